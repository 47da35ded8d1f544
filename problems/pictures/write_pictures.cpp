#include "problems/pictures/write_pictures.hpp"

#include "problems/pictures/convergence_picture.hpp"
#include "problems/pictures/modes_picture.hpp"
#include "problems/pictures/shown_field.hpp"
#include "problems/pictures/solution_picture.hpp"

namespace rfm {

std::vector<std::string> write_pictures(ResultFolder& folder, const std::string& name,
                                        const ScalarProblem& problem,
                                        const ScalarSolution& solution,
                                        const std::vector<ConvergenceRow>& convergence) {
  const auto add = [&](const std::string& file, const Image& image) {
    folder.write(file, [&](const std::string& path) { write_png(image, path); });
  };
  std::vector<std::string> remarks;
  Picture plain;
  plain.field = problem.problem().physics.unknowns[0];
  const Picture picture = problem.problem().outputs.picture.value_or(plain);
  add(name + ".png", draw_solution(problem, solution, picture, remarks));
  if (solution.eigen) add(name + ".modes.png", draw_modes(problem, solution, picture, remarks));
  if (const auto image =
          draw_convergence(convergence, shown_title(problem.problem()), picture.width))
    add(name + ".convergence.png", *image);
  return remarks;
}

}  // namespace rfm
