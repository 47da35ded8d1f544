#include "problems/schema.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <set>

#include "problems/document.hpp"

using namespace rfm;

namespace {

void for_every_key(const SchemaKey& key, const std::function<void(const SchemaKey&)>& action) {
  for (const auto* children : {&key.keys, &key.words, &key.items, &key.named})
    for (const SchemaKey& child : *children) {
      action(child);
      for_every_key(child, action);
    }
}

}  // namespace

TEST(Schema, EveryRowIsDocumentedByASentence) {
  for_every_key(schema(), [](const SchemaKey& key) {
    EXPECT_THAT(key.doc, testing::EndsWith(".")) << key.path;
    EXPECT_NE(key.types, 0u) << key.path;
  });
}
TEST(Schema, DefaultsAreYamlOfTheRightKind) {
  for_every_key(schema(), [](const SchemaKey& key) {
    if (key.presence.standard.empty()) return;
    const DocumentNode node = parse_document(
        make_source("default of " + key.path, std::string(key.presence.standard), false));
    const unsigned lists = list_value | vector_value | numbers_value;
    const unsigned maps = map_value | named_map_value;
    EXPECT_TRUE(node.is_scalar() || key.takes(node.is_map() ? maps : lists)) << key.path;
    if (key.takes(word_value) && node.is_scalar()) {
      EXPECT_THAT(key.words, testing::Contains(testing::Field(&SchemaKey::name, node.text)));
    }
  });
}
TEST(Schema, RowsOfOneNameApplyUnderDifferentConditions) {
  for_every_key(schema(), [](const SchemaKey& key) {
    std::set<std::string> seen;
    for (const SchemaKey& child : key.keys)
      for (const std::string& word : child.when.empty() ? std::vector<std::string>{""} : child.when)
        EXPECT_TRUE(seen.insert(child.name + " " + word).second) << child.path;
  });
}
TEST(Schema, WordsOfWhenExist) {
  for_every_key(schema(), [](const SchemaKey& key) {
    std::set<std::string> words = {"1D", "2D", "3D"};
    for (const SchemaKey& child : key.keys) {
      for (const SchemaKey& word : child.words) words.insert(word.name);
      if (child.presence.kind == Presence::Kind::alternative) words.insert(child.name);
    }
    for (const SchemaKey& type : schema().keys)
      if (type.name == "physics" && key.path == "physics.materials[]")
        for (const SchemaKey& word : type.keys[0].words) words.insert(word.name);
    for (const SchemaKey& child : key.keys)
      for (const std::string& word : child.when)
        EXPECT_TRUE(words.contains(word)) << child.path << " when " << word;
  });
}
TEST(Schema, CoefficientsMayBeGivenPerMaterial) {
  std::set<std::string> paths;
  for_every_key(schema(), [&](const SchemaKey& key) { paths.insert(key.path); });
  EXPECT_TRUE(paths.contains("physics.materials[].conductivity"));
  EXPECT_TRUE(paths.contains("physics.conductivity.from"));
}

TEST(Range, TellsItsLimits) {
  EXPECT_EQ(positive.text(), "greater than 0");
  EXPECT_EQ(at_least(1).text(), "at least 1");
  EXPECT_EQ(between(1, 9).text(), "from 1 to 9");
  EXPECT_EQ((Range{-1, 1, true}).text(), "greater than -1 and at most 1");
  EXPECT_EQ(any_range.text(), "");
  EXPECT_FALSE(positive.contains(0));
  EXPECT_TRUE(at_least(0).contains(0));
  EXPECT_FALSE(between(1, 9).contains(10));
  EXPECT_FALSE(positive.contains(std::numeric_limits<double>::quiet_NaN()));
}
