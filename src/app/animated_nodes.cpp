#include "animated_nodes.hpp"

#include "messages/error.hpp"

#include <algorithm>
#include <cmath>

namespace drape::app {
namespace {

struct Parts {
  aiVector3D scale;
  aiQuaternion turn;
  aiVector3D shift;
};

Parts partsOf(const aiMatrix4x4& matrix) {
  Parts parts;
  matrix.Decompose(parts.scale, parts.turn, parts.shift);
  return parts;
}

aiMatrix4x4 inverseOf(aiMatrix4x4 matrix) {
  return matrix.Inverse();
}

float sizeOf(const aiMesh& mesh) {
  aiVector3D low = mesh.mVertices[0];
  aiVector3D high = low;
  for (unsigned v = 1; v < mesh.mNumVertices; ++v) {
    const aiVector3D& p = mesh.mVertices[v];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return (high - low).Length();
}

/// Whether two places of a mesh differ no more than the root of a skeleton moves in a clip.
bool areNear(const aiMatrix4x4& a, const aiMatrix4x4& b, const aiMesh& mesh) {
  constexpr float largestRatio = 1.1F;
  constexpr float smallestCosine = 0.924F;  // of half the angle: 45 degrees
  const Parts first = partsOf(a);
  const Parts second = partsOf(b);
  const float ratio = first.scale.Length() / second.scale.Length();
  const float cosine = std::abs(first.turn.w * second.turn.w + first.turn.x * second.turn.x +
                                first.turn.y * second.turn.y + first.turn.z * second.turn.z);
  const float shift = (first.shift - second.shift).Length();
  return ratio < largestRatio && ratio > 1.0F / largestRatio && cosine > smallestCosine &&
         shift < 0.5F * sizeOf(mesh) * std::max(first.scale.Length(), second.scale.Length());
}

/// Where a mesh with bones is in its bind pose: at its node, or as the root of its bones places it. Exporters write a
/// node that is anywhere else, since readers ignore it. @param usual the places without a clip
aiMatrix4x4 placeInBindPose(const MeshInstance& instance, const NodePlaces& usual) {
  const SkinBone& root = *std::ranges::min_element(instance.bones, {}, &SkinBone::node);
  const aiMatrix4x4 byRoot = usual[root.node] * root.bone->mOffsetMatrix;
  const aiMatrix4x4& byNode = usual[instance.node];
  return instance.mesh->mNumVertices == 0 || areNear(byNode, byRoot, *instance.mesh) ? byNode : byRoot;
}

}  // namespace

std::string nameOf(const aiString& name) {
  return {name.data, name.length};
}

NodeTree::NodeTree(const aiScene& scene) {
  addNode(scene, *scene.mRootNode, -1);
  for (MeshInstance& instance : instances_) {
    addBones(instance);
  }
}

void NodeTree::animate(const aiNodeAnim& channel) {
  if (const auto found = byName_.find(nameOf(channel.mNodeName)); found != byName_.end()) {
    nodes_[found->second].channel = &channel;
  }
}

NodePlaces NodeTree::usualPlaces() const {
  NodePlaces places(nodes_.size());
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const AnimatedNode& node = nodes_[n];
    places[n] = node.parent < 0 ? node.node->mTransformation : places[node.parent] * node.node->mTransformation;
  }
  return places;
}

void NodeTree::addNode(const aiScene& scene, const aiNode& node, int parent) {
  const auto index = static_cast<int>(nodes_.size());
  nodes_.push_back({&node, parent, nullptr});
  const auto [known, isNew] = byName_.emplace(nameOf(node.mName), index);
  if (!isNew && nodes_[known->second].node->mNumMeshes > 0 && node.mNumMeshes == 0) {
    known->second = index;
  }
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    if (node.mMeshes[m] >= scene.mNumMeshes) {
      throw messages::InputError("one of its nodes uses a missing mesh. Export the mesh again.");
    }
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    instances_.push_back({&mesh, index, {}, vertices_});
    vertices_ += mesh.mNumVertices;
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) {
    addNode(scene, *node.mChildren[c], index);
  }
}

void NodeTree::addBones(MeshInstance& instance) {
  for (unsigned b = 0; b < instance.mesh->mNumBones; ++b) {
    const aiBone& bone = *instance.mesh->mBones[b];
    const std::string name = nameOf(bone.mName);
    if (const auto found = byName_.find(name); found != byName_.end()) {
      instance.bones.push_back({found->second, &bone});
    } else {
      missingBone_ = name;
    }
  }
}

NodePlaces bindPose(const NodeTree& tree) {
  const std::vector<AnimatedNode>& nodes = tree.nodes();
  const NodePlaces usual = tree.usualPlaces();
  NodePlaces places(nodes.size());
  std::vector<bool> known(nodes.size(), false);
  for (const MeshInstance& instance : tree.instances()) {
    if (instance.bones.empty()) {
      continue;
    }
    const aiMatrix4x4 place = placeInBindPose(instance, usual);
    for (const SkinBone& bone : instance.bones) {
      if (!known[bone.node]) {
        places[bone.node] = place * inverseOf(bone.bone->mOffsetMatrix);
        known[bone.node] = true;
      }
    }
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!known[n]) {
      const int parent = nodes[n].parent;
      places[n] = parent < 0 ? usual[n] : places[parent] * inverseOf(usual[parent]) * usual[n];
    }
  }
  return places;
}

NodePlaces betweenPoses(const NodeTree& tree, const NodePlaces& from, const NodePlaces& to, double share) {
  const auto weight = static_cast<float>(share);
  NodePlaces places(tree.nodes().size());
  for (std::size_t n = 0; n < places.size(); ++n) {
    const int parent = tree.nodes()[n].parent;
    const Parts first = partsOf(parent < 0 ? from[n] : inverseOf(from[parent]) * from[n]);
    const Parts second = partsOf(parent < 0 ? to[n] : inverseOf(to[parent]) * to[n]);
    aiQuaternion turn;
    aiQuaternion::Interpolate(turn, first.turn, second.turn, weight);
    const aiMatrix4x4 own(first.scale + (second.scale - first.scale) * weight, turn,
                          first.shift + (second.shift - first.shift) * weight);
    places[n] = parent < 0 ? own : places[parent] * own;
  }
  return places;
}

}  // namespace drape::app
