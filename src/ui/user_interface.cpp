#include "ui/user_interface.hpp"

#include "sim/model/fingerprint.hpp"
#include "ui/command_palette.hpp"
#include "ui/panels.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <imgui_internal.h>  // for closing a drop-down list from outside

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

namespace drape::ui {
namespace {

constexpr float columnWidth = 372.0F;  // at scale 1
constexpr float statusHeight = 30.0F;  // at scale 1
constexpr float columnShare = 0.55F;   // maximum share of a small window

constexpr ImGuiWindowFlags columnFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar |
                                         ImGuiWindowFlags_NoScrollWithMouse;

}  // namespace

struct UserInterface::Parts {
  ImGuiContext* context = nullptr;
  Backend backend = Backend::None;
  UiDisplay display;
  UiFonts fonts;
  Theme theme = Theme::Dark;
  locale::Language language = locale::languages().front();
  CommandPalette search;
  bool searches = false;  ///< whether the search was open at the start of the last frame
  PanelMemory memory;
  UiRects widgets;
  UiRects buttons;
  UiRects labels;
  bool panels = true;
  bool notices = true;
  bool help = false;
  bool asksToQuit = false;
  bool quittingLosesChanges = false;    ///< of the scene, as of the question
  std::string replaced;                 ///< the scene file that the user may want to replace; empty: no question
  std::optional<DroppedFiles> dropped;  ///< the user must choose the cloth among these
  DropChoices dropChoices;              ///< the answers so far
  Wording closedError;                  ///< the error that the user closed
  Wording shownError;
  int failures = 0;  ///< as of the last frame

  void makeFonts();
  void remember(const session::Snapshot& snapshot, const UiStats& stats);
  void column(PanelContext& panel, const UiRect& place);
  void overlays(PanelContext& panel, const UiRect& view);
  void dialog(PanelContext& panel, const UiRect& view);
  [[nodiscard]] float width() const {
    return std::round(std::min(columnWidth * display.scale, columnShare * static_cast<float>(display.width)));
  }
  [[nodiscard]] float bottom() const { return std::round(statusHeight * display.scale); }
};

void UserInterface::Parts::makeFonts() {
  ImGuiIO& io = ImGui::GetIO();
  applyTheme(ImGui::GetStyle(), theme, display.scale);
  fonts = buildFonts(*io.Fonts, display.scale, display.density);
  io.FontDefault = fonts.regular;
  io.FontGlobalScale = 1.0F / display.density;
  if (backend == Backend::OpenGl) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  } else {
    io.Fonts->SetTexID(context);  // any value except null, so that ImGui's checks of its texture stack work
  }
}

void UserInterface::Parts::remember(const session::Snapshot& snapshot, const UiStats& stats) {
  // A pending change of the mesh is not refused as long as the scene is built or the user still drags.
  const bool waiting = !stats.loading.empty() || ImGui::IsAnyItemActive();
  memory.pending.update(snapshot.settings, ImGui::GetTime(), waiting);
  if (snapshot.step != memory.lastStep && snapshot.stepSeconds > 0.0) {
    memory.stepTimes.add(static_cast<float>(snapshot.stepSeconds * 1e3));
  }
  memory.lastStep = snapshot.step;
  memory.measures.add(snapshot);
  if (stats.fields != nullptr) {
    memory.picked.follow(snapshot, *stats.fields);
  }
  memory.hasDragged = memory.hasDragged || snapshot.attachment.has_value();
  if (!memory.hoveredThisFrame) {
    memory.hoveredRow.clear();
  }
  memory.hoveredThisFrame = false;
  if (stats.error.empty() || stats.failures != failures) {
    closedError = {};
  }
  failures = stats.failures;
  shownError = stats.error == closedError ? Wording() : stats.error;
}

void UserInterface::Parts::column(PanelContext& panel, const UiRect& place) {
  ImGui::SetNextWindowPos({static_cast<float>(place.x), static_cast<float>(place.y)});
  ImGui::SetNextWindowSize({static_cast<float>(place.width), static_cast<float>(place.height)});
  ImGui::Begin("Panels", nullptr, columnFlags);
  headPanel(panel);
  ImGui::Dummy({0.0F, 2.0F * display.scale});
  ImGui::BeginChild("Sections", {0.0F, 0.0F}, false, ImGuiWindowFlags_NoSavedSettings);
  drawSections(panel);
  memory.openSections.reset();
  ImGui::EndChild();
  ImGui::End();
}

