#include "io/garments/garments.hpp"
#include "io/garments/solids.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::io {
namespace {

using namespace garment;

constexpr double pi = std::numbers::pi;
constexpr double poleRadius = 0.011;     // [m]
constexpr double hoopThickness = 0.006;  // radius of the bent bar [m]
constexpr double hoopGap = 0.016;        // from a hoop to the cloth around it, more than the contact distance [m]
constexpr double spokeRadius = 0.004;    // [m]
constexpr double barRadius = 0.007;      // of the shoulder bar [m]
constexpr double barDepth = 0.02;  // of its axis below the shoulder line, so that cloth on it falls to both sides [m]
constexpr int roundSegments = 64;  // around base and pole
constexpr int barSegments = 16;    // around bars
constexpr double longest = 0.06;   // maximum length of a segment: long triangles make contact slow [m]

/// A straight bar.
void addStraightBar(const Vec3& from, const Vec3& to, double radius, RawMesh& mesh) {
  const int parts = std::max(2, static_cast<int>(std::ceil((to - from).norm() / longest)));
  std::vector<Vec3> axis;
  for (int i = 0; i <= parts; ++i) {
    axis.emplace_back(from + (to - from) * i / parts);
  }
  addBar(axis, false, radius, barSegments, mesh);
}

/// A heavy base of that radius, a pole, and a knob whose top is at `top`.
void addBaseAndPole(double baseRadius, double top, RawMesh& stand) {
  constexpr double knobRadius = 0.017;
  const double knobBottom = top - 2.0 * knobRadius;
  std::vector<SilhouettePoint> silhouette{{0.0, 0.0}, {baseRadius / 2.0, 0.0}};
  const auto add = [&silhouette](const std::vector<SilhouettePoint>& part) {
    silhouette.insert(silhouette.end(), part.begin(), part.end());
  };
  add(rounding({baseRadius - 0.004, 0.0}, {baseRadius, 0.004}, true));
  add(rounding({baseRadius, 0.012}, {baseRadius - 0.006, 0.018}, false));
  silhouette.push_back({baseRadius / 2.0, 0.021});
  silhouette.push_back({0.040, 0.023});
  add(rounding({0.036, 0.024}, {poleRadius + 0.006, 0.042}, true));
  add(rounding({poleRadius + 0.006, 0.070}, {poleRadius, 0.076}, false));
  constexpr double poleBottom = 0.1;
  const double poleTop = knobBottom - 0.01;
  const int parts = static_cast<int>(std::ceil((poleTop - poleBottom) / longest));
  for (int i = 0; i <= parts; ++i) {
    silhouette.push_back({poleRadius, poleBottom + (poleTop - poleBottom) * i / parts});
  }
  silhouette.push_back({poleRadius, knobBottom});
  constexpr int knobRings = 12;
  const double start = std::asin(poleRadius / knobRadius);
  for (int ring = 0; ring <= knobRings; ++ring) {
    const double angle = start + (pi - start) * ring / knobRings;
    silhouette.push_back({knobRadius * std::max(0.0, std::sin(angle)), top - knobRadius * (1.0 + std::cos(angle))});
  }
  addTurned(silhouette, roundSegments, stand);
}

Vec3 onCircle(double radius, double height, double angle) {
  return {radius * std::sin(angle), height, radius * std::cos(angle)};
}

/// A hoop around the pole, on spokes, with that outer radius.
void addHoop(double outerRadius, double height, int spokes, RawMesh& stand) {
  const double radius = outerRadius - hoopThickness;
  std::vector<Vec3> hoop;
  constexpr int segments = 96;
  for (int i = 0; i < segments; ++i) {
    hoop.push_back(onCircle(radius, height, 2.0 * pi * i / segments));
  }
  addBar(hoop, true, hoopThickness, barSegments, stand);
  for (int i = 0; i < spokes; ++i) {
    const double angle = 2.0 * pi * (i + 0.5) / spokes;
    const Vec3 inner = onCircle(poleRadius / 2.0, height, angle);
    const Vec3 outer = onCircle(radius, height, angle);
    addBar({inner, 0.5 * (inner + outer), outer}, false, spokeRadius, barSegments, stand);
  }
}

}  // namespace

RawMesh makeSkirtStand() {
  RawMesh stand;
  addBaseAndPole(0.17, waistHeight + 0.045, stand);
  addHoop(waistRadius - hoopGap, waistHeight, 3, stand);
  addHoop(hipRadius() - hoopGap, hipHeight, 3, stand);
  return stand;
}

RawMesh makeFlagPole() {
  RawMesh pole;
  addBaseAndPole(0.25, flagTop + 0.06, pole);
  return pole;
}

RawMesh makeTable() {
  constexpr double edge = 0.014;  // half of the top's thickness [m]
  std::vector<SilhouettePoint> silhouette{{0.0, 0.0}, {0.13, 0.0}};
  const auto add = [&silhouette](const std::vector<SilhouettePoint>& part) {
    silhouette.insert(silhouette.end(), part.begin(), part.end());
  };
  add(rounding({0.26 - 0.006, 0.0}, {0.26, 0.006}, true));
  add(rounding({0.26, 0.014}, {0.26 - 0.008, 0.022}, false));
  silhouette.push_back({0.14, 0.030});
  add(rounding({0.09, 0.036}, {0.032, 0.120}, true));
  silhouette.push_back({0.030, 0.37});
  add(rounding({0.032, 0.640}, {0.090, tableHeight - 2.0 * edge - 0.006}, false));
  silhouette.push_back({0.25, tableHeight - 2.0 * edge - 0.003});
  add(rounding({tableRadius - edge, tableHeight - 2.0 * edge}, {tableRadius, tableHeight - edge}, true));
  add(rounding({tableRadius, tableHeight - edge}, {tableRadius - edge, tableHeight}, false));
  silhouette.push_back({0.34, tableHeight});
  silhouette.push_back({0.24, tableHeight});
  silhouette.push_back({0.14, tableHeight});
  silhouette.push_back({0.06, tableHeight});
  silhouette.push_back({0.0, tableHeight});
  RawMesh table;
  addTurned(silhouette, roundSegments, table);
  return table;
}

RawMesh makeCurtainRail() {
  RawMesh rail;
  const double end = 0.5 * railLength;
  addStraightBar(Vec3(-end, railHeight, 0.0), Vec3(end, railHeight, 0.0), 0.012, rail);
  for (const double x : {-end, end}) {
    addStraightBar(Vec3(x, 0.0, 0.0), Vec3(x, railHeight + 0.03, 0.0), 0.016, rail);
    addStraightBar(Vec3(x, 0.012, -0.25), Vec3(x, 0.012, 0.25), 0.012, rail);
  }
  return rail;
}

RawMesh makeHangerStand() {
  RawMesh stand;
  addBaseAndPole(0.2, shoulderHeight + 0.04, stand);
  std::vector<Vec3> bar;
  constexpr int steps = 48;
  const double reach = shoulderHalfWidth - 0.02;
  for (int i = -steps; i <= steps; ++i) {
    const double x = reach * i / steps;
    bar.emplace_back(x, shoulderLine(x) - barDepth, 0.0);
  }
  addBar(bar, false, barRadius, barSegments, stand);
  return stand;
}

}  // namespace drape::io
