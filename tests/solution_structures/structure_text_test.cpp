#include "solution_structures/structure_text.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"
#include "solution_structures/verification.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();
const Structure psi1 = Structure::undetermined(0), psi2 = Structure::undetermined(1);

// Two normalised functions, one of which is linear, and names for them.
const Field hole = -circle({0.2, 0.1}, 0.4).primitives()[0]->function;
const Field side = half_plane({-1, 0}, {1, 0.5}).primitives()[0]->function;
const StructureNames names{{"omega(hole)", hole}, {"omega(side)", side}};

ExpressionScope scope(int unknowns) {
  ExpressionScope scope = coordinate_scope(2);
  define_structures(scope, 2, unknowns);
  scope.define_function("omega", {.call =
                                      [](std::span<const ExpressionArgument> arguments) {
                                        return arguments[0].text == "hole" ? hole : side;
                                      },
                                  .takes_names = true});
  return scope;
}

void expect_read_back(const Structure& structure) {
  const std::string text = to_text(structure, names);
  const Structure again = to_structure(Expression(text), scope(structure.unknown_count()));
  const Field expected = random_solution({structure}, 2, 4)[0];
  const Field read = random_solution({again}, 2, 4)[0];
  for (const Point& at : {Point{0.3, -0.7}, Point{-0.2, 0.9}, Point{1.1, 0.6}}) {
    const double value = value_at(expected, at);
    EXPECT_NEAR(value_at(read, at), value, 1e-13 * (1 + std::fabs(value))) << text;
  }
}

TEST(StructureText, IsTheFormulaOfTheLiterature) {
  const Structure neumann = psi1 - hole * D(hole, psi1, 2) + pow(hole, 2) * psi2;
  EXPECT_EQ(to_text(neumann, names),
            "psi1 - omega(hole)*D(omega(hole), psi1) + omega(hole)^2*psi2");
  EXPECT_EQ(to_text(x + hole * psi1, names), "x + omega(hole)*psi1");
  const Structure clamped = normalized(1 + x * x, hole, 2) + pow(hole, 2) * psi1;
  EXPECT_EQ(to_text(clamped, names), "normalizer(1 + x*x, omega(hole)) + omega(hole)^2*psi1");
}

TEST(StructureText, ReadBackIsTheSameFunction) {
  expect_read_back(psi1);
  expect_read_back(sin(3 * x) * y + hole * psi1);
  expect_read_back(psi1 - hole * D(hole, psi1, 2) + pow(hole, 2) * psi2);
  // D inside D, and along a linear function, where most terms vanish.
  expect_read_back(psi1 - side * D(side, psi1 + hole * D(hole, psi2, 2), 2));
  expect_read_back(normalized(exp(x) * y, hole, 2) - hole * (x + y) + pow(hole, 2) * psi1);
  expect_read_back(partial(hole * psi1, 0) / (1 + x * x) - laplacian(hole, 2) * psi2);
}

TEST(StructureText, FunctionsWhoseTermsCancelAreWritten) {
  const Structure psi4 = Structure::undetermined(3);
  EXPECT_EQ(to_text(psi1 + (psi4 - psi4), names), "psi1 + (psi4 - psi4)");
}

TEST(StructureText, OneUndeterminedFunctionNeedsNoNumber) {
  const Structure structure = to_structure(Expression("x + omega(hole)*psi"), scope(1));
  ASSERT_EQ(structure.terms().size(), 1u);
  EXPECT_TRUE(structure.terms()[0].coefficient.same_as(hole));
  EXPECT_THROW(to_structure(Expression("psi"), scope(2)), InputError);
}

TEST(StructureText, UsersMayCallTransfiniteInterpolation) {
  const Expression text("transfinite(sin(y), omega(hole), 1, psi, omega(side), 2)");
  const Field u = random_solution({to_structure(text, scope(1))}, 2, 1)[0];
  const Point on_hole{0.6, 0.1};
  EXPECT_NEAR(value_at(u, on_hole), std::sin(0.1), 1e-14);
}

TEST(StructureText, MistakesHaveTheirPlace) {
  const auto offset = [](const char* text) {
    try {
      to_structure(Expression(text), scope(2));
    } catch (const InputError& mistake) {
      return static_cast<int>(mistake.offset);
    }
    return -1;
  };
  EXPECT_EQ(offset("psi1 + psi3"), 7);
  EXPECT_EQ(offset("D(psi1, psi2)"), 2) << "the direction is known";
  EXPECT_EQ(offset("psi1 + D(x, grad(psi1))"), 12) << "a vector";
  EXPECT_EQ(offset("psi1 * psi2"), 0) << "not affine";
  EXPECT_EQ(offset("transfinite(x, y, 1, y)"), 21);
  EXPECT_EQ(offset("transfinite(x, y, 1.5)"), 18);
}

}  // namespace
}  // namespace rfm
