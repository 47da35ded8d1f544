#include "core/expression_writer.hpp"

#include <cmath>
#include <deque>

#include "core/error.hpp"
#include "core/expression_tokens.hpp"
#include "core/field_node.hpp"
#include "core/further_coordinate.hpp"

namespace rfm {
namespace {

// How tightly the parts of a formula bind, loosest first, as in the grammar of expression.hpp.
enum Level : int { comparison, sum, product, negation, power, primary };

constexpr std::size_t deepest_text = 240;   // the parser allows 250
constexpr std::size_t longest_partial = 8;  // dxxyy: so many axes may stand in one name

/// Writes one formula without recursion: graphs may be deeper than the machine's stack.
class Writer {
 public:
  Writer(const ExpressionTextOptions& options, const FieldNames& names)
      : options_(options), names_(names) {}

  std::string write(const Field::Node& root) {
    // The root itself is written out, also where it has a name.
    push(Item{&root, nullptr, comparison, 0, true});
    while (!pending_.empty()) {
      const Item item = std::move(pending_.back());
      pending_.pop_back();
      if (item.node)
        expand(item);
      else
        text_ += item.literal;
      if (text_.size() <= options_.longest) continue;
      if (options_.abbreviated) {
        text_.resize(whole_characters(options_.longest));
        return text_ + "…";
      }
      throw InvalidArgument("the formula is longer than " + std::to_string(options_.longest) +
                            " characters: write it with named parts");
    }
    return std::move(text_);
  }

 private:
  struct Item {
    const Field::Node* node = nullptr;
    const char* literal = nullptr;
    int level = comparison;  // parentheses are needed around what binds less tightly
    std::size_t depth = 0;
    bool in_full = false;
  };

  void push(Item item) { pending_.push_back(std::move(item)); }
  void push(const char* literal) { push(Item{nullptr, literal, 0, 0, false}); }
  void push(const Field& field, int level, std::size_t depth) {
    push(Item{&field.node(), nullptr, level, depth, false});
  }

  std::size_t whole_characters(std::size_t length) const {
    while (length > 0 && (static_cast<unsigned char>(text_[length]) & 0xC0) == 0x80) --length;
    return length;
  }

  void expand(const Item& item) {
    const Field::Node& node = *item.node;
    if (const auto name = names_.find(&node); name != names_.end() && !item.in_full) {
      text_ += name->second;
      return;
    }
    const int own = level_of(node);
    const bool parentheses = own < item.level;
    const std::size_t depth =
        item.depth + parentheses + (own == primary || own == power || own == negation);
    if (depth > deepest_text && !options_.abbreviated)
      throw InvalidArgument("the formula is nested more than " + std::to_string(deepest_text) +
                            " levels deep: write it with named parts");
    if (parentheses) {
      text_ += '(';
      push(")");
    }
    write_node(node, depth);
  }

  static int level_of(const Field::Node& node) {
    switch (node.operation) {
      case Operation::constant:
        if (!std::isfinite(node.number)) return product;
        return std::signbit(node.number) ? negation : primary;
      case Operation::less:
      case Operation::less_equal:
      case Operation::equal:
        return comparison;
      case Operation::add:
      case Operation::subtract:
        return sum;
      case Operation::multiply:
      case Operation::divide:
        return product;
      case Operation::negate:
        return negation;
      case Operation::power:
      case Operation::integer_power:
      case Operation::real_power:
        return power;
      default:
        return primary;
    }
  }

  // What follows is pushed in reverse: the last item pushed is written first.
  void write_node(const Field::Node& node, std::size_t depth) {
    const std::vector<Field>& a = node.arguments;
    const auto infix = [&](int left, const char* symbol, int right) {
      push(a[1], right, depth);
      push(symbol);
      push(a[0], left, depth);
    };
    switch (node.operation) {
      case Operation::constant:
        text_ += number_text(node.number);
        return;
      case Operation::coordinate:
      case Operation::parameter:
        text_ += leaf_name(node);
        return;
      case Operation::source:
        return write_source(node, depth);
      case Operation::partial:
        return write_partial(node, depth);
      case Operation::less:
        return infix(sum, " < ", sum);
      case Operation::less_equal:
        return infix(sum, " <= ", sum);
      case Operation::equal:
        return infix(sum, " == ", sum);
      case Operation::add:
        return infix(sum, " + ", product);
      case Operation::subtract:
        return infix(sum, " - ", product);
      case Operation::multiply:
        return infix(product, "*", negation);
      case Operation::divide:
        return infix(product, "/", negation);
      case Operation::power:
        return infix(primary, "^", negation);
      case Operation::negate:
        text_ += '-';
        return push(a[0], negation, depth);
      case Operation::integer_power:
      case Operation::real_power:
        numbers_.push_back("^" + number_text(node.number));
        push(numbers_.back().c_str());
        return push(a[0], primary, depth);
      default:
        return write_call(node, depth);
    }
  }

