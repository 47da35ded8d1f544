#include "problems/scalar_places.hpp"

#include <gmock/gmock.h>

#include <random>

namespace rfm {
namespace {

using testing::ElementsAre;

/// The value of `a:` and, for each byte of it, what stands in the source at its place.
struct Read {
  std::string text;
  std::string at;
  std::vector<std::size_t> places;
};

Read read(const std::string& value) {
  const auto source = make_source("f.yaml", "a: " + value + "\n");
  const DocumentNode root = parse_document(source);
  const auto places = byte_places(*root.find("a"));
  Read result{root.find("a")->text, {}, {}};
  if (!places) return result;
  result.places = *places;
  for (std::size_t i = 0; i < result.text.size(); ++i) result.at += source->text[(*places)[i]];
  return result;
}

TEST(ScalarPlaces, OfJoinedLinesAreThoseOfTheirBytes) {
  const Read plain = read("1 +\n  x\n\n  * y");
  EXPECT_EQ(plain.text, "1 + x\n* y");
  EXPECT_THAT(plain.places, ElementsAre(3, 4, 5, 6, 9, 10, 14, 15, 16, 17));
}

TEST(ScalarPlaces, OfEscapesAreWhereTheyBegin) {
  const Read escaped = read(R"("x\t\u03C0\x41 y")");
  EXPECT_EQ(escaped.text, "x\t\u03C0A y");
  EXPECT_THAT(escaped.places, ElementsAre(4, 5, 7, 7, 13, 17, 18, 19));
  const Read single = read("'f(''a'')'");
  EXPECT_EQ(single.text, "f('a')");
  EXPECT_THAT(single.places, ElementsAre(4, 5, 6, 8, 9, 11, 12));
}

TEST(ScalarPlaces, OfBlocksDoNotCountTheIndentation) {
  EXPECT_THAT(read("|\n    x\n      y").places, ElementsAre(9, 10, 11, 12, 17, 18, 18));
  EXPECT_THAT(read(">-\n  x\n  y").places, ElementsAre(8, 9, 12, 13));
}

// Formulas of random words, written in every style, in lines broken at random.
TEST(ScalarPlaces, FollowEveryByteThatIsNoSpaceInEveryStyle) {
  std::mt19937 generator(5);
  const std::vector<std::string> words{"x",   "+",      "sin(y)", "2.5e-3", "*",
                                       "'q'", "\u03B1", "(",      ")"};
  int compared = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<std::string> formula{"x"};  // a plain text may not begin with every sign
    for (std::size_t i = 1 + generator() % 8; i > 0; --i)
      formula.push_back(words[generator() % words.size()]);
    for (const std::string style : {"", "'", "\"", "|", ">", "|-", ">+"}) {
      const bool is_block = style.starts_with('|') || style.starts_with('>');
      std::string value = is_block ? style + "\n   " : style, stripped;
      for (std::size_t i = 0; i < formula.size(); ++i) {
        std::string word = formula[i];
        stripped += word;
        if (style == "'" && word == "'q'") word = "''q''";
        if (style == "\"" && word == "x" && generator() % 2) word = "\\x78";
        const bool breaks = generator() % 3 == 0;
        if (i > 0) value += breaks ? (generator() % 2 ? "\n   " : "  \n\n   ") : " ";
        value += word;
      }
      if (!is_block) value += style;
      const Read result = read(value);
      ASSERT_EQ(result.places.size(), result.text.size() + 1) << value;
      std::string found;
      for (std::size_t i = 0; i < result.text.size(); ++i) {
        if (result.text[i] == ' ' || result.text[i] == '\n') continue;
        found += result.text[i];
        ++compared;
        // An escape begins with its backslash.
        EXPECT_TRUE(result.at[i] == result.text[i] || result.at[i] == '\\') << value;
        if (i > 0) {
          EXPECT_GT(result.places[i], result.places[i - 1]) << value;
        }
      }
      EXPECT_EQ(found, stripped);
    }
  }
  EXPECT_GT(compared, 100'000);
}

}  // namespace
}  // namespace rfm
