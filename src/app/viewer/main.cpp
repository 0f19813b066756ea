#include "app/command_line.hpp"
#include "app/viewer/viewer.hpp"
#include "locale/language.hpp"
#include "messages/error.hpp"
#include "ui/scene_loader.hpp"

#include <charconv>
#include <cstdlib>
#include <string>
#include <utility>

namespace drape::app {
namespace {

int sideOf(std::string_view text) {
  constexpr int smallest = 320;
  constexpr int largest = 16384;
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < smallest || value > largest) {
    throw messages::UsageError("--window-size needs width,height between 320 and 16384, for example 1280,720");
  }
  return value;
}

std::pair<int, int> parseWindowSize(const std::string& text) {
  const std::string_view all = text;
  const std::size_t comma = all.find(',');
  return {sideOf(all.substr(0, comma)), sideOf(comma == std::string_view::npos ? "" : all.substr(comma + 1))};
}

/// The first of these variables of the environment that is set counts, as in other programs.
std::string localeOfEnvironment() {
  for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
    if (const char* value = std::getenv(variable); value != nullptr && *value != '\0') {
      return value;
    }
  }
  return {};
}

}  // namespace
}  // namespace drape::app

int main(int argc, char** argv) {
  CLI::App app("Cloth that you can pull, in a window. F1 in the window lists keys and mouse actions.", "drape");
  drape::app::SceneArguments scene;
  scene.adjust = drape::ui::useWindowDefaults;
  scene.addTo(app);
  drape::app::ViewerOptions options;
  std::string windowSize;
  std::string language;
  app.add_flag("--paused", options.paused, "Start paused");
  app.add_option("--window-size", windowSize, "Size of the window")
      ->type_name("WIDTH,HEIGHT")
      ->check(drape::app::notEmpty());
  app.add_option("--status", options.statusFile, "Write the viewer's state to this file, for scripts (see below)")
      ->type_name("FILE")
      ->check(drape::app::notEmpty());
  app.add_option("--record", options.recordFile,
                 "Write the session to this file at the end, for 'drape-headless run --replay'")
      ->type_name("FILE")
      ->check(drape::app::notEmpty());
  app.add_option("--language", language,
                 "Language of the window: en, de, or a catalogue file of your own; at first that of the system")
      ->type_name("NAME|FILE")
      ->check(drape::app::notEmpty());
  bool noSettings = false;
  app.add_flag(
      "--no-settings", noSettings,
      "Neither read nor write the preferences of the window: its size and place, theme, language, sections and "
      "recent files");
  auto* dress = app.add_subcommand("dress", "Opens the window with a garment on a body, without intersections");
  drape::app::DressingChoices dressing;
  dressing.addTo(*dress);
  dress->fallthrough();  // the options of the window may follow
  app.footer(drape::app::StatusFile::help);
  return drape::app::runProgram(app, argc, argv, [&] {
    if (!windowSize.empty()) {
      options.windowSize = drape::app::parseWindowSize(windowSize);
    }
    if (!language.empty()) {
      options.language = drape::locale::openLanguage(language);
    }
    options.usualLanguage = drape::locale::languageOfLocale(drape::app::localeOfEnvironment());
    // The first save creates a list that does not exist yet.
    auto fabrics = drape::app::readFabricList(scene.fabrics, drape::app::FabricList::Missing::Allowed);
    if (dress->parsed()) {
      options.dressing = dressing;
    }
    const auto loaded = options.dressing ? dressing.open(scene, fabrics.fabrics()) : scene.load(fabrics.fabrics());
    drape::app::PreferencesFile preferences(noSettings ? std::filesystem::path() : drape::app::usualPreferencesFile());
    drape::app::Viewer viewer(loaded, std::move(fabrics), std::move(preferences), options);
    viewer.run();
  });
}
