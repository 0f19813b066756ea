#include "panel_fixture.hpp"

#include <imgui.h>

#include <iterator>
#include <utility>

namespace drape::ui {
namespace {

std::shared_ptr<const scene::Scene> builtScene(const char* name) {
  const scene::SceneDescription description = scene::openScene(name);
  return scene::buildScene(description, description.settings);
}

}  // namespace

void append(UiOutput& all, UiOutput more) {
  std::move(more.commands.begin(), more.commands.end(), std::back_inserter(all.commands));
  std::move(more.requests.begin(), more.requests.end(), std::back_inserter(all.requests));
  if (!more.hint.empty()) {
    all.hint = more.hint;
  }
}

settings::SettingValue lastValue(const UiOutput& output, const std::string& key) {
  for (auto command = output.commands.rbegin(); command != output.commands.rend(); ++command) {
    const auto* set = std::get_if<session::SetSettingCommand>(&*command);
    if (set != nullptr && set->key == key) {
      return set->value;
    }
  }
  ADD_FAILURE() << "no command sets " << key;
  return {};
}

// The window is tall enough for all sections, so that no test must scroll.
PanelFixture::PanelFixture(const char* scene)
    : simulation_(builtScene(scene)),
      panels_({.width = 1280, .height = 4000, .density = 1.0F, .scale = 1.0F}, UserInterface::Backend::None) {
  simulation_.apply(session::PauseCommand{true});
  panels_.openSections(true);
  settle();
}

UiOutput PanelFixture::frame() {
  simulation_.capture(snapshot_);
  UiOutput output;
  panels_.build(snapshot_, stats_, output);
  return output;
}

void PanelFixture::settle() {
  for (int i = 0; i < 3; ++i) {
    frame();
  }
}

void PanelFixture::apply(const UiOutput& output) {
  for (const session::Command& command : output.commands) {
    simulation_.apply(command);
  }
}

void PanelFixture::moveTo(const UiRect& rect, double across) {
  ImGui::GetIO().MousePos = {static_cast<float>(rect.x + across * rect.width),
                             static_cast<float>(rect.y + 0.5 * rect.height)};
}

UiOutput PanelFixture::click(const UiRect& place, double across, int button) {
  const UiRect rect = place;  // the frames below change the object of the reference
  moveTo(rect, across);
  settle();
  ImGui::GetIO().MouseDown[button] = true;
  UiOutput all = frame();
  ImGui::GetIO().MouseDown[button] = false;
  append(all, frame());
  return all;
}

UiOutput PanelFixture::drag(const UiRect& place, double from, double to) {
  const UiRect rect = place;
  moveTo(rect, from);
  settle();
  ImGui::GetIO().MouseDown[0] = true;
  UiOutput all = frame();
  moveTo(rect, to);
  append(all, frame());
  ImGui::GetIO().MouseDown[0] = false;
  append(all, frame());
  append(all, frame());
  return all;
}

UiOutput PanelFixture::typeInto(const UiRect& rect, const std::string& text) {
  ImGuiIO& io = ImGui::GetIO();
  constexpr int enter = 1;
  io.KeyMap[ImGuiKey_Enter] = enter;
  io.KeyCtrl = true;
  io.KeyMods = ImGuiKeyModFlags_Ctrl;
  UiOutput all = click(rect);
  io.KeyCtrl = false;
  io.KeyMods = ImGuiKeyModFlags_None;
  append(all, frame());
  append(all, frame());
  io.AddInputCharactersUTF8(text.c_str());
  append(all, frame());
  io.KeysDown[enter] = true;
  append(all, frame());
  io.KeysDown[enter] = false;
  append(all, frame());
  return all;
}

}  // namespace drape::ui
