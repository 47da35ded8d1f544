#include "problems/definition_reader.hpp"

#include <algorithm>
#include <set>

#include "core/expression_tokens.hpp"
#include "problems/reserved_names.hpp"
#include "problems/result_scope.hpp"

namespace rfm {
namespace {

/// A parameter, field or function of the file.
struct Definition {
  enum class Kind { parameter, field, function };
  Kind kind;
  std::string name;
  std::vector<std::string> arguments;
  const DocumentNode::Entry* entry;
  std::optional<Expression> formula;  ///< nothing where it has a mistake

  bool hides(const std::string& used) const {
    return std::ranges::find(arguments, used) != arguments.end();
  }
};

// An argument may hide other names, but not what has a meaning in every formula.
void refuse_argument(const std::vector<std::string>& arguments, const Token& token) {
  const std::string& name = arguments.back();
  const auto refuse = [&](const std::string& message) {
    throw InputError(message, token.offset, token.length);
  };
  if (std::ranges::count(arguments, name) > 1) refuse("the argument '" + name + "' is given twice");
  if (name == "pi") refuse("an argument cannot be called 'pi': it is a number in every formula");
  if (is_reserved_in_expressions(name))
    refuse("an argument cannot be called '" + name + "': that is a function");
}

/// `f(a, b)` → name and arguments. Throws `InputError`.
void parse_head(const std::string& head, std::string& name, std::vector<std::string>& arguments) {
  const auto take_name = [](Tokenizer& tokens, const char* what) {
    const Token token = tokens.take();
    if (token.kind != Token::Kind::name || !is_name(token.text))
      throw InputError(std::string("expected ") + what + " but found " + token.quoted(),
                       token.offset, token.length);
    return std::string(token.text);
  };
  Tokenizer tokens(head);
  name = take_name(tokens, "the name of a function");
  if (!tokens.take_if("("))
    throw InputError("a function is defined as " + name + "(a, b): formula", tokens.peek().offset);
  do {
    const Token next = tokens.peek();
    arguments.push_back(take_name(tokens, "the name of an argument"));
    refuse_argument(arguments, next);
  } while (tokens.take_if(","));
  const bool is_closed = tokens.take_if(")");
  if (!is_closed || tokens.peek().kind != Token::Kind::end)
    throw InputError(std::string("expected ") + (is_closed ? "the end" : "',' or ')'") +
                         " but found " + tokens.peek().quoted(),
                     tokens.peek().offset, tokens.peek().length);
}

}  // namespace

class DefinitionReader::Definitions {
 public:
  Definitions(const DocumentNode& root, ValueReader& values, Problem& problem)
      : root_(root), values_(values), problem_(problem) {}

  void read() {
    collect("parameters", Definition::Kind::parameter);
    collect("fields", Definition::Kind::field);
    collect("functions", Definition::Kind::function);
    refuse_repeated_names();
    refuse_cycles();
    define_functions(values_.number_scope);
    define_functions(values_.scope);
    for (const Definition& definition : definitions_)
      if (definition.kind == Definition::Kind::field) define_field(definition);
    for (const Definition* definition : order_)
      if (definition->kind == Definition::Kind::parameter) define_parameter(*definition);
  }

  void check() {
    ExpressionScope permissive = values_.scope;
    const std::vector<Field> normal = stand_in_normal(values_.dimension);
    define_results(permissive, values_.results);
    define_normal(permissive, normal);
    define_boundary_results(permissive, values_.results, normal);
    for (const Definition* definition : order_) {
      if (definition->kind == Definition::Kind::parameter || !is_sound(*definition)) continue;
      if (evaluates(*definition, permissive)) continue;
      replace(*definition, permissive);
      replace(*definition, values_.scope);
      replace(*definition, values_.number_scope);
    }
  }

 private:
  void collect(std::string_view key, Definition::Kind kind) {
    const DocumentNode* map = values_.find(root_, key);
    if (!map) return;
    std::set<std::string> seen;
    for (const DocumentNode::Entry& entry : map->entries) {
      if (!seen.insert(entry.key).second) continue;  // reported as a duplicate
      Definition definition{kind, entry.key, {}, &entry, {}};
      if (kind == Definition::Kind::function && !read_head(definition)) continue;
      const std::string objection = objection_to_name(definition.name);
      if (!objection.empty()) {
        values_.mistakes.add(objection, entry.key_place);
        continue;
      }
      read_formula(definition);
      definitions_.push_back(std::move(definition));
    }
  }

  bool read_head(Definition& definition) {
    DocumentNode head;
    head.text = definition.entry->key;
    head.place = definition.entry->key_place;
    const auto parsed = values_.guarded<bool>(head, [&] {
      parse_head(head.text, definition.name, definition.arguments);
      return true;
    });
    return parsed.has_value();
  }

  void read_formula(Definition& definition) {
    const DocumentNode& node = definition.entry->value;
    if (!node.is_scalar()) {  // a field may be the result of another problem
      if (definition.kind == Definition::Kind::function)
        values_.mistakes.add("expected a formula for '" + definition.entry->key + "'", node.place);
      return;
    }
    definition.formula = values_.guarded<Expression>(node, [&] { return Expression(node.text); });
  }

