#include "session/solver_warning.hpp"
#include "session/work_budget.hpp"
#include "settings/settings_table.hpp"
#include "sim/solver.hpp"
#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/solver_facts.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace drape {
namespace {

/// What one click would change for the better.
enum class WayOut { None, Auto, Soften };

struct Message {
  std::string text;
  ImVec4 colour;
  WayOut wayOut = WayOut::None;
};

/// The solver that finds out for itself what a cloth needs.
constexpr std::string_view choosingSolver = "auto";

bool isOpen(WayOut way, const Settings& settings) {
  const bool chooses = settings.solver.name == choosingSolver;
  switch (way) {
    case WayOut::Auto:
      return !chooses && findSolver(choosingSolver) != nullptr;
    case WayOut::Soften:
      return chooses && !settings.step.soften;
    case WayOut::None:
      break;
  }
  return false;
}

/// What a method that chooses for itself has to say that is urgent.
std::optional<Message> choiceMessage(const Snapshot& snapshot, const std::string& words) {
  const StepChoice& choice = *snapshot.stepReport.choice;
  if (choice.resting) {
    return Message{words, palette().muted};
  }
  if (choice.demand > stretchedBudget) {
    return Message{words, palette().warning, WayOut::Soften};
  }
  return std::nullopt;
}

/// What a step may cost: what the user allows, or else what it covers [s].
double timeForStep(const Settings& settings) {
  const double share = settings.automatic.budget * 1e-3 / budgetedTime;
  return (share > 0.0 ? share : 1.0) * settings.step.timeStep;
}

/// The most urgent thing there is to say.
Message messageOf(const PanelContext& context) {
  const Snapshot& snapshot = context.snapshot;
  const UiStats& stats = context.stats;
  if (!stats.loading.empty()) {
    return {stats.loading, palette().accent};
  }
  if (!stats.error.empty()) {
    return {stats.error, palette().error};
  }
  if (!snapshot.message.empty()) {
    return {snapshot.message, palette().warning,
            snapshot.maxStretch > implausibleStretch ? WayOut::Auto : WayOut::None};
  }
  if (!stats.notice.empty()) {
    return {stats.notice, palette().text};
  }
  const auto& choice = snapshot.stepReport.choice;
  const std::string chosen =
      choice ? inWords(*choice, snapshot.stepSeconds, timeForStep(snapshot.settings)) : std::string();
  if (choice) {
    if (std::optional<Message> urgent = choiceMessage(snapshot, chosen)) {
      return *urgent;
    }
  }
  if (std::string warning = solverWarning(context.settings, *snapshot.model); !warning.empty()) {
    return {std::move(warning), palette().warning, WayOut::Auto};
  }
  if (std::string warning = ghostWarning(context.settings, *snapshot.model); !warning.empty()) {
    return {"Ghost: " + warning, palette().warning};
  }
  if (!snapshot.paused && snapshot.realTimeFactor > 0.0 &&
      snapshot.realTimeFactor < 0.9 * snapshot.settings.playback.speed) {
    return {"The machine does not keep up, so the clock runs slower", palette().warning};
  }
  if (choice) {
    return {chosen, palette().muted};
  }
  return {"F1 or ? for help", palette().muted};
}

std::vector<std::string> factsOf(const PanelContext& context) {
  const Snapshot& snapshot = context.snapshot;
  std::vector<std::string> facts{snapshot.scene->description.name,
                                 formatCount(snapshot.model->vertexCount()) + " vertices",
                                 printed("%.2f s", snapshot.time), describePace(snapshot)};
  if (context.stats.frameSeconds > 0.0) {
    facts.push_back(std::to_string(std::lround(1.0 / context.stats.frameSeconds)) + " fps");
  }
  return facts;
}

/// At the right end of the line. How wide it is [pixels].
float drawWayOut(PanelContext& context, WayOut way) {
  const bool toAuto = way == WayOut::Auto;
  const char* const word = toAuto ? "Use auto" : "Keep pace";
  const ImGuiStyle& style = ImGui::GetStyle();
  const float width = ImGui::CalcTextSize(word).x + 2.0F * style.FramePadding.x;
  ImGui::SameLine(ImGui::GetWindowWidth() - width - style.WindowPadding.x);
  ImGui::PushStyleColor(ImGuiCol_Button, palette().accentFill);
  if (ImGui::SmallButton(word)) {
    if (toAuto) {
      changeSetting(context, requireSetting("solver"), std::string(choosingSolver));
    } else {
      changeSetting(context, requireSetting("auto.soften"), true);
    }
  }
  ImGui::PopStyleColor();
  const char* const name = toAuto ? "button.auto" : "button.soften";
  context.buttons[name] = lastItemRect();
  explainItem(context, name,
              toAuto ? "Changes the solver to auto, which takes the steps that this cloth needs."
                     : "Softens the springs to what the work allowed carries, so that the clock keeps pace.");
  return width + style.ItemSpacing.x;
}

void drawMessage(PanelContext& context, float room) {
  const Message message = messageOf(context);
  const float right = isOpen(message.wayOut, context.settings) ? drawWayOut(context, message.wayOut) : 0.0F;
  room -= right;
  const auto fits = static_cast<std::size_t>(std::max(8.0F, room / (ImGui::GetFontSize() * 0.52F)));
  const std::string firstLine = message.text.substr(0, message.text.find('\n'));
  const std::string shown = shortened(firstLine, fits);
  const float width = ImGui::CalcTextSize(shown.c_str()).x;
  ImGui::SameLine(ImGui::GetWindowWidth() - width - right - ImGui::GetStyle().WindowPadding.x);
  ImGui::PushStyleColor(ImGuiCol_Text, message.colour);
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopStyleColor();
  if (shown != message.text) {
    explainItem(context, "status.message", message.text);
  }
}

}  // namespace

void statusLine(PanelContext& context, const UiRect& place) {
  ImGui::SetNextWindowPos({static_cast<float>(place.x), static_cast<float>(place.y)});
  ImGui::SetNextWindowSize({static_cast<float>(place.width), static_cast<float>(place.height)});
  const float padding = (static_cast<float>(place.height) - ImGui::GetTextLineHeight()) * 0.5F;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ImGui::GetStyle().WindowPadding.x, std::floor(padding)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));
  ImGui::Begin("Status", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBringToFrontOnFocus);
  float used = 0.0F;
  bool first = true;
  for (const std::string& fact : factsOf(context)) {
    if (!first) {
      ImGui::SameLine(0.0F, 0.0F);
      mutedText("   \u00B7   ");
      ImGui::SameLine(0.0F, 0.0F);
    }
    first = false;
    mutedText(fact, palette().text);
    used = ImGui::GetItemRectMax().x;
  }
  drawMessage(context, static_cast<float>(place.width) - used - 3.0F * ImGui::GetStyle().WindowPadding.x);
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace drape
