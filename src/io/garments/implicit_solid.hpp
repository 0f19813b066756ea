#pragma once

#include "io/mesh_import.hpp"

#include <functional>
#include <vector>

namespace drape::io {

/// The approximate signed distance of a point from a solid's surface: negative inside, positive outside [m].
using SolidDistance = std::function<double(const Vec3&)>;

/// A round bar with two radii, optionally flattened along z.
struct TaperedBar {
  Vec3 from;              ///< centre of one end [m]
  Vec3 to;                ///< centre of the other end [m]
  double fromRadius;      ///< [m]
  double toRadius;        ///< [m]
  double flatness = 1.0;  ///< ratio of its extents along z and x [-]
};
[[nodiscard]] double distanceTo(const TaperedBar& bar, const Vec3& point);

/// An ellipsoid along the axes.
struct Ellipsoid {
  Vec3 centre;  ///< [m]
  Vec3 half;    ///< semi-axes [m]
};
[[nodiscard]] double distanceTo(const Ellipsoid& ellipsoid, const Vec3& point);

/// The union of two solids, with a fillet of about the width `fillet` [m].
[[nodiscard]] double joined(double a, double b, double fillet);

/// The surface of a solid as a closed mesh, counter-clockwise from outside: one vertex per grid cell that the surface
/// crosses (surface nets; Gibson, Constrained Elastic Surface Nets, 1998), smoothed and projected to the surface. The
/// solid must lie between `min` and `max` [m], without parts or gaps much thinner than `cell` [m]: a cell that the
/// surface crosses twice gives an edge with four faces.
[[nodiscard]] RawMesh surfaceOf(const SolidDistance& distance, const Vec3& min, const Vec3& max, double cell);

}  // namespace drape::io
