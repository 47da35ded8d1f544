#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rfm {

/// A word of an expression. Tokens view the text they were cut from.
struct Token {
  enum class Kind {
    number,  ///< `1`, `.5`, `2.`, `1e-3`: value in `number`
    name,  ///< a letter, then letters, digits, `_`; names joined by dots are one name: `plate.left`
    text,  ///< in double or single quotes; `text` without them
    symbol,  ///< an operator, a bracket or a comma
    end,
  };
  Kind kind = Kind::end;
  std::string_view text;
  std::size_t offset = 0;
  std::size_t length = 0;
  double number = 0;

  bool is(std::string_view symbol) const { return kind == Kind::symbol && text == symbol; }
  /// As a message names it: "'sin'", or "the end".
  std::string quoted() const;
};

/// Cuts a text into tokens, one ahead of its reader. Shared by formulas (expression.hpp) and
/// Boolean expressions of shapes (boolean_text.hpp). Throws `InputError` at a character that no
/// token begins with, a number out of range, or a quotation that does not end.
class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : text_(text) { advance(); }

  const Token& peek() const { return next_; }
  Token take();
  /// Takes the next token if it is this symbol.
  bool take_if(std::string_view symbol);
  std::string_view text() const { return text_; }

 private:
  void advance();
  void cut(Token::Kind kind, std::size_t length);
  void cut_number();
  void cut_quotation();
  bool begins_number() const;
  [[noreturn]] void refuse_character() const;

  std::string_view text_;
  std::size_t position_ = 0;
  Token next_;
};

/// Whether `text` is a name: a letter, then letters, digits and `_`.
bool is_name(std::string_view text);

}  // namespace rfm
