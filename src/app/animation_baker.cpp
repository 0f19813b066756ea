#include "animation_baker.hpp"

#include "animated_nodes.hpp"
#include "io/clip_facts.hpp"
#include "io/mesh_import.hpp"
#include "io/quoted_text.hpp"
#include "messages/error.hpp"

#include <assimp/anim.h>
#include <assimp/scene.h>

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace drape::app {
namespace {

using messages::InputError;

constexpr std::size_t maxTriangles = io::maxMovingTriangles;
constexpr std::size_t maxPositions = 30'000'000;  // in all frames
constexpr double usualTicks = 25.0;               // a second, for a file that does not say

std::string clipNames(const aiScene& scene) {
  std::string names;
  for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
    names += (names.empty() ? "" : ", ") + io::quoted(nameOf(scene.mAnimations[i]->mName));
  }
  return names;
}

/// The length of a clip [s].
double durationOf(const aiAnimation& clip) {
  return clip.mDuration / (clip.mTicksPerSecond > 0.0 ? clip.mTicksPerSecond : usualTicks);
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
  if (scene.mNumAnimations == 1 && scene.mAnimations[0]->mName.length == 0) {
    throw InputError("there is no clip " + io::quoted(clip) + "; its only clip has no name. Leave the name out.");
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

class Baker {
 public:
  Baker(const aiScene& scene, const aiAnimation& clip) : tree_(scene) {
    if (!tree_.missingBone().empty()) {
      throw InputError("its bone " + io::quoted(tree_.missingBone()) +
                       " is not in the skeleton. Export the skin with its skeleton.");
    }
    for (unsigned c = 0; c < clip.mNumChannels; ++c) {
      checkChannel(*clip.mChannels[c]);
      tree_.animate(*clip.mChannels[c]);
    }
    for (const MeshInstance& instance : tree_.instances()) {
      totalWeights_.push_back(totalWeightsOf(instance));
    }
  }

  [[nodiscard]] std::size_t vertices() const { return tree_.vertices(); }

  [[nodiscard]] std::vector<Triangle> triangles(int& facesSkipped) const {
    std::vector<Triangle> all;
    for (const MeshInstance& instance : tree_.instances()) {
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
    return skinned(scale);
  }

  /// The positions between the bind pose, share 0, and a time of the clip, share 1.
  [[nodiscard]] std::vector<Vec3> frameBefore(double ticks, double share, double scale) {
    if (bind_.empty()) {
      bind_ = bindPose(tree_);
    }
    placeNodes(ticks);
    places_ = betweenPoses(tree_, bind_, places_, share);
    return skinned(scale);
  }

 private:
  [[nodiscard]] std::vector<Vec3> skinned(double scale) const {
    std::vector<Vec3> positions(vertices(), Vec3::Zero());
    for (std::size_t i = 0; i < tree_.instances().size(); ++i) {
      addInstance(tree_.instances()[i], totalWeights_[i], scale, positions);
    }
    if (!std::all_of(positions.begin(), positions.end(), [](const Vec3& p) { return p.allFinite(); })) {
      throw InputError("one of its vertices moves to a place that is not a finite number. Export the animation again.");
    }
    return positions;
  }

  static void add(const aiVector3D& position, double weight, Vec3& sum) {
    sum += weight * Vec3(position.x, position.y, position.z);
  }

  void addInstance(const MeshInstance& instance, const std::vector<float>& totals, double scale,
                   std::vector<Vec3>& positions) const {
    for (const SkinBone& bone : instance.bones) {
      const aiMatrix4x4 moves = places_[bone.node] * bone.bone->mOffsetMatrix;
      for (unsigned w = 0; w < bone.bone->mNumWeights; ++w) {
        const aiVertexWeight& weight = bone.bone->mWeights[w];
        const float total = totals[weight.mVertexId];
        const float share = total > 0.0F ? weight.mWeight / total : 0.0F;
        add(moves * instance.mesh->mVertices[weight.mVertexId], share * scale,
            positions[instance.first + weight.mVertexId]);
      }
    }
    for (unsigned v = 0; v < instance.mesh->mNumVertices; ++v) {
      if (totals.empty() || !(totals[v] > 0.0F)) {  // it follows its node
        add(places_[instance.node] * instance.mesh->mVertices[v], scale, positions[instance.first + v]);
      }
    }
  }

  static void checkChannel(const aiNodeAnim& channel) {
    const std::string name = nameOf(channel.mNodeName);
    checkKeys(channel.mPositionKeys, channel.mNumPositionKeys, name);
    checkKeys(channel.mRotationKeys, channel.mNumRotationKeys, name);
    checkKeys(channel.mScalingKeys, channel.mNumScalingKeys, name);
  }

  /// The sum of the weights of each vertex; empty without bones.
  static std::vector<float> totalWeightsOf(const MeshInstance& instance) {
    std::vector<float> totals;
    if (instance.bones.empty()) {
      return totals;
    }
    totals.assign(instance.mesh->mNumVertices, 0.0F);
    for (const SkinBone& bone : instance.bones) {
      for (unsigned w = 0; w < bone.bone->mNumWeights; ++w) {
        if (bone.bone->mWeights[w].mVertexId >= instance.mesh->mNumVertices) {
          throw InputError("its bone " + io::quoted(nameOf(bone.bone->mName)) +
                           " moves a missing vertex. Export the mesh again.");
        }
        totals[bone.bone->mWeights[w].mVertexId] += bone.bone->mWeights[w].mWeight;
      }
    }
    return totals;
  }

  void placeNodes(double ticks) {
    places_.resize(tree_.nodes().size());
    for (std::size_t n = 0; n < places_.size(); ++n) {
      const AnimatedNode& node = tree_.nodes()[n];
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

  NodeTree tree_;
  std::vector<std::vector<float>> totalWeights_;  // of the vertices of each instance
  NodePlaces places_;
  NodePlaces bind_;  // once one was needed
};

void requireBones(const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    if (scene.mMeshes[m]->mNumBones > 0) {
      return;
    }
  }
  throw InputError("none of its meshes has a skin with bones. Export the mesh with its skeleton and its weights.");
}

void addTriangles(const Baker& baker, io::ImportReply& reply) {
  reply.mesh.triangles = baker.triangles(reply.mesh.facesSkipped);
  if (reply.mesh.triangles.size() > maxTriangles) {
    throw InputError(fmt::format("it has {} triangles, and a body that moves may have {}. Reduce the mesh.",
                                 reply.mesh.triangles.size(), maxTriangles));
  }
}

/// Whether a clip can be baked and chosen by its name.
bool isUsable(const aiScene& scene, const aiAnimation& clip) {
  const double duration = durationOf(clip);
  return duration > 0.0 && duration <= io::longestClip && (scene.mNumAnimations == 1 || clip.mName.length > 0);
}

std::vector<io::ClipFacts> clipsOf(const aiScene& scene) {
  std::vector<io::ClipFacts> clips;
  for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
    const aiAnimation& clip = *scene.mAnimations[i];
    if (isUsable(scene, clip)) {
      clips.push_back({nameOf(clip.mName), durationOf(clip)});
    }
  }
  return clips;
}

/// 0 at 0 and 1 at 1, with slope 0 at both.
double smoothStep(double x) {
  return x * x * (3.0 - 2.0 * x);
}

/// The time of a frame of a clip.
double ticksOf(std::size_t frame, std::size_t frames, const aiAnimation& clip) {
  return static_cast<double>(frame) / static_cast<double>(frames) * clip.mDuration;
}

}  // namespace

io::ImportReply bakeAnimation(const aiScene& scene, const BakeOptions& options) {
  requireBones(scene);
  const aiAnimation& clip = chooseClip(scene, options.clip);
  const double duration = durationOf(clip);
  const std::string name = io::quoted(nameOf(clip.mName));
  if (!(duration > 0.0)) {
    throw InputError("its clip " + name + " has no length. Choose another clip, or export it again.");
  }
  if (!(duration <= io::longestClip)) {
    throw InputError(
        fmt::format("its clip {} takes {:.3g} s, and the limit is {:.0f} s. Cut it.", name, duration, io::longestClip));
  }
  Baker baker(scene, clip);
  io::ImportReply reply;
  addTriangles(baker, reply);
  const auto steps = static_cast<std::size_t>(std::max(1L, std::lround(duration * options.rate)));
  reply.frameTime = duration / static_cast<double>(steps);
  const auto lead = static_cast<std::size_t>(std::ceil(options.blend / reply.frameTime));
  if ((lead + steps + 1) * baker.vertices() > maxPositions) {
    throw InputError(
        fmt::format("its clip has {} frames of {} vertices, which is too much. Use a lower rate, or reduce "
                    "the mesh.",
                    lead + steps + 1, baker.vertices()));
  }
  for (std::size_t k = 0; k < lead; ++k) {
    const double share = smoothStep(static_cast<double>(k) / static_cast<double>(lead));
    const std::size_t frame = options.loop ? (steps - (lead - k) % steps) % steps : 0;
    reply.frames.push_back(baker.frameBefore(ticksOf(frame, steps, clip), share, options.metresPerUnit));
  }
  for (std::size_t k = 0; k <= steps; ++k) {
    reply.frames.push_back(baker.frameAt(ticksOf(k, steps, clip), options.metresPerUnit));
  }
  reply.leadFrames = lead;
  reply.clips = clipsOf(scene);
  reply.mesh.positions = reply.frames.front();
  return reply;
}

io::ImportReply bindPoseWithClips(const aiScene& scene, double metresPerUnit) {
  requireBones(scene);
  io::ImportReply reply;
  const aiAnimation still;
  Baker baker(scene, still);
  addTriangles(baker, reply);
  reply.mesh.positions = baker.frameBefore(0.0, 0.0, metresPerUnit);
  reply.clips = clipsOf(scene);
  return reply;
}

}  // namespace drape::app
