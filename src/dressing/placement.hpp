#pragma once

#include "dressing/wearing.hpp"
#include "sim/contact/bodies/pose.hpp"

#include <functional>
#include <span>
#include <vector>

namespace drape::dressing {

/// How a garment gets its place on a body.
enum class PlacementRule {
  Auto,       ///< File if the garment is around the body there, else Landmarks, else Boxes (also if Landmarks fails)
  File,       ///< the coordinates of both files
  Landmarks,  ///< neck on neck, sleeves on arms, waist on waist, or hood over the head
  Boxes       ///< the middle above the middle, and the top at the shoulders of a person or the top of another body
};

/// Where a garment is put.
struct Placement {
  PlacementRule rule = PlacementRule::File;  ///< the one that was used; never Auto
  sim::contact::Pose pose;
};

/// Finds a place for the garment.
///
/// `Landmarks` and `Boxes` give a first guess. Around it the place is searched in steps of 2 cm, then 1 cm, where the
/// fewest triangles of the garment meet the body or its centre lines, and where the arms pass through the openings of
/// the sleeves: first in height and depth, and to the sides if no such place fits.
/// @param garment upright [m]
[[nodiscard]] Placement place(const sim::ClothMesh& garment, const ShrinkingBody& body, const BodyParts& parts,
                              PlacementRule rule, const std::function<void(double)>& progress);

/// The positions in that place.
[[nodiscard]] std::vector<Vec3> moved(std::span<const Vec3> positions, const sim::contact::Pose& pose);

}  // namespace drape::dressing
