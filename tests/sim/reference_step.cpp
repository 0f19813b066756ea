#include "reference_step.hpp"

#include <Eigen/Dense>

namespace drape::sim::testing {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct System {
  MatrixXd mass;
  MatrixXd J;           // df/dx of the springs
  MatrixXd damping;     // -df/dv
  MatrixXd attachment;  // -df/dx of the attachment
  VectorXd force;
};

/// The block that couples the ends of a spring, from the separate formulas of the publications.
Mat3 couplingOf(const Vec3& d, double L, double l0, double k, ForceDerivative variant) {
  const Mat3 along = d * d.transpose();
  const Mat3 across = Mat3::Identity() - along;
  // The force k (L - l0) d: its size changes by k along the spring, its direction by 1/L across.
  const Mat3 derivative = k * along + k * (L - l0) / L * across;
  switch (variant) {
    case ForceDerivative::Exact:
      return derivative;
    case ForceDerivative::Scalar:
      return k * Mat3::Identity();
    case ForceDerivative::Axial:
      return k * along;
    case ForceDerivative::TensionOnly:
      return L < l0 ? Mat3(Mat3::Zero()) : derivative;
    case ForceDerivative::Stabilised:
      break;
  }
  return L < l0 ? Mat3(k * l0 / L * along) : derivative;
}

void addSprings(const ClothModel& model, const StepParameters& p, const ClothState& state, System& system) {
  for (const Spring& spring : model.springs) {
    const Vec3 xa = state.positions[spring.a];
    const Vec3 xb = state.positions[spring.b];
    const double L = (xb - xa).norm();
    const Vec3 d = (xb - xa) / L;
    const Mat3 block = couplingOf(d, L, spring.restLength, p.material.stiffness, p.derivative);
    const int a = 3 * spring.a;
    const int b = 3 * spring.b;
    system.J.block<3, 3>(a, a) -= block;
    system.J.block<3, 3>(b, b) -= block;
    system.J.block<3, 3>(a, b) += block;
    system.J.block<3, 3>(b, a) += block;
    const Mat3 damped = p.material.damping * Mat3::Identity();
    system.damping.block<3, 3>(a, a) += damped;
    system.damping.block<3, 3>(b, b) += damped;
    system.damping.block<3, 3>(a, b) -= damped;
    system.damping.block<3, 3>(b, a) -= damped;
    const Vec3 pull = p.material.stiffness * (L - spring.restLength) * d;
    system.force.segment<3>(a) += pull;
    system.force.segment<3>(b) -= pull;
  }
}

Vec3 normalAt(const ClothModel& model, const ClothState& state, int vertex) {
  Vec3 normal = Vec3::Zero();
  for (const Triangle& t : model.triangles) {
    if (t[0] == vertex || t[1] == vertex || t[2] == vertex) {
      const Vec3 x0 = state.positions[t[0]];
      const Vec3 x1 = state.positions[t[1]];
      const Vec3 x2 = state.positions[t[2]];
      normal += 0.5 * (x1 - x0).cross(x2 - x0);
    }
  }
  return normal.normalized();
}

void addGravityAndAir(const ClothModel& model, const StepParameters& p, const ClothState& state, System& system) {
  for (int i = 0; i < model.vertexCount(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    system.mass.block<3, 3>(3 * i, 3 * i) = model.vertexMass[v] * Mat3::Identity();
    system.force.segment<3>(3 * i) += model.vertexMass[v] * Vec3(0.0, -p.gravity, 0.0);
    const Vec3 relative = state.velocities[v] - p.air.wind;
    const double speed = relative.norm();
    if (speed == 0.0 || (p.air.drag == 0.0 && p.air.lift == 0.0)) {
      continue;
    }
    const Vec3 heading = relative / speed;
    Vec3 n = normalAt(model, state, i);
    n = n.dot(heading) < 0.0 ? Vec3(-n) : n;
    const double K = 0.5 * p.air.density * model.vertexArea[v];
    const double facing = n.dot(heading);
    system.force.segment<3>(3 * i) -= K * p.air.drag * facing * speed * speed * heading;
    system.force.segment<3>(3 * i) += K * p.air.lift * (1.0 - facing) * speed * speed * n.cross(heading).cross(heading);
  }
}

/// The attachment's force and its derivative: lumped on the diagonal with the secant stiffness as in the paper's
/// method, or whole as Newton's method needs it.
void addAttachment(const ClothModel& model, const Attachment& attachment, double h, const ClothState& state,
                   bool lumped, System& system) {
  const Triangle& t = model.triangles[attachment.triangle];
  MatrixXd weights = MatrixXd::Zero(3, 3 * model.vertexCount());
  VectorXd x(3 * model.vertexCount());
  VectorXd v(3 * model.vertexCount());
  for (int i = 0; i < model.vertexCount(); ++i) {
    x.segment<3>(3 * i) = state.positions[i];
    v.segment<3>(3 * i) = state.velocities[i];
  }
  for (int c = 0; c < 3; ++c) {
    weights.block<3, 3>(0, 3 * t[c]) = attachment.barycentric[c] * Mat3::Identity();
  }
  const Vec3 offset = attachment.target - weights * x;
  const double distance = offset.norm();
  const double chord = std::min(attachment.stiffness, attachment.maxForce / distance);
  Mat3 stiffness = chord * Mat3::Identity();
  if (!lumped && chord < attachment.stiffness) {
    stiffness -= chord / (distance * distance) * offset * offset.transpose();
  }
  const Vec3 point = weights * v;
  system.force += weights.transpose() * (chord * offset - h * (stiffness * point));
  if (lumped) {
    system.attachment.diagonal() += chord * (weights.transpose() * Vec3::Ones());
  } else {
    system.attachment += weights.transpose() * stiffness * weights;
  }
}

System systemOf(const ClothModel& model, const StepParameters& p, const StepInputs& inputs, const ClothState& state,
                bool lumped) {
  const int n = model.vertexCount();
  const MatrixXd zero = MatrixXd::Zero(3 * n, 3 * n);
  System system{zero, zero, zero, zero, VectorXd::Zero(3 * n)};
  addSprings(model, p, state, system);
  addGravityAndAir(model, p, state, system);
  if (inputs.attachment) {
    addAttachment(model, *inputs.attachment, p.timeStep, state, lumped, system);
  }
  return system;
}

MatrixXd matrixOf(const System& system, double h) {
  return system.mass - h * h * system.J + h * system.damping + h * h * system.attachment;
}

VectorXd rightHandSideOf(const System& system, double h, const ClothState& state) {
  VectorXd v(3 * static_cast<int>(state.velocities.size()));
  for (std::size_t i = 0; i < state.velocities.size(); ++i) {
    v.segment<3>(3 * static_cast<int>(i)) = state.velocities[i];
  }
  return h * (system.force - system.damping * v + h * system.J * v);
}

void advanceBy(const ClothModel& model, double h, const VectorXd& dv, ClothState& state) {
  for (int i = 0; i < model.vertexCount(); ++i) {
    const auto vertex = static_cast<std::size_t>(i);
    state.velocities[vertex] += dv.segment<3>(3 * i);
    if (!model.pinned[vertex]) {
      state.positions[vertex] += h * state.velocities[vertex];
    }
  }
  state.time += h;
}

}  // namespace

void referenceStep(const ClothModel& model, const StepParameters& p, const StepInputs& inputs, ClothState& state) {
  const int n = model.vertexCount();
  const System system = systemOf(model, p, inputs, state, true);
  const MatrixXd W = matrixOf(system, p.timeStep);
  const VectorXd rhs = rightHandSideOf(system, p.timeStep, state);
  MatrixXd inverse = MatrixXd::Zero(3 * n, 3 * n);  // of the block-diagonal part; nothing moves where it is pinned
  for (int i = 0; i < n; ++i) {
    if (!model.pinned[i]) {
      inverse.block<3, 3>(3 * i, 3 * i) = W.block<3, 3>(3 * i, 3 * i).inverse();
    }
  }
  // Damped Jacobi: every sweep goes by `relaxation` towards where Jacobi would go. The first comes from zero.
  VectorXd dv = VectorXd::Zero(3 * n);
  for (int sweep = 0; sweep <= p.jacobi.sweeps; ++sweep) {
    dv += p.jacobi.relaxation * (inverse * (rhs - W * dv));
  }
  advanceBy(model, p.timeStep, dv, state);
}

void exactLinearStep(const ClothModel& model, const StepParameters& p, const StepInputs& inputs,
                     AttachmentDerivative attachment, ClothState& state) {
  const System system = systemOf(model, p, inputs, state, attachment == AttachmentDerivative::Lumped);
  MatrixXd W = matrixOf(system, p.timeStep);
  VectorXd rhs = rightHandSideOf(system, p.timeStep, state);
  for (int i = 0; i < model.vertexCount(); ++i) {
    if (model.pinned[i]) {
      W.middleRows<3>(3 * i).setZero();
      W.middleCols<3>(3 * i).setZero();
      W.block<3, 3>(3 * i, 3 * i).setIdentity();
      rhs.segment<3>(3 * i).setZero();
    }
  }
  const VectorXd dv = W.partialPivLu().solve(rhs);
  advanceBy(model, p.timeStep, dv, state);
}

}  // namespace drape::sim::testing
