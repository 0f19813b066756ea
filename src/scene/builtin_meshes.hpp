#pragma once

#include <string_view>

namespace drape {

/// The bytes of a mesh that is built in, by its name below assets/meshes. Throws InputError listing what there is.
[[nodiscard]] std::string_view builtinMesh(std::string_view name);

}  // namespace drape
