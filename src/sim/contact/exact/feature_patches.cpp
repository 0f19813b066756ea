#include "sim/contact/exact/feature_patches.hpp"

#include <algorithm>

namespace drape::sim::contact {
namespace {

constexpr int maxUpdatesPerGrowth = 256;  // see PatchUpdater

/// Sides of a border that come closer than this fraction of the size of the cloth count as touching. Positions in float
/// have a rounding error of 6e-8 of the size, and the test adds a few of those.
constexpr float borderMarginRatio = 2e-6F;

constexpr int none = -1;
constexpr int unknown = -2;

/// The patch of a feature with one more triangle.
int joined(int patch, int patchOfTriangle) {
  return patch == unknown || patch == patchOfTriangle ? patchOfTriangle : none;
}

FeaturePatches labelled(const FeatureMesh& mesh, std::size_t vertices,
                        std::shared_ptr<const CollisionFreePatches> patches) {
  FeaturePatches features{.patches = std::move(patches), .ofVertex = {}, .ofEdge = {}, .ofTriangle = {}};
  features.ofTriangle = features.patches->patchOfTriangle;
  features.ofVertex.assign(vertices, unknown);
  features.ofEdge.assign(mesh.edges.edges.size(), unknown);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int v : mesh.triangles[t]) {
      features.ofVertex[v] = joined(features.ofVertex[v], features.ofTriangle[t]);
    }
    for (const int e : mesh.edgesOfTriangle[t]) {
      if (e >= 0) {
        features.ofEdge[e] = joined(features.ofEdge[e], features.ofTriangle[t]);
      }
    }
  }
  return features;
}

}  // namespace

/// Copies positions in float, relative to the first vertex, so that cloth far from the origin keeps its digits.
void PatchFinder::setPositions(std::span<const Vec3> positions) {
  positions_.resize(positions.size());
  float size = 0.0F;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Eigen::Vector3f offset = (positions[v] - positions[0]).cast<float>();
    positions_.x[v] = offset.x();
    positions_.y[v] = offset.y();
    positions_.z[v] = offset.z();
    size = std::max(size, offset.cwiseAbs().maxCoeff());
  }
  updater_.setBorderMargin(borderMarginRatio * size);
  check_.setBorderMargin(borderMarginRatio * size);
}

PatchHistory PatchFinder::update(const ClothModel& model, std::span<const Vec3> positions, const PatchHistory& last) {
  setPositions(positions);
  const bool known = last.patches != nullptr && last.patches->patchOfVertex.size() == positions.size() &&
                     last.patches->patchOfTriangle.size() == model.triangles.size();
  return updater_.update(mesh_.get(model, patchMeshOf), positions_, known ? last : PatchHistory{}, maxUpdatesPerGrowth);
}

SharedFeaturePatches PatchFinder::ofFeatures(const FeatureMesh& mesh, const PatchHistory& history) {
  if (last_ == nullptr || last_->patches != history.patches) {
    last_ = std::make_shared<FeaturePatches>(labelled(mesh, history.patches->patchOfVertex.size(), history.patches));
  }
  return last_;
}

bool PatchFinder::removeInvalid(std::span<const Vec3> positions, SharedFeaturePatches& patches) {
  setPositions(positions);
  if (check_.failures(*patches->patches, positions_, valid_) == 0) {
    return false;
  }
  FeaturePatches remaining = *patches;
  bool removed = false;
  for (auto* part : {&remaining.ofVertex, &remaining.ofEdge, &remaining.ofTriangle}) {
    for (int& patch : *part) {
      if (patch >= 0 && valid_[patch] == 0) {
        patch = none;
        removed = true;
      }
    }
  }
  if (removed) {
    patches = std::make_shared<FeaturePatches>(std::move(remaining));
  }
  return removed;
}

}  // namespace drape::sim::contact
