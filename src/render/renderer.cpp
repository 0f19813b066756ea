#include "render/renderer.hpp"

#include "render/ambient_occlusion.hpp"
#include "render/body_drawing.hpp"
#include "render/creases.hpp"
#include "render/fabric_look.hpp"
#include "render/frame_uniforms.hpp"
#include "render/framebuffer.hpp"
#include "render/ground_shadow.hpp"
#include "render/marks.hpp"
#include "render/picking.hpp"
#include "render/shader_program.hpp"
#include "render/shadow_map.hpp"
#include "render/smooth_mesh.hpp"
#include "render/surface_coordinates.hpp"
#include "render/texture_units.hpp"
#include "render/wrinkles.hpp"
#include "render/yarn_coordinates.hpp"
#include "scene/cloth_material.hpp"
#include "scene/framing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace drape::render {
namespace {

constexpr double fadeInSizes = 5.0;       // distance at which the ground has faded out, in sizes of the scene [-]
constexpr double smallestFade = 1.5;      // its minimum [m]
constexpr double occlusionRadius = 0.13;  // up to which surfaces take light from each other, in sizes of the scene [-]
constexpr double creaseAngle = 0.7;       // sharper edges of a stand get separate normals [rad]
constexpr float ghostOpacity = 0.6F;
constexpr float unitHeight = 800.0F;   // picture height at which a unit of a mark is one pixel [pixels]
constexpr float smallestMark = 0.75F;  // smaller dots are invisible [pixels]

Eigen::Vector3d directionToLight() {
  return Eigen::Vector3d(0.60, 1.0, 0.55).normalized();
}

float markScale(int height) {
  return std::max(smallestMark, static_cast<float>(height) / unitHeight);
}

/// The size of a metre at the distance of the focal point [pixels].
float pixelsPerMetre(const Camera& camera, int height) {
  const scene::CameraPose& pose = camera.pose();
  return static_cast<float>(height / (2.0 * scene::viewOffset(pose).norm() * scene::tanHalfAngle(pose)));
}

Eigen::Vector3f vectorOf(const fabrics::Colour& colour) {
  return {colour[0], colour[1], colour[2]};
}

/// Sets the uniforms of light.glsl.
void setLight(const ShaderProgram& program) {
  program.set("shadowMap", static_cast<int>(shadowUnit));
  program.set("occlusionMap", static_cast<int>(occlusionUnit));
}

/// Sets the uniforms of fabric.frag. @param warpAngle as fabric.warp_angle [degrees]
void setFabric(const ShaderProgram& program, const fabrics::Look& look, double warpAngle) {
  const auto angle = static_cast<float>(warpAngle * std::numbers::pi / 180.0);
  program.set("structure", static_cast<int>(look.structure));
  program.set("weave", Eigen::Vector3f(static_cast<float>(look.weave.repeat), static_cast<float>(look.weave.step),
                                       look.weave.weftOnTop));
  program.set("count", Eigen::Vector2f(look.columns, look.rows));
  program.set("warpTurn", Eigen::Vector2f(std::cos(angle), std::sin(angle)));
  program.set("warpColor", vectorOf(look.warp));
  program.set("weftColor", vectorOf(look.weft));
  program.set("relief", look.relief);
  program.set("roughness", look.roughness);
  program.set("anisotropy", look.anisotropy);
  program.set("shine", look.shine);
  program.set("sheen", look.sheen);
  program.set("unevenness", look.unevenness);
  program.set("translucency", look.translucency);
}

/// Whether warp runs along the texture coordinates, for each cloth.
std::vector<bool> clothsWithWarpAlongUvs(const scene::Scene& scene, const settings::Settings& settings) {
  std::vector<bool> along;
  for (const scene::ClothPart& cloth : scene.cloths) {
    along.push_back(scene::warpsAlongUvs(cloth.uvs, scene::settingsOf(cloth.own, settings)));
  }
  return along;
}

}  // namespace

