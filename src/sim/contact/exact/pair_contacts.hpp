#pragma once

#include "sim/contact/exact/pair_search.hpp"
#include "sim/forces/substep_contact.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// The conditions for a contact of two features, and its properties.
struct PairContactRules {
  double thickness = 0.0;           ///< distance that layers keep [m]
  double margin = 0.0;              ///< a pair is a contact if it comes closer than its thickness plus this [m]
  double separationStep = 0.0;      ///< how far a pair that is too close at the start may be moved apart [m]
  double staticFriction = 0.0;      ///< [-]
  double kineticFriction = 0.0;     ///< [-]
  std::span<const char> entangled;  ///< vertices of triangles that intersect at the start; may be empty
};

/// Whether both features have vertices of triangles that intersect at the start. Such pairs are neither contacts nor
/// guarded.
[[nodiscard]] bool isEntangled(std::span<const char> entangled, const PairVertices& vertices);

/// The distance that a pair keeps in contact [m]: the thickness, or half of the distance at rest if that is less and
/// both features belong to one cloth.
[[nodiscard]] double thicknessOfPair(const ClothModel& model, const PairVertices& vertices, double thickness);

/// Finds the contacts among the pairs of a search. The normal is that of the closest points at the start of the step.
///
/// Around a contact many pairs are near. Only those are contacts whose closest points are the closest ones of the
/// surface around them: a vertex and a point inside a triangle; a vertex and a point on the border of a triangle, if no
/// adjacent triangle is closer; two edges at interior points, if the offset does not lead along an adjacent face. The
/// others would block sliding.
/// @param start positions at the start of the step [m]  @param predicted positions at its end [m]
/// @param found the contacts are appended
void findPairContacts(const ClothModel& model, const PairSearch& search, const PairContactRules& rules,
                      std::span<const Vec3> start, std::span<const Vec3> predicted, Workers& workers, int threads,
                      std::vector<SubstepContact>& found);

}  // namespace drape::sim::contact
