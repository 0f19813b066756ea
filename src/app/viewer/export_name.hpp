#pragma once

#include "ui/export_request.hpp"

#include <filesystem>
#include <string>

namespace drape::app {

/// The name of the files of an export. Its ending is that of the format, and a file for each frame has the placeholder
/// "{frame:4}". Without a name in the request: a free one in `folder`, from that of the scene; a new folder for a
/// sequence.
[[nodiscard]] std::string exportName(const ui::ExportRequest& request, const std::filesystem::path& folder,
                                     const std::string& scene);

/// Throws InputError if the file, or that of one of these frames, exists already.
void requireNewFiles(const std::string& name, int firstFrame, int frames);

}  // namespace drape::app
