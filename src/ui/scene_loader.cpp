#include "ui/scene_loader.hpp"

#include "messages/sim_error_text.hpp"
#include "session/take_if_ready.hpp"
#include "ui/names_in_words.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <thread>
#include <utility>

namespace drape::ui {
namespace {

text::Sentence reasonOf(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::bad_alloc&) {
    return text::Sentence("Not enough memory. Use a smaller mesh or a coarser grid.");
  } catch (const std::exception& error) {
    return messages::sentenceOf(error);
  }
}

}  // namespace

SceneLoader::~SceneLoader() {
  stop_.request_stop();
}

text::Sentence SceneLoader::activity() const {
  const int percent = percent_;
  if (activity_.empty()) {
    return {};
  }
  return percent > 0 && !waiting_ ? text::Sentence("{}: {} %", activity_, percent)
                                  : text::Sentence("{} \u2026", activity_);
}

void SceneLoader::open(const scene::SceneParts& parts, std::function<void(settings::Settings&)> adjust,
                       const settings::OwnFabrics& own) {
  submit({.activity = text::Sentence("Opening '{}'", inWords(parts)),
          .build =
              [parts, own, adjust = std::move(adjust)](const io::ImportWatch& watch) {
                const scene::SceneDescription description = scene::openParts(parts, own);
                settings::Settings settings = description.settings;
                adjust(settings);
                return scene::buildScene(description, settings, watch);
              },
          .kind = Kind::Opened});
}

void SceneLoader::rebuild(const scene::SceneDescription& description, const settings::Settings& settings, Kind kind) {
  submit({.activity = text::Sentence("Building '{}'", inWords(description)),
          .build = [description,
                    settings](const io::ImportWatch& watch) { return scene::buildScene(description, settings, watch); },
          .kind = kind});
}

bool SceneLoader::cancel() {
  const bool any = !activity_.empty();
  activity_ = {};
  waiting_.reset();
  cancelled_ = running_.valid();
  stop_.request_stop();
  return any;
}

void SceneLoader::submit(Job job) {
  if (running_.valid()) {
    activity_ = job.activity;
    waiting_ = std::move(job);
    stop_.request_stop();
  } else {
    start(std::move(job));
  }
}

void SceneLoader::start(Job job) {
  activity_ = job.activity;
  cancelled_ = false;
  percent_ = 0;
  stop_ = std::stop_source();
  constexpr double whole = 100.0;
  const io::ImportWatch watch{
      [this](double share, std::string_view) { percent_ = static_cast<int>(std::lround(whole * share)); },
      stop_.get_token()};
  running_ = std::async(std::launch::async, [job = std::move(job), watch]() -> Outcome {
    try {
      return {.scene = job.build(watch), .error = {}, .kind = job.kind};
    } catch (...) {
      return {.scene = nullptr, .error = reasonOf(std::current_exception()), .kind = job.kind};
    }
  });
}

std::optional<SceneLoader::Outcome> SceneLoader::poll() {
  std::optional<Outcome> outcome = session::takeIfReady(running_);
  if (!outcome) {
    return std::nullopt;
  }
  if (std::exchange(cancelled_, false)) {
    outcome.reset();
  }
  activity_ = {};
  if (waiting_) {
    // A newer request replaces this result.
    outcome.reset();
    start(*std::exchange(waiting_, std::nullopt));
  }
  return outcome;
}

void useWindowDefaults(settings::Settings& settings) {
  double& limit = settings.step.automatic.strainLimit;
  limit = limit > 0.0 ? limit : visibleStrain;
  constexpr double usualMemory = 200.0;  // [1e6 bytes]
  double& memory = settings.timeline.memory;
  memory = memory > 0.0 ? memory : usualMemory;
  constexpr int maxThreads = 64;  // of the setting
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  int& threads = settings.step.threads;
  threads = std::clamp(cores - 1, threads, maxThreads);  // one core draws
  constexpr int coresForErrorCheck = 4;
  settings.measures.errorCheck = settings.measures.errorCheck || cores >= coresForErrorCheck;
}

void carryViewSettings(const settings::Settings& current, const settings::Settings& own, settings::Settings& target) {
  for (const settings::SettingInfo* info : settings::differingSettings(current, own)) {
    if (info->group == settings::SettingGroup::View) {
      settings::assignSetting(target, *info, settings::settingValue(current, *info));
    }
  }
  // A setting that also sets another one must not change what the user chose there.
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    if (info.group == settings::SettingGroup::View && !info.alsoKey.empty()) {
      const settings::SettingInfo& other = settings::requireSetting(info.alsoKey);
      settings::assignSetting(target, other, settings::settingValue(current, other));
    }
  }
}

}  // namespace drape::ui
