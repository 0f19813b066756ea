#pragma once

#include "sim/contact/body.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape {

/// The bodies of a scene while it runs: where each is, from step to step. A body follows its own motion, and a hand can
/// shift it from there; the shift goes towards its target at a bounded speed, so that cloth is swept along.
class BodyWorld {
 public:
  BodyWorld() = default;
  BodyWorld(const BodyWorld&) = delete;  // its steps point into itself
  BodyWorld& operator=(const BodyWorld&) = delete;
  BodyWorld(BodyWorld&&) = default;
  BodyWorld& operator=(BodyWorld&&) = default;
  ~BodyWorld() = default;
  /// Places every body where it is at that time [s].
  BodyWorld(std::shared_ptr<const std::vector<Body>> bodies, double time);

  /// Back to the bodies' own motion at that time, without shifts. What is switched off stays off, and surfaces stay as
  /// they are.
  void reset(double time);

  /// Where the hand wants a body to be shifted to from its own motion [m].
  void shiftTowards(std::size_t body, const Vec3& shift) { places_[body].wanted = shift; }
  void switchOn(std::size_t body, bool on);
  void setSurface(std::size_t body, const SurfaceProperties& surface);

  /// Takes the bodies along from `time` to `time + timeStep` [s].
  void advance(double time, double timeStep);

  /// The bodies that are on, over the last step that was taken. Before the first one they stand still.
  [[nodiscard]] const std::vector<BodyStep>& steps() const { return steps_; }

  [[nodiscard]] const std::vector<Body>& bodies() const { return *bodies_; }
  [[nodiscard]] const Pose& pose(std::size_t body) const { return places_[body].end; }
  [[nodiscard]] bool isOn(std::size_t body) const { return places_[body].on; }
  [[nodiscard]] const SurfaceProperties& surface(std::size_t body) const { return places_[body].surface; }
  [[nodiscard]] const Vec3& shift(std::size_t body) const { return places_[body].shift; }
  [[nodiscard]] bool movesInItself(std::size_t body) const;
  /// Of a mesh, in its own frame [m]; empty for other shapes.
  [[nodiscard]] std::span<const Vec3> vertices(std::size_t body) const;

  /// The hand moves a body no faster than this [m/s].
  static constexpr double maxDragSpeed = 4.0;

 private:
  struct Place {
    bool on = true;
    SurfaceProperties surface;
    Vec3 wanted = Vec3::Zero();  // shift [m]
    Vec3 shift = Vec3::Zero();   // as it is [m]
    Pose start;
    Pose end;
    std::vector<Vec3> startVertices;  // of a mesh that moves in itself
    std::vector<Vec3> endVertices;
  };

  void place(std::size_t body, double time);
  void collect();

  std::shared_ptr<const std::vector<Body>> bodies_ = std::make_shared<const std::vector<Body>>();
  std::vector<Place> places_;
  std::vector<BodyStep> steps_;
};

/// The positions of a mesh that moves in itself at that time [s], linear between its frames.
void meshPositionsAt(const MeshShape& mesh, double time, std::vector<Vec3>& positions);

}  // namespace drape
