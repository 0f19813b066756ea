#include "sim/contact/exact/feature_patches.hpp"

#include "sim/forces/diagnostics.hpp"

#include <algorithm>

namespace drape::sim::contact {
namespace {

constexpr int maxUpdatesPerGrowth = 256;  // see PatchUpdater

/// Sides of a border that come closer than this fraction of the size of the cloth count as touching. Positions in float
/// have a rounding error of 6e-8 of the size, and the test adds a few of those.
constexpr float borderMarginRatio = 2e-6F;

/// Patches across borders are grown if the mean edge is shorter than this number of reaches. On meshes with longer
/// edges few neighbours are near, and the patches would cost more than they save.
constexpr double reachesOfShortEdges = 2.5;

constexpr int none = -1;
constexpr int unknown = -2;

/// The patch of a feature with one more triangle.
int joined(int patch, int patchOfTriangle) {
  return patch == unknown || patch == patchOfTriangle ? patchOfTriangle : none;
}

PatchLabels labelled(const FeatureMesh& mesh, std::shared_ptr<const CollisionFreePatches> patches) {
  PatchLabels labels{.patches = std::move(patches), .ofVertex = {}, .ofEdge = {}, .ofTriangle = {}};
  if (labels.patches->count() == 0) {
    return labels;
  }
  labels.ofTriangle = labels.patches->patchOfTriangle;
  labels.ofVertex = patchesAroundVertices(mesh.triangles, *labels.patches);
  labels.ofEdge.assign(mesh.edges.edges.size(), unknown);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int e : mesh.edgesOfTriangle[t]) {
      if (e >= 0) {
        labels.ofEdge[e] = joined(labels.ofEdge[e], labels.ofTriangle[t]);
      }
    }
  }
  return labels;
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
  grower_.setBorderMargin(borderMarginRatio * size);
  check_.setBorderMargin(borderMarginRatio * size);
}

PatchHistory PatchFinder::update(const ClothModel& model, double maxDistance, std::span<const Vec3> positions,
                                 const PatchHistory& last) {
  setPositions(positions);
  const bool known = last.patches != nullptr && last.patches->patchOfVertex.size() == positions.size() &&
                     last.patches->patchOfTriangle.size() == model.triangles.size();
  const PatchMesh& mesh = mesh_.get(model, patchMeshOf);
  PatchHistory next = updater_.update(mesh, positions_, known ? last : PatchHistory{}, maxUpdatesPerGrowth);
  const bool isFine = meanEdge_.get(model, meanEdge) < reachesOfShortEdges * maxDistance;
  updateAcrossBorders(mesh, isFine, last, next);
  return next;
}

/// Sets the patches across borders. Those of `last` are kept if the sets before them are the same and they are valid.
/// @param isFine whether there are any; otherwise the sets are empty
void PatchFinder::updateAcrossBorders(const PatchMesh& mesh, bool isFine, const PatchHistory& last,
                                      PatchHistory& next) {
  std::array<std::shared_ptr<const CollisionFreePatches>, patchSets> sets{next.patches};
  bool areSame = last.patches == next.patches;
  for (std::size_t k = 0; k < furtherPatchSets; ++k) {
    const auto& old = last.acrossBorders[k];
    areSame = areSame && old != nullptr && check_.failures(*old, positions_, valid_) == 0;
    if (areSame) {
      next.acrossBorders[k] = old;
    } else {
      auto patches = std::make_shared<CollisionFreePatches>();
      if (isFine) {
        grower_.growAcrossBorders(mesh, positions_, std::span(sets).first(k + 1), *patches);
      }
      next.acrossBorders[k] = patches;
    }
    sets[k + 1] = next.acrossBorders[k];
  }
}

SharedFeaturePatches PatchFinder::ofFeatures(const FeatureMesh& mesh, const PatchHistory& history) {
  std::array<std::shared_ptr<const CollisionFreePatches>, patchSets> sets{history.patches};
  std::ranges::copy(history.acrossBorders, sets.begin() + 1);
  const auto isOf = [](const PatchLabels& labels, const auto& patches) { return labels.patches == patches; };
  if (last_ == nullptr || !std::ranges::equal(*last_, sets, isOf)) {
    auto labels = std::make_shared<FeaturePatches>();
    std::ranges::transform(sets, labels->begin(), [&](const auto& patches) { return labelled(mesh, patches); });
    last_ = labels;
  }
  return last_;
}

bool PatchFinder::removeInvalid(std::span<const Vec3> positions, SharedFeaturePatches& patches) {
  setPositions(positions);
  std::shared_ptr<FeaturePatches> remaining;
  bool removed = false;
  for (std::size_t k = 0; k < patchSets; ++k) {
    if (check_.failures(*(*patches)[k].patches, positions_, valid_) > 0) {
      remaining = remaining != nullptr ? remaining : std::make_shared<FeaturePatches>(*patches);
      removed = removeMarked((*remaining)[k]) || removed;
    }
  }
  if (removed) {
    patches = remaining;
  }
  return removed;
}

/// Removes the features of the patches that the last check found invalid.
/// @returns whether there are any
bool PatchFinder::removeMarked(PatchLabels& labels) const {
  bool removed = false;
  for (auto* part : {&labels.ofVertex, &labels.ofEdge, &labels.ofTriangle}) {
    for (int& patch : *part) {
      if (patch >= 0 && valid_[patch] == 0) {
        patch = none;
        removed = true;
      }
    }
  }
  return removed;
}

}  // namespace drape::sim::contact
