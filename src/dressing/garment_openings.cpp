#include "dressing/garment_openings.hpp"

#include "scene/boundary_loops.hpp"
#include "scene/open_neckline.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <array>
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

/// Two loops of a piece that are mirror images: a pair of sleeves or of legs.
struct LimbPair {
  const scene::BoundaryLoop* left = nullptr;  ///< towards +x
  const scene::BoundaryLoop* right = nullptr;
  [[nodiscard]] double height() const { return 0.5 * (left->centre.y() + right->centre.y()); }
};

bool arePair(const scene::BoundaryLoop& left, const scene::BoundaryLoop& right, const Eigen::AlignedBox3d& box) {
  constexpr double sameHeight = 0.2;    // of the height of the garment
  constexpr double sameDistance = 0.2;  // from the middle, of the width of the garment
  constexpr double sameLength = 1.5;
  constexpr double acrossMiddle = 0.1;  // of the width of the loop
  const double middle = box.center().x();
  return left.piece == right.piece && left.box.min().x() > middle - acrossMiddle * left.box.sizes().x() &&
         right.box.max().x() < middle + acrossMiddle * right.box.sizes().x() &&
         std::abs(left.centre.y() - right.centre.y()) < sameHeight * box.sizes().y() &&
         std::abs(left.centre.x() + right.centre.x() - 2.0 * middle) < sameDistance * box.sizes().x() &&
         left.length < sameLength * right.length && right.length < sameLength * left.length;
}

/// @param loops highest first  @return highest first
std::vector<LimbPair> limbPairs(const std::vector<scene::BoundaryLoop>& loops, const Eigen::AlignedBox3d& box) {
  std::vector<LimbPair> pairs;
  for (const scene::BoundaryLoop& left : loops) {
    const auto right = std::ranges::find_if(loops, [&](const scene::BoundaryLoop& each) {
      const bool isTaken = std::ranges::find(pairs, &each, &LimbPair::right) != pairs.end();
      return !isTaken && arePair(left, each, box);
    });
    if (right != loops.end()) {
      pairs.push_back({&left, &*right});
    }
  }
  return pairs;
}

/// Takes the loops of arms and legs out of the list. The highest pairs are for arms and the lowest ones for legs, which
/// have no opening below them. Pairs at one height belong to layers. Of trousers the only other opening is the waist,
/// of a vest there is none.
void takeLimbs(std::vector<scene::BoundaryLoop>& loops, const Eigen::AlignedBox3d& box,
               std::vector<Opening>& openings) {
  const std::vector<LimbPair> pairs = limbPairs(loops, box);
  if (pairs.empty()) {
    return;
  }
  const double oneHeight = 0.1 * box.sizes().y();
  const double top = pairs.front().height();
  const double bottom = pairs.back().height();
  const auto layers =
      std::ranges::count_if(pairs, [&](const LimbPair& pair) { return pair.height() < bottom + oneHeight; });
  const auto others = static_cast<std::ptrdiff_t>(loops.size() - 2 * pairs.size());
  const bool isLowest = loops.back().centre.y() > bottom - oneHeight;
  const bool hasTwoHeights = top > bottom + oneHeight;
  const bool hasLegs = isLowest && (hasTwoHeights || (others > 0 && others <= layers));
  std::vector<const scene::BoundaryLoop*> taken;
  for (const LimbPair& pair : pairs) {
    const bool isLeg = hasLegs && pair.height() < bottom + oneHeight;
    const bool isSleeve = !isLeg && pair.height() > top - oneHeight;
    if (isLeg || isSleeve) {
      openings.push_back(
          {isLeg ? OpeningKind::LeftLeg : OpeningKind::LeftSleeve, pair.left->vertices, pair.left->centre});
      openings.push_back(
          {isLeg ? OpeningKind::RightLeg : OpeningKind::RightSleeve, pair.right->vertices, pair.right->centre});
      taken.insert(taken.end(), {pair.left, pair.right});
    }
  }
  std::vector<scene::BoundaryLoop> rest;
  for (const scene::BoundaryLoop& loop : loops) {
    if (std::ranges::find(taken, &loop) == taken.end()) {
      rest.push_back(loop);
    }
  }
  loops = std::move(rest);
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

double widthOf(const scene::BoundaryLoop& loop) {
  return std::max(loop.box.sizes().x(), loop.box.sizes().z());
}

/// The area of a loop, towards the top.
Vec3 upwards(const scene::BoundaryLoop& loop) {
  return loop.area.y() < 0.0 ? Vec3(-loop.area) : loop.area;
}

/// Whether a loop is high enough for a neck or a waist.
bool isHighest(const scene::BoundaryLoop& loop, const Eigen::AlignedBox3d& box) {
  constexpr double upperPart = 0.6;  // of the height
  return loop.centre.y() > box.min().y() + upperPart * box.sizes().y();
}

/// Whether a loop is the opening of a hood for the face: it faces the front, and cloth is above it. A deep neckline
/// reaches up to the shoulders, which are the top of its garment.
bool isHood(const scene::BoundaryLoop& loop, const Eigen::AlignedBox3d& box) {
  constexpr double steep = 0.5;        // cosine of the angle between its normal and the vertical
  constexpr double clothAbove = 0.02;  // of the height
  return isHighest(loop, box) && std::abs(loop.area.y()) < steep * loop.area.norm() &&
         loop.box.max().y() < box.max().y() - clothAbove * box.sizes().y();
}

/// Whether a neckline is lower towards -z.
bool slopesBack(const scene::BoundaryLoop& loop) {
  constexpr double clearSlope = 0.1;
  return upwards(loop).z() < -clearSlope * loop.area.norm();
}

bool hasOutline(const scene::ClothPieces& pieces, int piece) {
  return std::ranges::any_of(
      pieces.loops, [&](const scene::BoundaryLoop& loop) { return loop.piece == piece && pieces.isOutline(loop); });
}

/// Whether the outline of a sheet is towards -z: the front edges of a vest or of a jacket, or those of an apron. Few
/// garments are open at the back.
/// @param middle of the openings for arms or neck, along z [m]
bool hangsBehind(const scene::ClothPieces& pieces, double middle, const Eigen::AlignedBox3d& box) {
  constexpr double clear = 0.05;  // of the depth
  return std::ranges::any_of(pieces.loops, [&](const scene::BoundaryLoop& loop) {
    return pieces.isOutline(loop) && loop.centre.z() < middle - clear * box.sizes().z();
  });
}

/// Whether the gap is towards -z.
bool isOpenBehind(const scene::OpenNeckline& neckline) {
  constexpr double clear = 0.1;  // of the width
  return neckline.gap.z() < neckline.centre.z() - clear * neckline.width;
}

/// A neck opening is narrower than the shoulders by this factor; a skirt is less flared below its waist.
constexpr double shoulders = 2.0;

}  // namespace

