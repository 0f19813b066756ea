#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace drape::io {

/// The parts of a glTF document that a mesh is made of: the nodes of its scene, and the positions, first texture
/// coordinates and indices of its meshes. A mesh with a skin is where its joints place it. Damage in all other parts
/// (materials, skins, animations) does no harm then.
/// `buffers` are the contents of the document's buffers. Throws InputError, with the place, when a part is missing, is
/// of another kind than it should be, or points beyond the data. The parsing library crashes or stalls on some
/// such files, leaves faces out of others without a message, and describes the cause in internal terms.
/// Source: glTF 2.0 specification, sections 3.5 to 3.7 and 5.
[[nodiscard]] nlohmann::json meshPartsOf(const nlohmann::json& document, const std::vector<std::string>& buffers);

}  // namespace drape::io