  void write_call(const Field::Node& node, std::size_t depth) {
    const OperationRow* row = find_operation(node.operation);
    if (!row || !is_name(row->name))
      throw InvalidArgument("an operation of the field has no form as text");
    text_ += row->name;
    text_ += '(';
    push(")");
    if (row->numbers > 0) {
      numbers_.push_back(", " + number_text(node.number));
      push(numbers_.back().c_str());
    }
    push_arguments(node, depth);
  }

  void push_arguments(const Field::Node& node, std::size_t depth) {
    for (std::size_t i = node.arguments.size(); i-- > 0;) {
      push(node.arguments[i], comparison, depth);
      if (i > 0) push(", ");
    }
  }

  // A sampled field by its name; at a mapped point it is wall(x + 1, y), its derivative there
  // wall.dx(x + 1, y).
  void write_source(const Field::Node& node, std::size_t depth) {
    text_ += leaf_name(node);
    if (node.arguments.empty()) return;
    const MultiIndex alpha = source_derivative(node.index);
    if (degree(alpha) > static_cast<int>(longest_partial))
      throw InvalidArgument("a derivative of a sampled field at a mapped point is of order " +
                            std::to_string(degree(alpha)) + ": names have at most " +
                            std::to_string(longest_partial) + " letters");
    std::string axes;
    for (std::size_t axis = 0; axis < 3; ++axis) axes.append(alpha[axis], "xyz"[axis]);
    if (!axes.empty()) text_ += ".d" + axes;
    text_ += '(';
    push(")");
    push_arguments(node, depth);
  }

  // ∂/∂x of ∂/∂y of f is dyx(f): inner derivatives first.
  void write_partial(const Field::Node& node, std::size_t depth) {
    if (node.index > 3) {  // along a further coordinate: d(f, name)
      const Field along = further_coordinate(node.index);
      numbers_.push_back(", " + leaf_name(along.node()) + ")");
      text_ += "d(";
      push(numbers_.back().c_str());
      return push(node.arguments[0], comparison, depth);
    }
    std::string axes;
    const Field* inner = nullptr;
    for (const Field::Node* outer = &node; axes.size() < longest_partial;) {
      axes.insert(axes.begin(), "xyzt"[outer->index]);
      inner = &outer->arguments[0];
      outer = &inner->node();
      if (outer->operation != Operation::partial || outer->index > 3 || names_.contains(outer))
        break;
    }
    text_ += 'd' + axes + '(';
    push(")");
    push(*inner, comparison, depth);
  }

  // Leaves are named by what they are: each use may be a node of its own.
  static bool is_same_leaf(const Field::Node& a, const Field::Node& b) {
    if (a.operation != b.operation || !a.arguments.empty()) return false;
    return a.operation == Operation::source ? a.source == b.source : a.index == b.index;
  }

  std::string leaf_name(const Field::Node& node) const {
    if (node.operation == Operation::coordinate && node.index < 4) return {"xyzt"[node.index]};
    if (node.operation == Operation::parameter) {
      if (node.index < static_cast<int>(options_.parameters.size()))
        return options_.parameters[static_cast<std::size_t>(node.index)];
      if (node.name) return *node.name;
    }
    for (const auto& [name, field] : options_.names)
      if (is_same_leaf(field.node(), node)) return name;
    const std::string what = node.operation == Operation::source ? "sampled field"
                             : node.operation == Operation::coordinate
                                 ? "coordinate " + std::to_string(node.index)
                                 : "parameter " + std::to_string(node.index);
    if (options_.abbreviated) return "[" + what + "]";
    throw InvalidArgument("a " + what + " has no name in the text");
  }

  const ExpressionTextOptions& options_;
  const FieldNames& names_;
  std::vector<Item> pending_;
  std::deque<std::string> numbers_;  // literals made here, never moved
  std::string text_;
};

}  // namespace

std::string written(const Field::Node& root, const ExpressionTextOptions& options,
                    const FieldNames& names) {
  return Writer(options, names).write(root);
}

}  // namespace rfm
