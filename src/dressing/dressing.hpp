#pragma once

#include "dressing/fitting.hpp"
#include "dressing/placement.hpp"

#include <functional>
#include <vector>

namespace drape::dressing {

/// What dressing does at the moment.
enum class Stage { Shrinking, Placing, Growing, Settling };

/// How to dress a body.
struct DressingOptions {
  PlacementRule rule = PlacementRule::Auto;
  Vec3 move = Vec3::Zero();    ///< after the placement [m]
  double turn = 0.0;           ///< about the vertical through the middle of the garment, after the placement [rad]
  sim::StepParameters step;    ///< material, contact and threads
  double maxSettleTime = 4.0;  ///< after the growth, while pairs are left [s]
  /// Called often with the share of the stage that is done, 0 to 1. An exception that it throws ends the dressing.
  std::function<void(Stage, double)> progress = [](Stage, double) {};
};

/// The intersecting pairs of triangles of a garment.
struct Pairs {
  std::size_t body = 0;  ///< with the body
  std::size_t self = 0;  ///< with itself
  [[nodiscard]] std::size_t all() const { return body + self; }
};

/// A dressed body.
struct Dressed {
  Placement placement;  ///< with `move` and `turn`
  /// Whether a shrunk body is outside the triangles of the garment, and the garment outside it. Otherwise nothing was
  /// moved.
  bool fits = true;
  int openings = 0;     ///< of the garment
  int filledHoles = 0;  ///< of the body
  /// Whether it is open at the front and without sleeves, so that nothing but its own shape keeps it on the shoulders.
  bool isOpenCape = false;
  Pairs before;  ///< where the garment was placed
  Pairs after;
  std::vector<Fault> placedFaults;  ///< what is wrong with the shrunk body where the garment was placed
  std::vector<Fault> faults;        ///< what is wrong at the end
  double stretch = 0.0;             ///< at the end, of the tightest twentieth of the edges: 0.1 is a tenth longer [-]
  double shrunk = 0.0;              ///< the way of the vertex that moved most while the body was shrunk [m]
  std::vector<Vec3> positions;      ///< of the garment [m]
};

/// What is wrong with the meshes, so that they cannot be dressed.
enum class Misfit { None, OpenBody, NoVolume, GarmentTooLarge, GarmentTooSmall };

/// The largest extent of a garment over that of the body, for both limits [-].
inline constexpr double largestRatio = 4.0;
inline constexpr double smallestRatio = 0.02;

/// The holes of a body are filled if their area is at most this share of the body's surface [-]. A sheet, a vessel or
/// half of a person has larger ones.
inline constexpr double largestHoles = 0.15;

/// @param body, garment in the scene [m]
[[nodiscard]] Misfit misfitOf(const sim::ClothMesh& garment, const sim::ClothMesh& body);

/// Finds the place of a garment on a body, and leaves the intersections: the first step of dress().
/// @param start of the garment, in the coordinates of its file [m]  @param body as for dress()
[[nodiscard]] Placement placeOn(const sim::ClothModel& model, const std::vector<Vec3>& start,
                                const sim::ClothMesh& body, const DressingOptions& options);

/// Places a garment on a body and removes all intersections: the body is shrunk until no triangle of the garment passes
/// through it, as little as possible, and grows again while it pushes the garment outwards (Fitting). The result is
/// judged by the exact intersection test.
/// @param model of the garment, without pins  @param start positions in the coordinates of its file [m]
/// @param body its triangles are counter-clockwise from outside, and its holes are filled [m]
[[nodiscard]] Dressed dress(const sim::ClothModel& model, const std::vector<Vec3>& start, const sim::ClothMesh& body,
                            const DressingOptions& options);

}  // namespace drape::dressing
