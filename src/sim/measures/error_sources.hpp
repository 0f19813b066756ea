#pragma once

namespace drape::sim {

/// How far a motion moves away after some time when one thing changes and all else stays. Each distance is the mean
/// over the vertices [m].
struct ErrorSources {
  double time = 0.0;      ///< since the start of the motion [s]
  double method = 0.0;    ///< the solver with its steps and its limits, from accurate small steps
  double mesh = 0.0;      ///< from a mesh with four triangles for each, at the vertices of both
  double material = 0.0;  ///< from a material that is stiffer by a tenth
  double start = 0.0;     ///< from a start that is displaced by `testDisplacement`
};

/// A source of error.
enum class ErrorSource { Method, Mesh, Material, Chaos };

/// The largest distance. `Chaos` if none is larger than that of the displaced start: then the motion cannot be known.
[[nodiscard]] ErrorSource dominantSource(const ErrorSources& sources);

}  // namespace drape::sim
