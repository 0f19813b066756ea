#include "report/validation/drape_disc.hpp"

#include "sim/measures/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace drape::report::validation {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// Which ring has which radius. `free` cells lie outside the last held ring.
struct Rings {
  DiscForm form;
  int count = 0;
  int free = 0;

  [[nodiscard]] double radius(double ring) const {
    const int last = count - free;
    const double cell = (form.radius - form.support) / (free + 0.5);
    const double lastHeld = form.support + 0.5 * cell;
    const double beyond = ring - last;
    // The cell inside the last held ring has the same width, for the bend at the edge of the support.
    return beyond >= -1.0 ? lastHeld + beyond * cell : (lastHeld - cell) * ring / (last - 1);
  }
};

/// The point of the disc for a point of the square [-rings, rings]^2. Square rings become circles towards the support's
/// edge.
Vec3 onDisc(double x, double z, const Rings& rings) {
  const double ring = std::max(std::abs(x), std::abs(z));
  if (ring == 0.0) {
    return Vec3::Zero();
  }
  // Even angles along each side of the square.
  const double quarter = 0.25 * std::numbers::pi;
  const bool upright = std::abs(x) >= std::abs(z);
  const double share = (upright ? z : x) / ring;
  const double angle = quarter * share;
  const double sign = (upright ? x : z) > 0.0 ? 1.0 : -1.0;
  const Vec3 circle =
      upright ? Vec3(sign * std::cos(angle), 0.0, std::sin(angle)) : Vec3(std::sin(angle), 0.0, sign * std::cos(angle));
  return rings.radius(ring) * circle;
}

/// Makes the diagonals of the cells at the corners of the rings radial. The other diagonal would make triangles with
/// three vertices on a circle, which have hardly any area.
void turnDiagonals(TestSheet& sheet) {
  const int cells = sheet.columns - 1;
  for (int row = 0; row < cells; ++row) {
    for (const int column : {row, cells - 1 - row}) {
      const int a = sheet.vertex(column, row);
      const int b = sheet.vertex(column + 1, row);
      const int c = sheet.vertex(column, row + 1);
      const int d = sheet.vertex(column + 1, row + 1);
      const int ofCell = 2 * (row * cells + column);
      Triangle& first = sheet.mesh.triangles[ofCell];
      Triangle& second = sheet.mesh.triangles[ofCell + 1];
      const bool falling = column == row;
      first = falling ? Triangle{a, c, d} : Triangle{a, c, b};
      second = falling ? Triangle{a, d, b} : Triangle{b, c, d};
    }
  }
}

}  // namespace

Disc discOf(const DiscForm& form, int cells, MeshKind kind) {
  const double size = cells;
  const Rings rings{.form = form, .count = cells / 2, .free = cells / 3};
  Disc disc;
  disc.sheet = testSheet({.start = -0.5 * size, .length = size, .width = size, .along = cells, .across = cells}, kind);
  const int last = rings.count - rings.free;
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const int vertex = disc.sheet.vertex(column, row);
      const int ring = std::max(std::abs(column - rings.count), std::abs(row - rings.count));
      Vec3& position = disc.sheet.mesh.positions[vertex];
      if (ring <= last) {
        disc.pinned.push_back(vertex);
        position.x() = column - rings.count;
        position.z() = row;
      }
      position = onDisc(position.x(), position.z() - rings.count, rings);
    }
  }
  turnDiagonals(disc.sheet);
  return disc;
}

std::vector<int> rimOf(const Disc& disc) {
  std::vector<int> rim;
  const int last = disc.sheet.columns - 1;
  for (int row = 0; row <= last; ++row) {
    for (int column = 0; column <= last; ++column) {
      if (row == 0 || column == 0 || row == last || column == last) {
        rim.push_back(disc.sheet.vertex(column, row));
      }
    }
  }
  return rim;
}

namespace {

/// Twice the signed area of the triangle (0, u, v), seen from above.
double crossOf(const Vec3& u, const Vec3& v) {
  return u.z() * v.x() - u.x() * v.z();
}

/// The displacement of a point of the flat disc, interpolated in the triangle that it lies in, or that it is closest to
/// in barycentric coordinates.
Vec3 displacementAt(const Vec3& point, const DrapedDisc& from) {
  const sim::ClothMesh& mesh = from.disc.sheet.mesh;
  Vec3 displacement = Vec3::Zero();
  double best = -std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3& a = mesh.positions[triangle[0]];
    const Vec3& b = mesh.positions[triangle[1]];
    const Vec3& c = mesh.positions[triangle[2]];
    const double area = crossOf(b - a, c - a);
    const double ofB = crossOf(point - a, c - a) / area;
    const double ofC = crossOf(b - a, point - a) / area;
    const double lowest = std::min({1.0 - ofB - ofC, ofB, ofC});
    if (lowest > best) {
      best = lowest;
      displacement = (1.0 - ofB - ofC) * (from.positions[triangle[0]] - a) + ofB * (from.positions[triangle[1]] - b) +
                     ofC * (from.positions[triangle[2]] - c);
    }
    if (best >= 0.0) {
      break;
    }
  }
  return displacement;
}

