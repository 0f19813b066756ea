#include "sim/fields/tension_field.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::sim::fields {
namespace {

/// n n^T as (e_11, e_22, 2 e_12).
Vec3 strainAlong(const Vec2& n) {
  return {n.x() * n.x(), n.y() * n.y(), 2.0 * n.x() * n.y()};
}

}  // namespace

std::array<Compression, 2> compressionsOf(const Eigen::Matrix2d& metric, const fabric::Material& material) {
  const Mat3 law = fabric::stretchMatrix(material);
  const Eigen::Matrix2d strain = 0.5 * (metric - Eigen::Matrix2d::Identity());
  const Vec3 stress = law * Vec3(strain(0, 0), strain(1, 1), 2.0 * strain(0, 1));
  Eigen::Matrix2d tensor;
  tensor << stress[0], stress[2], stress[2], stress[1];
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal;
  principal.computeDirect(tensor);
  std::array<Compression, 2> result;
  for (Eigen::Index i = 0; i < 2; ++i) {
    Compression& compression = result[static_cast<std::size_t>(i)];
    compression.along = principal.eigenvectors().col(i);
    const Vec3 n = strainAlong(compression.along);
    const double slack = std::max(-principal.eigenvalues()[i], 0.0) / n.dot(law * n);
    const double square = std::max(compression.along.dot(metric * compression.along), 0.0);
    compression.ratio = slack > 0.0 ? std::sqrt(square / (square + 2.0 * slack)) : 1.0;
  }
  return result;
}

double bucklingStrain(const fabric::Material& material, const Vec2& along, double wavelength) {
  const double waveNumber = 2.0 * std::numbers::pi / wavelength;
  const Vec3 n = strainAlong(along);
  return waveNumber * waveNumber * n.dot(fabric::bendMatrix(material) * n) / n.dot(fabric::stretchMatrix(material) * n);
}

}  // namespace drape::sim::fields
