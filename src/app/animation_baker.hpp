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
};

/// The meshes of a scene at equal times of a clip: skinned by their bones, or moved by their nodes. Throws InputError
/// without the name of the file.
[[nodiscard]] io::ImportReply bakeAnimation(const aiScene& scene, const BakeOptions& options);

}  // namespace drape::app
