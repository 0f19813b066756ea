#pragma once

#include "sim/model/vector.hpp"

#include <array>
#include <vector>

namespace drape::sim::contact {

/// A contact between a point x of the cloth and a body, in the world frame at the end of the step. It requires
///
///     normal . x >= height + offset
///
/// For a contact between two points of the cloth x is the offset between them, and the body is the origin.
struct ContactConstraint {
  std::array<int, 4> vertices{};         ///< vertices of the cloth; x is their weighted sum
  std::array<double, 4> weights{};       ///< their sum is 1 with a body, 0 between two points of the cloth
  Vec3 normal = Vec3::UnitY();           ///< from the body to the point
  double height = 0.0;                   ///< coordinate of the closest point of the body along the normal [m]
  double offset = 0.0;                   ///< required distance of x from that point along the normal [m]
  Vec3 bodyDisplacement = Vec3::Zero();  ///< displacement of the closest point of the body over the step [m]
  double staticFriction = 0.0;           ///< [-]
  double kineticFriction = 0.0;          ///< [-]
  int body = -1;                         ///< index into the bodies of the step
};

/// The weighted sum of the values of its vertices. @param values one per vertex of the cloth
[[nodiscard]] Vec3 pointOf(const ContactConstraint& contact, const std::vector<Vec3>& values);

/// A half-space for the position x of one vertex of a triangle, normal . x >= height, in the world frame at the end of
/// the step. The plane separates the whole triangle from a part of a body. If no vertex crosses its planes, no triangle
/// intersects a body.
struct SeparatingPlane {
  int vertex = 0;
  int body = 0;                 ///< index into the bodies of the step
  Vec3 normal = Vec3::UnitY();  ///< towards the cloth
  double height = 0.0;          ///< lower bound of normal . x [m]
};

/// The result of a search: contacts and separating planes.
struct Candidates {
  std::vector<ContactConstraint> contacts;
  std::vector<SeparatingPlane> planes;
  int overlaps = 0;             ///< triangles of the cloth inside a body
  double deepestOverlap = 0.0;  ///< maximum depth of these triangles [m]

  void clear() { *this = {}; }
  void append(const Candidates& more);
};

}  // namespace drape::sim::contact
