#include "problems/run_reader.hpp"

#include <gtest/gtest.h>

#include "problems/reader.hpp"

namespace rfm {
namespace {

int resolution(int dimension, const std::vector<std::string>& overrides = {}) {
  const std::string shape =
      dimension == 3 ? "sphere: {center: [0, 0, 0]" : "circle: {center: [0, 0]";
  const std::string text = "dimension: " + std::to_string(dimension) +
                           "\ngeometry: {shapes: {ball: {" + shape +
                           ", radius: 1}}}, domain: ball}\n"
                           "physics: {type: poisson, source: 1}\n"
                           "conditions: [{at: all, value: 0}]\n";
  return read_problem(make_source("ball.yaml", text), overrides).outputs.resolution;
}

TEST(RunReader, FilesOfFieldsInSpaceAreCoarserUnlessTheProblemSays) {
  EXPECT_EQ(resolution(2), 128);
  EXPECT_EQ(resolution(3), 48);
  EXPECT_EQ(resolution(3, {"outputs.vtu.resolution=90"}), 90);
  EXPECT_EQ(resolution(2, {"outputs.vtu.resolution=90"}), 90);
}

}  // namespace
}  // namespace rfm
