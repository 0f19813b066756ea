#pragma once

#include "sim/model/vector.hpp"

#include <array>
#include <vector>

namespace drape::sim::contact {

/// A contact between a point of the cloth and a body, in the world frame at the end of the step; or a contact between
/// two points of the cloth, where "point" means the offset between them and the body is the origin.
struct ContactConstraint {
  std::array<int, 4> vertices{};         ///< vertices of the cloth; the point is their weighted sum
  std::array<double, 4> weights{};       ///< their sum is 1 with a body, 0 between two points of the cloth
  Vec3 normal = Vec3::UnitY();           ///< from the body to the point
  double height = 0.0;                   ///< normal . x at the closest point of the body [m]
  double offset = 0.0;                   ///< required distance of the point above that [m]
  Vec3 bodyDisplacement = Vec3::Zero();  ///< displacement of the closest point of the body over the step [m]
  double staticFriction = 0.0;           ///< [-]
  double kineticFriction = 0.0;          ///< [-]
  int body = -1;                         ///< index into the bodies of the step
};

/// The weighted sum of the values of its vertices.
[[nodiscard]] Vec3 pointOf(const ContactConstraint& contact, const std::vector<Vec3>& values);

/// A half-space for one vertex of a triangle: the plane separates the whole triangle from a part of a body. If no
/// vertex crosses its planes, no triangle intersects a body.
struct SeparatingPlane {
  int vertex = 0;
  int body = 0;                 ///< index into the bodies of the step
  Vec3 normal = Vec3::UnitY();  ///< towards the cloth
  double height = 0.0;          ///< lower bound of normal . x [m]
};

/// The result of a search: candidate contacts and separating planes.
struct Candidates {
  std::vector<ContactConstraint> contacts;
  std::vector<SeparatingPlane> planes;
  int overlaps = 0;             ///< triangles of the cloth inside a body
  double deepestOverlap = 0.0;  ///< maximum depth of these [m]

  void clear() { *this = {}; }
  void append(const Candidates& more);
};

}  // namespace drape::sim::contact
