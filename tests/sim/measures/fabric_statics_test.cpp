#include "fabric_strip.hpp"
#include "sim/measures/equilibrium.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Strips of fabric at rest, compared with closed forms. The validation cases of src/report compare more quantities on
// finer meshes; the closed forms here share no code with theirs.

namespace drape::sim {
namespace {

using namespace testing;

constexpr double stripGravity = 9.81;  // [m/s^2]
constexpr double stripYoung = 1000.0;  // Young's modulus times thickness [N/m]

/// An isotropic membrane.
fabric::Material isotropicStrip(double poisson) {
  fabric::Material material;
  material.poisson = poisson;
  material.stretchWarp = material.stretchWeft = stripYoung / (1.0 - poisson * poisson);
  material.shear = 0.5 * stripYoung / (1.0 + poisson);
  return material;
}

/// The stretch lambda with E h lambda (lambda^2 - 1) / 2 = force per width, by bisection.
double stretchBy(double force) {
  double low = 1.0;
  double high = 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * stripYoung * middle * (middle * middle - 1.0) > force ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// Pulls on both ends of a strip with a force per width [N/m]. Only one vertex is pinned, so that the strip may
/// contract everywhere.
std::vector<Vec3> pulled(const FabricStrip& strip, double force) {
  std::vector<Vec3> loads(strip.mesh.positions.size(), Vec3::Zero());
  const Vec3 half(0.5 * force * strip.width / strip.across, 0.0, 0.0);
  for (int row = 0; row < strip.across; ++row) {
    for (const int side : {row, row + 1}) {
      loads[strip.vertex(strip.along, side)] += half;
      loads[strip.vertex(0, side)] -= half;
    }
  }
  return loads;
}

TEST(FabricStatics, aPulledStripStretchesAndContractsAsSaintVenantKirchhoffSays) {
  constexpr double poisson = 0.3;
  for (const StripTriangles kind : stripKinds) {
    for (const double force : {1.0, 50.0, 300.0}) {
      FabricStrip strip;
      strip.triangulate(kind);
      const auto model = strip.cloth(isotropicStrip(poisson), {strip.vertex(10, 2)});
      ASSERT_EQ(model->fabric->slivers, 0) << "slivers are softer";
      const Equilibrium found = equilibriumUnder(*model, pulled(strip, force), model->restPositions);
      ASSERT_TRUE(found.converged);
      const double stretch = stretchBy(force);
      const double across = std::sqrt(1.0 - poisson * (stretch * stretch - 1.0));
      for (std::size_t v = 0; v < found.positions.size(); ++v) {
        const Vec3 offset = found.positions[v] - found.positions[strip.vertex(10, 2)];
        const Vec3 rest = model->restPositions[v] - model->restPositions[strip.vertex(10, 2)];
        EXPECT_NEAR(offset.x(), stretch * rest.x(), 1e-9 * strip.length);
        EXPECT_NEAR(offset.z(), across * rest.z(), 1e-9 * strip.length);
      }
    }
  }
}

/// The elastic energy per area [J/m^2] of a square of which the boundary is sheared by `shear`: (x + shear z, z).
double energyOfSimpleShear(const fabric::Material& material, StripTriangles kind, double shear) {
  FabricStrip square;
  square.length = square.width = 0.1;
  square.along = square.across = 12;
  square.triangulate(kind);
  std::vector<int> boundary;
  std::vector<Vec3> start;
  RandomVectors random(5);
  for (int row = 0; row <= square.across; ++row) {
    for (int column = 0; column <= square.along; ++column) {
      const Vec3& rest = square.mesh.positions[square.vertex(column, row)];
      start.emplace_back(rest.x() + shear * rest.z(), 0.0, rest.z());
      if (square.isOnBoundary(column, row)) {
        boundary.push_back(square.vertex(column, row));
      } else {
        const Vec3 change = random.next(0.01 * square.length * shear);  // the search begins away from the answer
        start.back() += Vec3(change.x(), 0.0, change.z());
      }
    }
  }
  const auto model = square.cloth(material, boundary);
  const Equilibrium found = equilibriumUnder(*model, std::vector<Vec3>(start.size(), Vec3::Zero()), start);
  EXPECT_TRUE(found.converged);
  return fabric::elasticEnergy(*model, found.positions) / (square.length * square.width);
}

TEST(FabricStatics, simpleShearHasTheEnergyOfTheShearModulus) {
  fabric::Material material;
  material.shear = 100.0;
  material.stretchWarp = 2000.0;
  material.stretchWeft = 1500.0;
  material.poisson = 0.2;
  for (const StripTriangles kind : stripKinds) {
    for (const double shear : {1e-3, 0.1, 0.5}) {
      // 2 E_12 = shear, and lines along weft become longer: E_22 = shear^2 / 2.
      const double exact =
          0.5 * material.shear * std::pow(shear, 2) + 0.125 * material.stretchWeft * std::pow(shear, 4);
      EXPECT_NEAR(energyOfSimpleShear(material, kind, shear), exact, 1e-9 * exact);
    }
  }
}

/// Integrates the heavy elastica theta'' = -gamma (1 - s) cos(theta) of length 1 from its clamp, with Runge-Kutta of
/// order 4. @return slope, curvature, horizontal distance and drop at the tip
Eigen::Vector4d tipFromClamp(double gamma, double curvature) {
  constexpr int steps = 2000;
  constexpr double h = 1.0 / steps;
  const auto rate = [gamma](double s, const Eigen::Vector4d& at) {
    return Eigen::Vector4d(at[1], -gamma * (1.0 - s) * std::cos(at[0]), std::cos(at[0]), std::sin(at[0]));
  };
  Eigen::Vector4d at(0.0, curvature, 0.0, 0.0);
  for (int i = 0; i < steps; ++i) {
    const double s = i * h;
    const Eigen::Vector4d first = rate(s, at);
    const Eigen::Vector4d second = rate(s + 0.5 * h, at + 0.5 * h * first);
    const Eigen::Vector4d third = rate(s + 0.5 * h, at + 0.5 * h * second);
    const Eigen::Vector4d fourth = rate(s + h, at + h * third);
    at += h / 6.0 * (first + 2.0 * second + 2.0 * third + fourth);
  }
  return at;
}

/// The drop of the elastica's tip: the curvature at the clamp is the one that leaves none at the tip.
double exactDrop(double gamma) {
  double low = 0.0;
  double high = std::min(gamma, 2.0 * std::sqrt(gamma));
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (tipFromClamp(gamma, middle)[1] > 0.0 ? high : low) = middle;
  }
  return tipFromClamp(gamma, low)[3];
}

/// The drop of the tip of a clamped strip in lengths. The free length begins in the middle of the pinned cells.
double dropOf(double gamma, StripTriangles kind, int cells, unsigned seed) {
  constexpr double length = 0.2;    // [m]
  constexpr double bending = 1e-4;  // [N m]
  const double cell = length / (cells - 0.5);
  FabricStrip strip;
  strip.start = -0.5 * cell;
  strip.length = length + 0.5 * cell;
  strip.along = cells;
  strip.across = cells / 4;
  strip.straight = 2;
  strip.seed = seed;
  strip.density = gamma * bending / (stripGravity * length * length * length);
  strip.triangulate(kind);
  fabric::Material material;
  material.shear = 1000.0;
  material.bendWarp = material.bendWeft = material.bendBias = bending;
  std::vector<int> pins = strip.column(0);
  const std::vector<int> second = strip.column(1);
  pins.insert(pins.end(), second.begin(), second.end());
  const auto model = strip.cloth(material, pins);
  const Equilibrium found = equilibriumUnder(*model, weightsOf(*model, stripGravity), model->restPositions);
  EXPECT_TRUE(found.converged);
  EXPECT_TRUE(found.stable);
  return -strip.meanOf(cells, found.positions).y() / length;
}

TEST(FabricStatics, aClampedStripBendsAsTheHeavyElastica) {
  for (const double gamma : {1.5, 15.0}) {
    const double exact = exactDrop(gamma);
    for (const StripTriangles kind : {StripTriangles::Grid, StripTriangles::Alternating}) {
      EXPECT_NEAR(dropOf(gamma, kind, 20, 1), exact, 0.002 * exact) << gamma;
      EXPECT_NEAR(dropOf(gamma, kind, 40, 1), exact, 0.0005 * exact) << gamma;
    }
  }
}

TEST(FabricStatics, stripsOnIrregularMeshesBendAsMuchAsOnGrids) {
  for (const double gamma : {1.5, 15.0}) {
    const double exact = exactDrop(gamma);
    for (unsigned seed = 1; seed <= 4; ++seed) {
      EXPECT_NEAR(dropOf(gamma, StripTriangles::Irregular, 20, seed), exact, 0.02 * exact) << gamma << ' ' << seed;
    }
  }
}

TEST(FabricStatics, aHangingStripStretchesByItsOwnWeight) {
  constexpr double weight = 200.0;  // [N/m^2], a strain of 4 % at the upper edge
  for (const StripTriangles kind : stripKinds) {
    FabricStrip strip;
    strip.density = weight / stripGravity;
    strip.triangulate(kind);
    fabric::Material material = isotropicStrip(0.0);
    material.bendWarp = material.bendWeft = material.bendBias = 1e-5;
    const auto model = strip.cloth(material, strip.column(0));
    // It begins upright and bent out of its plane.
    std::vector<Vec3> start = model->restPositions;
    for (Vec3& position : start) {
      position = {0.05 * std::sin(8.0 * position.x()), -position.x(), position.z()};
    }
    const Equilibrium found = equilibriumUnder(*model, weightsOf(*model, stripGravity), start);
    ASSERT_TRUE(found.converged);
    EXPECT_TRUE(found.stable);
    double exact = 0.0;
    constexpr int parts = 2000;
    for (int i = 0; i < parts; ++i) {
      exact += (stretchBy(weight * strip.length * (i + 0.5) / parts) - 1.0) * strip.length / parts;
    }
    const Vec3 end = strip.meanOf(strip.along, found.positions);
    EXPECT_NEAR(-end.y() - strip.length, exact, 1e-3 * exact);
    EXPECT_NEAR(end.x(), 0.0, 1e-7 * strip.length);
  }
}

}  // namespace
}  // namespace drape::sim
