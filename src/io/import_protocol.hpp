#pragma once

#include "io/mesh_import.hpp"

#include <string>
#include <string_view>

namespace drape {

/// What the import program answers: a mesh, or in words why there is none.
struct ImportReply {
  RawMesh mesh;
  std::string error;  ///< empty when there is a mesh; no file name in it, one sentence with its full stop
};

/// The reply as bytes: a header with the counts, the arrays one after the other, and a closing mark. Both programs are
/// built together and run on one machine, so numbers keep the machine's own format.
[[nodiscard]] std::string encodeReply(const ImportReply& reply);

/// Takes a reply apart. Trusts nothing: throws InputError when the bytes are not exactly one whole reply.
[[nodiscard]] ImportReply decodeReply(std::string_view bytes);

}  // namespace drape
