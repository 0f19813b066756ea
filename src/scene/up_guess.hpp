#pragma once

#include "scene/boundary_loops.hpp"
#include "sim/model/cloth_model.hpp"

#include <array>

namespace drape::scene {

/// The evidence from the shape of a mesh for each of its axes x, y and z to point up [-].
struct UpEvidence {
  std::array<double, 3>
      openings{};                 ///< share of the openings' area that faces along the axis, as neck, waist and hem do
  std::array<double, 3> limbs{};  ///< 1 where openings of two arms or two legs are mirror images along the axis
  std::array<double, 3> asymmetry{};  ///< difference from the mirror image along the axis; 0: symmetric
  std::array<double, 3> extent{};     ///< of the bounding box, relative to the largest extent
  std::array<double, 3> score{};      ///< the weighted sum
};

/// The guessed up axis of a mesh.
struct UpGuess {
  int axis = 1;         ///< 0: x, 1: y, 2: z
  double margin = 0.0;  ///< difference of its score to the next one [-]; 0: the shape does not show it
  UpEvidence evidence;
};

/// Whether a mesh with that extent of its box is a flat sheet: thinner than 2 % of its largest side.
[[nodiscard]] bool isFlat(const Vec3& extent);

/// Guesses the up axis of a garment or a body. The neck, waist and hem of a garment face up or down; openings for arms
/// and legs, which are mirror images, do not count. The neckline of a garment that is open at the front counts. A
/// garment is symmetric left and right, often nearly so front and back, but not top and bottom. It is wide and tall
/// rather than deep. A shape without evidence, such as a flat sheet, gets y.
[[nodiscard]] UpGuess guessUp(const sim::ClothMesh& mesh, const ClothPieces& pieces);

}  // namespace drape::scene
