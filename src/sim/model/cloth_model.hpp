#pragma once

#include "sim/model/ragged_rows.hpp"
#include "sim/model/vector.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::sim {

namespace fabric {
struct Fabric;
}

/// A spring between two vertices. One for each edge of the mesh.
struct Spring {
  int a = 0;                       ///< vertex index, a < b
  int b = 0;                       ///< vertex index
  double restLength = 0.0;         ///< [m]
  double relativeStiffness = 1.0;  ///< factor on the stiffness of the settings [-]
};

/// A spring, seen from one of its ends.
struct SpringEnd {
  int neighbour = 0;  ///< vertex at the other end
  int spring = 0;     ///< index into ClothModel::springs
};

/// How the mass of the cloth is distributed over its vertices.
enum class MassLumping {
  Uniform,  ///< the same mass at every vertex, as in the paper
  Area,  ///< proportional to a third of the adjacent triangles' rest area, so that results do not depend on the mesh's
         ///< resolution
};

/// A triangle mesh in its rest shape, from which a cloth is built.
struct ClothMesh {
  std::vector<Vec3> positions;      ///< rest positions [m], one a vertex
  std::vector<Triangle> triangles;  ///< indices into positions
};

/// The constant data of a cloth: rest mesh, springs, masses and pins. Immutable once built; a change of mass or pins
/// makes a new model.
struct ClothModel : std::enable_shared_from_this<ClothModel> {
  std::vector<Vec3> restPositions;   ///< [m]
  std::vector<Triangle> triangles;   ///< front is counter-clockwise
  std::vector<Spring> springs;       ///< one for each edge of the mesh, sorted by (a, b)
  RaggedRows<SpringEnd> springEnds;  ///< the springs of each vertex, by ascending neighbour
  RaggedRows<int> vertexTriangles;   ///< the triangles of each vertex, ascending
  std::vector<double> vertexArea;    ///< a third of the adjacent triangles' rest area [m^2]
  std::vector<double> vertexMass;    ///< [kg]
  std::vector<bool> pinned;          ///< true for fixed vertices
  std::vector<int> clothOf;          ///< which cloth each vertex belongs to; empty: there is one cloth
  double unitFrequency = 0.0;  ///< largest local angular frequency [1/s], for springs of 1 N/m; see local_frequency.hpp
  double unitDampingRate = 0.0;  ///< largest 2 n_i / m_i, for a damping of 1 N s/m [1/s]
  double stiffestSpring = 1.0;   ///< largest relativeStiffness [-]; 1 without springs
  /// Whether the rest lengths and areas are those of a flat pattern (fabric::withPattern) instead of restPositions.
  bool hasPattern = false;
  /// Membrane and bending (sim/fabric/fabric.hpp), which replace the springs' forces. Null: springs.
  std::shared_ptr<const fabric::Fabric> fabric;
  /// Largest stiffness of the fabric at each vertex [N/m], with stiffening. Empty: springs.
  std::vector<double> fabricStiffness;

  /// Whether two vertices belong to the same cloth. Only then does their distance at rest mean anything.
  [[nodiscard]] bool areInOneCloth(int a, int b) const { return clothOf.empty() || clothOf[a] == clothOf[b]; }
  [[nodiscard]] int vertexCount() const { return static_cast<int>(restPositions.size()); }
  /// True if all springs are equally stiff.
  [[nodiscard]] bool evenlyStiff() const;
  [[nodiscard]] double restArea() const;   ///< [m^2]
  [[nodiscard]] double totalMass() const;  ///< [kg]
};

/// The springs of each vertex, by ascending neighbour.
[[nodiscard]] RaggedRows<SpringEnd> springEndsOf(const std::vector<Spring>& springs, std::size_t vertexCount);

/// The index of the spring between two vertices; -1 if there is none. @param ends of springEndsOf
[[nodiscard]] int springBetween(const RaggedRows<SpringEnd>& ends, int vertex, int neighbour);

/// Diagonal of the bounding box of a cloth's rest shape [m], the unit of relative distances.
[[nodiscard]] double diagonalOf(const ClothModel& model);

/// Sum of the triangles' areas [m^2]. Throws ClothModelError as buildClothModel does.
[[nodiscard]] double restAreaOf(const ClothMesh& mesh);

/// Builds springs, adjacency, areas and masses. `pins` are vertex indices.
/// Throws ClothModelError for an empty mesh, an index out of range, a position that is not finite or a mass that is not
/// positive.
[[nodiscard]] std::shared_ptr<const ClothModel> buildClothModel(const ClothMesh& mesh, double totalMass,
                                                                MassLumping lumping, const std::vector<int>& pins);

/// The masses [kg] of vertices with these areas [m^2], for a total mass [kg]. Throws ClothModelError if it is not
/// positive and finite.
[[nodiscard]] std::vector<double> lumpedMasses(std::span<const double> vertexAreas, double totalMass,
                                               MassLumping lumping);

/// The same cloth with another mass [kg]. Throws ClothModelError if it is not positive.
[[nodiscard]] std::shared_ptr<const ClothModel> withMass(const ClothModel& model, double totalMass,
                                                         MassLumping lumping);

/// The same cloth with these masses [kg], one a vertex. Throws ClothModelError if one is not positive and finite.
[[nodiscard]] std::shared_ptr<const ClothModel> withVertexMasses(const ClothModel& model, std::vector<double> masses);

/// The same cloth with springs of different stiffness. `relative` has one factor a spring on the stiffness of the
/// settings [-]. Throws ClothModelError if one is negative or not finite.
[[nodiscard]] std::shared_ptr<const ClothModel> withSpringStiffness(const ClothModel& model,
                                                                    const std::vector<double>& relative);

/// The same cloth with a fabric instead of springs. @param stiffness largest stiffness at each vertex at rest [N/m]
/// Use fabric::withFabric, which computes both.
[[nodiscard]] std::shared_ptr<const ClothModel> withFabric(const ClothModel& model,
                                                           std::shared_ptr<const fabric::Fabric> fabric,
                                                           std::vector<double> stiffness);

/// The same cloth with the rest lengths of its springs [m] and the areas of its vertices [m^2] from a pattern. Masses
/// do not change. Use fabric::withPattern, which computes both.
[[nodiscard]] std::shared_ptr<const ClothModel> withRestSizes(const ClothModel& model, std::span<const double> lengths,
                                                              std::vector<double> areas);

/// The same cloth with the rest lengths and areas of its mesh again. Masses do not change.
[[nodiscard]] std::shared_ptr<const ClothModel> withMeshSizes(const ClothModel& model);

/// The same cloth with springs instead of a fabric, of the lengths in the mesh.
[[nodiscard]] std::shared_ptr<const ClothModel> withSprings(const ClothModel& model);

/// The same model as several cloths that are not connected. `clothOf` has the cloth of each vertex.
[[nodiscard]] std::shared_ptr<const ClothModel> withCloths(const ClothModel& model, std::vector<int> clothOf);

/// The same cloth with other pins. `pinned` has one entry a vertex.
[[nodiscard]] std::shared_ptr<const ClothModel> withPins(const ClothModel& model, std::vector<bool> pinned);

}  // namespace drape::sim
