#include "core/boolean_text.hpp"

#include <gmock/gmock.h>

#include <map>

#include "core/error.hpp"
#include "core/primitives.hpp"

using namespace rfm;

namespace {

/// Shapes a, b, c, d, each a half-plane of its own, so that their signs are independent variables.
Region shape(const BooleanText::Name& name) {
  static const std::map<std::string, Region> shapes = [] {
    std::map<std::string, Region> all;
    for (const char* letter : {"a", "b", "c", "d"})
      all.emplace(letter, level_set(x_coordinate()).named(letter));
    return all;
  }();
  const auto found = shapes.find(name.name);
  if (found == shapes.end())
    throw InputError("unknown shape '" + name.name + "'", name.offset, name.name.size());
  return found->second;
}

/// The value of the text for every assignment of a, b, c, d, as 16 characters 0 and 1.
std::string truth_table(const std::string& text) {
  const Region region = BooleanText(text).region(shape);
  std::string table;
  for (int bits = 0; bits < 16; ++bits) {
    std::unique_ptr<bool[]> signs(new bool[region.primitives().size()]);
    for (std::size_t k = 0; k < region.primitives().size(); ++k)
      signs[k] = ((bits >> (region.primitives()[k]->name[0] - 'a')) & 1) != 0;
    const std::span<const bool> values(signs.get(), region.primitives().size());
    table += region.expression().evaluate(values) ? '1' : '0';
  }
  return table;
}

std::string truth_table(bool (*formula)(bool, bool, bool, bool)) {
  std::string table;
  for (int bits = 0; bits < 16; ++bits)
    table += formula(bits & 1, bits & 2, bits & 4, bits & 8) ? '1' : '0';
  return table;
}

std::string mistake(const std::string& text) {
  try {
    BooleanText(text).region(shape);
  } catch (const InputError& error) {
    return std::to_string(error.offset) + "+" + std::to_string(error.length) + ": " + error.what();
  }
  return "none";
}

}  // namespace

TEST(BooleanText, ComplementBindsTightest) {
  EXPECT_EQ(truth_table("!a & b"), truth_table([](bool a, bool b, bool, bool) { return !a && b; }));
  EXPECT_EQ(truth_table("!!a"), truth_table([](bool a, bool, bool, bool) { return a; }));
  EXPECT_EQ(truth_table("!(a | b)"),
            truth_table([](bool a, bool b, bool, bool) { return !(a || b); }));
}
TEST(BooleanText, IntersectionAndDifferenceGoLeftToRight) {
  EXPECT_EQ(truth_table("a - b & c"),
            truth_table([](bool a, bool b, bool c, bool) { return (a && !b) && c; }));
  EXPECT_EQ(truth_table("a & b - c"),
            truth_table([](bool a, bool b, bool c, bool) { return (a && b) && !c; }));
  EXPECT_EQ(truth_table("a - b - c"),
            truth_table([](bool a, bool b, bool c, bool) { return (a && !b) && !c; }));
  EXPECT_EQ(truth_table("a - (b - c)"),
            truth_table([](bool a, bool b, bool c, bool) { return a && !(b && !c); }));
}
TEST(BooleanText, ExclusiveOrBindsLooserThanIntersectionAndTighterThanUnion) {
  EXPECT_EQ(truth_table("a & b ^ c - d"),
            truth_table([](bool a, bool b, bool c, bool d) { return (a && b) != (c && !d); }));
  EXPECT_EQ(truth_table("a | b ^ c"),
            truth_table([](bool a, bool b, bool c, bool) { return a || (b != c); }));
  EXPECT_EQ(truth_table("a ^ b | c & d"),
            truth_table([](bool a, bool b, bool c, bool d) { return (a != b) || (c && d); }));
}
TEST(BooleanText, ParenthesesGroup) {
  EXPECT_EQ(truth_table("(a | b) & (c | d)"),
            truth_table([](bool a, bool b, bool c, bool d) { return (a || b) && (c || d); }));
}
TEST(BooleanText, ListsTheShapesItNames) {
  const std::vector<BooleanText::Name> names = BooleanText("(plate & roof) - hole").names();
  ASSERT_EQ(names.size(), 3u);
  EXPECT_EQ(names[0].name, "plate");
  EXPECT_EQ(names[1].offset, 9u);
  EXPECT_EQ(names[2].name, "hole");
}

TEST(BooleanText, ReportsMistakesWithTheirPlace) {
  EXPECT_EQ(mistake(""), "0+1: expected an expression of shapes but the text is empty");
  EXPECT_EQ(mistake("a &"), "3+1: expected a shape, '!' or '(' but found the end");
  EXPECT_EQ(mistake("a & & b"), "4+1: expected a shape, '!' or '(' but found '&'");
  EXPECT_EQ(mistake("(a | b"), "6+1: expected ')' but found the end");
  EXPECT_EQ(mistake("a b"), "2+1: expected '&', '|', '-', '^' or the end but found 'b'");
  EXPECT_EQ(mistake("a && b"),
            "2+2: expected '&', '|', '-', '^' or the end but found '&&' "
            "(intersections are written with '&')");
  EXPECT_EQ(mistake("a + b"),
            "2+1: expected '&', '|', '-', '^' or the end but found '+' (unions "
            "are written with '|')");
  EXPECT_EQ(mistake("a - hole"), "4+4: unknown shape 'hole'");
  EXPECT_EQ(mistake("a - 2"), "4+1: expected a shape, '!' or '(' but found '2'");
  EXPECT_EQ(mistake("a # b"), "2+1: unexpected character '#'");
}
TEST(BooleanText, HostileNestingIsAMistakeAndNotACrash) {
  EXPECT_THAT(mistake(std::string(100'000, '(')), testing::HasSubstr("nested more than 250"));
  EXPECT_THAT(mistake(std::string(100'000, '!') + "a"), testing::HasSubstr("nested more than 250"));
}
TEST(BooleanText, AChainOfExclusiveOrsIsLimited) {
  std::string chain = "a";
  for (int i = 0; i < 10; ++i) chain += " ^ b";
  EXPECT_EQ(truth_table(chain), truth_table("a"));  // b an even number of times
  for (int i = 0; i < 90; ++i) chain += " ^ b";
  EXPECT_THAT(mistake(chain), testing::HasSubstr("the expression of shapes is too large"));
}
