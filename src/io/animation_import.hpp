#pragma once

#include "io/clip_facts.hpp"
#include "io/import_watch.hpp"
#include "io/mesh_import.hpp"
#include "sim/model/vector.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace drape::io {

/// How to read the skeletal animation of a file.
struct AnimationOptions {
  std::string clip;            ///< its name; empty: the only one
  double rate = 60.0;          ///< frames a second [1/s]
  double metresPerUnit = 1.0;  ///< a factor on lengths, beyond the unit that the file states [-]
  bool loop = false;           ///< whether the clip repeats
  double blend = 0.0;  ///< time from the bind pose, in which the mesh was modelled, to the start of the clip [s]
  ImportWatch watch = {};
};

/// A mesh whose vertices move.
struct AnimatedMesh {
  std::vector<Triangle> triangles;        ///< counter-clockwise from outside
  std::vector<std::vector<Vec3>> frames;  ///< the positions at equal time intervals, at least two, the last one at the
                                          ///< end of the clip [m]
  double frameTime = 0.0;                 ///< [s]; the length of the clip is a multiple of it
  std::size_t leadFrames = 0;    ///< the first ones, of the blend from the bind pose; the clip begins after them
  std::vector<ClipFacts> clips;  ///< of the file, this one and those that could be chosen instead
};

/// A file with a skeletal animation before its frames are computed.
struct BindPose {
  ImportedMesh mesh;             ///< in the pose in which it was modelled, in metres with y up
  std::vector<ClipFacts> clips;  ///< that can move it
};

/// The extensions of the formats with skeletal animation, lower case, without the dot.
[[nodiscard]] std::vector<std::string> animationFormats();

/// Whether the extension is that of a format with skeletal animation.
[[nodiscard]] bool isAnimationFile(const std::filesystem::path& file);

/// Whether it is one of them that is not read as a mesh: the file can only be a body that a clip moves.
[[nodiscard]] bool isOnlyAnimationFile(const std::filesystem::path& file);

/// Reads the clip of a skeletal animation and computes the positions of its frames (linear blend skinning, as the
/// formats define it). A child process with limits of memory and time does this. y is up. Vertices that stay together
/// in all frames become one. Throws InputError (also for a clip that does not exist, with the names of those that do)
/// and Cancelled.
[[nodiscard]] AnimatedMesh importAnimation(const std::filesystem::path& file, const AnimationOptions& options);

/// Reads the pose of the mesh and the list of the clips. Throws like importAnimation.
[[nodiscard]] BindPose importBindPose(const std::filesystem::path& file, const ImportOptions& options);

}  // namespace drape::io
