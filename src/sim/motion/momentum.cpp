#include "sim/motion/momentum.hpp"

#include "sim/forces/external_forces.hpp"
#include "sim/model/pieces.hpp"
#include "sim/motion/rigid_motion.hpp"

#include <algorithm>

namespace drape::sim {
namespace {

Vec3 linearMomentumOf(const ClothModel& model, const std::vector<std::size_t>& piece, const ClothState& state) {
  Vec3 sum = Vec3::Zero();
  for (const std::size_t v : piece) {
    sum += model.vertexMass[v] * state.velocities[v];
  }
  return sum;
}

}  // namespace

Vec3 barycentreOf(const ClothModel& model, const ClothState& state) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    sum += model.vertexMass[v] * state.positions[v];
  }
  return sum / model.totalMass();
}

Vec3 linearMomentum(const ClothModel& model, const ClothState& state) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    sum += model.vertexMass[v] * state.velocities[v];
  }
  return sum;
}

Vec3 angularMomentum(const ClothModel& model, const ClothState& state, const Vec3& about) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < state.velocities.size(); ++v) {
    sum += model.vertexMass[v] * (state.positions[v] - about).cross(state.velocities[v]);
  }
  return sum;
}

MomentumKeeper::Target MomentumKeeper::targetOf(const ClothModel& model, const CommonParameters& parameters,
                                                const std::vector<std::size_t>& piece, const ClothState& state,
                                                const std::optional<AttachmentForce>& pull, const Vec3& attachedPoint) {
  const MassMoments moments = momentsOf(model, piece, state.positions);
  Target target;
  for (const std::size_t v : piece) {
    const Vec3 impulse =
        model.vertexMass[v] * state.velocities[v] + parameters.timeStep * gravityAndAir(model, parameters, state, v);
    target.linear += impulse;
    target.angular += (state.positions[v] - moments.barycentre).cross(impulse);
  }
  target.attached = pull && std::binary_search(piece.begin(), piece.end(), pull->vertices[0]);
  if (target.attached) {
    target.attachmentArm = attachedPoint - moments.barycentre;
  }
  return target;
}

void MomentumKeeper::prepare(const ClothModel& model, const CommonParameters& parameters, const StepInputs& inputs,
                             const ClothState& state) {
  pull_.reset();
  if (inputs.attachment) {
    pull_ = attachmentForce(model, *inputs.attachment, state);
    attachedPoint_ = pull_->interpolatedFrom(state.positions);
  }
  targets_.clear();
  for (const auto& piece : pieces_.get(model, freePieces)) {
    targets_.push_back(targetOf(model, parameters, piece, state, pull_, attachedPoint_));
  }
}

void MomentumKeeper::correct(const ClothModel& model, double timeStep, double driftTime, ClothState& state) {
  const Vec3 attachmentMotion =
      pull_ ? Vec3(pull_->interpolatedFrom(state.positions) - attachedPoint_) : Vec3(Vec3::Zero());
  const Pieces& pieces = pieces_.get(model, freePieces);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    correctPiece(model, timeStep, driftTime, pieces[p], targets_[p], attachmentMotion, state);
  }
}

void MomentumKeeper::correctPiece(const ClothModel& model, double timeStep, double driftTime,
                                  const std::vector<std::size_t>& piece, const Target& target,
                                  const Vec3& attachmentMotion, ClothState& state) const {
  const MassMoments moments = momentsOf(model, piece, state.positions);
  Vec3 linear = target.linear - linearMomentumOf(model, piece, state);  // missing
  Vec3 angular = target.angular;
  // The correction also moves the positions. So it changes the angular momentum by
  // sum m r x (omega x r) + driftTime sum m (omega x r) x v, which is linear in omega.
  Mat3 inertia = moments.inertia;
  for (const std::size_t v : piece) {
    const Vec3 arm = state.positions[v] - moments.barycentre;
    const Vec3& velocity = state.velocities[v];
    angular -= model.vertexMass[v] * arm.cross(velocity);
    inertia += (driftTime * model.vertexMass[v]) * (arm * velocity.transpose() - arm.dot(velocity) * Mat3::Identity());
  }
  // The attachment's impulse is h (F - stiffness (displacement of the attached point)), and the correction is part of
  // that displacement: it acts like the mass `attachmentMass` at the attached point. The first unknown, a, is
  // eliminated from the two equations.
  double attachmentMass = 0.0;      // [kg]
  Vec3 attachedArm = Vec3::Zero();  // from the barycentre to the attached point now [m]
  const Vec3& arm = target.attachmentArm;
  if (target.attached) {
    attachedArm = pull_->interpolatedFrom(state.positions) - moments.barycentre;
    const Vec3 impulse = timeStep * (pull_->force - pull_->stiffness * attachmentMotion);
    linear += impulse;
    angular += arm.cross(impulse);
    attachmentMass = timeStep * driftTime * pull_->stiffness;
    inertia += (attachmentMass * moments.mass / (moments.mass + attachmentMass)) *
               (arm.dot(attachedArm) * Mat3::Identity() - attachedArm * arm.transpose());
  }
  const Vec3 spin =
      solveRigid(inertia, angular - (attachmentMass / (moments.mass + attachmentMass)) * arm.cross(linear));
  const Vec3 shift = (linear - attachmentMass * spin.cross(attachedArm)) / (moments.mass + attachmentMass);
  for (const std::size_t v : piece) {
    const Vec3 change = shift + spin.cross(state.positions[v] - moments.barycentre);
    state.velocities[v] += change;
    state.positions[v] += driftTime * change;
  }
}

}  // namespace drape::sim
