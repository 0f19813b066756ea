#include "report/validation/cases.hpp"
#include "report/validation/closed_forms.hpp"
#include "report/validation/test_motion.hpp"

#include <cmath>
#include <numbers>

namespace drape::report::validation {
namespace {

/// A square membrane that is stretched by a tenth in both directions and held at its sides. It starts in the shape of
/// the mode with m and n half waves.
Oscillation stretchedMembrane(int m, int n, const CaseMesh& mesh) {
  constexpr double side = 0.5;        // at rest [m]
  constexpr double stretch = 1.1;     // [-]
  constexpr double modulus = 1000.0;  // [N/m]
  constexpr double density = 0.2;     // [kg/m^2]
  constexpr double amplitude = 0.005 * side;
  sim::fabric::Material material;
  material.stretchWarp = material.stretchWeft = modulus;
  material.shear = 0.5 * modulus;
  const TestSheet sheet =
      testSheet({.length = side, .width = side, .along = mesh.resolution, .across = mesh.resolution}, mesh.kind);
  Oscillation oscillation;
  std::vector<int> frame;
  for (int vertex = 0; vertex < static_cast<int>(sheet.mesh.positions.size()); ++vertex) {
    const Vec3& rest = sheet.mesh.positions[vertex];
    const int column = vertex % sheet.columns;
    const int row = vertex / sheet.columns;
    const bool onSide = row == 0 || column == 0 || row + 1 == sheet.rows || column + 1 == sheet.columns;
    if (onSide) {
      frame.push_back(vertex);
    }
    const double wave =
        std::sin(std::numbers::pi * m * rest.x() / side) * std::sin(std::numbers::pi * n * rest.z() / side);
    oscillation.equilibrium.emplace_back(stretch * rest);
    oscillation.shape.emplace_back(0.0, onSide ? 0.0 : amplitude * wave, 0.0);
  }
  oscillation.model = clothOf(sheet, material, density, frame);
  oscillation.period = 1.0 / membraneFrequency(modulus, stretch, density, side, m, n);
  return oscillation;
}

/// A strip that is clamped at one end and starts in the shape of its first mode.
Oscillation clampedStrip(const CaseMesh& mesh) {
  constexpr double freeLength = 0.2;  // [m]
  constexpr double bending = 1e-4;    // [N m]
  constexpr double density = 0.05;    // [kg/m^2]
  constexpr double amplitude = 0.01 * freeLength;
  // The mode does not stretch the strip. So a soft membrane changes nothing and permits longer explicit steps.
  sim::fabric::Material material = stiffSheet(bending);
  material.stretchWarp = material.stretchWeft = 50.0;
  material.shear = 25.0;
  const TestSheet sheet = cantilever(freeLength, mesh);
  Oscillation oscillation;
  oscillation.model = clothOf(sheet, material, density, sheet.verticesOf(0, 1));
  oscillation.equilibrium = sheet.mesh.positions;
  for (std::size_t v = 0; v < oscillation.equilibrium.size(); ++v) {
    const double share = oscillation.equilibrium[v].x() / freeLength;
    oscillation.shape.emplace_back(0.0, oscillation.model->pinned[v] ? 0.0 : amplitude * cantileverMode(share), 0.0);
  }
  oscillation.period = 1.0 / cantileverFrequency(bending, density, freeLength);
  return oscillation;
}

Comparison compared(const Oscillation& oscillation, const CaseMesh& mesh, SubstepRule rule = SubstepRule::One) {
  return {.measured = frequencyOf(oscillation, mesh.subject, mesh.stop, rule), .exact = 1.0 / oscillation.period};
}

}  // namespace

Comparison membraneMode11(const CaseMesh& mesh) {
  return compared(stretchedMembrane(1, 1, mesh), mesh);
}

Comparison membraneMode22(const CaseMesh& mesh) {
  return compared(stretchedMembrane(2, 2, mesh), mesh);
}

Comparison stripMode(const CaseMesh& mesh) {
  return compared(clampedStrip(mesh), mesh);
}

Comparison substeppedStripMode(const CaseMesh& mesh) {
  return compared(clampedStrip(mesh), mesh, SubstepRule::OfWarning);
}

}  // namespace drape::report::validation
