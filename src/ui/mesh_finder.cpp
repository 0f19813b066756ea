#include "ui/mesh_finder.hpp"

#include "messages/sim_error_text.hpp"
#include "session/take_if_ready.hpp"

#include <exception>
#include <new>
#include <optional>
#include <utility>

namespace drape::ui {
namespace {

FoundFile readToFind(const std::string& file, const std::stop_token& stop) {
  FoundFile result{file, std::nullopt, {}};
  try {
    io::ImportWatch watch;
    watch.stop = stop;
    result.mesh = scene::findMesh(file, watch);
  } catch (const std::bad_alloc&) {
    result.problem = text::Sentence("Not enough memory. Use a smaller mesh or a coarser grid.");
  } catch (const std::exception& error) {
    result.problem = messages::sentenceOf(error);
  }
  return result;
}

}  // namespace

MeshFinder::~MeshFinder() {
  stop_.request_stop();
}

void MeshFinder::find(const std::vector<std::string>& files) {
  forget();
  for (const std::string& file : files) {
    found_.push_back({file, std::nullopt, {}});
  }
  follow();
}

void MeshFinder::forget() {
  found_.clear();
  next_ = 0;
  isCancelled_ = running_.valid();
  stop_.request_stop();
}

void MeshFinder::follow() {
  if (running_.valid()) {
    std::optional<FoundFile> result = session::takeIfReady(running_);
    if (!result) {
      return;
    }
    if (!std::exchange(isCancelled_, false)) {
      found_[next_++] = *std::move(result);
    }
  }
  if (next_ < found_.size()) {
    stop_ = std::stop_source();
    running_ = std::async(std::launch::async, readToFind, found_[next_].file, stop_.get_token());
  }
}

}  // namespace drape::ui
