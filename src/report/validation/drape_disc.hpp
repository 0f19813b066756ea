#pragma once

#include "report/validation/test_sheet.hpp"
#include "sim/fabric/presets.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::report::validation {

/// Cusick's drape test (BS 5058, ISO 9073-9): a disc of fabric is held between two smaller discs, and its rim hangs
/// freely. (Cusick 1968, The measurement of fabric drape.)
inline constexpr double discRadius = 0.15;     ///< [m]
inline constexpr double supportRadius = 0.09;  ///< [m]

/// A disc in the xz plane around the origin. It consists of square rings of cells; the rings outside the support are
/// circles.
///
/// The vertices of `held` are on the support. A held ring and the free one beside it share the bend at the edge of the
/// support. The disc bends as if it began in the middle between the last two held rings, so the edge of the support is
/// there.
struct DrapeDisc {
  TestSheet sheet;
  std::vector<int> held;
};

/// @param cells across the disc, a multiple of 6  @param kind as of a sheet
[[nodiscard]] DrapeDisc drapeDisc(int cells, MeshKind kind);

/// The shadow of a sheet from above, by the angle about the y axis: the largest distance of the sheet from that axis at
/// each of `shadowAngles` angles, evenly over a turn from the x axis to the z axis [m].
inline constexpr int shadowAngles = 1440;
[[nodiscard]] std::vector<double> shadowOf(std::span<const Vec3> positions, const std::vector<Triangle>& triangles);

/// The area within a shadow's outline, without that of the support, over the area of the flat disc without that of the
/// support [%].
[[nodiscard]] double drapeCoefficient(std::span<const double> shadow);

/// The number of folds: maxima of a shadow's outline that rise by a fifth of its range above the minima beside them.
[[nodiscard]] int foldsOf(std::span<const double> shadow);

}  // namespace drape::report::validation
