#include "report/validation/cases.hpp"
#include "report/validation/closed_forms.hpp"
#include "sim/fabric/fabric.hpp"
#include "sim/measures/equilibrium.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace drape::report::validation {
namespace {

constexpr double length = 0.2;  // [m]
constexpr double width = 0.05;  // [m]

/// An isotropic sheet with Young's modulus times thickness 1000 N/m and Poisson's ratio 0.3.
constexpr double youngThickness = 1000.0;
constexpr double poissonRatio = 0.3;

sim::fabric::Material isotropic(double poisson) {
  sim::fabric::Material material;
  material.poisson = poisson;
  material.stretchWarp = material.stretchWeft = youngThickness / (1.0 - poisson * poisson);
  material.shear = 0.5 * youngThickness / (1.0 + poisson);
  return material;
}

/// A strip along x with nearly square cells.
TestSheet stripOf(const CaseMesh& mesh) {
  const int across = std::max(2, mesh.resolution / 4);
  return testSheet({.length = length, .width = width, .along = mesh.resolution, .across = across}, mesh.kind);
}

/// The positions of the equilibrium; NaN if it was not found.
std::vector<Vec3> positionsUnder(const sim::ClothModel& model, const std::vector<Vec3>& loads,
                                 const std::vector<Vec3>& start, const CaseMesh& mesh) {
  sim::Equilibrium found = sim::equilibriumUnder(model, loads, start, {}, mesh.stop);
  if (!found.converged) {
    found.positions.assign(start.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  }
  return found.positions;
}

constexpr double endForce = 50.0;  // per width [N/m]: a strain of 5 % of the isotropic sheet

/// The stretches along x and z in the middle of a strip under an end load, fitted to the vertices there. An
/// extensometer measures them in the same place, because the clamp prevents the contraction beside it.
Vec2 stretchesOfLoadedStrip(const CaseMesh& mesh, const sim::fabric::Material& material, const Vec3& warp) {
  const TestSheet sheet = stripOf(mesh);
  const auto model = clothOf(sheet, material, 0.2, sheet.verticesOf(0, 0), warp);
  std::vector<Vec3> loads(model->restPositions.size(), Vec3::Zero());
  for (int row = 0; row + 1 < sheet.rows; ++row) {
    const double side = width / (sheet.rows - 1);
    loads[sheet.vertex(sheet.columns - 1, row)].x() += 0.5 * endForce * side;
    loads[sheet.vertex(sheet.columns - 1, row + 1)].x() += 0.5 * endForce * side;
  }
  const std::vector<Vec3> positions = positionsUnder(*model, loads, model->restPositions, mesh);
  const std::vector<int> gauge = sheet.verticesOf(mesh.resolution / 2, mesh.resolution * 9 / 10);
  Eigen::MatrixXd rest(gauge.size(), 3);
  Eigen::MatrixXd now(gauge.size(), 2);
  for (std::size_t i = 0; i < gauge.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    rest.row(row) << 1.0, model->restPositions[gauge[i]].x(), model->restPositions[gauge[i]].z();
    now.row(row) << positions[gauge[i]].x(), positions[gauge[i]].z();
  }
  const Eigen::MatrixXd fit = rest.householderQr().solve(now);
  return {fit(1, 0), fit(2, 1)};
}

}  // namespace

Comparison endLoadModulus(const CaseMesh& mesh) {
  const double stretch = stretchesOfLoadedStrip(mesh, isotropic(poissonRatio), Vec3::UnitX()).x();
  return {.measured = 2.0 * endForce / (stretch * (stretch * stretch - 1.0)), .exact = youngThickness};
}

Comparison endLoadPoisson(const CaseMesh& mesh) {
  const Vec2 stretch = stretchesOfLoadedStrip(mesh, isotropic(poissonRatio), Vec3::UnitX());
  return {.measured = (1.0 - stretch.y() * stretch.y()) / (stretch.x() * stretch.x() - 1.0), .exact = poissonRatio};
}

/// Bias extension: with equal moduli along warp and weft, a strip that is cut at 45 degrees does not shear when it is
/// stretched.
Comparison biasExtension(const CaseMesh& mesh) {
  const sim::fabric::Material material{.stretchWarp = 2000.0, .stretchWeft = 2000.0, .shear = 300.0, .poisson = 0.2};
  const double stretch = stretchesOfLoadedStrip(mesh, material, Vec3(1.0, 0.0, 1.0).normalized()).x();
  return {.measured = 2.0 * endForce / (stretch * (stretch * stretch - 1.0)), .exact = biasModulus(material)};
}

Comparison ownWeight(const CaseMesh& mesh) {
  constexpr double weight = 200.0;  // [N/m^2]: a strain of 4 % at the clamp
  const TestSheet sheet = stripOf(mesh);
  const auto model = clothOf(sheet, isotropic(0.0), 1.0, sheet.verticesOf(0, 0));
  std::vector<Vec3> loads;
  for (const double area : model->vertexArea) {
    loads.emplace_back(weight * area, 0.0, 0.0);
  }
  const std::vector<Vec3> positions = positionsUnder(*model, loads, model->restPositions, mesh);
  double end = 0.0;
  for (const int vertex : sheet.verticesOf(sheet.columns - 1, sheet.columns - 1)) {
    end += positions[vertex].x() / sheet.rows;
  }
  return {.measured = end - length, .exact = elongationByWeight(weight, length, youngThickness)};
}

Comparison pictureFrame(const CaseMesh& mesh) {
  constexpr double angle = 0.3;  // [rad]
  constexpr double side = 0.1;   // [m]
  sim::fabric::Material material;
  const TestSheet sheet =
      testSheet({.length = side, .width = side, .along = mesh.resolution, .across = mesh.resolution}, mesh.kind);
  std::vector<int> frame;
  std::vector<Vec3> start;
  std::mt19937 engine(3);
  for (int row = 0; row < sheet.rows; ++row) {
    for (int column = 0; column < sheet.columns; ++column) {
      const Vec3& rest = sheet.mesh.positions[sheet.vertex(column, row)];
      start.emplace_back(rest.x() + std::sin(angle) * rest.z(), 0.0, std::cos(angle) * rest.z());
      if (row == 0 || column == 0 || row + 1 == sheet.rows || column + 1 == sheet.columns) {
        frame.push_back(sheet.vertex(column, row));
      } else {
        // The search begins away from the answer.
        start.back().x() += 0.1 * side / mesh.resolution * (static_cast<double>(engine()) / 4294967295.0 - 0.5);
      }
    }
  }
  const auto model = clothOf(sheet, material, 0.2, frame);
  const std::vector<Vec3> loads(start.size(), Vec3::Zero());
  const std::vector<Vec3> positions = positionsUnder(*model, loads, start, mesh);
  const double density = sim::fabric::elasticEnergy(*model, positions) / (side * side);
  const double unit = pictureFrameEnergy({.shear = 1.0}, angle);
  return {.measured = density / unit, .exact = material.shear};
}

Comparison hangingStrip(const CaseMesh& mesh) {
  constexpr double span = 0.8 * length;
  sim::fabric::Material material;
  material.stretchWarp = material.stretchWeft = 1e5;  // hardly extensible under the weight of 2 N/m^2
  material.shear = 1e4;
  // Almost limp: it selects the smooth one of the equilibria, as a membrane may fold along its edges at no cost.
  material.bendWarp = material.bendWeft = material.bendBias = 1e-7;
  const TestSheet sheet = stripOf(mesh);
  std::vector<int> pins = sheet.verticesOf(0, 0);
  const std::vector<int> other = sheet.verticesOf(sheet.columns - 1, sheet.columns - 1);
  pins.insert(pins.end(), other.begin(), other.end());
  const auto model = clothOf(sheet, material, 0.2, pins);
  std::vector<Vec3> start = model->restPositions;
  for (Vec3& position : start) {
    const double share = position.x() / length;
    position = {span * share, -1.4 * length * share * (1.0 - share), position.z()};
  }
  const std::vector<Vec3> positions = positionsUnder(*model, sim::weightsOf(*model, 9.81), start, mesh);
  const double middle = positions[sheet.vertex(mesh.resolution / 2, 0)].y();
  const double opposite = positions[sheet.vertex(mesh.resolution / 2, sheet.rows - 1)].y();
  return {.measured = -0.5 * (middle + opposite), .exact = catenarySag(length, span)};
}

}  // namespace drape::report::validation
