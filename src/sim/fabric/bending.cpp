#include "sim/fabric/bending.hpp"

#include "sim/fabric/rate_limit.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace drape::sim::fabric {
namespace {

using Row3 = Eigen::RowVector3d;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// A fit takes every bending stiffness as at least this fraction of the largest one. Otherwise the fit would not be
/// unique where hinges are missing and the fabric does not resist bending in one direction.
constexpr double minMomentRatio = 1e-2;

/// Patches whose hinges determine the curvature badly are regularised below this eigenvalue of their correlation
/// matrix [-].
constexpr double minCorrelation = 0.03;

/// N(n) of bendingMatrix.
Vec3 normalSquares(const Vec2& normal) {
  return {normal.x() * normal.x(), normal.y() * normal.y(), 2.0 * normal.x() * normal.y()};
}

/// The second derivatives of a field with the curvature (k_11, k_22, 2 k_12): along t twice, along t and n, and along n
/// twice, one a row.
Mat3 secondDerivatives(const Vec2& t, const Vec2& n) {
  Mat3 rows;
  rows << t.x() * t.x(), t.y() * t.y(), t.x() * t.y(),                      //
      t.x() * n.x(), t.y() * n.y(), 0.5 * (t.x() * n.y() + t.y() * n.x()),  //
      n.x() * n.x(), n.y() * n.y(), n.x() * n.y();
  return rows;
}

/// The same along the edge of a hinge and across it from its first triangle to its second, for a curvature in the axes
/// of one of them.
Mat3 secondDerivatives(const Hinge& hinge, std::size_t of) {
  const SideFrame& frame = hinge.frames[of];
  return secondDerivatives(frame.along, of == 0 ? frame.outward : Vec2(-frame.outward));
}

/// A second derivative H along a side makes the slope of the plane triangle differ by H / 2 times this length from the
/// slope at the middle of the side [m].
double alongSide(const SideFrame& frame) {
  return (frame.offset * frame.offset - 0.25 * frame.length * frame.length) / frame.height;
}

/// The factor on the bend vector of a hinge, or on a side of the boundary. The stiffness that a sliver causes goes up
/// with the inverse of its height to the third power, and the square of the factor compensates that.
double scaleOf(double quality) {
  return std::pow(std::min(1.0, quality / sliverQuality), 1.5);
}

/// The moments D of each triangle [N m].
class TriangleMoments {
 public:
  explicit TriangleMoments(const TriangleMaterials& materials) : materials_(materials) {
    std::ranges::transform(materials.list(), std::back_inserter(moments_), bendMatrix);
  }

  [[nodiscard]] const Mat3& operator[](std::size_t triangle) const { return moments_[materials_.indexOf(triangle)]; }

 private:
  const TriangleMaterials& materials_;
  std::vector<Mat3> moments_;  // of each material
};

/// Finds the curvatures of the triangles as linear functions of the bend vectors of the hinges.
class CurvatureBuilder {
 public:
  CurvatureBuilder(const RestShape& shape, const TriangleMoments& moments)
      : shape_(shape), hingesOf_(shape.triangles.size(), {-1, -1, -1}), fits_(shape.triangles.size(), Mat3::Zero()) {
    for (std::size_t h = 0; h < shape.hinges.size(); ++h) {
      const Hinge& hinge = shape.hinges[h];
      scales_.push_back(scaleOf(std::min(qualityOf(triangleOf(hinge, 0)), qualityOf(triangleOf(hinge, 1)))));
      for (std::size_t s = 0; s < 2; ++s) {
        hingesOf_[hinge.triangles[s]][hinge.sides[s]] = static_cast<int>(h);
      }
    }
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
      if (shape.triangles[t].area > 0.0) {
        fit(t, complianceFor(moments[t]));
      }
    }
  }

  /// The matrix [1/m] with three rows a triangle and one column a hinge.
  RowMatrix build() {
    for (std::size_t h = 0; h < shape_.hinges.size(); ++h) {
      addHinge(static_cast<int>(h));
    }
    for (std::size_t t = 0; t < shape_.triangles.size(); ++t) {
      for (int side = 0; side < 3 && shape_.triangles[t].area > 0.0; ++side) {
        if (hingesOf_[t][side] < 0) {
          addBoundary(t, side);
        }
      }
    }
    RowMatrix matrix(static_cast<Eigen::Index>(3 * shape_.triangles.size()),
                     static_cast<Eigen::Index>(shape_.hinges.size()));
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }

