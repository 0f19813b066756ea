#pragma once

#include "sim/fabric/bending.hpp"
#include "sim/fabric/material.hpp"
#include "sim/fabric/membrane.hpp"
#include "sim/fabric/pattern.hpp"
#include "sim/fabric/rate_limit.hpp"
#include "sim/fabric/rest_curvature.hpp"
#include "sim/fabric/rest_shape.hpp"
#include "sim/model/cloth_model.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace drape::sim::fabric {

/// Two vertices whose forces depend on each other: the ends of an edge, or two corners that bending connects.
struct VertexPair {
  int a = 0;             ///< vertex index, a < b
  int b = 0;             ///< vertex index
  double bending = 0.0;  ///< their entry of the bending matrix [N/m]
};

/// How the mesh of a cloth is related to the pattern that is its rest shape.
enum class PatternMesh {
  Strained,  ///< it is the cloth's shape at the start, strained against the pattern
  Unrelated  ///< it says nothing about any strain, as that of flat pieces after their seams are welded
};

/// What a cloth's fabric consists of: the materials, and what follows from it and from the rest shape. Constant.
struct Fabric {
  /// Triangles with a common vertex have the same material.
  TriangleMaterials materials{Material{}};
  RestShape shape;
  std::vector<MembraneTriangle> membrane;  ///< one a triangle
  std::vector<double> membraneScales;      ///< the factor on the moduli of each triangle [-]; below 1 where clamped
  VertexMatrix bending;                    ///< without rows if the fabric does not resist bending
  std::vector<double> bendingScales;       ///< the factor on the bending energy of each triangle [-]; empty likewise
  /// See halfRowSums. Empty if the fabric does not resist bending [N/m].
  std::vector<double> bendingHalfSums;
  RestCurvature restCurvature = RestCurvature::Flat;
  RestMoments restMoments;         ///< none if the rest shape is flat for bending
  std::vector<VertexPair> pairs;   ///< sorted by (a, b)
  RaggedRows<SpringEnd> pairEnds;  ///< of each vertex, by ascending neighbour; `spring` is an index into pairs
  std::vector<std::array<int, 3>> pairsOfSides;  ///< of each triangle: the pairs of its sides

  PatternMesh patternMesh = PatternMesh::Strained;  ///< of a cloth with a pattern
  /// The strain of the mesh against the pattern. Nothing if the rest shape is the mesh, or unrelated to it.
  std::optional<MeshStrain> meshStrain;
  double maxRatio = maxMembraneRatio;  ///< of the RateLimit of the membrane; that of bending is its square [-]
  int slivers = 0;                     ///< triangles whose stiffness is clamped, see sliverQuality and RateLimit

  /// A hash of the materials, the rest shape and the limit. It differs for fabrics that differ in a modulus or in the
  /// direction of warp, even if their stiffness at rest is the same.
  std::uint64_t fingerprint = 0;

  [[nodiscard]] bool bends() const { return bending.rows() > 0; }
};

/// The same cloth with a fabric instead of springs, whose rest shape is the mesh.
/// @param warp a unit vector in the plane of each triangle at rest, see warpAlong
/// @param curvature the shape without bending moments. Flat: the fabric tends to unroll, as woven cloth does.
/// Throws ClothModelError if a material is not stable (isStable), if triangles of different materials have a common
/// vertex, or if there is not one direction a triangle.
[[nodiscard]] std::shared_ptr<const ClothModel> withFabric(const ClothModel& model, const TriangleMaterials& materials,
                                                           std::span<const Vec3> warp,
                                                           RestCurvature curvature = RestCurvature::Flat);

/// The same cloth with a fabric whose rest shape is a flat sewing pattern instead of the mesh. Rest lengths and areas
/// become those of the pattern (withPattern). Masses do not change. @param pattern one for each triangle of the cloth
/// @param curvature the shape without bending moments  @param mesh how the mesh is related to the pattern
/// Throws ClothModelError as withFabric does, and if there are more or fewer triangles.
[[nodiscard]] std::shared_ptr<const ClothModel> withPatternFabric(const ClothModel& model,
                                                                  const TriangleMaterials& materials,
                                                                  std::vector<RestTriangle> pattern,
                                                                  RestCurvature curvature = RestCurvature::Flat,
                                                                  PatternMesh mesh = PatternMesh::Strained);

/// The same cloth with the stretch moduli and the stiffening of each material multiplied by a factor. Shear, bending
/// and mass are the same. @param model must have a fabric  @param scales one for each of TriangleMaterials::list,
/// above 0 [-]
[[nodiscard]] std::shared_ptr<const ClothModel> withStretchScales(const ClothModel& model,
                                                                  std::span<const double> scales);

/// The same cloth with a tighter RateLimit, so that its few smallest triangles do not determine the time step. Stretch,
/// shear and bending of these triangles become softer.
/// @param model must have a fabric  @param maxRatio as in RateLimit, of the membrane; its square is that of bending [-]
/// @return null if no triangle exceeds the tighter limit
[[nodiscard]] std::shared_ptr<const ClothModel> withTighterRateLimit(const ClothModel& model, double maxRatio);

/// The strain along warp or weft that one triangle in 100 exceeds (Green's strain), for each of TriangleMaterials::list
/// [-]. Compression counts as 0. Elastic bands do not count. @param model must have a fabric
[[nodiscard]] std::vector<double> strainsAlongYarns(const ClothModel& model, std::span<const Vec3> positions);

/// The largest stiffness of the membrane at each vertex at rest, without stiffening [N/m].
/// @param model must have a fabric
[[nodiscard]] std::vector<double> membraneStiffness(const ClothModel& model);

/// The stretch damping of each vertex's material over the largest one of the cloth [-]; 1 if none damps.
/// @param model must have a fabric
[[nodiscard]] std::vector<double> relativeStretchDamping(const ClothModel& model);

/// The smaller one of the stretch moduli along warp and weft [N/m].
[[nodiscard]] double minStretchModulus(const Material& material);

/// The same of the softest material of a cloth [N/m].
/// @param model must have a fabric
[[nodiscard]] double minStretchModulus(const ClothModel& model);

/// The elastic energy [J] of a cloth whose material is a fabric.
[[nodiscard]] double elasticEnergy(const ClothModel& model, std::span<const Vec3> positions);

/// The elastic force on a vertex [N] of a cloth whose material is a fabric.
[[nodiscard]] Vec3 elasticForceOn(const ClothModel& model, std::span<const Vec3> positions, std::size_t vertex);

/// Minus the derivative of that force by the vertex's position [N/m]. @param variant of the membrane's derivative
[[nodiscard]] Mat3 stiffnessAt(const ClothModel& model, std::span<const Vec3> positions, std::size_t vertex,
                               ForceDerivative variant);

}  // namespace drape::sim::fabric
