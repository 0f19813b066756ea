#pragma once

#include "scene/boundary_loops.hpp"
#include "sim/cloth_model.hpp"

#include <array>

namespace drape {

/// What the shape of a mesh says about which of its axes x, y and z points up, each for the three axes [-].
struct UpEvidence {
  std::array<double, 3> openings{};   ///< share of the openings' area that faces along the axis: neck, waist and hem do
  std::array<double, 3> asymmetry{};  ///< how far the shape is from its mirror image along the axis; 0: its own image
  std::array<double, 3> extent{};     ///< of the bounding box, as a share of the largest one
  std::array<double, 3> score{};      ///< all of that weighed up
};

/// Which axis of a mesh points up.
struct UpGuess {
  int axis = 1;         ///< 0: x, 1: y, 2: z
  double margin = 0.0;  ///< by how much its score is larger than that of the next one [-]
  UpEvidence evidence;
};

/// Guesses which axis of a garment or a body points up. A garment's neck, waist and hem face up or down; it is the same
/// on the left and the right, and often nearly so in front and behind, but not on top and below; and it is wide and
/// tall rather than deep. Where the shape says nothing, as that of a flat sheet, y it is.
[[nodiscard]] UpGuess guessUp(const ClothMesh& mesh, const ClothPieces& pieces);

}  // namespace drape