 private:
  [[nodiscard]] const RestTriangle& triangleOf(const Hinge& hinge, std::size_t of) const {
    return shape_.triangles[hinge.triangles[of]];
  }

  /// Minus the bend vector of a hinge per curvature, in the axes of one of its triangles [m].
  [[nodiscard]] static Row3 bendPerCurvature(const Hinge& hinge, std::size_t of) {
    const auto& [first, second] = hinge.frames;
    const Row3 perDerivative(0.5 * (alongSide(first) + alongSide(second)), second.offset - first.offset,
                             0.5 * (first.height + second.height));
    return perDerivative * secondDerivatives(hinge, of);
  }

  /// The inverse of the moments for a fit [1/(N m)]. Without moments any positive matrix serves.
  [[nodiscard]] static Mat3 complianceFor(const Mat3& moments) {
    const double largest = moments.diagonal().maxCoeff();
    return largest > 0.0 ? Mat3(moments.diagonal().cwiseMax(minMomentRatio * largest).cwiseInverse().asDiagonal())
                         : Mat3(Mat3::Identity());
  }

  /// Finds the curvature of the quadratic field through the corners of a triangle and of its neighbours. Where hinges
  /// are missing or do not determine it, the field is the one of least energy: its moments across free edges vanish.
  void fit(std::size_t t, const Mat3& compliance) {
    Mat3 bends = Mat3::Zero();  // one row a hinge [m]
    for (Eigen::Index side = 0; side < 3; ++side) {
      if (const int h = hingesOf_[t][static_cast<std::size_t>(side)]; h >= 0) {
        const Hinge& hinge = shape_.hinges[h];
        bends.row(side) = bendPerCurvature(hinge, hinge.triangles[0] == static_cast<int>(t) ? 0 : 1);
      }
    }
    const Mat3 gram = bends * compliance * bends.transpose();
    const Vec3 scale = gram.diagonal().unaryExpr([](double d) { return d > 0.0 ? 1.0 / std::sqrt(d) : 0.0; });
    const Eigen::SelfAdjointEigenSolver<Mat3> correlation(Mat3(scale.asDiagonal() * gram * scale.asDiagonal()));
    const Vec3 inverse = correlation.eigenvalues().cwiseMax(minCorrelation).cwiseInverse();
    const Mat3& modes = correlation.eigenvectors();
    fits_[t] = compliance * bends.transpose() * scale.asDiagonal() * modes * inverse.asDiagonal() * modes.transpose() *
               scale.asDiagonal();
  }

  void add(std::size_t triangle, const Vec3& direction, double factor, int hinge) {
    for (int i = 0; i < 3; ++i) {
      entries_.emplace_back(3 * static_cast<int>(triangle) + i, hinge, -scales_[hinge] * factor * direction[i]);
    }
  }

  /// Adds a slope at a side that is caused by the fitted curvature of a triangle. @param perCurvature [m]
  void addFitted(std::size_t to, const Vec3& direction, std::size_t from, const Row3& perCurvature) {
    for (std::size_t side = 0; side < 3; ++side) {
      if (const int h = hingesOf_[from][side]; h >= 0) {
        add(to, direction, perCurvature.dot(fits_[from].col(static_cast<Eigen::Index>(side))), h);
      }
    }
  }