void UserInterface::Parts::overlays(PanelContext& panel, const UiRect& view) {
  colourLegend(panel, view, panels ? timelineBar(panel, view) : 0.0F);
  if (!notices) {
    return;
  }
  // Permanent boxes come first, so that a new message does not move a button before a click.
  OverlayStack stack(panel, view);
  readingNotice(panel, stack);
  if (!shownError.empty() && !errorNotice(panel, stack)) {
    closedError = shownError;
    shownError = {};
  }
  if (!panel.stats.loading.empty()) {
    loadingNotice(panel, stack);
  }
  if (panel.stats.dressing) {
    dressingNotice(panel, stack);
  }
  if (panel.stats.exporting) {
    exportNotice(panel, stack);
  }
  if (!memory.hasDragged && memory.picked.vertices().empty() && !panel.stats.placing && !panel.stats.sewing &&
      panel.stats.selection.mode == SelectionMode::Off) {
    dragHint(panel, stack);
  }
  pickedPanel(panel, view);
  selectionBox(panel, view);
  placingBox(panel, view);
  sewingBox(panel, view);
  dialog(panel, view);
}

/// One at a time: they share their place and their keys. closeOverlay() has the same order.
void UserInterface::Parts::dialog(PanelContext& panel, const UiRect& view) {
  if (asksToQuit) {
    asksToQuit = quitQuestion(panel, view, quittingLosesChanges);
  } else if (!replaced.empty()) {
    if (!replaceQuestion(panel, view, replaced)) {
      replaced.clear();
    }
  } else if (dropped) {
    if (!dropQuestion(panel, view, *dropped, dropChoices)) {
      dropped.reset();
    }
  } else if (search.isOpen()) {
    search.draw(panel, view);
    panels = panels || memory.revealed.isPending;
  } else if (help) {
    help = helpOverlay(panel, view);
  }
}

UserInterface::UserInterface(const UiDisplay& display, Backend backend) : parts_(std::make_unique<Parts>()) {
  IMGUI_CHECKVERSION();
  parts_->context = ImGui::CreateContext();
  ImGui::SetCurrentContext(parts_->context);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.DeltaTime = 1.0F / 60.0F;
  parts_->memory.scenes = scene::sceneList();
  parts_->display = display;
  parts_->backend = backend;
  if (backend == Backend::OpenGl) {
    ImGui_ImplOpenGL3_Init("#version 330 core");
  }
  parts_->makeFonts();
  setDisplay(display);
}

UserInterface::~UserInterface() {
  ImGui::SetCurrentContext(parts_->context);
  if (parts_->backend == Backend::OpenGl) {
    ImGui_ImplOpenGL3_Shutdown();
  }
  ImGui::DestroyContext(parts_->context);
}

void UserInterface::setDisplay(const UiDisplay& display) {
  ImGui::SetCurrentContext(parts_->context);
  const UiDisplay old = parts_->display;
  parts_->display = display;
  const bool resized = display.scale != old.scale || display.density != old.density;
  if (resized && ImGui::IsAnyItemActive()) {
    parts_->display.scale = old.scale;
    parts_->display.density = old.density;
  } else if (resized) {
    parts_->makeFonts();
  }
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(display.width), static_cast<float>(display.height)};
  io.DisplayFramebufferScale = {display.density, display.density};
}

