#pragma once

#include <span>
#include <vector>

#include "quadrature/smooth_intervals.hpp"

namespace rfm {

/// The crossings on the lines of a rule of order `points`, kept while a part of a cell is
/// integrated: along a smooth interval they are at places that vary smoothly, so that the lines of
/// another rule find theirs from good guesses. Lines come interval by interval, intervals section
/// by section (of a plane there is one), sections of space block by block, between breakpoints of
/// the outer axis. Memory is used again.
class LineRecord {
 public:
  /// The lines over one interval of the base axis.
  struct Strip {
    SmoothInterval interval;
    int lines = 0;
    /// All lines meet the same surfaces in the same order, with the same states between.
    bool uniform = true;
    bool starts_inside = false;
    int crossing_count = 0;
    int first_crossing = 0;
    /// positions[line · crossing_count + crossing]
    int first_position = 0;
  };
  /// The sections between two breakpoints of the outer axis.
  struct Block {
    SmoothInterval interval;
    int first_section = 0;
    int sections = 0;
  };

  void clear();
  void begin_block(const SmoothInterval& interval);
  void begin_section();
  void begin_strip(const SmoothInterval& interval);
  /// A line over the interval of the strip begun last: its crossings, ascending, then its end.
  void add_crossing(const LineCrossing& crossing) { line_[line_size_++] = crossing; }
  void end_line(bool starts_inside);

  std::span<const Block> blocks() const { return blocks_; }
  std::span<const Strip> strips(int section) const;
  /// The crossings of a strip that is uniform; their positions have no meaning.
  std::span<const LineCrossing> crossings(const Strip& strip) const;
  /// Their positions, line by line.
  std::span<const double> positions(const Strip& strip) const;
  /// Whether all sections of a block have uniform strips that differ in places alone.
  bool is_uniform(const Block& block) const;

 private:
  bool same(const Strip& a, const Strip& b) const;

  /// The line that is being added.
  std::array<LineCrossing, ActiveSet::capacity> line_;
  std::size_t line_size_ = 0;
  std::vector<Block> blocks_;
  std::vector<int> first_strips_;
  std::vector<Strip> strips_;
  std::vector<LineCrossing> crossings_;
  std::vector<double> positions_;
};

}  // namespace rfm
