#include "problems/pictures/solution_picture.hpp"

#include "problems/pictures/line_picture.hpp"
#include "problems/pictures/plane_picture.hpp"
#include "problems/pictures/space_picture.hpp"

namespace rfm {

Image draw_solution(const ScalarProblem& problem, const ScalarSolution& solution,
                    const Picture& picture, std::vector<std::string>& remarks) {
  return draw_shown(problem, shown_field(problem.problem(), solution, picture), picture, remarks);
}

Image draw_shown(const ScalarProblem& problem, const ShownField& shown, const Picture& picture,
                 std::vector<std::string>& remarks) {
  switch (problem.problem().dimension) {
    case 1:
      return draw_line(problem, shown, picture, remarks);
    case 2:
      return draw_plane(problem, shown, picture, remarks);
    default:
      return draw_space(problem, shown, picture, remarks);
  }
}

}  // namespace rfm
