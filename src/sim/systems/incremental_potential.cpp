#include "sim/systems/incremental_potential.hpp"

#include "sim/forces/external_forces.hpp"
#include "sim/forces/kernels.hpp"

#include <cmath>
#include <limits>

namespace drape::sim {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

void IncrementalPotential::prepare(const ClothModel& model, const CommonParameters& parameters,
                                   const StepInputs& inputs, const ClothState& state, Workers& workers) {
  model_ = &model;
  parameters_ = &parameters;
  workers_ = &workers;
  startVelocities_ = state.velocities;
  const std::size_t vertices = state.positions.size();
  const std::size_t springs = model.fabric ? 0 : model.springs.size();
  external_.resize(vertices);
  gradient_.resize(vertices);
  size_.resize(vertices);
  startOffsets_.resize(springs);
  startExcess_.resize(springs);
  offsets_.resize(springs);
  springForces_.resize(springs);
  springEnergy_.resize(springs);
  springSize_.resize(springs);
  workers.forEach(parameters.threads, vertices,
                  [&](std::size_t i) { external_[i] = gravityAndAir(model, parameters, state, i); });
  workers.forEach(parameters.threads, springs, [&](std::size_t s) { prepareSpring(s, state); });
  if (model.fabric) {
    fabric_.prepare(model, state.positions, parameters.threads, workers);
  }
  attachment_ = inputs.attachment;
  if (attachment_) {
    attachedCorners_ = attachedCorners(model, *attachment_);
    attachmentStartOffset_ =
        attachedCorners_.subtracted(attachment_->target, [&](std::size_t v) { return state.positions[v]; });
  }
}

void IncrementalPotential::prepareSpring(std::size_t spring, const ClothState& state) {
  const Spring& ends = model_->springs[spring];
  const Vec3 offset =
      state.positions[static_cast<std::size_t>(ends.b)] - state.positions[static_cast<std::size_t>(ends.a)];
  const double length = offset.norm();
  startOffsets_[spring] = offset;
  startExcess_[spring] = (length - ends.restLength) * (length + ends.restLength);
}

PotentialValue IncrementalPotential::evaluate(const std::vector<Vec3>& velocities) {
  if (model_->fabric) {
    evaluateFabric(velocities);
  }
  workers_->forEach(parameters_->threads, offsets_.size(), [&](std::size_t s) { evaluateSpring(s, velocities); });
  workers_->forEach(parameters_->threads, gradient_.size(), [&](std::size_t i) { gatherVertex(i, velocities); });
  return sum(velocities, addAttachment(velocities));
}

void IncrementalPotential::evaluateFabric(const std::vector<Vec3>& velocities) {
  displacement_.resize(velocities.size());
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    displacement_[i] = parameters_->timeStep * velocities[i];
  }
  fabric_.evaluate(displacement_);
}

void IncrementalPotential::evaluateSpring(std::size_t spring, const std::vector<Vec3>& velocities) {
  const Spring& ends = model_->springs[spring];
  const double h = parameters_->timeStep;
  const double k = parameters_->material.stiffness * ends.relativeStiffness;
  const Vec3& va = velocities[static_cast<std::size_t>(ends.a)];
  const Vec3& vb = velocities[static_cast<std::size_t>(ends.b)];
  const Vec3 change = h * (vb - va);
  const Vec3 offset = startOffsets_[spring] + change;
  const double length = offset.norm();
  // L - l0 = (L^2 - l0^2) / (L + l0), with L^2 computed from its value at x0 and the change since.
  const double excess = startExcess_[spring] + change.dot(2.0 * startOffsets_[spring] + change);
  const double both = length + ends.restLength;
  const double elongation = both > 0.0 ? excess / both : 0.0;
  const bool hasDirection = length > kernels::shortestLength * ends.restLength;
  offsets_[spring] = offset;
  springForces_[spring] = kernels::dampingForce(va, vb, parameters_->material.damping);
  if (hasDirection) {
    springForces_[spring] += (k * elongation / length) * offset;
  }
  springEnergy_[spring] =
      0.5 * k * elongation * elongation + 0.5 * h * parameters_->material.damping * (vb - va).squaredNorm();
  const double speeds = va.norm() + vb.norm();
  springSize_[spring] = k * (std::abs(elongation) + h * speeds) + parameters_->material.damping * speeds;
}

void IncrementalPotential::gatherVertex(std::size_t vertex, const std::vector<Vec3>& velocities) {
  if (model_->pinned[vertex]) {
    gradient_[vertex].setZero();
    size_[vertex] = 0.0;
    return;
  }
  Vec3 force = external_[vertex];
  double forceSize = force.norm();
  if (model_->fabric) {
    force += fabric_.forceOn(vertex);
    forceSize += fabric_.forceSizeOn(vertex);
  }
  for (const SpringEnd& end : model_->fabric ? std::span<const SpringEnd>() : model_->springEnds[vertex]) {
    const int s = end.spring;
    const bool first = static_cast<int>(vertex) == model_->springs[s].a;
    force += first ? springForces_[s] : Vec3(-springForces_[s]);
    forceSize += springSize_[s];
  }
  const double mass = model_->vertexMass[vertex];
  gradient_[vertex] = mass * (velocities[vertex] - startVelocities_[vertex]) - parameters_->timeStep * force;
  size_[vertex] =
      mass * (velocities[vertex].norm() + startVelocities_[vertex].norm()) + parameters_->timeStep * forceSize;
}

