#include "tests/core/conformance_evaluators.hpp"

#include "core/further_coordinate.hpp"
#include "core/point_program.hpp"
#include "core/slots.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

using Jets = std::vector<std::vector<double>>;

// Variables of jets are x, y, z and a further coordinate. The values of arguments that are not
// coordinates themselves are held: further coordinates as well.
constexpr int first_held = 4, fourth_variable = 7, further_count = 4;

Field variable(int axis) {
  return axis < 3 ? coordinate(axis) : further_coordinate(fourth_variable);
}

bool is_own(const ArgumentShape& shape) { return shape.kind == ArgumentShape::Kind::own; }

Variables variables_of(const ArgumentShape& shape) {
  std::vector<int> numbers{0, 1, 2, fourth_variable};
  numbers.resize(shape.variables);
  return Variables(numbers);
}

Field operation_of(const Row& row, std::vector<Field> arguments) {
  const OperationRow& entry = *find_operation(row.operation);
  arguments.resize(entry.arity);
  return apply(row.operation, arguments,
               entry.numbers ? std::optional<double>(row.number) : std::nullopt);
}

// The operation of coordinates, or of held values plus or times polynomials of which the variables
// are 0.
Field field_of(const Row& row, const ArgumentShape& shape) {
  std::vector<Field> arguments;
  for (int i = 0; i < 3; ++i) {
    if (is_own(shape) && i < shape.variables) {
      arguments.push_back(variable(i));
      continue;
    }
    const Field held = further_coordinate(first_held + i);
    const bool is_factor = shape.kind == ArgumentShape::Kind::proportional;
    Field argument = is_factor ? Field(1.0) : held;
    for (int k = 1; k < jet_size(shape.variables, std::min(shape.order, 2)); ++k) {
      const MultiIndex alpha = JetShape::get(shape.variables, 2).exponent(k);
      Field term = shape.coefficients[i][k];
      for (int axis = 0; axis < shape.variables; ++axis)
        term = term * pow(variable(axis), alpha[axis]);
      argument = argument + term;
    }
    arguments.push_back(is_factor ? held * argument : argument);
  }
  return operation_of(row, arguments);
}

// The coordinates of a point: its arguments where they are coordinates, and all as held values.
struct Place {
  Point point{};
  std::array<double, further_count> further{};
};

Place place_of(const ArgumentShape& shape, const Arguments& arguments) {
  Place place;
  for (int i = 0; i < 3; ++i) {
    if (is_own(shape) && i < shape.variables) place.point[i] = arguments[i];
    place.further[i] = arguments[i];
  }
  return place;
}

Jets at_single_points(const Row& row, const ArgumentShape& shape,
                      const std::vector<Arguments>& points) {
  const Tape tape({field_of(row, shape)}, {shape.order}, variables_of(shape));
  Jets jets;
  for (const Arguments& arguments : points) {
    const Place place = place_of(shape, arguments);
    jets.push_back(tape.jet(place.point, 0, {0, {}, place.further}));
  }
  return jets;
}

Jets in_blocks(const Row& row, const ArgumentShape& shape, const std::vector<Arguments>& points) {
  const Tape tape({field_of(row, shape)}, {shape.order}, variables_of(shape));
  Tape::Workspace workspace(tape);
  Jets jets(points.size(), std::vector<double>(jet_size(shape.variables, shape.order)));
  for (std::size_t first = 0; first < points.size(); first += Tape::block_size) {
    const int count =
        static_cast<int>(std::min<std::size_t>(Tape::block_size, points.size() - first));
    std::array<std::vector<double>, 3 + further_count> rows;
    for (int i = 0; i < count; ++i) {
      const Place place = place_of(shape, points[first + i]);
      for (int axis = 0; axis < 3; ++axis) rows[axis].push_back(place.point[axis]);
      for (int k = 0; k < further_count; ++k) rows[3 + k].push_back(place.further[k]);
    }
    std::array<const double*, further_count> further;
    for (int k = 0; k < further_count; ++k) further[k] = rows[3 + k].data();
    tape.evaluate({.coordinates = {rows[0].data(), rows[1].data(), rows[2].data()},
                   .count = count,
                   .further = further},
                  workspace);
    for (int i = 0; i < count; ++i)
      for (std::size_t k = 0; k < jets[first].size(); ++k)
        jets[first + i][k] = workspace.coefficient(0, static_cast<int>(k))[i];
  }
  return jets;
}