struct Renderer::Parts {
  void take(const session::Snapshot& snapshot);
  void takeField(const fields::ShownField* shown);
  void takeWrinkles(const session::Snapshot& snapshot);
  void takeScene(const scene::Scene& scene, const settings::Settings& settings);
  void takeGhost(const session::Snapshot& snapshot);
  [[nodiscard]] std::vector<const SmoothMesh*> solidMeshes() const;
  void updateShadows(const FrameUniforms& uniforms);
  [[nodiscard]] FrameUniforms frameUniforms(const session::Snapshot& snapshot, const Camera& camera, int width,
                                            int height) const;
  void drawBackground() const;
  void drawStand() const;
  void drawBodies() const;
  void setPattern(const ShaderProgram& program, const settings::Settings& settings) const;
  void drawFabrics(const settings::Settings& settings) const;
  void drawCloth(const settings::Settings& settings) const;
  void drawField(const settings::Settings& settings) const;
  void drawGhost(const settings::Settings& settings) const;
  void drawGround() const;
  void drawMarks(const session::Snapshot& snapshot, const Camera& camera, int height,
                 std::span<const int> picked) const;

  Framebuffer framebuffer;
  FrameBlock frameBlock;
  ShaderProgram backgroundProgram{"fullscreen.vert", "background.frag"};
  ShaderProgram clothProgram{"surface.vert", "cloth.frag"};
  ShaderProgram fabricProgram{"surface.vert", "fabric.frag"};
  ShaderProgram wireframeProgram{"surface.vert", "cloth.frag", "wireframe.geom", "#define WIREFRAME\n"};
  std::optional<ShaderProgram> fieldProgram;  // compiled when it is needed first
  std::optional<ShaderProgram> fieldWireframeProgram;
  std::optional<ShaderProgram> clothWrinklesProgram;  // likewise
  std::optional<ShaderProgram> fabricWrinklesProgram;
  ShaderProgram standProgram{"surface.vert", "stand.frag"};
  ShaderProgram bodyProgram{"surface.vert", "stand.frag", {}, "#define BODY\n"};
  ShaderProgram groundProgram{"ground.vert", "ground.frag"};
  GlVertexArray nothing;
  SmoothMesh cloth;
  WrinkleMap wrinkles;
  SmoothMesh ghost;
  SmoothMesh stand;
  BodyDrawing bodies;
  Marks marks;
  ShadowMap shadowMap;
  GroundShadow groundShadow;
  AmbientOcclusion occlusion;

  std::shared_ptr<const scene::Scene> scene;
  std::vector<bool> warpsAlongUvs;  // of the yarns of each cloth that are shown
  std::shared_ptr<const sim::ClothModel> model;
  std::int64_t version = -1;
  double checkSize = 0.1;                       // [m]
  Eigen::Vector3d groundCentre{0.0, 0.0, 0.0};  // [m]
  double sceneSize = 1.0;                       // half the diagonal of cloth and stand at the start [m]
  double groundFade = 1.0;                      // [m]
  bool shadowsAreCurrent = false;
  bool drawsWrinkles = false;
  bool hasGhost = false;
  bool ghostStandsBeside = false;              // far enough from the cloth for its own shadows
  double clothWidth = 0.0;                     // at the scene's start [m]
  std::vector<Vec3> ghostPositions;            // where it is drawn [m]
  const fields::ColourMap* colours = nullptr;  // of the field that is drawn; null: the cloth has its own look
  std::vector<float> places;                   // of its values in the range of the colours
};

/// Uploads the changes since the last picture.
void Renderer::Parts::take(const session::Snapshot& snapshot) {
  const bool newScene =
      snapshot.scene != scene || clothsWithWarpAlongUvs(*snapshot.scene, snapshot.settings) != warpsAlongUvs;
  if (newScene) {
    scene = snapshot.scene;
    takeScene(*scene, snapshot.settings);
  }
  if (newScene || snapshot.version != version || snapshot.model != model) {
    version = snapshot.version;
    model = snapshot.model;
    cloth.setPositions(snapshot.positions);
    takeGhost(snapshot);
    marks.setPins(snapshot);
    marks.setContacts(snapshot);
    marks.setIntersections(snapshot);
    bodies.take(snapshot);
    shadowsAreCurrent = false;
  }
}

