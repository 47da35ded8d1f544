#include "core/slots.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "core/further_coordinate.hpp"
#include "core/jet_shape.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

Field slot(int i) { return further_coordinate(4 + i); }

std::vector<Field> first_slots(int count) {
  std::vector<Field> slots;
  for (int i = 0; i < count; ++i) slots.push_back(slot(i));
  return slots;
}

// Value, gradient and full Hessian at one point of a block of several.
struct Derivatives {
  double value;
  std::vector<double> gradient, hessian;
};

std::vector<Derivatives> evaluate_block(const Field& function,
                                        const std::vector<std::vector<double>>& slots) {
  const int n = static_cast<int>(slots[0].size()), count = static_cast<int>(slots.size());
  const auto [gradient, hessian] = slot_derivatives(function, first_slots(n));
  std::vector<Field> roots{function};
  for (const SlotSlope& entry : gradient) roots.push_back(entry.value);
  for (const SlotCurvature& entry : hessian) roots.push_back(entry.value);
  const Tape tape(roots, {0}, Variables(std::vector<int>{0}));
  std::vector<std::vector<double>> rows(n);
  for (const auto& values : slots)
    for (int i = 0; i < n; ++i) rows[i].push_back(values[i]);
  std::vector<const double*> pointers;
  for (const auto& row : rows) pointers.push_back(row.data());
  std::vector<double> xs(count, 0.5);
  Tape::Workspace workspace(tape);
  tape.evaluate(
      {.coordinates = {xs.data(), xs.data(), xs.data()}, .count = count, .further = pointers},
      workspace);
  std::vector<Derivatives> found;
  for (int k = 0; k < count; ++k) {
    int root = 0;
    const auto next = [&] { return workspace.coefficient(root++)[k]; };
    Derivatives d{next(), std::vector<double>(n), std::vector<double>(n * n)};
    for (const SlotSlope& entry : gradient) d.gradient[entry.slot] = next();
    for (const SlotCurvature& entry : hessian)
      d.hessian[entry.row * n + entry.column] = d.hessian[entry.column * n + entry.row] = next();
    found.push_back(std::move(d));
  }
  return found;
}

std::vector<std::vector<double>> random_slots(int count, int n) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-0.4, 0.4);
  std::vector<std::vector<double>> slots(count, std::vector<double>(n));
  for (auto& values : slots)
    for (double& value : values) value = uniform(generator);
  return slots;
}

TEST(Slots, MinimalSurfaceHasItsClosedForm) {
  // W = √(1 + |p|²): ∇W = p/W, H = (I − p pᵀ/W²)/W.
  const Field area = sqrt(1 + slot(0) * slot(0) + slot(1) * slot(1));
  const auto slots = random_slots(11, 2);
  const auto found = evaluate_block(area, slots);
  for (int k = 0; k < 11; ++k) {
    const auto& p = slots[k];
    const double w = std::sqrt(1 + p[0] * p[0] + p[1] * p[1]);
    EXPECT_NEAR(found[k].value, w, 1e-15);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(found[k].gradient[i], p[i] / w, 1e-15);
      for (int j = 0; j < 2; ++j)
        EXPECT_NEAR(found[k].hessian[2 * i + j], ((i == j) - p[i] * p[j] / (w * w)) / w, 1e-15);
    }
  }
}

