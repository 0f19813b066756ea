#pragma once

#include "io/mesh_import.hpp"

#include <functional>
#include <vector>

namespace drape {

/// About how far a point is from a solid's surface: negative inside, positive outside [m].
using SolidDistance = std::function<double(const Vec3&)>;

/// A round bar that is thicker at one end, and may be flattened along z.
struct TaperedBar {
  Vec3 from;              ///< centre of one end [m]
  Vec3 to;                ///< centre of the other end [m]
  double fromRadius;      ///< [m]
  double toRadius;        ///< [m]
  double flatness = 1.0;  ///< its extent along z over that along x [-]
};
[[nodiscard]] double distanceTo(const TaperedBar& bar, const Vec3& point);

/// An ellipsoid along the axes.
struct Ellipsoid {
  Vec3 centre;  ///< [m]
  Vec3 half;    ///< semi-axes [m]
};
[[nodiscard]] double distanceTo(const Ellipsoid& ellipsoid, const Vec3& point);

/// The distance to both of two solids, joined by a fillet about as wide as `fillet` [m].
[[nodiscard]] double joined(double a, double b, double fillet);

/// The surface of a solid as a closed mesh, counter-clockwise from outside: one vertex in each cell of a grid that the
/// surface passes (surface nets; Gibson, Constrained Elastic Surface Nets, 1998), evened out and put onto the surface.
/// The solid must lie between `min` and `max` [m], and have no part or gap much thinner than `cell` [m]: a
/// cell that the surface passes twice makes an edge of four faces.
[[nodiscard]] RawMesh surfaceOf(const SolidDistance& distance, const Vec3& min, const Vec3& max, double cell);

}  // namespace drape