void Renderer::Parts::takeField(const fields::ShownField* shown) {
  constexpr float undefined = -1e9F;  // far below every place, so that a triangle with one such corner is grey
  constexpr double farOutside = 100.0;
  colours = nullptr;
  if (shown == nullptr || !shown->isShown()) {
    return;
  }
  if (!fieldProgram) {
    fieldProgram.emplace("surface.vert", "cloth.frag", std::string_view(), "#define FIELD\n");
    fieldWireframeProgram.emplace("surface.vert", "cloth.frag", "wireframe.geom", "#define FIELD\n#define WIREFRAME\n");
  }
  colours = &fields::coloursOf(*shown->field);
  places.resize(shown->values.size());
  std::transform(shown->values.begin(), shown->values.end(), places.begin(), [&](double value) {
    return std::isnan(value) ? undefined
                             : static_cast<float>(std::clamp(shown->range.placeOf(value), -farOutside, farOutside));
  });
  cloth.setValues(places);
}

/// Uploads the wrinkles of the cloth while they are drawn. Comes after takeField.
void Renderer::Parts::takeWrinkles(const session::Snapshot& snapshot) {
  drawsWrinkles = snapshot.settings.view.wrinkles && !snapshot.settings.view.wireframe && colours == nullptr;
  if (!drawsWrinkles) {
    return;
  }
  if (!clothWrinklesProgram) {
    clothWrinklesProgram.emplace("surface.vert", "cloth.frag", std::string_view(), "#define WRINKLES\n");
    fabricWrinklesProgram.emplace("surface.vert", "fabric.frag", std::string_view(), "#define WRINKLES\n");
  }
  if (wrinkles.update(snapshot)) {
    cloth.setWrinkles(wrinkles.vertices());
  }
}

void Renderer::Parts::takeGhost(const session::Snapshot& snapshot) {
  hasGhost = snapshot.ghost.has_value();
  if (!hasGhost) {
    return;
  }
  const double offset = snapshot.settings.ghost.offset;
  ghostPositions = snapshot.ghost->positions;
  for (Vec3& position : ghostPositions) {
    position.x() += offset;
  }
  ghost.setPositions(ghostPositions);
  ghostStandsBeside = std::abs(offset) > 0.5 * clothWidth;
}

void Renderer::Parts::takeScene(const scene::Scene& newScene, const settings::Settings& settings) {
  warpsAlongUvs = clothsWithWarpAlongUvs(newScene, settings);
  const io::RenderMesh& mesh = newScene.renderMesh;
  const SurfaceCoordinates coordinates = surfaceCoordinates(mesh, newScene.cloths, newScene.model->restPositions);
  checkSize = coordinates.checkSize;
  const std::vector<Vec2> yarns = yarnCoordinates(mesh, newScene.model->restPositions,
                                                  scene::warpDirections(*newScene.model, newScene.cloths, settings));
  const MeshTopology topology{newScene.model->triangles, mesh.triangles, mesh.particle, coordinates.metres, yarns};
  cloth.setTopology(topology);
  ghost.setTopology(topology);

  Eigen::AlignedBox3d box;
  for (const Vec3& position : newScene.start.positions) {
    box.extend(position);
  }
  clothWidth = box.sizes().x();
  const scene::Decor standing = newScene.stand.value_or(scene::Decor{});
  const CreasedMesh creased = splitAtCreases(standing.positions, standing.triangles, creaseAngle);
  stand.setTopology({creased.triangles, creased.triangles, {}, {}});
  stand.setPositions(creased.positions);
  box.extend(stand.bounds());
  bodies.takeScene(newScene);

  groundCentre = {box.center().x(), newScene.groundHeight, box.center().z()};
  sceneSize = 0.5 * box.diagonal().norm();
  groundFade = std::max(smallestFade, fadeInSizes * sceneSize);
}

