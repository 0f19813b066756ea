#include "io/garments/solids.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace drape::io {
namespace {

constexpr double pi = std::numbers::pi;

/// Segments of a rounded end or edge.
constexpr int roundingSteps = 5;

/// Joins consecutive rings of `segments` points each, starting at `first`, by triangles. They face outwards when each
/// ring runs counter-clockwise as seen against the direction of the sequence.
void joinRings(int first, int rings, int segments, bool closed, RawMesh& solid) {
  for (int ring = 0; ring + (closed ? 0 : 1) < rings; ++ring) {
    const int lower = first + ring * segments;
    const int upper = first + (ring + 1) % rings * segments;
    for (int i = 0; i < segments; ++i) {
      const int next = (i + 1) % segments;
      solid.triangles.push_back({lower + i, lower + next, upper + next});
      solid.triangles.push_back({lower + i, upper + next, upper + i});
    }
  }
}

/// A cross-section of a bar.
struct Section {
  Vec3 centre;
  Vec3 side;    ///< unit vector perpendicular to the bar
  Vec3 normal;  ///< unit vector perpendicular to the bar and `side`
  double radius = 0.0;
};

/// The cross-sections at the points of a path, with minimal rotation from one to the next.
std::vector<Section> sectionsAlong(const std::vector<Vec3>& path, bool closed, double radius) {
  std::vector<Section> sections;
  const std::size_t count = path.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& before = path[i > 0 ? i - 1 : (closed ? count - 1 : 0)];
    const Vec3& after = path[i + 1 < count ? i + 1 : (closed ? 0 : i)];
    const Vec3 along = (after - before).normalized();
    const Vec3 hint = !sections.empty()           ? sections.back().side
                      : std::abs(along.y()) < 0.9 ? Vec3(0.0, 1.0, 0.0)
                                                  : Vec3(1.0, 0.0, 0.0);
    const Vec3 side = (hint - hint.dot(along) * along).normalized();
    sections.push_back({path[i], side, along.cross(side), radius});
  }
  return sections;
}

/// Replaces the ends of a bar by half spheres.
std::vector<Section> withRoundEnds(const std::vector<Section>& bar) {
  const auto shrunk = [](const Section& end, double outwards, int step) {
    const double angle = pi / 2.0 * step / roundingSteps;
    Section result = end;
    result.centre += outwards * std::sin(angle) * end.radius * end.side.cross(end.normal);
    result.radius = end.radius * std::max(0.0, std::cos(angle));
    return result;
  };
  std::vector<Section> sections;
  for (int step = roundingSteps; step > 0; --step) {
    sections.push_back(shrunk(bar.front(), -1.0, step));
  }
  sections.insert(sections.end(), bar.begin(), bar.end());
  for (int step = 1; step <= roundingSteps; ++step) {
    sections.push_back(shrunk(bar.back(), 1.0, step));
  }
  return sections;
}

}  // namespace

void addTurned(const std::vector<SilhouettePoint>& silhouette, int segments, RawMesh& solid) {
  const int first = static_cast<int>(solid.positions.size());
  for (const SilhouettePoint& point : silhouette) {
    for (int i = 0; i < segments; ++i) {
      const double angle = 2.0 * pi * i / segments;
      solid.positions.emplace_back(point.radius * std::sin(angle), point.height, point.radius * std::cos(angle));
    }
  }
  joinRings(first, static_cast<int>(silhouette.size()), segments, false, solid);
}

std::vector<SilhouettePoint> rounding(SilhouettePoint from, SilhouettePoint to, bool outwardFirst) {
  std::vector<SilhouettePoint> points;
  for (int step = 0; step <= roundingSteps; ++step) {
    const double angle = pi / 2.0 * step / roundingSteps;
    const double fast = std::sin(angle);
    const double slow = 1.0 - std::cos(angle);
    points.push_back({from.radius + (to.radius - from.radius) * (outwardFirst ? fast : slow),
                      from.height + (to.height - from.height) * (outwardFirst ? slow : fast)});
  }
  return points;
}

void addBar(const std::vector<Vec3>& path, bool closed, double radius, int segments, RawMesh& solid) {
  std::vector<Section> sections = sectionsAlong(path, closed, radius);
  if (!closed) {
    sections = withRoundEnds(sections);
  }
  const int first = static_cast<int>(solid.positions.size());
  for (const Section& section : sections) {
    for (int i = 0; i < segments; ++i) {
      const double angle = 2.0 * pi * i / segments;
      solid.positions.emplace_back(
          section.centre + section.radius * (std::cos(angle) * section.side + std::sin(angle) * section.normal));
    }
  }
  joinRings(first, static_cast<int>(sections.size()), segments, closed, solid);
}

}  // namespace drape::io