  void refuse_repeated_names() {
    for (const Definition& definition : definitions_) {
      const auto [known, is_new] = index_.emplace(definition.name, &definition);
      if (!is_new)
        values_.mistakes.add("the name '" + definition.name + "' is already taken",
                             definition.entry->key_place,
                             {{"first given here", known->second->entry->key_place}});
    }
  }

  struct Visit {
    const Definition* definition;
    std::vector<const Definition*> next;
  };

  // Depth-first search with a stack of its own: chains of definitions may be long.
  void refuse_cycles() {
    std::set<const Definition*> done, open;
    std::vector<Visit> path;
    const auto enter = [&](const Definition* definition) {
      path.push_back({definition, used_by(*definition)});
      open.insert(definition);
    };
    for (const Definition& start : definitions_) {
      if (!done.contains(&start)) enter(&start);
      while (!path.empty()) {
        Visit& visit = path.back();
        if (visit.next.empty()) {
          done.insert(visit.definition);
          open.erase(visit.definition);
          order_.push_back(visit.definition);
          path.pop_back();
          continue;
        }
        const Definition* next = visit.next.back();
        visit.next.pop_back();
        if (open.contains(next))
          report_cycle(path, next);
        else if (!done.contains(next))
          enter(next);
      }
    }
  }

  void report_cycle(const std::vector<Visit>& path, const Definition* start) {
    constexpr int most_named = 10;
    std::string cycle;
    int length = 0;
    for (auto step = std::ranges::find(path, start, &Visit::definition); step != path.end();
         ++step) {
      broken_.insert(step->definition);
      if (++length <= most_named) cycle += step->definition->name + " -> ";
    }
    if (length > most_named) cycle += "... -> ";
    values_.mistakes.add("a definition that uses itself: " + cycle + start->name,
                         start->entry->key_place);
  }

  std::vector<const Definition*> used_by(const Definition& definition) const {
    std::vector<const Definition*> used;
    if (!definition.formula) return used;
    for (const Expression::Use& use : definition.formula->uses()) {
      const auto found = index_.find(use.name);
      if (found != index_.end() && !definition.hides(use.name)) used.push_back(found->second);
    }
    return used;
  }

  bool is_sound(const Definition& definition) const {
    return definition.formula && !broken_.contains(&definition);
  }

  bool evaluates(const Definition& definition, const ExpressionScope& permissive) {
    const auto check = [&](const ExpressionScope& scope) {
      const auto value = values_.guarded<ExpressionValue>(
          definition.entry->value, [&] { return evaluate(*definition.formula, scope); });
      return value.has_value();
    };
    if (definition.arguments.empty()) return check(permissive);
    ExpressionScope inside = permissive;
    // An argument that is called is a function, sin for one; others may be coordinates.
    for (const std::string& argument : definition.arguments) {
      const bool is_called = std::ranges::any_of(definition.formula->uses(), [&](const auto& use) {
        return use.is_call && use.name.substr(0, use.name.find('.')) == argument;
      });
      inside.define(argument, is_called ? sin(x_coordinate()) : x_coordinate());
    }
    return check(inside);
  }

  // A definition with a mistake stands for 1, so that its users are not reported as well.
  static void replace(const Definition& definition, ExpressionScope& scope) {
    if (definition.kind == Definition::Kind::function)
      scope.define_function(definition.name, definition.arguments, Expression("1"));
    else if (scope.has_name(definition.name))
      scope.define(definition.name, Expression("1"));
  }

  void define_functions(ExpressionScope& scope) {
    for (const Definition& definition : definitions_)
      if (definition.kind == Definition::Kind::function)
        scope.define_function(definition.name, definition.arguments,
                              is_sound(definition) ? *definition.formula : Expression("1"));
  }

  void define_parameter(const Definition& definition) {
    std::optional<double> value;
    if (is_sound(definition)) value = values_.number(definition.entry->value);
    values_.number_scope.define(definition.name, value.value_or(1.0));
    values_.scope.define_parameter(definition.name, value.value_or(1.0));
    problem_.parameters.emplace(definition.name, value.value_or(1.0));
  }

  void define_field(const Definition& definition) {
    values_.number_scope.refuse(definition.name, "is a field: a number is needed here");
    problem_.fields.push_back(definition.name);
    if (definition.entry->value.is_map()) {
      const std::optional<Field> result = values_.field(definition.entry->value);
      return values_.scope.define(definition.name, result.value_or(Field(1.0)));
    }
    values_.scope.define(definition.name,
                         is_sound(definition) ? *definition.formula : Expression("1"));
  }

  const DocumentNode& root_;
  ValueReader& values_;
  Problem& problem_;
  std::vector<Definition> definitions_;
  std::map<std::string, const Definition*> index_;
  std::set<const Definition*> broken_;
  std::vector<const Definition*> order_;  // used before users
};

DefinitionReader::DefinitionReader(const DocumentNode& root, ValueReader& values, Problem& problem)
    : definitions_(std::make_unique<Definitions>(root, values, problem)) {}

DefinitionReader::~DefinitionReader() = default;

void DefinitionReader::read() { definitions_->read(); }
void DefinitionReader::check() { definitions_->check(); }

}  // namespace rfm
