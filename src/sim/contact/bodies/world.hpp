#pragma once

#include "sim/contact/bodies/body.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::sim::contact {

/// How the user has changed the prescribed motion of a body.
struct BodyShift {
  Vec3 shift = Vec3::Zero();                                 ///< present displacement from the prescribed motion [m]
  Vec3 target = Vec3::Zero();                                ///< displacement that the shift approaches [m]
  std::shared_ptr<const Deformation> deformation = nullptr;  ///< instead of that of its mesh; null: none
};

/// The bodies of a running scene and their motion in each step. A body follows its prescribed motion; the user can
/// shift it by dragging. The shift approaches its target at a bounded speed, so that the body pushes cloth and does not
/// jump through it.
class BodyWorld {
 public:
  BodyWorld() = default;
  BodyWorld(const BodyWorld&) = delete;  // steps_ point into states_
  BodyWorld& operator=(const BodyWorld&) = delete;
  BodyWorld(BodyWorld&&) = default;
  BodyWorld& operator=(BodyWorld&&) = default;
  ~BodyWorld() = default;
  /// Puts every body at its pose at that time [s].
  BodyWorld(std::shared_ptr<const std::vector<Body>> bodies, double time);

  /// Puts every body at the pose of its prescribed motion at that time [s], without shift. Surfaces and
  /// deformations stay as they are, and bodies that are off stay off.
  void reset(double time);

  /// The shifts and deformations of all bodies.
  [[nodiscard]] std::vector<BodyShift> shifts() const;
  /// Puts every body at the pose of its prescribed motion at that time [s] with its shift and its deformation.
  /// @param shifts one a body
  void resume(double time, std::span<const BodyShift> shifts);

  /// Sets the shift that a dragged body approaches, relative to its prescribed motion [m].
  void shiftTowards(std::size_t body, const Vec3& shift) { states_[body].targetShift = shift; }
  /// Sets whether the cloth collides with a body.
  void switchOn(std::size_t body, bool on);
  void setSurface(std::size_t body, const SurfaceProperties& surface);
  /// Lets a mesh that deforms follow another deformation from the next step on, also after a reset. It must continue
  /// the present positions. @param deformation for the vertices of that mesh; null: its own
  void deform(std::size_t body, std::shared_ptr<const Deformation> deformation);
  /// The deformation that a mesh follows; null for other bodies.
  [[nodiscard]] std::shared_ptr<const Deformation> deformation(std::size_t body) const;

  /// Advances the bodies from `time` to `time + timeStep` [s].
  void advance(double time, double timeStep);

  /// The motion of the bodies that are on, over the last step. Before the first step they stand still.
  [[nodiscard]] const std::vector<BodyStep>& steps() const { return steps_; }

  [[nodiscard]] const std::vector<Body>& bodies() const { return *bodies_; }
  [[nodiscard]] const Pose& pose(std::size_t body) const { return states_[body].end; }
  [[nodiscard]] bool isOn(std::size_t body) const { return states_[body].on; }
  [[nodiscard]] const SurfaceProperties& surface(std::size_t body) const { return states_[body].surface; }
  [[nodiscard]] const Vec3& shift(std::size_t body) const { return states_[body].shift; }
  [[nodiscard]] const Vec3& targetShift(std::size_t body) const { return states_[body].targetShift; }
  [[nodiscard]] bool isDeforming(std::size_t body) const;
  /// The vertices of a mesh, in its own frame [m]; empty for other shapes.
  [[nodiscard]] std::span<const Vec3> vertices(std::size_t body) const;

  /// Maximum speed at which a dragged body moves [m/s].
  static constexpr double maxDragSpeed = 4.0;

 private:
  struct BodyState {
    bool on = true;
    SurfaceProperties surface;
    Vec3 targetShift = Vec3::Zero();                 // shift to approach [m]
    Vec3 shift = Vec3::Zero();                       // current shift [m]
    std::shared_ptr<const Deformation> deformation;  // instead of that of the mesh; null: none
    Pose start;
    Pose end;
    std::vector<Vec3> startVertices;  // of a deforming mesh
    std::vector<Vec3> endVertices;
  };

  void updatePose(std::size_t body, double time);
  void placeAt(double time);
  void collect();

  std::shared_ptr<const std::vector<Body>> bodies_ = std::make_shared<const std::vector<Body>>();
  std::vector<BodyState> states_;
  std::vector<BodyStep> steps_;
};

/// The positions of a deforming mesh at that time [s]: of its deformation, or interpolated linearly between its frames.
void meshPositionsAt(const MeshShape& mesh, double time, std::vector<Vec3>& positions);

}  // namespace drape::sim::contact
