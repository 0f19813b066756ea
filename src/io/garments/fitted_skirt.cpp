#include "io/garments/flat_pattern.hpp"
#include "io/garments/garments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace drape::io {
namespace {

constexpr double edgeLength = 0.0205;  // [m]
constexpr double waistLine = 1.045;    // height of the upper border [m]
constexpr double hemLine = 0.47;       // height of the lower border [m]
constexpr double slant = 1.035;        // the cloth's length over its height [-]

/// A horizontal section of the skirt: an ellipse.
struct Section {
  double halfWidth = 0.0;  // along x [m]
  double halfDepth = 0.0;  // along z [m]
};

/// Close to the figure at the waist, and wider than its hips. @param down 0 at the waist, 1 at the hem
Section sectionAt(double down) {
  return {0.138 + down * (0.200 - 0.038 * down), 0.092 + down * (0.075 + 0.068 * down)};
}

/// The lengths along the front half of a section, from the middle (+z) to the side (+x).
class QuarterArc {
 public:
  explicit QuarterArc(const Section& section) : section_(section) {
    for (std::size_t k = 1; k < lengths_.size(); ++k) {
      lengths_[k] = lengths_[k - 1] + (at(angleOf(k)) - at(angleOf(k - 1))).norm();
    }
  }
  [[nodiscard]] double length() const { return lengths_.back(); }
  /// The point (x, z) at a share of the length, -1 to 1.
  [[nodiscard]] Vec2 pointAt(double share) const {
    const double wanted = std::min(std::abs(share), 1.0) * length();
    const auto next = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, wanted);
    const auto k = static_cast<std::size_t>(next - lengths_.begin());
    const double part = (wanted - lengths_[k - 1]) / (lengths_[k] - lengths_[k - 1]);
    const Vec2 point = at(angleOf(k - 1) + part * (angleOf(k) - angleOf(k - 1)));
    return {std::copysign(point.x(), share), point.y()};
  }

 private:
  static constexpr std::size_t parts = 64;
  static double angleOf(std::size_t k) { return std::numbers::pi / 2.0 * static_cast<double>(k) / parts; }
  [[nodiscard]] Vec2 at(double angle) const {
    return {section_.halfWidth * std::sin(angle), section_.halfDepth * std::cos(angle)};
  }

  Section section_;
  std::array<double, parts + 1> lengths_{};
};

double heightOf(double flatHeight) {
  return waistLine + flatHeight / slant;  // the flat panel hangs below 0
}

double downAt(double flatHeight) {
  return -flatHeight / slant / (waistLine - hemLine);
}

/// Front or back, laid flat: its width at each height is half the circumference.
FlatMesh meshSkirtPanel() {
  constexpr double bottom = -slant * (waistLine - hemLine);
  const auto side = [](double flatHeight) {
    return Vec2(QuarterArc(sectionAt(downAt(flatHeight))).length(), flatHeight);
  };
  const auto mirrored = [](const Vec2& point) { return Vec2(-point.x(), point.y()); };
  Outline outline(mirrored(side(bottom)), edgeLength);
  outline.lineTo(side(bottom), false);
  outline.curveTo([&](double t) { return side(bottom * (1.0 - t)); }, true);
  outline.lineTo(mirrored(side(0.0)), false);
  outline.curveTo([&](double t) { return mirrored(side(bottom * t)); }, true);
  return meshPattern({outline.points(), {}}, edgeLength);
}

}  // namespace

RawMesh makeFittedSkirt() {
  const FlatMesh panel = meshSkirtPanel();
  RawMesh skirt;
  for (const bool front : {true, false}) {
    std::vector<Vec3> positions;
    for (const Vec2& flat : panel.points) {
      const QuarterArc arc(sectionAt(downAt(flat.y())));
      const Vec2 point = arc.pointAt(flat.x() / arc.length());
      const double facing = front ? 1.0 : -1.0;
      positions.emplace_back(facing * point.x(), heightOf(flat.y()), facing * point.y());
    }
    const Vec2 aside(front ? 0.0 : 1.2, slant * (waistLine - hemLine));
    addPiece(panel, positions, std::vector<Vec2>(panel.triangles.size(), aside), skirt);
  }
  return skirt;
}

}  // namespace drape::io
