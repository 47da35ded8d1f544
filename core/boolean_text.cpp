#include "core/boolean_text.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/expression_tokens.hpp"
#include "core/nearest_name.hpp"

namespace rfm {
namespace {

constexpr int deepest_nesting = 250;
constexpr std::size_t largest_expression = 100'000;

std::size_t size_of(const Region& region) { return region.expression().nodes().size(); }
std::size_t size_of(const BooleanExpression& expression) { return expression.nodes().size(); }

}  // namespace

/// One function per level of the grammar, loosest first.
class BooleanTextParser {
 public:
  using Node = BooleanText::Node;

  explicit BooleanTextParser(std::string_view text) : tokens_(text) {}

  std::vector<Node> parse() {
    if (tokens_.peek().kind == Token::Kind::end)
      throw InputError("expected an expression of shapes but the text is empty", 0);
    join();
    if (tokens_.peek().kind != Token::Kind::end) refuse_rest();
    return std::move(nodes_);
  }

 private:
  void join() {
    exclusive();
    while (tokens_.peek().is("|")) {
      const Token token = tokens_.take();
      exclusive();
      append(Node::Kind::join, token);
    }
  }

  void exclusive() {
    intersection();
    while (tokens_.peek().is("^")) {
      const Token token = tokens_.take();
      intersection();
      append(Node::Kind::exclusive, token);
    }
  }

  void intersection() {
    complement();
    while (tokens_.peek().is("&") || tokens_.peek().is("-")) {
      const Token token = tokens_.take();
      complement();
      append(token.is("&") ? Node::Kind::intersection : Node::Kind::difference, token);
    }
  }

  void complement() {
    if (++depth_ > deepest_nesting)
      throw InputError(
          "the expression is nested more than " + std::to_string(deepest_nesting) + " levels deep",
          tokens_.peek().offset);
    if (tokens_.peek().is("!")) {
      const Token token = tokens_.take();
      complement();
      append(Node::Kind::complement, token);
    } else {
      primary();
    }
    --depth_;
  }

  void primary() {
    if (tokens_.peek().kind == Token::Kind::name) return append(Node::Kind::name, tokens_.take());
    const Token found = tokens_.peek();
    if (!found.is("("))
      throw InputError("expected a shape, '!' or '(' but found " + found.quoted(), found.offset,
                       found.length);
    tokens_.take();
    join();
    if (!tokens_.take_if(")")) {
      const Token& other = tokens_.peek();
      throw InputError("expected ')' but found " + other.quoted(), other.offset, other.length);
    }
  }

  [[noreturn]] void refuse_rest() const {
    const Token& found = tokens_.peek();
    std::string advice;
    if (found.is("&&")) advice = " (intersections are written with '&')";
    if (found.is("||")) advice = " (unions are written with '|')";
    if (found.is("+")) advice = " (unions are written with '|')";
    if (found.is("*")) advice = " (intersections are written with '&')";
    throw InputError("expected '&', '|', '-', '^' or the end but found " + found.quoted() + advice,
                     found.offset, found.length);
  }

  void append(Node::Kind kind, const Token& token) {
    nodes_.push_back({kind, token.offset, token.length});
  }

  Tokenizer tokens_;
  std::vector<Node> nodes_;
  int depth_ = 0;
};

BooleanText::BooleanText(std::string text)
    : text_(std::move(text)), nodes_(BooleanTextParser(text_).parse()) {}

std::vector<BooleanText::Name> BooleanText::names() const {
  std::vector<Name> names;
  for (const Node& node : nodes_)
    if (node.kind == Node::Kind::name)
      names.push_back({text_.substr(node.offset, node.length), node.offset});
  return names;
}

template <class Value, class Named>
Value BooleanText::folded(const Named& named) const {
  std::vector<Value> stack;
  const auto take = [&stack] {
    Value value = std::move(stack.back());
    stack.pop_back();
    return value;
  };
  for (const Node& node : nodes_) {
    if (node.kind == Node::Kind::name) {
      stack.push_back(named(Name{text_.substr(node.offset, node.length), node.offset}));
      continue;
    }
    const Value last = take();
    // An exclusive or holds both arguments twice: a chain of them grows like a power of two.
    const bool is_exclusive = node.kind == Node::Kind::exclusive;
    const std::size_t others = node.kind == Node::Kind::complement ? 0 : size_of(stack.back());
    if ((size_of(last) + others) * (is_exclusive ? 2 : 1) > largest_expression)
      throw InputError("the expression of shapes is too large", node.offset, node.length);
    switch (node.kind) {
      case Node::Kind::complement:
        stack.push_back(!last);
        break;
      case Node::Kind::intersection:
        stack.push_back(take() & last);
        break;
      case Node::Kind::difference:
        stack.push_back(take() & !last);
        break;
      case Node::Kind::exclusive:
        stack.push_back(take() ^ last);
        break;
      default:
        stack.push_back(take() | last);
    }
  }
  return take();
}

Region BooleanText::region(const std::function<Region(const Name&)>& shape) const {
  return folded<Region>(shape);
}

BooleanExpression BooleanText::expression(
    const std::function<BooleanExpression(const Name&)>& variable) const {
  return folded<BooleanExpression>(variable);
}

BooleanExpression BooleanText::expression(const std::vector<std::string>& variables) const {
  return expression([&](const Name& name) {
    const auto known = std::ranges::find(variables, name.name);
    if (known == variables.end())
      throw InputError("unknown name '" + name.name + "'" + did_you_mean(name.name, variables),
                       name.offset, name.name.size());
    return BooleanExpression::variable(static_cast<int>(known - variables.begin()));
  });
}

}  // namespace rfm
