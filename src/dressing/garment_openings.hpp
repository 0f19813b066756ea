#pragma once

#include "dressing/body_parts.hpp"
#include "scene/boundary_loops.hpp"
#include "sim/model/cloth_model.hpp"

#include <optional>
#include <span>
#include <vector>

namespace drape::dressing {

/// What an opening of a garment is for. Left is the side of the wearer's left arm. A hood is open for the face.
enum class OpeningKind { Neck, Waist, LeftSleeve, RightSleeve, LeftLeg, RightLeg, Hood, Hem };

[[nodiscard]] bool isSleeve(OpeningKind kind);
[[nodiscard]] bool isLeg(OpeningKind kind);

/// An opening of a garment.
struct Opening {
  OpeningKind kind = OpeningKind::Hem;
  std::vector<int> vertices;   ///< around it, in order
  Vec3 centre = Vec3::Zero();  ///< at the start [m]
  bool hasGap = false;         ///< whether a straight line closes it, see scene::OpenNeckline
};

/// The openings of a garment, from its boundary loops. The neckline of a garment that is open from top to bottom counts
/// as an opening, with a straight line across the gap.
class GarmentOpenings {
 public:
  /// @param garment upright, its front towards +z or -z [m]
  explicit GarmentOpenings(const sim::ClothMesh& garment);

  [[nodiscard]] std::span<const Opening> all() const { return openings_; }
  /// The first of a kind; null if there is none.
  [[nodiscard]] const Opening* find(OpeningKind kind) const;
  /// Whether its front is towards -z: the neck opening is lower there, a hood, a vest or a cape is open there, or
  /// an apron hangs there. False if it cannot be told.
  [[nodiscard]] bool facesBack() const { return facesBack_; }

 private:
  void takeOpenNeckline(const sim::ClothMesh& garment, const scene::ClothPieces& pieces);
  void swapSides();

  std::vector<Opening> openings_;
  bool facesBack_ = false;
};

/// The mean of the vertices around an opening [m].
[[nodiscard]] Vec3 centreOf(const Opening& opening, std::span<const Vec3> positions);

/// A surface that spans an opening.
[[nodiscard]] sim::ClothMesh spanning(const Opening& opening, std::span<const Vec3> positions);

}  // namespace drape::dressing
