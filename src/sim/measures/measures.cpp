#include "sim/measures/measures.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace drape::sim {

double meanDistance(std::span<const Vec3> a, std::span<const Vec3> b) {
  assert(a.size() == b.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - b[i]).norm();
  }
  return a.empty() ? 0.0 : sum / static_cast<double>(a.size());
}

double rmsDistance(std::span<const Vec3> a, std::span<const Vec3> b) {
  assert(a.size() == b.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - b[i]).squaredNorm();
  }
  return a.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(a.size()));
}

DisplacementError displacementError(const ClothModel& model, const CheckpointPair& pair, double diagonal) {
  DisplacementError error;
  double eps = 0.0;
  double squaredCosine = 0.0;
  for (std::size_t i = 0; i < pair.after.size(); ++i) {
    if (model.pinned[i]) {
      continue;
    }
    const Vec3 own = pair.after[i] - pair.before[i];                          // D_i
    const Vec3 reference = pair.referenceAfter[i] - pair.referenceBefore[i];  // R_i
    if (reference.norm() < stillShare * diagonal || reference.squaredNorm() == 0.0) {
      ++error.stillVertices;
      error.stillMotion = std::max(error.stillMotion, own.norm());
      continue;
    }
    ++error.vertices;
    eps += (own - reference).squaredNorm() / reference.squaredNorm();
    if (own.squaredNorm() > 0.0) {
      const double cosine = own.normalized().dot(reference.normalized());
      squaredCosine += cosine * cosine;
    }
  }
  const double count = error.vertices > 0 ? error.vertices : std::numeric_limits<double>::quiet_NaN();
  error.eps = eps / count;
  error.squaredCosine = squaredCosine / count;
  return error;
}

void MotionKept::add(const ClothModel& model, const CheckpointPair& pair) {
  for (std::size_t i = 0; i < pair.after.size(); ++i) {
    own_ += model.vertexMass[i] * (pair.after[i] - pair.before[i]).squaredNorm();
    reference_ += model.vertexMass[i] * (pair.referenceAfter[i] - pair.referenceBefore[i]).squaredNorm();
  }
}

double MotionKept::value() const {
  if (reference_ > 0.0) {
    return std::sqrt(own_ / reference_);
  }
  return own_ > 0.0 ? std::numeric_limits<double>::infinity() : 1.0;
}

double motionKept(const ClothModel& model, const CheckpointPair& pair) {
  MotionKept kept;
  kept.add(model, pair);
  return kept.value();
}

}  // namespace drape::sim
