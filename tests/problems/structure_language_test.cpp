// The structure that the program finds is printed as text; written into the file it gives the same
// solution.

#include "problems/structure_language.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "problems/reader.hpp"
#include "problems/scalar_problem.hpp"
#include "solvers/integrate.hpp"

using namespace rfm;

namespace {

const std::filesystem::path verification = RFM_VERIFICATION_FOLDER;

// As a value of `--set`: one formula, or one for each unknown.
std::string as_yaml(const Problem& problem, const std::vector<std::string>& lines) {
  if (lines.size() == 1) return "\"" + lines[0] + "\"";
  std::string text;
  for (std::size_t c = 0; c < lines.size(); ++c)
    text += (c > 0 ? ", " : "") + problem.physics.unknowns[c] + ": \"" + lines[c] + "\"";
  return "{" + text + "}";
}

std::vector<std::string> lines_of(const ScalarProblem& problem, const Grid& grid) {
  std::vector<std::string> lines;
  for (const std::optional<std::string>& line : problem.structure_lines(grid))
    lines.push_back(line.value_or("not to be written"));
  return lines;
}

// The largest difference of the solutions of a file with its own structure and with the printed
// one, relative to the solution.
double difference(const std::string& file, std::vector<std::string> overrides) {
  const std::string path = (verification / (file + ".yaml")).string();
  const Problem found = read_problem(path, overrides);
  const ScalarProblem with_found(found);
  const Grid grid = with_found.grid();
  const ScalarSolution a = with_found.solve(grid);
  overrides.push_back("discretization.structure=" + as_yaml(found, lines_of(with_found, grid)));
  const Problem printed = read_problem(path, overrides);
  const ScalarProblem with_printed(printed);
  const ScalarSolution b = with_printed.solve(grid);
  double largest = 0;
  for (std::size_t c = 0; c < a.results.unknowns.size(); ++c) {
    const Field& own = a.results.unknowns[c].field;
    const Field& other = b.results.unknowns[c].field;
    largest = std::max(largest, norms(own - other, a.rule).maximum / norms(own, a.rule).maximum);
  }
  EXPECT_EQ(a.unknowns, b.unknowns);
  return largest;
}

struct Case {
  const char* file;
  int cells = 8;
};
std::ostream& operator<<(std::ostream& stream, const Case& c) { return stream << c.file; }

class PrintedStructure : public testing::TestWithParam<Case> {};
TEST_P(PrintedStructure, WrittenIntoTheFileGivesTheSameSolution) {
  EXPECT_LT(difference(GetParam().file,
                       {"discretization.basis.cells=" + std::to_string(GetParam().cells)}),
            1e-12);
}
INSTANTIATE_TEST_SUITE_P(
    OfFiles, PrintedStructure,
    testing::Values(
        // Products, R-functions, unions; data of one and of several pieces; parts of pieces;
        // natural conditions alone; several unknowns, nonlinear ones, the line and space.
        Case{"annulus_inhomogeneous"}, Case{"annulus_homogeneous"}, Case{"disk_quadratic"},
        Case{"rotated_square"}, Case{"square_torsion"}, Case{"rectangle_four_conditions"},
        Case{"disk_arc"}, Case{"ring_two_materials"}, Case{"ring_flux_robin"},
        Case{"torsion_ellipse"}, Case{"torsion_equilateral"}, Case{"torsion_lshape"},
        Case{"laplace_lshape"}, Case{"poisson_disk_minus_disks", 16}, Case{"mixed_robin_annulus"},
        Case{"motz"}, Case{"anisotropic_reaction"}, Case{"neumann_mean_zero"}, Case{"exclusive_or"},
        Case{"half_moon"}, Case{"polygon_acute"}, Case{"stadium_values"},
        Case{"squares_that_share_a_side"}, Case{"chosen_boundaries"}, Case{"bar"},
        Case{"poisson_cube", 4}, Case{"balls", 5}, Case{"rotated_cylinder", 5},
        Case{"forms/clamped_disk"}, Case{"forms/coupled_pair"}, Case{"forms/stokes_channel"},
        Case{"forms/lame_cylinder"}, Case{"forms/nonlinear_diffusion"},
        Case{"structures/flux_by_structure"}, Case{"structures/motz"}));

TEST(PrintedStructure, NamesShapesAndDataAsTheFileDoes) {
  const Problem problem = read_problem((verification / "annulus_inhomogeneous.yaml").string());
  const ScalarProblem scalar(problem);
  const std::string line = lines_of(scalar, scalar.grid())[0];
  EXPECT_THAT(line, testing::StartsWith("transfinite("));
  EXPECT_THAT(line, testing::HasSubstr("(exact + outer_circle*cos(x + 2*y))"));
  EXPECT_THAT(line, testing::EndsWith("omega(outer)*-omega(inner)*psi1"));
  const Problem ellipse = read_problem((verification / "torsion_ellipse.yaml").string());
  const ScalarProblem with_level(ellipse);
  EXPECT_THAT(lines_of(with_level, with_level.grid())[0], testing::HasSubstr("level("));
}

// A disk with a hole, on which a condition holds by structure.
std::string ring(const std::string& condition, const std::string& discretization = "") {
  return "dimension: 2\n"
         "fields: {near: 1 + x}\n"
         "geometry:\n"
         "  shapes:\n"
         "    disk: {circle: {center: [0, 0], radius: 1}}\n"
         "    hole: {circle: {center: [0.1, 0], radius: 0.4}}\n"
         "  domain: disk - hole\n"
         "discretization: {basis: {bspline: 3, cells: 12}" +
         discretization +
         "}\n"
         "physics: {type: poisson, diffusivity: 2 + x, source: 1}\n"
         "conditions:\n"
         "  - {at: disk, value: sin(3*x) + y}\n"
         "  - {at: hole, " +
         condition + ", enforce: structure}\n";
}

std::vector<std::string> printed(const std::string& text) {
  const Problem problem = read_problem(make_source("ring.yaml", text));
  const ScalarProblem scalar(problem);
  return lines_of(scalar, scalar.grid());
}

TEST(PrintedStructure, MayHaveMoreThanNineFunctions) {
  std::string line = "omega(disk)*(psi1";
  for (int k = 2; k <= 64; ++k)
    line += " + x^" + std::to_string(k % 5) + "*psi" + std::to_string(k);
  const Problem problem = read_problem(make_source(
      "many.yaml",
      "dimension: 2\n"
      "geometry: {shapes: {disk: {circle: {center: [0, 0], radius: 1}}}, domain: disk}\n"
      "physics: {type: poisson, source: 1}\n"
      "conditions: [{at: disk, value: 0}]\n"
      "discretization: {basis: {cells: 4}, structure: \"" +
          line + ")\"}\n"));
  EXPECT_EQ(ScalarProblem(problem).function_count(), 64);
}

TEST(PrintedStructure, OfANaturalConditionIsReadBackAsItself) {
  for (const char* condition :
       {"flux: cos(x)", "convection: {coefficient: 3, ambient: x}", "robin: {a: 1, b: 2, c: y}"}) {
    const std::string line = printed(ring(condition))[0];
    EXPECT_THAT(line, testing::HasSubstr("near("));
    EXPECT_THAT(line, testing::HasSubstr("D("));
    EXPECT_EQ(printed(ring(condition, ", structure: \"" + line + "\""))[0], line);
  }
}

}  // namespace
