#include "dressing/garment_openings.hpp"

#include "scene/boundary_loops.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drape::dressing {
namespace {

/// The loops that are openings of hollow shapes and have the size of one, highest first.
std::vector<scene::BoundaryLoop> openLoops(const scene::ClothPieces& pieces) {
  constexpr double smallestOpening = 0.12;  // around [m]; buttonholes and gaps of the mesh are smaller
  std::vector<scene::BoundaryLoop> loops;
  for (const scene::BoundaryLoop& loop : pieces.loops) {
    if (loop.length > smallestOpening && !pieces.isOutline(loop)) {
      loops.push_back(loop);
    }
  }
  std::ranges::stable_sort(loops, std::greater(), [](const scene::BoundaryLoop& loop) { return loop.centre.y(); });
  return loops;
}

/// Whether a loop can be the end of a sleeve: it is beside the middle, and does not lie flat.
bool isSideways(const scene::BoundaryLoop& loop, const Eigen::AlignedBox3d& box) {
  constexpr double besideMiddle = 0.2;  // of the width
  constexpr double flat = 0.97;         // cosine of the angle between its normal and the vertical
  const double size = loop.area.norm();
  return std::abs(loop.centre.x() - box.center().x()) > besideMiddle * box.sizes().x() && size > 0.0 &&
         std::abs(loop.area.y()) < flat * size;
}

/// Takes the two loops of the sleeves out of the list: the highest on each side that are mirror images in height.
void takeSleeves(std::vector<scene::BoundaryLoop>& loops, const Eigen::AlignedBox3d& box,
                 std::vector<Opening>& openings) {
  const auto find = [&](double side) {
    return std::ranges::find_if(loops, [&](const scene::BoundaryLoop& loop) {
      return isSideways(loop, box) && side * (loop.centre.x() - box.center().x()) > 0.0;
    });
  };
  const auto left = find(1.0);
  const auto right = find(-1.0);
  constexpr double sameHeight = 0.2;  // of the height of the garment
  if (left == loops.end() || right == loops.end() ||
      std::abs(left->centre.y() - right->centre.y()) > sameHeight * box.sizes().y()) {
    return;
  }
  openings.push_back({OpeningKind::LeftSleeve, left->vertices, left->centre});
  openings.push_back({OpeningKind::RightSleeve, right->vertices, right->centre});
  const std::vector<int> lowest{left->vertices.front(), right->vertices.front()};
  std::erase_if(loops, [&](const scene::BoundaryLoop& loop) {
    return loop.vertices.front() == lowest[0] || loop.vertices.front() == lowest[1];
  });
}

/// The width of the garment a fifth of its height below its top [m].
double widthBelowTop(const sim::ClothMesh& garment, const Eigen::AlignedBox3d& box) {
  Eigen::AlignedBox3d band;
  for (const Vec3& point : garment.positions) {
    if (std::abs(box.max().y() - 0.2 * box.sizes().y() - point.y()) < 0.05 * box.sizes().y()) {
      band.extend(point);
    }
  }
  return band.isEmpty() ? 0.0 : std::max(band.sizes().x(), band.sizes().z());
}

double widthOf(const scene::BoundaryLoop& loop, const sim::ClothMesh& garment) {
  Eigen::AlignedBox3d box;
  for (const int vertex : loop.vertices) {
    box.extend(garment.positions[vertex]);
  }
  return std::max(box.sizes().x(), box.sizes().z());
}

/// The area of a loop, towards the top.
Vec3 upwards(const scene::BoundaryLoop& loop) {
  return loop.area.y() < 0.0 ? Vec3(-loop.area) : loop.area;
}

}  // namespace

bool isSleeve(OpeningKind kind) {
  return kind == OpeningKind::LeftSleeve || kind == OpeningKind::RightSleeve;
}

GarmentOpenings::GarmentOpenings(const sim::ClothMesh& garment) {
  const Eigen::AlignedBox3d box = sim::boundsOf(garment.positions);
  const scene::ClothPieces pieces = scene::findPieces(garment);
  std::vector<scene::BoundaryLoop> loops = openLoops(pieces);
  takeSleeves(loops, box, openings_);
  const bool hasSleeves = !openings_.empty();
  constexpr double upperPart = 0.6;  // of the height: a neck or a waist is above
  for (std::size_t k = 0; k < loops.size(); ++k) {
    OpeningKind kind = OpeningKind::Hem;
    if (k == 0 && loops[k].centre.y() > box.min().y() + upperPart * box.sizes().y()) {
      constexpr double shoulders = 2.0;  // over the width of a neck opening; a skirt is less flared
      const bool isNeck = hasSleeves || widthBelowTop(garment, box) > shoulders * widthOf(loops[k], garment);
      kind = isNeck ? OpeningKind::Neck : OpeningKind::Waist;
    }
    openings_.push_back({kind, loops[k].vertices, loops[k].centre});
    constexpr double clearSlope = 0.1;
    if (kind == OpeningKind::Neck && hasSleeves) {
      facesBack_ = upwards(loops[k]).z() < -clearSlope * loops[k].area.norm();
    }
  }
  if (facesBack_) {
    for (Opening& opening : openings_) {
      if (isSleeve(opening.kind)) {
        opening.kind = opening.kind == OpeningKind::LeftSleeve ? OpeningKind::RightSleeve : OpeningKind::LeftSleeve;
      }
    }
  }
}

const Opening* GarmentOpenings::find(OpeningKind kind) const {
  const auto found = std::ranges::find(openings_, kind, &Opening::kind);
  return found == openings_.end() ? nullptr : &*found;
}

Vec3 centreOf(const Opening& opening, std::span<const Vec3> positions) {
  Vec3 sum = Vec3::Zero();
  for (const int vertex : opening.vertices) {
    sum += positions[vertex];
  }
  return sum / static_cast<double>(opening.vertices.size());
}

sim::ClothMesh spanning(const Opening& opening, std::span<const Vec3> positions) {
  sim::ClothMesh fan;
  for (const int vertex : opening.vertices) {
    fan.positions.push_back(positions[vertex]);
  }
  const auto count = static_cast<int>(opening.vertices.size());
  fan.positions.push_back(centreOf(opening, positions));
  for (int k = 0; k < count; ++k) {
    fan.triangles.push_back({k, (k + 1) % count, count});
  }
  return fan;
}

}  // namespace drape::dressing
