#include "quadrature/line_record.hpp"

#include <algorithm>

namespace rfm {
namespace {

// The same but for their places.
bool same_crossings(std::span<const LineCrossing> a, std::span<const LineCrossing> b) {
  return std::ranges::equal(a, b, [](const LineCrossing& p, const LineCrossing& q) {
    return p.surface == q.surface && p.interface == q.interface && p.begins == q.begins &&
           p.inside_is_positive == q.inside_is_positive;
  });
}

}  // namespace

void LineRecord::clear() {
  blocks_.clear();
  first_strips_.clear();
  strips_.clear();
  crossings_.clear();
  positions_.clear();
}

void LineRecord::begin_block(const SmoothInterval& interval) {
  blocks_.push_back({interval, static_cast<int>(first_strips_.size())});
}

void LineRecord::begin_section() {
  first_strips_.push_back(static_cast<int>(strips_.size()));
  if (!blocks_.empty()) ++blocks_.back().sections;
}

void LineRecord::begin_strip(const SmoothInterval& interval) {
  Strip strip;
  strip.interval = interval;
  strip.first_crossing = static_cast<int>(crossings_.size());
  strip.first_position = static_cast<int>(positions_.size());
  strips_.push_back(strip);
}

void LineRecord::end_line(bool starts_inside) {
  const std::span<const LineCrossing> crossings = std::span(line_).first(line_size_);
  line_size_ = 0;
  Strip& strip = strips_.back();
  if (strip.lines++ == 0) {
    strip.starts_inside = starts_inside;
    strip.crossing_count = static_cast<int>(crossings.size());
    crossings_.insert(crossings_.end(), crossings.begin(), crossings.end());
  }
  strip.uniform = strip.uniform && strip.starts_inside == starts_inside &&
                  same_crossings(this->crossings(strip), crossings);
  if (!strip.uniform) return;
  for (const LineCrossing& crossing : crossings) positions_.push_back(crossing.position);
}

std::span<const LineRecord::Strip> LineRecord::strips(int section) const {
  const int next = section + 1;
  const int end = next < static_cast<int>(first_strips_.size()) ? first_strips_[next]
                                                                : static_cast<int>(strips_.size());
  return std::span(strips_).subspan(first_strips_[section], end - first_strips_[section]);
}

std::span<const LineCrossing> LineRecord::crossings(const Strip& strip) const {
  return std::span(crossings_).subspan(strip.first_crossing, strip.crossing_count);
}

std::span<const double> LineRecord::positions(const Strip& strip) const {
  return std::span(positions_).subspan(strip.first_position, strip.lines * strip.crossing_count);
}

bool LineRecord::same(const Strip& a, const Strip& b) const {
  return b.uniform && a.interval.low.cause == b.interval.low.cause &&
         a.interval.high.cause == b.interval.high.cause && a.starts_inside == b.starts_inside &&
         same_crossings(crossings(a), crossings(b));
}

bool LineRecord::is_uniform(const Block& block) const {
  const std::span<const Strip> first = strips(block.first_section);
  for (int i = 0; i < block.sections; ++i)
    if (!std::ranges::equal(first, strips(block.first_section + i),
                            [&](const Strip& a, const Strip& b) { return same(a, b); }))
      return false;
  return true;
}

}  // namespace rfm
