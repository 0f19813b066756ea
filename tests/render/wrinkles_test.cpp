#include "render/wrinkles.hpp"
#include "compare_images.hpp"
#include "fields/shown_field.hpp"
#include "render/osmesa_context.hpp"
#include "render/renderer.hpp"
#include "session/simulation.hpp"
#include "wavy_sheet.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace drape::render {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int sheetPixels = 384;  // the sheet of one metre fills the picture

/// A flat sheet of a square metre that is compressed to these ratios along x and y.
session::Snapshot compressedSheet(double ratioX, double ratioY) {
  session::Snapshot snapshot = wavySheet(0.0);
  auto scene = std::make_shared<scene::Scene>(*snapshot.scene);
  scene->model =
      sim::buildClothModel({scene->model->restPositions, scene->model->triangles}, 0.15, sim::MassLumping::Area, {});
  scene->cloths = {scene::wholeCloth(*scene->model)};
  snapshot.scene = scene;
  snapshot.model = scene->model;
  const Vec3 middle(0.0, 0.9, 0.0);
  for (Vec3& position : snapshot.positions) {
    position = middle + (position - middle).cwiseProduct(Vec3(ratioX, ratioY, 1.0));
  }
  snapshot.settings.view.surface = "plain";
  snapshot.settings.view.shadows = false;
  snapshot.settings.view.occlusion = false;
  snapshot.settings.view.wrinkles = true;
  return snapshot;
}

/// The wavelength of its wrinkles at rest [m].
double wavelengthOf(const session::Snapshot& snapshot) {
  double sum = 0.0;
  for (const sim::Spring& spring : snapshot.model->springs) {
    sum += spring.restLength;
  }
  return edgesPerWrinkle * sum / static_cast<double>(snapshot.model->springs.size());
}

/// A view along the normal, without perspective, in which a square of this height fills the picture [m].
Camera facing(double height = 1.0) {
  scene::CameraPose pose;
  pose.focalPoint = {0.0, 0.9, 0.0};
  pose.position = pose.focalPoint + Vec3(0.0, 0.0, 2.0);
  pose.viewAngle = 2.0 * std::atan(0.5 * height / 2.0) * 180.0 / pi;
  pose.isOrthographic = true;
  return Camera(pose);
}

/// The brightness of each pixel of a square in the middle, row by row, without its mean.
struct Brightness {
  int side = 0;
  std::vector<double> values;

  [[nodiscard]] double at(int x, int y) const { return values[y * side + x]; }
};

Brightness brightnessOf(const Image& image, int side) {
  Brightness result{side, {}};
  double sum = 0.0;
  for (int y = (image.height - side) / 2; y < (image.height + side) / 2; ++y) {
    for (int x = (image.width - side) / 2; x < (image.width + side) / 2; ++x) {
      result.values.push_back(image.rgb[3 * (y * image.width + x) + 1]);
      sum += result.values.back();
    }
  }
  for (double& value : result.values) {
    value -= sum / static_cast<double>(result.values.size());
  }
  return result;
}

/// The mean square of the difference between neighbours along x or along y.
double variation(const Brightness& picture, bool alongX) {
  double sum = 0.0;
  for (int y = 0; y + 1 < picture.side; ++y) {
    for (int x = 0; x + 1 < picture.side; ++x) {
      const double step = picture.at(alongX ? x + 1 : x, alongX ? y : y + 1) - picture.at(x, y);
      sum += step * step;
    }
  }
  return sum / (picture.side * picture.side);
}

/// The number of waves along x with the most power, of all rows together [in the square].
double strongestWave(const Brightness& picture) {
  double strongest = 0.0;
  double best = 0.0;
  for (double waves = 2.0; waves < 30.0; waves += 0.25) {
    double power = 0.0;
    for (int y = 0; y < picture.side; ++y) {
      std::complex<double> sum;
      for (int x = 0; x < picture.side; ++x) {
        sum += picture.at(x, y) * std::polar(1.0, 2.0 * pi * waves * x / picture.side);
      }
      power += std::norm(sum);
    }
    if (power > strongest) {
      strongest = power;
      best = waves;
    }
  }
  return best;
}

