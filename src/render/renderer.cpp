#include "render/renderer.hpp"

#include "render/creases.hpp"
#include "render/frame_uniforms.hpp"
#include "render/framebuffer.hpp"
#include "render/ground_shadow.hpp"
#include "render/marks.hpp"
#include "render/shader_program.hpp"
#include "render/shadow_map.hpp"
#include "render/smooth_mesh.hpp"
#include "render/surface_coordinates.hpp"
#include "render/texture_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drape {
namespace {

constexpr double fadeInSizes = 5.0;    // the ground has faded away at this many sizes of the scene [-]
constexpr double smallestFade = 1.5;   // but not nearer than this [m]
constexpr double creaseAngle = 0.7;    // edges of a stand that turn by more are sharp [rad]
constexpr float unitHeight = 800.0F;   // in a picture this high a unit of a mark is one pixel [pixels]
constexpr float smallestMark = 0.75F;  // a smaller dot would not be seen [pixels]

Eigen::Vector3d directionToLight() {
  return Eigen::Vector3d(0.60, 1.0, 0.55).normalized();
}

float markScale(int height) {
  return std::max(smallestMark, static_cast<float>(height) / unitHeight);
}

}  // namespace

struct Renderer::Parts {
  void take(const Snapshot& snapshot);
  void takeScene(const Scene& scene);
  void updateShadows(const FrameUniforms& uniforms);
  [[nodiscard]] FrameUniforms frameUniforms(const Snapshot& snapshot, const Camera& camera, int width,
                                            int height) const;
  void drawBackground() const;
  void drawStand() const;
  void drawCloth(const Settings::View& view) const;
  void drawGround() const;
  void drawMarks(const Snapshot& snapshot, int height) const;

  Framebuffer framebuffer;
  FrameBlock frameBlock;
  ShaderProgram backgroundProgram{"fullscreen.vert", "background.frag"};
  ShaderProgram clothProgram{"surface.vert", "cloth.frag"};
  ShaderProgram wireframeProgram{"surface.vert", "cloth.frag", "wireframe.geom", "#define WIREFRAME\n"};
  ShaderProgram standProgram{"surface.vert", "stand.frag"};
  ShaderProgram groundProgram{"ground.vert", "ground.frag"};
  GlVertexArray nothing;
  SmoothMesh cloth;
  SmoothMesh stand;
  Marks marks;
  ShadowMap shadowMap;
  GroundShadow groundShadow;

  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const ClothModel> model;
  std::int64_t version = -1;
  double checkSize = 0.1;                       // [m]
  Eigen::Vector3d groundCentre{0.0, 0.0, 0.0};  // [m]
  double groundFade = 1.0;                      // [m]
  bool shadowsAreCurrent = false;
};

/// Sends to the graphics card what has changed since the last picture.
void Renderer::Parts::take(const Snapshot& snapshot) {
  const bool newScene = snapshot.scene != scene;
  if (newScene) {
    scene = snapshot.scene;
    takeScene(*scene);
  }
  if (newScene || snapshot.version != version || snapshot.model != model) {
    version = snapshot.version;
    model = snapshot.model;
    cloth.setPositions(snapshot.positions);
    marks.setPins(snapshot);
    shadowsAreCurrent = false;
  }
}

void Renderer::Parts::takeScene(const Scene& newScene) {
  const RenderMesh& mesh = newScene.renderMesh;
  const SurfaceCoordinates coordinates = surfaceCoordinates(mesh, newScene.model->restPositions);
  checkSize = coordinates.checkSize;
  cloth.setTopology({newScene.model->triangles, mesh.triangles, mesh.particle, coordinates.metres});

  Eigen::AlignedBox3d box;
  for (const Vec3& position : newScene.start.positions) {
    box.extend(position);
  }
  const Decor standing = newScene.stand.value_or(Decor{});
  const CreasedMesh creased = splitAtCreases(standing.positions, standing.triangles, creaseAngle);
  stand.setTopology({creased.triangles, creased.triangles, {}, {}});
  stand.setPositions(creased.positions);
  box.extend(stand.bounds());

  groundCentre = {box.center().x(), newScene.groundHeight, box.center().z()};
  groundFade = std::max(smallestFade, fadeInSizes * 0.5 * box.diagonal().norm());
}

FrameUniforms Renderer::Parts::frameUniforms(const Snapshot& snapshot, const Camera& camera, int width,
                                             int height) const {
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  FrameUniforms uniforms;
  uniforms.viewProjection = camera.projectionMatrix(static_cast<double>(width) / height) * camera.viewMatrix();
  uniforms.shadowFromWorld = shadowMap.fromWorld();
  uniforms.eye << camera.pose().position.cast<float>(), 1.0F;
  uniforms.toLight << directionToLight().cast<float>(), snapshot.settings.view.shadows ? 1.0F : 0.0F;
  uniforms.viewport << w, h, 1.0F / w, 1.0F / h;
  uniforms.ground << groundCentre.cast<float>(), static_cast<float>(groundFade);
  uniforms.groundShadow << groundShadow.centre().cast<float>(), static_cast<float>(groundShadow.halfSide()), 0.0F;
  uniforms.shadowScale << static_cast<float>(shadowMap.texelSize()), static_cast<float>(2.0 * shadowMap.radius()),
      1.0F / ShadowMap::resolution, 0.0F;
  return uniforms;
}

