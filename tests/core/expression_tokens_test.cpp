#include "core/expression_tokens.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"

namespace rfm {
namespace {

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> found;
  Tokenizer tokens(text);
  while (tokens.peek().kind != Token::Kind::end) {
    const Token token = tokens.take();
    // A token is what stands at its place.
    if (token.kind != Token::Kind::text) {
      EXPECT_EQ(token.text, std::string_view(text).substr(token.offset, token.length));
    }
    found.emplace_back(token.text);
  }
  EXPECT_EQ(tokens.peek().offset, text.size());
  return found;
}

std::string mistake(const std::string& text) {
  try {
    words(text);
  } catch (const InputError& error) {
    return std::to_string(error.offset) + "+" + std::to_string(error.length) + ": " + error.what();
  }
  return "none";
}

TEST(Tokenizer, TakesTheLongestSymbol) {
  using testing::ElementsAre;
  EXPECT_THAT(words("a<=b<c"), ElementsAre("a", "<=", "b", "<", "c"));
  EXPECT_THAT(words("2**-x!=!y"), ElementsAre("2", "**", "-", "x", "!=", "!", "y"));
  EXPECT_THAT(words("1e-3-2.e2"), ElementsAre("1e-3", "-", "2.e2"));
}

TEST(Tokenizer, JoinsNamesByDotsThatLettersFollow) {
  using testing::ElementsAre;
  EXPECT_THAT(words("plate.left.dx(x1_2)"), ElementsAre("plate.left.dx", "(", "x1_2", ")"));
  EXPECT_THAT(words("a .5"), ElementsAre("a", ".5"));
  EXPECT_THAT(words("a.5"), ElementsAre("a", ".5"));
}

TEST(Tokenizer, KeepsQuotedTextsWhole) {
  Tokenizer tokens("f('a + \"b', \"c\")");
  tokens.take(), tokens.take();
  const Token text = tokens.take();
  EXPECT_EQ(text.kind, Token::Kind::text);
  EXPECT_EQ(text.text, "a + \"b");
  EXPECT_EQ(text.offset, 2u);
  EXPECT_EQ(text.length, 8u);
}

TEST(Tokenizer, ReadsNumbersToTheLastBit) {
  for (const char* text :
       {"0.1", "1e308", "1.7976931348623157e308", "08", ".5E+1", "0e-999", "0e999",
        "2.2250738585072011e-308", "1e-310", "4.9406564584124654e-324", "3e-324"}) {
    Tokenizer tokens{std::string_view(text)};
    EXPECT_EQ(tokens.peek().number, std::strtod(text, nullptr)) << text;
  }
}

TEST(Tokenizer, RefusesWhatNoTokenBeginsWith) {
  EXPECT_EQ(mistake("x @ 1"), "2+1: unexpected character '@'");
  EXPECT_EQ(mistake("3 \u00D7 x"),
            "2+2: unexpected character '\u00D7' (a multiplication sign: write '*')");
  EXPECT_EQ(mistake("a + 1e999"), "4+5: the number 1e999 is too large: numbers go up to 1.797e308");
  EXPECT_EQ(mistake("a + 1e-999*b"),
            "4+6: the number 1e-999 is too small: write 0, or a number from 4.941e-324 on");
  EXPECT_EQ(mistake("f(\"a"), "2+1: the quotation that begins here does not end");
}

TEST(Names, AreALetterThenLettersDigitsAndUnderscores) {
  for (const char* name : {"a", "A1", "x_1", "omega"}) EXPECT_TRUE(is_name(name)) << name;
  for (const char* name : {"", "1a", "_a", "a.b", "a b", "\u03B1"})
    EXPECT_FALSE(is_name(name)) << name;
}

}  // namespace
}  // namespace rfm
