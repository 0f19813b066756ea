#include "fabrics/presets.hpp"
#include "report/validation/cases.hpp"
#include "report/validation/closed_forms.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/measures/equilibrium.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drape::report::validation {
namespace {

constexpr double gravity = 9.81;  // [m/s^2]

/// The tip of a cantilever under its weight, in units of its free length; NaN if no equilibrium was found.
ElasticaTip tipOf(const sim::fabric::Material& material, double density, double freeLength, const CaseMesh& mesh) {
  const TestSheet sheet = cantilever(freeLength, mesh);
  const auto model = clothOf(sheet, material, density, sheet.verticesOf(0, 1));
  const sim::Equilibrium found =
      sim::equilibriumUnder(*model, sim::weightsOf(*model, gravity), model->restPositions, {}, mesh.stop);
  Vec3 tip = Vec3::Zero();
  for (const int vertex : sheet.verticesOf(sheet.columns - 1, sheet.columns - 1)) {
    tip += found.positions[vertex] / (sheet.rows * freeLength);
  }
  const double failed = found.converged ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  return {.along = tip.x() + failed, .down = -tip.y() + failed};
}

Comparison heavyElastica(double gamma, const CaseMesh& mesh) {
  constexpr double freeLength = 0.2;  // [m]
  constexpr double bending = 1e-4;    // [N m]
  const double density = gamma * bending / (gravity * freeLength * freeLength * freeLength);
  return {.measured = tipOf(stiffSheet(bending), density, freeLength, mesh).down,
          .exact = heavyElasticaTip(gamma).down};
}

/// Finds the overhang at which the chord makes Peirce's angle, by the secant method.
Comparison peirce(const sim::fabric::Material& material, double density, const CaseMesh& mesh) {
  const double exact = peirceOverhang(material.bendWarp, density * gravity);
  const auto excess = [&](double overhang) {
    return tipOf(material, density, overhang, mesh).chordAngle() - peirceAngle;
  };
  double former = exact;
  double formerExcess = excess(former);
  double overhang = 1.01 * exact;
  constexpr int maxIterations = 8;
  for (int i = 0; i < maxIterations && std::abs(overhang - former) > 1e-6 * exact; ++i) {
    const double now = excess(overhang);
    const double next = overhang - now * (overhang - former) / (now - formerExcess);
    former = overhang;
    formerExcess = now;
    overhang = next;
  }
  return {.measured = overhang, .exact = exact};
}

/// The fabric with warp and weft exchanged.
sim::fabric::Material turned(sim::fabric::Material material) {
  std::swap(material.stretchWarp, material.stretchWeft);
  std::swap(material.stiffeningWarp, material.stiffeningWeft);
  std::swap(material.bendWarp, material.bendWeft);
  return material;
}

}  // namespace

Comparison heavyElasticaSmall(const CaseMesh& mesh) {
  return heavyElastica(1.5, mesh);
}

Comparison heavyElasticaMedium(const CaseMesh& mesh) {
  return heavyElastica(5.0, mesh);
}

Comparison heavyElasticaLarge(const CaseMesh& mesh) {
  return heavyElastica(15.0, mesh);
}

Comparison heavyElasticaHanging(const CaseMesh& mesh) {
  return heavyElastica(46.0, mesh);
}

Comparison peirceWarp(const CaseMesh& mesh) {
  const fabrics::Preset& preset = *fabrics::findPreset(mesh.subject);
  return peirce(preset.material, preset.density, mesh);
}

Comparison peirceWeft(const CaseMesh& mesh) {
  const fabrics::Preset& preset = *fabrics::findPreset(mesh.subject);
  return peirce(turned(preset.material), preset.density, mesh);
}

Comparison buckling(const CaseMesh& mesh) {
  constexpr double freeLength = 0.2;  // [m]
  constexpr double bending = 1e-4;    // [N m]
  const sim::fabric::Material material = stiffSheet(bending);
  const TestSheet sheet = testSheet({.length = freeLength,
                                     .width = 0.25 * freeLength,
                                     .along = mesh.resolution,
                                     .across = std::max(2, mesh.resolution / 4)},
                                    mesh.kind);
  // A single pinned column is a hinge: the strip may turn about it.
  std::vector<int> pins = sheet.verticesOf(0, 0);
  const std::vector<int> other = sheet.verticesOf(sheet.columns - 1, sheet.columns - 1);
  pins.insert(pins.end(), other.begin(), other.end());
  const auto model = clothOf(sheet, material, 0.2, pins);
  const double exact = bucklingLoad(bending, freeLength);
  // Without contraction across, the flat strip is strained evenly: E_11 = -load / C_11.
  const auto isStable = [&](double load) {
    std::vector<Vec3> positions = model->restPositions;
    const double stretch = std::sqrt(1.0 - 2.0 * load / material.stretchWarp);
    for (Vec3& position : positions) {
      position.x() *= stretch;
    }
    return sim::isStableAt(*model, positions);
  };
  double low = 0.0;
  double high = 4.0 * exact;
  constexpr int halvings = 20;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (isStable(middle) ? low : high) = middle;
  }
  return {.measured = 0.5 * (low + high), .exact = exact};
}

namespace {

/// The vertices of the four corners of a sheet.
std::vector<int> cornerVertices(const TestSheet& sheet) {
  return {sheet.vertex(0, 0), sheet.vertex(sheet.columns - 1, 0), sheet.vertex(0, sheet.rows - 1),
          sheet.vertex(sheet.columns - 1, sheet.rows - 1)};
}

/// The energy of small deflections of which some are given and the others take the least energy [J].
double minEnergy(const sim::fabric::VertexMatrix& bending, Eigen::VectorXd deflections, const std::vector<int>& given) {
  const Eigen::SparseMatrix<double> whole = bending;
  Eigen::SparseMatrix<double> rest = whole;  // with rows and columns of the identity where deflections are given
  const auto isGiven = [&](Eigen::Index vertex) { return std::ranges::find(given, vertex) != given.end(); };
  rest.prune([&](Eigen::Index row, Eigen::Index column, double) { return !isGiven(row) && !isGiven(column); });
  Eigen::VectorXd forces = -(whole * deflections);
  for (const int vertex : given) {
    rest.coeffRef(vertex, vertex) = 1.0;
    forces[vertex] = 0.0;
  }
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(rest);
  deflections += Eigen::VectorXd(solver.solve(forces));
  return 0.5 * deflections.dot(whole * deflections);
}

}  // namespace

/// A square plate whose corners are moved to y = k x z. It takes that shape everywhere, with the energy 2 D_33 k^2 an
/// area.
Comparison twist(const CaseMesh& mesh) {
  constexpr double side = 0.2;  // [m]
  const sim::fabric::Material material = stiffSheet(1e-4);
  const TestSheet sheet =
      testSheet({.length = side, .width = side, .along = mesh.resolution, .across = mesh.resolution}, mesh.kind);
  const auto model = clothOf(sheet, material, 0.2, {});
  const std::vector<int> corners = cornerVertices(sheet);
  Eigen::VectorXd deflections = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model->restPositions.size()));
  for (const int vertex : corners) {
    deflections[vertex] = model->restPositions[vertex].x() * model->restPositions[vertex].z();
  }
  const double energy = minEnergy(model->fabric->bending, deflections, corners);
  return {.measured = 0.5 * energy / (side * side), .exact = sim::fabric::bendMatrix(material)(2, 2)};
}

}  // namespace drape::report::validation
