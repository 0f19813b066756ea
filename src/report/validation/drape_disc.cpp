#include "report/validation/drape_disc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::report::validation {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

/// Which ring has which radius. `free` cells lie outside the last held ring.
struct Rings {
  int count = 0;
  int free = 0;

  [[nodiscard]] double radius(double ring) const {
    const int held = count - free;
    const double cell = (discRadius - supportRadius) / (free + 0.5);
    const double lastHeld = supportRadius + 0.5 * cell;
    const double beyond = ring - held;
    // The cell inside the last held ring has the same width, for the bend at the edge of the support.
    return beyond >= -1.0 ? lastHeld + beyond * cell : (lastHeld - cell) * ring / (held - 1);
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
      Triangle& first = sheet.mesh.triangles[2 * (row * cells + column)];
      Triangle& second = sheet.mesh.triangles[2 * (row * cells + column) + 1];
      const bool falling = column == row;
      first = falling ? Triangle{a, c, d} : Triangle{a, c, b};
      second = falling ? Triangle{a, d, b} : Triangle{b, c, d};
    }
  }
}

}  // namespace

DrapeDisc drapeDisc(int cells, MeshKind kind) {
  const double size = cells;
  const Rings rings{.count = cells / 2, .free = cells / 3};
  DrapeDisc disc;
  disc.sheet = testSheet({.start = -0.5 * size, .length = size, .width = size, .along = cells, .across = cells}, kind);
  const int last = rings.count - rings.free;
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const int vertex = disc.sheet.vertex(column, row);
      const int ring = std::max(std::abs(column - rings.count), std::abs(row - rings.count));
      Vec3& position = disc.sheet.mesh.positions[vertex];
      if (ring <= last) {
        disc.held.push_back(vertex);
        position.x() = column - rings.count;
        position.z() = row;
      }
      position = onDisc(position.x(), position.z() - rings.count, rings);
    }
  }
  turnDiagonals(disc.sheet);
  return disc;
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
          double& farthest = shadow[(i % shadowAngles + shadowAngles) % shadowAngles];
          farthest = std::max(farthest, std::hypot(a.x() + t * (b.x() - a.x()), a.z() + t * (b.z() - a.z())));
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
  const double support = supportRadius * supportRadius;
  return 100.0 * (squares - support) / (discRadius * discRadius - support);
}

int foldsOf(std::span<const double> shadow) {
  const auto [least, most] = std::minmax_element(shadow.begin(), shadow.end());
  const double rise = 0.2 * (*most - *least);
  if (rise < 1e-3 * discRadius) {
    return 0;
  }
  // From the lowest minimum once around: a fold begins with a rise and ends with a fall.
  const auto start = static_cast<std::size_t>(least - shadow.begin());
  int folds = 0;
  bool rising = true;
  double extreme = *least;
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
