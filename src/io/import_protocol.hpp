#pragma once

#include "io/mesh_import.hpp"

#include <optional>
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

/// Before its reply the import program may write bytes that tell its progress. No reply begins with one of them.
[[nodiscard]] char progressByte(double share);

/// The share that a byte tells; none when it is the first byte of the reply.
[[nodiscard]] std::optional<double> progressOf(char byte);

/// The program's output without the progress before the reply.
[[nodiscard]] std::string_view withoutProgress(std::string_view output);

/// Takes a reply apart. Trusts nothing: throws InputError when the bytes are not exactly one whole reply.
[[nodiscard]] ImportReply decodeReply(std::string_view bytes);

}  // namespace drape
