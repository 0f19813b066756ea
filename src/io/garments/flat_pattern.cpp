#include "io/garments/flat_pattern.hpp"

#include "io/garments/delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>

namespace drape::io {
namespace {

/// Rounds, since the last digits of sines and cosines differ between machines, and the triangulation must not.
Vec2 rounded(const Vec2& point) {
  return (point * 1e9).array().round() / 1e9;
}

double distanceToStretch(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double t = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - a - t * along).norm();
}

double distanceToLine(const Vec2& point, const std::vector<Vec2>& line, bool closed) {
  double distance = HUGE_VAL;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
    distance = std::min(distance, distanceToStretch(point, line[i], line[(i + 1) % line.size()]));
  }
  return distance;
}

/// Whether a lattice point is inside with a clearance; near the outline it would make flat triangles.
bool isFree(const FlatPattern& pattern, const Vec2& point, double clearance) {
  return isInside(pattern.outline, point) && distanceToLine(point, pattern.outline, true) >= clearance &&
         std::all_of(pattern.lines.begin(), pattern.lines.end(),
                     [&](const std::vector<Vec2>& line) { return distanceToLine(point, line, false) >= clearance; });
}

/// Adds the points of a lattice of equilateral triangles.
void addLattice(const FlatPattern& pattern, double edgeLength, std::vector<Vec2>& points) {
  Vec2 low = pattern.outline.front();
  Vec2 high = low;
  for (const Vec2& point : pattern.outline) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double rowHeight = edgeLength * std::sqrt(0.75);
  const int rows = static_cast<int>((high.y() - low.y()) / rowHeight) + 1;
  const int columns = static_cast<int>(std::max(-low.x(), high.x()) / edgeLength) + 1;
  for (int row = 0; row <= rows; ++row) {
    for (int column = -columns; column <= columns; ++column) {
      const double shift = row % 2 == 0 ? 0.0 : 0.5;
      const Vec2 point = rounded({(column + shift) * edgeLength, low.y() + row * rowHeight});
      if (isFree(pattern, point, 0.65 * edgeLength)) {
        points.push_back(point);
      }
    }
  }
}

/// The Delaunay triangles inside the pattern that are not flat.
std::vector<Triangle> fill(const FlatPattern& pattern, const std::vector<Vec2>& points, double edgeLength) {
  std::vector<Triangle> triangles = delaunay(points);
  std::erase_if(triangles, [&](const Triangle& triangle) {
    const Vec2& a = points[triangle[0]];
    const Vec2 ab = points[triangle[1]] - a;
    const Vec2 ac = points[triangle[2]] - a;
    const double twiceArea = ab.x() * ac.y() - ab.y() * ac.x();
    return twiceArea < 1e-3 * edgeLength * edgeLength || !isInside(pattern.outline, a + (ab + ac) / 3.0);
  });
  return triangles;
}

/// Moves every point from `firstFree` on to the mean of its neighbours, several times.
void smooth(const std::vector<Triangle>& triangles, std::size_t firstFree, std::vector<Vec2>& points) {
  constexpr int passes = 10;
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<Vec2> sum(points.size(), Vec2::Zero());
    std::vector<int> count(points.size(), 0);
    for (const Triangle& triangle : triangles) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        sum[triangle[corner]] += points[triangle[(corner + 1) % 3]];
        ++count[triangle[corner]];
      }
    }
    for (std::size_t i = firstFree; i < points.size(); ++i) {
      points[i] = rounded(sum[i] / std::max(1, count[i]));
    }
  }
}

}  // namespace

bool isInside(const std::vector<Vec2>& outline, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& a = outline[i];
    const Vec2& b = outline[(i + 1) % outline.size()];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y())) {
      inside = !inside;
    }
  }
  return inside;
}

std::vector<Vec2> sampleCurve(const std::function<Vec2(double)>& curve, double edgeLength) {
  constexpr int fine = 2000;
  std::vector<double> length{0.0};
  for (int i = 1; i <= fine; ++i) {
    length.push_back(length.back() + (curve(double(i) / fine) - curve(double(i - 1) / fine)).norm());
  }
  const int stretches = std::max(1, static_cast<int>(std::lround(length.back() / edgeLength)));
  std::vector<Vec2> points;
  for (int i = 0; i <= stretches; ++i) {
    const double wanted = length.back() * i / stretches;
    const auto upper = std::lower_bound(length.begin() + 1, length.end() - 1, wanted);
    const double part = (wanted - *(upper - 1)) / (*upper - *(upper - 1));
    points.push_back(rounded(curve((static_cast<double>(upper - 1 - length.begin()) + part) / fine)));
  }
  return points;
}

void Outline::lineTo(const Vec2& end, bool sewn) {
  const Vec2 start = points_.back();
  curveTo([&](double t) -> Vec2 { return start + t * (end - start); }, sewn);
}

void Outline::curveTo(const std::function<Vec2(double)>& curve, bool sewn) {
  const std::vector<Vec2> samples = sampleCurve(curve, edgeLength_);
  points_.insert(points_.end(), samples.begin() + 1, samples.end());
  stretchSewn_.resize(points_.size() - 1, sewn);
}

std::vector<Vec2> Outline::points() const {
  return {points_.begin(), points_.end() - 1};
}

std::vector<bool> Outline::sewn() const {
  std::vector<bool> result;
  for (std::size_t i = 0; i < stretchSewn_.size(); ++i) {
    result.push_back(stretchSewn_[i] || stretchSewn_[i == 0 ? stretchSewn_.size() - 1 : i - 1]);
  }
  return result;
}

FlatMesh meshPattern(const FlatPattern& pattern, double edgeLength) {
  FlatMesh mesh;
  mesh.points = pattern.outline;
  for (const std::vector<Vec2>& line : pattern.lines) {
    // The ends of the line are already points of the outline.
    mesh.points.insert(mesh.points.end(), line.begin() + 1, line.end() - 1);
  }
  const std::size_t firstFree = mesh.points.size();
  addLattice(pattern, edgeLength, mesh.points);
  smooth(fill(pattern, mesh.points, edgeLength), firstFree, mesh.points);
  mesh.triangles = fill(pattern, mesh.points, edgeLength);
  return mesh;
}

void addPiece(const FlatMesh& piece, const std::vector<Vec3>& position, const std::vector<Vec2>& chart,
              RawMesh& garment) {
  std::map<std::tuple<int, double, double>, int> known;
  for (std::size_t t = 0; t < piece.triangles.size(); ++t) {
    Triangle added{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const int point = piece.triangles[t][corner];
      const auto [entry, isNew] =
          known.try_emplace({point, chart[t].x(), chart[t].y()}, static_cast<int>(garment.positions.size()));
      if (isNew) {
        garment.positions.push_back(position[point]);
        garment.uvs.emplace_back(piece.points[point] + chart[t]);
      }
      added[corner] = entry->second;
    }
    garment.triangles.push_back(added);
  }
}

}  // namespace drape::io
