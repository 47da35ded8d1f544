#include "problems/overrides.hpp"

#include <gmock/gmock.h>

#include "problems/resolved_document.hpp"

using namespace rfm;

namespace {

DocumentNode sample() {
  return parse_document(make_source(
      "f.yaml", "title: old\nparameters:\nconditions: [{at: a, value: 1}, {at: b, value: 2}]\n"));
}

/// The document after the overrides, and their mistakes as text.
std::pair<DocumentNode, std::string> applied(const std::vector<std::string>& overrides) {
  DocumentNode root = sample();
  MistakeList mistakes;
  apply_overrides(root, overrides, mistakes);
  std::string text;
  for (const Mistake& mistake : mistakes.sorted()) text += mistake.text();
  return {std::move(root), text};
}

}  // namespace

TEST(Overrides, ReplaceValues) {
  const auto [root, mistakes] = applied({"title=new", "conditions.1.value=3"});
  EXPECT_EQ(mistakes, "");
  EXPECT_EQ(root.find("title")->text, "new");
  EXPECT_EQ(root.find("conditions")->items[1].find("value")->text, "3");
  EXPECT_EQ(root.find("conditions")->items[0].find("value")->text, "1");
}
TEST(Overrides, MakeKeysThatTheFileLeavesOut) {
  const auto [root, mistakes] = applied({"discretization.basis.cells=32", "parameters.r=0.5"});
  EXPECT_EQ(mistakes, "");
  EXPECT_EQ(root.find("discretization")->find("basis")->find("cells")->text, "32");
  EXPECT_EQ(root.find("parameters")->find("r")->text, "0.5");
}
TEST(Overrides, TakeYamlValuesWithEqualsSigns) {
  const auto [root, mistakes] = applied({"a={b: [1, 2]}", "c=x == y", "d='text'"});
  EXPECT_EQ(mistakes, "");
  EXPECT_EQ(root.find("a")->find("b")->items[1].text, "2");
  EXPECT_EQ(root.find("c")->text, "x == y");
  EXPECT_EQ(root.find("d")->text, "text");
}
TEST(Overrides, TheLastOfSeveralHolds) {
  EXPECT_EQ(applied({"title=one", "title=two"}).first.find("title")->text, "two");
}
TEST(Overrides, PlaceWhatTheySetAtTheCommandLine) {
  const auto [root, mistakes] = applied({"conditions.0.value=1 + "});
  EXPECT_EQ(root.find("conditions")->items[0].find("value")->place.text(),
            "--set conditions.0.value=1 + ");
}
TEST(Overrides, ReportWhatCannotBeSet) {
  EXPECT_EQ(applied({"title"}).second, "--set title: expected path=value\n");
  EXPECT_EQ(applied({"title="}).second, "--set title=: expected path=value\n");
  EXPECT_EQ(applied({"=1"}).second, "--set =1: expected path=value\n");
  EXPECT_EQ(applied({"a..b=1"}).second,
            "--set a..b=1: a path is made of names and numbers, joined by dots\n");
  EXPECT_EQ(applied({"title.x=1"}).second,
            "--set title.x=1: 'title' is a single value and has no 'x'\n");
  EXPECT_EQ(applied({"conditions.2.value=1"}).second,
            "--set conditions.2.value=1: 'conditions' is a list of 2 items: expected a number from "
            "0 to 1 but found '2'\n");
  EXPECT_EQ(
      applied({"conditions.x=1"}).second,
      "--set conditions.x=1: 'conditions' is a list of 2 items: expected a number from 0 to 1 "
      "but found 'x'\n");
  EXPECT_THAT(applied({"title=[1"}).second, testing::StartsWith("--set title=[1: a '[' is not"));
}
