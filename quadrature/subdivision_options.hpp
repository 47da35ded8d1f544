#pragma once

#include <array>
#include <cstdint>

namespace rfm {

struct SubdivisionOptions {
  /// Graphs may be as steep as 1 / flatness, by dimension. Steeper ones are admissible too but
  /// their roots vary too fast for the Gauss rule: with 0 a coarse ellipse stalls at errors of
  /// 1e-5. On coarse cells of a plane body with small holes the worst error over many positions of
  /// the grid falls by 1000 from 0.2 to 0.4 for 15 % more points; in space a coarse torus gains a
  /// factor of 15 from 0.2 to 0.3, and nothing beyond.
  std::array<double, 3> flatness = {0, 0.4, 0.3};
  /// After 3 (d − 1) bisections the flatness shrinks by this factor with each more, or boxes near
  /// tangential corners would never be accepted.
  double flatness_decay = 0.8;
  /// Bisections along one branch, by dimension: 2⁻¹² of a cell per axis in 2D.
  std::array<int, 3> max_depth = {48, 24, 18};
  /// What may be done for one cell, in steps of `work_done`: some 25 ms. It includes what boxes
  /// that wait cost when they are reduced as they are and reported, and no search goes on when it
  /// is spent. Large boxes come first, so that what is left unresolved is small everywhere.
  std::int64_t max_work = 2'000'000;
  /// From this depth on a rotated frame is tried in 2D: it resolves corners where one curve is
  /// horizontal and another vertical.
  int rotation_depth = 8;
  /// From this depth on in 3D, surfaces that only touch as far as samples tell are accepted:
  /// bisection would follow the place where they touch to the bottom. A plane tangent to a torus
  /// along a circle costs 1 ms a cell with 4, 3 ms with 8, and 70 ms without.
  int contact_depth = 6;
};

/// Where a cell could not be resolved within its budget: rules and pictures there are a best
/// effort, with an error of the volume of at most the measure of these boxes.
struct Uncertified {
  int boxes = 0;
  double measure = 0;
  /// Length or area of the boundary in these boxes: as rules have it, whose pieces are a best
  /// effort, too, or, where structure is not proven and pieces may be missing, what the sides of a
  /// box measure for each surface in it, if that is more. Known where a rule of the boundary is
  /// made.
  double boundary = 0;
  /// Boxes in which surfaces of space seem to touch without crossing: bounds cannot prove a
  /// tangency, but the extrema of their distance have one sign up to rounding. The rules there have
  /// full order if that is so everywhere; these boxes are not counted above.
  int contact_boxes = 0;
  double contact_measure = 0;

  Uncertified& operator+=(const Uncertified& other) {
    boxes += other.boxes;
    measure += other.measure;
    boundary += other.boundary;
    contact_boxes += other.contact_boxes;
    contact_measure += other.contact_measure;
    return *this;
  }
};

}  // namespace rfm
