#include "scene/up_guess.hpp"

#include "scene/open_neckline.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::scene {
namespace {

constexpr int cells = 16;  // of a silhouette along each axis
constexpr int finest = 5;  // maximum number of subdivisions of a triangle

/// The distribution of a surface's area seen along one axis: two of the three axes, each in `cells` cells.
class Silhouette {
 public:
  Silhouette(int across, int along) : across_(across), along_(along) {}

  /// Adds an amount at a point of the unit cube, distributed to the four nearest cells.
  void add(const Vec3& point, double amount) {
    const double u = std::clamp(point[across_] * cells - 0.5, 0.0, cells - 1.001);
    const double v = std::clamp(point[along_] * cells - 0.5, 0.0, cells - 1.001);
    const int column = static_cast<int>(u);
    const int row = static_cast<int>(v);
    const double right = u - column;
    const double up = v - row;
    cell(column, row) += amount * (1.0 - right) * (1.0 - up);
    cell(column + 1, row) += amount * right * (1.0 - up);
    cell(column, row + 1) += amount * (1.0 - right) * up;
    cell(column + 1, row + 1) += amount * right * up;
  }

  /// 0: symmetric with respect to the first axis; 1: no overlap with the mirror image.
  [[nodiscard]] double asymmetry() const {
    double apart = 0.0;
    double total = 0.0;
    for (int row = 0; row < cells; ++row) {
      for (int column = 0; column < cells; ++column) {
        apart += std::abs(amount(column, row) - amount(cells - 1 - column, row));
        total += 2.0 * amount(column, row);
      }
    }
    return total > 0.0 ? apart / total : 0.0;
  }

 private:
  double& cell(int column, int row) { return amounts_[row * cells + column]; }
  [[nodiscard]] double amount(int column, int row) const { return amounts_[row * cells + column]; }

  int across_;
  int along_;
  std::array<double, static_cast<std::size_t>(cells* cells)> amounts_{};
};

/// Visits sample points of a triangle with their areas: its centre, or those of its quarters when it is larger than a
/// cell.
template <typename Visit>
void spread(const Vec3& a, const Vec3& b, const Vec3& c, int depth, const Visit& visit) {
  constexpr double small = 0.7 / cells;
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  if (depth == 0 || longest < small) {
    visit((a + b + c) / 3.0, std::pow(0.25, finest - depth));
    return;
  }
  const Vec3 ab = 0.5 * (a + b);
  const Vec3 bc = 0.5 * (b + c);
  const Vec3 ca = 0.5 * (c + a);
  spread(a, ab, ca, depth - 1, visit);
  spread(ab, b, bc, depth - 1, visit);
  spread(ca, bc, c, depth - 1, visit);
  spread(ab, bc, ca, depth - 1, visit);
}

std::array<double, 3> asymmetries(const sim::ClothMesh& mesh, const Eigen::AlignedBox3d& box) {
  const Vec3 size = box.sizes().cwiseMax(1e-3 * box.sizes().maxCoeff());
  const auto within = [&](int vertex) -> Vec3 {
    const Vec3 fromMiddle = mesh.positions[static_cast<std::size_t>(vertex)] - box.center();
    return fromMiddle.cwiseQuotient(size) + Vec3::Constant(0.5);
  };
  std::array<double, 3> result{};
  for (int axis = 0; axis < 3; ++axis) {
    std::array<Silhouette, 2> views{Silhouette(axis, (axis + 1) % 3), Silhouette(axis, (axis + 2) % 3)};
    for (const Triangle& triangle : mesh.triangles) {
      const auto corner = [&](std::size_t i) -> const Vec3& {
        return mesh.positions[static_cast<std::size_t>(triangle[i])];
      };
      const double area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
      spread(within(triangle[0]), within(triangle[1]), within(triangle[2]), finest,
             [&](const Vec3& point, double share) {
               views[0].add(point, share * area);
               views[1].add(point, share * area);
             });
    }
    result[static_cast<std::size_t>(axis)] = 0.5 * (views[0].asymmetry() + views[1].asymmetry());
  }
  return result;
}

/// The axis along which two openings are mirror images, as those of two sleeves or two trouser legs are; -1 if none.
int mirrorAxis(const BoundaryLoop& a, const BoundaryLoop& b, const Eigen::AlignedBox3d& box) {
  constexpr double equal = 0.1;  // of the box or the length
  constexpr double apart = 0.3;  // of the box
  if (a.piece != b.piece || std::abs(a.length - b.length) > equal * a.length) {
    return -1;
  }
  const Vec3 between = (a.centre - b.centre).cwiseAbs();
  const Vec3 offMiddle = (a.centre + b.centre - 2.0 * box.center()).cwiseAbs();
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 off = between;
    off[axis] = offMiddle[axis];
    if (between[axis] > apart * box.sizes()[axis] && (off.array() <= equal * box.sizes().array()).all()) {
      return axis;
    }
  }
  return -1;
}