void Renderer::Parts::updateShadows(const FrameUniforms& uniforms) {
  frameBlock.upload(uniforms);
  const std::array<const SmoothMesh*, 2> meshes{&cloth, &stand};
  shadowMap.draw(meshes);
  shadowMap.bind(shadowUnit, shadowDepthUnit);
  groundShadow.draw();
  shadowsAreCurrent = true;
}

void Renderer::Parts::drawBackground() const {
  // Comes after the solid things and fills what they leave, so that no pixel is coloured twice.
  glDepthFunc(GL_LEQUAL);
  backgroundProgram.use();
  glBindVertexArray(nothing.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glDepthFunc(GL_LESS);
}

void Renderer::Parts::drawStand() const {
  standProgram.use();
  standProgram.set("shadowMap", static_cast<int>(shadowUnit));
  stand.draw();
}

void Renderer::Parts::drawCloth(const Settings::View& view) const {
  const ShaderProgram& program = view.wireframe ? wireframeProgram : clothProgram;
  program.use();
  program.set("shadowMap", static_cast<int>(shadowUnit));
  program.set("checkSize", static_cast<float>(checkSize));
  program.set("checkered", view.surface == "checker" ? 1.0F : 0.0F);
  cloth.draw();
}

void Renderer::Parts::drawGround() const {
  // Cloth that lies on the ground wins over it.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0F, 2.0F);
  groundShadow.bind(groundShadowUnit);
  groundProgram.use();
  groundProgram.set("groundShadowMap", static_cast<int>(groundShadowUnit));
  glBindVertexArray(nothing.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void Renderer::Parts::drawMarks(const Snapshot& snapshot, int height) const {
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDepthMask(GL_FALSE);
  marks.drawPins(markScale(height));
  if (snapshot.grab) {
    // The hand is shown through the cloth: it must never be lost.
    glDisable(GL_DEPTH_TEST);
    marks.drawGrab(*snapshot.grab, markScale(height));
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_PROGRAM_POINT_SIZE);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
}

Renderer::Renderer() : parts_(std::make_unique<Parts>()) {
  checkGl("the renderer's set-up");
}

Renderer::~Renderer() = default;

void Renderer::draw(const Snapshot& snapshot, const Camera& camera, int width, int height) {
  Parts& parts = *parts_;
  const Settings::View& view = snapshot.settings.view;
  parts.take(snapshot);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (view.shadows && !parts.shadowsAreCurrent) {
    Eigen::AlignedBox3d box = parts.cloth.bounds();
    box.extend(parts.stand.bounds());
    parts.shadowMap.fit(box, directionToLight());
    parts.groundShadow.fit(parts.shadowMap, parts.groundCentre.y(), directionToLight());
    parts.updateShadows(parts.frameUniforms(snapshot, camera, width, height));
  }
  parts.frameBlock.upload(parts.frameUniforms(snapshot, camera, width, height));
  parts.shadowMap.bind(shadowUnit, shadowDepthUnit);

  parts.framebuffer.begin(width, height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  parts.drawStand();
  parts.drawCloth(view);
  if (view.ground && camera.pose().position.y() > parts.groundCentre.y()) {
    parts.drawGround();
  }
  parts.drawBackground();
  parts.drawMarks(snapshot, height);
  parts.framebuffer.resolve();
  glUseProgram(0);
  checkGl("the picture");
}

void Renderer::blitToWindow(int left, int bottom) {
  parts_->framebuffer.blitToWindow(left, bottom);
}

void Renderer::bindTarget() {
  parts_->framebuffer.bindResolved();
}

Image Renderer::read() {
  parts_->framebuffer.bindResolved();
  Image image{parts_->framebuffer.width(), parts_->framebuffer.height(), {}};
  const std::size_t row = std::size_t{3} * static_cast<std::size_t>(image.width);
  image.rgb.resize(row * static_cast<std::size_t>(image.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  // OpenGL counts rows from the bottom.
  for (std::size_t top = 0, bottom = image.rgb.size() - row; top < bottom; top += row, bottom -= row) {
    std::swap_ranges(image.rgb.begin() + static_cast<std::ptrdiff_t>(top),
                     image.rgb.begin() + static_cast<std::ptrdiff_t>(top + row),
                     image.rgb.begin() + static_cast<std::ptrdiff_t>(bottom));
  }
  checkGl("reading the picture");
  return image;
}

}  // namespace drape
