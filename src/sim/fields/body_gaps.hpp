#pragma once

#include "sim/contact/bodies/body.hpp"
#include "sim/model/workers.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::sim::fields {

/// Where a body is.
struct BodyPlace {
  bool on = true;  ///< whether cloth collides with it
  contact::Pose pose;
  std::span<const Vec3> vertices;  ///< of a deforming mesh, in its own frame [m]; empty for other shapes
};

/// Distances of points to the nearest body.
class BodyGaps {
 public:
  explicit BodyGaps(std::shared_ptr<const std::vector<contact::Body>> bodies);
  BodyGaps(const BodyGaps&) = delete;
  BodyGaps& operator=(const BodyGaps&) = delete;
  ~BodyGaps();

  /// @param places one a body  @return whether a body is on
  bool moveTo(std::vector<BodyPlace> places);

  /// The signed distance of each position to the surface of the nearest body that is on [m]: negative inside a body. An
  /// open mesh has no inside. Infinite if no body is on.
  void compute(std::span<const Vec3> positions, std::span<double> gaps);

 private:
  struct Mesh;

  void meetMesh(std::size_t body, std::span<const Vec3> positions, std::span<double> gaps);

  std::shared_ptr<const std::vector<contact::Body>> bodies_;
  std::vector<BodyPlace> places_;
  std::vector<std::unique_ptr<Mesh>> meshes_;  // of each body; null for other shapes
  Workers workers_;
};

}  // namespace drape::sim::fields
