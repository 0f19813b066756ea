#include "animation_baker.hpp"

#include "io/mesh_import.hpp"
#include "io/quoted_text.hpp"
#include "messages/error.hpp"

#include <assimp/anim.h>
#include <assimp/scene.h>

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drape::app {
namespace {

using messages::InputError;

constexpr double longestClip = 600.0;  // [s]
constexpr std::size_t maxTriangles = io::maxMovingTriangles;
constexpr std::size_t maxPositions = 30'000'000;  // in all frames
constexpr double usualTicks = 25.0;               // a second, for a file that does not say

std::string nameOf(const aiString& name) {
  return {name.data, name.length};
}

std::string clipNames(const aiScene& scene) {
  std::string names;
  for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
    names += (names.empty() ? "" : ", ") + io::quoted(nameOf(scene.mAnimations[i]->mName));
  }
  return names;
}

const aiAnimation& chooseClip(const aiScene& scene, const std::string& clip) {
  if (scene.mNumAnimations == 0) {
    throw InputError("there is no animation in it. Export the mesh with its animation.");
  }
  if (clip.empty() && scene.mNumAnimations == 1) {
    return *scene.mAnimations[0];
  }
  for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
    if (!clip.empty() && nameOf(scene.mAnimations[i]->mName) == clip) {
      return *scene.mAnimations[i];
    }
  }
  throw InputError(
      (clip.empty() ? std::string("there are several clips in it") : "there is no clip " + io::quoted(clip)) +
      ". Choose one of " + clipNames(scene) + ".");
}

template <typename Key>
void checkKeys(const Key* keys, unsigned count, const std::string& node) {
  for (unsigned k = 0; k < count; ++k) {
    if (!std::isfinite(keys[k].mTime) || (k > 0 && keys[k].mTime < keys[k - 1].mTime)) {
      throw InputError("the times of the keys of " + io::quoted(node) + " do not ascend. Export the animation again.");
    }
  }
}

aiVector3D between(const aiVector3D& a, const aiVector3D& b, float t) {
  return a + (b - a) * t;
}

aiQuaternion between(const aiQuaternion& a, const aiQuaternion& b, float t) {
  aiQuaternion result;
  aiQuaternion::Interpolate(result, a, b, t);
  return result;
}

/// The value of keys at a time, linear between two keys and constant outside. @param usual without keys
template <typename Key, typename Value>
Value valueAt(const Key* keys, unsigned count, double ticks, const Value& usual) {
  if (count == 0) {
    return usual;
  }
  const Key* const next =
      std::upper_bound(keys, keys + count, ticks, [](double time, const Key& key) { return time < key.mTime; });
  if (next == keys) {
    return keys[0].mValue;
  }
  if (next == keys + count) {
    return keys[count - 1].mValue;
  }
  const Key& from = *(next - 1);
  return between(from.mValue, next->mValue, static_cast<float>((ticks - from.mTime) / (next->mTime - from.mTime)));
}

/// The nodes of a scene with their parents before them.
struct Node {
  const aiNode* node = nullptr;
  int parent = -1;
  const aiNodeAnim* channel = nullptr;
};

/// A bone of a mesh.
struct Bone {
  int node = 0;
  const aiBone* bone = nullptr;
};

/// A mesh where a node places it.
struct Instance {
  const aiMesh* mesh = nullptr;
  int node = 0;
  std::vector<Bone> bones;
  std::size_t first = 0;           // of its vertices in a frame
  std::vector<float> totalWeight;  // of each vertex; empty without bones
};

class Baker {
 public:
  Baker(const aiScene& scene, const aiAnimation& clip) : scene_(scene) {
    addNode(*scene.mRootNode, -1);
    for (unsigned c = 0; c < clip.mNumChannels; ++c) {
      addChannel(*clip.mChannels[c]);
    }
    for (Instance& instance : instances_) {
      addBones(instance);
    }
  }

  [[nodiscard]] std::size_t vertices() const { return vertices_; }

  [[nodiscard]] std::vector<Triangle> triangles(int& facesSkipped) const {
    std::vector<Triangle> all;
    for (const Instance& instance : instances_) {
      for (unsigned f = 0; f < instance.mesh->mNumFaces; ++f) {
        const aiFace& face = instance.mesh->mFaces[f];
        if (face.mNumIndices != 3) {
          ++facesSkipped;
          continue;
        }
        Triangle triangle{};
        for (unsigned corner = 0; corner < 3; ++corner) {
          triangle[corner] = static_cast<int>(instance.first + face.mIndices[corner]);
        }
        all.push_back(triangle);
      }
    }
    return all;
  }

  /// The positions at a time of the clip [ticks].
  [[nodiscard]] std::vector<Vec3> frameAt(double ticks, double scale) {
    placeNodes(ticks);
    std::vector<Vec3> positions(vertices_, Vec3::Zero());
    for (const Instance& instance : instances_) {
      for (const Bone& bone : instance.bones) {
        const aiMatrix4x4 moves = places_[bone.node] * bone.bone->mOffsetMatrix;
        for (unsigned w = 0; w < bone.bone->mNumWeights; ++w) {
          const aiVertexWeight& weight = bone.bone->mWeights[w];
          const float total = instance.totalWeight[weight.mVertexId];
          const float share = total > 0.0F ? weight.mWeight / total : 0.0F;
          add(moves * instance.mesh->mVertices[weight.mVertexId], share * scale,
              positions[instance.first + weight.mVertexId]);
        }
      }
      for (unsigned v = 0; v < instance.mesh->mNumVertices; ++v) {
        if (instance.totalWeight.empty() || !(instance.totalWeight[v] > 0.0F)) {  // it follows its node
          add(places_[instance.node] * instance.mesh->mVertices[v], scale, positions[instance.first + v]);
        }
      }
    }
    if (!std::all_of(positions.begin(), positions.end(), [](const Vec3& p) { return p.allFinite(); })) {
      throw InputError("one of its vertices moves to a place that is not a finite number. Export the animation again.");
    }
    return positions;
  }

