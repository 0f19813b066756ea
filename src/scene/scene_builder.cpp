#include "io/mesh_summary.hpp"
#include "scene/body_builder.hpp"
#include "scene/cloth_builder.hpp"
#include "scene/framing.hpp"
#include "scene/ground.hpp"
#include "scene/pin_advice.hpp"
#include "scene/scene.hpp"
#include "scene/seam_builder.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace drape::scene {
namespace {

/// Extends a box by the meshes of bodies at their start.
void extend(Eigen::AlignedBox3d& box, const std::vector<sim::contact::Body>& bodies) {
  for (const sim::contact::Body& body : bodies) {
    const auto* mesh = std::get_if<std::shared_ptr<const sim::contact::MeshShape>>(&body.shape);
    if (mesh == nullptr) {
      continue;
    }
    const sim::contact::Pose pose = sim::contact::poseAt(body.motion, 0.0);
    for (const Vec3& position : (*mesh)->positions) {
      box.extend(pose.toWorld(position));
    }
  }
}

/// The camera of the description, or one that shows the cloth at its start; with the bodies if they are to wear it,
/// since it is put on them afterwards.
CameraPose cameraFor(const SceneDescription& description, const std::vector<Vec3>& start,
                     const std::vector<sim::contact::Body>& bodies) {
  constexpr double usualAspect = 16.0 / 9.0;
  constexpr double boxScale = 1.15;  // margin, since cloth sags and swings beyond its start box
  Eigen::AlignedBox3d box = sim::boundsOf(start);
  if (description.parts.dressed) {
    extend(box, bodies);
  }
  const Vec3 middle = 0.5 * (box.min() + box.max());
  return description.camera.value_or(framed({Vec3(0.35, 0.2, 1.0), Vec3::Zero(), CameraPose{}.viewAngle},
                                            middle + boxScale * (box.min() - middle),
                                            middle + boxScale * (box.max() - middle), usualAspect));
}

}  // namespace

std::shared_ptr<const Scene> buildScene(const SceneDescription& description, const settings::Settings& settings,
                                        const io::ImportWatch& watch) {
  auto scene = std::make_shared<Scene>();
  scene->description = description;
  scene->settings = settings;

  constexpr double meshIsRead = 0.7;  // share of the time for building a scene from a large file
  JoinedCloths joined = joinCloths(description, settings, watch.part(0.0, meshIsRead));
  watch.tell(meshIsRead, "Building");
  scene->model = modelOf(joined, settings);
  std::vector<std::string> seamNotes;
  scene->seams = std::make_shared<const std::vector<sim::Seam>>(
      seamsOf(description.seams, joined.mesh, joined.cloths, *scene->model, {}, &seamNotes));
  scene->restPositions = std::move(joined.mesh.positions);
  watch.tell(0.95, "Building");
  scene->start = sim::stateAtRest(std::move(joined.start));
  scene->renderMesh = std::move(joined.renderMesh);
  scene->summary = std::move(joined.summary);
  scene->cloths = std::move(joined.cloths);
  if (!description.seams.empty()) {
    std::erase_if(scene->summary.warnings,
                  [](const std::string& warning) { return warning.ends_with(io::piecesNeedPins); });
  }
  std::ranges::move(seamNotes, std::back_inserter(scene->summary.warnings));
  if (joined.showsReading) {
    scene->reading = joined.reading;
  }
  const std::vector<int> pins = joined.pinned();
  scene->pinAdvice = adviceOnPins(description, settings, pins.size(), scene->start.positions.size());
  scene->stand = readStand(description.stand, settings, watch, scene->summary.warnings);
  scene->groundHeight = groundHeightOf(description, joined.unplacedStart, pins);
  BuiltBodies built = buildBodies(description, joined.reading, scene->stand, scene->groundHeight, settings, watch,
                                  scene->summary.warnings);
  for (const PinGroup& group : joined.pins) {
    carryPins(description, group, scene->start, *built.bodies);
    if (group.motion && !group.vertices.empty()) {
      scene->pinPaths.push_back(pathOf(group.vertices, *group.motion, scene->start.positions));
    }
  }
  scene->camera = cameraFor(description, scene->start.positions, *built.bodies);
  scene->bodies = std::move(built.bodies);
  scene->clips = std::move(built.clips);
  return scene;
}

}  // namespace drape::scene
