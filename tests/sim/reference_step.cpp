#include "reference_step.hpp"

#include <Eigen/Dense>

namespace drape::testing {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct System {
  MatrixXd mass;
  MatrixXd J;        // df/dx of the springs, stabilised
  MatrixXd damping;  // -df/dv
  MatrixXd hand;     // -df/dx of the hand, its diagonal blocks
  VectorXd force;
};

void addSprings(const ClothModel& model, const StepParameters& p, const ClothState& state, System& system) {
  for (const Spring& spring : model.springs) {
    const Vec3 xa = state.positions[static_cast<std::size_t>(spring.a)];
    const Vec3 xb = state.positions[static_cast<std::size_t>(spring.b)];
    const double L = (xb - xa).norm();
    const Vec3 d = (xb - xa) / L;
    Mat3 block = p.stiffness * (spring.restLength / L) * d * d.transpose();
    if (L > spring.restLength) {
      block += p.stiffness * (1.0 - spring.restLength / L) * Mat3::Identity();
    }
    const int a = 3 * spring.a;
    const int b = 3 * spring.b;
    system.J.block<3, 3>(a, a) -= block;
    system.J.block<3, 3>(b, b) -= block;
    system.J.block<3, 3>(a, b) += block;
    system.J.block<3, 3>(b, a) += block;
    const Mat3 damped = p.damping * Mat3::Identity();
    system.damping.block<3, 3>(a, a) += damped;
    system.damping.block<3, 3>(b, b) += damped;
    system.damping.block<3, 3>(a, b) -= damped;
    system.damping.block<3, 3>(b, a) -= damped;
    const Vec3 pull = p.stiffness * (L - spring.restLength) * d;
    system.force.segment<3>(a) += pull;
    system.force.segment<3>(b) -= pull;
  }
}

Vec3 normalAt(const ClothModel& model, const ClothState& state, int vertex) {
  Vec3 normal = Vec3::Zero();
  for (const Triangle& t : model.triangles) {
    if (t[0] == vertex || t[1] == vertex || t[2] == vertex) {
      const Vec3 x0 = state.positions[static_cast<std::size_t>(t[0])];
      const Vec3 x1 = state.positions[static_cast<std::size_t>(t[1])];
      const Vec3 x2 = state.positions[static_cast<std::size_t>(t[2])];
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
    const Vec3 relative = state.velocities[v] - p.wind;
    const double speed = relative.norm();
    if (speed == 0.0 || (p.drag == 0.0 && p.lift == 0.0)) {
      continue;
    }
    const Vec3 heading = relative / speed;
    Vec3 n = normalAt(model, state, i);
    n = n.dot(heading) < 0.0 ? Vec3(-n) : n;
    const double K = 0.5 * p.airDensity * model.vertexArea[v];
    const double facing = n.dot(heading);
    system.force.segment<3>(3 * i) -= K * p.drag * facing * speed * speed * heading;
    system.force.segment<3>(3 * i) += K * p.lift * (1.0 - facing) * speed * speed * n.cross(heading).cross(heading);
  }
}

void addHand(const ClothModel& model, const Grab& grab, double h, const ClothState& state, System& system) {
  Vec3 point = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  const Triangle& t = model.triangles[static_cast<std::size_t>(grab.triangle)];
  for (int c = 0; c < 3; ++c) {
    const auto v = static_cast<std::size_t>(t[static_cast<std::size_t>(c)]);
    point += grab.barycentric[c] * state.positions[v];
    velocity += grab.barycentric[c] * state.velocities[v];
  }
  const double distance = (grab.target - point).norm();
  const double stiffness = std::min(grab.stiffness, grab.maxForce / distance);
  for (int c = 0; c < 3; ++c) {
    const int row = 3 * t[static_cast<std::size_t>(c)];
    system.force.segment<3>(row) += grab.barycentric[c] * stiffness * (grab.target - point - h * velocity);
    system.hand.block<3, 3>(row, row) += grab.barycentric[c] * stiffness * Mat3::Identity();
  }
}

}  // namespace

void referenceStep(const ClothModel& model, const StepParameters& p, const StepInputs& inputs, ClothState& state) {
  const int n = model.vertexCount();
  const double h = p.timeStep;
  const MatrixXd zero = MatrixXd::Zero(3 * n, 3 * n);
  System system{zero, zero, zero, zero, VectorXd::Zero(3 * n)};
  addSprings(model, p, state, system);
  addGravityAndAir(model, p, state, system);
  if (inputs.grab) {
    addHand(model, *inputs.grab, h, state, system);
  }
  VectorXd v(3 * n);
  for (int i = 0; i < n; ++i) {
    v.segment<3>(3 * i) = state.velocities[static_cast<std::size_t>(i)];
  }
  const VectorXd rhs = h * (system.force - system.damping * v + h * system.J * v);
  const MatrixXd W = system.mass - h * h * system.J + h * system.damping + h * h * system.hand;

  MatrixXd inverse = zero;  // of the block-diagonal part; nothing moves where the cloth is pinned
  MatrixXd off = W;
  for (int i = 0; i < n; ++i) {
    off.block<3, 3>(3 * i, 3 * i).setZero();
    if (!model.pinned[static_cast<std::size_t>(i)]) {
      inverse.block<3, 3>(3 * i, 3 * i) = W.block<3, 3>(3 * i, 3 * i).inverse();
    }
  }
  VectorXd dv = inverse * rhs;
  for (int sweep = 0; sweep < p.sweeps; ++sweep) {
    dv = inverse * (rhs - off * dv);
  }
  for (int i = 0; i < n; ++i) {
    const auto vertex = static_cast<std::size_t>(i);
    state.velocities[vertex] += dv.segment<3>(3 * i);
    if (!model.pinned[vertex]) {
      state.positions[vertex] += h * state.velocities[vertex];
    }
  }
  state.time += h;
}

}  // namespace drape::testing