void UserInterface::build(const session::Snapshot& snapshot, const UiStats& stats, UiOutput& output) {
  Parts& parts = *parts_;
  ImGui::SetCurrentContext(parts.context);
  if (parts.backend == Backend::OpenGl) {
    ImGui_ImplOpenGL3_NewFrame();
  }
  ImGui::NewFrame();
  if (parts.panels || parts.notices) {  // the legend alone may belong to another simulation
    parts.remember(snapshot, stats);
  }
  parts.searches = parts.search.isOpen();
  if (parts.searches) {
    parts.memory.hoveredSince = ImGui::GetTime();  // an explanation would cover the search
  }
  parts.widgets.clear();
  parts.buttons.clear();
  parts.labels.clear();
  const settings::Settings settings = parts.memory.pending.overlay(snapshot.settings);
  PanelContext panel{.snapshot = snapshot,
                     .settings = settings,
                     .sceneSettings = snapshot.scene->description.settings,
                     .stats = stats,
                     .fonts = parts.fonts,
                     .texts = parts.language.texts,
                     .language = parts.language.name,
                     .scale = parts.display.scale,
                     .theme = parts.theme,
                     .memory = parts.memory,
                     .widgets = parts.widgets,
                     .buttons = parts.buttons,
                     .labels = parts.labels,
                     .output = output};
  UiRect uncovered = view();
  if (parts.panels) {
    const double below = static_cast<double>(parts.display.height) - parts.bottom();
    const double extra = statusLine(panel, {0.0, below, static_cast<double>(parts.display.width), parts.bottom()});
    // A long message takes lines above the status line; they must not cover the panel's last rows or the timeline.
    parts.column(panel, {0.0, 0.0, parts.width(), below - extra});
    uncovered.height = std::max(1.0, uncovered.height - extra);
  }
  parts.overlays(panel, uncovered);
  ImGui::Render();
}

void UserInterface::renderDrawData() {
  ImGui::SetCurrentContext(parts_->context);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

std::uint64_t UserInterface::fingerprint() const {
  ImGui::SetCurrentContext(parts_->context);
  const ImDrawData& data = *ImGui::GetDrawData();
  sim::Fingerprint all;
  const auto add = [&all](const auto& values) {
    // Word by word; the few bytes of an incomplete last word are part of it.
    const char* bytes = reinterpret_cast<const char*>(values.Data);  // NOLINT: the bytes of plain data
    for (std::size_t left = values.size_in_bytes(); left > 0;) {
      std::uint64_t word = 0;
      const std::size_t length = std::min(left, sizeof(word));
      std::memcpy(&word, bytes, length);
      all.add(word);
      bytes += length;
      left -= length;
    }
  };
  for (int i = 0; i < data.CmdListsCount; ++i) {
    add(data.CmdLists[i]->VtxBuffer);
    for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer) {
      all.add(command.ClipRect.x);
      all.add(command.ClipRect.y);
      all.add(command.ClipRect.z);
      all.add(command.ClipRect.w);
    }
  }
  return all.value();
}

void UserInterface::drawLegend(const session::Snapshot& snapshot, const UiStats& stats, int width, int height) {
  const UiDisplay window = parts_->display;
  const bool panels = std::exchange(parts_->panels, false);
  const bool notices = std::exchange(parts_->notices, false);
  UiDisplay picture = window;
  picture.width = width;
  picture.height = height;
  setDisplay(picture);
  UiOutput ignored;
  build(snapshot, stats, ignored);
  renderDrawData();
  parts_->panels = panels;
  parts_->notices = notices;
  setDisplay(window);
}

UiRect UserInterface::view() const {
  const UiDisplay& display = parts_->display;
  if (!parts_->panels) {
    return {0.0, 0.0, static_cast<double>(display.width), static_cast<double>(display.height)};
  }
  const double left = parts_->width();
  return {left, 0.0, std::max(1.0, display.width - left),
          std::max(1.0, display.height - static_cast<double>(parts_->bottom()))};
}

bool UserInterface::covers(const Vec2& point) const {
  if (!view().contains(point)) {
    return parts_->panels;
  }
  for (const auto& [name, rect] : parts_->buttons) {
    if (name.starts_with("overlay.") && rect.contains(point)) {
      return true;
    }
  }
  // A drop-down list or an active slider may extend over the picture.
  ImGui::SetCurrentContext(parts_->context);
  return ImGui::IsAnyItemActive() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

bool UserInterface::takesText() const {
  ImGui::SetCurrentContext(parts_->context);
  return ImGui::GetIO().WantTextInput || parts_->searches;
}

bool UserInterface::panelsVisible() const {
  return parts_->panels;
}

void UserInterface::showPanels(bool visible) {
  parts_->panels = visible;
}

bool UserInterface::pick(int vertex) {
  return parts_->memory.picked.toggle(vertex);
}

const PickedVertices& UserInterface::picked() const {
  return parts_->memory.picked;
}

void UserInterface::showNotices(bool visible) {
  parts_->notices = visible;
}

bool UserInterface::helpVisible() const {
  return parts_->help;
}

void UserInterface::showHelp(bool visible) {
  parts_->help = visible;
}

bool UserInterface::closeOverlay() {
  ImGui::SetCurrentContext(parts_->context);
  if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) {
    ImGui::ClosePopupToLevel(0, true);
    return true;
  }
  if (std::exchange(parts_->asksToQuit, false)) {
    return true;
  }
  if (!std::exchange(parts_->replaced, {}).empty()) {
    return true;
  }
  if (parts_->dropped) {
    parts_->dropped.reset();
    return true;
  }
  if (parts_->search.isOpen()) {
    parts_->search.close();
    return true;
  }
  if (std::exchange(parts_->help, false)) {
    return true;
  }
  if (!parts_->shownError.empty()) {
    parts_->closedError = parts_->shownError;
    parts_->shownError = {};
    return true;
  }
  if (!parts_->memory.picked.vertices().empty()) {
    parts_->memory.picked.clear();
    return true;
  }
  return false;
}

