#pragma once

namespace drape::sim {

/// How far a motion moves away after some time when one thing changes and all else stays. Each distance is the mean
/// over the vertices [m]. That of the mesh is extrapolated to infinitely fine triangles.
struct ErrorSources {
  double time = 0.0;    ///< since the start of the motion [s]
  double method = 0.0;  ///< the solver with its steps and its limits, from accurate small steps
  double mesh = 0.0;    ///< the error of the mesh: `meshErrorFactor` times the distance from one of half the cell size
  double material = 0.0;  ///< from a material that is stiffer by a tenth
  double start = 0.0;     ///< from a start that is displaced by `testDisplacement`
};

/// The error of a mesh, as a multiple of its mean distance from one of half the cell size (Richardson): 1 / (1 - 2^-p)
/// with the order p = 1. Cloth that hangs has this order, since its deflection is concentrated at the pins.
inline constexpr double meshErrorFactor = 2.0;

/// A source of error.
enum class ErrorSource { Method, Mesh, Material, Chaos };

/// The largest distance. `Chaos` if none is larger than that of the displaced start: then the motion cannot be known.
[[nodiscard]] ErrorSource dominantSource(const ErrorSources& sources);

}  // namespace drape::sim
