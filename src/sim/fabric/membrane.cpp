#include "sim/fabric/membrane.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace drape::sim::fabric {
namespace {

/// Side k of the triangle [m], from corner k to the next.
Vec3 sideOf(const Corners& corners, Eigen::Index k) {
  return corners.col((k + 1) % 3) - corners.col(k);
}

/// The gradient of q by the corners' positions: column k is that of side k [m].
Eigen::Matrix<double, 9, 3> gradientOf(const Corners& corners) {
  Eigen::Matrix<double, 9, 3> gradient = Eigen::Matrix<double, 9, 3>::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vec3 side = sideOf(corners, k);
    gradient.block<3, 1>(3 * k, k) = -side;
    gradient.block<3, 1>(3 * ((k + 1) % 3), k) = side;
  }
  return gradient;
}

/// Sum over the sides of t_k |x_(k+1) - x_k|^2 / 2, differentiated twice.
Mat9 geometricPart(const Vec3& tensions) {
  Mat9 matrix = Mat9::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Index next = (k + 1) % 3;
    const Mat3 block = tensions[k] * Mat3::Identity();
    matrix.block<3, 3>(3 * k, 3 * k) += block;
    matrix.block<3, 3>(3 * next, 3 * next) += block;
    matrix.block<3, 3>(3 * k, 3 * next) -= block;
    matrix.block<3, 3>(3 * next, 3 * k) -= block;
  }
  return matrix;
}

/// The stress without its compressive principal parts. Both as (s_11, s_22, s_12).
Vec3 tensilePart(const Vec3& stress) {
  Eigen::Matrix2d matrix;
  matrix << stress[0], stress[2], stress[2], stress[1];
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal;
  principal.computeDirect(matrix);
  const Eigen::Vector2d tensile = principal.eigenvalues().cwiseMax(0.0);
  const Eigen::Matrix2d part = principal.eigenvectors() * tensile.asDiagonal() * principal.eigenvectors().transpose();
  return {part(0, 0), part(1, 1), part(0, 1)};
}

}  // namespace

Corners cornersOf(const Triangle& triangle, std::span<const Vec3> positions) {
  Corners corners;
  corners << positions[triangle[0]], positions[triangle[1]], positions[triangle[2]];
  return corners;
}

MembraneTriangle::MembraneTriangle(const RestTriangle& rest, const Material& material, double stiffnessScale)
    : stretch_(stiffnessScale * stretchMatrix(material)),
      stiffening_(stiffnessScale * Vec2(material.stiffeningWarp, material.stiffeningWeft)),
      stiffeningStrain_(material.stiffeningStrain),
      area_(rest.area) {
  if (!(area_ > 0.0)) {
    return;
  }
  Mat3 squares;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vec2& side = rest.sides[static_cast<std::size_t>(k)];
    squares.row(k) << side.x() * side.x(), side.y() * side.y(), side.x() * side.y();
    restSquares_[k] = side.squaredNorm();
  }
  strainOfSides_ = squares.inverse();
}

Vec3 MembraneTriangle::excess(const Corners& corners) const {
  Vec3 excess;
  for (Eigen::Index k = 0; k < 3; ++k) {
    excess[k] = 0.5 * (sideOf(corners, k).squaredNorm() - restSquares_[k]);
  }
  return excess;
}

Vec3 MembraneTriangle::stress(const Vec3& strain) const {
  Vec3 stress = stretch_ * strain;
  for (Eigen::Index i = 0; i < 2; ++i) {
    stress[i] += stiffening_[i] * std::max(0.0, strain[i] - stiffeningStrain_);
  }
  return stress;
}

Mat3 MembraneTriangle::tangent(const Vec3& strain) const {
  Mat3 tangent = stretch_;
  for (Eigen::Index i = 0; i < 2; ++i) {
    tangent(i, i) += strain[i] > stiffeningStrain_ ? stiffening_[i] : 0.0;
  }
  return tangent;
}

double MembraneTriangle::energy(const Vec3& excess) const {
  const Vec3 epsilon = strain(excess);
  double density = 0.5 * epsilon.dot(stretch_ * epsilon);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const double beyond = std::max(0.0, epsilon[i] - stiffeningStrain_);
    density += 0.5 * stiffening_[i] * beyond * beyond;
  }
  return area_ * density;
}

Vec3 MembraneTriangle::tensions(const Vec3& excess) const {
  return area_ * (strainOfSides_.transpose() * stress(strain(excess)));
}

Vec3 MembraneTriangle::tensileTensions(const Vec3& excess) const {
  return area_ * (strainOfSides_.transpose() * tensilePart(stress(strain(excess))));
}

Mat3 MembraneTriangle::tangentOfSides(const Vec3& excess) const {
  return area_ * strainOfSides_.transpose() * tangent(strain(excess)) * strainOfSides_;
}

Mat3 MembraneTriangle::stiffnessOfSides() const {
  return area_ * strainOfSides_.transpose() * stretch_ * strainOfSides_;
}

MembraneTriangle::Stiffening MembraneTriangle::stiffeningOfSides(std::size_t direction) const {
  const auto row = static_cast<Eigen::Index>(direction);
  const double root = std::sqrt(area_ * stiffening_[row]);
  return {.weights = root * strainOfSides_.row(row).transpose(), .start = root * stiffeningStrain_};
}

Mat9 MembraneTriangle::derivative(const Corners& corners, ForceDerivative variant) const {
  const Mat3 toTensions = area_ * strainOfSides_.transpose();
  if (variant == ForceDerivative::Scalar) {
    const double largest = stretch_.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
    return geometricPart(toTensions * Vec3(largest, largest, 0.0));
  }
  const Vec3 epsilon = strain(excess(corners));
  Vec3 acting = stress(epsilon);
  if (variant == ForceDerivative::Stabilised || variant == ForceDerivative::TensionOnly) {
    acting = tensilePart(acting);
  }
  if (variant == ForceDerivative::TensionOnly && acting.isZero(0.0)) {
    return Mat9::Zero();
  }
  const Eigen::Matrix<double, 9, 3> gradient = gradientOf(corners);
  const Mat9 elastic = gradient * (toTensions * tangent(epsilon) * strainOfSides_) * gradient.transpose();
  return variant == ForceDerivative::Axial ? elastic : Mat9(elastic + geometricPart(toTensions * acting));
}

}  // namespace drape::sim::fabric
