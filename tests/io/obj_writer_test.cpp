#include "io/obj_writer.hpp"

#include <gtest/gtest.h>

namespace drape::io {
namespace {

TEST(ObjWriter, writesSharedPositionsAndSplitTextureCoordinates) {
  RenderMesh render;
  render.particle = {0, 1, 2, 1, 3, 2};
  render.uvs = {{0, 0}, {1, 0}, {0, 1}, {3, 0}, {3, 1}, {2, 1}};
  render.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(objText({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, render, "two triangles"),
            "# two triangles\n"
            "v 0.000000 0.000000 0.000000\nv 1.000000 0.000000 0.000000\n"
            "v 0.000000 1.000000 0.000000\nv 1.000000 1.000000 0.000000\n"
            "vt 0.000000 0.000000\nvt 1.000000 0.000000\nvt 0.000000 1.000000\n"
            "vt 3.000000 0.000000\nvt 3.000000 1.000000\nvt 2.000000 1.000000\n"
            "f 1/1 2/2 3/3\nf 2/4 4/5 3/6\n");
}

TEST(ObjWriter, namesPositionsOnlyWithoutTextureCoordinates) {
  RenderMesh render;
  render.particle = {0, 1, 2};
  render.triangles = {{0, 1, 2}};
  const std::string text = objText({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, render, "");
  EXPECT_NE(text.find("\nf 1 2 3\n"), std::string::npos);
  EXPECT_EQ(text.find("vt"), std::string::npos);
}

TEST(ObjWriter, writesNoNegativeZeroAndAllDigitsOfLargeNumbers) {
  RenderMesh render;
  const std::string text = objText({{-1e-9, -0.25, 1e300}}, render, "");
  EXPECT_NE(text.find("v 0.000000 -0.250000 1000000000000000052504760"), std::string::npos);
}

}  // namespace
}  // namespace drape::io
