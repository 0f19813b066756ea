#pragma once

#include "sim/vector.hpp"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace drape {

/// How a surface lies around a vertex.
struct SurfaceShape {
  Eigen::Vector3f normal;  ///< unit length; the mean of the triangles' normals weighted by their area
  float curvature = 0.0F;  ///< mean curvature [1/m], positive where the surface is hollow when seen from the front
};

/// The shape of a mesh at its vertices. A vertex without any area around it gets a normal that points up.
class SurfaceShapes {
 public:
  /// Computes all shapes anew. No memory is allocated while the number of positions stays the same.
  void compute(std::span<const Vec3> positions, std::span<const Triangle> triangles);

  [[nodiscard]] std::span<const SurfaceShape> values() const { return shapes_; }

 private:
  /// What is summed over the triangles of a vertex.
  struct Sums {
    Eigen::Vector3f twiceArea;     ///< times the normal [m^2]
    Eigen::Vector3f toNeighbours;  ///< vectors along the edges [m]
    float squaredLengths = 0.0F;   ///< of the same edges [m^2]
  };

  std::vector<Sums> sums_;
  std::vector<SurfaceShape> shapes_;
};

}  // namespace drape
