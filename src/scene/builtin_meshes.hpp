#pragma once

#include <string_view>

namespace drape::scene {

/// The bytes of a built-in mesh, by its name below assets/meshes. Throws InputError with the list of names.
[[nodiscard]] std::string_view builtinMesh(std::string_view name);

}  // namespace drape::scene
