#include "dressing/heat_flow.hpp"

#include <algorithm>

namespace drape::dressing {
namespace {

/// Cotangent of the angle at a corner. Obtuse angles give no negative weights, so that the flow has a maximum
/// principle; slivers give no huge ones.
double boundedCotangent(const Vec3& at, const Vec3& left, const Vec3& right) {
  constexpr double smallest = 0.02;
  constexpr double largest = 20.0;
  const Vec3 u = left - at;
  const Vec3 v = right - at;
  const double sine = u.cross(v).norm();
  return sine > 0.0 ? std::clamp(u.dot(v) / sine, smallest, largest) : smallest;
}

}  // namespace

HeatFlow::HeatFlow(const sim::ClothMesh& surface) {
  constexpr double someArea = 1e-12;  // [m^2] so that a vertex without triangles has an equation
  const auto count = static_cast<Eigen::Index>(surface.positions.size());
  areas_ = Eigen::VectorXd::Constant(count, someArea);
  std::vector<Eigen::Triplet<double>> entries;
  for (const Triangle& triangle : surface.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const int at = triangle[corner];
      const int a = triangle[(corner + 1) % 3];
      const int b = triangle[(corner + 2) % 3];
      const Vec3& origin = surface.positions[at];
      const double weight = 0.5 * boundedCotangent(origin, surface.positions[a], surface.positions[b]);
      entries.insert(entries.end(), {{a, a, weight}, {b, b, weight}, {a, b, -weight}, {b, a, -weight}});
      areas_[at] += (surface.positions[a] - origin).cross(surface.positions[b] - origin).norm() / 6.0;
    }
  }
  for (Eigen::Index v = 0; v < count; ++v) {
    entries.emplace_back(v, v, 0.0);
  }
  laplacian_.resize(count, count);
  laplacian_.setFromTriplets(entries.begin(), entries.end());
}

void HeatFlow::setTimeStep(double timeStep) {
  Eigen::SparseMatrix<double> system = timeStep * laplacian_;
  system.diagonal() += areas_;
  factors_.compute(system);
}

std::vector<Vec3> HeatFlow::advance(const std::vector<Vec3>& values) const {
  const auto count = static_cast<int>(values.size());
  Eigen::MatrixX3d right(count, 3);
  for (int v = 0; v < count; ++v) {
    right.row(v) = areas_[v] * values[v].transpose();
  }
  const Eigen::MatrixX3d solution = factors_.solve(right);
  std::vector<Vec3> result(values.size());
  for (int v = 0; v < count; ++v) {
    result[v] = solution.row(v).transpose();
  }
  return result;
}

}  // namespace drape::dressing
