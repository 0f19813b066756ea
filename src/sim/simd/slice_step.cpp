#include "sim/simd/slice_step.hpp"

#include "sim/kernels.hpp"

#include <algorithm>
#include <limits>

namespace drape {
namespace {

template <typename T>
Vec3 vectorAt(const LaneVectors<T>& vectors, int index) {
  return {static_cast<double>(vectors.x.data()[index]), static_cast<double>(vectors.y.data()[index]),
          static_cast<double>(vectors.z.data()[index])};
}

}  // namespace

template <typename T>
SliceStep<T> sliceStepOf(const StepParameters& parameters) {
  SliceStep<T> step;
  step.timeStep = static_cast<T>(parameters.timeStep);
  step.stiffness = static_cast<T>(parameters.stiffness);
  step.damping = static_cast<T>(parameters.damping);
  step.gravity = static_cast<T>(parameters.gravity);
  step.drag = static_cast<T>(0.5 * parameters.airDensity * parameters.drag);
  step.lift = static_cast<T>(0.5 * parameters.airDensity * parameters.lift);
  step.windX = static_cast<T>(parameters.wind.x());
  step.windY = static_cast<T>(parameters.wind.y());
  step.windZ = static_cast<T>(parameters.wind.z());
  step.relaxation = static_cast<T>(parameters.relaxation);
  step.derivative = parameters.derivative;
  step.sweeps = parameters.sweeps;
  return step;
}

template <typename T>
void setAttachment(const ClothModel& model, const Attachment& attachment, const SlicedCloth<T>& cloth,
                   SliceStep<T>& step) {
  const Triangle& corners = model.triangles[static_cast<std::size_t>(attachment.triangle)];
  Vec3 point = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  std::array<int, 3> indices{};
  for (std::size_t c = 0; c < 3; ++c) {
    indices[c] = cloth.layout.indexOf[static_cast<std::size_t>(corners[c])];
    const double weight = attachment.barycentric[static_cast<Eigen::Index>(c)];
    point += weight * vectorAt(cloth.position, indices[c]);
    velocity += weight * vectorAt(cloth.velocity, indices[c]);
  }
  const Vec3 offset = attachment.target - point;
  const double distance = offset.norm();
  const Vec3 force = kernels::boundedSpringForce(offset, attachment.stiffness, attachment.maxForce);
  const double stiffness = distance > 0.0 ? force.norm() / distance : attachment.stiffness;
  const Vec3 pull = force - static_cast<double>(step.timeStep) * stiffness * velocity;
  for (std::size_t c = 0; c < 3; ++c) {
    const double weight = attachment.barycentric[static_cast<Eigen::Index>(c)];
    step.attachedCorners[c] = {.slice = indices[c] / sliceLanes,
                               .lane = indices[c] % sliceLanes,
                               .forceX = static_cast<T>(weight * pull.x()),
                               .forceY = static_cast<T>(weight * pull.y()),
                               .forceZ = static_cast<T>(weight * pull.z()),
                               .stiffness = static_cast<T>(weight * stiffness)};
  }
}

template <typename T>
void applyAttachmentImpulse(const ClothModel& model, double timeStep, const Attachment& attachment,
                            SlicedCloth<T>& cloth) {
  const double h = timeStep;
  const Triangle& corners = model.triangles[static_cast<std::size_t>(attachment.triangle)];
  Vec3 offset = attachment.target;
  double inverseMass = 0.0;
  std::array<double, 3> share{};  // w_i / m_i [1/kg]
  for (std::size_t c = 0; c < 3; ++c) {
    const auto v = static_cast<std::size_t>(corners[c]);
    const int index = cloth.layout.indexOf[v];
    const double weight = attachment.barycentric[static_cast<Eigen::Index>(c)];
    offset -= weight * (vectorAt(cloth.position, index) + 0.5 * h * vectorAt(cloth.velocity, index));
    share[c] = model.pinned[v] ? 0.0 : weight / model.vertexMass[v];
    inverseMass += weight * share[c];
  }
  Vec3 impulse = (h * attachment.stiffness / (1.0 + 0.5 * h * h * attachment.stiffness * inverseMass)) * offset;
  impulse *= std::min(1.0, h * attachment.maxForce / std::max(impulse.norm(), std::numeric_limits<double>::min()));
  for (std::size_t c = 0; c < 3; ++c) {
    const int index = cloth.layout.indexOf[static_cast<std::size_t>(corners[c])];
    const Vec3 velocity = vectorAt(cloth.velocity, index) + share[c] * impulse;
    cloth.velocity.set(static_cast<std::size_t>(index), static_cast<T>(velocity.x()), static_cast<T>(velocity.y()),
                       static_cast<T>(velocity.z()));
  }
}

template void applyAttachmentImpulse(const ClothModel& model, double timeStep, const Attachment& attachment,
                                     SlicedCloth<float>& cloth);
template void applyAttachmentImpulse(const ClothModel& model, double timeStep, const Attachment& attachment,
                                     SlicedCloth<double>& cloth);
template SliceStep<float> sliceStepOf(const StepParameters& parameters);
template SliceStep<double> sliceStepOf(const StepParameters& parameters);
template void setAttachment(const ClothModel& model, const Attachment& attachment, const SlicedCloth<float>& cloth,
                            SliceStep<float>& step);
template void setAttachment(const ClothModel& model, const Attachment& attachment, const SlicedCloth<double>& cloth,
                            SliceStep<double>& step);

}  // namespace drape