void UserInterface::askWhichIsTheCloth(const DroppedFiles& files) {
  parts_->dropChoices = firstChoices(files);
  parts_->dropped = files;
}

bool UserInterface::asksWhichIsTheCloth() const {
  return parts_->dropped.has_value();
}

void UserInterface::askToQuit(bool hasChanges) {
  parts_->asksToQuit = true;
  parts_->quittingLosesChanges = hasChanges;
}

void UserInterface::askToReplace(const std::string& file) {
  parts_->replaced = file;
}

void UserInterface::toggleSearch(const std::vector<std::string>& recentFiles) {
  if (parts_->search.isOpen()) {
    parts_->search.close();
  } else {
    parts_->search.open(searchEntries(parts_->memory.scenes, recentFiles, parts_->language.texts));
  }
}

void UserInterface::showOpenField() {
  parts_->panels = true;
  parts_->memory.revealed = {"scene.path", 0.0, true};
}

void UserInterface::showExport() {
  parts_->panels = true;
  parts_->memory.revealed = {std::string(exportSection), 0.0, true};
}

void UserInterface::useTheme(Theme theme) {
  ImGui::SetCurrentContext(parts_->context);
  parts_->theme = theme;
  applyTheme(ImGui::GetStyle(), theme, parts_->display.scale);
}

Theme UserInterface::theme() const {
  return parts_->theme;
}

void UserInterface::useLanguage(const locale::Language& language) {
  parts_->language = language;
  parts_->search.close();  // its entries are in the language before
}

const locale::Language& UserInterface::language() const {
  return parts_->language;
}

const std::map<std::string, bool>& UserInterface::sections() const {
  return parts_->memory.sections;
}

void UserInterface::restoreSections(const std::map<std::string, bool>& sections) {
  parts_->memory.sections = sections;
}

settings::Settings UserInterface::settingsInForce(const session::Snapshot& snapshot) const {
  return parts_->memory.pending.overlay(snapshot.settings);
}

bool UserInterface::isBusy() const {
  ImGui::SetCurrentContext(parts_->context);
  return ImGui::IsAnyItemActive() || !parts_->memory.pending.empty();
}

void UserInterface::forgetQuestions() {
  parts_->asksToQuit = false;
  parts_->replaced.clear();
  parts_->dropped.reset();
}

const std::string& UserInterface::status() const {
  return parts_->memory.status;
}

void UserInterface::openSections(bool open) {
  parts_->memory.openSections = open;
}

const UiRects& UserInterface::widgets() const {
  return parts_->widgets;
}

const UiRects& UserInterface::buttons() const {
  return parts_->buttons;
}

const UiRects& UserInterface::labels() const {
  return parts_->labels;
}

render::Camera besidePanels(const render::Camera& camera, const UiRect& view, int width, int height) {
  const double right = view.x + (view.width - width) / 2.0;
  const double down = view.y + (view.height - height) / 2.0;
  render::Camera moved = camera;
  moved.pan(-right / height, down / height);
  return moved;
}

float uiScale(double fontScaleSetting, float contentScale, int monitorRows) {
  if (fontScaleSetting > 0.0) {
    return static_cast<float>(std::clamp(fontScaleSetting, 0.5, 4.0));
  }
  constexpr int manyRows = 1600;
  const float fromRows = monitorRows >= manyRows ? static_cast<float>(monitorRows) / 1080.0F : 1.0F;
  return std::clamp(std::max(contentScale, fromRows), 1.0F, 4.0F);
}

}  // namespace drape::ui
