#include "sim/systems/implicit_system.hpp"

#include "sim/forces/external_forces.hpp"
#include "sim/forces/kernels.hpp"

#include <algorithm>

namespace drape::sim {
namespace {

/// See ImplicitSystem::jacobiSurplus [N/m]. @param stiffness the vertex's diagonal block of membrane and bending [N/m]
Mat3 surplusOf(const fabric::Fabric& fabric, const Mat3& stiffness, std::size_t vertex) {
  if (!fabric.bends()) {
    return 0.5 * stiffness;
  }
  const int row = static_cast<int>(vertex);
  const double own = fabric.bending.coeff(row, row);
  return 0.5 * (stiffness - own * Mat3::Identity()) +
         std::max(0.0, fabric.bendingHalfSums[vertex] - own) * Mat3::Identity();
}

}  // namespace

void ImplicitSystem::assemble(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
                              const ClothState& state, Workers& workers) {
  diagonal_.resize(state.positions.size());
  rightHandSide_.resize(state.positions.size());
  if (model.fabric) {
    assembleFabric(model, parameters, state, workers);
  } else {
    assembleSprings(model, parameters, state, workers);
  }
  if (inputs.attachment) {
    addAttachment(model, parameters.timeStep, *inputs.attachment, state);
  }
}

void ImplicitSystem::assembleSprings(const ClothModel& model, const CommonParameters& parameters,
                                     const ClothState& state, Workers& workers) {
  pairBlocks_.resize(model.springs.size());
  springForces_.resize(model.springs.size());
  workers.forEach(parameters.threads, model.springs.size(),
                  [&](std::size_t s) { evaluateSpring(model, parameters, state, s); });
  workers.forEach(parameters.threads, state.positions.size(),
                  [&](std::size_t i) { assembleVertex(model, parameters, state, i); });
}

void ImplicitSystem::assembleFabric(const ClothModel& model, const CommonParameters& parameters,
                                    const ClothState& state, Workers& workers) {
  const double h = parameters.timeStep;
  fabric_.prepare(model, state.positions, parameters.threads, workers);
  fabric_.evaluate(std::vector<Vec3>(state.positions.size(), Vec3::Zero()));
  diagonal_.assign(state.positions.size(), Mat3::Zero());
  surplus_.resize(state.positions.size());
  pairBlocks_.assign(model.fabric->pairs.size(), Mat3::Zero());
  fabric_.addDerivative(parameters.derivative, -1.0, diagonal_, pairBlocks_);
  workers.forEach(parameters.threads, state.positions.size(), [&](std::size_t i) {
    const Vec3 change = elasticCoupling(model, state.velocities, i) + diagonal_[i] * state.velocities[i];
    rightHandSide_[i] = h * (gravityAndAir(model, parameters, state, i) + fabric_.forceOn(i) + h * change);
    surplus_[i] = h * h * surplusOf(*model.fabric, -diagonal_[i], i);
    diagonal_[i] = model.vertexMass[i] * Mat3::Identity() - h * h * diagonal_[i];
  });
}

void ImplicitSystem::evaluateSpring(const ClothModel& model, const CommonParameters& parameters,
                                    const ClothState& state, std::size_t spring) {
  const Spring& ends = model.springs[spring];
  const auto a = static_cast<std::size_t>(ends.a);
  const auto b = static_cast<std::size_t>(ends.b);
  const Vec3 offset = state.positions[b] - state.positions[a];
  const double stiffness = parameters.material.stiffness * ends.relativeStiffness;
  const Mat3 block = kernels::springDerivative(offset, ends.restLength, stiffness, parameters.derivative);
  pairBlocks_[spring] = block;
  springForces_[spring] = kernels::springForce(offset, ends.restLength, stiffness) +
                          kernels::dampingForce(state.velocities[a], state.velocities[b], parameters.material.damping) +
                          parameters.timeStep * (block * (state.velocities[b] - state.velocities[a]));
}

void ImplicitSystem::assembleVertex(const ClothModel& model, const CommonParameters& parameters,
                                    const ClothState& state, std::size_t vertex) {
  const double h = parameters.timeStep;
  Vec3 force = gravityAndAir(model, parameters, state, vertex);
  Mat3 stiffness = Mat3::Zero();
  const std::span<const SpringEnd> ends = model.springEnds[vertex];
  for (const SpringEnd& end : ends) {
    const int s = end.spring;
    const bool first = static_cast<int>(vertex) == model.springs[s].a;
    force += first ? springForces_[s] : Vec3(-springForces_[s]);
    stiffness += pairBlocks_[s];
  }
  rightHandSide_[vertex] = h * force;
  const double isotropic =
      model.vertexMass[vertex] + static_cast<double>(ends.size()) * h * parameters.material.damping;
  diagonal_[vertex] = h * h * stiffness + isotropic * Mat3::Identity();
}

void ImplicitSystem::addAttachment(const ClothModel& model, double timeStep, const Attachment& attachment,
                                   const ClothState& state) {
  const AttachmentForce pull = attachmentForce(model, attachment, state);
  const Vec3 force = pull.implicitForce(timeStep);
  pull.forEach([&](std::size_t v, double weight) {
    rightHandSide_[v] += (timeStep * weight) * force;
    diagonal_[v] += (weight * timeStep * timeStep * pull.stiffness) * Mat3::Identity();
  });
}

Vec3 ImplicitSystem::elasticCoupling(const ClothModel& model, const std::vector<Vec3>& vectors,
                                     std::size_t vertex) const {
  Vec3 sum = Vec3::Zero();
  for (const SpringEnd& end : model.fabric->pairEnds[vertex]) {
    const Mat3& block = pairBlocks_[end.spring];
    const Vec3& other = vectors[end.neighbour];
    sum += static_cast<int>(vertex) > end.neighbour ? Vec3(block * other) : Vec3(block.transpose() * other);
  }
  return sum;
}

Vec3 ImplicitSystem::coupling(const ClothModel& model, const CommonParameters& parameters, const std::vector<Vec3>& dv,
                              std::size_t vertex) const {
  const double h = parameters.timeStep;
  if (model.fabric) {
    return h * h * elasticCoupling(model, dv, vertex);
  }
  Vec3 elastic = Vec3::Zero();
  Vec3 damped = Vec3::Zero();
  for (const SpringEnd& springEnd : model.springEnds[vertex]) {
    const Vec3& change = dv[static_cast<std::size_t>(springEnd.neighbour)];
    elastic += pairBlocks_[static_cast<std::size_t>(springEnd.spring)] * change;
    damped += change;
  }
  return h * h * elastic + h * parameters.material.damping * damped;
}

void advance(const ClothModel& model, double timeStep, const std::vector<Vec3>& dv, ClothState& state) {
  for (std::size_t i = 0; i < dv.size(); ++i) {
    if (model.pinned[i]) {
      state.velocities[i].setZero();
    } else {
      state.velocities[i] += dv[i];
      state.positions[i] += timeStep * state.velocities[i];
    }
  }
  state.time += timeStep;
}

}  // namespace drape::sim
