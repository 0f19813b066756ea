#include "sim/contact/bodies/substeps.hpp"

namespace drape::sim::contact {
namespace {

/// Returns exactly the given poses at fractions 0 and 1, so that steps connect without rounding errors. A body that
/// does not move keeps exactly its pose.
Pose poseAt(const BodyStep& whole, double fraction) {
  if (fraction == 0.0 || fraction == 1.0) {
    return fraction == 0.0 ? whole.start : whole.end;
  }
  Pose pose = whole.start;
  if (whole.start.position != whole.end.position) {
    pose.position = (1.0 - fraction) * whole.start.position + fraction * whole.end.position;
  }
  if (whole.start.rotation.coeffs() != whole.end.rotation.coeffs()) {
    pose.rotation = whole.start.rotation.slerp(fraction, whole.end.rotation);
  }
  return pose;
}

void verticesAt(const BodyStep& whole, double fraction, std::vector<Vec3>& vertices) {
  vertices.resize(whole.startVertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    vertices[v] = (1.0 - fraction) * whole.startVertices[v] + fraction * whole.endVertices[v];
  }
}

}  // namespace

const std::vector<BodyStep>& BodySubsteps::between(const std::vector<BodyStep>& whole, double from, double to) {
  parts_ = whole;
  startVertices_.resize(whole.size());
  endVertices_.resize(whole.size());
  for (std::size_t b = 0; b < whole.size(); ++b) {
    parts_[b].start = poseAt(whole[b], from);
    parts_[b].end = poseAt(whole[b], to);
    if (whole[b].startVertices.data() != whole[b].endVertices.data()) {
      verticesAt(whole[b], from, startVertices_[b]);
      verticesAt(whole[b], to, endVertices_[b]);
      parts_[b].startVertices = startVertices_[b];
      parts_[b].endVertices = endVertices_[b];
    }
  }
  return parts_;
}

}  // namespace drape::sim::contact
