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
  /// A vector with a fourth component of zero, so that one instruction takes all of it.
  using Lanes [[gnu::vector_size(16)]] = float;

  /// Computes all shapes anew. No memory is allocated while the number of positions stays the same.
  void compute(std::span<const Vec3> positions, std::span<const Triangle> triangles);

  [[nodiscard]] std::span<const SurfaceShape> values() const { return shapes_; }

 private:
  /// What is summed over the triangles of a vertex.
  struct Sums {
    Lanes twiceArea{};     ///< times the normal [m^2]
    Lanes toNeighbours{};  ///< vectors along the edges [m]
    Lanes squares{};       ///< of their components [m^2]
  };

  void sumUp(std::span<const Triangle> triangles);
  static SurfaceShape shapeOf(const Sums& sums);

  std::vector<Lanes> places_;  // [m]
  std::vector<Sums> sums_;
  std::vector<SurfaceShape> shapes_;
};

}  // namespace drape
