#include "solvers/integrate.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/tape.hpp"
#include "quadrature/compensated_sum.hpp"
#include "quadrature/integrate.hpp"

namespace rfm {
namespace {

static_assert(QuadratureBlock::max_size <= Tape::block_size);

// The points of a place in blocks, and the tape at their points.
class PlaceBlocks {
 public:
  PlaceBlocks(const DomainRule& rule, const IntegrationPlace& place,
              const FieldArguments& arguments)
      : volume_(rule),
        surface_(place.place == Contribution::Place::interface ? rule.interfaces()
                                                               : rule.boundary()),
        arguments_(arguments),
        dimension_(rule.dimension()),
        is_volume_(place.place == Contribution::Place::volume) {
    if (is_volume_) return;
    for (const int number : place.numbers) {
      if (number >= static_cast<int>(is_chosen_.size())) is_chosen_.resize(number + 1, false);
      is_chosen_[number] = true;
    }
  }

  int count() const { return is_volume_ ? volume_.count() : surface_.count(); }

  // Calls visit(block number, block, workspace) for all blocks with points that count, in parallel.
  template <class Visit>
  void evaluate(const Tape& tape, Visit&& visit) const {
    struct Scratch {
      Tape::Workspace workspace;
      VolumeBlocks::Buffer buffer;
    };
    tbb::enumerable_thread_specific<Scratch> scratches([&] {
      return Scratch{Tape::Workspace(tape), {}};
    });
    tbb::parallel_for(0, count(), [&](int number) {
      Scratch& scratch = scratches.local();
      const QuadratureBlock block =
          is_volume_ ? volume_.block(number, scratch.buffer) : surface_.block(number);
      if (!has_points(block)) return;
      const PointBlock points{block.coordinates, block.count, arguments_.time,
                              arguments_.parameters};
      if (tape.root_count() > 0) tape.evaluate(points, scratch.workspace);
      visit(number, block, scratch.workspace);
    });
  }

  bool counts(const QuadratureBlock& block, int point) const {
    return is_chosen_.empty() || (block.numbers[point] < static_cast<int>(is_chosen_.size()) &&
                                  is_chosen_[block.numbers[point]]);
  }

  // `fields` are those that the value was made of.
  void require_finite(double value, const QuadratureBlock& block, int point,
                      std::span<const Field> fields) const {
    if (std::isfinite(value)) return;
    Point place{};
    for (int axis = 0; axis < dimension_; ++axis) place[axis] = block.coordinates[axis][point];
    std::string cause;
    for (const Field& field : fields)
      if (cause.empty())
        cause = diagnosis_suffix(field, place, dimension_, arguments_.time, arguments_.parameters);
    throw ComputationError(fmt::format("an integrand is {} at the point {}{}",
                                       std::isnan(value) ? "not a number" : "infinite",
                                       point_text(place, dimension_), cause));
  }

 private:
  bool has_points(const QuadratureBlock& block) const {
    for (int point = 0; point < block.count; ++point)
      if (counts(block, point)) return true;
    return false;
  }

  VolumeBlocks volume_;
  SurfaceBlocks surface_;
  const FieldArguments& arguments_;
  int dimension_;
  bool is_volume_;
  std::vector<bool> is_chosen_;  // by number; empty where all count
};

// Σ_α n^α f_α at a point of a block; the fields are roots of a tape from `root` on.
double value_of(const Coefficient& integrand, int root, const QuadratureBlock& block,
                const Tape::Workspace& workspace, int point) {
  double sum = 0;
  for (const auto& [normal, field] : integrand.terms()) {
    double term = workspace.coefficient(root++)[point];
    for (int axis = 0; axis < 3; ++axis)
      for (int n = 0; n < normal[axis]; ++n) term *= block.normals[axis][point];
    sum += term;
  }
  return sum;
}

}  // namespace

std::vector<double> integrate(std::span<const Coefficient> integrands, const DomainRule& rule,
                              const IntegrationPlace& place, const FieldArguments& arguments) {
  std::vector<Field> roots;
  std::vector<int> first_root;
  for (const Coefficient& integrand : integrands) {
    if (place.place == Contribution::Place::volume && integrand.depends_on_normal())
      throw InvalidArgument("an integrand over the volume cannot depend on the normal");
    first_root.push_back(static_cast<int>(roots.size()));
    for (const Coefficient::Term& term : integrand.terms()) roots.push_back(term.field);
  }
  const PlaceBlocks blocks(rule, place, arguments);
  const std::size_t count = integrands.size();
  std::vector<double> sums(blocks.count() * count);
  blocks.evaluate(Tape(roots, {0}, rule.dimension()), [&](int number, const QuadratureBlock& block,
                                                          const Tape::Workspace& workspace) {
    for (std::size_t i = 0; i < count; ++i) {
      CompensatedSum sum;
      for (int point = 0; point < block.count; ++point) {
        if (!blocks.counts(block, point)) continue;
        const double value = value_of(integrands[i], first_root[i], block, workspace, point);
        blocks.require_finite(
            value, block, point,
            std::span(roots).subspan(first_root[i], integrands[i].terms().size()));
        sum.add(block.weights[point] * value);
      }
      sums[number * count + i] = sum.value();
    }
  });
  std::vector<double> integrals;
  for (std::size_t i = 0; i < count; ++i) {
    CompensatedSum total;
    for (std::size_t k = i; k < sums.size(); k += count) total.add(sums[k]);
    integrals.push_back(total.value());
  }
  return integrals;
}

double integrate(const Coefficient& integrand, const DomainRule& rule,
                 const IntegrationPlace& place, const FieldArguments& arguments) {
  return integrate(std::span(&integrand, 1), rule, place, arguments)[0];
}

double maximum(const Field& field, const DomainRule& rule, const IntegrationPlace& place,
               const FieldArguments& arguments) {
  const PlaceBlocks blocks(rule, place, arguments);
  std::vector<double> largest(blocks.count(), 0.0);
  blocks.evaluate(Tape({field}, {0}, rule.dimension()),
                  [&](int number, const QuadratureBlock& block, const Tape::Workspace& workspace) {
                    for (int point = 0; point < block.count; ++point) {
                      if (!blocks.counts(block, point)) continue;
                      const double value = workspace.coefficient(0)[point];
                      blocks.require_finite(value, block, point, std::span(&field, 1));
                      largest[number] = std::max(largest[number], std::abs(value));
                    }
                  });
  return largest.empty() ? 0 : *std::max_element(largest.begin(), largest.end());
}

double FieldNorms::h1() const { return std::hypot(l2, h1_seminorm); }

FieldNorms norms(const Field& field, const DomainRule& rule, const FieldArguments& arguments) {
  Field slope = 0.0;
  for (const Field& derivative : gradient(field, rule.dimension()))
    slope = slope + derivative * derivative;
  const std::vector<double> squares =
      integrate(std::vector<Coefficient>{field * field, slope}, rule, {}, arguments);
  return {std::sqrt(squares[0]), std::sqrt(squares[1]), maximum(field, rule, {}, arguments)};
}

}  // namespace rfm
