#include "problems/pictures/check_picture.hpp"

#include "problems/pictures/line_check.hpp"
#include "problems/pictures/plane_check.hpp"

namespace rfm {

std::optional<Image> draw_check(const ScalarProblem& problem, const DomainRule& rule, int width,
                                std::vector<std::string>& remarks) {
  switch (problem.problem().dimension) {
    case 1:
      return draw_line_check(problem, rule.grid(), width);
    case 2:
      return draw_plane_check(problem, rule, width);
    default:
      remarks.push_back("pictures of bodies in space are not supported yet");
      return std::nullopt;
  }
}

}  // namespace rfm
