#include "solvers/linearity.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/tape.hpp"

namespace rfm {
namespace {

// To which nothing changes: further digits are those that u² − u·u loses.
constexpr double precision = 1e-9;
// Of values of slots, the most telling first.
constexpr double sizes[] = {1, 1e2, 1e-3, 10};
constexpr int states_of_a_size = 4;
constexpr int most_points = 256;

VolumePoints sample(const FormPlace& place, const DomainRule& rule) {
  VolumePoints all, points;
  if (place.place == Contribution::Place::volume) {
    // A few inside points of cells everywhere, and of those that are cut.
    const std::vector<int>& inside = rule.inside_cells();
    const std::size_t stride = std::max<std::size_t>(1, inside.size() / 64);
    for (std::size_t i = 0; i < inside.size(); i += stride) rule.add_inside_points(inside[i], all);
    all.append(rule.cut_points());
  } else {
    const SurfacePoints& surface = place.place == Contribution::Place::boundary
                                       ? rule.boundary().points
                                       : rule.interfaces().points;
    for (int i = 0; i < surface.size(); ++i)
      if (place.numbers.empty() ||
          std::ranges::find(place.numbers, surface.numbers[i]) != place.numbers.end())
        all.add(rule.dimension(), surface.point(i), surface.weights[i]);
  }
  const int stride = std::max(1, (all.size() + most_points - 1) / most_points);
  for (int i = 0; i < all.size(); i += stride)
    points.add(rule.dimension(), all.point(i), all.weights[i]);
  return points;
}

// Values of the slots: different at every point and in every slot.
std::vector<Field> random_state(const Form& form, const DomainRule& rule, double size,
                                std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Box& box = rule.grid().box();
  std::vector<Field> state;
  for (const SymbolSlot& slot : form.slots()) {
    Field value = uniform(generator);
    for (int axis = 0; axis < rule.dimension(); ++axis)
      value = value + uniform(generator) / box.length(axis) *
                          (coordinate(axis) - 0.5 * (box.low[axis] + box.high[axis]));
    state.push_back(slot.role == SymbolRole::test ? Field(0.0) : size * value);
  }
  return state;
}

// F, C and d of one state at the points, entries by the numbers of slots.
class StateValues {
 public:
  StateValues(const Form& form, const std::vector<Field>& state, const VolumePoints& points,
              int dimension)
      : slots_(form.slots()) {
    const Contribution part = form.at(state);
    std::vector<Field> roots = state;
    const auto add = [&](std::pair<int, int> entry, const Coefficient& coefficient) {
      entries_.push_back(entry);
      roots.push_back(coefficient.is_zero() ? Field(0.0) : coefficient.terms()[0].field);
    };
    const std::vector<Slot>& own = part.energy.slots();
    for (const QuadraticEnergy::Load& load : part.energy.load())
      add({test_number(own[load.slot]), -1}, -load.coefficient);
    for (const QuadraticEnergy::Entry& entry : part.energy.stiffness()) {
      const int row = trial_number(own[entry.row]), column = trial_number(own[entry.column]);
      add({row, column}, entry.coefficient);
      if (row != column) add({column, row}, entry.coefficient);
    }
    for (const Coupling& coupling : part.couplings)
      add({test_number(coupling.test), trial_number(coupling.trial)}, coupling.coefficient);
    if (part.where) roots.push_back(*part.where);
    has_where_ = part.where.has_value();
    evaluate(roots, points, dimension);
  }

  int point_count() const { return static_cast<int>(values_.size()); }
  bool counts(int point) const { return !has_where_ || values_[point].back() >= 0; }
  // [row, column] with C(row, ·) from 1 on and F(row) in column 0.
  std::vector<std::vector<double>> equations(int point) const {
    const std::size_t count = slots_.size();
    std::vector<std::vector<double>> result(count, std::vector<double>(count + 1, 0.0));
    for (std::size_t e = 0; e < entries_.size(); ++e)
      result[entries_[e].first][entries_[e].second + 1] += values_[point][count + e];
    return result;
  }
  double state(int slot, int point) const { return values_[point][slot]; }

 private:
  int number(const Slot& slot, SymbolRole role) const {
    for (std::size_t i = 0; i < slots_.size(); ++i)
      if (slots_[i].slot == slot && slots_[i].role == role) return static_cast<int>(i);
    return -1;
  }
  int trial_number(const Slot& slot) const { return number(slot, SymbolRole::unknown); }
  // Equations of weak forms are those of test functions, of others those of the unknowns.
  int test_number(const Slot& slot) const {
    const int test = number(slot, SymbolRole::test);
    return test >= 0 ? test : trial_number(slot);
  }

