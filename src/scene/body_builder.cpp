#include "scene/body_builder.hpp"

#include "io/animation_import.hpp"
#include "messages/error.hpp"
#include "scene/cached_mesh.hpp"
#include "scene/cloth_builder.hpp"
#include "scene/mesh_file.hpp"
#include "scene/unit_guess.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

namespace drape::scene {
namespace {

/// The most triangles of a body or a stand. Contact with more takes minutes to begin.
constexpr int maxTriangles = 1'000'000;

/// Import options for the meshes of bodies and stands: in metres, without progress.
io::ImportOptions bodyOptions(const settings::Settings& settings, const io::ImportWatch& watch) {
  io::ImportOptions options;
  options.use = io::MeshUse::Body;
  options.maxTriangles = maxTriangles;
  options.outliers = outlierRule(settings);
  options.watch.stop = watch.stop;
  return options;
}

/// Reads the mesh of a body or a stand. Adds its warnings to `warnings`, except for built-in meshes.
io::ImportedMesh readBodyMesh(const MeshFileSource& source, const io::ImportOptions& options,
                              std::vector<std::string>& warnings) {
  io::ImportedMesh mesh = readMesh(source, options);
  for (const std::string& warning : mesh.summary.warnings) {
    if (!source.builtIn) {
      warnings.push_back(source.path + ": " + warning);
    }
  }
  return mesh;
}

/// Reads one mesh from several files, which must have the same triangles.
std::shared_ptr<const sim::contact::MeshShape> readMeshShape(const BodyDescription& description,
                                                             io::ImportOptions options,
                                                             std::vector<std::string>& warnings) {
  options.maxTriangles = description.meshes.size() > 1 ? io::maxMovingTriangles : options.maxTriangles;
  auto shape = std::make_shared<sim::contact::MeshShape>();
  for (const MeshFileSource& source : description.meshes) {
    std::vector<std::string> others;  // warnings of later frames repeat those of the first
    io::ImportedMesh mesh = readBodyMesh(source, options, shape->frames.empty() ? warnings : others);
    for (Vec3& position : mesh.cloth.positions) {
      position *= description.scale;
    }
    if (shape->triangles.empty()) {
      shape->triangles = mesh.cloth.triangles;
    } else if (shape->triangles != mesh.cloth.triangles ||
               shape->frames.front().size() != mesh.cloth.positions.size()) {
      throw messages::InputError(
          placed(source.where, source.path + " does not have the same triangles as " + description.meshes.front().path +
                                   "; the frames of a body must be one mesh with different positions"));
    }
    shape->frames.push_back(std::move(mesh.cloth.positions));
  }
  shape->positions = shape->frames.front();
  if (shape->frames.size() == 1) {
    shape->frames.clear();
  }
  shape->frameTime = description.frameTime;
  shape->loop = description.frameLoop;
  return shape;
}

/// Reads the frames of a skeletal animation. A clip that loops ends with the pose of its start, which is one frame
/// then. @param clips set to those in the file
std::shared_ptr<const sim::contact::MeshShape> readAnimatedMesh(const BodyDescription& description,
                                                                const io::ImportWatch& watch,
                                                                std::vector<io::ClipFacts>& clips) {
  const MeshFileSource& source = description.meshes.front();
  io::AnimationOptions options{.clip = description.animation->clip,
                               .rate = description.animation->rate,
                               .metresPerUnit = description.scale,
                               .loop = description.frameLoop,
                               .blend = description.animation->blend,
                               .watch = {}};
  options.watch.stop = watch.stop;
  try {
    io::AnimatedMesh mesh = io::importAnimation(source.path, options);
    clips = std::move(mesh.clips);
    auto shape = std::make_shared<sim::contact::MeshShape>();
    shape->triangles = std::move(mesh.triangles);
    shape->frames = std::move(mesh.frames);
    if (description.frameLoop && shape->frames.size() > mesh.leadFrames + 2) {
      shape->frames.pop_back();
    }
    shape->loopStart = mesh.leadFrames;
    shape->positions = shape->frames.front();
    shape->frameTime = mesh.frameTime;
    shape->loop = description.frameLoop;
    return shape;
  } catch (const messages::InputError& error) {
    throw messages::InputError(placed(source.where, error.what()));
  }
}

/// Reads a mesh whose vertices follow a vertex cache.
std::shared_ptr<const sim::contact::MeshShape> readCachedMesh(const BodyDescription& description,
                                                              io::ImportOptions options,
                                                              std::vector<std::string>& warnings) {
  options.keepsFile = true;
  options.maxTriangles = io::maxMovingTriangles;
  const io::ImportedMesh mesh = readBodyMesh(description.meshes.front(), options, warnings);
  const CacheSource& source = *description.cache;
  try {
    const io::PointCache cache = io::importPointCache(source.path, mesh.file->positions.size(), source.rate);
    const VertexMatch match = vertexMatchOf(*mesh.file, mesh.cloth.positions.size(), cache);
    if (match.parted > 0) {
      warnings.push_back(fmt::format(
          "{}: vertices at the place of another one in the mesh move away from it ({} of them); they follow it",
          source.path, match.parted));
    }
    return cachedMesh(mesh.cloth.triangles, cache, match, description.scale, description.frameLoop);
  } catch (const messages::InputError& error) {
    throw messages::InputError(placed(source.where, error.what()));
  }
}

std::shared_ptr<const sim::contact::MeshShape> readFigure(const BodyDescription& description,
                                                          const io::ImportOptions& options,
                                                          std::vector<std::string>& warnings) {
  io::ImportedMesh mesh = readBodyMesh(description.meshes.front(), options, warnings);
  return figure::movingFigure(std::move(mesh.cloth.positions), std::move(mesh.cloth.triangles), *description.figure);
}

void scaleShape(double scale, sim::contact::PlaneShape& plane) {
  plane.halfSize *= scale;
}

void scaleShape(double scale, sim::contact::SphereShape& sphere) {
  sphere.radius *= scale;
}

void scaleShape(double scale, sim::contact::CapsuleShape& capsule) {
  capsule.radius *= scale;
  capsule.halfLength *= scale;
}

void scaleShape(double scale, sim::contact::BoxShape& box) {
  box.half *= scale;
}

/// The scale of a mesh applies to its coordinates.
void scaleShape(double /*scale*/, std::shared_ptr<const sim::contact::MeshShape>& /*mesh*/) {}

/// Puts a body with its whole motion where its placement says.
BodyDescription inPlace(BodyDescription body) {
  const Placement& placement = body.placement;
  if (placement.isNone()) {
    return body;
  }
  body.scale *= placement.scale;
  std::visit([&](auto& shape) { scaleShape(placement.scale, shape); }, body.body.shape);
  for (sim::contact::Keyframe& key : body.body.motion.keyframes) {
    key.position *= placement.scale;
  }
  body.body.motion.placement = placement.pose();
  return body;
}

sim::contact::Body bodyOf(const sim::contact::Body& stand, const Decor& surface) {
  auto shape = std::make_shared<sim::contact::MeshShape>();
  shape->positions = surface.positions;
  shape->triangles = surface.triangles;
  sim::contact::Body body = stand;
  body.shape = std::move(shape);
  return body;
}

/// The vertex of a deforming mesh that is nearest to a point at the start; -1 for other shapes.
int anchorNear(const sim::contact::BodyShape& shape, const Vec3& place) {
  const auto* mesh = std::get_if<std::shared_ptr<const sim::contact::MeshShape>>(&shape);
  if (mesh == nullptr || !(*mesh)->deforms()) {
    return -1;
  }
  const std::vector<Vec3>& positions = (*mesh)->positions;
  const auto nearest = std::min_element(positions.begin(), positions.end(), [&](const Vec3& left, const Vec3& right) {
    return (left - place).squaredNorm() < (right - place).squaredNorm();
  });
  return static_cast<int>(nearest - positions.begin());
}

}  // namespace

std::optional<Decor> readStand(const std::optional<StandDescription>& stand, const settings::Settings& settings,
                               const io::ImportWatch& watch, std::vector<std::string>& warnings) {
  if (!stand) {
    return std::nullopt;
  }
  io::ImportedMesh mesh = readBodyMesh(stand->mesh, bodyOptions(settings, watch), warnings);
  return Decor{std::move(mesh.cloth.positions), std::move(mesh.cloth.triangles)};
}

BodyDescription inMetres(BodyDescription body, double metresPerUnit, const std::string& up) {
  if (body.reading) {
    body.scale *= scene::metresPerUnit(body.reading->unit);
    body.body.motion.keyframes.front().rotation = rotationToY(body.reading->up);
  } else if (body.readLikeCloth) {
    body.scale *= metresPerUnit;
    body.body.motion.keyframes.front().rotation = rotationToY(up);
  }
  return body;
}

BuiltBodies buildBodies(const SceneDescription& description, const std::optional<MeshReading>& reading,
                        const std::optional<Decor>& stand, double groundHeight, const settings::Settings& settings,
                        const io::ImportWatch& watch, std::vector<std::string>& warnings) {
  const io::ImportOptions options = bodyOptions(settings, watch);
  const MeshReading like = reading.value_or(MeshReading());
  auto bodies = std::make_shared<std::vector<sim::contact::Body>>();
  std::vector<std::vector<io::ClipFacts>> clips;
  for (const BodyDescription& written : description.bodies) {
    const BodyDescription each = inPlace(inMetres(written, like.metresPerUnit, like.up));
    bodies->push_back(each.body);
    clips.emplace_back();
    if (each.figure) {
      bodies->back().shape = readFigure(each, options, warnings);
    } else if (each.cache) {
      bodies->back().shape = readCachedMesh(each, options, warnings);
    } else if (each.animation) {
      bodies->back().shape = readAnimatedMesh(each, watch, clips.back());
    } else if (!each.meshes.empty()) {
      bodies->back().shape = readMeshShape(each, options, warnings);
    }
  }
  if (stand && description.stand->body) {
    bodies->push_back(bodyOf(*description.stand->body, *stand));
  }
  if (description.ground) {
    bodies->push_back(*description.ground);
    bodies->back().motion.keyframes = {{0.0, Vec3(0.0, groundHeight, 0.0), Vec3::Zero()}};
  }
  return {std::move(bodies), std::move(clips)};
}

void carryPins(const SceneDescription& description, const PinGroup& group, const sim::ClothState& start,
               std::vector<sim::contact::Body>& bodies) {
  // Stand and ground come after the scene's bodies. They move no pins, and may share a name with a body.
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    sim::contact::Body& body = bodies[i];
    if (body.name != group.body) {
      continue;
    }
    const sim::contact::Pose pose = sim::contact::poseAt(body.motion, start.time);
    for (const int vertex : group.vertices) {
      const Vec3 place = pose.toLocal(start.positions[vertex]);
      body.pins.push_back({vertex, anchorNear(body.shape, place)});
    }
  }
}

}  // namespace drape::scene
