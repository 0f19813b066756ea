#pragma once

namespace drape::sim::contact {

/// Self-collision methods.
enum class SelfCollision {
  Off,
  Hash,   ///< the paper's method (sec. 5.2): vertices against vertices, found by a spatial hash
  Exact,  ///< vertices against triangles and edges against edges, so that nothing intersects
  Auto    ///< Exact with a solver that resolves contacts (SolverInfo::resolvesContacts), Hash with others
};

/// Parameters of contact. A kind of contact that is off costs nothing; without bodies, body contact costs nothing.
struct ContactParameters {
  bool bodies = true;                       ///< contact with the bodies of the scene
  SelfCollision self = SelfCollision::Off;  ///< self-collision
  double thickness = 0.004;                 ///< of the cloth; distance between its layers [m]
  double selfThickness = 0.0;               ///< of SelfCollision::Hash [m]; 0: from the mesh, see selfThicknessOf
  double staticFriction = 0.4;              ///< of cloth on cloth [-]
  double kineticFriction = 0.3;             ///< of cloth on cloth [-]
  double bodyFriction = 1.0;                ///< a factor on the friction of the bodies, which depends on the fabric [-]
};

}  // namespace drape::sim::contact
