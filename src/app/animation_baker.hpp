#pragma once

#include "io/import_protocol.hpp"

#include <string>

struct aiScene;

namespace drape::app {

/// What to compute from a scene.
struct BakeOptions {
  std::string clip;            ///< its name; empty: the only one
  double rate = 60.0;          ///< frames a second [1/s]
  double metresPerUnit = 1.0;  ///< [m]
  bool loop = false;           ///< whether the clip repeats
  double blend = 0.0;          ///< time from the bind pose to the start of the clip [s]
};

/// The meshes of a scene at equal times of a clip: skinned by their bones, or moved by their nodes. The frames of the
/// blend come first; a clip that loops runs meanwhile, so that it goes on without a jump of velocity. With the list of
/// the clips that can be baked. Throws InputError without the name of the file.
[[nodiscard]] io::ImportReply bakeAnimation(const aiScene& scene, const BakeOptions& options);

/// The meshes of a scene in their bind pose, and the clips that can be baked. Throws InputError without the name of the
/// file. @param metresPerUnit [m]
[[nodiscard]] io::ImportReply bindPoseWithClips(const aiScene& scene, double metresPerUnit);

}  // namespace drape::app
