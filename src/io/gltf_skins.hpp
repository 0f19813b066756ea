#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace drape::io {

/// Checks the joints and the weights of all meshes with a skin. `buffers` are the contents of the document's buffers.
/// Throws InputError if a skin has no joints, if a vertex follows a joint that its skin does not have, or if more than
/// 1 % of the vertices of a mesh follow no joint. The parsing library leaves such weights out without a message. Parts
/// that are damaged in other ways are left to it. Source: glTF 2.0 specification, section 3.7.3.
void checkSkins(const nlohmann::json& document, const std::vector<std::string>& buffers);

}  // namespace drape::io