FrameUniforms Renderer::Parts::frameUniforms(const session::Snapshot& snapshot, const Camera& camera, int width,
                                             int height) const {
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  FrameUniforms uniforms;
  const Eigen::Matrix4f projection = camera.projectionMatrix(static_cast<double>(width) / height);
  uniforms.viewProjection = projection * camera.viewMatrix();
  uniforms.shadowFromWorld = shadowMap.fromWorld();
  uniforms.eye = camera.eye();
  uniforms.toLight << directionToLight().cast<float>(), snapshot.settings.view.shadows ? 1.0F : 0.0F;
  uniforms.viewport << w, h, 1.0F / w, 1.0F / h;
  uniforms.ground << groundCentre.cast<float>(), static_cast<float>(groundFade);
  uniforms.groundShadow << groundShadow.centre().cast<float>(), static_cast<float>(groundShadow.halfSide()), 0.0F;
  uniforms.shadowScale << static_cast<float>(shadowMap.texelSize()), static_cast<float>(2.0 * shadowMap.radius()),
      1.0F / ShadowMap::resolution, 0.0F;
  uniforms.occlusion << static_cast<float>(occlusionRadius * sceneSize), snapshot.settings.view.occlusion ? 1.0F : 0.0F,
      1.0F / projection(0, 0), 1.0F / projection(1, 1);
  return uniforms;
}

/// The meshes that cast shadows and take light from each other.
std::vector<const SmoothMesh*> Renderer::Parts::solidMeshes() const {
  std::vector<const SmoothMesh*> meshes{&cloth, &stand};
  bodies.addMeshes(meshes);
  if (hasGhost && ghostStandsBeside) {
    meshes.push_back(&ghost);
  }
  return meshes;
}

void Renderer::Parts::updateShadows(const FrameUniforms& uniforms) {
  frameBlock.upload(uniforms);
  shadowMap.draw(solidMeshes());
  shadowMap.bind(shadowUnit, shadowDepthUnit);
  groundShadow.draw();
  shadowsAreCurrent = true;
}

