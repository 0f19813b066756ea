#include "sim/contact/constraints/cloth_frames.hpp"

#include <algorithm>

namespace drape::sim::contact {

void ClothFrames::prepare(const ContactPass& pass) {
  const std::size_t count = pass.step.start.size();
  displacementBounds_.assign(count, 0.0);
  frames_.resize(std::max(frames_.size(), pass.bodies.size()));
  for (const NearBody& body : pass.bodies) {
    Frame& frame = frames_[body.index];
    frame.start.resize(count);
    frame.predicted.resize(count);
    pass.workers.forEach(pass.step.parameters.threads, count, [&](std::size_t v) {
      frame.start[v] =
          pass.atEnd() ? body.step->end.toLocal((*pass.previous)[v]) : body.step->start.toLocal(pass.step.start[v]);
      frame.predicted[v] = body.step->end.toLocal(pass.step.predicted[v]);
      displacementBounds_[v] = std::max(displacementBounds_[v], (frame.predicted[v] - frame.start[v]).norm());
    });
  }
  // In the frames of bodies that move differently a vertex has different starts. The bound must hold for all of them.
  const double apart = pass.bodies.size() > 1 && !pass.atEnd() ? 2.0 : 1.0;
  const double offset = pass.bodies.maxContactOffset();
  for (double& bound : displacementBounds_) {
    bound = apart * bound + 2.0 * offset;
  }
  deformations_.clear();
  for (const NearBody& body : pass.bodies) {
    if (!pass.atEnd() && body.mesh != nullptr && body.mesh->isDeforming()) {
      addDeformation(pass, body);
    }
  }
  for (std::size_t v = 0; v < deformations_.size(); ++v) {
    displacementBounds_[v] += deformations_[v];
  }
}

/// Adds the displacement of a deforming mesh near each vertex, since the mesh can move the cloth that far.
void ClothFrames::addDeformation(const ContactPass& pass, const NearBody& body) {
  deformations_.resize(displacementBounds_.size(), 0.0);
  const std::vector<Vec3>& start = frames_[body.index].start;
  const ClothClusters& clusters = pass.cloth.clusters;
  std::vector<double> largest(clusters.count(), 0.0);
  pass.workers.forUnevenRange(pass.step.parameters.threads, static_cast<int>(largest.size()), [&](int begin, int end) {
    for (int c = begin; c < end; ++c) {
      Eigen::AlignedBox3d box;
      for (const int vertex : clusters.vertices(static_cast<std::size_t>(c))) {
        box.extend((start[vertex].array() - displacementBounds_[vertex]).matrix());
        box.extend((start[vertex].array() + displacementBounds_[vertex]).matrix());
      }
      body.mesh->tree.forEachLeafIn(
          box, [&](std::size_t leaf) { largest[c] = std::max(largest[c], body.mesh->moveOf(leaf)); });
    }
  });
  for (std::size_t c = 0; c < largest.size(); ++c) {
    for (const int vertex : clusters.vertices(c)) {
      deformations_[vertex] = std::max(deformations_[vertex], largest[c]);
    }
  }
}

void ClothFrames::setSolved(const ContactPass& pass, const std::vector<Vec3>& positions) {
  displacements_.assign(positions.size(), 0.0);
  for (const NearBody& body : pass.bodies) {
    Frame& frame = frames_[body.index];
    frame.solved.resize(positions.size());
    pass.workers.forEach(pass.step.parameters.threads, positions.size(), [&](std::size_t v) {
      frame.solved[v] = body.step->end.toLocal(positions[v]);
      displacements_[v] = std::max(displacements_[v], (frame.solved[v] - frame.start[v]).norm());
    });
  }
}

void ClothFrames::tightenBounds(const NearBodies& bodies) {
  const double apart = bodies.size() > 1 ? 2.0 : 1.0;
  const double offset = bodies.maxContactOffset();
  for (std::size_t v = 0; v < displacements_.size(); ++v) {
    displacementBounds_[v] = std::min(
        displacementBounds_[v], apart * displacements_[v] + offset + (deformations_.empty() ? 0.0 : deformations_[v]));
  }
}

void ClothFrames::extendBounds(double by) {
  for (double& bound : displacementBounds_) {
    bound += by;
  }
}

void ClothFrames::extendBounds(std::span<const int> vertices, double by) {
  for (const int v : vertices) {
    displacementBounds_[v] += by;
  }
}

ClothInBody ClothFrames::predictedIn(const NearBody& body, const ContactPass& pass, const Overlap* overlap) const {
  return clothIn(body, pass, frames_[body.index].predicted, overlap);
}

ClothInBody ClothFrames::solvedIn(const NearBody& body, const ContactPass& pass, const Overlap* overlap) const {
  return clothIn(body, pass, frames_[body.index].solved, overlap);
}

ClothInBody ClothFrames::clothIn(const NearBody& body, const ContactPass& pass, std::span<const Vec3> predicted,
                                 const Overlap* overlap) const {
  return {frames_[body.index].start, predicted, displacementBounds_, pass.step.model.triangles, pass.cloth.owned,
          pass.cloth.inverseMass,    overlap};
}

}  // namespace drape::sim::contact
