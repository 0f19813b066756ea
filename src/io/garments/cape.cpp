#include "io/garments/garments.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace drape::io {
namespace {

constexpr double halfAngle = 1.5;  // angle to either side, from the middle of the back [rad]
constexpr double depth = 0.75;     // ratio of the extent to the back and to the sides [-]
constexpr double middleZ = 0.055;  // of its axis [m]
constexpr int columns = 37;        // vertices along a border
constexpr int yokeRows = 7;        // cells from the neck to the edge of the shoulders
constexpr int rows = 35;           // cells from there to the hem

/// The distance of a border from the axis, and its height [m].
struct Level {
  double radius;
  double height;
};
constexpr Level neckline{0.115, 1.462};
constexpr Level shoulder{0.262, 1.378};
constexpr Level hem{0.420, 0.560};

Level between(const Level& a, const Level& b, double t) {
  return {a.radius + t * (b.radius - a.radius), a.height + t * (b.height - a.height)};
}

}  // namespace

RawMesh makeCape() {
  RawMesh cape;
  double down = 0.0;
  Level above = neckline;
  for (int row = 0; row <= yokeRows + rows; ++row) {
    const Level level = row <= yokeRows ? between(neckline, shoulder, double(row) / yokeRows)
                                        : between(shoulder, hem, double(row - yokeRows) / rows);
    down += std::hypot(level.radius - above.radius, level.height - above.height);
    above = level;
    for (int column = 0; column < columns; ++column) {
      const double across = 2.0 * column / (columns - 1) - 1.0;
      const double angle = across * halfAngle;
      cape.positions.emplace_back(level.radius * std::sin(angle), level.height,
                                  middleZ - depth * level.radius * std::cos(angle));
      cape.uvs.emplace_back(across * halfAngle * hem.radius, hem.height - down);
    }
  }
  for (int row = 0; row < yokeRows + rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const int corner = row * columns + column;
      cape.triangles.push_back({corner, corner + 1, corner + columns + 1});
      cape.triangles.push_back({corner, corner + columns + 1, corner + columns});
    }
  }
  return cape;
}

}  // namespace drape::io
