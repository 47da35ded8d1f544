#include "problems/combine_reader.hpp"

#include <gtest/gtest.h>

#include "core/evaluate.hpp"
#include "problems/reader.hpp"

namespace rfm {
namespace {

WeightOptions options(const std::string& combine) {
  const std::string text =
      "dimension: 2\n"
      "parameters: {k: 4}\n"
      "geometry:\n"
      "  shapes: {plate: {box: {min: [0, 0], max: [2, 1]}}}\n"
      "  domain: plate\n"
      "  combine: " +
      combine +
      "\n"
      "physics: {type: poisson, source: 1}\n"
      "conditions: [{at: all, value: 0}]\n";
  return read_problem(make_source("plate.yaml", text)).combine;
}

template <class System>
System system_of(const std::string& combine) {
  return std::get<System>(std::get<RSystem>(options(combine).rule));
}

TEST(CombineReader, ReadsEveryRule) {
  EXPECT_TRUE(std::holds_alternative<AutomaticRule>(options("{}").rule));
  EXPECT_TRUE(std::holds_alternative<AutomaticRule>(options("{rule: auto}").rule));
  EXPECT_TRUE(std::holds_alternative<ProductRule>(options("{rule: product}").rule));
  EXPECT_EQ(system_of<RAlpha>("{rule: R0}").alpha, 0);
  EXPECT_EQ(system_of<RAlpha>("{rule: Ralpha, alpha: -1/2}").alpha, -0.5);
  system_of<R1>("{rule: R1}");
  EXPECT_EQ(system_of<Rp>("{rule: Rp, p: 2*k}").p, 8);
  EXPECT_EQ(system_of<RAlphaM>("{rule: R0m, m: 3}").m, 3);
  EXPECT_EQ(system_of<RAlphaM>("{rule: R0m, m: 3}").alpha, 0);
  const auto plateau = std::get<PlateauRule>(options("{rule: plateau, width: 1/k}").rule);
  EXPECT_EQ(plateau.width, 0.25);
  EXPECT_EQ(plateau.power, 3);
}

TEST(CombineReader, ReadsWhatShapesTheFunctions) {
  const WeightOptions read = options(
      "{saturate: {beta: 2}, cap: 1 + x, corner_scales: {plate.left: k, plate.left & plate.top: "
      "3}}");
  ASSERT_TRUE(read.saturation && read.cap);
  EXPECT_EQ(read.saturation->alpha, 2);
  EXPECT_EQ(read.saturation->beta, 2);
  EXPECT_EQ(value_at(*read.cap, {0.5, 0}), 1.5);
  ASSERT_EQ(read.piece_scales.size(), 1u);
  EXPECT_EQ(read.piece_scales[0].name, "plate.left");
  EXPECT_EQ(read.piece_scales[0].scale, 4);
  ASSERT_EQ(read.corner_scales.size(), 1u);
  EXPECT_EQ(read.corner_scales[0].first, "plate.left");
  EXPECT_EQ(read.corner_scales[0].second, "plate.top");
  EXPECT_EQ(read.corner_scales[0].scale, 3);
}

}  // namespace
}  // namespace rfm
