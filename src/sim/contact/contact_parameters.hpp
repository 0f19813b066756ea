#pragma once

namespace drape::sim::contact {

/// Self-collision methods.
enum class SelfCollision {
  Off,
  Hash,   ///< the paper's method (sec. 5.2): vertices against vertices, found by a spatial hash
  Exact,  ///< vertices against triangles and edges against edges, so that nothing intersects
  Auto    ///< Exact with a solver that resolves contacts (SolverInfo::resolvesContacts), Hash with others
};

/// Parameters of contact. A kind of contact that is off costs nothing. Contact with bodies costs nothing in a scene
/// without bodies.
struct ContactParameters {
  bool bodies = true;                       ///< contact with the bodies of the scene
  SelfCollision self = SelfCollision::Off;  ///< self-collision
  double thickness = 0.004;                 ///< of the cloth: the distance that its layers keep [m]
  double selfThickness = 0.0;               ///< the same for SelfCollision::Hash [m]; 0: see selfThicknessOf
  double staticFriction = 0.4;              ///< of cloth on cloth [-]
  double kineticFriction = 0.3;             ///< of cloth on cloth [-]
  double bodyFriction = 1.0;                ///< factor of the cloth's fabric on the friction of the bodies [-]
};

}  // namespace drape::sim::contact
