#pragma once

namespace drape::sim {

/// The material of the cloth: springs along the edges of the mesh.
struct MaterialParameters {
  double stiffness = 100.0;  ///< k_s [N/m] of every spring
  double damping = 0.0;      ///< C_d [N s/m] of every spring
};

}  // namespace drape::sim
