#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace drape::io {

/// Replaces the keys of animations that are steps (STEP) or cubic curves (CUBICSPLINE) by keys with straight lines
/// between them: the parsing library reads all keys like this. A step becomes two keys at almost the same time, a curve
/// a key at least every 1/120 s. `buffers` are the contents of the document's buffers; new keys get a buffer of their
/// own. Keys that are damaged, whose times do not ascend, or that take longer than a clip may (longestClip), stay as
/// they are. Returns whether anything changed. Source: glTF 2.0 specification, section 3.11 and appendix C.
[[nodiscard]] bool straightenKeys(nlohmann::json& document, std::vector<std::string>& buffers);

}  // namespace drape::io
