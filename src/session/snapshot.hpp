#pragma once

#include "scene/scene.hpp"
#include "session/stretch_cause.hpp"
#include "sim/diagnostics.hpp"
#include "sim/energy_balance.hpp"
#include "sim/solver.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape {

/// The hand, as it is.
struct GrabStatus {
  int triangle = 0;
  Vec3 barycentric = Vec3::Zero();
  Vec3 target = Vec3::Zero();  ///< where the hand is [m]
  Vec3 point = Vec3::Zero();   ///< where the held point of the cloth is [m]
  bool pinned = false;         ///< the vertex nearest to the held point is pinned
};

/// The second cloth, as it is.
struct GhostStatus {
  std::vector<Vec3> positions;  ///< one a vertex [m], where it is: not yet moved by ghost.offset
  double meanDistance = 0.0;    ///< from the first cloth, mean over the vertices [m]
  double stepSeconds = 0.0;     ///< what its last step cost [s]
  StepReport stepReport;        ///< how its last step went
};

/// A body of the scene, as it is.
struct BodyStatus {
  Pose pose;
  Vec3 shift = Vec3::Zero();  ///< by hand, from where its own motion puts it [m]
  bool on = true;
  SurfaceProperties surface;
  std::vector<Vec3> vertices;  ///< of a deforming mesh, in its own frame [m]; else empty
};

/// A picture of the running simulation at a step boundary. All that the renderer and the panels ever see of it.
struct Snapshot {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const ClothModel> model;  ///< the scene's, or a successor with other masses or pins
  std::vector<Vec3> positions;              ///< one a vertex [m]
  std::int64_t step = 0;                    ///< steps since the scene was loaded or reset
  std::int64_t version = 0;                 ///< grows with every snapshot that differs from the one before
  double time = 0.0;                        ///< simulated [s]
  Settings settings;                        ///< in force
  bool paused = false;
  Energy energy;
  std::optional<EnergyBalance> balance;           ///< of the steps since it was asked for or the cloth was reset
  double maxStretch = 0.0;                        ///< largest (L - l0) / l0 [-]
  std::optional<StretchDiagnosis> overstretched;  ///< why, when maxStretch is beyond implausibleStretch
  double stepSeconds = 0.0;                       ///< what the last step cost, without the ghost's [s]
  StepReport stepReport;                          ///< how the last step went
  double realTimeFactor = 0.0;  ///< simulated time over wall-clock time, lately [-]; 0 while paused or not timed
  std::optional<GrabStatus> grab;
  std::optional<GhostStatus> ghost;
  std::vector<BodyStatus> bodies;           ///< one for each of the scene's
  std::vector<ContactPoint> contactPoints;  ///< of the last step; only with view.contacts
  std::string message;                      ///< for the status line, when something went wrong; else empty
};

}  // namespace drape
