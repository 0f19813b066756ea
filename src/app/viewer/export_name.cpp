#include "app/viewer/export_name.hpp"

#include "app/export/frame_name.hpp"
#include "app/output_file.hpp"
#include "app/viewer/free_name.hpp"
#include "text/words.hpp"

namespace drape::app {
namespace {

constexpr std::string_view placeholder = "{frame";

std::string withEnding(const std::string& file, const ui::ExportFormat& format) {
  const bool hasEnding = text::lowerCase(std::filesystem::path(file).extension().string()) == format.ending;
  return hasEnding ? file : file + std::string(format.ending);
}

}  // namespace

std::string exportName(const ui::ExportRequest& request, const std::filesystem::path& folder,
                       const std::string& scene) {
  const ui::ExportFormat& format = *request.format;
  if (request.file.empty()) {
    return format.isSequence ? (freeName(folder, scene, "") / "frame_{frame:4}").string() + std::string(format.ending)
                             : freeName(folder, scene, std::string(format.ending)).string();
  }
  std::string file = withEnding(std::filesystem::absolute(request.file).string(), format);
  if (format.isSequence && file.find(placeholder) == std::string::npos) {
    file.insert(file.size() - format.ending.size(), "_{frame:4}");
  }
  return file;
}

void requireNewFiles(const std::string& name, int firstFrame, int frames) {
  const bool isNumbered = name.find(placeholder) != std::string::npos;
  const FramePattern pattern(name, 1, "the name");
  for (int i = 0; i < (isNumbered ? frames : 1); ++i) {
    requireFree(pattern.name(firstFrame + i), Existing::Refused);
  }
}

}  // namespace drape::app
