#include "solvers/weak_values.hpp"

#include <gmock/gmock.h>

#include <random>

#include "core/error.hpp"
#include "solvers/assembly.hpp"
#include "solvers/equations.hpp"
#include "solvers/solution.hpp"
#include "tests/solvers/form_algebra.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;

const Field x = x_coordinate(), y = y_coordinate();
const Field u = unknown_symbol(0, 2), v = test_symbol(0, 2);

// Values on the hypotenuse of the triangle, and random states.
class WeakValues : public testing::TestWithParam<bool> {
 protected:
  Form volume() const {
    return GetParam()
               ? Form::energy(sqrt(1.0 + squared_slope(u)) + exp(x) * u)
               : Form::weak((1.0 + u * u + squared_slope(u)) * dot(gradient(u, 2), gradient(v, 2)) +
                            x * v);
  }
  Form form() const {
    const double half = std::sqrt(0.5);
    return weak_values(volume(), 0, sin(x) + y, {half, half}, 30,
                       {Contribution::Place::boundary, {2}, {}});
  }
  Eigen::VectorXd random(int seed) const {
    std::mt19937 generator(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> uniform(-1, 1);
    Eigen::VectorXd numbers(spaces_[0].size());
    for (double& number : numbers) number = uniform(generator);
    return numbers;
  }
  LinearSystem system(const Eigen::VectorXd& c, const Eigen::VectorXd& held) const {
    const Contribution part = form().linearized(solution_fields(structures_, spaces_, c),
                                                solution_fields(structures_, spaces_, held));
    return assemble(structures_, spaces_, std::span(&part, 1), rule_);
  }

  Grid grid_ = triangle_grid(5);
  DomainRule rule_ = rule_for(triangle(), grid_, 2);
  std::vector<TensorProductSpace> spaces_{TensorProductSpace(grid_, 2, cells_in_region(rule_))};
  std::vector<Structure> structures_{Structure::undetermined()};
};

INSTANTIATE_TEST_SUITE_P(EnergyAndWeak, WeakValues, testing::Bool());

// The tangent counts all but what is held, so that along steps beside it residuals must fall.
TEST_P(WeakValues, HaveTheTangentOfTheirResidualBesideWhatIsHeld) {
  const Eigen::VectorXd c = random(1), direction = random(2);
  const auto residual = [&](double t) {
    return Eigen::VectorXd(-system(c + t * direction, c).right_hand_side);
  };
  const double h = 1e-4;
  const Eigen::VectorXd slope = (residual(h) - residual(-h)) / (2 * h);
  const LinearSystem at = system(c, c);
  EXPECT_EQ(at.symmetric, GetParam());
  const Eigen::VectorXd product =
      at.symmetric ? Eigen::VectorXd(at.matrix.selfadjointView<Eigen::Lower>() * direction)
                   : Eigen::VectorXd(at.matrix * direction);
  EXPECT_LT((product - slope).norm(), 1e-6 * slope.norm());
  const Eigen::VectorXd beside = random(3);
  EXPECT_GT((system(c, beside).right_hand_side - at.right_hand_side).norm(),
            0.1 * at.right_hand_side.norm());
}

// What is held has the values of the solution: the slope of the energy
// -q(u) (u - g) + penalty k (u - g)^2 / 2 but for the changes of k and of the slopes of q, which
// are multiplied by u - g.
TEST(WeakValuesOfAnEnergy, AreItsSlopeWhereTheDataAreMet) {
  const Grid grid = triangle_grid(4);
  const DomainRule rule = rule_for(triangle(), grid, 3);
  const std::vector<TensorProductSpace> spaces{TensorProductSpace(grid, 3, cells_in_region(rule))};
  const std::vector<Structure> structures{Structure::undetermined()};
  const Field data = x * y + 2.0 * x;  // in the span of the splines, with slopes
  const double half = std::sqrt(0.5);
  const std::vector<Field> normal{half, half};
  const FormPlace place{Contribution::Place::boundary, {2}, {}};
  const Field k = 1.0 / sqrt(1.0 + squared_slope(u));
  const Field q = k * (half * partial(u, 0) + half * partial(u, 1));
  const Form own =
      weak_values(Form::energy(sqrt(1.0 + squared_slope(u))), 0, data, normal, 30, place);
  const Form plain = Form::energy(-1.0 * q * (u - data), place);
  const auto load = [&](const Form& form) {
    const Contribution part = form.linearized(std::vector<Field>{data});
    return assemble(structures, spaces, std::span(&part, 1), rule).right_hand_side;
  };
  EXPECT_LT((load(own) - load(plain)).norm(), 1e-12 * load(plain).norm());
}

TEST(WeakValuesOf, ResidualsAndHigherDerivativesAreRefused) {
  const std::vector<Field> normal{1.0, 0.0};
  EXPECT_THROW(weak_values(Form::least_squares({u}), 0, x, normal, 1, {}), InvalidArgument);
  EXPECT_THROW(weak_values(Form::energy(laplacian(u, 2)), 0, x, normal, 1, {}), InvalidArgument);
  EXPECT_THROW(weak_values(Form::energy(u * u), 0, x, normal, 1, {}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
