#include "app/fabric_list.hpp"

#include "app/output_file.hpp"
#include "app/user_folder.hpp"
#include "messages/error.hpp"
#include "scene/fabric_file.hpp"
#include "scene/text_file.hpp"

#include <unistd.h>
#include <system_error>

namespace drape::app {
namespace {

constexpr const char* fabricFileName = "fabrics.toml";

/// The file that a name stands for, so that a link stays a link.
std::filesystem::path behindLinks(const std::filesystem::path& file) {
  std::error_code error;
  const auto target = std::filesystem::canonical(file, error);
  return error ? file : target;
}

}  // namespace

std::filesystem::path usualFabricFile() {
  const std::filesystem::path folder = userFolder("XDG_CONFIG_HOME", ".config");
  return folder.empty() ? folder : folder / fabricFileName;
}

FabricList::FabricList(const std::string& file, Missing missing)
    : file_(file.empty() ? usualFabricFile() : std::filesystem::path(file)) {
  std::error_code error;
  const bool named = !file.empty();
  if (!std::filesystem::exists(file_, error)) {
    if (named && missing == Missing::Refused) {
      throw messages::InputError("there is no list of fabrics '" + file + "'; check the name after --fabrics");
    }
    return;
  }
  try {
    fabrics_ = scene::readFabricFile(file_);
  } catch (const messages::InputError& wrong) {
    if (named) {
      throw;
    }
    problem_ = std::string(wrong.what()) + ". Your own fabrics are not available until you correct this file";
  }
}

void FabricList::add(const settings::OwnFabric& fabric) {
  if (file_.empty()) {
    throw messages::InputError(
        "There is no folder for your own fabrics: neither HOME nor XDG_CONFIG_HOME is set. Start "
        "Drape with --fabrics FILE.");
  }
  saveFabric(file_, fabric);
  fabrics_ = scene::readFabricFile(file_);
  problem_.clear();
}

void saveFabric(const std::filesystem::path& file, const settings::OwnFabric& fabric) {
  settings::requireAllowed(fabric);
  const std::filesystem::path target = behindLinks(file);
  std::error_code error;
  const bool isNew = !std::filesystem::exists(target, error);
  const std::string text =
      scene::withFabricEntry(isNew ? std::string() : scene::readTextFile(target), fabric, file.string());
  if (isNew && target.has_parent_path()) {
    makeFolder(target.parent_path());
  }
  const bool locked = !isNew && ::access(target.c_str(), W_OK) != 0;
  if (locked || !replaceFile(target, text)) {
    throw messages::InputError("cannot save the fabric '" + fabric.name + "' in " + file.string() +
                               ". Check that the file and its folder are writable, or start Drape with --fabrics FILE");
  }
}

}  // namespace drape::app