bool isLeg(OpeningKind kind) {
  return kind == OpeningKind::LeftLeg || kind == OpeningKind::RightLeg;
}

bool isSleeve(OpeningKind kind) {
  return kind == OpeningKind::LeftSleeve || kind == OpeningKind::RightSleeve;
}

GarmentOpenings::GarmentOpenings(const sim::ClothMesh& garment) {
  const Eigen::AlignedBox3d box = sim::boundsOf(garment.positions);
  const scene::ClothPieces pieces = scene::findPieces(garment);
  std::vector<scene::BoundaryLoop> loops = openLoops(pieces);
  takeLimbs(loops, box, openings_);
  const bool hasSleeves = find(OpeningKind::LeftSleeve) != nullptr;
  const double middle = hasSleeves ? find(OpeningKind::LeftSleeve)->centre.z() : box.center().z();
  if (!loops.empty() && isHood(loops.front(), box)) {
    openings_.push_back({OpeningKind::Hood, loops.front().vertices, loops.front().centre});
    facesBack_ = loops.front().centre.z() < middle;
    loops.erase(loops.begin());
  } else if (!loops.empty() && isHighest(loops.front(), box)) {
    const scene::BoundaryLoop& loop = loops.front();
    const bool isSheet = hasOutline(pieces, loop.piece);  // with a hole for the head: a poncho, an apron
    const bool isNeck = hasSleeves || isSheet || widthBelowTop(garment, box) > shoulders * widthOf(loop);
    facesBack_ = hasSleeves ? slopesBack(loop) : isSheet && hangsBehind(pieces, loop.centre.z(), box);
    openings_.push_back(
        {isNeck ? OpeningKind::Neck : OpeningKind::Waist, loops.front().vertices, loops.front().centre});
    loops.erase(loops.begin());
  } else {
    takeOpenNeckline(garment, pieces);
    facesBack_ = hasSleeves ? hangsBehind(pieces, middle, box) : facesBack_;
  }
  for (const scene::BoundaryLoop& loop : loops) {
    openings_.push_back({OpeningKind::Hem, loop.vertices, loop.centre});
  }
  if (facesBack_) {
    swapSides();
  }
}

/// Adds the neck or the waist of a garment that is open from top to bottom.
void GarmentOpenings::takeOpenNeckline(const sim::ClothMesh& garment, const scene::ClothPieces& pieces) {
  const std::optional<scene::OpenNeckline> found = scene::findOpenNeckline(garment, pieces);
  if (!found) {
    return;
  }
  const bool hasSleeves = find(OpeningKind::LeftSleeve) != nullptr;
  const bool isNeck = hasSleeves || widthBelowTop(garment, sim::boundsOf(garment.positions)) > shoulders * found->width;
  openings_.push_back({isNeck ? OpeningKind::Neck : OpeningKind::Waist, found->vertices, found->centre, true});
  facesBack_ = isOpenBehind(*found);
}

/// Exchanges left and right.
void GarmentOpenings::swapSides() {
  static constexpr std::array<std::array<OpeningKind, 2>, 2> sides{
      {{OpeningKind::LeftSleeve, OpeningKind::RightSleeve}, {OpeningKind::LeftLeg, OpeningKind::RightLeg}}};
  for (Opening& opening : openings_) {
    for (const auto& [left, right] : sides) {
      if (opening.kind == left || opening.kind == right) {
        opening.kind = opening.kind == left ? right : left;
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
