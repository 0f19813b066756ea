#pragma once

#include "fabrics/presets.hpp"
#include "report/validation/test_sheet.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::report::validation {

/// A disc whose middle is held.
struct DiscForm {
  double radius = 0.15;   ///< [m]
  double support = 0.09;  ///< radius of the held part [m]
};

/// Cusick's drape test (BS 5058, ISO 9073-9): a disc of 30 cm is held between two discs of 18 cm, and its rim hangs
/// freely. (Cusick 1968, The measurement of fabric drape.)
inline constexpr DiscForm cusickDisc;

/// A disc in the xz plane around the origin. It consists of square rings of cells; the rings outside the support are
/// circles. A third of the cells across the disc are rings outside the support.
///
/// The vertices of `pinned` are on the support. The last held ring and the free one beside it share the bend at the
/// edge of the support. The disc bends as if it began in the middle between the last two held rings, so the edge of the
/// support is there.
struct Disc {
  TestSheet sheet;
  std::vector<int> pinned;
};

/// @param cells across the disc, even and at least 12  @param kind as of a sheet
[[nodiscard]] Disc discOf(const DiscForm& form, int cells, MeshKind kind);

/// The vertices of the rim.
[[nodiscard]] std::vector<int> rimOf(const Disc& disc);

/// A disc at rest under its weight.
struct DrapedDisc {
  Disc disc;
  std::vector<Vec3> positions;  ///< [m]
  bool converged = false;       ///< whether it is in equilibrium
};

/// The equilibrium of a disc of a preset, without contact. The search starts on 12 cells with four waves along the rim,
/// which have less energy than three or five to eight (found for silk, wool and leather). Each finer disc starts from
/// the equilibrium of a coarser one. So discs of all resolutions and kinds have the same folds as far as these are
/// stable.
[[nodiscard]] DrapedDisc drapedDisc(const DiscForm& form, const fabrics::Preset& preset, const CaseMesh& mesh);

inline constexpr int shadowAngles = 1440;

/// The shadow of a sheet from above, by the angle about the y axis: the largest distance of the sheet from that axis at
/// each of `shadowAngles` angles, evenly over a turn from the x axis to the z axis [m].
[[nodiscard]] std::vector<double> shadowOf(std::span<const Vec3> positions, const std::vector<Triangle>& triangles);

/// Cusick's drape coefficient: the area of the shadow without that of the support, over the area of the flat disc
/// without that of the support [%].
[[nodiscard]] double drapeCoefficient(std::span<const double> shadow);

/// The number of folds: maxima of a shadow's outline that rise by a fifth of its range above the minima beside them.
[[nodiscard]] int foldsOf(std::span<const double> shadow);

}  // namespace drape::report::validation
