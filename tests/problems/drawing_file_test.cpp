#include "problems/drawing_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace rfm {
namespace {

// Groups are written with blanks between code and value, one after the other.
std::string lines_of(std::string text) {
  for (char& letter : text)
    if (letter == ' ') letter = '\n';
  return text + "\n";
}

std::string drawing(const std::string& entities, const std::string& before = "") {
  return lines_of(before + "0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF");
}

const std::string outline = "0 LWPOLYLINE 8 0 70 1 10 1 20 0 42 0.5 10 5 20 0 10 5 20 3";

std::vector<PointList> outlines(const std::string& entities, const std::string& before = "") {
  return outlines_of_drawing(drawing(entities, before), "part.dxf");
}

std::string mistake_in(const std::string& entities) {
  try {
    outlines(entities);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Drawing, MayBeginWithComments) {
  const std::string text = drawing(outline, "999 dxfrw 999 again ");
  EXPECT_TRUE(is_drawing(text));
  EXPECT_EQ(outlines_of_drawing(text, "part.dxf").size(), 1u);
  EXPECT_EQ(parse_points(text, "part.dxf")[0].points.size(), 3u);
  EXPECT_FALSE(is_drawing("999\n1\n2\n"));
  EXPECT_FALSE(is_drawing("0 0\n1 0\n1 1\n"));
}

TEST(Drawing, SeenFromBelowIsMirrored) {
  const PointList plain = outlines(outline)[0];
  const PointList mirrored = outlines(outline + " 210 0 220 0 230 -1")[0];
  ASSERT_EQ(mirrored.points.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(mirrored.points[i][0], -plain.points[i][0]);
    EXPECT_EQ(mirrored.points[i][1], plain.points[i][1]);
    EXPECT_EQ(mirrored.bulges[i], -plain.bulges[i]);
  }
  const PointList circle = outlines("0 CIRCLE 10 5 20 1 40 2 210 0 220 0 230 -1")[0];
  EXPECT_EQ(std::min(circle.points[0][0], circle.points[1][0]), -7);
  EXPECT_EQ(std::max(circle.points[0][0], circle.points[1][0]), -3);
  const PointList old = outlines(
      "0 POLYLINE 66 1 70 1 230 -1 0 VERTEX 10 1 20 2 42 1 0 VERTEX 10 3 20 2 42 1 0 SEQEND")[0];
  EXPECT_EQ(old.points[1][0], -3);
  EXPECT_EQ(old.bulges[1], -1);
  EXPECT_EQ(mistake_in(outline + " 210 0 220 1 230 0"),
            "part.dxf:6: the plane of this LWPOLYLINE is inclined to that of the drawing");
}

TEST(Drawing, HoldsWhatIsSeenInTheModel) {
  EXPECT_EQ(outlines(outline + " " + outline + " 60 1").size(), 1u);
  EXPECT_EQ(outlines(outline + " " + outline + " 67 1").size(), 1u);
  EXPECT_EQ(outlines(outline + " 0 LINE 67 1 10 0 20 0 11 1 21 1").size(), 1u);
  EXPECT_EQ(outlines(outline + " 0 POLYLINE 67 1 70 1 0 VERTEX 10 1 20 2 0 SEQEND").size(), 1u);
  EXPECT_EQ(outlines(outline + " 0 CIRCLE 60 0 67 0 10 2 20 1 40 0.1").size(), 2u);
  const std::string tables =
      "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 old 70 1 62 7 0 LAYER 2 off 70 0 62 -7 "
      "0 LAYER 2 on 70 0 62 7 0 ENDTAB 0 ENDSEC ";
  for (const std::string name : {"old", "off", "on"})
    EXPECT_EQ(outlines(outline + " 0 CIRCLE 8 " + name + " 10 2 20 1 40 0.1", tables).size(),
              name == "on" ? 2u : 1u)
        << name;
}

TEST(Drawing, OfASmoothedPolylineHoldsTheCurve) {
  const PointList list = outlines(
      "0 POLYLINE 66 1 70 5 0 VERTEX 10 0 20 0 70 8 0 VERTEX 10 2 20 -1 70 16 0 VERTEX 10 4 20 0 "
      "70 8 0 VERTEX 10 4 20 4 70 8 0 SEQEND")[0];
  ASSERT_EQ(list.points.size(), 3u);
  EXPECT_EQ(list.points[1][0], 4);
  EXPECT_FALSE(list.is_open);
}

TEST(Drawing, RefusesMeshesAndCurvesInSpace) {
  EXPECT_EQ(mistake_in("0 POLYLINE 70 16 0 VERTEX 10 0 20 0 0 SEQEND"),
            "part.dxf:6: this polyline is a mesh and no outline");
  EXPECT_EQ(mistake_in("0 POLYLINE 70 64 0 VERTEX 10 0 20 0 70 192 0 SEQEND"),
            "part.dxf:6: this polyline is a mesh and no outline");
  EXPECT_EQ(mistake_in("0 POLYLINE 70 9 0 VERTEX 10 0 20 0 30 1 0 VERTEX 10 1 20 0 30 2 0 SEQEND"),
            "part.dxf:18: the heights of this polyline differ");
  EXPECT_EQ(outlines("0 POLYLINE 70 9 0 VERTEX 10 0 20 0 30 1 0 VERTEX 10 1 20 0 30 1 0 SEQEND")[0]
                .points.size(),
            2u);
}

}  // namespace
}  // namespace rfm
