#include "app/user_folder.hpp"

#include <cstdlib>

namespace drape::app {
namespace {

std::string valueOf(const char* variable) {
  const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nothing changes the environment
  return value == nullptr ? "" : value;
}

}  // namespace

std::filesystem::path userFolder(const char* variable, const std::string& usual) {
  // The specification ignores relative paths.
  if (const std::filesystem::path folder = valueOf(variable); folder.is_absolute()) {
    return folder / "drape";
  }
  const std::filesystem::path home = valueOf("HOME");
  return home.is_absolute() ? home / usual / "drape" : std::filesystem::path();
}

}  // namespace drape::app
