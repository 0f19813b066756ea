#pragma once

#include "sim/forces/external_forces.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/solvers/step_parameters.hpp"
#include "test_meshes.hpp"

#include <Eigen/Dense>

namespace drape::sim::testing {

/// One row a vertex, columns x, y, z.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

inline Rows rowsOf(const std::vector<Vec3>& values) {
  Rows rows(static_cast<Eigen::Index>(values.size()), 3);
  for (std::size_t i = 0; i < values.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) = values[i].transpose();
  }
  return rows;
}

inline Eigen::MatrixXd massMatrix(const ClothModel& model) {
  return Eigen::VectorXd::Map(model.vertexMass.data(), static_cast<Eigen::Index>(model.vertexMass.size())).asDiagonal();
}

/// L: the number of neighbours on the diagonal, -1 between neighbours.
inline Eigen::MatrixXd laplacian(const ClothModel& model) {
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(model.vertexCount(), model.vertexCount());
  for (const Spring& s : model.springs) {
    L(s.a, s.a) += 1.0;
    L(s.b, s.b) += 1.0;
    L(s.a, s.b) -= 1.0;
    L(s.b, s.a) -= 1.0;
  }
  return L;
}

/// 1 where a vertex may move, 0 where it is pinned, on the diagonal.
inline Eigen::MatrixXd freedom(const ClothModel& model) {
  Eigen::MatrixXd free = Eigen::MatrixXd::Identity(model.vertexCount(), model.vertexCount());
  for (int i = 0; i < model.vertexCount(); ++i) {
    free(i, i) = model.pinned[i] ? 0.0 : 1.0;
  }
  return free;
}

/// k (L - l0) along each spring, summed up for every vertex [N].
inline Rows springForces(const ClothModel& model, double k, const Rows& x) {
  Rows force = Rows::Zero(x.rows(), 3);
  for (const Spring& s : model.springs) {
    const Vec3 offset = (x.row(s.b) - x.row(s.a)).transpose();
    const Vec3 pull = k * (offset.norm() - s.restLength) * offset.normalized();
    force.row(s.a) += pull.transpose();
    force.row(s.b) -= pull.transpose();
  }
  return force;
}

/// Gravity and air [N].
inline Rows outerForces(const ClothModel& model, const StepParameters& p, const ClothState& state) {
  Rows force(model.vertexCount(), 3);
  for (int i = 0; i < model.vertexCount(); ++i) {
    force.row(i) = gravityAndAir(model, p, state, static_cast<std::size_t>(i)).transpose();
  }
  return force;
}

/// The attachment as in the implicit methods: its force minus the change over the step, and its lumped stiffness.
struct DenseAttachment {
  Rows force;                 ///< w_i (F - h stiffness v) [N]
  Eigen::MatrixXd stiffness;  ///< w_i times that of the chord, on the diagonal [N/m]
};

inline DenseAttachment denseAttachment(const ClothModel& model, const StepInputs& inputs, double h,
                                       const ClothState& state) {
  const Eigen::Index n = model.vertexCount();
  DenseAttachment dense{Rows::Zero(n, 3), Eigen::MatrixXd::Zero(n, n)};
  if (!inputs.attachment) {
    return dense;
  }
  const Attachment& attachment = *inputs.attachment;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(n);
  for (int c = 0; c < 3; ++c) {
    weights[model.triangles[attachment.triangle][c]] = attachment.barycentric[c];
  }
  const Vec3 offset = attachment.target - rowsOf(state.positions).transpose() * weights;
  const double stiffness = std::min(attachment.stiffness, attachment.maxForce / offset.norm());
  const Vec3 force = stiffness * (offset - h * (rowsOf(state.velocities).transpose() * weights));
  dense.force = weights * force.transpose();
  dense.stiffness = (stiffness * weights).asDiagonal();
  return dense;
}

/// Solves for the vertices that are free; zero for the others.
inline Rows solveFree(const ClothModel& model, const Eigen::MatrixXd& matrix, const Rows& right) {
  const Eigen::MatrixXd free = freedom(model);
  const Eigen::MatrixXd fixed = Eigen::MatrixXd::Identity(free.rows(), free.cols()) - free;
  return (free * matrix * free + fixed).fullPivLu().solve(free * right);
}

/// How far a state is from the given positions and velocities, in any component.
inline double distance(const ClothState& state, const Rows& x, const Rows& v) {
  return std::max((rowsOf(state.positions) - x).cwiseAbs().maxCoeff(),
                  (rowsOf(state.velocities) - v).cwiseAbs().maxCoeff());
}

/// A sheet whose vertices stand unevenly and whose masses differ.
inline std::shared_ptr<const ClothModel> unevenSheet(int n, const std::vector<int>& pins) {
  ClothMesh mesh = sheet(n);
  RandomVectors random(11);
  for (Vec3& position : mesh.positions) {
    position += random.next(0.2 / (n - 1));
  }
  return buildClothModel(mesh, 0.1, MassLumping::Area, pins);
}

/// Two vertices with one spring of 1 m between them along x, of mass 0.05 kg each.
inline std::shared_ptr<const ClothModel> pair(const std::vector<int>& pins) {
  return buildClothModel({{Vec3(0.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0)}, {{0, 1, 1}}}, 0.1, MassLumping::Uniform, pins);
}

/// Parameters with damping, drag, lift and wind.
inline StepParameters dampedInWind() {
  StepParameters p;
  p.material.damping = 0.01;
  p.air.drag = 0.6;
  p.air.lift = 0.4;
  p.air.wind = Vec3(1.0, 0.0, -2.0);
  return p;
}

/// A pull at a point within triangle 9.
/// @param maxForce the largest force [N]
inline StepInputs attachmentWith(double maxForce) {
  StepInputs inputs;
  inputs.attachment = Attachment{{9, Vec3(0.5, 0.3, 0.2), Vec3(0.5, 0.4, 0.5)}, {50.0, maxForce}};
  return inputs;
}

}  // namespace drape::sim::testing