class WrinklePicture : public testing::Test {
 protected:
  Image picture(const session::Snapshot& snapshot, const Camera& camera, const PictureExtras& extras = {}) {
    renderer_.draw(snapshot, camera, sheetPixels, sheetPixels, extras);
    return renderer_.read();
  }

  /// The number of pixels in which the picture with wrinkles differs from that without.
  int changedPixels(session::Snapshot snapshot, const Camera& camera, int tolerance = 0,
                    const PictureExtras& extras = {}) {
    const Image with = picture(snapshot, camera, extras);
    snapshot.settings.view.wrinkles = false;
    return compareImages(with, picture(snapshot, camera, extras), tolerance).pixels;
  }

 private:
  OsmesaContext context_;
  Renderer renderer_;
};

TEST(Wrinkles, HaveTheLengthOfTheClothAtRest) {
  constexpr int parts = 10000;
  for (const double ratio : {0.99, 0.97, 0.95, 0.9, 0.85}) {
    // The length of the sine over its wavelength, by the midpoint rule.
    const double slope = std::sqrt(squaredWrinkleSlope(ratio, springBuckling));
    double length = 0.0;
    for (int i = 0; i < parts; ++i) {
      length += std::hypot(1.0, slope * std::cos(2.0 * pi * (i + 0.5) / parts)) / parts;
    }
    const double excess = 1.0 / ratio - 1.0;
    EXPECT_LT(length, 1.0 / ratio);
    EXPECT_GT(length, 1.0 / ratio - springBuckling - 0.8 * excess * excess) << ratio;
  }
}

TEST(Wrinkles, NeedCompression) {
  EXPECT_EQ(squaredWrinkleSlope(1.0, springBuckling), 0.0);
  EXPECT_EQ(squaredWrinkleSlope(1.2, springBuckling), 0.0);
  EXPECT_LT(squaredWrinkleSlope(1.0 - 1e-6, springBuckling), 1e-8) << "rounding is not drawn";
  EXPECT_EQ(squaredWrinkleSlope(0.0, springBuckling), squaredWrinkleSlope(0.3, springBuckling))
      << "the slope has a limit";
  EXPECT_EQ(squaredWrinkleSlope(std::nan(""), springBuckling), 0.0);
}

TEST(Wrinkles, AreComputedOncePerVersionAndNotWhileTheyAreOff) {
  session::Snapshot snapshot = compressedSheet(0.9, 1.0);
  WrinkleMap map;
  snapshot.settings.view.wrinkles = false;
  EXPECT_FALSE(map.update(snapshot));
  EXPECT_TRUE(map.vertices().empty()) << "nothing is computed";
  snapshot.settings.view.wrinkles = true;
  EXPECT_TRUE(map.update(snapshot));
  EXPECT_EQ(map.vertices().size(), snapshot.positions.size());
  EXPECT_FALSE(map.update(snapshot));
  ++snapshot.version;
  EXPECT_TRUE(map.update(snapshot));
}

TEST(Wrinkles, RunAcrossTheCompression) {
  WrinkleMap map;
  ASSERT_TRUE(map.update(compressedSheet(0.9, 1.02)));
  for (const Wrinkles& wrinkles : map.vertices()) {
    const float squaredSlope = wrinkles.diagonal.sum();
    EXPECT_NEAR(squaredSlope, squaredWrinkleSlope(0.9, springBuckling), 1e-5);
    EXPECT_GT(wrinkles.diagonal.x(), 0.89F * squaredSlope) << "the random part is small";
    EXPECT_NEAR(wrinkles.diagonal.z(), 0.0, 1e-6) << "the sheet has its normal along z";
  }
}

TEST_F(WrinklePicture, ClothWithoutCompressionHasTheSameBits) {
  for (const char* surface : {"plain", "checker", "fabric"}) {
    session::Snapshot snapshot = compressedSheet(1.0, 1.05);
    snapshot.settings.view.surface = surface;
    EXPECT_EQ(changedPixels(snapshot, cameraInFront()), 0) << surface;
  }
}

