#pragma once

#include "figure/skin.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace drape::figure {

/// The measures of a body. Absent: as the figure is built.
struct Proportions {
  std::optional<double> height;    ///< [m]
  std::optional<double> chest;     ///< circumference [m]
  std::optional<double> waist;     ///< circumference [m]
  std::optional<double> hip;       ///< circumference [m]
  std::optional<double> shoulder;  ///< between the joints of the upper arms [m]

  bool operator==(const Proportions&) const = default;
};

/// A measure with its key in scene files, what it means, and its range [m].
struct ProportionInfo {
  std::string_view key;
  std::string_view title;
  double min = 0.0;
  double max = 0.0;
  std::optional<double> Proportions::*value = nullptr;
};
[[nodiscard]] std::span<const ProportionInfo> proportionTable();

/// A figure in the rest pose.
struct FigureShape {
  PerJoint<Vec3> places;        ///< of the joints [m]
  std::vector<Vec3> positions;  ///< of the vertices [m]
};

/// All measures of a figure. A circumference is that of a tape, which spans hollows.
[[nodiscard]] Proportions measured(const FigureShape& figure, std::span<const Triangle> triangles,
                                   std::span<const SkinWeights> weights);

/// The figure with these proportions. The trunk changes its width and depth by a factor that varies smoothly with
/// height; the arms move with the shoulders; the height changes all heights alike.
/// @param figure as it is built
[[nodiscard]] FigureShape withProportions(const FigureShape& figure, std::span<const Triangle> triangles,
                                          std::span<const SkinWeights> weights, const Proportions& wanted);

}  // namespace drape::figure
