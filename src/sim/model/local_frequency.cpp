#include "sim/model/local_frequency.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>

namespace drape::sim {

double unitFrequencySquared(const ClothModel& model, std::size_t vertex) {
  if (!model.fabricStiffness.empty()) {
    return 2.0 * model.fabricStiffness[vertex] / model.vertexMass[vertex];
  }
  Mat3 stiffness = Mat3::Zero();
  for (const SpringEnd& springEnd : model.springEnds[vertex]) {
    const Vec3 offset = model.restPositions[springEnd.neighbour] - model.restPositions[vertex];
    const double relative = model.springs[springEnd.spring].relativeStiffness;
    stiffness +=
        offset * offset.transpose() * (relative / std::max(offset.squaredNorm(), std::numeric_limits<double>::min()));
  }
  const double largest =
      Eigen::SelfAdjointEigenSolver<Mat3>().computeDirect(stiffness, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
  return 2.0 * largest / model.vertexMass[vertex];
}

}  // namespace drape::sim
