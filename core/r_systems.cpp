#include "core/r_systems.hpp"

namespace rfm {
namespace {

struct Printer {
  std::ostream& stream;
  void operator()(const RAlpha& r) const { stream << "R-alpha, alpha = " << r.alpha; }
  void operator()(const R1&) const { stream << "R1"; }
  void operator()(const Rp& r) const { stream << "R-p, p = " << r.p; }
  void operator()(const RAlphaField&) const { stream << "R-alpha, alpha a field"; }
  void operator()(const RAlphaM& r) const {
    stream << "R-alpha-m, alpha = " << r.alpha << ", m = " << r.m;
  }
  void operator()(const RCm& r) const { stream << "R-C-m, m = " << r.m; }
};

}  // namespace

std::ostream& operator<<(std::ostream& stream, const RSystem& system) {
  std::visit(Printer{stream}, system);
  return stream;
}

}  // namespace rfm
