// The modes Place and Sew: requests of the user, and what stays when the scene is built again.
#include "app/viewer/viewer.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace drape::app {

void Viewer::on(const ui::PlacingRequest& request, const session::Snapshot& snapshot) {
  ui::UiOutput output;
  controller_.placing().on(request, snapshot, output);
  execute(output, snapshot);
}

void Viewer::startPlacing(ui::UiAction action, const session::Snapshot& snapshot) {
  ui::UiOutput output;
  controller_.place(action, snapshot, output);
  if (snapshot.placedStart && controller_.placing().isOn()) {
    output.hint = "A placement undoes the dressing; press Dress again after it";
  }
  execute(output, snapshot);
}

void Viewer::on(const ui::SewingRequest& request, const session::Snapshot& snapshot) {
  ui::UiOutput output;
  controller_.sewing().on(request, snapshot, output);
  undo_.noteCommands(output.commands);
  execute(output, snapshot);
}

void Viewer::startSewing(ui::UiAction action, const session::Snapshot& snapshot) {
  ui::UiOutput output;
  controller_.sew(action, output);
  execute(output, snapshot);
}

/// A scene that was built again has the seams and bands of its file. Those of the user stay where the mesh is the same.
void Viewer::keepSewing(const scene::Scene& built, const session::Snapshot& snapshot) {
  if (*snapshot.sewing == scene::sewingOf(snapshot.scene->description)) {
    return;
  }
  if (built.model->triangles == snapshot.scene->model->triangles) {
    simulation_.post(session::SetSewingCommand{*snapshot.sewing});
  } else {
    showNotice("The mesh has changed: your seams and elastic bands were removed");
  }
}

/// Another clip of a body leaves the cloth where it was dressed. A placement does not: the user moves the cloth with
/// it.
void Viewer::keepDressing(const scene::Scene& built, const session::Snapshot& snapshot) {
  scene::Placements before = scene::placementsOf(snapshot.scene->description);
  const scene::Placements after = scene::placementsOf(built.description);
  before.clips = after.clips;
  if (snapshot.placedStart && before == after) {
    simulation_.post(session::PlaceClothCommand{*snapshot.placedStart, true});
  }
}

/// A scene with another placement has the same vertices and bodies, so the user's pins and bodies stay. Bodies that the
/// mouse moved begin where the scene has them, as after a return to the start.
void Viewer::keepPinsAndBodies(const scene::Scene& built, const session::Snapshot& snapshot) {
  const std::vector<bool>& pinned = snapshot.model->pinned;
  if (pinned.size() == built.model->pinned.size() && pinned != built.model->pinned) {
    session::SetPinsCommand pins;
    for (std::size_t v = 0; v < pinned.size(); ++v) {
      if (pinned[v]) {
        pins.vertices.push_back(static_cast<int>(v));
      }
    }
    simulation_.post(std::move(pins));
  }
  if (pinned.size() == built.model->pinned.size()) {
    std::vector<scene::PinPath> paths = *snapshot.pinPaths;
    for (scene::PinPath& path : paths) {
      path = scene::pathOf(path.vertices, path.motion, built.start.positions);
    }
    if (paths != built.pinPaths) {
      simulation_.post(session::SetPinPathsCommand{std::move(paths), false});
    }
  }
  for (std::size_t i = 0; i < snapshot.bodies.size() && i < built.bodies->size(); ++i) {
    const session::BodyStatus& status = snapshot.bodies[i];
    const int body = static_cast<int>(i);
    if (!status.on) {
      simulation_.post(session::SwitchBodyCommand{body, false});
    }
    if (status.surface != (*built.bodies)[i].surface) {
      simulation_.post(session::SetSurfaceCommand{body, status.surface});
    }
    if (status.figure && i < built.description.bodies.size() && status.figure != built.description.bodies[i].figure) {
      simulation_.post(session::SetFigureCommand{body, *status.figure});
    }
  }
}

}  // namespace drape::app
