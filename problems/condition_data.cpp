#include "problems/condition_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/nearest_name.hpp"
#include "problems/interpolation.hpp"
#include "problems/result_scope.hpp"
#include "problems/solution_symbols.hpp"

namespace rfm {
namespace {

class ConditionDataReader {
 public:
  ConditionDataReader(const DocumentNode& node, ValueReader& values, const Physics& physics,
                      Condition& condition)
      : node_(node),
        values_(values),
        physics_(physics),
        condition_(condition),
        scope_(values.scope) {
    define_normal(scope_, stand_in_normal(values.dimension));
    if (physics.type == PhysicsType::interpolation) {
      read_interpolated();
    } else {
      if (!values.find(node, "value")) define_symbols(scope_, physics.unknowns, values.dimension);
      refuse_further_derivatives();
      read_kind();
    }
  }

 private:
  void add(const char* key, const DocumentNode* formula) {
    if (!formula) return;
    if (auto expression = values_.deferred(*formula, scope_))
      condition_.data.emplace(key, std::move(*expression));
  }
  // What stands for a formula that the file does not write.
  void add_text(const char* key, const DocumentNode& place, const char* text) {
    if (!values_.fits(place)) return;
    DocumentNode formula = place;
    formula.text = text;
    condition_.data.emplace(key, DeferredExpression(formula));
  }

  void read_kind() {
    using Kind = Condition::Kind;
    if (const DocumentNode* value = values_.find(node_, "value")) {
      condition_.kind = Kind::value;
      read_values(*value);
    } else if (const DocumentNode* free = values_.find(node_, "free")) {
      condition_.kind = Kind::value;  // of no unknown
      if (free->text != "true")
        values_.mistakes.add("expected free: true; what is prescribed takes the place of false",
                             free->place);
      if (const DocumentNode* enforce = values_.find(node_, "enforce"))
        values_.mistakes.add("nothing is prescribed here that could be enforced", enforce->place);
    } else if (const DocumentNode* clamped = values_.find(node_, "clamped")) {
      read_clamped(*clamped);
    } else if (values_.find(node_, "periodic")) {
      condition_.kind = Kind::value;  // of no unknown
      if (const DocumentNode* enforce = values_.find(node_, "enforce"))
        values_.mistakes.add("splines are periodic: nothing is left to be enforced",
                             enforce->place);
    } else if (values_.results.flux.empty()) {
      values_.mistakes.add(
          "custom physics have no flux of their own: write free: true here, and the integral of "
          "what is given under physics.boundary",
          node_.place);
    } else if (const DocumentNode* flux = values_.find(node_, "flux")) {
      condition_.kind = Kind::flux;
      add("flux", flux);
    } else if (const DocumentNode* convection = values_.find(node_, "convection")) {
      condition_.kind = Kind::convection;
      for (const char* key : {"coefficient", "ambient"}) add(key, values_.find(*convection, key));
    } else if (const DocumentNode* robin = values_.find(node_, "robin")) {
      condition_.kind = Kind::robin;
      for (const char* key : {"a", "b", "c"}) add(key, values_.find(*robin, key));
      refuse_zero(values_.find(*robin, "b"));
    } else if (const DocumentNode* slope = values_.find(node_, "normal_derivative")) {
      condition_.kind = Kind::robin;
      add_text("a", *slope, "0");
      add_text("b", *slope, "1");
      add("c", slope);
    } else if (const DocumentNode* tangential = values_.find(node_, "tangential")) {
      condition_.kind = Kind::oblique;
      read_tangential(*tangential);
    } else if (const DocumentNode* oblique = values_.find(node_, "oblique")) {
      condition_.kind = Kind::oblique;
      read_oblique(*oblique);
    }
  }

  // b of a u + b du/dn = c.
  void refuse_zero(const DocumentNode* b) {
    if (!b || !values_.fits(*b)) return;
    try {
      if (to_number(Expression(b->text), values_.number_scope) != 0) return;
    } catch (const InputError&) {  // a formula, or its mistake is reported
      return;
    }
    values_.mistakes.add("b must not vanish: what is left of robin then is a value", b->place);
  }

