#include "app/viewer/preferences.hpp"

#include "app/output_file.hpp"
#include "app/user_folder.hpp"
#include "app/vector_json.hpp"
#include "locale/language.hpp"
#include "messages/error.hpp"
#include "scene/framing.hpp"
#include "scene/text_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <system_error>
#include <utility>

namespace drape::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int maxPixels = 32767;  // of a window and of a desktop, in X11
constexpr int minSide = 320;

int numberFrom(const Json& json, const char* key, int min, int max) {
  const int number = json.at(key).get<int>();
  if (number < min || number > max) {
    throw messages::InputError(std::string(key) + " is out of range");
  }
  return number;
}

WindowPlace placeFrom(const Json& json) {
  return {numberFrom(json, "x", -maxPixels, maxPixels), numberFrom(json, "y", -maxPixels, maxPixels),
          numberFrom(json, "width", minSide, maxPixels), numberFrom(json, "height", minSide, maxPixels)};
}

ui::Theme themeFrom(const std::string& name) {
  for (const ui::ThemeInfo& theme : ui::themes()) {
    if (theme.name == name) {
      return theme.theme;
    }
  }
  throw messages::InputError("there is no theme '" + name + "'");
}

std::string languageFrom(const std::string& name) {
  if (!name.empty() && locale::findLanguage(name) == nullptr) {
    throw messages::InputError("there is no language '" + name + "'");
  }
  return name;
}

Vec3 pointFrom(const Json& json) {
  constexpr double farAway = 1e6;  // [m]
  const Vec3 point = vectorFrom(json);
  if (!(point.cwiseAbs().maxCoeff() <= farAway)) {
    throw messages::InputError("a camera is out of range");
  }
  return point;
}

Json viewJson(const std::optional<scene::CameraPose>& view) {
  if (!view) {
    return nullptr;
  }
  return {{"position", vectorJson(view->position)},
          {"focal_point", vectorJson(view->focalPoint)},
          {"view_angle", view->viewAngle},
          {"orthographic", view->isOrthographic}};
}

std::optional<scene::CameraPose> viewFrom(const Json& json) {
  if (json.is_null()) {
    return std::nullopt;
  }
  scene::CameraPose view;
  view.position = pointFrom(json.at("position"));
  view.focalPoint = pointFrom(json.at("focal_point"));
  view.viewAngle = json.at("view_angle").get<double>();
  view.isOrthographic = json.value("orthographic", false);
  if (!scene::isFarEnough(view) || !(view.viewAngle >= 1.0 && view.viewAngle <= 150.0)) {
    throw messages::InputError("a camera is out of range");
  }
  return view;
}

Json viewsJson(const std::vector<SceneViews>& scenes) {
  Json json = Json::array();
  for (const SceneViews& each : scenes) {
    Json views = Json::array();
    for (const std::optional<scene::CameraPose>& view : each.views) {
      views.push_back(viewJson(view));
    }
    json.push_back({{"scene", each.scene}, {"views", views}});
  }
  return json;
}

std::vector<SceneViews> viewsFrom(const Json& json) {
  std::vector<SceneViews> scenes;
  for (const Json& each : json) {
    SceneViews& scene = scenes.emplace_back();
    scene.scene = each.at("scene").get<std::string>();
    const Json& views = each.at("views");
    for (std::size_t i = 0; i < std::min(scene.views.size(), views.size()); ++i) {
      scene.views[i] = viewFrom(views[i]);
    }
  }
  scenes.resize(std::min(scenes.size(), Preferences::maxScenesWithViews));
  return scenes;
}

}  // namespace

const SceneViews* Preferences::viewsOf(const std::string& scene) const {
  const auto found = std::ranges::find(views, scene, &SceneViews::scene);
  return found == views.end() ? nullptr : &*found;
}

void Preferences::keepView(const std::string& scene, std::size_t place, const scene::CameraPose& view) {
  const SceneViews* before = viewsOf(scene);
  SceneViews changed = before == nullptr ? SceneViews{scene, {}} : *before;
  changed.views[place] = view;
  std::erase_if(views, [&](const SceneViews& each) { return each.scene == scene; });
  views.insert(views.begin(), std::move(changed));
  views.resize(std::min(views.size(), maxScenesWithViews));
}

void Preferences::noteFile(const std::filesystem::path& file) {
  const std::string name = std::filesystem::absolute(file).lexically_normal().string();
  std::erase(recentFiles, name);
  recentFiles.insert(recentFiles.begin(), name);
  if (recentFiles.size() > maxRecentFiles) {
    recentFiles.resize(maxRecentFiles);
  }
}

std::filesystem::path usualPreferencesFile() {
  const std::filesystem::path folder = userFolder("XDG_STATE_HOME", ".local/state");
  return folder.empty() ? folder : folder / "window.json";
}

std::string preferencesText(const Preferences& preferences) {
  Json json = Json::object();
  if (const std::optional<WindowPlace>& place = preferences.window) {
    json["window"] = {{"x", place->x}, {"y", place->y}, {"width", place->width}, {"height", place->height}};
  }
  json["theme"] = ui::themes()[static_cast<std::size_t>(preferences.theme)].name;
  json["language"] = preferences.language;
  json["folder"] = preferences.folder;
  json["recent_files"] = preferences.recentFiles;
  json["sections"] = preferences.sections;
  json["views"] = viewsJson(preferences.views);
  return jsonText(json, 2) + '\n';
}

Preferences preferencesFrom(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    Preferences preferences;
    if (json.contains("window")) {
      preferences.window = placeFrom(json.at("window"));
    }
    preferences.theme = themeFrom(json.value("theme", std::string(ui::themes().front().name)));
    preferences.language = languageFrom(json.value("language", std::string()));
    preferences.folder = json.value("folder", std::string());
    preferences.recentFiles = json.value("recent_files", std::vector<std::string>());
    preferences.recentFiles.resize(std::min(preferences.recentFiles.size(), Preferences::maxRecentFiles));
    preferences.sections = json.value("sections", std::map<std::string, bool>());
    preferences.views = viewsFrom(json.value("views", Json::array()));
    return preferences;
  } catch (const Json::exception& error) {
    throw messages::InputError(error.what());
  }
}

PreferencesFile::PreferencesFile(std::filesystem::path file) : file_(std::move(file)) {
  std::error_code error;
  if (file_.empty() || !std::filesystem::exists(file_, error)) {
    return;
  }
  try {
    values_ = preferencesFrom(scene::readTextFile(file_));
  } catch (const messages::InputError& wrong) {
    problem_ = "The preferences in " + file_.string() + " are damaged and ignored: " + wrong.what();
  }
}

std::string PreferencesFile::keep(const Preferences& preferences) {
  if (file_.empty() || preferences == values_) {
    return {};
  }
  values_ = preferences;
  std::string reason;
  try {
    makeFolder(file_.parent_path());
  } catch (const messages::InputError& error) {
    reason = error.what();
  }
  if (reason.empty() && replaceFile(file_, preferencesText(preferences))) {
    return {};
  }
  return std::exchange(failed_, true)
             ? std::string()
             : "The preferences cannot be written to " + file_.string() + (reason.empty() ? "" : ": " + reason);
}

}  // namespace drape::app