TEST(Slots, ElasticEnergyIsQuadraticWithTheTensorOfElasticity) {
  // W = μ e:e + λ/2 (tr e)², e the symmetric part of the displacement gradient in 3D: slots 3i + j.
  const double mu = 1.3, lambda = 0.7;
  Field trace = 0.0, energy = 0.0;
  for (int i = 0; i < 3; ++i) {
    trace = trace + slot(4 * i);
    for (int j = 0; j < 3; ++j)
      energy = energy + mu * pow(0.5 * (slot(3 * i + j) + slot(3 * j + i)), 2);
  }
  const Field elastic = energy + lambda / 2 * trace * trace;
  const std::vector<SlotCurvature> hessian = slot_derivatives(elastic, first_slots(9)).hessian;
  for (const SlotCurvature& entry : hessian) EXPECT_TRUE(entry.value.is_constant());
  EXPECT_EQ(hessian.size(), 9u + 3u + 3u);  // diagonal, pairs of shear, pairs of stretch
  const auto slots = random_slots(3, 9);
  const auto found = evaluate_block(elastic, slots);
  for (int a = 0; a < 9; ++a)
    for (int b = 0; b < 9; ++b) {
      const int i = a / 3, j = a % 3, k = b / 3, l = b % 3;
      const double expected =
          lambda * (i == j && k == l) + mu * ((i == k && j == l) + (i == l && j == k));
      EXPECT_NEAR(found[0].hessian[9 * a + b], expected, 1e-15);
    }
  for (int a = 0; a < 9; ++a) {  // the gradient of a quadratic form is H d
    double sum = 0;
    for (int b = 0; b < 9; ++b) sum += found[1].hessian[9 * a + b] * slots[1][b];
    EXPECT_NEAR(found[1].gradient[a], sum, 1e-15);
  }
}

TEST(Slots, CoefficientsMayDependOnPosition) {
  const Field energy = (1 + x_coordinate()) * slot(0) * slot(0);
  EXPECT_EQ(evaluate_block(energy, {{3}})[0].hessian[0], 3);  // 2 (1 + x) at x = 0.5
}

TEST(Slots, HyperelasticEnergyAgreesWithJets) {
  // Neo-Hooke in 2D: μ/2 (|F|² − 2) − μ log J + λ/2 (log J)², F = I + ∇u, four slots: as many as
  // jets have variables.
  const Field a = 1 + slot(0), b = slot(1), c = slot(2), d = 1 + slot(3);
  const Field logarithm = log(a * d - b * c);
  const Field energy =
      0.65 * (a * a + b * b + c * c + d * d - 2) - 1.3 * logarithm + 0.35 * logarithm * logarithm;
  const Tape jets({energy}, {2}, Variables(std::vector<int>{4, 5, 6, 7}));
  const auto slots = random_slots(9, 4);
  const auto found = evaluate_block(energy, slots);
  for (int k = 0; k < 9; ++k) {
    const std::vector<double> jet = jets.jet({}, 0, {0, {}, slots[k]});
    EXPECT_NEAR(found[k].value, jet[0], 1e-14);
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(found[k].gradient[i], jet[1 + i], 1e-14);
      for (int j = 0; j < 4; ++j)
        EXPECT_NEAR(found[k].hessian[4 * i + j],
                    jet[jet_index(4, unit_index(i) + unit_index(j))] * (i == j ? 2 : 1), 1e-13);
    }
  }
}

TEST(Slots, SixtySlotsOfAChainHaveABandedHessian) {
  Field energy = 0.0;
  for (int i = 0; i + 1 < 60; ++i) energy = energy + exp(slot(i) - slot(i + 1));
  const auto [gradient, hessian] = slot_derivatives(energy, first_slots(60));
  EXPECT_EQ(gradient.size(), 60u);
  EXPECT_EQ(hessian.size(), 60u + 59u);
  const auto slots = random_slots(2, 60);
  const auto found = evaluate_block(energy, slots);
  for (int i = 1; i < 59; ++i) {
    const double before = std::exp(slots[1][i - 1] - slots[1][i]);
    const double after = std::exp(slots[1][i] - slots[1][i + 1]);
    EXPECT_NEAR(found[1].gradient[i], after - before, 1e-14);
    EXPECT_NEAR(found[1].hessian[60 * i + i], after + before, 1e-14);
    EXPECT_NEAR(found[1].hessian[60 * i + i + 1], -after, 1e-14);
  }
}

TEST(Slots, WrongSlotsAreRefused) {
  EXPECT_THROW(slot_derivatives(slot(0), {slot(0), slot(0)}), InvalidArgument);
  EXPECT_THROW(slot_derivatives(slot(0), {slot(0) + 1}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
