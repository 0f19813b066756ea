#pragma once

namespace drape {

/// How the cloth is kept from passing through itself.
enum class SelfCollision {
  Off,
  Hash  ///< the paper's scheme (sec. 5.2): vertices hashed by cell, vertex to vertex
};

/// What contact needs to know. Each kind costs nothing while it is off, and bodies cost nothing where there are none.
struct ContactParameters {
  bool bodies = true;                       ///< the cloth is kept out of the scene's bodies
  SelfCollision self = SelfCollision::Off;  ///< the cloth is kept apart from itself
  double thickness = 0.004;                 ///< of the cloth: its layers stay that far apart [m]
  double selfThickness = 0.0;               ///< of SelfCollision::Hash [m]; 0: by the mesh, see selfThicknessOf
  double staticFriction = 0.4;              ///< of cloth on cloth [-]
  double kineticFriction = 0.3;             ///< of cloth on cloth [-]
};

}  // namespace drape