  /// Adds the slope at the edge of a hinge to the curvature of its triangles.
  void addHinge(int h) {
    const Hinge& hinge = shape_.hinges[h];
    const auto& [first, second] = hinge.frames;
    const double heights = first.height + second.height;
    const std::array<double, 2> weights = {second.height / heights, first.height / heights};  // of their slopes
    const double areas = triangleOf(hinge, 0).area + triangleOf(hinge, 1).area;
    // The interpolated slope is that where the line between the opposite corners crosses the edge.
    const double crossing = weights[0] * first.offset + weights[1] * second.offset;
    const double curved = 0.5 * (weights[1] * alongSide(second) - weights[0] * alongSide(first));
    for (std::size_t s = 0; s < 2; ++s) {
      const auto to = static_cast<std::size_t>(hinge.triangles[s]);
      const Vec3 direction =
          hinge.frames[s].length / shape_.triangles[to].area * normalSquares(hinge.frames[s].outward);
      add(to, direction, weights[1 - s], h);
      for (std::size_t f = 0; f < 2; ++f) {
        const Mat3 derivatives = secondDerivatives(hinge, f);
        const Row3 correction = crossing * derivatives.row(1) + curved * derivatives.row(0);
        const double share = triangleOf(hinge, f).area / areas * (s == 0 ? -1.0 : 1.0);
        addFitted(to, scales_[h] * share * direction, static_cast<std::size_t>(hinge.triangles[f]), correction);
      }
    }
  }

  /// Adds the slope at a side without a hinge, which is that of the fitted field.
  void addBoundary(std::size_t t, int side) {
    const RestTriangle& triangle = shape_.triangles[t];
    const SideFrame frame = sideFrameOf(triangle, side, false);
    const Mat3 derivatives = secondDerivatives(frame.along, Vec2(-frame.outward));
    const Row3 slope = 0.5 * alongSide(frame) * derivatives.row(0) + frame.offset * derivatives.row(1) +
                       0.5 * frame.height * derivatives.row(2);
    const Vec3 direction = frame.length / triangle.area * normalSquares(frame.outward);
    addFitted(t, scaleOf(qualityOf(triangle)) * direction, t, slope);
  }

  const RestShape& shape_;
  std::vector<std::array<int, 3>> hingesOf_;  // of each triangle's sides; -1 if there is none
  std::vector<double> scales_;                // of each hinge [-]
  // Of each triangle: column k is the curvature per minus the bend vector of the hinge of side k [1/m].
  std::vector<Mat3> fits_;
  std::vector<Eigen::Triplet<double>> entries_;
};

/// The bend vectors of the hinges as a function of the vertices [1/m].
RowMatrix bendVectors(const RestShape& shape, std::size_t vertexCount) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t h = 0; h < shape.hinges.size(); ++h) {
    for (std::size_t i = 0; i < 4; ++i) {
      entries.emplace_back(static_cast<int>(h), shape.hinges[h].vertices[i],
                           shape.hinges[h].weights[static_cast<Eigen::Index>(i)]);
    }
  }
  RowMatrix matrix(static_cast<Eigen::Index>(shape.hinges.size()), static_cast<Eigen::Index>(vertexCount));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The curvatures of the triangles as a function of the vertices [1/m^2]: three rows a triangle.
RowMatrix curvatureMatrix(const RestShape& shape, const TriangleMoments& moments, std::size_t vertexCount) {
  return (CurvatureBuilder(shape, moments).build() * bendVectors(shape, vertexCount)).pruned(0.0);
}

/// A D for each triangle, on the diagonal. @param scales factor of each triangle; empty: 1
RowMatrix momentsOf(const RestShape& shape, const TriangleMoments& moments, std::span<const double> scales) {
  const auto size = static_cast<Eigen::Index>(3 * shape.triangles.size());
  RowMatrix matrix(size, size);
  matrix.reserve(Eigen::VectorXi::Constant(size, 1));
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto t = static_cast<std::size_t>(i / 3);
    const double scale = scales.empty() ? 1.0 : scales[t];
    matrix.insert(i, i) = scale * shape.triangles[t].area * moments[t](i % 3, i % 3);
  }
  return matrix;
}

/// Makes a matrix exactly symmetric and removes the entries that are only rounding.
VertexMatrix withoutRounding(const VertexMatrix& matrix) {
  const Eigen::VectorXd diagonal = matrix.diagonal();
  VertexMatrix symmetric = 0.5 * (matrix + VertexMatrix(matrix.transpose()));
  symmetric.prune([&](Eigen::Index row, Eigen::Index column, double value) {
    constexpr double rounding = 1e-12;
    return value * value > rounding * rounding * diagonal[row] * diagonal[column];
  });
  return symmetric;
}

