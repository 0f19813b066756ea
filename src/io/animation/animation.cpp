#include "io/animation/animation.hpp"

#include "messages/error.hpp"
#include "text/words.hpp"

#include <algorithm>
#include <array>

namespace drape::io::animation {
namespace {

struct KnownFormat {
  Format format;
  std::unique_ptr<Writer> (*make)(const FileOfFrame&, const Clip&) = nullptr;
};

constexpr std::array<KnownFormat, 7> knownFormats{{
    {{"obj", false, true, false}, makeObjWriter},
    {{"ply", false, false, false}, makePlyWriter},
    {{"pc2", true, false, false}, makePc2Writer},
    {{"mdd", true, false, false}, makeMddWriter},
    {{"glb", true, true, true}, makeGlbWriter},
    {{"usda", true, true, false}, makeUsdaWriter},
    {{"csv", true, true, false}, makeCsvWriter},
}};

const KnownFormat& knownFormatOf(const std::filesystem::path& file) {
  const std::string ending = text::lowerCase(file.extension().string());
  const auto* const found = std::find_if(knownFormats.begin(), knownFormats.end(), [&](const KnownFormat& known) {
    return !ending.empty() && ending.substr(1) == known.format.extension;
  });
  if (found == knownFormats.end()) {
    std::string list;
    for (const KnownFormat& known : knownFormats) {
      list += (list.empty() ? "." : ", .") + std::string(known.format.extension);
    }
    throw messages::UsageError(file.string() + ": " +
                               (ending.empty() ? "has no extension" : "'" + ending + "' is not a format of exports") +
                               "; the formats are " + list);
  }
  return *found;
}

}  // namespace

const Format& formatOf(const std::filesystem::path& file) {
  return knownFormatOf(file).format;
}

std::unique_ptr<Writer> makeWriter(const FileOfFrame& files, const Clip& clip) {
  return knownFormatOf(files(clip.firstFrame)).make(files, clip);
}

}  // namespace drape::io::animation
