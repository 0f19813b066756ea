#pragma once

#include "io/clip_facts.hpp"
#include "io/mesh_import.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drape::io {

/// The reply of the import program: a mesh, or an error message.
struct ImportReply {
  RawMesh mesh;
  /// The positions of an animation's frames, as many in each as the mesh has; empty without an animation.
  std::vector<std::vector<Vec3>> frames;
  double frameTime = 0.0;             ///< between two frames [s]
  std::size_t leadFrames = 0;         ///< frames before the clip begins
  std::vector<ClipFacts> clips = {};  ///< of a file with a skeletal animation
  std::string error;  ///< empty when there is a mesh; otherwise one sentence with a full stop, without the file name
};

/// The reply as bytes: a header with the counts, the arrays in order, and a closing mark. Both programs are built
/// together and run on one machine, so numbers have the machine's format.
[[nodiscard]] std::string encodeReply(const ImportReply& reply);

/// A byte that reports progress. The import program may write such bytes before its reply; no reply starts with one.
[[nodiscard]] char progressByte(double share);

/// The progress of a byte; empty when it is the first byte of the reply.
[[nodiscard]] std::optional<double> progressOf(char byte);

/// The program's output without the progress before the reply.
[[nodiscard]] std::string_view withoutProgress(std::string_view output);

/// Decodes a reply and checks everything. Throws InputError when the bytes are not exactly one whole reply.
[[nodiscard]] ImportReply decodeReply(std::string_view bytes);

}  // namespace drape::io
