#include "render/renderer.hpp"
#include "compare_images.hpp"
#include "render/osmesa_context.hpp"
#include "render/shader_program.hpp"
#include "wavy_sheet.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

namespace drape::render {
namespace {

constexpr int targetWidth = 320;
constexpr int targetHeight = 240;

using Pixel = std::array<int, 3>;

Pixel pixelAt(const Image& image, int x, int y) {
  const std::size_t offset =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgb[offset], image.rgb[offset + 1], image.rgb[offset + 2]};
}

int distanceOf(const Pixel& a, const Pixel& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// The same scene with the cloth out of view.
session::Snapshot withoutCloth(session::Snapshot snapshot) {
  for (Vec3& position : snapshot.positions) {
    position.z() += 1000.0;
  }
  snapshot.settings.view.shadows = false;
  ++snapshot.version;
  return snapshot;
}

class RendererTest : public testing::Test {
 protected:
  Image picture(const session::Snapshot& snapshot, const Camera& camera = cameraInFront()) {
    renderer_.draw(snapshot, camera, targetWidth, targetHeight);
    return renderer_.read();
  }

  Renderer& renderer() { return renderer_; }

 private:
  OsmesaContext context_;
  Renderer renderer_;
};

TEST_F(RendererTest, PictureHasTheSizeAskedForAndIsNotBlack) {
  const Image image = picture(wavySheet(0.06));
  EXPECT_EQ(image.width, targetWidth);
  EXPECT_EQ(image.height, targetHeight);
  ASSERT_EQ(image.rgb.size(), std::size_t{3} * targetWidth * targetHeight);
  EXPECT_GT(*std::max_element(image.rgb.begin(), image.rgb.end()), 200);
  const std::set<std::uint8_t> values(image.rgb.begin(), image.rgb.end());
  EXPECT_GT(values.size(), 50U);
}

TEST_F(RendererTest, ClothIsWhereTheCameraProjectsIt) {
  session::Snapshot snapshot = wavySheet(0.06);
  snapshot.settings.view.surface = "plain";
  snapshot.settings.view.shadows = false;
  const Image with = picture(snapshot);
  const Image without = picture(withoutCloth(snapshot));
  const Camera camera = cameraInFront();
  int covered = 0;
  for (const Vec3& position : snapshot.positions) {
    // Slightly towards the middle, so that vertices on the rim count too.
    const Vec3 inside = position + 0.03 * (Vec3(0.0, 0.9, position.z()) - position);
    const Vec2 place = camera.project(inside, targetWidth, targetHeight);
    const int x = static_cast<int>(place.x());
    const int y = static_cast<int>(place.y());
    covered += distanceOf(pixelAt(with, x, y), pixelAt(without, x, y)) > 20 ? 1 : 0;
  }
  EXPECT_EQ(covered, static_cast<int>(snapshot.positions.size()));
  for (const auto& [x, y] : {std::pair(3, 3), std::pair(targetWidth - 4, 3), std::pair(3, targetHeight / 2)}) {
    EXPECT_EQ(pixelAt(with, x, y), pixelAt(without, x, y));
  }
}

TEST_F(RendererTest, TwoRenderersDrawTheSameBytes) {
  const session::Snapshot snapshot = wavySheet(0.06);
  const Image first = picture(snapshot);
  Renderer other;
  other.draw(snapshot, cameraInFront(), targetWidth, targetHeight);
  EXPECT_EQ(first.rgb, other.read().rgb);
  EXPECT_EQ(first.rgb, picture(snapshot).rgb);
}

TEST_F(RendererTest, APictureDoesNotDependOnThePreviousOne) {
  const session::Snapshot snapshot = wavySheet(0.06);
  const Image fresh = picture(snapshot);
  session::Snapshot other = wavySheet(0.12);
  other.settings.view.wireframe = true;
  other.settings.view.shadows = false;
  other.attachment = session::AttachmentStatus{};
  (void)picture(other);
  EXPECT_EQ(fresh.rgb, picture(snapshot).rgb);
}

TEST_F(RendererTest, ViewSettingsChangeThePicture) {
  const session::Snapshot plainView = wavySheet(0.06);
  const Image before = picture(plainView);
  const auto pixelsChangedBy = [&](auto change) {
    session::Snapshot changed = plainView;
    change(changed.settings.view);
    return compareImages(before, picture(changed), 8).pixels;
  };
  EXPECT_GT(pixelsChangedBy([](settings::Settings::View& view) { view.wireframe = true; }), 2000);
  EXPECT_GT(pixelsChangedBy([](settings::Settings::View& view) { view.surface = "plain"; }), 2000);
  EXPECT_GT(pixelsChangedBy([](settings::Settings::View& view) { view.ground = false; }), 2000);
  EXPECT_GT(pixelsChangedBy([](settings::Settings::View& view) { view.shadows = false; }), 500);
}

TEST_F(RendererTest, AmbientOcclusionDarkensFoldsAndNothingElse) {
  const auto withAndWithout = [&](double depth) {
    session::Snapshot snapshot = wavySheet(depth);
    snapshot.settings.view.shadows = false;
    const Image with = picture(snapshot);
    snapshot.settings.view.occlusion = false;
    return std::pair(with, picture(snapshot));
  };
  const auto [folded, foldedWithout] = withAndWithout(0.3);
  int darker = 0;
  int brightest = 0;
  for (std::size_t i = 0; i < folded.rgb.size(); ++i) {
    const int change = static_cast<int>(folded.rgb[i]) - static_cast<int>(foldedWithout.rgb[i]);
    darker += change < -4 ? 1 : 0;
    brightest = std::max(brightest, change);
  }
  EXPECT_GT(darker, 500);
  EXPECT_LE(brightest, 1);
  const auto [flat, flatWithout] = withAndWithout(0.0);
  EXPECT_EQ(compareImages(flat, flatWithout, 1).pixels, 0);
}

TEST_F(RendererTest, AmbientOcclusionIsTheSameInAnOrthographicView) {
  // From far away both views show nearly the same picture.
  scene::CameraPose pose = cameraInFront().pose();
  pose.position = pose.focalPoint + 20.0 * (pose.position - pose.focalPoint);
  pose.viewAngle /= 20.0;
  session::Snapshot snapshot = wavySheet(0.3);
  snapshot.settings.view.shadows = false;
  snapshot.settings.view.ground = false;
  const auto darkenedPixels = [&] {
    snapshot.settings.view.occlusion = true;
    const Image with = picture(snapshot, Camera(pose));
    snapshot.settings.view.occlusion = false;
    return compareImages(with, picture(snapshot, Camera(pose)), 4).pixels;
  };
  const int inPerspective = darkenedPixels();
  pose.isOrthographic = true;
  const int orthographic = darkenedPixels();
  EXPECT_GT(inPerspective, 300);
  EXPECT_NEAR(orthographic, inPerspective, 0.1 * inPerspective);
}

TEST_F(RendererTest, FrontAndBackAreTinted) {
  session::Snapshot snapshot = wavySheet(0.0);
  snapshot.settings.view.surface = "plain";
  const Pixel front = pixelAt(picture(snapshot), targetWidth / 2, targetHeight / 2);
  scene::CameraPose pose = cameraInFront().pose();
  pose.position.z() = -pose.position.z();
  const Pixel back = pixelAt(picture(snapshot, Camera(pose)), targetWidth / 2, targetHeight / 2);
  EXPECT_GT(front[2], front[0] + 30) << "the front is blue";
  EXPECT_GT(back[0], back[2] + 30) << "the back is red";
}

TEST_F(RendererTest, OutlinesAreBlendedFromFourSamples) {
  session::Snapshot snapshot = wavySheet(0.0);
  snapshot.settings.view.surface = "plain";
  snapshot.settings.view.shadows = false;
  snapshot.settings.view.ground = false;
  const Image with = picture(snapshot);
  const Image without = picture(withoutCloth(snapshot));
  // Every row crosses the left outline once; the pixel there is a mixture of quarters.
  std::set<int> quarters;
  for (int y = 80; y < 160; ++y) {
    for (int x = 1; x + 1 < targetWidth / 2; ++x) {
      const int background = pixelAt(without, x, y)[0];
      const int cloth = pixelAt(with, x + 2, y)[0];
      const int here = pixelAt(with, x, y)[0];
      const bool isOutline = std::abs(here - background) > 10 && std::abs(here - cloth) > 10;
      if (isOutline) {
        quarters.insert(static_cast<int>(std::lround(4.0 * (here - background) / (cloth - background))));
      }
    }
  }
  EXPECT_TRUE(quarters.contains(1) && quarters.contains(2) && quarters.contains(3));
}

TEST_F(RendererTest, NewPositionsAreDrawnWhenTheVersionGrows) {
  session::Snapshot snapshot = wavySheet(0.06);
  const Image before = picture(snapshot);
  for (Vec3& position : snapshot.positions) {
    position.x() += 0.2;
  }
  ++snapshot.version;
  EXPECT_GT(compareImages(before, picture(snapshot), 8).pixels, 500);
}

TEST_F(RendererTest, AttachmentAndPinsAreShown) {
  const session::Snapshot snapshot = wavySheet(0.06);
  const Camera camera = cameraInFront();
  const Image without = picture(snapshot);
  session::Snapshot attached = snapshot;
  attached.attachment = session::AttachmentStatus{{0, {1.0, 0.0, 0.0}, {0.3, 1.1, 0.4}}, {0.0, 0.9, 0.0}, false};
  const Image with = picture(attached);
  const Vec2 target = camera.project(attached.attachment->target, targetWidth, targetHeight);
  const Pixel amber = pixelAt(with, static_cast<int>(target.x()), static_cast<int>(target.y()));
  EXPECT_GT(amber[0], amber[2] + 100);
  EXPECT_GT(compareImages(without, with, 8).pixels, 100);

  session::Snapshot unpinned = snapshot;
  auto model = std::make_shared<sim::ClothModel>(*snapshot.model);
  model->pinned.assign(model->pinned.size(), false);
  unpinned.model = model;
  const Image noPins = picture(unpinned);
  EXPECT_GT(compareImages(without, noPins, 8).pixels, 20);
  EXPECT_LT(compareImages(without, noPins, 8).pixels, 300);

  model = std::make_shared<sim::ClothModel>(*snapshot.model);
  model->pinned.assign(model->pinned.size(), true);
  unpinned.model = model;
  EXPECT_EQ(compareImages(picture(unpinned), noPins, 0).pixels, 0)
      << "dots would hide a cloth that is frozen as a whole";
}

/// The sheet with a ghost at this distance behind (+) or in front (-) of it.
session::Snapshot withGhost(session::Snapshot snapshot, double behind) {
  snapshot.ghost.emplace();
  snapshot.ghost->positions = snapshot.positions;
  for (Vec3& position : snapshot.ghost->positions) {
    position.z() -= behind;
  }
  ++snapshot.version;
  return snapshot;
}

TEST_F(RendererTest, AGhostInFrontIsGreenAndTheClothShowsThrough) {
  session::Snapshot snapshot = wavySheet(0.0);
  snapshot.settings.view.surface = "plain";
  const Pixel cloth = pixelAt(picture(snapshot), targetWidth / 2, targetHeight / 2);
  const Pixel mixed = pixelAt(picture(withGhost(snapshot, -0.1)), targetWidth / 2, targetHeight / 2);
  EXPECT_GT(mixed[1], mixed[0] + 20);
  EXPECT_GT(mixed[1], mixed[2] + 10);
  session::Snapshot alone = withGhost(snapshot, -0.1);
  for (Vec3& position : alone.positions) {
    position.z() += 1000.0;
  }
  ++alone.version;
  const Pixel ghost = pixelAt(picture(alone), targetWidth / 2, targetHeight / 2);
  EXPECT_GT(distanceOf(mixed, cloth), 20);
  EXPECT_GT(distanceOf(mixed, ghost), 20);
}

TEST_F(RendererTest, AGhostInTheSamePlaceOrBehindIsHidden) {
  for (const bool wireframe : {false, true}) {
    session::Snapshot snapshot = wavySheet(0.06);
    snapshot.settings.view.wireframe = wireframe;
    const Image without = picture(snapshot);
    EXPECT_EQ(compareImages(without, picture(withGhost(snapshot, 0.0)), 8).pixels, 0);
    const Pixel before = pixelAt(without, targetWidth / 2, targetHeight / 2);
    EXPECT_EQ(pixelAt(picture(withGhost(snapshot, 0.1)), targetWidth / 2, targetHeight / 2), before);
  }
}

TEST_F(RendererTest, AGhostIsDrawnBesideTheCloth) {
  session::Snapshot snapshot = wavySheet(0.0);
  snapshot.settings.view.surface = "plain";
  scene::CameraPose pose = cameraInFront().pose();
  pose.position.z() += 3.0;
  const Camera camera(pose);
  const Image without = picture(snapshot, camera);
  session::Snapshot beside = withGhost(snapshot, 0.0);
  beside.settings.ghost.offset = 1.5;
  const Image with = picture(beside, camera);
  const Vec2 place = camera.project({1.5, 0.9, 0.0}, targetWidth, targetHeight);
  const int x = static_cast<int>(place.x());
  const int y = static_cast<int>(place.y());
  EXPECT_GT(distanceOf(pixelAt(with, x, y), pixelAt(without, x, y)), 40);
  EXPECT_GT(pixelAt(with, x, y)[1], pixelAt(with, x, y)[0] + 30) << "it is green, and not seen through";
}

TEST_F(RendererTest, AGhostThatLeavesLeavesNoTrace) {
  const session::Snapshot snapshot = wavySheet(0.06);
  const Image fresh = picture(snapshot);
  session::Snapshot haunted = withGhost(snapshot, -0.1);
  haunted.settings.ghost.offset = 1.5;
  haunted.settings.view.wireframe = true;
  (void)picture(haunted);
  session::Snapshot after = snapshot;
  after.version = haunted.version + 1;
  EXPECT_EQ(fresh.rgb, picture(after).rgb);
}

TEST_F(RendererTest, GroundIsNotInTheWayFromBelow) {
  scene::CameraPose pose = cameraInFront().pose();
  pose.position.y() = -0.8;
  session::Snapshot snapshot = wavySheet(0.06);
  const Image withGround = picture(snapshot, Camera(pose));
  snapshot.settings.view.ground = false;
  EXPECT_EQ(withGround.rgb, picture(snapshot, Camera(pose)).rgb);
}

TEST_F(RendererTest, SizeMayChangeBetweenPictures) {
  const session::Snapshot snapshot = wavySheet(0.06);
  const Image before = picture(snapshot);
  renderer().draw(snapshot, cameraInFront(), 101, 77);
  EXPECT_EQ(renderer().read().rgb.size(), std::size_t{3} * 101 * 77);
  EXPECT_EQ(before.rgb, picture(snapshot).rgb);
}

TEST_F(RendererTest, AStandIsDrawn) {
  const session::Snapshot snapshot = wavySheet(0.06);
  const Image without = picture(snapshot);
  auto scene = std::make_shared<scene::Scene>(*snapshot.scene);
  scene->stand = scene::Decor{{{-0.9, 0.0, 0.2}, {-0.6, 0.0, 0.2}, {-0.75, 1.2, 0.2}}, {{0, 1, 2}}};
  session::Snapshot withStand = snapshot;
  withStand.scene = scene;
  const Vec2 place = cameraInFront().project({-0.75, 0.5, 0.2}, targetWidth, targetHeight);
  const int x = static_cast<int>(place.x());
  const int y = static_cast<int>(place.y());
  EXPECT_GT(distanceOf(pixelAt(picture(withStand), x, y), pixelAt(without, x, y)), 15);
}

TEST_F(RendererTest, IntersectionsAreDrawnInRedOverTheCloth) {
  const session::Snapshot snapshot = wavySheet(0.0);
  const Image without = picture(snapshot);
  session::Snapshot crossing = snapshot;
  const Vec3 behind(0.0, 0.8, -0.2);  // behind the sheet
  crossing.intersections = {{behind - 0.1 * Vec3::UnitX(), behind + 0.1 * Vec3::UnitX()}};
  ++crossing.version;
  const Image with = picture(crossing);
  const Vec2 place = cameraInFront().project(behind, targetWidth, targetHeight);
  const Pixel line = pixelAt(with, static_cast<int>(place.x()), static_cast<int>(place.y()));
  EXPECT_GT(line[0], line[1] + 120);
  EXPECT_GT(compareImages(without, with, 8).pixels, 10);
  EXPECT_LT(compareImages(without, with, 8).pixels, 400);
}

TEST_F(RendererTest, ContactsAreDrawnWithTheirNormals) {
  const session::Snapshot snapshot = wavySheet(0.0);
  const Image without = picture(snapshot);
  session::Snapshot touching = snapshot;
  touching.settings.view.contacts = true;
  touching.contactPoints = {{Vec3(0.2, 0.9, 0.01), Vec3::UnitX()}, {Vec3(-0.2, 0.7, 0.01), Vec3::UnitY()}};
  ++touching.version;
  const Image with = picture(touching);
  const Camera camera = cameraInFront();
  for (const sim::contact::ContactPoint& contact : touching.contactPoints) {
    const Vec2 foot = camera.project(contact.point, targetWidth, targetHeight);
    const auto pixelOf = [&](const Image& image, const Vec2& place) {
      return pixelAt(image, static_cast<int>(place.x()), static_cast<int>(place.y()));
    };
    EXPECT_GT(distanceOf(pixelOf(with, foot), pixelOf(without, foot)), 10);
    // The drawn normal is red.
    const Pixel line = pixelOf(with, camera.project(contact.point + 0.02 * contact.normal, targetWidth, targetHeight));
    EXPECT_GT(line[0], line[1] + 60);
  }
  EXPECT_GT(compareImages(without, with, 8).pixels, 20);
  EXPECT_LT(compareImages(without, with, 8).pixels, 400);
  session::Snapshot after = snapshot;
  after.version = touching.version + 1;
  EXPECT_EQ(without.rgb, picture(after).rgb) << "they leave no trace";
}

TEST_F(RendererTest, UnknownShadersAreReported) {
  EXPECT_THROW(ShaderProgram("surface.vert", "no_such.frag"), std::logic_error);
  EXPECT_THROW(ShaderProgram("surface.vert", "cloth.frag", {}, "#error broken\n"), std::logic_error);
}

}  // namespace
}  // namespace drape::render
