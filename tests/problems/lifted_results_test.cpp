#include "problems/lifted_results.hpp"

#include <gtest/gtest.h>

namespace rfm {
namespace {

DocumentNode lifted(const std::string& text) {
  DocumentNode root = parse_document(make_source("case.yaml", text));
  lift_results(root);
  return root;
}

TEST(LiftedResults, AreFieldsAndTheirNamesTheFormulas) {
  const DocumentNode root = lifted(
      "fields: {u_of_heat: x}\n"
      "conditions:\n"
      "  - {at: a, value: {from: heat.yaml, field: u}}\n"
      "  - {at: b, flux: {from: heat.yaml, field: u}}\n"
      "  - {at: c, value: {v: {from: 2-d.yaml, field: u}}}\n");
  const DocumentNode& fields = *root.find("fields");
  ASSERT_EQ(fields.entries.size(), 3u);
  EXPECT_EQ(fields.entries[1].key, "u_of_heat_2");  // beside the user's own
  EXPECT_EQ(fields.entries[1].value.find("from")->text, "heat.yaml");
  EXPECT_EQ(fields.entries[2].key, "u_of_2_d");
  const DocumentNode& conditions = *root.find("conditions");
  EXPECT_EQ(conditions.items[0].find("value")->text, "u_of_heat_2");
  EXPECT_EQ(conditions.items[1].find("flux")->text, "u_of_heat_2");
  EXPECT_EQ(conditions.items[2].find("value")->find("v")->text, "u_of_2_d");
}

TEST(LiftedResults, AreNothingElseThatIsCalledFrom) {
  const std::string text =
      "geometry: {shapes: {rod: {capsule: {from: [0, 0], to: [1, 0], radius: 1}}}}\n"
      "conditions: [{at: a, value: {from: 1, u: 2}}]\n"
      "physics: {source: {from: heat.yaml, field: u}}\n";
  const DocumentNode root = lifted(text);
  EXPECT_EQ(root.find("fields"), nullptr);
  EXPECT_TRUE(root.find("conditions")->items[0].find("value")->is_map());
  EXPECT_TRUE(root.find("physics")->find("source")->is_map());
}

}  // namespace
}  // namespace rfm
