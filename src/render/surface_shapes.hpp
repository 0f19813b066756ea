#pragma once

#include "sim/model/vector.hpp"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace drape::render {

/// The shape of a surface at a vertex.
struct SurfaceShape {
  Eigen::Vector3f normal;  ///< unit length; the area-weighted mean of the triangles' normals
  float curvature = 0.0F;  ///< mean curvature [1/m], positive where the front side is hollow
};

/// The shape of a mesh at its vertices. A vertex without any area gets a normal that points up.
class SurfaceShapes {
 public:
  /// A vector with a fourth component of zero, so that one instruction processes it.
  using Lanes [[gnu::vector_size(16)]] = float;

  /// Computes all shapes. Allocates no memory while the number of positions stays the same.
  void compute(std::span<const Vec3> positions, std::span<const Triangle> triangles);

  [[nodiscard]] std::span<const SurfaceShape> values() const { return shapes_; }

 private:
  /// Sums over the triangles of a vertex.
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

}  // namespace drape::render