  void read_clamped(const DocumentNode& clamped) {
    condition_.kind = Condition::Kind::value;
    condition_.clamped = true;
    if (clamped.text != "true") values_.mistakes.add("expected clamped: true", clamped.place);
    if (!values_.results.flux.empty())
      values_.mistakes.add(
          "clamped is for equations of the fourth order: a value and a flux at one "
          "place are too much here",
          clamped.place);
  }

  // Counter-clockwise about the domain.
  void read_tangential(const DocumentNode& along) {
    if (values_.dimension != 2)
      return values_.mistakes.add(
          "a derivative along the boundary has one direction in the plane only", along.place);
    add("value", &along);
    add_text("direction.x", along, "-n.y");
    add_text("direction.y", along, "n.x");
  }

  void read_oblique(const DocumentNode& oblique) {
    add("value", values_.find(oblique, "value"));
    const DocumentNode* direction = values_.find(oblique, "direction");
    if (!direction) return;
    if (static_cast<int>(direction->items.size()) != values_.dimension)
      return values_.mistakes.add(
          "expected a direction of " + std::to_string(values_.dimension) + " components",
          direction->place);
    const char* const keys[] = {"direction.x", "direction.y", "direction.z"};
    for (std::size_t axis = 0; axis < direction->items.size(); ++axis)
      add(keys[axis], &direction->items[axis]);
  }

  // One formula, or one for each unknown that is not free.
  void read_values(const DocumentNode& value) {
    const std::vector<std::string>& unknowns = physics_.unknowns;
    if (!value.is_map()) {
      if (unknowns.size() == 1) return add(unknowns[0].c_str(), &value);
      return values_.mistakes.add("there are several unknowns: expected {" + unknowns[0] +
                                      ": .., " + unknowns[1] + ": ..}; those left out are free",
                                  value.place);
    }
    for (const DocumentNode::Entry& entry : value.entries) {
      if (std::ranges::find(unknowns, entry.key) == unknowns.end())
        values_.mistakes.add("unknown result '" + entry.key + "' in value" +
                                 did_you_mean(entry.key, unknowns) +
                                 fmt::format("; expected: {}", fmt::join(unknowns, ", ")),
                             entry.key_place);
      else if (values_.fits(entry.value))
        add(entry.key.c_str(), &entry.value);
    }
  }

  void read_interpolated() {
    const DocumentNode* value = values_.find(node_, "value");
    condition_.kind = value ? Condition::Kind::value : Condition::Kind::slope;
    if (value) read_values(*value);
    for (const char* key : {"normal_derivative", "second_normal_derivative"})
      add(key, values_.find(node_, key));
    if (const DocumentNode* exponent = values_.find(node_, "exponent"))
      condition_.exponent = values_.integer(*exponent).value_or(0);
  }

  // What goes with interpolation only.
  void refuse_further_derivatives() {
    for (const char* key : {"second_normal_derivative", "exponent"})
      if (const DocumentNode* given = node_.find(key))
        values_.mistakes.add("'" + std::string(key) + "' goes with interpolation only",
                             given->place);
    if (const DocumentNode* given = node_.find("normal_derivative"); given && node_.find("value"))
      values_.mistakes.add(
          "a value and a normal derivative at one place are too much but for interpolation",
          given->place);
  }

  const DocumentNode& node_;
  ValueReader& values_;
  const Physics& physics_;
  Condition& condition_;
  ExpressionScope scope_;  // what the formulas may name
};

}  // namespace

void read_condition_data(const DocumentNode& node, ValueReader& values, const Physics& physics,
                         Condition& condition) {
  ConditionDataReader(node, values, physics, condition);
}

void check_interpolated(const DocumentNode& node, ValueReader& values) {
  check_interpolation_entry(node, values);
  const bool has_data =
      node.find("value") || node.find("normal_derivative") || node.find("second_normal_derivative");
  const DocumentNode* at = node.find("at");
  if (!has_data && at)
    values.mistakes.add("what is interpolated are values and normal derivatives", at->place);
  if (const DocumentNode* enforce = node.find("enforce"))
    values.mistakes.add("an interpolant takes its data by construction", enforce->place);
}

}  // namespace rfm
