#include "io/mesh_summary.hpp"
#include "scene/body_builder.hpp"
#include "scene/cloth_builder.hpp"
#include "scene/ground.hpp"
#include "scene/pin_advice.hpp"
#include "scene/scene.hpp"
#include "scene/seam_builder.hpp"
#include "scene/usual_view.hpp"
#include "sim/model/pieces.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace drape::scene {

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
  const std::vector<int> pins = joined.pinned();
  if (!description.seams.empty() || sim::freePieces(*scene->model).empty()) {
    std::erase_if(scene->summary.warnings,
                  [](const std::string& warning) { return warning.ends_with(io::piecesNeedPins); });
  }
  std::ranges::move(seamNotes, std::back_inserter(scene->summary.warnings));
  if (joined.showsReading) {
    scene->reading = joined.reading;
  }
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
  scene->camera = usualView({description, scene->start.positions, pins, *built.bodies, scene->groundHeight});
  scene->bodies = std::move(built.bodies);
  scene->clips = std::move(built.clips);
  return scene;
}

}  // namespace drape::scene
