#include "sim/fabric/highest_frequency.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace drape::sim::fabric {
namespace {

using Vectors = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

constexpr int iterations = 48;

/// The same vector for every cloth of that size, with parts in all modes.
Vectors startVector(Eigen::Index vertices) {
  Vectors start(vertices, 3);
  for (Eigen::Index i = 0; i < 3 * vertices; ++i) {
    start(i / 3, i % 3) = std::sin(1.7 * static_cast<double>(i * i % 1009) + 0.3);
  }
  return start;
}

/// The forces of a displacement, with the opposite sign.
Vectors stiffnessTimes(const ClothModel& model, std::span<const Mat9> membrane, const VertexMatrix& bending,
                       const Vectors& displacement) {
  Vectors sum = Vectors::Zero(displacement.rows(), 3);
  if (bending.rows() > 0) {
    sum = bending * displacement;
  }
  for (std::size_t t = 0; t < membrane.size(); ++t) {
    const auto& [a, b, c] = model.triangles[t];
    Eigen::Matrix<double, 9, 1> own;
    own << displacement.row(a).transpose(), displacement.row(b).transpose(), displacement.row(c).transpose();
    const Eigen::Matrix<double, 9, 1> forces = membrane[t] * own;
    sum.row(a) += forces.segment<3>(0).transpose();
    sum.row(b) += forces.segment<3>(3).transpose();
    sum.row(c) += forces.segment<3>(6).transpose();
  }
  return sum;
}

}  // namespace

double highestFrequencySquared(const ClothModel& model, std::span<const Mat9> membrane, const VertexMatrix& bending) {
  const auto vertices = static_cast<Eigen::Index>(model.vertexMass.size());
  const Eigen::Map<const Eigen::VectorXd> masses(model.vertexMass.data(), vertices);
  Vectors mode = startVector(vertices);
  double squared = 0.0;
  for (int i = 0; i < iterations; ++i) {
    const Vectors forces = stiffnessTimes(model, membrane, bending, mode);
    const Vectors accelerations = masses.cwiseInverse().asDiagonal() * forces;
    // Rayleigh's quotient of M^-1 K applied to the square root of the mass.
    const double potential = accelerations.cwiseProduct(forces).sum();
    const double kinetic = mode.cwiseProduct(forces).sum();
    if (!(kinetic > 0.0)) {
      return squared;
    }
    squared = potential / kinetic;
    mode = accelerations / std::sqrt(potential);
  }
  return squared;
}

}  // namespace drape::sim::fabric
