#include "render/window_context.hpp"
#include "messages/error.hpp"
#include "render/renderer.hpp"
#include "wavy_sheet.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::render {
namespace {

TEST(WindowWithoutDisplay, IsRefusedWithAReasonAndARemedy) {
  try {
    const WindowContext context("drape", 320, 240);
    FAIL() << "there should be no display here";
  } catch (const messages::InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("cannot reach a display"), std::string::npos) << message;
    EXPECT_NE(message.find("drape-headless"), std::string::npos) << message;
  }
}

TEST(WindowOnDisplay, DrawsAndCopiesToTheWindow) {
  const WindowContext context("drape", 320, 240);
  ASSERT_NE(context.window(), nullptr);
  Renderer renderer;
  renderer.draw(wavySheet(0.06), cameraInFront(), 320, 240);
  renderer.blitToWindow();
  const Image image = renderer.read();
  EXPECT_GT(*std::max_element(image.rgb.begin(), image.rgb.end()), 200);
}

TEST(WindowOnDisplay, CanBeOpenedAgain) {
  { const WindowContext first("drape", 320, 240); }
  const WindowContext second("drape", 320, 240);
  EXPECT_NE(second.window(), nullptr);
}

}  // namespace
}  // namespace drape::render
