#pragma once

#include "sim/vector.hpp"

#include <array>
#include <vector>

namespace drape {

/// A point of the cloth that is near a body. All of it in the world at the end of the step.
struct ContactConstraint {
  std::array<int, 3> vertices{};         ///< of the cloth, whose weighted sum the point is
  Vec3 weights = Vec3::Zero();           ///< summing to 1
  Vec3 normal = Vec3::UnitY();           ///< from the body to the point
  double height = 0.0;                   ///< normal . x of the body's nearest point [m]
  double offset = 0.0;                   ///< how far above that the point is to be [m]
  Vec3 bodyDisplacement = Vec3::Zero();  ///< the way of the body's nearest point over the step [m]
  double staticFriction = 0.0;           ///< [-]
  double kineticFriction = 0.0;          ///< [-]
  int body = -1;                         ///< index into the bodies of the step
};

/// The weighted sum of its vertices' values.
[[nodiscard]] Vec3 pointOf(const ContactConstraint& contact, const std::vector<Vec3>& values);

/// A plane with the whole triangle on one side and the body on the other, as one of the triangle's vertices sees it. As
/// long as no vertex crosses its planes, no triangle can meet a body.
struct SeparatingPlane {
  int vertex = 0;
  int body = 0;                 ///< index into the bodies of the step
  Vec3 normal = Vec3::UnitY();  ///< towards the cloth
  double height = 0.0;          ///< normal . x must not become less [m]
};

/// What a search for contacts finds.
struct Candidates {
  std::vector<ContactConstraint> contacts;
  std::vector<SeparatingPlane> planes;
  int overlaps = 0;             ///< triangles of the cloth that are inside a body
  double deepestOverlap = 0.0;  ///< of these [m]

  void clear() { *this = {}; }
  void append(const Candidates& more);
};

}  // namespace drape
