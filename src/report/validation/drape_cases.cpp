#include "report/validation/cases.hpp"
#include "report/validation/drape_disc.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace drape::report::validation {
namespace {

constexpr double notAtRest = std::numeric_limits<double>::quiet_NaN();

/// The report has a picture of these presets, on a mesh that is neither coarse nor large.
bool isPictured(const CaseMesh& mesh) {
  constexpr std::array<std::string_view, 4> presets{"silk", "cotton", "denim", "leather"};
  return mesh.resolution == 24 && std::ranges::find(presets, mesh.subject) != presets.end();
}

double coefficientOf(const DrapedDisc& draped) {
  return draped.converged ? drapeCoefficient(shadowOf(draped.positions, draped.disc.sheet.mesh.triangles)) : notAtRest;
}

/// The mean depth of the rim below the support [m].
double depthOfRim(const DrapedDisc& draped) {
  const std::vector<int> rim = rimOf(draped.disc);
  double depth = 0.0;
  for (const int vertex : rim) {
    depth -= draped.positions[vertex].y() / static_cast<double>(rim.size());
  }
  return draped.converged ? depth : notAtRest;
}

/// The mesh with once the vertices, which the others are compared with.
CaseMesh onceTheVertices(const CaseMesh& mesh) {
  CaseMesh once = mesh;
  once.resolution = 24;
  return once;
}

}  // namespace

Comparison cusick(const CaseMesh& mesh) {
  const fabrics::Preset& preset = *fabrics::findPreset(mesh.subject);
  const DrapedDisc draped = drapedDisc(cusickDisc, preset, mesh);
  const std::vector<Triangle>& triangles = draped.disc.sheet.mesh.triangles;
  const fabrics::DrapeRange range = preset.drape.value_or(fabrics::DrapeRange{});
  return {
      .measured = coefficientOf(draped),
      .exact = range.lower,
      .upper = range.upper,
      .note = fmt::format("{} folds{}", foldsOf(shadowOf(draped.positions, triangles)),
                          draped.converged ? "" : ", not at rest"),
      .shape = isPictured(mesh) ? std::make_shared<DrapedShape>(DrapedShape{draped.positions, triangles}) : nullptr};
}

Comparison remeshedDisc(const CaseMesh& mesh) {
  constexpr double points = 3.0;
  const fabrics::Preset& preset = *fabrics::findPreset(mesh.subject);
  const double once = coefficientOf(drapedDisc(cusickDisc, preset, onceTheVertices(mesh)));
  return {
      .measured = coefficientOf(drapedDisc(cusickDisc, preset, mesh)), .exact = once - points, .upper = once + points};
}

Comparison remeshedCape(const CaseMesh& mesh) {
  constexpr DiscForm cape{.radius = 0.25, .support = 0.13};
  const fabrics::Preset& preset = *fabrics::findPreset(mesh.subject);
  return {.measured = depthOfRim(drapedDisc(cape, preset, mesh)),
          .exact = depthOfRim(drapedDisc(cape, preset, onceTheVertices(mesh)))};
}

}  // namespace drape::report::validation
