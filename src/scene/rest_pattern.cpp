#include "scene/rest_pattern.hpp"

#include "messages/error.hpp"
#include "sim/fabric/fabric.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace drape::scene {
namespace {

/// A pattern whose area differs from that of the mesh by more than this factor is unlikely [-].
constexpr double unlikelyAreaRatio = 4.0;
/// A larger factor is an error [-].
constexpr double largestAreaRatio = 1e4;

/// The scale with which the pattern has the area of the mesh [m].
double matchingScale(const PatternUvs& uvs) {
  return std::sqrt(uvs.meshArea / uvs.area);
}

/// The area of the pattern divided by that of the mesh [-].
double areaRatio(const PatternUvs& uvs, const settings::Settings& settings) {
  const double scale = patternScale(uvs, settings) / matchingScale(uvs);
  return scale * scale;
}

/// "12 times" or "1/12 of".
text::Sentence asFactor(double ratio) {
  return ratio >= 1.0 ? text::Sentence("{} times", fmt::format("{:.3g}", ratio))
                      : text::Sentence("1/{} of", fmt::format("{:.3g}", 1.0 / ratio));
}

void requirePattern(const PatternUvs& uvs, const settings::Settings& settings) {
  if (!uvs.usable()) {
    throw messages::InputError(refusalOf(uvs, "fabric.rest_shape", "mesh"));
  }
  if (settings.fabric.warpFrom == "vertical") {
    throw messages::InputError(
        "fabric.rest_shape = uv takes warp from the pattern, so fabric.warp_from = vertical is not possible. Use "
        "fabric.warp_from = auto, and turn warp by fabric.warp_angle");
  }
  const double matching = matchingScale(uvs);
  if (!(matching > 0.0) || !std::isfinite(matching)) {
    throw messages::InputError(
        fmt::format("fabric.rest_shape = uv cannot be used: the pattern has an area of {:.3g} UV "
                    "units squared, the mesh one of {:.3g} m^2",
                    uvs.area, uvs.meshArea));
  }
  const double ratio = areaRatio(uvs, settings);
  if (!(std::max(ratio, 1.0 / ratio) <= largestAreaRatio)) {
    throw messages::InputError(
        fmt::format("fabric.uv_scale = {:.3g} gives the pattern {} the area of the mesh. "
                    "Use {:.3g}, or 0, which chooses this value",
                    settings.fabric.uvScale, asFactor(ratio).english(), matching));
  }
}

}  // namespace

double patternScale(const PatternUvs& uvs, const settings::Settings& settings) {
  return settings.fabric.uvScale > 0.0 ? settings.fabric.uvScale : matchingScale(uvs);
}

std::vector<sim::fabric::RestTriangle> patternOf(const PatternUvs& uvs, const settings::Settings& settings) {
  requirePattern(uvs, settings);
  const double scale = patternScale(uvs, settings);
  const double angle = settings.fabric.warpAngle * std::numbers::pi / 180.0;
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  std::vector<sim::fabric::RestTriangle> pattern;
  pattern.reserve(uvs.corners.size());
  for (const std::array<Vec2, 3>& corners : uvs.corners) {
    // Seen from the front of the cloth, weft lies to the left of warp. In a mirrored piece that is where U grows.
    const double weftOfU = twiceArea(corners) > 0.0 ? -1.0 : 1.0;
    std::array<Vec2, 3> turned;
    std::ranges::transform(corners, turned.begin(), [&](const Vec2& uv) {
      const double along = scale * uv.y();
      const double across = scale * weftOfU * uv.x();
      return Vec2(cosine * along + sine * across, cosine * across - sine * along);
    });
    pattern.push_back(sim::fabric::restTriangleOf(turned));
  }
  return pattern;
}

text::Sentence restShapeInWords(const sim::ClothModel& model, const PatternUvs& uvs,
                                const settings::Settings& settings) {
  if (!model.fabric || !model.fabric->meshStrain) {
    return text::Sentence("the mesh");
  }
  if (!settings::restsOnPattern(settings)) {
    return text::Sentence("the mesh, with elastic bands");
  }
  const auto& [median, high] = *model.fabric->meshStrain;
  return text::Sentence(
      "the pattern in the UVs, {} m a unit; the mesh is strained against it by {} % (median), {} % (99th percentile)",
      fmt::format("{:.4g}", patternScale(uvs, settings)), fmt::format("{:.1f}", 100.0 * median),
      fmt::format("{:.1f}", 100.0 * high));
}

text::Sentence restShapeNote(const sim::ClothModel& model, const PatternUvs& uvs, const settings::Settings& settings) {
  if (!model.fabric || !model.fabric->meshStrain || !settings::restsOnPattern(settings)) {
    return {};
  }
  if (const double ratio = areaRatio(uvs, settings); std::max(ratio, 1.0 / ratio) > unlikelyAreaRatio) {
    return text::Sentence("fabric.uv_scale gives the pattern {} the area of the mesh; with {} they are equal",
                          asFactor(ratio), fmt::format("{:.3g}", matchingScale(uvs)));
  }
  if (!uvs.isPattern()) {
    const auto& [median, high] = *model.fabric->meshStrain;
    return text::Sentence(
        "the UVs are unlikely to be the pattern of this mesh: it is strained against them by {} % (median), {} % (99th "
        "percentile), and more in one direction than in the other",
        fmt::format("{:.0f}", 100.0 * median), fmt::format("{:.0f}", 100.0 * high));
  }
  return {};
}

}  // namespace drape::scene