/// Four waves along the rim. They are turned a little, and one side is lower, so that no symmetry hinders the search.
std::vector<Vec3> wavesOf(const DiscForm& form, const Disc& disc) {
  constexpr double amplitude = 0.13;  // of the radius
  std::vector<Vec3> positions = disc.sheet.mesh.positions;
  for (Vec3& position : positions) {
    const double angle = std::atan2(position.z(), position.x());
    const double beyond = std::hypot(position.x(), position.z()) - form.support;
    const double wave = std::cos(4.0 * (angle + 0.1)) - 0.03 * std::cos(angle);
    position.y() = amplitude * form.radius * wave * std::max(0.0, beyond) / (form.radius - form.support);
  }
  return positions;
}

}  // namespace

DrapedDisc drapedDisc(const DiscForm& form, const fabrics::Preset& preset, const CaseMesh& mesh) {
  constexpr int coarsest = 12;
  constexpr double gravity = 9.81;  // [m/s^2]
  constexpr sim::EquilibriumOptions options{.tolerance = 1e-6, .maxIterations = 400};
  DrapedDisc draped;
  for (int cells = std::min(coarsest, mesh.resolution); cells <= mesh.resolution;
       cells = cells == mesh.resolution ? cells + 1 : std::min(2 * cells, mesh.resolution)) {
    DrapedDisc finer{.disc = discOf(form, cells, mesh.kind), .positions = {}};
    finer.positions = wavesOf(form, finer.disc);
    if (!draped.positions.empty()) {
      finer.positions = finer.disc.sheet.mesh.positions;
      for (Vec3& position : finer.positions) {
        position += displacementAt(position, draped);
      }
    }
    for (const int vertex : finer.disc.pinned) {
      finer.positions[vertex] = finer.disc.sheet.mesh.positions[vertex];
    }
    const auto model = clothOf(finer.disc.sheet, preset.material, preset.density, finer.disc.pinned);
    sim::Equilibrium found =
        sim::equilibriumUnder(*model, sim::weightsOf(*model, gravity), finer.positions, options, mesh.stop);
    finer.converged = found.converged;
    finer.positions = std::move(found.positions);
    draped = std::move(finer);
  }
  return draped;
}

std::vector<double> shadowOf(std::span<const Vec3> positions, const std::vector<Triangle>& triangles) {
  std::vector<double> shadow(shadowAngles, 0.0);
  const double step = turn / shadowAngles;
  for (const Triangle& triangle : triangles) {
    for (std::size_t side = 0; side < 3; ++side) {
      const Vec3& a = positions[triangle[side]];
      const Vec3& b = positions[triangle[(side + 1) % 3]];
      double from = std::atan2(a.z(), a.x());
      double to = std::atan2(b.z(), b.x());
      from += to - from > std::numbers::pi ? turn : 0.0;
      to += from - to > std::numbers::pi ? turn : 0.0;
      const auto first = static_cast<int>(std::ceil(std::min(from, to) / step));
      const auto end = static_cast<int>(std::floor(std::max(from, to) / step));
      for (int i = first; i <= end; ++i) {
        // The ray r (c, s) meets a + t (b - a).
        const double c = std::cos(i * step);
        const double s = std::sin(i * step);
        const double across = (b.x() - a.x()) * s - (b.z() - a.z()) * c;
        if (across != 0.0) {
          const double t = std::clamp((a.z() * c - a.x() * s) / across, 0.0, 1.0);
          double& largest = shadow[(i % shadowAngles + shadowAngles) % shadowAngles];
          largest = std::max(largest, std::hypot(a.x() + t * (b.x() - a.x()), a.z() + t * (b.z() - a.z())));
        }
      }
    }
  }
  return shadow;
}

double drapeCoefficient(std::span<const double> shadow) {
  double squares = 0.0;
  for (const double radius : shadow) {
    squares += radius * radius / static_cast<double>(shadow.size());
  }
  const double support = cusickDisc.support * cusickDisc.support;
  return 100.0 * (squares - support) / (cusickDisc.radius * cusickDisc.radius - support);
}

int foldsOf(std::span<const double> shadow) {
  const auto [lowest, most] = std::minmax_element(shadow.begin(), shadow.end());
  const double rise = 0.2 * (*most - *lowest);
  if (rise < 1e-3 * cusickDisc.radius) {
    return 0;
  }
  // From the lowest minimum once around: a fold begins with a rise and ends with a fall.
  const auto start = static_cast<std::size_t>(lowest - shadow.begin());
  int folds = 0;
  bool rising = true;
  double extreme = *lowest;
  for (std::size_t i = 1; i <= shadow.size(); ++i) {
    const double radius = shadow[(start + i) % shadow.size()];
    if (rising) {
      extreme = std::min(extreme, radius);
      if (radius > extreme + rise) {
        rising = false;
        ++folds;
        extreme = radius;
      }
    } else {
      extreme = std::max(extreme, radius);
      if (radius < extreme - rise) {
        rising = true;
        extreme = radius;
      }
    }
  }
  return folds;
}

}  // namespace drape::report::validation