  void evaluate(const std::vector<Field>& roots, const VolumePoints& points, int dimension) {
    const Tape tape(roots, {0}, dimension);
    Tape::Workspace workspace(tape);
    for (int first = 0; first < points.size(); first += Tape::block_size) {
      PointBlock block;
      block.count = std::min(Tape::block_size, points.size() - first);
      for (int axis = 0; axis < dimension; ++axis)
        block.coordinates[axis] = points.coordinates[axis].data() + first;
      tape.evaluate(block, workspace);
      for (int q = 0; q < block.count; ++q) {
        std::vector<double>& values = values_.emplace_back();
        for (int root = 0; root < tape.root_count(); ++root)
          values.push_back(workspace.coefficient(root)[q]);
      }
    }
  }

  std::vector<SymbolSlot> slots_;
  std::vector<std::pair<int, int>> entries_;
  std::vector<std::vector<double>> values_;  // by point: state, entries, where
  bool has_where_ = false;
};

// Whether C is the same and F what C makes of the state.
bool agree(const StateValues& rest, const StateValues& state, int point) {
  const auto at_rest = rest.equations(point), at_state = state.equations(point);
  const int count = static_cast<int>(at_rest.size());
  double change = 0, size = 0;
  for (int row = 0; row < count; ++row)
    for (int column = 1; column <= count; ++column) {
      change = std::max(change, std::abs(at_state[row][column] - at_rest[row][column]));
      size = std::max({size, std::abs(at_state[row][column]), std::abs(at_rest[row][column])});
      if (!std::isfinite(at_state[row][column]) || !std::isfinite(at_rest[row][column]))
        return false;
    }
  if (change > precision * size) return false;
  change = size = 0;
  for (int row = 0; row < count; ++row) {
    double expected = at_rest[row][0];
    size = std::max({size, std::abs(at_rest[row][0]), std::abs(at_state[row][0])});
    for (int column = 0; column < count; ++column) {
      const double term = at_rest[row][column + 1] * state.state(column, point);
      expected += term;
      size = std::max(size, std::abs(term));
    }
    if (!std::isfinite(expected) || !std::isfinite(at_state[row][0])) return false;
    change = std::max(change, std::abs(at_state[row][0] - expected));
  }
  return change <= precision * size;
}

}  // namespace

bool is_linear_by_value(const Form& form, const DomainRule& rule) {
  const VolumePoints points = sample(form.place(), rule);
  const StateValues rest(form, std::vector<Field>(form.slots().size(), 0.0), points,
                         rule.dimension());
  std::mt19937 generator(1);
  for (int repetition = 0; repetition < states_of_a_size; ++repetition)
    for (const double size : sizes) {
      const StateValues state(form, random_state(form, rule, size, generator), points,
                              rule.dimension());
      for (int point = 0; point < state.point_count(); ++point)
        if (state.counts(point) && !agree(rest, state, point)) return false;
    }
  return true;
}

Linearity linearity(std::span<const Form> forms, const DomainRule& rule) {
  if (std::ranges::all_of(forms, &Form::is_linear)) return Linearity::by_form;
  return std::ranges::all_of(
             forms,
             [&](const Form& form) { return form.is_linear() || is_linear_by_value(form, rule); })
             ? Linearity::by_value
             : Linearity::none;
}

double departure_from_linear(const LinearSystem& system, const Eigen::VectorXd& coefficients,
                             const Eigen::VectorXd& residual) {
  // The largest entry of each row: of a lower triangle, also of its column.
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(system.size());
  for (Eigen::Index column = 0; column < system.matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(system.matrix, column); entry; ++entry) {
      largest[entry.row()] = std::max(largest[entry.row()], std::abs(entry.value()));
      if (system.symmetric) largest[column] = std::max(largest[column], std::abs(entry.value()));
    }
  const Eigen::VectorXd scale =
      largest.unaryExpr([](double entry) { return entry > 1e-300 ? 1 / std::sqrt(entry) : 0.0; });
  const Eigen::VectorXd product =
      system.symmetric
          ? Eigen::VectorXd(system.matrix.selfadjointView<Eigen::Lower>() * coefficients)
          : Eigen::VectorXd(system.matrix * coefficients);
  const double size =
      scale.cwiseProduct(system.right_hand_side).norm() + scale.cwiseProduct(product).norm();
  const double departure = scale.cwiseProduct(residual - (system.right_hand_side - product)).norm();
  return departure == 0 ? 0 : departure / size;
}

bool is_linear_at(const LinearSystem& system, const Eigen::VectorXd& coefficients,
                  const Eigen::VectorXd& residual) {
  return departure_from_linear(system, coefficients, residual) <= precision;
}

}  // namespace rfm