// A tape for each point, specialised to it: whatever can be decided is.
Jets specialised_to_points(const Row& row, const ArgumentShape& shape,
                           const std::vector<Arguments>& points) {
  const Tape general({field_of(row, shape)}, {shape.order}, variables_of(shape));
  Jets jets;
  for (const Arguments& arguments : points) {
    const Place place = place_of(shape, arguments);
    const Tape tape = general.specialised({shape.variables, place.point, place.point});
    jets.push_back(tape.jet(place.point, 0, {0, {}, place.further}));
  }
  return jets;
}

std::optional<PointProgram> program_of(const Row& row, const ArgumentShape& shape) {
  return PointProgram::compiled(field_of(row, shape), shape.variables);
}

Jets by_point_programs(const Row& row, const ArgumentShape& shape,
                       const std::vector<Arguments>& points) {
  const PointProgram program = *program_of(row, shape);
  Jets jets;
  for (const Arguments& arguments : points) {
    Point gradient;
    std::vector<double> jet{program.value_and_gradient(arguments, gradient)};
    for (int axis = 0; axis < shape.variables; ++axis) jet.push_back(gradient[axis]);
    jets.push_back(jet);
  }
  return jets;
}

Jets by_slopes_of_point_programs(const Row& row, const ArgumentShape& shape,
                                 const std::vector<Arguments>& points) {
  const PointProgram program = *program_of(row, shape);
  Jets jets;
  for (const Arguments& arguments : points) {
    std::vector<double> jet{program.value(arguments)};
    for (int axis = 0; axis < shape.variables; ++axis) {
      double slope = 0;
      program.value_and_slope(arguments, axis, slope);
      jet.push_back(slope);
    }
    jets.push_back(jet);
  }
  return jets;
}

Jets by_slots(const Row& row, const ArgumentShape& shape, const std::vector<Arguments>& points) {
  std::vector<Field> arguments;
  for (int i = 0; i < 3; ++i) arguments.push_back(further_coordinate(first_held + i));
  const Field function = operation_of(row, arguments);
  const auto [gradient, hessian] = slot_derivatives(
      function, std::vector<Field>(arguments.begin(), arguments.begin() + shape.variables));
  std::vector<Field> roots{function};
  for (const SlotSlope& entry : gradient) roots.push_back(entry.value);
  for (const SlotCurvature& entry : hessian) roots.push_back(entry.value);
  const Tape tape(roots, {0}, Variables(std::vector<int>{0}));
  Jets jets;
  for (const Arguments& point : points) {
    const std::array<double, further_count> further = place_of(shape, point).further;
    int root = 0;
    const auto next = [&] { return tape.value({}, root++, {0, {}, further}); };
    std::vector<double> jet(jet_size(shape.variables, 2), 0.0);
    jet[0] = next();
    for (const SlotSlope& entry : gradient) jet[1 + entry.slot] = next();
    for (const SlotCurvature& entry : hessian)
      jet[jet_index(shape.variables, unit_index(entry.row) + unit_index(entry.column))] =
          (entry.row == entry.column ? 0.5 : 1) * next();
    jets.push_back(jet);
  }
  return jets;
}

bool always(const Row&, const ArgumentShape&) { return true; }

bool is_natural(const Row& row, const ArgumentShape& shape) {
  return is_own(shape) && shape.variables == find_operation(row.operation)->arity;
}

}  // namespace

const std::vector<Evaluator>& all_evaluators() {
  const auto has_program = [](const Row& row, const ArgumentShape& shape) {
    return is_natural(row, shape) && shape.order == 1 && program_of(row, shape);
  };
  static const std::vector<Evaluator> evaluators{
      {"single points", always, at_single_points},
      {"blocks", always, in_blocks},
      {"specialised tapes",
       [](const Row&, const ArgumentShape& shape) { return is_own(shape) && shape.variables <= 3; },
       specialised_to_points},
      {"point programs", has_program, by_point_programs},
      {"slopes of point programs", has_program, by_slopes_of_point_programs},
      {"slots",
       [](const Row& row, const ArgumentShape& shape) {
         return is_natural(row, shape) && shape.order == 2;
       },
       by_slots, true}};
  return evaluators;
}

}  // namespace rfm
