#include "figure/proportions.hpp"

#include "figure/periodic_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drape::figure {
namespace {

constexpr double chestHeight = 1.220;  // where each circumference is measured on the figure as built [m]
constexpr double waistHeight = 1.060;
constexpr double hipHeight = 0.890;

double trunkShare(const SkinWeights& weights) {
  return weights.of(Joint::Hips) + weights.of(Joint::Spine) + weights.of(Joint::Chest) + weights.of(Joint::LeftThigh) +
         weights.of(Joint::RightThigh);
}

double armShare(const SkinWeights& weights) {
  double sum = 0.0;
  for (std::size_t j = indexOf(Joint::LeftShoulder); j < indexOf(Joint::LeftThigh); ++j) {
    sum += weights.of(static_cast<Joint>(j));
  }
  return sum;
}

/// The points where the trunk's surface crosses a height, as (x, z).
std::vector<Vec2> sectionOf(const FigureShape& figure, std::span<const Triangle> triangles,
                            std::span<const SkinWeights> weights, double height) {
  std::vector<Vec2> points;
  for (const Triangle& triangle : triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const int a = triangle[corner];
      const int b = triangle[(corner + 1) % 3];
      const Vec3& from = figure.positions[a];
      const Vec3& to = figure.positions[b];
      if ((from.y() < height) != (to.y() < height) && trunkShare(weights[a]) + trunkShare(weights[b]) > 1.0) {
        const Vec3 point = from + (height - from.y()) / (to.y() - from.y()) * (to - from);
        points.emplace_back(point.x(), point.z());
      }
    }
  }
  return points;
}

/// The length of a tape around points: the perimeter of their convex hull (Andrew 1979).
double tapeLength(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  const auto chain = [](const auto& sorted) {
    std::vector<Vec2> hull;
    for (const Vec2& point : sorted) {
      const auto turnsRight = [&] {
        const Vec2 u = hull[hull.size() - 1] - hull[hull.size() - 2];
        const Vec2 v = point - hull.back();
        return u.x() * v.y() - u.y() * v.x() <= 0.0;
      };
      while (hull.size() > 1 && turnsRight()) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    double length = 0.0;
    for (std::size_t i = 1; i < hull.size(); ++i) {
      length += (hull[i] - hull[i - 1]).norm();
    }
    return length;
  };
  const double lower = chain(points);
  std::reverse(points.begin(), points.end());
  return lower + chain(points);
}

double heightOf(const FigureShape& figure) {
  const auto [lowest, highest] = std::minmax_element(figure.positions.begin(), figure.positions.end(),
                                                     [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
  return highest->y() - lowest->y();
}

/// The factors of the trunk's width and depth at heights of the figure as built.
struct TrunkScale {
  struct Level {
    double height = 0.0;  // [m]
    double factor = 1.0;
  };
  std::array<Level, 6> levels;  // ascending; the factor is 1 outside

  [[nodiscard]] double at(double height) const {
    if (height <= levels.front().height || height >= levels.back().height) {
      return 1.0;
    }
    std::size_t k = 1;
    while (height > levels[k].height) {
      ++k;
    }
    const Level& below = levels[k - 1];
    const Level& above = levels[k];
    const double t = smoothStep((height - below.height) / (above.height - below.height));
    return below.factor + t * (above.factor - below.factor);
  }
};

/// The change of a figure.
struct Change {
  TrunkScale trunk;
  double shoulder = 0.0;  // of an upper arm, outwards [m]
  double height = 1.0;

  [[nodiscard]] Vec3 moved(const Vec3& point, double trunkWeight, double armWeight) const {
    const double factor = 1.0 + trunkWeight * (trunk.at(point.y()) - 1.0);
    const double outwards = std::clamp(point.x() / restOf(Joint::LeftUpperArm).x(), -1.0, 1.0);
    return {factor * point.x() + armWeight * shoulder * outwards, height * point.y(), factor * point.z()};
  }
};

Change changeOf(const Proportions& built, const Proportions& wanted) {
  const auto factor = [&](std::optional<double> Proportions::*value) {
    return wanted.*value ? *(wanted.*value) / *(built.*value) : 1.0;
  };
  Change change;
  const double hip = factor(&Proportions::hip);
  const double chest = factor(&Proportions::chest);
  change.trunk.levels = {{{0.52, 1.0},
                          {0.84, hip},
                          {hipHeight, hip},
                          {waistHeight, factor(&Proportions::waist)},
                          {chestHeight, chest},
                          {1.42, 1.0}}};
  // Without a measure of their own, the shoulders follow half of the chest.
  const double shoulder = wanted.shoulder ? *wanted.shoulder / *built.shoulder : 1.0 + 0.5 * (chest - 1.0);
  change.shoulder = 0.5 * (shoulder - 1.0) * *built.shoulder;
  change.height = factor(&Proportions::height);
  return change;
}

}  // namespace

std::span<const ProportionInfo> proportionTable() {
  static const std::array<ProportionInfo, 5> table{{
      {"height", "height", 1.2, 2.2, &Proportions::height},
      {"chest", "circumference of the chest", 0.55, 1.2, &Proportions::chest},
      {"waist", "circumference of the waist", 0.45, 1.1, &Proportions::waist},
      {"hip", "circumference of the hips", 0.6, 1.3, &Proportions::hip},
      {"shoulder", "distance of the shoulder joints", 0.28, 0.5, &Proportions::shoulder},
  }};
  return table;
}

Proportions measured(const FigureShape& figure, std::span<const Triangle> triangles,
                     std::span<const SkinWeights> weights) {
  const double scale = figure.places[0].y() / restOf(Joint::Hips).y();
  const auto around = [&](double height) { return tapeLength(sectionOf(figure, triangles, weights, scale * height)); };
  Proportions result;
  result.height = heightOf(figure);
  result.chest = around(chestHeight);
  result.waist = around(waistHeight);
  result.hip = around(hipHeight);
  result.shoulder = (figure.places[indexOf(Joint::LeftUpperArm)] - figure.places[indexOf(Joint::RightUpperArm)]).norm();
  return result;
}

FigureShape withProportions(const FigureShape& figure, std::span<const Triangle> triangles,
                            std::span<const SkinWeights> weights, const Proportions& wanted) {
  const Change change = changeOf(measured(figure, triangles, weights), wanted);
  FigureShape result;
  for (std::size_t j = 0; j < jointCount; ++j) {
    const bool isArm = j >= indexOf(Joint::LeftShoulder) && j < indexOf(Joint::LeftThigh);
    result.places[j] = change.moved(figure.places[j], isArm ? 0.0 : 1.0, isArm ? 1.0 : 0.0);
  }
  result.positions.reserve(figure.positions.size());
  for (std::size_t v = 0; v < figure.positions.size(); ++v) {
    result.positions.push_back(change.moved(figure.positions[v], trunkShare(weights[v]), armShare(weights[v])));
  }
  return result;
}

}  // namespace drape::figure
