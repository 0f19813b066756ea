#include "messages/step_choice_text.hpp"
#include "scene/cloth_material.hpp"
#include "session/cost_budget.hpp"
#include "session/solver_warning.hpp"
#include "settings/settings_table.hpp"
#include "sim/solvers/solver.hpp"
#include "ui/panels.hpp"
#include "ui/scene_loader.hpp"
#include "ui/setting_widget.hpp"
#include "ui/solver_facts.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace drape::ui {
namespace {

constexpr const char* detailsName = "Solver details";

/// The change that one click offers.
enum class Remedy { None, Auto, Soften, AllowStrain, Untangle };

struct Message {
  std::string text;
  ImVec4 colour;
  Remedy remedy = Remedy::None;
};

/// The solver that chooses its own steps.
constexpr std::string_view choosingSolver = "auto";

/// Whether the remedy would change something.
bool isOffered(Remedy remedy, const settings::Settings& settings) {
  const bool chooses = settings.solver.name == choosingSolver;
  switch (remedy) {
    case Remedy::Auto:
      return !chooses && sim::findSolver(choosingSolver) != nullptr;
    case Remedy::Soften:
      return chooses && !settings.step.automatic.soften;
    case Remedy::AllowStrain:
      return chooses && settings.step.automatic.strainLimit == 0.0;
    case Remedy::Untangle:
      return true;
    case Remedy::None:
      break;
  }
  return false;
}

/// The allowed duration of a step: the user's budget, or else the time step [s].
double timeForStep(const settings::Settings& settings) {
  const double share = settings.automatic.budget * 1e-3 / session::budgetedTime;
  return (share > 0.0 ? share : 1.0) * settings.step.timeStep;
}

/// A message about intersections, which take long to disappear while the cloth moves.
std::optional<Message> intersectionMessage(const PanelContext& context) {
  const int pairs = intersectingPairsOf(context.snapshot);
  if (pairs == 0) {
    return std::nullopt;
  }
  return Message{context.texts(text::plural(pairs, "The cloth intersects itself in {} pair of triangles",
                                            "The cloth intersects itself in {} pairs of triangles"),
                               text::formatCount(pairs)),
                 palette().warning, Remedy::Untangle};
}

/// A message about the speed of the simulation: why it is slow, or that the cloth is at rest.
std::optional<Message> paceMessage(const PanelContext& context) {
  const session::Snapshot& snapshot = context.snapshot;
  const auto& choice = snapshot.stepReport.choice;
  if (choice && choice->sleeping) {
    return Message{context.texts("The cloth is at rest"), palette().muted};
  }
  if (choice && choice->costRatio > sim::adaptive::toleratedCostRatio) {
    const bool isFabric = snapshot.model->fabric != nullptr;
    const bool isSoftened = !isFabric && snapshot.settings.step.automatic.soften;
    return Message{context.texts(isSoftened ? "The springs are softened to keep real time"
                                            : "The cloth is too stiff and too fine for real time"),
                   palette().warning, isFabric ? Remedy::AllowStrain : Remedy::Soften};
  }
  return std::nullopt;
}

/// The most urgent message.
Message messageOf(const PanelContext& context) {
  const session::Snapshot& snapshot = context.snapshot;
  if (!context.stats.notice.empty()) {
    return {context.texts(context.stats.notice), palette().text};
  }
  if (!snapshot.message.empty()) {
    return {context.texts(snapshot.message), palette().warning,
            snapshot.overstretched && snapshot.overstretched->advice.key == "solver" ? Remedy::Auto : Remedy::None};
  }
  if (std::optional<Message> intersections = intersectionMessage(context)) {
    return *intersections;
  }
  if (std::optional<Message> pace = paceMessage(context)) {
    return *pace;
  }
  if (const text::Sentence warning = session::solverWarning(context.settings, *snapshot.model); !warning.empty()) {
    return {context.texts(warning), palette().warning, Remedy::Auto};
  }
  if (const text::Sentence warning = session::ghostWarning(context.settings, *snapshot.model); !warning.empty()) {
    return {context.texts("Ghost: {}", warning), palette().warning};
  }
  if (isTooSlow(snapshot)) {
    return {context.texts(slownessInWords(snapshot)), palette().warning};
  }
  return {context.texts("F1: help"), palette().muted};
}

using Facts = std::vector<std::pair<std::string, ImVec4>>;

/// The cloth and its speed. A long name is cut.
Facts factsOf(const PanelContext& context) {
  const session::Snapshot& snapshot = context.snapshot;
  const scene::SceneDescription& scene = snapshot.scene->description;
  const float widestName = 0.4F * ImGui::GetIO().DisplaySize.x;
  return {{fitted(scene.title.empty() ? scene.name : context.texts(scene.title), widestName), palette().text},
          {context.texts("{} vertices", text::formatCount(snapshot.model->vertexCount())), palette().text},
          {describePace(snapshot, context.texts), isTooSlow(snapshot) ? palette().warning : palette().text}};
}

/// The button of a remedy.
struct RemedyButton {
  const char* word;
  const char* name;
  const char* help;
};

RemedyButton buttonOf(Remedy remedy) {
  switch (remedy) {
    case Remedy::Untangle:
      return {"Untangle", "button.untangle",
              "Moves the cloth until it no longer intersects itself, and brings it to rest there. Pins stay in place."};
    case Remedy::Soften:
      return {"Soften", "button.soften",
              "Softens the springs so that the steps fit the cost budget and the simulation keeps real time."};
    case Remedy::AllowStrain:
      return {"Lower stiffness", "button.strain",
              "Lets auto lower the stretch stiffness of the fabric while its strain stays below 1 %, so that the "
              "simulation keeps real time."};
    case Remedy::Auto:
    case Remedy::None:
      break;
  }
  return {"Use auto", "button.auto", "Changes the solver to auto, which chooses suitable steps for this cloth."};
}

void apply(PanelContext& context, Remedy remedy) {
  switch (remedy) {
    case Remedy::Untangle:
      context.output.commands.emplace_back(session::UntangleCommand{});
      break;
    case Remedy::Soften:
      changeSetting(context, settings::requireSetting("auto.soften"), true);
      break;
    case Remedy::AllowStrain:
      changeSetting(context, settings::requireSetting("auto.strain"), visibleStrain);
      break;
    case Remedy::Auto:
      changeSetting(context, settings::requireSetting("solver"), std::string(choosingSolver));
      break;
    case Remedy::None:
      break;
  }
}

void remedyButton(PanelContext& context, Remedy remedy) {
  const RemedyButton button = buttonOf(remedy);
  ImGui::PushStyleColor(ImGuiCol_Button, palette().accentFill);
  if (ImGui::SmallButton(labelOf(context, button.word, button.name).c_str())) {
    apply(context, remedy);
  }
  ImGui::PopStyleColor();
  context.buttons[button.name] = lastItemRect();
  explainItem(context, button.name, button.help);
}

/// The details behind a click on the line: the solver, its cost and its choices.
void detailRows(PanelContext& context) {
  const session::Snapshot& snapshot = context.snapshot;
  const settings::Settings& settings = snapshot.settings;
  const sim::SolverInfo* solver = sim::findSolver(settings.solver.name);
  ImGui::Dummy({26.0F * ImGui::GetFontSize(), 0.0F});
  valueRow(context, "Solver", solver == nullptr ? settings.solver.name : context.texts(solver->title));
  valueRow(context, "Simulated time", fmt::format("{:.2f} s", snapshot.time));
  valueRow(context, "Time step", describeStepLimit(settings.step.timeStep, context.texts));
  valueRow(context, "Cost of a step", text::formatDuration(snapshot.stepSeconds));
  if (context.stats.frameSeconds > 0.0) {
    valueRow(context, "Frames per second", std::to_string(std::lround(1.0 / context.stats.frameSeconds)));
  }
  if (const auto& choice = snapshot.stepReport.choice) {
    ImGui::Spacing();
    const text::Sentence fabric = scene::materialInWords(snapshot.scene->cloths, settings, choice->softestMaterial);
    mutedText(context.texts("Chosen by auto: {}",
                            messages::inWords(*choice, fabric, snapshot.stepSeconds, timeForStep(settings))));
  }
  accuracyText(context);
  if (const text::Sentence warning = session::solverWarning(context.settings, *snapshot.model); !warning.empty()) {
    ImGui::Spacing();
    mutedText(context.texts(warning), palette().warning);
  }
  ImGui::Spacing();
  mutedText(context.texts("Change these in the section Advanced."));
}

void drawDetails(PanelContext& context, const UiRect& place) {
  ImGui::SetNextWindowPos({ImGui::GetStyle().WindowPadding.x, static_cast<float>(place.y) - 4.0F * context.scale},
                          ImGuiCond_Always, {0.0F, 1.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ImGui::GetFontSize() * 0.8F, ImGui::GetFontSize() * 0.6F));
  if (ImGui::BeginPopup(detailsName)) {
    const ImVec2 at = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    context.buttons["status.details"] = {at.x, at.y, size.x, size.y};
    detailRows(context);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

constexpr const char* gapBetweenFacts = "   \u00B7   ";

float widthOf(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x;
}

/// The facts in as many lines as they need. Every line but the first begins with a fact, without a gap before it.
std::vector<Facts> linesOf(const Facts& facts, float width) {
  std::vector<Facts> lines(1);
  float used = 0.0F;
  for (const auto& [text, colour] : facts) {
    const std::string following = gapBetweenFacts + text;
    const bool isFirst = lines.back().empty();
    const bool follows = !isFirst && used + widthOf(following) <= width;
    if (!isFirst && !follows) {
      lines.emplace_back();
    }
    lines.back().emplace_back(follows ? following : text, colour);
    used = follows ? used + widthOf(following) : widthOf(text);
  }
  return lines;
}

float widthOf(const Facts& line) {
  float width = 0.0F;
  for (const auto& [text, colour] : line) {
    width += widthOf(text);
  }
  return width;
}

/// Draws the facts from the left; a click on them opens the details.
void drawFacts(PanelContext& context, const std::vector<Facts>& lines, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight();
  if (ImGui::InvisibleButton("facts", {width, height * static_cast<float>(lines.size())})) {
    ImGui::OpenPopup(detailsName);
  }
  const bool hovered = ImGui::IsItemHovered();
  context.buttons["status.facts"] = lastItemRect();
  explainItem(context, "status.facts", "Click for the solver, its cost and its choices.");
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  float y = at.y;
  for (const Facts& line : lines) {
    float x = at.x;
    for (const auto& [text, colour] : line) {
      canvas.AddText({x, y}, ImGui::GetColorU32(hovered ? palette().accent : colour), text.c_str());
      x += widthOf(text);
    }
    y += height;
  }
}

/// The layout: one line when everything fits, otherwise the message above the facts, which may take several lines too.
struct Layout {
  std::vector<Facts> facts;
  float factsWidth = 0.0F;
  float buttonWidth = 0.0F;   // with its gap; 0: no button
  float messageWidth = 0.0F;  // of the wrapped lines
  float extraHeight = 0.0F;   // additional height of the line
};

Layout layOut(const PanelContext& context, const Message& message, const UiRect& place) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = static_cast<float>(place.width) - 2.0F * style.WindowPadding.x;
  Layout layout{.facts = linesOf(factsOf(context), width)};
  for (const Facts& line : layout.facts) {
    layout.factsWidth = std::min(width, std::max(layout.factsWidth, widthOf(line)));
  }
  if (message.remedy != Remedy::None) {
    layout.buttonWidth =
        widthOf(context.texts(buttonOf(message.remedy).word)) + 2.0F * style.FramePadding.x + style.ItemSpacing.x;
  }
  layout.messageWidth = widthOf(message.text);
  const bool breaks = layout.facts.size() > 1 || message.text.find('\n') != std::string::npos;
  if (breaks || layout.factsWidth + layout.messageWidth + layout.buttonWidth + 3.0F * style.WindowPadding.x > width) {
    layout.messageWidth = width - layout.buttonWidth;
    layout.extraHeight = ImGui::CalcTextSize(message.text.c_str(), nullptr, false, layout.messageWidth).y +
                         style.ItemSpacing.y + ImGui::GetTextLineHeight() * static_cast<float>(layout.facts.size() - 1);
  }
  return layout;
}

void drawMessage(PanelContext& context, const Message& message, const Layout& layout) {
  ImGui::PushStyleColor(ImGuiCol_Text, message.colour);
  ImGui::PushTextWrapPos(layout.extraHeight > 0.0F ? ImGui::GetCursorPosX() + layout.messageWidth : -1.0F);
  ImGui::TextUnformatted(message.text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  if (message.remedy != Remedy::None) {
    ImGui::SameLine();
    remedyButton(context, message.remedy);
  }
}

void drawLine(PanelContext& context, const Message& message, const Layout& layout) {
  if (layout.extraHeight > 0.0F) {
    drawMessage(context, message, layout);
    drawFacts(context, layout.facts, layout.factsWidth);
    return;
  }
  drawFacts(context, layout.facts, layout.factsWidth);
  const float right = ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x;
  ImGui::SameLine(right - layout.messageWidth - layout.buttonWidth);
  drawMessage(context, message, layout);
}

}  // namespace

double statusLine(PanelContext& context, const UiRect& place) {
  Message message = messageOf(context);
  if (!isOffered(message.remedy, context.settings)) {
    message.remedy = Remedy::None;
  }
  std::string facts;
  for (const auto& [text, colour] : factsOf(context)) {
    facts += (facts.empty() ? "" : gapBetweenFacts) + text;
  }
  const Layout layout = layOut(context, message, place);
  context.memory.status = facts + gapBetweenFacts + message.text;
  const float top = static_cast<float>(place.y) - layout.extraHeight;
  ImGui::SetNextWindowPos({static_cast<float>(place.x), top});
  ImGui::SetNextWindowSize({static_cast<float>(place.width), static_cast<float>(place.height) + layout.extraHeight});
  const float padding = (static_cast<float>(place.height) - ImGui::GetTextLineHeight()) * 0.5F;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ImGui::GetStyle().WindowPadding.x, std::floor(padding)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
  ImGui::Begin("Status", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoScrollWithMouse);
  if (layout.extraHeight > 0.0F) {
    context.buttons["overlay.status"] = {place.x, top, place.width, layout.extraHeight};
  }
  drawLine(context, message, layout);
  ImGui::PopStyleVar(2);
  drawDetails(context, {place.x, top, place.width, place.height});
  ImGui::End();
  return static_cast<double>(layout.extraHeight);
}

}  // namespace drape::ui
