#pragma once

#include <assimp/anim.h>
#include <assimp/scene.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace drape::app {

/// A name of assimp as a text.
[[nodiscard]] std::string nameOf(const aiString& name);

/// A node of a scene. Its parent has a lower index.
struct AnimatedNode {
  const aiNode* node = nullptr;
  int parent = -1;                      ///< -1: none
  const aiNodeAnim* channel = nullptr;  ///< its keys in the clip; null: none
};

/// A bone of a mesh.
struct SkinBone {
  int node = 0;
  const aiBone* bone = nullptr;
};

/// A mesh where a node places it.
struct MeshInstance {
  const aiMesh* mesh = nullptr;
  int node = 0;
  std::vector<SkinBone> bones;
  std::size_t first = 0;  ///< of its vertices in a frame
};

/// The places of all nodes in the scene.
using NodePlaces = std::vector<aiMatrix4x4>;

/// The nodes and the meshes of a scene.
class NodeTree {
 public:
  /// Throws InputError if a node uses a missing mesh.
  explicit NodeTree(const aiScene& scene);

  [[nodiscard]] const std::vector<AnimatedNode>& nodes() const { return nodes_; }
  /// In the order of the nodes. Their bones are those that the skeleton has.
  [[nodiscard]] const std::vector<MeshInstance>& instances() const { return instances_; }
  /// The name of a bone that the skeleton does not have; empty if there is none.
  [[nodiscard]] const std::string& missingBone() const { return missingBone_; }
  /// Of all instances.
  [[nodiscard]] std::size_t vertices() const { return vertices_; }

  /// Lets the keys of a clip move a node, if there is a node of its name.
  void animate(const aiNodeAnim& channel);

  /// The places without a clip.
  [[nodiscard]] NodePlaces usualPlaces() const;

 private:
  void addNode(const aiScene& scene, const aiNode& node, int parent);
  void addBones(MeshInstance& instance);

  std::vector<AnimatedNode> nodes_;
  std::vector<MeshInstance> instances_;
  std::map<std::string, int> byName_;  // of several nodes with one name, one without a mesh: bones have none
  std::string missingBone_;
  std::size_t vertices_ = 0;
};

/// The nodes where their bones leave the meshes as they were modelled (the bind pose): in a T-pose, for most figures.
[[nodiscard]] NodePlaces bindPose(const NodeTree& tree);

/// Places between two poses: position, rotation and scale of each node relative to its parent are interpolated.
/// @param share 0: from, 1: to
[[nodiscard]] NodePlaces betweenPoses(const NodeTree& tree, const NodePlaces& from, const NodePlaces& to, double share);

}  // namespace drape::app