 private:
  static void add(const aiVector3D& position, double weight, Vec3& sum) {
    sum += weight * Vec3(position.x, position.y, position.z);
  }

  void addNode(const aiNode& node, int parent) {
    const auto index = static_cast<int>(nodes_.size());
    nodes_.push_back({&node, parent, nullptr});
    byName_.emplace(nameOf(node.mName), index);
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
      const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[m]];
      instances_.push_back({&mesh, index, {}, vertices_, {}});
      vertices_ += mesh.mNumVertices;
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) {
      addNode(*node.mChildren[c], index);
    }
  }

  void addChannel(const aiNodeAnim& channel) {
    const std::string name = nameOf(channel.mNodeName);
    checkKeys(channel.mPositionKeys, channel.mNumPositionKeys, name);
    checkKeys(channel.mRotationKeys, channel.mNumRotationKeys, name);
    checkKeys(channel.mScalingKeys, channel.mNumScalingKeys, name);
    if (const auto found = byName_.find(name); found != byName_.end()) {
      nodes_[found->second].channel = &channel;
    }
  }

  void addBones(Instance& instance) {
    const aiMesh& mesh = *instance.mesh;
    if (mesh.mNumBones == 0) {
      return;
    }
    instance.totalWeight.assign(mesh.mNumVertices, 0.0F);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const aiBone& bone = *mesh.mBones[b];
      const auto found = byName_.find(nameOf(bone.mName));
      if (found == byName_.end()) {
        throw InputError("its bone " + io::quoted(nameOf(bone.mName)) +
                         " is not in the skeleton. Export the skin with its skeleton.");
      }
      for (unsigned w = 0; w < bone.mNumWeights; ++w) {
        if (bone.mWeights[w].mVertexId >= mesh.mNumVertices) {
          throw InputError("its bone " + io::quoted(nameOf(bone.mName)) +
                           " moves a missing vertex. Export the mesh again.");
        }
        instance.totalWeight[bone.mWeights[w].mVertexId] += bone.mWeights[w].mWeight;
      }
      instance.bones.push_back({found->second, &bone});
    }
  }

  void placeNodes(double ticks) {
    places_.resize(nodes_.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      const Node& node = nodes_[n];
      aiMatrix4x4 own = node.node->mTransformation;
      if (node.channel != nullptr) {
        const aiNodeAnim& channel = *node.channel;
        aiVector3D scale;
        aiQuaternion turn;
        aiVector3D shift;
        own.Decompose(scale, turn, shift);
        own = aiMatrix4x4(valueAt(channel.mScalingKeys, channel.mNumScalingKeys, ticks, scale),
                          valueAt(channel.mRotationKeys, channel.mNumRotationKeys, ticks, turn),
                          valueAt(channel.mPositionKeys, channel.mNumPositionKeys, ticks, shift));
      }
      places_[n] = node.parent < 0 ? own : places_[node.parent] * own;
    }
  }

  const aiScene& scene_;
  std::vector<Node> nodes_;
  std::map<std::string, int> byName_;
  std::vector<Instance> instances_;
  std::vector<aiMatrix4x4> places_;
  std::size_t vertices_ = 0;
};

void requireBones(const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    if (scene.mMeshes[m]->mNumBones > 0) {
      return;
    }
  }
  throw InputError("none of its meshes has a skin with bones. Export the mesh with its skeleton and its weights.");
}

}  // namespace

io::ImportReply bakeAnimation(const aiScene& scene, const BakeOptions& options) {
  requireBones(scene);
  const aiAnimation& clip = chooseClip(scene, options.clip);
  const double ticksPerSecond = clip.mTicksPerSecond > 0.0 ? clip.mTicksPerSecond : usualTicks;
  const double duration = clip.mDuration / ticksPerSecond;
  const std::string name = io::quoted(nameOf(clip.mName));
  if (!(duration > 0.0)) {
    throw InputError("its clip " + name + " has no length. Choose another clip, or export it again.");
  }
  if (!(duration <= longestClip)) {
    throw InputError(
        fmt::format("its clip {} takes {:.3g} s, and the limit is {:.0f} s. Cut it.", name, duration, longestClip));
  }
  Baker baker(scene, clip);
  io::ImportReply reply;
  reply.mesh.triangles = baker.triangles(reply.mesh.facesSkipped);
  if (reply.mesh.triangles.size() > maxTriangles) {
    throw InputError(fmt::format("it has {} triangles, and a body that moves may have {}. Reduce the mesh.",
                                 reply.mesh.triangles.size(), maxTriangles));
  }
  const auto steps = static_cast<std::size_t>(std::max(1L, std::lround(duration * options.rate)));
  if ((steps + 1) * baker.vertices() > maxPositions) {
    throw InputError(
        fmt::format("its clip has {} frames of {} vertices, which is too much. Use a lower rate, or reduce "
                    "the mesh.",
                    steps + 1, baker.vertices()));
  }
  for (std::size_t k = 0; k <= steps; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(steps);
    reply.frames.push_back(baker.frameAt(share * clip.mDuration, options.metresPerUnit));
  }
  reply.mesh.positions = reply.frames.front();
  reply.frameTime = duration / static_cast<double>(steps);
  return reply;
}

}  // namespace drape::app