/// The axis along which an opening for an arm or a leg has its mirror image; -1 if it has none. The two ends of a tube
/// are mirror images, too, so only pieces with more borders count.
int axisOfLimbs(const BoundaryLoop& loop, const ClothPieces& pieces, const Eigen::AlignedBox3d& box) {
  if (pieces.pieces[loop.piece].loops > 2) {
    for (const BoundaryLoop& other : pieces.loops) {
      if (const int axis = mirrorAxis(loop, other, box); axis >= 0) {
        return axis;
      }
    }
  }
  return -1;
}

/// The shares of the necklines of a garment that is open from top to bottom.
std::array<double, 3> sharesOfNecklines(const sim::ClothMesh& mesh, const ClothPieces& pieces) {
  std::array<double, 3> shares{};
  double total = 0.0;
  for (int up = 0; up < 3; ++up) {
    const double found = findOpenNeckline(mesh, pieces, up) ? 1.0 : 0.0;
    shares[static_cast<std::size_t>(up)] = found;
    total += found;
  }
  std::ranges::for_each(shares, [&](double& share) { share /= std::max(1.0, total); });
  return shares;
}

/// Sets the evidence from openings.
void findOpenings(const sim::ClothMesh& mesh, const ClothPieces& pieces, const Eigen::AlignedBox3d& box,
                  UpEvidence& evidence) {
  constexpr double smallest =
      1e-3;  // relative to the square of the box's diagonal; a smaller opening is a slit or a defect
  std::array<double, 3>& shares = evidence.openings;
  double total = 0.0;
  for (const BoundaryLoop& loop : pieces.loops) {
    const double area = loop.area.norm();
    if (pieces.isOutline(loop) || area < smallest * box.diagonal().squaredNorm()) {
      continue;
    }
    if (const int sideways = axisOfLimbs(loop, pieces, box); sideways >= 0) {
      evidence.limbs[static_cast<std::size_t>(sideways)] = 1.0;
      continue;
    }
    total += area;
    for (int axis = 0; axis < 3; ++axis) {
      const double facing = loop.area[axis] / area;
      shares[static_cast<std::size_t>(axis)] += area * facing * facing;
    }
  }
  if (!(total > 0.0)) {
    shares = sharesOfNecklines(mesh, pieces);
    return;
  }
  for (double& share : shares) {
    share /= total;
  }
}

}  // namespace

bool isFlat(const Vec3& extent) {
  constexpr double flatness = 0.02;
  return extent.minCoeff() < flatness * extent.maxCoeff();
}

UpGuess guessUp(const sim::ClothMesh& mesh, const ClothPieces& pieces) {
  constexpr std::array<double, 3> usual{-0.6, 0.15, 0.0};  // files with y up are the most common, with x up the rarest
  constexpr double openingWeight = 1.5;
  constexpr double asymmetryWeight = 1.0;
  constexpr double limbWeight = -1.0;
  constexpr double extentWeight = 0.8;
  constexpr double extentWeightAlone = 1.3;  // for a shape without openings
  UpGuess guess;
  const Eigen::AlignedBox3d box = sim::boundsOf(mesh.positions);
  UpEvidence& evidence = guess.evidence;
  findOpenings(mesh, pieces, box, evidence);
  evidence.asymmetry = asymmetries(mesh, box);
  const bool open = std::any_of(evidence.openings.begin(), evidence.openings.end(), [](double s) { return s > 0.0; });
  const double largest = std::max(std::numeric_limits<double>::min(), box.sizes().maxCoeff());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    evidence.extent[axis] = box.sizes()[static_cast<Eigen::Index>(axis)] / largest;
    evidence.score[axis] = usual[axis] + openingWeight * evidence.openings[axis] + limbWeight * evidence.limbs[axis] +
                           asymmetryWeight * evidence.asymmetry[axis] +
                           (open ? extentWeight : extentWeightAlone) * evidence.extent[axis];
  }
  if (!open && isFlat(box.sizes())) {
    return guess;  // a flat sheet may lie or hang: the more common axis decides
  }
  guess.axis =
      static_cast<int>(std::max_element(evidence.score.begin(), evidence.score.end()) - evidence.score.begin());
  std::array<double, 3> sorted = evidence.score;
  std::sort(sorted.begin(), sorted.end());
  guess.margin = sorted[2] - sorted[1];
  return guess;
}

}  // namespace drape::scene
