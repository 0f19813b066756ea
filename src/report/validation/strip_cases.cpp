#include "report/validation/cases.hpp"
#include "report/validation/closed_forms.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/measures/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

/// The tests of Romero et al. 2021, Physical validation of simulators in computer graphics, that a sheet can show:
/// lateral buckling and stick-slip. Their cantilever is among the cases of bending.
namespace drape::report::validation {

/// A strip on edge, clamped at one end. Searches the weight from which on the straight strip is unstable.
Comparison lateralBuckling(const CaseMesh& mesh) {
  constexpr double gravity = 9.81;    // [m/s^2]
  constexpr double freeLength = 0.2;  // [m]
  constexpr double width = freeLength / 10.0;
  constexpr double bending = 1e-4;  // D_11 [N m]
  const sim::fabric::Material material = stiffSheet(bending);
  const double cell = freeLength / (mesh.resolution - 0.5);
  const TestSheet sheet = testSheet({.start = -0.5 * cell,
                                     .length = freeLength + 0.5 * cell,
                                     .width = width,
                                     .along = mesh.resolution,
                                     .across = std::max(2, mesh.resolution / 10),
                                     .straight = 2},
                                    mesh.kind);
  const double exact = lateralBucklingWeight(bending, sim::fabric::bendMatrix(material)(2, 2), width, freeLength);
  const auto model = clothOf(sheet, material, exact / gravity, sheet.verticesOf(0, 1));
  const auto isStable = [&](double share) {
    std::vector<Vec3> weights;
    for (const Vec3& weight : sim::weightsOf(*model, share * gravity)) {
      weights.emplace_back(0.0, 0.0, weight.y());  // the width of the sheet, along z, is vertical
    }
    const sim::Equilibrium straight = sim::equilibriumUnder(*model, weights, model->restPositions, {}, mesh.stop);
    return sim::isStableAt(*model, straight.positions);
  };
  double low = 0.9;
  double high = 1.2;
  constexpr int halvings = 10;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (isStable(middle) ? low : high) = middle;
  }
  return {.measured = 0.5 * (low + high) * exact, .exact = exact};
}

namespace {

/// A strip without weight that stands upright between a clamp above and a floor below.
struct PressedStrip {
  std::shared_ptr<const sim::ClothModel> model;  // the clamp is pinned
  std::vector<Vec3> positions;                   // in equilibrium while the lower end sticks [m]
  std::vector<int> lowerEnd;                     // vertices
  double floor = 0.0;                            // height of the lower end [m]
  bool converged = false;
};

/// A strip of length 1 in the shape of small deflections, whose ends have approached by about `shortening`.
Vec2 bentShape(double share, double shortening) {
  constexpr double k = 4.493409457909064;  // k = tan(k)
  const double amplitude = std::sqrt(4.0 * shortening) / (k * std::abs(std::sin(k)));
  return {amplitude * (std::sin(k * share) - share * std::sin(k)), share * (1.0 - shortening)};
}

PressedStrip pressedStrip(double shortening, const CaseMesh& mesh) {
  constexpr double freeLength = 0.2;  // [m]
  constexpr double bending = 1e-4;    // [N m]
  constexpr double density = 0.2;     // [kg/m^2]
  const TestSheet sheet = cantilever(freeLength, mesh);
  PressedStrip strip{.model = clothOf(sheet, stiffSheet(bending), density, sheet.verticesOf(0, 1)),
                     .positions = {},
                     .lowerEnd = sheet.verticesOf(sheet.columns - 1, sheet.columns - 1),
                     .floor = -freeLength * (1.0 - shortening)};
  // The sheet lies along x, with the clamp at the origin. It is put upright and bent.
  for (const Vec3& flat : sheet.mesh.positions) {
    const Vec2 bent = freeLength * bentShape(1.0 - std::max(0.0, flat.x()) / freeLength, shortening);
    const double height = flat.x() > 0.0 ? bent.y() + strip.floor : -flat.x();
    strip.positions.emplace_back(flat.x() > 0.0 ? bent.x() : 0.0, height, flat.z());
  }
  std::vector<bool> pinned = strip.model->pinned;
  for (const int vertex : sheet.verticesOf(0, 1)) {
    strip.positions[vertex] = Vec3(0.0, -sheet.mesh.positions[vertex].x(), sheet.mesh.positions[vertex].z());
  }
  for (const int vertex : strip.lowerEnd) {
    pinned[vertex] = true;
  }
  sim::Equilibrium found =
      sim::equilibriumUnder(*sim::withPins(*strip.model, pinned),
                            std::vector<Vec3>(strip.positions.size(), Vec3::Zero()), strip.positions, {}, mesh.stop);
  strip.positions = std::move(found.positions);
  strip.converged = found.converged;
  return strip;
}

}  // namespace

/// The friction that the lower end of a pressed strip needs, from the forces of the strip on the floor.
Comparison stickSlip(const CaseMesh& mesh) {
  constexpr double shortening = 0.1;
  const PressedStrip strip = pressedStrip(shortening, mesh);
  Vec3 force = Vec3::Zero();
  for (const int vertex : strip.lowerEnd) {
    force += sim::fabric::elasticForceOn(*strip.model, strip.positions, static_cast<std::size_t>(vertex));
  }
  return {.measured = strip.converged ? std::abs(force.x() / force.y()) : std::numeric_limits<double>::quiet_NaN(),
          .exact = frictionOfPressedStrip(shortening)};
}

}  // namespace drape::report::validation
