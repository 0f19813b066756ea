#include "compare_images.hpp"
#include "render/osmesa_context.hpp"
#include "render/renderer.hpp"
#include "session/simulation.hpp"
#include "ui/user_interface.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

constexpr int width = 1280;
constexpr int height = 720;

/// The panels over the picture, off screen, as in a capture with panels.
class PanelPicture : public ::testing::Test {
 protected:
  PanelPicture() : simulation_(scene()), panels_({width, height, 1.0F, 1.0F}, UserInterface::Backend::OpenGl) {
    simulation_.apply(session::PauseCommand{true});
    simulation_.capture(snapshot_);
  }

  static std::shared_ptr<const scene::Scene> scene() {
    const scene::SceneDescription description = scene::openScene("grid");
    return scene::buildScene(description, description.settings);
  }

  render::Image draw(const UiStats& stats = {}) {
    UiOutput ignored;
    // The layout needs three frames: first the width of the column, then the line breaks beside the scroll bar.
    for (int frame = 0; frame < 3; ++frame) {
      panels_.build(snapshot_, stats, ignored);
    }
    const render::Camera camera = besidePanels(render::Camera(snapshot_.scene->camera), panels_.view(), width, height);
    renderer_.draw(snapshot_, camera, width, height);
    renderer_.bindTarget();
    panels_.renderDrawData();
    return renderer_.read();
  }

  static int brightness(const render::Image& image, int x, int y) {
    const std::size_t at = (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) * 3;
    return (image.rgb[at] + image.rgb[at + 1] + image.rgb[at + 2]) / 3;
  }

  render::OsmesaContext context_;
  render::Renderer renderer_;
  session::Simulation simulation_;
  session::Snapshot snapshot_;
  UserInterface panels_;
};

TEST_F(PanelPicture, TheColumnIsDarkAndThePictureIsNot) {
  const render::Image image = draw();
  const UiRect view = panels_.view();
  EXPECT_LT(brightness(image, 4, 300), 60);
  EXPECT_GT(brightness(image, static_cast<int>(view.x) + 20, 20), 120);
  EXPECT_LT(brightness(image, width - 4, height - 4), 60) << "the status line";
}

TEST_F(PanelPicture, TextIsDrawn) {
  const render::Image image = draw();
  int bright = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 300; ++x) {
      bright += brightness(image, x, y) > 180 ? 1 : 0;
    }
  }
  EXPECT_GT(bright, 150) << "the scene's title";
}

TEST_F(PanelPicture, PicturesAreTheSameEveryTime) {
  const render::Image first = draw();
  const render::Image second = draw();
  EXPECT_EQ(render::compareImages(first, second).pixels, 0);
}

TEST_F(PanelPicture, WithoutPanelsThePictureFillsTheWindow) {
  panels_.showPanels(false);
  const render::Image image = draw();
  EXPECT_GT(brightness(image, 4, 300), 120);
  EXPECT_GT(brightness(image, width - 4, height - 4), 120);
}

TEST_F(PanelPicture, TheFocalPointIsInTheMiddleOfTheFreeArea) {
  draw();
  const UiRect view = panels_.view();
  const scene::CameraPose pose = snapshot_.scene->camera;
  const Vec2 place = besidePanels(render::Camera(pose), view, width, height).project(pose.focalPoint, width, height);
  EXPECT_NEAR(place.x(), view.x + view.width / 2.0, 1.0);
  EXPECT_NEAR(place.y(), view.y + view.height / 2.0, 1.0);
}

}  // namespace
}  // namespace drape::ui
