#pragma once

#include "scene/sewing.hpp"
#include "session/stretch_cause.hpp"
#include "session/timeline.hpp"
#include "sim/contact/exact/intersection_contours.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/measures/accuracy.hpp"
#include "sim/measures/energy_balance.hpp"
#include "sim/solvers/solver.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape::session {

/// The current attachment. Its target is the position of the mouse in the scene.
struct AttachmentStatus : sim::AttachmentEnds {
  Vec3 point = Vec3::Zero();  ///< the attached point of the cloth [m]
  bool pinned = false;        ///< whether the vertex nearest to the attached point is pinned
};

/// The current state of the second cloth.
struct GhostStatus {
  std::vector<Vec3> positions;  ///< one per vertex [m], without ghost.offset
  double meanDistance = 0.0;    ///< from the first cloth, averaged over the vertices [m]
  double stepSeconds = 0.0;     ///< duration of its last step [s]
  sim::StepReport stepReport;   ///< of its last step
};

/// The current state of a body.
struct BodyStatus {
  sim::contact::Pose pose;
  Vec3 shift = Vec3::Zero();        ///< set by the user, relative to its own motion [m]
  Vec3 targetShift = Vec3::Zero();  ///< that the body approaches [m]
  bool on = true;
  sim::contact::SurfaceProperties surface;
  std::optional<figure::FigureOptions> figure;  ///< what the figure does, or will do after its blend; else empty
  std::vector<Vec3> vertices;                   ///< of a deforming mesh, in its own frame [m]; otherwise empty
};

/// The state of the simulation at a step boundary. The renderer and the panels see nothing else of it.
struct Snapshot {
  std::shared_ptr<const scene::Scene> scene;
  /// The scene's model, or a successor with other masses or pins. Its pieces are apart where seams are welded.
  std::shared_ptr<const sim::ClothModel> model;
  std::vector<Vec3> positions;   ///< one per vertex [m]
  std::vector<Vec3> velocities;  ///< one per vertex [m/s]; only with view.colour_map or when observed
  /// Of the last step, one per vertex, see ContactLoads [N s]; likewise, and empty before the next step.
  std::vector<double> contactImpulses;
  /// Where a PlaceClothCommand let the scene start [m]; null: it starts as it was built.
  std::shared_ptr<const std::vector<Vec3>> placedStart;
  /// Of pins that move without a body; never null.
  std::shared_ptr<const std::vector<scene::PinPath>> pinPaths = std::make_shared<std::vector<scene::PinPath>>();
  /// The seams and the elastic bands in force; never null.
  std::shared_ptr<const scene::Sewing> sewing = std::make_shared<scene::Sewing>();
  /// The same seams by vertices of the model, and whether each of them is welded; never null.
  std::shared_ptr<const std::vector<sim::Seam>> seams = std::make_shared<std::vector<sim::Seam>>();
  std::vector<char> isWelded;
  std::int64_t step = 0;     ///< steps since the scene was loaded or reset
  std::int64_t version = 0;  ///< increases with every snapshot that differs from the one before
  /// Increases like `version`, but not while sleeping cloth only gets older: then nothing in the picture moves.
  std::int64_t pictureVersion = 0;
  double time = 0.0;            ///< simulated [s]
  settings::Settings settings;  ///< the current values
  bool paused = false;
  sim::Energy energy;
  std::optional<sim::EnergyBalance> balance;      ///< since the balance was switched on or the cloth was reset
  std::optional<sim::Accuracy> accuracy;          ///< of the last check (settings `error_check`)
  double maxStretch = 0.0;                        ///< largest (L - l0) / l0 [-]
  std::optional<StretchDiagnosis> overstretched;  ///< the cause, when maxStretch is above implausibleStretch
  double stepSeconds = 0.0;                       ///< duration of the last step, without the ghost's [s]
  sim::StepReport stepReport;                     ///< of the last step
  std::optional<TimelineStatus> timeline;         ///< while states are recorded
  double realTimeFactor = 0.0;  ///< simulated time divided by real time, recently [-]; 0 while paused or not timed
  std::optional<AttachmentStatus> attachment;
  std::optional<GhostStatus> ghost;
  std::vector<BodyStatus> bodies;                         ///< one per body of the scene
  std::vector<sim::contact::ContactPoint> contactPoints;  ///< of the last step; only with view.contacts
  /// Where the cloth intersects itself; only with view.intersections.
  std::vector<sim::contact::IntersectionSegment> intersections;
  text::Sentence message;  ///< for the status line, when something went wrong; otherwise empty
};

}  // namespace drape::session
