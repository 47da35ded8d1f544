#include "problems/document.hpp"

#include <gmock/gmock.h>

using namespace rfm;

namespace {

DocumentNode parse(const std::string& text) { return parse_document(make_source("f.yaml", text)); }

/// The first line of the mistake in a text that is not a document.
std::string mistake(const std::string& text) {
  try {
    parse(text);
  } catch (const ProblemFileErrors& errors) {
    EXPECT_EQ(errors.mistakes.size(), 1u);
    const std::string whole = errors.mistakes[0].text();
    return whole.substr(0, whole.find('\n'));
  }
  return "none";
}

}  // namespace

TEST(Document, KeepsThePlaceOfEveryKeyAndValue) {
  const DocumentNode root = parse("a: 1\nlist:\n  - x\n  - {b: [2, 33]}\n");
  ASSERT_TRUE(root.is_map());
  EXPECT_EQ(root.entries[0].key_place.text(), "f.yaml:1:1");
  EXPECT_EQ(root.find("a")->place.text(), "f.yaml:1:4");
  const DocumentNode& list = *root.find("list");
  EXPECT_EQ(list.items[0].place.text(), "f.yaml:3:5");
  const DocumentNode& pair = *list.items[1].find("b");
  EXPECT_EQ(list.items[1].entries[0].key_place.text(), "f.yaml:4:6");
  EXPECT_EQ(pair.items[1].place.text(), "f.yaml:4:13");
  EXPECT_EQ(pair.items[1].place.length, 2);
}
TEST(Document, InterpretsNothing) {
  const DocumentNode root =
      parse("[1e-3, yes, on, 08, 0x10, 2*r, .5, 'a''b', \"\\u00e9\", ~, null, '']");
  const std::vector<std::string> texts = {"1e-3", "yes", "on",     "08", "0x10", "2*r",
                                          ".5",   "a'b", "\u00e9", "",   "",     ""};
  ASSERT_EQ(root.items.size(), texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(root.items[i].text, texts[i]);
  EXPECT_FALSE(root.items[1].quoted);
  EXPECT_TRUE(root.items[7].quoted);
  EXPECT_EQ(root.items[9].kind, DocumentNode::Kind::empty);
  EXPECT_EQ(root.items[10].kind, DocumentNode::Kind::empty);
  EXPECT_EQ(root.items[11].kind, DocumentNode::Kind::scalar);
}
TEST(Document, KeepsRepeatedKeys) {
  const DocumentNode root = parse("{a: 1, a: 2}");
  ASSERT_EQ(root.entries.size(), 2u);
  EXPECT_EQ(root.find("a")->text, "1");
}
TEST(Document, PlacesAMissingValueAtItsKey) {
  const DocumentNode root = parse("first: 1\nempty:\nlast: 2\n");
  EXPECT_EQ(root.find("empty")->kind, DocumentNode::Kind::empty);
  EXPECT_EQ(root.find("empty")->place.text(), "f.yaml:2:1");
}
TEST(Document, CountsColumnsInCharacters) {
  const DocumentNode root = parse("{\u00e9t\u00e9: \u03c0, b: 2}");
  EXPECT_EQ(root.entries[1].key_place.text(), "f.yaml:1:10");
}
TEST(Document, SkipsAByteOrderMarkAndCarriageReturns) {
  const DocumentNode root = parse(
      "\xEF\xBB\xBF"
      "a: 1\r\nb: 2\r\n");
  EXPECT_EQ(root.find("b")->text, "2");
  EXPECT_EQ(root.entries[0].key_place.text(), "f.yaml:1:1");
  EXPECT_EQ(root.find("b")->place.excerpt(), "    2 | b: 2\n      |    ^\n");
}
TEST(Document, FindsAPlaceWithinAText) {
  const DocumentNode root =
      parse("a: x + yy\nb: \"x + yy\"\nc: >\n  x\n  + yy\nd: \"x\\x20+ yy\"\n");
  EXPECT_EQ(root.find("a")->place_within(4, 2).text(), "f.yaml:1:8");
  EXPECT_EQ(root.find("b")->place_within(4, 2).text(), "f.yaml:2:9");
  // Where the text is not in the file as it is, the place is still that in the file.
  EXPECT_EQ(root.find("c")->place_within(4, 2).text(), "f.yaml:5:5");
  EXPECT_EQ(root.find("d")->place_within(4, 2).text(), "f.yaml:6:12");
}

TEST(Document, RefusesWhatIsNotOneDocument) {
  EXPECT_EQ(mistake(""), "f.yaml:1:1: the file is empty");
  EXPECT_EQ(mistake("# only a comment\n"), "f.yaml:1:1: the file is empty");
  EXPECT_EQ(mistake("a: 1\n---\nb: 2\n"),
            "f.yaml:3:1: several documents in one file: '---' may only begin it");
  EXPECT_EQ(mistake("---\na: 1\n"), "none");
}
TEST(Document, RefusesAnchorsAliasesAndTags) {
  EXPECT_THAT(mistake("a: &x 1\n"), testing::StartsWith("f.yaml:1:4: anchors are not supported"));
  EXPECT_THAT(mistake("a: *x\n"), testing::StartsWith("f.yaml:1:4: aliases are not supported"));
  EXPECT_THAT(mistake("a: !x 1\n"), testing::StartsWith("f.yaml:1:4: tags are not supported"));
  EXPECT_THAT(mistake("a: & b\n"), testing::StartsWith("f.yaml:1:"));
}
TEST(Document, RefusesTextThatIsNotUtf8) {
  EXPECT_EQ(mistake("a: 1\nb: \xFF\n"), "f.yaml:2:4: the text is not UTF-8 here");
  EXPECT_EQ(mistake("b: \xC0\xAF\n"), "f.yaml:1:4: the text is not UTF-8 here");      // overlong
  EXPECT_EQ(mistake("b: \xED\xA0\x80\n"), "f.yaml:1:4: the text is not UTF-8 here");  // surrogate
  EXPECT_EQ(mistake("b: \xE2\x82"), "f.yaml:1:4: the text is not UTF-8 here");        // cut off
  EXPECT_EQ(mistake("\xFF\xFE"
                    "a"),
            "f.yaml:1:1: the text is not UTF-8 here");  // UTF-16
  EXPECT_EQ(mistake(std::string("a: \0b\n", 6)), "f.yaml:1:4: a control character in the text");
}
TEST(Document, HostileTextIsAMistakeAndNotACrash) {
  EXPECT_THAT(mistake(std::string(100'000, '[')), testing::HasSubstr("nested more than 100"));
  EXPECT_THAT(mistake(std::string(100'000, '{')), testing::StartsWith("f.yaml:1:"));
  std::string indented;
  for (int i = 0; i < 2000; ++i) indented += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_THAT(mistake(indented), testing::HasSubstr("nested more than 100"));
  const DocumentNode root = parse("a: " + std::string(10'000'000, 'x') + "\n");
  EXPECT_EQ(root.find("a")->text.size(), 10'000'000u);
  EXPECT_LT(root.find("a")->place.excerpt().size(), 300u);
}
TEST(Document, RefusesFilesThatCannotBeRead) {
  EXPECT_THROW(read_source("no/such/file.yaml"), ProblemFileErrors);
  EXPECT_THROW(read_source("."), ProblemFileErrors);
}
TEST(Document, ListsTheWordsOfItsScalars) {
  const DocumentNode root = parse("{a: 'omega(hole) + hole_2', b: [disk.left, 3]}");
  EXPECT_THAT(words_of(root), testing::ElementsAre("3", "disk", "hole", "hole_2", "left", "omega"));
}
