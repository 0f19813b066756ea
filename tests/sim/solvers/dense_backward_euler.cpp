#include "dense_backward_euler.hpp"

#include <Eigen/Dense>
#include <stdexcept>

namespace drape::sim::testing {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd flat(const std::vector<Vec3>& vectors) {
  VectorXd all(3 * static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    all.segment<3>(3 * static_cast<Eigen::Index>(i)) = vectors[i];
  }
  return all;
}

struct Equations {
  VectorXd residual;  // M (x - y) - h^2 f(x) + h C_d L (x - x_n) [kg m]
  MatrixXd jacobian;
};

void addSprings(const ClothModel& model, const StepParameters& p, const VectorXd& x, const VectorXd& start,
                Equations& equations) {
  const double h = p.timeStep;
  for (const Spring& spring : model.springs) {
    const int a = 3 * spring.a;
    const int b = 3 * spring.b;
    const Vec3 offset = x.segment<3>(b) - x.segment<3>(a);
    const double L = offset.norm();
    const Vec3 d = offset / L;
    const double ratio = spring.restLength / L;
    const Vec3 onFirst = p.material.stiffness * (L - spring.restLength) * d;
    const Vec3 slipped = (x - start).segment<3>(b) - (x - start).segment<3>(a);
    const Vec3 row = h * h * onFirst + h * p.material.damping * slipped;
    const Mat3 block = h * h * p.material.stiffness * ((1.0 - ratio) * Mat3::Identity() + ratio * d * d.transpose()) +
                       h * p.material.damping * Mat3::Identity();
    equations.residual.segment<3>(a) -= row;
    equations.residual.segment<3>(b) += row;
    equations.jacobian.block<3, 3>(a, a) += block;
    equations.jacobian.block<3, 3>(b, b) += block;
    equations.jacobian.block<3, 3>(a, b) -= block;
    equations.jacobian.block<3, 3>(b, a) -= block;
  }
}

void addAttachment(const ClothModel& model, const Attachment& attachment, double h, const VectorXd& x,
                   Equations& equations) {
  MatrixXd weights = MatrixXd::Zero(3, x.size());  // attached point = weights * x
  for (int c = 0; c < 3; ++c) {
    const int v = model.triangles[attachment.triangle][c];
    weights.block<3, 3>(0, 3 * v) = attachment.barycentric[c] * Mat3::Identity();
  }
  equations.residual += h * h * attachment.stiffness * weights.transpose() * (weights * x - attachment.target);
  equations.jacobian += h * h * attachment.stiffness * weights.transpose() * weights;
}

}  // namespace

void denseBackwardEulerStep(const ClothModel& model, const StepParameters& p, const StepInputs& inputs,
                            ClothState& state) {
  const double h = p.timeStep;
  const VectorXd start = flat(state.positions);
  VectorXd mass(start.size());
  VectorXd y = start + h * flat(state.velocities);
  for (int i = 0; i < model.vertexCount(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    mass.segment<3>(3 * i).setConstant(model.vertexMass[v]);
    y.segment<3>(3 * i) += h * h * Vec3(0.0, -p.gravity, 0.0);
    if (model.pinned[v]) {
      y.segment<3>(3 * i) = start.segment<3>(3 * i);
    }
  }
  VectorXd x = y;
  VectorXd change = x;
  for (int iteration = 0; change.norm() > 1e-14 * (1.0 + x.norm()); ++iteration) {
    if (iteration == 50) {
      throw std::runtime_error("Newton's method did not converge");
    }
    Equations equations{mass.cwiseProduct(x - y), mass.asDiagonal()};
    addSprings(model, p, x, start, equations);
    if (inputs.attachment) {
      addAttachment(model, *inputs.attachment, h, x, equations);
    }
    for (int i = 0; i < model.vertexCount(); ++i) {
      if (model.pinned[i]) {
        equations.residual.segment<3>(3 * i).setZero();
        equations.jacobian.middleRows<3>(3 * i).setZero();
        equations.jacobian.block<3, 3>(3 * i, 3 * i).setIdentity();
      }
    }
    change = -equations.jacobian.partialPivLu().solve(equations.residual);
    x += change;
  }
  for (int i = 0; i < model.vertexCount(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    state.velocities[v] = (x - start).segment<3>(3 * i) / h;
    state.positions[v] = x.segment<3>(3 * i);
  }
  state.time += h;
}

}  // namespace drape::sim::testing
