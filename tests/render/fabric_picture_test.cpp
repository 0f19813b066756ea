#include "compare_images.hpp"
#include "fabrics/presets.hpp"
#include "render/osmesa_context.hpp"
#include "render/renderer.hpp"
#include "settings/settings_table.hpp"
#include "wavy_sheet.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

namespace drape::render {
namespace {

constexpr int pictureWidth = 320;
constexpr int pictureHeight = 240;

session::Snapshot sheetOf(std::string_view preset, double waveHeight = 0.0) {
  session::Snapshot snapshot = wavySheet(waveHeight);
  settings::assignSettingExpression(snapshot.settings, "material.model=fabric");
  settings::assignSettingExpression(snapshot.settings, "material.preset=" + std::string(preset));
  return snapshot;
}

/// A camera at this distance from the middle of the sheet [m], in front (+) or behind (-).
Camera cameraAt(double distance) {
  scene::CameraPose pose;
  pose.focalPoint = {0.013, 0.9, 0.0};
  pose.position = pose.focalPoint + Vec3(0.0, 0.0, distance);
  return Camera(pose);
}

/// A square of 40 by 40 pixels in the middle of a picture.
template <typename Visit>
void forEachPixelInTheMiddle(const Image& image, Visit&& visit) {
  for (int y = pictureHeight / 2 - 20; y < pictureHeight / 2 + 20; ++y) {
    for (int x = pictureWidth / 2 - 20; x < pictureWidth / 2 + 20; ++x) {
      visit(&image.rgb[3 * (static_cast<std::size_t>(y) * pictureWidth + static_cast<std::size_t>(x))]);
    }
  }
}

/// The largest difference between neighbours in the middle of a picture [levels].
int contrastOf(const Image& image) {
  int largest = 0;
  forEachPixelInTheMiddle(image, [&](const std::uint8_t* pixel) {
    const std::uint8_t* below = pixel + std::size_t{3} * pictureWidth;
    for (int channel = 0; channel < 3; ++channel) {
      largest =
          std::max({largest, std::abs(pixel[channel] - pixel[channel + 3]), std::abs(pixel[channel] - below[channel])});
    }
  });
  return largest;
}

/// The mean colour in the middle of a picture [levels].
std::array<double, 3> meanOf(const Image& image) {
  std::array<double, 3> mean{};
  forEachPixelInTheMiddle(image, [&](const std::uint8_t* pixel) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      mean[channel] += pixel[channel] / 1600.0;
    }
  });
  return mean;
}

class FabricPicture : public testing::Test {
 protected:
  Image picture(const session::Snapshot& snapshot, const Camera& camera = cameraInFront()) {
    Renderer renderer;
    renderer.draw(snapshot, camera, pictureWidth, pictureHeight);
    return renderer.read();
  }

 private:
  OsmesaContext context_;
};

TEST_F(FabricPicture, SpringsKeepTheirChecker) {
  session::Snapshot springs = wavySheet(0.06);
  const Image automatic = picture(springs);
  springs.settings.view.surface = "checker";
  EXPECT_EQ(automatic.rgb, picture(springs).rgb);
  springs.settings.view.surface = "fabric";
  EXPECT_GT(compareImages(automatic, picture(springs), 8).pixels, 5000);
}

TEST_F(FabricPicture, AFabricLooksLikeItselfAndTheCheckerStaysAChoice) {
  session::Snapshot denim = sheetOf("denim", 0.06);
  const Image automatic = picture(denim);
  EXPECT_GT(compareImages(automatic, picture(sheetOf("silk", 0.06)), 8).pixels, 5000);
  denim.settings.view.surface = "checker";
  const Image checker = picture(denim);
  EXPECT_GT(compareImages(automatic, checker, 8).pixels, 5000);
  EXPECT_EQ(checker.rgb, picture(wavySheet(0.06)).rgb);
}

/// A sheet whose texture coordinates are all one point, as those of meshes for games that have one colour.
session::Snapshot sheetWithoutArea(session::Snapshot sheet) {
  auto scene = std::make_shared<scene::Scene>(*sheet.scene);
  for (Vec2& uv : scene->renderMesh.uvs) {
    uv = Vec2(0.5, 0.5);
  }
  sheet.scene = scene;
  return sheet;
}

TEST_F(FabricPicture, ClothWhoseTextureCoordinatesHaveNoAreaIsShadedAlike) {
  for (const char* preset : {"cotton", "silk", "leather"}) {
    const session::Snapshot sheet = sheetOf(preset, 0.06);
    EXPECT_LT(compareImages(picture(sheet), picture(sheetWithoutArea(sheet)), 24).pixels, 400) << preset;
  }
}

TEST_F(FabricPicture, YarnsShowFromNearAndLeaveNoMoireFarther) {
  for (const char* preset : {"denim", "canvas", "linen", "jersey", "leather"}) {
    EXPECT_GT(contrastOf(picture(sheetOf(preset), cameraAt(0.03))), 15) << preset;
  }
  for (const fabrics::Preset& preset : fabrics::presetTable()) {
    for (const double distance : {1.3, 1.7, 2.3}) {
      EXPECT_LE(contrastOf(picture(sheetOf(preset.name), cameraAt(distance))), 6) << preset.name << " " << distance;
    }
  }
}

TEST_F(FabricPicture, TheColourIsTheSameFromNearAndFar) {
  for (const char* preset : {"cotton", "denim", "wool", "jersey", "felt"}) {
    const auto near = meanOf(picture(sheetOf(preset), cameraAt(0.15)));
    const auto far = meanOf(picture(sheetOf(preset), cameraAt(1.3)));
    for (std::size_t channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(near[channel], far[channel], 16.0) << preset;
    }
  }
}

TEST_F(FabricPicture, TheBackDiffersFromTheFront) {
  const auto front = meanOf(picture(sheetOf("denim"), cameraAt(1.0)));
  const auto back = meanOf(picture(sheetOf("denim"), cameraAt(-1.0)));
  EXPECT_GT(front[2], front[0] + 20.0) << "the front is blue: mostly warp";
  EXPECT_LT(back[2] - back[0], front[2] - front[0]) << "the back shows the white weft";
}

TEST_F(FabricPicture, WarpTurnsWithItsAngle) {
  session::Snapshot denim = sheetOf("denim");
  const Image upright = picture(denim, cameraAt(0.05));
  denim.settings.fabric.warpAngle = 45.0;
  EXPECT_GT(compareImages(upright, picture(denim, cameraAt(0.05)), 8).pixels, 5000);
}

TEST_F(FabricPicture, ASheenShowsAtGrazingViews) {
  session::Snapshot felt = sheetOf("felt");
  scene::CameraPose pose = cameraAt(1.0).pose();
  const auto facing = meanOf(picture(felt, Camera(pose)));
  pose.position = pose.focalPoint + Vec3(0.0, 0.97, 0.24);
  const auto grazing = meanOf(picture(felt, Camera(pose)));
  EXPECT_GT(grazing[1], facing[1] + 8.0);
}

TEST_F(FabricPicture, AGhostBesideAFabricIsGreen) {
  session::Snapshot snapshot = sheetOf("silk");
  snapshot.ghost.emplace();
  snapshot.ghost->positions = snapshot.positions;
  snapshot.settings.ghost.offset = 1.5;
  scene::CameraPose pose = cameraAt(2.0).pose();
  pose.position.x() += 1.5;
  pose.focalPoint.x() += 1.5;
  const auto ghost = meanOf(picture(snapshot, Camera(pose)));
  EXPECT_GT(ghost[1], ghost[0] + 30.0);
}

}  // namespace
}  // namespace drape::render
