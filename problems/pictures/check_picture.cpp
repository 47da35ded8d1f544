#include "problems/pictures/check_picture.hpp"

#include "problems/pictures/line_check.hpp"
#include "problems/pictures/plane_check.hpp"
#include "problems/pictures/space_check.hpp"

namespace rfm {

Image draw_check(const ScalarProblem& problem, const DomainRule& rule, int width) {
  switch (problem.problem().dimension) {
    case 1:
      return draw_line_check(problem, rule.grid(), width);
    case 2:
      return draw_plane_check(problem, rule, width);
    default:
      return draw_space_check(problem, rule, width);
  }
}

}  // namespace rfm
