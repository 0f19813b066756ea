#pragma once

#include "sim/fabric/bending.hpp"
#include "sim/fabric/material.hpp"
#include "sim/fabric/rest_shape.hpp"
#include "sim/model/ragged_rows.hpp"
#include "sim/model/vector.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace drape::sim::fabric {

/// The shape in which a fabric has no bending moments.
enum class RestCurvature {
  Flat,  ///< woven cloth that is cut from a flat piece
  Mesh   ///< the mesh as it is: creases, pleats and moulded shapes stay
};

/// A hinge that is bent at rest. Its energy is -nu (V - V_rest). V is the signed volume of the tetrahedron of its four
/// vertices times six: V = det(x_1 - x_0, x_2 - x_0, x_3 - x_0). Together with the quadratic energy of bendingMatrix it
/// is the cubic energy of Garg, Grinspun, Wardetzky and Zorin (2007, Cubic shells). For an isometric hinge V is
/// proportional to sin(theta) and the quadratic energy to 1 - cos(theta). So their sum is least at the rest angle, for
/// all angles below 90 degrees.
struct RestMoment {
  std::array<int, 4> vertices = {};  ///< of the hinge, in the order of Hinge::vertices
  double modulus = 0.0;              ///< nu [N/m^2]
};

/// The force of a RestMoment on one of its vertices is nu (x_b - x_a) x (x_c - x_a).
struct VertexMoment {
  std::array<int, 3> others = {};  ///< the vertices a, b, c
  double modulus = 0.0;            ///< nu [N/m^2]
};

/// The rest moments of a fabric, for its edges and for its vertices.
class RestMoments {
 public:
  RestMoments() = default;

  /// The moments for which the given positions have no bending moment about any edge. None if they are flat.
  /// @param scales of bendingMatrix, one a triangle  @param positions at rest [m]
  RestMoments(const RestShape& shape, const TriangleMaterials& materials, std::span<const double> scales,
              const VertexMatrix& bending, std::span<const Vec3> positions);

  [[nodiscard]] bool empty() const { return hinges_.empty(); }
  [[nodiscard]] std::span<const RestMoment> hinges() const { return hinges_; }
  /// The moments at a vertex, by ascending hinge.
  [[nodiscard]] std::span<const VertexMoment> at(std::size_t vertex) const { return ofVertices_[vertex]; }

  /// The force on a vertex [N].
  [[nodiscard]] Vec3 forceOn(std::size_t vertex, std::span<const Vec3> positions) const;

  /// The energy of all moments [J]. With that of the bending matrix it is zero at rest.
  [[nodiscard]] double energy(std::span<const Vec3> positions) const;

  /// The most stiffness that the moments add at each vertex, at rest [N/m]: half the sum of the absolute values of a
  /// row of their second derivative, as halfRowSums.
  [[nodiscard]] std::vector<double> halfRowSums(std::span<const Vec3> positions) const;

 private:
  std::vector<RestMoment> hinges_;
  RaggedRows<VertexMoment> ofVertices_;
  double restEnergy_ = 0.0;  // of the bending matrix and the moments at rest [J]
};

}  // namespace drape::sim::fabric
