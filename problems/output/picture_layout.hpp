#pragma once

#include <optional>
#include <string>

#include "problems/output/colour_bar.hpp"

namespace rfm {

struct PictureRequest {
  int width = 1000;  ///< pixels of the whole picture
  std::string title;
  /// Height over width of what is shown.
  double aspect = 1;
  /// Beside the picture, if any.
  std::optional<ColourScale> scale;
  ColourBarStyle bar;
  /// Pixels for the numbers of axes, at the left and below, and for what else stands at the right.
  double left_margin = 0, bottom_margin = 0, right_margin = 0;
  /// Pixels that what stands at the right needs in height, from the upper side of what is shown.
  double least_height = 0;
};

/// Where the parts of a picture go: title on top, what is shown below it at the left, the colour
/// bar at its right. The size of the shown part follows from the width of the picture and its
/// aspect, the height of the picture from both; a very flat or tall part is kept within 1/4 to 5/4
/// of the width, centred.
struct PictureLayout {
  int width = 0, height = 0;
  double font_size = 16;
  PixelRectangle shown;  ///< on whole pixels
  PixelRectangle bar;    ///< of no size without a colour scale
};
PictureLayout picture_layout(const PictureRequest& request);

/// Font size for the numbers of a picture of this width.
double label_size(int picture_width);

/// Draws title and colour bar.
void draw_frame(Canvas& canvas, const PictureLayout& layout, const PictureRequest& request);

}  // namespace rfm
