#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/region.hpp"
#include "core/tape.hpp"
#include "quadrature/interfaces.hpp"
#include "quadrature/truth_table.hpp"

namespace rfm {

/// The primitives and interfaces that may matter in a box: their sign there is not known, and the
/// region (or the inside) depends on it. Smaller boxes inherit and narrow the lists.
struct SurfaceCandidates {
  /// What is known of the sign of every primitive.
  std::vector<Truth> signs;
  std::vector<int> primitives;
  std::vector<int> interfaces;
  /// What the region's expression comes to with the signs known in a larger box, for the primitives
  /// left there; null for the whole expression. Smaller boxes inherit it, so that of many
  /// primitives a box costs what is near to it.
  std::shared_ptr<const BooleanExpression> open;
  /// A primitive given by an expression with many branches (min, max, if, |·|).
  struct Shortened {
    int primitive;
    /// Its tape without the branches that are not taken in the box; null if that leaves out little.
    std::shared_ptr<const Tape> tape;
    int wait = 0;  ///< boxes within boxes until the next attempt
  };
  /// All of these. Smaller boxes inherit the tapes, so that a long union within one expression
  /// costs a cell what is near to it.
  std::vector<Shortened> shortened;

  SurfaceCandidates() = default;
  /// Nothing known yet.
  SurfaceCandidates(const RegionEvaluator& region, const Interfaces& all_interfaces);

  /// Whether `box` is inside (an unknown answer leaves primitives; interfaces may be left unless it
  /// is no). `tight` asks for the better and dearer bounds.
  Truth narrow(const Box& box, bool tight, const RegionEvaluator& region,
               const Interfaces& all_interfaces);
  /// The region as a function of the primitives left, those on which it does not depend dropped.
  /// There may be at most `TruthTable::max_variables`.
  TruthTable make_table(const BooleanExpression& expression);

 private:
  void shorten(const Box& box, const RegionEvaluator& region);
  /// Drops primitives whose signs follow from those of others wherever they matter; returns whether
  /// `box` is inside.
  Truth drop_implied(const Box& box, const RegionEvaluator& region);
  /// The signs known, anything for what does not matter, and unknown for `primitives`.
  std::vector<Truth> known_signs() const;
};

}  // namespace rfm
