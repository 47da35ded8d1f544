#include "problems/output/picture_layout.hpp"

#include <gtest/gtest.h>

namespace rfm {
namespace {

TEST(PictureLayout, KeepsAspectAndWidthAndItsPartsApart) {
  for (const double aspect : {0.01, 0.2, 0.5, 1.0, 1.2, 3.0, 50.0})
    for (const int width : {300, 1000, 2400}) {
      PictureRequest request;
      request.width = width;
      request.aspect = aspect;
      request.title = "Title";
      request.scale = ColourScale(ColourMap::uniform, -1e-5, 3e-5);
      request.bar.title = "u";
      request.left_margin = 60;
      request.bottom_margin = 30;
      const PictureLayout layout = picture_layout(request);
      EXPECT_EQ(layout.width, width);
      EXPECT_NEAR(layout.shown.height, layout.shown.width * aspect, 0.51 * (1 + aspect));
      EXPECT_GE(layout.shown.left, request.left_margin);
      EXPECT_GT(layout.bar.left, layout.shown.right());
      EXPECT_LT(layout.bar.right() + colour_bar_label_width(*request.scale, layout.font_size),
                width);
      EXPECT_LE(layout.shown.bottom() + request.bottom_margin, layout.height);
      EXPECT_LE(layout.height, 1.6 * width);
    }
}

}  // namespace
}  // namespace rfm
