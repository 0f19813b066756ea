#pragma once

#include "sim/model/vector.hpp"

namespace drape::sim::contact {

/// Results and cost of contact in a contact substep, or in a whole step.
struct ContactReport {
  int bodyContacts = 0;         ///< active contacts with bodies
  int selfContacts = 0;         ///< active contacts of the cloth with itself
  int overlaps = 0;             ///< triangles of the cloth inside a body at the start
  double deepestOverlap = 0.0;  ///< maximum depth of these triangles [m]
  int infeasible = 0;           ///< vertices without a position that satisfies all their separating planes
  int crossings = 0;            ///< pairs of features of the cloth that could not be separated (SelfCollision::Exact)
  int intersections = 0;        ///< pairs of triangles of the cloth that intersect at the start (SelfCollision::Exact)
  double guardWork = 0.0;       ///< energy that the guard (PairGuard) added by moving features apart [J]
  double bodySeconds = 0.0;     ///< wall-clock time of body contact [s]
  double selfSeconds = 0.0;     ///< wall-clock time of self-collision [s]
};

/// An active contact, for drawing.
struct ContactPoint {
  Vec3 point = Vec3::Zero();    ///< [m]
  Vec3 normal = Vec3::UnitY();  ///< unit vector, towards the cloth
};

}  // namespace drape::sim::contact
