#include "dressing/body_parts.hpp"

#include "sim/model/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace drape::dressing {
namespace {

// Shares of the height of a body [-]. The ranges hold those of adults with a margin (Drillis and Contini 1966).
constexpr double besideTrunk = 0.085;  // the centre line of an arm is farther from the middle
constexpr double lowestArm = 0.3;
constexpr double legTop = 0.46;
constexpr double headBottom = 0.87;
constexpr double thinShare = 0.3;  // a limb keeps at most this share of its area as a centre line
constexpr int bands = 100;         // cross sections over the height

std::vector<double> areasOf(const std::vector<Vec3>& positions, std::span<const Triangle> triangles) {
  std::vector<double> areas(positions.size(), 0.0);
  for (const Triangle& t : triangles) {
    const double area = (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm();
    for (const int corner : t) {
      areas[corner] += area;
    }
  }
  return areas;
}

/// The full body, its centre lines, and its box.
struct Shape {
  const std::vector<Vec3>& full;
  const std::vector<Vec3>& lines;
  std::vector<double> areas;
  std::vector<double> lineAreas;
  Eigen::AlignedBox3d box;
  double middle = 0.0;  // of the upper half, along x [m]

  explicit Shape(const ShrinkingBody& body)
      : full(body.frames().front()),
        lines(body.frames()[body.centreLines()]),
        areas(areasOf(full, body.triangles())),
        lineAreas(areasOf(lines, body.triangles())),
        box(sim::boundsOf(full)) {
    double sum = 0.0;
    for (std::size_t v = 0; v < full.size(); ++v) {
      if (heightShare(v) > 0.5) {
        middle += areas[v] * full[v].x();
        sum += areas[v];
      }
    }
    middle = sum > 0.0 ? middle / sum : box.center().x();
  }

  [[nodiscard]] double height() const { return box.sizes().y(); }
  [[nodiscard]] double heightShare(std::size_t v) const { return (full[v].y() - box.min().y()) / height(); }
  [[nodiscard]] double beside(std::size_t v) const { return (lines[v].x() - middle) / height(); }
  [[nodiscard]] bool isThin(std::size_t v) const { return lineAreas[v] < thinShare * areas[v]; }
};

/// Whether the toes point along -z: the soles lie behind the ankles.
bool looksBack(const Shape& shape) {
  constexpr double soles = 0.03;
  constexpr double ankles = 0.06;
  Vec2 z = Vec2::Zero();
  Vec2 area = Vec2::Zero();
  for (std::size_t v = 0; v < shape.full.size(); ++v) {
    if (shape.heightShare(v) < ankles) {
      const int k = shape.heightShare(v) < soles ? 0 : 1;
      z[k] += shape.areas[v] * shape.full[v].z();
      area[k] += shape.areas[v];
    }
  }
  constexpr double clear = 0.01;  // of the height
  return area.minCoeff() > 0.0 && z[0] / area[0] - z[1] / area[1] < -clear * shape.height();
}

BodyPart partAt(const Shape& shape, std::size_t v, bool facesBack) {
  const double height = shape.heightShare(v);
  const double beside = facesBack ? -shape.beside(v) : shape.beside(v);
  if (std::abs(beside) > besideTrunk && height > lowestArm && shape.isThin(v)) {
    return beside > 0.0 ? BodyPart::LeftArm : BodyPart::RightArm;
  }
  if (height > headBottom) {
    return BodyPart::Head;
  }
  constexpr double betweenLegs = 0.015;
  if (height < legTop && std::abs(beside) > betweenLegs) {
    return beside > 0.0 ? BodyPart::LeftLeg : BodyPart::RightLeg;
  }
  return BodyPart::Trunk;
}

/// The box of the vertices of trunk, neck and head in each band of height.
std::vector<Eigen::AlignedBox3d> sectionsOf(const Shape& shape, const std::vector<BodyPart>& parts) {
  std::vector<Eigen::AlignedBox3d> sections(bands);
  for (std::size_t v = 0; v < parts.size(); ++v) {
    if (parts[v] == BodyPart::Trunk || parts[v] == BodyPart::Head) {
      sections[std::clamp(static_cast<int>(bands * shape.heightShare(v)), 0, bands - 1)].extend(shape.full[v]);
    }
  }
  return sections;
}

double girthOf(const Eigen::AlignedBox3d& section) {
  return section.isEmpty() ? std::numeric_limits<double>::max() : section.sizes().x() + section.sizes().z();
}

/// The band from `low` to `high` with the smallest girth.
int narrowest(const std::vector<Eigen::AlignedBox3d>& sections, int low, int high) {
  const auto begin = sections.begin();
  return static_cast<int>(std::ranges::min_element(begin + low, begin + high + 1, {}, girthOf) - begin);
}

BodyLandmarks landmarksOf(const Shape& shape, const std::vector<BodyPart>& parts) {
  const std::vector<Eigen::AlignedBox3d> sections = sectionsOf(shape, parts);
  constexpr int lowestNeck = 79;
  constexpr double shouldersBegin = 1.35;  // of the girth of the neck
  int neck = narrowest(sections, lowestNeck + 2, 92);
  const double girth = girthOf(sections[neck]);
  while (neck > lowestNeck && girthOf(sections[neck]) < shouldersBegin * girth) {
    --neck;
  }
  const int waist = narrowest(sections, 55, 70);
  return {sections[neck].isEmpty() ? shape.box.center() : Vec3(sections[neck].center()),
          sections[waist].isEmpty() ? shape.box.center() : Vec3(sections[waist].center()), shape.box.max().y()};
}

}  // namespace

BodyParts::BodyParts(const ShrinkingBody& body) {
  const Shape shape(body);
  facesBack_ = looksBack(shape);
  for (std::size_t v = 0; v < shape.full.size(); ++v) {
    parts_.push_back(partAt(shape, v, facesBack_));
  }
  const bool hasArms =
      std::ranges::count(parts_, BodyPart::LeftArm) > 0 && std::ranges::count(parts_, BodyPart::RightArm) > 0;
  constexpr double uprightShare = 0.8;  // of the largest extent; arms may be as long as the body is tall
  if (hasArms && shape.height() > uprightShare * shape.box.sizes().maxCoeff()) {
    landmarks_ = landmarksOf(shape, parts_);
  } else {
    std::ranges::fill(parts_, BodyPart::Whole);
    facesBack_ = false;
  }
}

BodyPart BodyParts::ofTriangle(const Triangle& triangle) const {
  // Arms first: a triangle at the border of a limb belongs to it.
  return std::max({parts_[triangle[0]], parts_[triangle[1]], parts_[triangle[2]]});
}

}  // namespace drape::dressing
