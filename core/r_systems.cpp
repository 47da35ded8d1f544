#include "core/r_systems.hpp"

#include "core/expression_text.hpp"

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
  void operator()(const UserSystem& r) const { stream << "system " << r.name; }
};

struct NormalizationOrder {
  int operator()(const RAlpha& r) const { return r.alpha == 1 ? every_order : 1; }
  int operator()(const R1&) const { return every_order; }
  int operator()(const Rp& r) const { return r.p - 1; }
  int operator()(const RAlphaField&) const { return 1; }
  int operator()(const RAlphaM&) const { return 0; }
  int operator()(const RCm& r) const { return r.m == 1 ? every_order : 0; }
  int operator()(const UserSystem& r) const { return r.normalization_order; }
};

constexpr const char* kinked = "continuous, with a kink wherever two arguments are equal";
constexpr const char* cornered =
    "analytic but where two arguments vanish together; there Lipschitz";

struct Smoothness {
  std::string operator()(const RAlpha& r) const { return r.alpha == 1 ? kinked : cornered; }
  std::string operator()(const R1&) const { return kinked; }
  std::string operator()(const Rp&) const { return cornered; }
  std::string operator()(const RAlphaField&) const {
    return "as alpha, but where two arguments vanish together; there Lipschitz";
  }
  std::string operator()(const RAlphaM& r) const {
    return std::to_string(r.m) + " times differentiable; flat where two arguments vanish together";
  }
  std::string operator()(const RCm& r) const {
    return r.m == 1 ? kinked : std::to_string(r.m - 1) + " times differentiable";
  }
  std::string operator()(const UserSystem& r) const { return r.smoothness; }
};

/// The name of an operation up to `_and` and `_or`, and what follows its arguments.
struct OperationName {
  std::string name;
  std::string parameters;
};

struct Naming {
  OperationName operator()(const RAlpha& r) const {
    return r.alpha == 0 ? OperationName{"r0", ""}
                        : OperationName{"ralpha", ", " + number_text(r.alpha)};
  }
  OperationName operator()(const R1&) const { return {}; }
  OperationName operator()(const Rp& r) const {
    return r.p == 2 ? OperationName{"r0", ""} : OperationName{"rp", ", " + std::to_string(r.p)};
  }
  OperationName operator()(const RAlphaField& r) const {
    return {"ralpha_field",
            ", " + to_text(r.alpha, {.parameters = {}, .names = {}, .abbreviated = true})};
  }
  OperationName operator()(const RAlphaM& r) const {
    const std::string order = ", " + std::to_string(r.m);
    return r.alpha == 0 ? OperationName{"r0m", order}
                        : OperationName{"ralpham", ", " + number_text(r.alpha) + order};
  }
  OperationName operator()(const RCm& r) const { return {"rcm", ", " + std::to_string(r.m)}; }
  OperationName operator()(const UserSystem& r) const { return {r.name, ""}; }
};

bool is_r1(const RSystem& system) {
  const auto* alpha = std::get_if<RAlpha>(&system);
  return std::holds_alternative<R1>(system) || (alpha && alpha->alpha == 1);
}

}  // namespace

std::ostream& operator<<(std::ostream& stream, const RSystem& system) {
  std::visit(Printer{stream}, system);
  return stream;
}

int normalization_order(const RSystem& system) { return std::visit(NormalizationOrder{}, system); }

std::string smoothness_text(const RSystem& system) { return std::visit(Smoothness{}, system); }

std::string operation_text(const RSystem& system, bool conjunction, const std::string& a,
                           const std::string& b) {
  if (is_r1(system)) return (conjunction ? "min(" : "max(") + a + ", " + b + ")";
  const OperationName operation = std::visit(Naming{}, system);
  return operation.name + (conjunction ? "_and(" : "_or(") + a + ", " + b + operation.parameters +
         ")";
}

}  // namespace rfm
