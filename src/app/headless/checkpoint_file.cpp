#include "app/headless/checkpoint_file.hpp"

#include "messages/error.hpp"
#include "session/checkpoint.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace drape::app {
namespace {

std::string wholeFile(const std::string& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) {
    throw messages::InputError(std::string("it cannot be read (") + std::strerror(errno != 0 ? errno : EIO) +
                               "). Check the path.");
  }
  return bytes;
}

}  // namespace

CheckpointFile::CheckpointFile(const std::string& file, const session::Simulation& simulation) : file_(file) {
  (void)session::checkpointOf(simulation);
}

void CheckpointFile::write(const session::Simulation& simulation) {
  file_.write(session::checkpointOf(simulation));
  file_.commit();
}

std::vector<std::string> resumeFrom(const std::string& file, session::Simulation& simulation) {
  try {
    return session::continueFrom(wholeFile(file), simulation);
  } catch (const messages::InputError& error) {
    throw messages::InputError(file + ": " + error.what());
  }
}

}  // namespace drape::app