TEST_F(WrinklePicture, CompressedClothHasWavesOfTheirLengthAcrossTheCompression) {
  const double ratio = 0.92;
  const session::Snapshot snapshot = compressedSheet(ratio, 1.0);
  EXPECT_GT(changedPixels(snapshot, facing(), 4), sheetPixels * sheetPixels / 2);
  constexpr int side = 320;
  const Brightness brightness = brightnessOf(picture(snapshot, facing()), side);
  EXPECT_GT(variation(brightness, true), 4.0 * variation(brightness, false));
  const double expected = side / (ratio * wavelengthOf(snapshot) * sheetPixels);
  EXPECT_NEAR(strongestWave(brightness), expected, 0.2 * expected);
}

TEST_F(WrinklePicture, TheWavesFollowTheDirectionOfTheCompression) {
  const Brightness brightness = brightnessOf(picture(compressedSheet(1.0, 0.92), facing()), 320);
  EXPECT_GT(variation(brightness, false), 4.0 * variation(brightness, true));
}

TEST_F(WrinklePicture, ClothThatIsCompressedEquallyOnAllSidesCrumplesAndDoesNotFlicker) {
  const Image equally = picture(compressedSheet(0.95, 0.95), facing());
  session::Snapshot smooth = compressedSheet(0.95, 0.95);
  smooth.settings.view.wrinkles = false;
  EXPECT_GT(compareImages(equally, picture(smooth, facing()), 4).pixels, sheetPixels * sheetPixels / 3);
  for (const double slightly : {1e-5, -1e-5}) {
    session::Snapshot next = compressedSheet(0.95, 0.95 + slightly);
    ++next.version;
    EXPECT_LT(compareImages(equally, picture(next, facing()), 4).pixels, 50);
  }
}

TEST_F(WrinklePicture, FabricsHaveWrinklesToo) {
  session::Snapshot snapshot = compressedSheet(0.92, 1.0);
  snapshot.settings.view.surface = "fabric";
  EXPECT_GT(changedPixels(snapshot, facing(), 4), sheetPixels * sheetPixels / 3);
}

TEST_F(WrinklePicture, WavesShorterThanTwoPixelsAreNotDrawn) {
  const session::Snapshot snapshot = compressedSheet(0.92, 1.0);
  const double pixelsPerMetre = 2.0 / wavelengthOf(snapshot);
  EXPECT_EQ(changedPixels(snapshot, facing(sheetPixels / pixelsPerMetre), 1), 0);
}

TEST_F(WrinklePicture, TheWireframeAndColourMapsShowTheMesh) {
  session::Snapshot snapshot = compressedSheet(0.92, 1.0);
  fields::SnapshotFields fields;
  fields::FieldDisplay display;
  snapshot.settings.view.colourMap = "strain_warp";
  EXPECT_EQ(changedPixels(snapshot, facing(), 0, {.field = &display.update(snapshot, fields)}), 0);
  snapshot.settings.view.wireframe = true;
  EXPECT_EQ(changedPixels(snapshot, facing()), 0);
}

TEST_F(WrinklePicture, DrawingThemDoesNotChangeTheMotion) {
  const auto positionsWith = [&](bool wrinkles) {
    const scene::SceneDescription description = scene::openScene("grid");
    settings::Settings settings = description.settings;
    settings.view.wrinkles = wrinkles;
    session::Simulation simulation(scene::buildScene(description, settings));
    session::Snapshot snapshot;
    for (int step = 0; step < 40; ++step) {
      simulation.step();
      simulation.capture(snapshot);
      if (step % 10 == 0) {
        (void)picture(snapshot, cameraInFront());
      }
    }
    EXPECT_EQ(snapshot.settings.view.wrinkles, wrinkles);
    return snapshot.positions;
  };
  EXPECT_EQ(positionsWith(true), positionsWith(false));
}

TEST_F(WrinklePicture, AChangeWhileTheClothRestsShowsAtOnce) {
  session::Snapshot snapshot = compressedSheet(0.92, 1.0);
  snapshot.settings.view.wrinkles = false;
  const Image without = picture(snapshot, facing());
  snapshot.settings.view.wrinkles = true;
  const Image with = picture(snapshot, facing());
  EXPECT_GT(compareImages(with, without, 4).pixels, 1000);
  snapshot.settings.view.wrinkles = false;
  EXPECT_EQ(picture(snapshot, facing()).rgb, without.rgb);
}

}  // namespace
}  // namespace drape::render
