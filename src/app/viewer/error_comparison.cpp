#include "app/viewer/error_comparison.hpp"

#include "messages/error.hpp"
#include "messages/sim_error_text.hpp"
#include "report/error_sources.hpp"
#include "session/take_if_ready.hpp"

#include <exception>
#include <new>
#include <utility>

namespace drape::app {
namespace {

struct Cancelled {};

}  // namespace

ErrorComparison::ErrorComparison(std::shared_ptr<const scene::Scene> scene, settings::Settings settings)
    : scene_(std::move(scene)), settings_(std::move(settings)) {
  running_ = std::async(std::launch::async, [this] { return run(); });
}

ErrorComparison::~ErrorComparison() {
  cancel();
}

std::optional<ErrorComparison::Outcome> ErrorComparison::poll() {
  return session::takeIfReady(running_);
}

ErrorComparison::Outcome ErrorComparison::run() {
  try {
    return {report::measureErrorSources(scene_->description, settings_, {},
                                        [this](double share) {
                                          if (stop_.stop_requested()) {
                                            throw Cancelled();
                                          }
                                          share_ = share;
                                        }),
            {}};
  } catch (const Cancelled&) {
    return {};
  } catch (const std::bad_alloc&) {
    return {{}, text::Sentence("Not enough memory to compare the sources of error. Use a smaller mesh.")};
  } catch (const std::exception& error) {
    return {{}, messages::sentenceOf(error)};
  }
}

}  // namespace drape::app
