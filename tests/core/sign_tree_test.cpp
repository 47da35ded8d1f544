#include "core/sign_tree.hpp"

#include <gtest/gtest.h>

#include "core/contact.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

TEST(SignTree, ProvesSignsAndHalvesUntilItKnowsOrIsAtItsResolution) {
  const RegionEvaluator ring(circle({0, 0}, 1) - circle({0, 0}, 0.5));
  SignTree tree(ring, {2, {-1, -1}, {1, 1}});
  int boxes = 0, leaves = 0;
  tree.search(
      [&](const SignTree::Node& node) {
        ++boxes;
        const Point center = node.box.center();
        for (int k = 0; k < 2; ++k) {
          if (node.of(k) == Truth::unknown) continue;
          EXPECT_EQ(node.of(k) == Truth::yes, ring.level(k).value(center) > 0);
        }
        if (node.inside != Truth::unknown) {
          EXPECT_EQ(node.inside == Truth::yes, ring.contains(center));
        }
        return node.inside == Truth::unknown;
      },
      [&](const SignTree::Node& node) {
        ++leaves;
        EXPECT_LE(node.box.longest_side(), 2.1 * 0x1p-10);
        EXPECT_GT(2.1 * node.box.longest_side(), 2.0 * 0x1p-10);
        return true;
      });
  EXPECT_GT(leaves, 5000);  // about the length of the circles in boxes
  EXPECT_LT(leaves, 20000);
  EXPECT_LT(boxes, 10 * leaves);
}

// Doubles near 1e14 are 1/64 apart: 2⁻¹⁰ of this circle is less.
TEST(SignTree, EndsWhereBoxesFarAwayNoLongerHalve) {
  const RegionEvaluator far(circle({1e14, 1e14}, 1));
  SignTree tree(far, {2, {1e14 - 1, 1e14 - 1}, {1e14 + 1, 1e14 + 1}});
  int leaves = 0;
  tree.search([](const SignTree::Node& node) { return node.inside == Truth::unknown; },
              [&](const SignTree::Node&) { return ++leaves > 0; });
  EXPECT_GT(leaves, 4);
  EXPECT_LT(leaves, 10000);
}

TEST(SignTree, LaterQuestionsHaveTheAnswersOfFreshTrees) {
  const RegionEvaluator region((circle({0, 0}, 1) & circle({1, 0}, 1)) | circle({3, 0}, 0.5) |
                               circle({3.2, 0}, 0.5));
  const Box bounds{2, {-1, -1}, {4, 1}};
  SignTree shared(region, bounds);
  for (int a = 0; a < region.primitive_count(); ++a) {
    SignTree fresh(region, bounds);
    EXPECT_EQ(extends_beyond_piece(a, shared), extends_beyond_piece(a, fresh)) << a;
    for (int b = 0; b < a; ++b) {
      SignTree own(region, bounds);
      const Factor first{BooleanExpression::variable(a), {{a, false}}};
      const Factor second{BooleanExpression::variable(b), {{b, false}}};
      EXPECT_EQ(contact(first, second, shared), contact(first, second, own)) << a << ' ' << b;
      EXPECT_EQ(may_cross_within(a, b, shared), may_cross_within(a, b, own)) << a << ' ' << b;
    }
  }
}

}  // namespace
}  // namespace rfm
