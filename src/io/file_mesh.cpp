#include "io/file_mesh.hpp"

#include "io/chained_index.hpp"
#include "sim/model/fingerprint.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace drape::io {
namespace {

using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

double largestCoordinateOf(const std::vector<Vec3>& points) {
  double largest = 0.0;
  for (const Vec3& point : points) {
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  return largest;
}

std::uint64_t hashOf(const Cell& cell) {
  std::uint64_t hash = 0;
  for (const std::int64_t coordinate : cell) {
    hash = sim::mixHash(hash, static_cast<std::uint64_t>(coordinate));
  }
  return hash;
}

/// Points in the cells of a grid.
class NearPoints {
 public:
  NearPoints(const std::vector<Vec3>& points, double tolerance)
      // Cells are much wider than the tolerance, so that most searches read one.
      : points_(points), tolerance_(tolerance), cell_(16.0 * tolerance), index_(points.size()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      index_.insert(hashOf(cellOf(points[i])), static_cast<int>(i));
    }
  }

  /// The nearest point within the tolerance, of equally near ones the first; or `none`.
  [[nodiscard]] int nearest(const Vec3& place) const {
    const Cell low = cellOf(place - Vec3::Constant(tolerance_));
    const Cell high = cellOf(place + Vec3::Constant(tolerance_));
    int best = ChainedIndex::none;
    double distance = tolerance_;
    Cell cell;
    for (cell.z() = low.z(); cell.z() <= high.z(); ++cell.z()) {
      for (cell.y() = low.y(); cell.y() <= high.y(); ++cell.y()) {
        for (cell.x() = low.x(); cell.x() <= high.x(); ++cell.x()) {
          searchCell(cell, place, best, distance);
        }
      }
    }
    return best;
  }

 private:
  [[nodiscard]] Cell cellOf(const Vec3& point) const { return (point / cell_).array().floor().cast<std::int64_t>(); }

  void searchCell(const Cell& cell, const Vec3& place, int& best, double& distance) const {
    for (int i = index_.first(hashOf(cell)); i != ChainedIndex::none; i = index_.next(i)) {
      const double away = (points_[i] - place).norm();
      if (away < distance || (away <= distance && (best == ChainedIndex::none || i < best))) {
        best = i;
        distance = away;
      }
    }
  }

  const std::vector<Vec3>& points_;
  double tolerance_;
  double cell_;
  ChainedIndex index_;
};

}  // namespace

void FileMesh::endFace() {
  constexpr int minCorners = 3;
  const int first = faceEnds.empty() ? 0 : faceEnds.back();
  if (static_cast<int>(corners.size()) - first < minCorners) {
    corners.resize(first);
    uvCorners.resize(std::min(uvCorners.size(), corners.size()));
    return;
  }
  faceEnds.push_back(static_cast<int>(corners.size()));
}

std::vector<int> verticesInLibrary(const FileMesh& file, const std::vector<Vec3>& points) {
  // Rounding to float moves a coordinate by at most 6e-8 of its size; the library's own reading of text by a little
  // more.
  constexpr double rounding = 1e-6;
  const double largest = largestCoordinateOf(points);
  if (!(largest > 0.0)) {
    std::vector<int> allAtOrigin(file.positions.size(), points.empty() ? -1 : 0);
    return allAtOrigin;
  }
  const NearPoints near(points, rounding * largest);
  std::vector<int> found;
  found.reserve(file.positions.size());
  for (const Vec3& place : file.positions) {
    found.push_back(near.nearest(place));
  }
  return found;
}

}  // namespace drape::io