void Renderer::Parts::drawBackground() const {
  // Comes after the solid objects and fills the rest, so that no pixel is shaded twice.
  glDepthFunc(GL_LEQUAL);
  backgroundProgram.use();
  glBindVertexArray(nothing.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glDepthFunc(GL_LESS);
}

void Renderer::Parts::drawStand() const {
  standProgram.use();
  setLight(standProgram);
  stand.draw();
}

void Renderer::Parts::drawBodies() const {
  bodyProgram.use();
  setLight(bodyProgram);
  bodies.draw();
}

/// Sets the uniforms of cloth.frag that both cloths share.
void Renderer::Parts::setPattern(const ShaderProgram& program, const settings::Settings& settings) const {
  setLight(program);
  program.set("checkSize", static_cast<float>(checkSize));
  program.set("checkered", surfaceOf(settings) == Surface::Checker ? 1.0F : 0.0F);
}

/// Draws each cloth as its fabric.
void Renderer::Parts::drawFabrics(const settings::Settings& settings) const {
  const ShaderProgram& program = drawsWrinkles ? *fabricWrinklesProgram : fabricProgram;
  program.use();
  setLight(program);
  for (const scene::ClothPart& part : scene->cloths) {
    const settings::Settings own = scene::settingsOf(part.own, settings);
    setFabric(program, lookOf(own), own.fabric.warpAngle);
    cloth.draw(part.firstTriangle, part.triangleCount);
  }
}

void Renderer::Parts::drawField(const settings::Settings& settings) const {
  const ShaderProgram& program = settings.view.wireframe ? *fieldWireframeProgram : *fieldProgram;
  program.use();
  setPattern(program, settings);
  program.set("ghostly", 0.0F);
  program.set("shadowed", 1.0F);
  program.set("opacity", 1.0F);
  for (std::size_t i = 0; i < colours->size(); ++i) {
    program.set(("colours[" + std::to_string(i) + "]").c_str(), vectorOf((*colours)[i]));
  }
  cloth.draw();
}

void Renderer::Parts::drawCloth(const settings::Settings& settings) const {
  if (colours != nullptr) {
    drawField(settings);
    return;
  }
  // The wireframe keeps its own colours, on which the edges can be read.
  if (surfaceOf(settings) == Surface::Fabric && !settings.view.wireframe) {
    drawFabrics(settings);
    return;
  }
  const ShaderProgram& program = drawsWrinkles             ? *clothWrinklesProgram
                                 : settings.view.wireframe ? wireframeProgram
                                                           : clothProgram;
  program.use();
  setPattern(program, settings);
  program.set("ghostly", 0.0F);
  program.set("shadowed", 1.0F);
  program.set("opacity", 1.0F);
  cloth.draw();
}

/// Draws the second cloth translucent. Only its nearest layer counts, since folds would add up. Where both cloths
/// coincide, the first one is visible.
void Renderer::Parts::drawGhost(const settings::Settings& settings) const {
  const ShaderProgram& program = settings.view.wireframe ? wireframeProgram : clothProgram;
  program.use();
  setPattern(program, settings);
  program.set("ghostly", 1.0F);
  // Where the cloths intersect, their shadows on each other would be noise.
  program.set("shadowed", ghostStandsBeside ? 1.0F : 0.0F);
  program.set("opacity", ghostStandsBeside ? 1.0F : ghostOpacity);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0F, 4.0F);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  ghost.draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_EQUAL);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  ghost.draw();
  glDisable(GL_BLEND);
  glDepthFunc(GL_LESS);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void Renderer::Parts::drawGround() const {
  // The cloth must be visible where it lies on the ground.
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

void Renderer::Parts::drawMarks(const session::Snapshot& snapshot, const Camera& camera, int height,
                                std::span<const int> picked) const {
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDepthMask(GL_FALSE);
  if (snapshot.settings.view.pins) {
    marks.drawPins(markScale(height), pixelsPerMetre(camera, height));
  }
  marks.drawContacts(markScale(height));
  // Intersections and the attachment are drawn over the cloth, so that they are always visible.
  glDisable(GL_DEPTH_TEST);
  marks.drawIntersections(markScale(height));
  const std::span<const fields::ScreenColour> colourOf = pickColours();
  for (std::size_t i = 0; i < picked.size(); ++i) {
    marks.drawPicked(snapshot.positions[picked[i]], colourOf[i % colourOf.size()], markScale(height));
  }
  if (snapshot.attachment) {
    marks.drawAttachment(*snapshot.attachment, markScale(height));
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

void Renderer::draw(const session::Snapshot& snapshot, const Camera& camera, int width, int height,
                    const PictureExtras& extras) {
  Parts& parts = *parts_;
  const settings::Settings::View& view = snapshot.settings.view;
  parts.take(snapshot);
  parts.takeField(extras.field);
  parts.takeWrinkles(snapshot);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (view.shadows && !parts.shadowsAreCurrent) {
    Eigen::AlignedBox3d box = parts.cloth.bounds();
    box.extend(parts.stand.bounds());
    box.extend(parts.bodies.bounds());
    if (parts.hasGhost && parts.ghostStandsBeside) {
      box.extend(parts.ghost.bounds());
    }
    parts.shadowMap.fit(box, directionToLight());
    parts.groundShadow.fit(parts.shadowMap, parts.groundCentre.y(), directionToLight());
    parts.updateShadows(parts.frameUniforms(snapshot, camera, width, height));
  }
  parts.frameBlock.upload(parts.frameUniforms(snapshot, camera, width, height));
  parts.shadowMap.bind(shadowUnit, shadowDepthUnit);
  if (view.occlusion) {
    parts.occlusion.draw(parts.solidMeshes(), width, height);
    parts.occlusion.bind(occlusionUnit);
  }

  parts.framebuffer.begin(width, height);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  parts.drawStand();
  parts.drawBodies();
  parts.drawCloth(snapshot.settings);
  const bool isAbove = camera.isOrthographic() ? scene::viewOffset(camera.pose()).y() > 0.0
                                               : camera.pose().position.y() > parts.groundCentre.y();
  if (view.ground && isAbove) {
    parts.drawGround();
  }
  parts.drawBackground();
  if (parts.hasGhost) {
    parts.drawGhost(snapshot.settings);
  }
  parts.drawMarks(snapshot, camera, height, extras.picked);
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

}  // namespace drape::render
