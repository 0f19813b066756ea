#include "sim/forces/attachment_limit.hpp"

#include "sim/forces/forces.hpp"

#include <algorithm>
#include <limits>

namespace drape::sim {
namespace {

/// How far the cloth around an attached point may stretch [-].
constexpr double strain = 0.2;
/// Springs in all directions carry a pull along one of them with a quarter of the sum of k l: half of them are in
/// tension, and the mean squared cosine to the pull is a half.
constexpr double alongPull = 0.25;
constexpr double shareOfWeight = 0.25;

/// The force that stretches the cloth around a vertex by `strain` [N].
double forceBorneBy(const ClothModel& model, const CommonParameters& parameters, std::size_t vertex) {
  double sum = 0.0;
  for (const SpringEnd& end : model.springEnds[vertex]) {
    const Spring& spring = model.springs[end.spring];
    sum += spring.relativeStiffness * spring.restLength;
  }
  return strain * alongPull * stretchStiffness(model, parameters) * sum;
}

}  // namespace

double maxAttachmentForce(const ClothModel& model, const CommonParameters& parameters, const AttachmentEnds& ends) {
  double force = std::numeric_limits<double>::infinity();
  attachedCorners(model, ends).forEach([&](std::size_t vertex, double weight) {
    if (weight > 0.0) {
      force = std::min(force, forceBorneBy(model, parameters, vertex) / weight);
    }
  });
  return std::max(force, shareOfWeight * parameters.gravity * model.totalMass());
}

}  // namespace drape::sim
