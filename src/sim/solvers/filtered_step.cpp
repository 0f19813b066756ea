#include "sim/solvers/filtered_step.hpp"

#include "sim/forces/external_forces.hpp"
#include "sim/forces/forces.hpp"
#include "sim/model/pieces.hpp"
#include "sim/motion/rigid_motion.hpp"

#include <algorithm>

namespace drape::sim {

StepReport FilteredStepSolver::step(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                                    ClothState& state) {
  const double h = parameters.timeStep;
  const std::size_t count = state.positions.size();
  filtered_.resize(count);
  external_.resize(count);
  workers_.forEach(parameters.threads, count, [&](std::size_t i) {
    filtered_[i] = internalImpulse(model, parameters, state, i);
    external_[i] = (h / model.vertexMass[i]) * gravityAndAir(model, parameters, state, i);
  });
  attached_ = inputs.attachment.has_value();
  if (inputs.attachment) {
    addAttachment(model, h, *inputs.attachment, state);
  }
  filter_.prepare(model, {h, parameters.material.stiffness, parameters.material.damping},
                  attached_ ? &attachment_ : nullptr);
  filter_.apply(parameters.threads, workers_, filtered_);
  findCorrection(model, state);
  move(model, parameters, state);
  return {};
}

Vec3 FilteredStepSolver::internalImpulse(const ClothModel& model, const StepParameters& parameters,
                                         const ClothState& state, std::size_t vertex) {
  Vec3 difference = Vec3::Zero();
  for (const SpringEnd& springEnd : model.springEnds[vertex]) {
    const auto neighbour = static_cast<std::size_t>(springEnd.neighbour);
    difference += model.springs[static_cast<std::size_t>(springEnd.spring)].relativeStiffness *
                  (state.velocities[neighbour] - state.velocities[vertex]);
  }
  const double h = parameters.timeStep;
  return h * (internalForceOn(model, parameters, state, vertex) + h * parameters.material.stiffness * difference);
}

void FilteredStepSolver::addAttachment(const ClothModel& model, double timeStep, const Attachment& attachment,
                                       const ClothState& state) {
  const AttachmentForce pull = attachmentForce(model, attachment, state);
  attachment_ = pull.diagonal(timeStep);
  const Vec3 impulse = timeStep * pull.implicitForce(timeStep);
  for (std::size_t c = 0; c < 3; ++c) {
    attachmentImpulse_[c] = pull.weights[static_cast<Eigen::Index>(c)] * impulse;
    filtered_[pull.vertices[c]] += attachmentImpulse_[c];
  }
}

void FilteredStepSolver::findCorrection(const ClothModel& model, const ClothState& state) {
  rotation_.assign(state.positions.size(), Vec3::Zero());
  for (const auto& piece : pieces_.get(model, freePieces)) {
    const MassMoments moments = momentsOf(model, piece, state.positions);
    const auto arm = [&](std::size_t v) { return Vec3(state.positions[v] - moments.barycentre); };
    Vec3 impulse = Vec3::Zero();  // h T, without the attachment's [N m s]
    for (const std::size_t v : piece) {
      impulse += model.vertexMass[v] * arm(v).cross(filtered_[v]);
    }
    if (attached_ && std::binary_search(piece.begin(), piece.end(), attachment_.vertices[0])) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t v = attachment_.vertices[c];
        impulse -=
            arm(v).cross(attachmentImpulse_[c] - attachment_.additions[static_cast<Eigen::Index>(c)] * filtered_[v]);
      }
    }
    const Vec3 spin = -solveRigid(moments.inertia, impulse);
    for (const std::size_t v : piece) {
      rotation_[v] = spin.cross(arm(v));
    }
  }
}

void FilteredStepSolver::move(const ClothModel& model, const StepParameters& parameters, ClothState& state) {
  const double h = parameters.timeStep;
  workers_.forEach(parameters.threads, state.positions.size(), [&](std::size_t i) {
    if (model.pinned[i]) {
      state.velocities[i].setZero();
      return;
    }
    state.velocities[i] += filtered_[i] + external_[i];
    if (correction_ == RotationCorrection::Velocities) {
      state.velocities[i] += rotation_[i];
      state.positions[i] += h * state.velocities[i];
    } else {
      state.positions[i] += h * (state.velocities[i] + rotation_[i]);
    }
  });
  state.time += h;
}

}  // namespace drape::sim