VertexMatrix matrixOf(const RestShape& shape, const TriangleMoments& moments, const RowMatrix& curvatures,
                      std::span<const double> scales) {
  return withoutRounding(RowMatrix(curvatures.transpose()) * momentsOf(shape, moments, scales) * curvatures);
}

/// The factor on the bending energy of one triangle, from its part of the half row sums.
double bendingScaleOf(std::size_t triangle, const RestShape& shape, const Mat3& moments, const RowMatrix& curvatures,
                      const RateLimit& limit) {
  std::map<int, Vec3> columns;  // the curvature per displacement of each vertex [1/m^2]
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (RowMatrix::InnerIterator entry(curvatures, 3 * static_cast<Eigen::Index>(triangle) + i); entry; ++entry) {
      columns.try_emplace(static_cast<int>(entry.col()), Vec3::Zero()).first->second[i] = entry.value();
    }
  }
  const Vec3 stiffness = shape.triangles[triangle].area * moments.diagonal();
  double scale = 1.0;
  for (const auto& [vertex, column] : columns) {
    double sum = 0.0;
    for (const auto& [other, otherColumn] : columns) {
      sum += std::abs(column.dot(stiffness.cwiseProduct(otherColumn)));
    }
    scale = std::min(scale, limit.scaleOf(0.5 * sum, static_cast<std::size_t>(vertex)));
  }
  return scale;
}

}  // namespace

VertexMatrix bendingMatrix(const RestShape& shape, const TriangleMaterials& materials, std::size_t vertexCount) {
  const TriangleMoments moments(materials);
  return matrixOf(shape, moments, curvatureMatrix(shape, moments, vertexCount), {});
}

std::vector<Vec3> hingeMoments(const RestShape& shape, const TriangleMaterials& materials,
                               std::span<const double> scales, std::span<const Vec3> positions) {
  const TriangleMoments moments(materials);
  const RowMatrix curvatures = CurvatureBuilder(shape, moments).build();
  Eigen::MatrixX3d points(static_cast<Eigen::Index>(positions.size()), 3);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    points.row(static_cast<Eigen::Index>(v)) = (positions[v] - positions[0]).transpose();
  }
  const Eigen::MatrixX3d bends = bendVectors(shape, positions.size()) * points;
  const Eigen::MatrixX3d stresses = momentsOf(shape, moments, scales) * Eigen::MatrixX3d(curvatures * bends);
  const Eigen::MatrixX3d hinges = curvatures.transpose() * stresses;
  std::vector<Vec3> result;
  for (Eigen::Index h = 0; h < hinges.rows(); ++h) {
    result.emplace_back(hinges.row(h).transpose());
  }
  return result;
}

CurvatureMatrix curvatureMatrix(const RestShape& shape, const TriangleMaterials& materials, std::size_t vertexCount) {
  return curvatureMatrix(shape, TriangleMoments(materials), vertexCount);
}

std::vector<double> halfRowSums(const VertexMatrix& bending) {
  std::vector<double> sums(static_cast<std::size_t>(bending.rows()), 0.0);
  for (int row = 0; row < bending.outerSize(); ++row) {
    for (VertexMatrix::InnerIterator entry(bending, row); entry; ++entry) {
      sums[row] += std::abs(entry.value());
    }
    sums[row] *= 0.5;
  }
  return sums;
}

ClampedBending clampedBendingMatrix(const RestShape& shape, const TriangleMaterials& materials,
                                    std::span<const double> vertexAreas, double maxRatio,
                                    std::span<const int> clothOf) {
  const TriangleMoments moments(materials);
  const RowMatrix curvatures = curvatureMatrix(shape, moments, vertexAreas.size());
  ClampedBending clamped{matrixOf(shape, moments, curvatures, {}), {}};
  const RateLimit limit(halfRowSums(clamped.matrix), vertexAreas, maxRatio, clothOf);
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
    clamped.scales.push_back(bendingScaleOf(t, shape, moments[t], curvatures, limit));
  }
  if (std::ranges::any_of(clamped.scales, [](double scale) { return scale < 1.0; })) {
    clamped.matrix = matrixOf(shape, moments, curvatures, clamped.scales);
  }
  return clamped;
}

}  // namespace drape::sim::fabric
