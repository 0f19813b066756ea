#include "messages/sim_error_text.hpp"
#include "scene/builtin_meshes.hpp"
#include "scene/cloth_material.hpp"
#include "scene/framing.hpp"
#include "scene/grid_mesh.hpp"
#include "scene/ground.hpp"
#include "scene/mass.hpp"
#include "scene/pin_advice.hpp"
#include "scene/pin_selection.hpp"
#include "scene/scene.hpp"
#include "scene/shape_pins.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <utility>

namespace drape::scene {
namespace {

/// Adds the place in the scene file to a message, if there is one.
std::string placed(const std::string& where, const std::string& message) {
  return where.empty() ? message : where + ": " + message;
}

io::OutlierRule outlierRule(const settings::Settings& settings) {
  return settings.mesh.outliers == "leave_out" ? io::OutlierRule::LeaveOut : io::OutlierRule::Refuse;
}

io::ImportOptions importOptions(const settings::Settings& settings, const io::ImportWatch& watch) {
  io::ImportOptions options;
  options.metresPerUnit = metresPerUnitOf(settings.mesh);
  options.weldTolerance = settings.mesh.weldTolerance;
  options.outliers = outlierRule(settings);
  options.watch = watch;
  return options;
}

/// Reads a mesh. Messages start with the place in the scene file that names it.
io::ImportedMesh readMesh(const MeshFileSource& source, const io::ImportOptions& options) {
  try {
    return source.builtIn ? io::importMeshFromMemory(source.path, builtinMesh(source.path), options)
                          : io::importMesh(source.path, options);
  } catch (const messages::InputError& error) {
    throw messages::InputError(placed(source.where, error.what()));
  }
}

PinSelection pinsInForce(const SceneDescription& description, const settings::Settings& settings) {
  if (settings.mesh.pins == "scene") {
    return description.pins;
  }
  PinSelection pins;
  if (settings.mesh.pins == "top") {
    pins.top = topOfBareMesh;
  }
  return pins;
}

/// Import options for the meshes of bodies and stands: in metres, without progress.
io::ImportOptions bodyOptions(const settings::Settings& settings, const io::ImportWatch& watch) {
  io::ImportOptions options;
  options.use = io::MeshUse::Body;
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

std::optional<Decor> readStand(const std::optional<StandDescription>& stand, const io::ImportOptions& options,
                               std::vector<std::string>& warnings) {
  if (!stand) {
    return std::nullopt;
  }
  io::ImportedMesh mesh = readBodyMesh(stand->mesh, options, warnings);
  return Decor{std::move(mesh.cloth.positions), std::move(mesh.cloth.triangles)};
}

/// Reads one mesh from several files, which must have the same triangles.
std::shared_ptr<const sim::contact::MeshShape> readMeshShape(const BodyDescription& description,
                                                             const io::ImportOptions& options,
                                                             std::vector<std::string>& warnings) {
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

/// Converts a body to metres with y up, when its files have the unit and axes of the cloth.
BodyDescription inMetres(BodyDescription body, const std::optional<MeshReading>& reading) {
  if (body.readLikeCloth && reading) {
    body.scale *= reading->metresPerUnit;
    body.body.motion.keyframes.front().rotation = rotationToY(reading->up);
  }
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

/// The bodies of the scene, then its stand, then its ground.
std::shared_ptr<std::vector<sim::contact::Body>> buildBodies(const SceneDescription& description,
                                                             const std::optional<MeshReading>& reading,
                                                             const std::optional<Decor>& stand, double groundHeight,
                                                             const io::ImportOptions& options,
                                                             std::vector<std::string>& warnings) {
  auto bodies = std::make_shared<std::vector<sim::contact::Body>>();
  for (const BodyDescription& written : description.bodies) {
    const BodyDescription each = inMetres(written, reading);
    bodies->push_back(each.body);
    if (!each.meshes.empty()) {
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
  return bodies;
}

/// The vertex of a deforming mesh that is nearest to a point at the start; -1 for other shapes.
int anchorNear(const sim::contact::BodyShape& shape, const Vec3& place) {
  const auto* mesh = std::get_if<std::shared_ptr<const sim::contact::MeshShape>>(&shape);
  if (mesh == nullptr || (*mesh)->frames.empty()) {
    return -1;
  }
  const std::vector<Vec3>& positions = (*mesh)->positions;
  const auto nearest = std::min_element(positions.begin(), positions.end(), [&](const Vec3& left, const Vec3& right) {
    return (left - place).squaredNorm() < (right - place).squaredNorm();
  });
  return static_cast<int>(nearest - positions.begin());
}

/// Attaches the pins to their body.
void carryPins(const SceneDescription& description, const std::vector<int>& pins, const sim::ClothState& start,
               std::vector<sim::contact::Body>& bodies) {
  // Stand and ground come after the scene's bodies. They move no pins, and may share a name with a body.
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    sim::contact::Body& body = bodies[i];
    if (body.name != description.pins.body) {
      continue;
    }
    const sim::contact::Pose pose = sim::contact::poseAt(body.motion, start.time);
    for (const int vertex : pins) {
      const Vec3 place = pose.toLocal(start.positions[vertex]);
      body.pins.push_back({vertex, anchorNear(body.shape, place)});
    }
  }
}

/// The imported mesh, the layout of a grid, and how a file was read.
struct Source {
  io::ImportedMesh mesh;
  std::optional<GridLayout> grid;
  std::optional<MeshReading> reading;
};

Source makeSource(const SceneDescription& description, const settings::Settings& settings,
                  const io::ImportWatch& watch) {
  if (const auto* grid = std::get_if<GridSource>(&description.source)) {
    const GridLayout layout = layoutOf(settings.grid);
    return {makeGrid(layout, grid->plane), layout, std::nullopt};
  }
  const auto& file = std::get<MeshFileSource>(description.source);
  Source source{readMesh(file, importOptions(settings, watch)), std::nullopt, std::nullopt};
  source.reading = readUpright(settings.mesh, source.mesh);
  return source;
}

std::vector<int> choosePins(const SceneDescription& description, const settings::Settings& settings,
                            const Source& source) {
  if (settings.mesh.pins == "shape") {
    return pinsByShape(source.mesh.cloth);
  }
  const PinSelection pins = pinsInForce(description, settings);
  try {
    return selectPins(pins, source.mesh.cloth.positions, source.grid ? &*source.grid : nullptr);
  } catch (const messages::InputError& error) {
    throw messages::InputError(placed(pins.where, error.what()));
  }
}

/// Moves the mesh to its position in the scene.
void placeCloth(const SceneDescription& description, std::vector<Vec3>& positions) {
  const sim::contact::Pose pose = sim::contact::poseOf(description.position, description.rotation);
  for (Vec3& position : positions) {
    position = pose.toWorld(position);
  }
}

std::vector<Vec3> startPositions(const SceneDescription& description, const Source& source) {
  std::vector<Vec3> positions = source.mesh.cloth.positions;
  if (description.pleats && source.grid) {
    applyPleats(*description.pleats, source.grid->width, positions);
  }
  placeCloth(description, positions);
  return positions;
}

}  // namespace

std::shared_ptr<const Scene> buildScene(const SceneDescription& description, const settings::Settings& settings,
                                        const io::ImportWatch& watch) {
  auto scene = std::make_shared<Scene>();
  scene->description = description;
  scene->settings = settings;

  constexpr double meshIsRead = 0.7;  // share of the time for building a scene from a large file
  Source source = makeSource(description, settings, watch.part(0.0, meshIsRead));
  watch.tell(meshIsRead, "Building");
  scene->start = sim::stateAtRest(startPositions(description, source));
  placeCloth(description, source.mesh.cloth.positions);
  const std::vector<int> pins = choosePins(description, settings, source);
  if (!source.grid) {  // the texture of a grid is made for the checker
    scene->uvs = patternUvsOf(source.mesh.render, source.mesh.cloth.positions);
  }
  scene->model = messages::withInputErrors([&] {
    const auto springs = sim::buildClothModel(
        source.mesh.cloth, totalMassOf(settings, sim::restAreaOf(source.mesh.cloth)), lumpingOf(settings), pins);
    return withMaterial(*springs, settings, scene->uvs);
  });
  watch.tell(0.95, "Building");
  scene->renderMesh = std::move(source.mesh.render);
  scene->summary = std::move(source.mesh.summary);
  const auto* file = std::get_if<MeshFileSource>(&description.source);
  if (file != nullptr && !file->builtIn) {
    scene->reading = source.reading;
  }
  scene->pinAdvice = adviceOnPins(description, settings, pins.size(), scene->start.positions.size());
  scene->stand = readStand(description.stand, bodyOptions(settings, watch), scene->summary.warnings);

  const Eigen::AlignedBox3d box = sim::boundsOf(scene->start.positions);
  scene->groundHeight = groundHeightOf(description, scene->start.positions, pins);
  const auto bodies = buildBodies(description, source.reading, scene->stand, scene->groundHeight,
                                  bodyOptions(settings, watch), scene->summary.warnings);
  carryPins(description, pins, scene->start, *bodies);
  scene->bodies = bodies;
  constexpr double usualAspect = 16.0 / 9.0;
  constexpr double boxScale = 1.15;  // margin, since cloth sags and swings beyond its start box
  const Vec3 middle = 0.5 * (box.min() + box.max());
  scene->camera = description.camera.value_or(framed({Vec3(0.35, 0.2, 1.0), Vec3::Zero(), CameraPose{}.viewAngle},
                                                     middle + boxScale * (box.min() - middle),
                                                     middle + boxScale * (box.max() - middle), usualAspect));
  return scene;
}

}  // namespace drape::scene
