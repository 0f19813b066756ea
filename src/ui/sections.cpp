#include "session/ghost.hpp"
#include "session/solver_warning.hpp"
#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/solver_facts.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace drape::ui {
namespace {

void airRows(PanelContext& context) {
  windDial(context);
  const sim::AirParameters& air = context.settings.step.air;
  if (air.wind.norm() > 0.0 && !air.acts()) {
    mutedText(context.texts("Wind has no effect while drag and lift are zero."), palette().warning);
  }
}

/// Why the colour map shows nothing.
void colourMapProblem(PanelContext& context) {
  const fields::ShownField* shown = context.stats.field;
  if (shown != nullptr) {
    steadyText(context, "colour_map.problem", context.texts(shown->problem), palette().warning);
  }
}

void viewButtons(PanelContext& context) {
  themeRow(context);
  languageRow(context);
  colourMapProblem(context);
  struct ViewButton {
    const char* name;
    const char* word;
    UiAction action;
    const char* help;
  };
  static constexpr std::array<ViewButton, 4> buttons{{
      {"frame", "camera|Frame", UiAction::FrameCloth, "Moves the camera so that the cloth fills the view (F)."},
      {"front", "Front", UiAction::ViewFront, "Looks from the front (1)."},
      {"right", "Right", UiAction::ViewRight, "Looks from the right (3)."},
      {"top", "Top", UiAction::ViewTop, "Looks from above (7)."},
  }};
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 3.0F * gap) / 4.0F;
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    if (i > 0) {
      ImGui::SameLine();
    }
    if (iconButton(context, buttons[i].name, Icon::None, buttons[i].word, width)) {
      context.output.requests.emplace_back(buttons[i].action);
    }
    explainItem(context, buttons[i].name, buttons[i].help);
  }
  cameraRows(context);
}

void ghostRows(PanelContext& context) {
  const sim::SolverInfo* solver = sim::findSolver(context.settings.ghost.solver);
  if (solver == nullptr) {
    mutedText(context.texts("A second cloth, in green, moved by another solver. Choose a solver to compare."));
    return;
  }
  if (const std::optional<session::GhostStatus>& ghost = context.snapshot.ghost) {
    valueRow(context, "Mean distance", text::formatQuantity(ghost->meanDistance * 1e3, "mm"), palette().ghost);
    valueRow(context, "Step", text::formatDuration(ghost->stepSeconds));
    solverRows(context, *solver, session::ghostParameters(context.settings), ghost->stepReport);
  }
  solverHelp(context, *solver);
  steadyText(context, "ghost.warning", context.texts(session::ghostWarning(context.settings, *context.snapshot.model)),
             palette().warning);
}

void advancedRows(PanelContext& context) {
  valueRow(context, "Steps per second", text::formatNumber(1.0 / context.settings.step.timeStep));
  if (const sim::SolverInfo* solver = sim::findSolver(context.settings.solver.name)) {
    solverRows(context, *solver, context.settings.step, context.snapshot.stepReport);
    solverHelp(context, *solver);
  }
  steadyText(context, "solver.warning",
             context.texts(session::solverWarning(context.settings, *context.snapshot.model)), palette().warning);
}

bool startsOpen(const PanelContext& /*context*/) {
  return true;
}

bool startsClosed(const PanelContext& /*context*/) {
  return false;
}

bool showsGhost(const PanelContext& context) {
  return context.settings.ghost.solver != "off";
}

/// A section of the column: a group of settings, with rows above and below them.
struct Section {
  std::string_view title;
  bool (*isOpenAtFirst)(const PanelContext& context) = nullptr;
  std::optional<settings::SettingGroup> group;  ///< its settings; empty: none
  void (*rowsBelow)(PanelContext& context) = nullptr;
  void (*rowsAbove)(PanelContext& context) = nullptr;
};

constexpr std::array<Section, 10> sections{{
    {"Material", startsOpen, settings::SettingGroup::Material, materialRows},
    {"Air", startsOpen, settings::SettingGroup::Air, airRows},
    {"Simulation", startsOpen, settings::SettingGroup::Simulation},
    {"Contact", contactMatters, settings::SettingGroup::Contact, contactRows},
    {"Scene", startsOpen, settings::SettingGroup::Scene, meshRows, sceneRows},
    {exportSection, startsClosed, std::nullopt, exportRows},
    {"View", startsClosed, settings::SettingGroup::View, viewButtons},
    {"Ghost", showsGhost, settings::SettingGroup::Ghost, ghostRows},
    {"Performance", startsClosed, std::nullopt, performanceRows},
    {"Advanced", startsClosed, settings::SettingGroup::Advanced, advancedRows},
}};

/// Whether the search shows this section or a row of it.
bool holdsRevealed(const PanelContext& context, const Section& section) {
  const RevealedRow& revealed = context.memory.revealed;
  if (revealed.key == exportSection) {
    return revealed.isPending && section.title == exportSection;
  }
  const settings::SettingInfo* info = settings::findSetting(revealed.key);
  const auto group = info == nullptr ? settings::SettingGroup::Scene : info->group;
  return revealed.isPending && section.group == group;
}

}  // namespace

void drawSections(PanelContext& context) {
  for (const Section& section : sections) {
    if (!beginSection(context, std::string(section.title), section.isOpenAtFirst(context),
                      holdsRevealed(context, section))) {
      continue;
    }
    if (section.rowsAbove != nullptr) {
      section.rowsAbove(context);
    }
    if (section.group) {
      settingsOfGroup(context, *section.group);
    }
    if (section.rowsBelow != nullptr) {
      section.rowsBelow(context);
    }
    endSection();
  }
}

}  // namespace drape::ui