double IncrementalPotential::addAttachment(const std::vector<Vec3>& velocities) {
  if (!attachment_) {
    return 0.0;
  }
  const AttachedCorners timed{attachedCorners_.vertices, parameters_->timeStep * attachedCorners_.weights};
  attachmentOffset_ = timed.subtracted(attachmentStartOffset_, [&](std::size_t v) { return velocities[v]; });
  const Vec3 force = attachment_->force(attachmentOffset_);
  timed.forEach([&](std::size_t v, double weight) {
    if (!model_->pinned[v]) {
      gradient_[v] -= weight * force;
      size_[v] += std::abs(weight) * force.norm();
    }
  });
  return attachment_->energy(attachmentOffset_.norm());
}

PotentialValue IncrementalPotential::sum(const std::vector<Vec3>& velocities, double attachmentEnergy) const {
  double kinetic = 0.0;
  double work = 0.0;
  double workSize = 0.0;
  double residual = 0.0;
  double rounding = 0.0;
  for (std::size_t i = 0; i < gradient_.size(); ++i) {
    if (!model_->pinned[i]) {
      kinetic += 0.5 * model_->vertexMass[i] * (velocities[i] - startVelocities_[i]).squaredNorm();
      work += parameters_->timeStep * velocities[i].dot(external_[i]);
      workSize += parameters_->timeStep * velocities[i].norm() * external_[i].norm();
      residual += gradient_[i].squaredNorm();
      rounding += size_[i] * size_[i];
    }
  }
  double elastic = model_->fabric ? fabric_.energy() : 0.0;
  for (const double energy : springEnergy_) {
    elastic += energy;
  }
  return {.value = kinetic + elastic + attachmentEnergy - work,
          .valueRounding = 16.0 * epsilon * (kinetic + elastic + attachmentEnergy + workSize),
          .residual = std::sqrt(residual),
          .rounding = epsilon * std::sqrt(rounding)};
}

void IncrementalPotential::findSpringBlocks(ForceDerivative variant) {
  const ClothModel& model = *model_;
  const double h = parameters_->timeStep;
  const Mat3 damped = h * parameters_->material.damping * Mat3::Identity();
  pairBlocks_.resize(offsets_.size());
  workers_->forEach(parameters_->threads, offsets_.size(), [&](std::size_t s) {
    const Spring& spring = model.springs[s];
    const double stiffness = parameters_->material.stiffness * spring.relativeStiffness;
    pairBlocks_[s] = -h * h * kernels::springDerivative(offsets_[s], spring.restLength, stiffness, variant) - damped;
  });
  workers_->forEach(parameters_->threads, diagonal_.size(), [&](std::size_t i) {
    diagonal_[i] = model.vertexMass[i] * Mat3::Identity();
    for (const SpringEnd& end : model.springEnds[i]) {
      diagonal_[i] -= pairBlocks_[end.spring];
    }
  });
}

void IncrementalPotential::findFabricBlocks(ForceDerivative variant) {
  pairBlocks_.assign(model_->fabric->pairs.size(), Mat3::Zero());
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    diagonal_[i] = model_->vertexMass[i] * Mat3::Identity();
  }
  fabric_.addDerivative(variant, parameters_->timeStep * parameters_->timeStep, diagonal_, pairBlocks_);
}

void IncrementalPotential::fillHessian(ForceDerivative variant, SparseSystem& hessian) {
  const ClothModel& model = *model_;
  const double h = parameters_->timeStep;
  diagonal_.resize(gradient_.size());
  model.fabric ? findFabricBlocks(variant) : findSpringBlocks(variant);
  hessian.fill(model, parameters_->threads, *workers_, diagonal_, pairBlocks_);
  if (!attachment_) {
    return;
  }
  const Mat3 stiffness = h * h * attachment_->forceDerivative(attachmentOffset_);
  const auto& [corners, weights] = attachedCorners_;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t d = c; d < 3; ++d) {
      const double weight = weights[static_cast<Eigen::Index>(c)] * weights[static_cast<Eigen::Index>(d)];
      // If two corners are the same vertex, both halves of the pair belong to its diagonal block.
      const double factor = c != d && corners[c] == corners[d] ? 2.0 : 1.0;
      hessian.add(model, corners[c], corners[d], (factor * weight) * stiffness);
    }
  }
}

}  // namespace drape::sim
