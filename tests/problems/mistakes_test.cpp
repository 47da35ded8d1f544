#include "problems/mistakes.hpp"

#include <gtest/gtest.h>

#include "problems/document.hpp"

using namespace rfm;

namespace {
std::shared_ptr<const SourceText> source(const std::string& text) {
  return make_source("plate.yaml", text);
}
Mistake mistake_at(const Place& place) {
  Mistake mistake;
  mistake.message = "wrong";
  mistake.place = place;
  return mistake;
}
}  // namespace

TEST(Mistake, ShowsTheLineWithACaret) {
  const auto text = source("title: x\nhole: {raduis: 1}\n");
  Mistake mistake = mistake_at({text, 2, 8, 6});
  mistake.others.push_back({"as here", {text, 1, 1, 5}});
  EXPECT_EQ(mistake.text(),
            "plate.yaml:2:8: wrong\n"
            "    2 | hole: {raduis: 1}\n"
            "      |        ^~~~~~\n"
            "  plate.yaml:1:1: as here\n"
            "    1 | title: x\n"
            "      | ^~~~~\n");
}
TEST(Mistake, AtTheEndOfALineIsShownBehindIt) {
  const auto text = source("a: [1");
  EXPECT_EQ((Place{text, 1, 6, 1}).excerpt(), "    1 | a: [1\n      |      ^\n");
  EXPECT_EQ((Place{text, 1, 6, 1}).text(), "plate.yaml:1:6");
}
TEST(Mistake, UnderlinesNoMoreThanTheLine) {
  EXPECT_EQ((Place{source("abc"), 1, 2, 10}).excerpt(), "    1 | abc\n      |  ^~\n");
}
TEST(Mistake, CountsCharactersAndHidesControls) {
  const auto text = source("\u00e9\u00e9: \x1b[0m\tb\n");
  EXPECT_EQ((Place{text, 1, 5, 1}).text(), "plate.yaml:1:3");
  EXPECT_EQ((Place{text, 1, 5, 1}).excerpt(), "    1 | \u00e9\u00e9: ?[0m b\n      |   ^\n");
}
TEST(Mistake, OfALongLineShowsThePartAboutTheCaret) {
  const auto text = source(std::string(500, 'a') + "X" + std::string(500, 'b'));
  const std::string excerpt = (Place{text, 1, 501, 1}).excerpt();
  const std::size_t line_end = excerpt.find('\n');
  EXPECT_LE(line_end, 120u);
  EXPECT_EQ(excerpt.find('X'), excerpt.find('^') - line_end - 1);
}
TEST(Mistake, OfTheCommandLineHasNoLine) {
  const auto text = make_source("--set a=b", "b", false);
  EXPECT_EQ(mistake_at({text}).text(), "--set a=b: wrong\n");
}

TEST(MistakeList, IsInTheOrderOfTheTextAndWithoutRepetition) {
  const auto text = source("a\nb\nc\n");
  const auto set = make_source("--set a=b", "b", false);
  MistakeList list;
  list.add("set", {set});
  list.add("third", {text, 3, 1});
  list.add("first", {text, 1, 1});
  list.add("first", {text, 1, 1});
  std::vector<std::string> order;
  for (const Mistake& mistake : list.sorted()) order.push_back(mistake.message);
  EXPECT_EQ(order, (std::vector<std::string>{"first", "third", "set"}));
}
TEST(MistakeList, ThrowsWhenItIsNotEmpty) {
  MistakeList list;
  EXPECT_NO_THROW(list.throw_if_any());
  list.add("wrong", {source("a")});
  EXPECT_THROW(list.throw_if_any(), ProblemFileErrors);
}
TEST(ProblemFileErrors, TellsAtMostAHundredMistakesInFull) {
  const auto text = source("a");
  std::vector<Mistake> mistakes(250, mistake_at({text}));
  const std::string what = ProblemFileErrors(mistakes).what();
  EXPECT_NE(what.find("and 150 more mistakes"), std::string::npos);
}
