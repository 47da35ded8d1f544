#include "core/expression.hpp"

#include "core/error.hpp"
#include "core/expression_tokens.hpp"

namespace rfm {
namespace {

using Node = Expression::Node;

constexpr int deepest_nesting = 250;

/// Precedence climbing. Each function parses one level of the grammar and appends its nodes; the
/// root of what it parsed is then the last node.
class Parser {
 public:
  explicit Parser(std::string_view text) : tokens_(text) {}

  std::vector<Node> parse() {
    if (tokens_.peek().kind == Token::Kind::end)
      throw InputError("expected an expression but the text is empty", 0);
    comparison();
    const Token& rest = tokens_.peek();
    if (rest.kind != Token::Kind::end) refuse_rest(rest);
    return std::move(nodes_);
  }

 private:
  /// Where a level begins, in nodes and in the text.
  struct Start {
    std::size_t node;
    std::size_t offset;
  };
  Start start() const { return {nodes_.size(), tokens_.peek().offset}; }

  struct Deeper {
    explicit Deeper(Parser& parser) : parser(parser) {
      if (++parser.depth_ > deepest_nesting)
        throw InputError("the expression is nested more than " + std::to_string(deepest_nesting) +
                             " levels deep",
                         parser.tokens_.peek().offset);
    }
    ~Deeper() { --parser.depth_; }
    Parser& parser;
  };

  Token take() {
    Token token = tokens_.take();
    end_ = token.offset + token.length;
    return token;
  }

  void append(Node::Kind kind, const Start& start, const Token& token, int arguments = 0,
              Operation operation = Operation::constant) {
    nodes_.push_back({kind, operation, static_cast<std::uint32_t>(start.node),
                      static_cast<std::uint32_t>(arguments), token.number, token.offset,
                      token.length, start.offset, end_});
  }
  void append(Operation operation, const Start& start, const Token& token, int arguments = 2) {
    append(Node::Kind::operation, start, token, arguments, operation);
  }

  static bool is_comparison(const Token& token) {
    for (const std::string_view symbol : {"<", "<=", ">", ">=", "==", "!="})
      if (token.is(symbol)) return true;
    return false;
  }

  void comparison() {
    const Start begin = start();
    sum();
    if (!is_comparison(tokens_.peek())) return;
    const Token token = take();
    sum();
    if (token.is("!="))
      append(Node::Kind::not_equal, begin, token, 2);
    else
      append(token.is("==")                   ? Operation::equal
             : token.is("<") || token.is(">") ? Operation::less
                                              : Operation::less_equal,
             begin, token);
    if (is_comparison(tokens_.peek()))
      throw InputError("comparisons cannot be chained; multiply them: (a < b) * (b < c)",
                       tokens_.peek().offset, tokens_.peek().length);
  }

  void sum() {
    const Start begin = start();
    product();
    while (tokens_.peek().is("+") || tokens_.peek().is("-")) {
      const Token token = take();
      product();
      append(token.is("+") ? Operation::add : Operation::subtract, begin, token);
    }
  }

  void product() {
    const Start begin = start();
    negation();
    while (tokens_.peek().is("*") || tokens_.peek().is("/")) {
      const Token token = take();
      negation();
      append(token.is("*") ? Operation::multiply : Operation::divide, begin, token);
    }
  }

  void negation() {
    const Deeper deeper(*this);
    const Start begin = start();
    if (tokens_.peek().is("-")) {
      const Token token = take();
      negation();
      append(Operation::negate, begin, token, 1);
    } else if (tokens_.peek().is("+")) {
      take();
      negation();
    } else {
      power();
    }
  }

  void power() {
    const Start begin = start();
    element();
    if (!tokens_.peek().is("^")) return;
    const Token token = take();
    negation();  // the exponent: a sign, then a power again, so ^ is right associative
    append(Operation::power, begin, token);
  }

  void element() {
    const Start begin = start();
    primary();
    while (tokens_.peek().is("[")) {
      const Token token = take();
      comparison();
      expect("]");
      append(Node::Kind::index, begin, token, 2);
    }
  }

  void primary() {
    const Start begin = start();
    const Token& next = tokens_.peek();
    switch (next.kind) {
      case Token::Kind::number:
        return append(Node::Kind::number, begin, take());
      case Token::Kind::text:
        return append(Node::Kind::text, begin, take());
      case Token::Kind::name: {
        const Token name = take();
        if (tokens_.peek().is("(")) return call(begin, name);
        return append(Node::Kind::name, begin, name);
      }
      default:
        break;
    }
    if (!next.is("("))
      throw InputError("expected a number, a name or '(' but found " + next.quoted(), next.offset,
                       next.length);
    take();
    comparison();
    expect(")", "an operator or ");
    nodes_.back().begin = begin.offset;
    nodes_.back().end = end_;
  }

  void call(const Start& begin, const Token& name) {
    take();
    int arguments = 0;
    if (!tokens_.peek().is(")")) {
      do {
        comparison();
        ++arguments;
      } while (take_if(","));
    }
    expect(")", "an operator, ", "',' or ");
    append(Node::Kind::call, begin, name, arguments);
  }

  bool take_if(std::string_view symbol) {
    if (!tokens_.peek().is(symbol)) return false;
    take();
    return true;
  }

  // `others` says what else could follow: an operator, if the text goes on, and a symbol.
  void expect(std::string_view symbol, std::string_view operators = {},
              std::string_view others = {}) {
    if (take_if(symbol)) return;
    const Token& found = tokens_.peek();
    std::string expected = "expected ";
    if (found.kind != Token::Kind::end) expected += operators;
    expected += std::string(others) + "'" + std::string(symbol) + "' but found " + found.quoted();
    throw InputError(expected, found.offset, found.length);
  }

  [[noreturn]] static void refuse_rest(const Token& token) {
    std::string advice;
    if (token.is("**")) advice = " (powers are written with '^')";
    if (token.is("&&") || token.is("&")) advice = " (multiply conditions: (a < b) * (b < c))";
    if (token.is("||") || token.is("|")) advice = " (take the larger: max(a < b, c < d))";
    throw InputError("expected an operator or the end but found " + token.quoted() + advice,
                     token.offset, token.length);
  }

  Tokenizer tokens_;
  std::vector<Node> nodes_;
  std::size_t end_ = 0;
  int depth_ = 0;
};

}  // namespace

Expression::Expression(std::string text) : text_(std::move(text)), nodes_(Parser(text_).parse()) {}

// Each root lies just before the subtree of the next.
std::vector<std::size_t> Expression::arguments_of(std::size_t i) const {
  std::vector<std::size_t> roots(nodes_[i].argument_count);
  std::size_t root = i;
  for (std::size_t k = roots.size(); k-- > 0;) {
    root = k + 1 == roots.size() ? i - 1 : nodes_[root].first - 1;
    roots[k] = root;
  }
  return roots;
}

std::vector<Expression::Use> Expression::uses() const {
  std::vector<Use> uses;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    if (node.kind != Node::Kind::name && node.kind != Node::Kind::call) continue;
    Use use{std::string(text_of(node)), node.offset, node.kind == Node::Kind::call, {}};
    for (const std::size_t root : arguments_of(i)) {
      const Node& argument = nodes_[root];
      use.arguments.push_back(text_.substr(argument.begin, argument.end - argument.begin));
    }
    uses.push_back(std::move(use));
  }
  return uses;
}

bool Expression::uses(std::string_view name) const {
  for (const Node& node : nodes_)
    if ((node.kind == Node::Kind::name || node.kind == Node::Kind::call) && text_of(node) == name)
      return true;
  return false;
}

}  // namespace rfm
