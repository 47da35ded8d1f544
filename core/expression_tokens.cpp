#include "core/expression_tokens.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

// Not the functions of <cctype>: names are the same in every locale.
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool continues_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

// Longer symbols first: `<=` is not `<` and `=`.
constexpr std::array<std::string_view, 21> symbols = {"<=", ">=", "==", "!=", "**", "&&", "||",
                                                      "<",  ">",  "+",  "-",  "*",  "/",  "^",
                                                      "(",  ")",  "[",  "]",  ",",  "&",  "|"};

// Characters that look like an operator but are another one.
struct Lookalike {
  std::string_view character;
  std::string_view advice;
};
constexpr std::array<Lookalike, 8> lookalikes = {{
    {"\u2212", "a minus sign that is not '-'"},
    {"\u2013", "a dash, not '-'"},
    {"\u00D7", "a multiplication sign: write '*'"},
    {"\u00B7", "a multiplication sign: write '*'"},
    {"\u00B2", "a superscript: write '^2'"},
    {"\u00B3", "a superscript: write '^3'"},
    {"\u03C0", "a Greek letter: write 'pi'"},
    {"=", "write '==' to compare"},
}};

// Bytes of the UTF-8 character that begins with `lead`.
std::size_t character_length(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  return byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

}  // namespace

bool is_name(std::string_view text) {
  if (text.empty() || !is_letter(text[0])) return false;
  for (const char c : text)
    if (!continues_name(c)) return false;
  return true;
}

std::string Token::quoted() const {
  return kind == Kind::end ? "the end" : "'" + std::string(text) + "'";
}

Token Tokenizer::take() {
  const Token token = next_;
  advance();
  return token;
}

bool Tokenizer::take_if(std::string_view symbol) {
  if (!next_.is(symbol)) return false;
  advance();
  return true;
}

void Tokenizer::cut(Token::Kind kind, std::size_t length) {
  next_ = {kind, text_.substr(position_, length), position_, length, 0};
  position_ += length;
}

bool Tokenizer::begins_number() const {
  const char c = text_[position_];
  const bool digit_follows = position_ + 1 < text_.size() && is_digit(text_[position_ + 1]);
  return is_digit(c) || (c == '.' && digit_follows);
}

void Tokenizer::cut_number() {
  double value = 0;
  const char* begin = text_.data() + position_;
  // Only digits, a point and an exponent can follow: from_chars knows neither signs nor hexadecimal
  // here, and "inf" does not begin with a digit.
  const auto [end, status] = std::from_chars(begin, text_.data() + text_.size(), value);
  const auto length = static_cast<std::size_t>(end - begin);
  if (status == std::errc::result_out_of_range) {
    const std::string number(begin, length);
    const bool is_large = std::strtod(number.c_str(), nullptr) > 1;
    throw InputError("the number " + number +
                         (is_large ? " is too large: numbers go up to 1.797e308"
                                   : " is too small: write 0, or a number from 4.941e-324 on"),
                     position_, length);
  }
  cut(Token::Kind::number, length);
  next_.number = value;
}

void Tokenizer::cut_quotation() {
  const std::size_t end = text_.find(text_[position_], position_ + 1);
  if (end == std::string_view::npos)
    throw InputError("the quotation that begins here does not end", position_);
  const std::size_t begin = position_;
  cut(Token::Kind::text, end + 1 - begin);
  next_.text = text_.substr(begin + 1, end - begin - 1);
}

void Tokenizer::refuse_character() const {
  const std::size_t length = std::min(character_length(text_[position_]), text_.size() - position_);
  const std::string character(text_.substr(position_, length));
  std::string message = "unexpected character '" + character + "'";
  for (const Lookalike& lookalike : lookalikes)
    if (lookalike.character == character) message += " (" + std::string(lookalike.advice) + ")";
  throw InputError(message, position_, length);
}

void Tokenizer::advance() {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
  if (position_ == text_.size()) {
    next_ = {Token::Kind::end, {}, position_, 1, 0};
    return;
  }
  const char c = text_[position_];
  if (is_letter(c)) {
    std::size_t end = position_;
    do {
      ++end;
      while (end < text_.size() && continues_name(text_[end])) ++end;
    } while (end + 1 < text_.size() && text_[end] == '.' && is_letter(text_[end + 1]));
    return cut(Token::Kind::name, end - position_);
  }
  if (begins_number()) return cut_number();
  if (c == '"' || c == '\'') return cut_quotation();
  for (const std::string_view symbol : symbols)
    if (text_.substr(position_).starts_with(symbol)) return cut(Token::Kind::symbol, symbol.size());
  if (c == '!') return cut(Token::Kind::symbol, 1);
  refuse_character();
}

}  // namespace rfm
