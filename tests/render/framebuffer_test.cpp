#include "render/framebuffer.hpp"

#include "render/osmesa_context.hpp"

#include <gtest/gtest.h>
#include <array>

namespace drape::render {
namespace {

/// The colour of a cleared picture [0 to 255].
std::array<int, 3> clearedWith(Framebuffer& framebuffer, float red, float green, float blue) {
  framebuffer.begin(40, 30);
  glClearColor(red, green, blue, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  framebuffer.resolve();
  std::array<unsigned char, 4> pixel{};
  glReadPixels(39, 29, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  return {pixel[0], pixel[1], pixel[2]};
}

TEST(Framebuffer, drawsWithAnyNumberOfSamplesThatTheDriverHas) {
  const OsmesaContext context;
  for (const int samples : {0, 1, 2, 4, 64}) {
    Framebuffer framebuffer(samples);
    EXPECT_EQ(clearedWith(framebuffer, 1.0F, 0.0F, 1.0F), (std::array<int, 3>{255, 0, 255})) << samples;
    EXPECT_LE(framebuffer.samples(), samples);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << samples;
  }
}

TEST(Framebuffer, hasFourSamplesByDefault) {
  const OsmesaContext context;
  Framebuffer framebuffer;
  static_cast<void>(clearedWith(framebuffer, 0.0F, 1.0F, 0.0F));
  EXPECT_EQ(framebuffer.samples(), 4);
}

}  // namespace
}  // namespace drape::render
