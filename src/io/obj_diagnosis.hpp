#pragma once

#include <string>
#include <string_view>

namespace drape {

/// The first line of an OBJ file that explains why it cannot be read, with the reason: "line 7: 'nan' is not a finite
/// number". Empty when every vertex and face is in order. For messages, after the parsing has failed.
[[nodiscard]] std::string diagnoseObj(std::string_view text);

}  // namespace drape
