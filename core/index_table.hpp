#pragma once

#include <cstdint>
#include <vector>

namespace rfm {

/// A hash table of the indices 0, 1, 2, … of things that are kept elsewhere: open addressing, twice
/// as many places as indices at least. It is what compiling a tape spends its time in.
class IndexTable {
 public:
  /// The index i with this hash for which `same(i)`, or −1.
  template <class Same>
  int find(std::uint64_t hash, const Same& same) const {
    if (places_.empty()) return -1;
    const std::uint32_t mixed = mix(hash), mask = static_cast<std::uint32_t>(places_.size()) - 1;
    for (std::uint32_t at = mixed & mask; places_[at].index >= 0; at = (at + 1) & mask)
      if (places_[at].hash == mixed && same(places_[at].index)) return places_[at].index;
    return -1;
  }
  /// The index i with this hash for which `same(i)`; if there is none, `next`, which is inserted.
  template <class Same>
  int find_or_insert(std::uint64_t hash, int next, const Same& same) {
    if (2 * (count_ + 1) > static_cast<int>(places_.size())) grow();
    const std::uint32_t mixed = mix(hash), mask = static_cast<std::uint32_t>(places_.size()) - 1;
    for (std::uint32_t at = mixed & mask;; at = (at + 1) & mask) {
      Place& place = places_[at];
      if (place.index < 0) {
        place = {mixed, next};
        ++count_;
        return next;
      }
      if (place.hash == mixed && same(place.index)) return place.index;
    }
  }

 private:
  struct Place {
    std::uint32_t hash = 0;
    int index = -1;
  };

  // Fibonacci hashing: the high bits of the product depend on all bits of the hash.
  static std::uint32_t mix(std::uint64_t hash) {
    return static_cast<std::uint32_t>((hash * 0x9e3779b97f4a7c15ull) >> 32);
  }

  void grow() {
    std::vector<Place> old(places_.empty() ? 64 : 2 * places_.size());
    old.swap(places_);
    const std::uint32_t mask = static_cast<std::uint32_t>(places_.size()) - 1;
    for (const Place& place : old) {
      if (place.index < 0) continue;
      std::uint32_t at = place.hash & mask;
      while (places_[at].index >= 0) at = (at + 1) & mask;
      places_[at] = place;
    }
  }

  std::vector<Place> places_;
  int count_ = 0;
};

}  // namespace rfm
