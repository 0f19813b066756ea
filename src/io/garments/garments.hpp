#pragma once

#include "io/mesh_import.hpp"

#include <string>
#include <vector>

namespace drape::io {

/// The positions of the garments, in metres, y up, above a ground at y = 0. They are symmetric to x = 0, with the front
/// towards +z.
namespace garment {

inline constexpr double waistHeight = 1.05;  ///< the skirt's upper border
inline constexpr double waistRadius = 0.13;
inline constexpr double hipHeight = 0.93;  ///< the height of the skirt's second hoop
inline constexpr double hemHeight = 0.38;  ///< the skirt's lower border

inline constexpr double shoulderHeight = 1.45;     ///< the T-shirt's and the poncho's upper line, at z = 0
inline constexpr double shoulderHalfWidth = 0.24;  ///< from the middle to where the T-shirt's sleeves begin

inline constexpr double flagTop = 2.4;      ///< of the flag's upper corner
inline constexpr double railHeight = 2.27;  ///< of the curtain rail's axis
inline constexpr double railLength = 1.9;

inline constexpr double patternDistance = 0.21;  ///< of the flat pieces of the dress from the plane between them

inline constexpr double tableHeight = 0.74;
inline constexpr double tableRadius = 0.45;

/// The height of the T-shirt's shoulder line over x = 0 .. shoulderHalfWidth (and mirrored): level near the neck, then
/// falling [m].
[[nodiscard]] double shoulderLine(double x);

/// The radius of the skirt at hipHeight: a cone whose flat pattern is half a disc widens by this much from the waist
/// [m].
[[nodiscard]] double hipRadius();

}  // namespace garment

/// A flared skirt of two panels, each a quarter of a ring, sewn at x = -r and x = r, smooth down to the hips and folded
/// below. Triangulated, with texture coordinates in metres that are split at the seams, like the following garments.
[[nodiscard]] RawMesh makeSkirt();

/// The same skirt with edges of about this length [m], 1 cm to 10 cm.
[[nodiscard]] RawMesh makeSkirtOfEdges(double edgeLength);

/// A square poncho of a front and a back, sewn along the shoulder line y = shoulderHeight, z = 0 and folded over it.
[[nodiscard]] RawMesh makePoncho();

/// A T-shirt: front and back, and two sleeves, sewn at shoulders, sides and armholes.
[[nodiscard]] RawMesh makeTshirt();

/// The T-shirt with a hem at the hips. It leaves room for the fitted skirt below it.
[[nodiscard]] RawMesh makeShortTshirt();

/// A skirt for the figure, of a front and a back. Its waist is narrower than the figure's hips, so that it cannot slide
/// over them.
[[nodiscard]] RawMesh makeFittedSkirt();

/// A sleeveless dress for the figure, of a front and a back, sewn at the shoulders and sides.
[[nodiscard]] RawMesh makeDress();

/// The flat front and back of this dress, before and behind the figure, not sewn.
[[nodiscard]] RawMesh makeDressPattern();

/// The stand of the skirt: base, pole, and hoops at its waist and hips. No texture coordinates, like the following
/// solids.
[[nodiscard]] RawMesh makeSkirtStand();

/// The stand of the T-shirt and the poncho: base, pole, and a shoulder bar just below their shoulder lines.
[[nodiscard]] RawMesh makeHangerStand();

/// A pole for a flag whose upper corner is at x = 0, y = flagTop.
[[nodiscard]] RawMesh makeFlagPole();

/// A rail between two posts, for a curtain that hangs at z = 0.
[[nodiscard]] RawMesh makeCurtainRail();

/// A figure on a stand for the T-shirt: head, trunk, arms and upper legs, in one smooth closed surface.
[[nodiscard]] RawMesh makeMannequin();

/// The whole figure, with the trunk, the arms and the head of the mannequin, in one smooth closed surface. Its joints
/// are those of figure::skeleton in the rest pose. It stands on the ground at y = 0.
[[nodiscard]] RawMesh makeFigure();

/// A gliding figure, in one smooth closed surface. It faces +z and stands above the ground at y = 0.
[[nodiscard]] RawMesh makeSkater();

/// A cape around the skater's shoulders, open in front. Its upper border is level, at y = 1.462.
[[nodiscard]] RawMesh makeCape();

/// A round table with one leg.
[[nodiscard]] RawMesh makeTable();

/// A mesh file to be written.
struct GarmentFile {
  std::string name;  ///< "skirt.obj"
  std::string text;
};

/// All of the above, welded and as OBJ text.
[[nodiscard]] std::vector<GarmentFile> garmentFiles();

}  // namespace drape::io
