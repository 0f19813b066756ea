#include "scene/unit_guess.hpp"
#include "ui/panels.hpp"
#include "ui/setting_widget.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace drape::ui {
namespace {

using text::Sentence;

/// A change that a line offers.
struct Offer {
  std::string name;                                ///< of the button: "reading.unit=m"
  Wording label;                                   ///< the text of the button
  Wording help;                                    ///< its effect
  const settings::SettingInfo* setting = nullptr;  ///< that it changes; null: it requests the action
  std::string value = {};
  UiAction action = UiAction::Dress;
};

/// A line that stays until the user answers it.
struct Line {
  std::string name;  ///< of its accept button: "reading.accept"
  text::Sentence text;
  ImVec4 colour;
  std::vector<Offer> offers;
  std::string subject = text.english();  ///< a line with another subject is another question
};

Line readingLine(const scene::MeshReading& reading) {
  Line line{"reading.accept", scene::inWords(reading), palette().text, {}};
  for (const scene::ReadingAlternative& other : reading.alternatives) {
    const bool unit = other.key == "unit";
    line.offers.push_back({"reading." + other.key + "=" + other.value,
                           unit ? Sentence::verbatim(other.value) : Sentence("{} up", other.value),
                           unit ? Sentence("Reads the file in {}.", scene::unitInWords(other.value))
                                : Sentence("Reads the file with {} up.", other.value),
                           settings::findSetting(other.key), other.value});
  }
  return line;
}

Line adviceLine(const std::string& name, const scene::Advice& advice) {
  Line line{name + ".accept", advice.text, palette().warning, {}};
  if (const settings::SettingInfo* setting = settings::findSetting(advice.key)) {
    line.offers.push_back({name + "." + advice.key, advice.button, Sentence("Sets {} to {}.", advice.key, advice.value),
                           setting, advice.value});
  }
  return line;
}

/// A body that passes through the cloth. The numbers change while the cloth moves; the question does not.
Line piercingLine(const PanelContext& context) {
  Line line{"pierced.accept", Sentence("{}.", context.stats.piercing->text), palette().warning, {}, "pierced"};
  if (hasBodyToDress(context.snapshot)) {
    line.offers.push_back({"pierced.dress", dressWord(context.snapshot), dressHelp});
  }
  return line;
}

/// The key under which an answered line is stored. Another scene or reading has another key.
std::string keyOf(const PanelContext& context, const Line& line) {
  return context.snapshot.scene->description.name + '\n' + line.subject;
}

std::vector<Line> linesOf(const PanelContext& context) {
  const scene::Scene& scene = *context.snapshot.scene;
  std::vector<Line> lines;
  if (scene.reading && scene.reading->needsReview()) {
    lines.push_back(readingLine(*scene.reading));
  }
  if (scene.pinAdvice) {
    lines.push_back(adviceLine("pins", *scene.pinAdvice));
  }
  if (context.snapshot.overstretched && settings::findSetting(context.snapshot.overstretched->advice.key) != nullptr) {
    lines.push_back(adviceLine("stretch", context.snapshot.overstretched->advice));
  }
  if (context.stats.piercing && !context.stats.dressing) {
    lines.push_back(piercingLine(context));
  }
  std::erase_if(lines, [&](const Line& line) { return context.memory.accepted.contains(keyOf(context, line)); });
  return lines;
}

/// The value of a setting from a text.
settings::SettingValue valueOf(const settings::SettingInfo& setting, const std::string& text) {
  settings::Settings settings;
  settings::assignSettingText(settings, setting, text);
  return settings::settingValue(settings, setting);
}

bool button(PanelContext& context, const std::string& name, const Wording& label, const Wording& help) {
  ImGui::PushID(name.c_str());
  const bool pressed = ImGui::SmallButton(labelOf(context, label, name).c_str());
  ImGui::PopID();
  context.buttons[name] = lastItemRect();
  explainItem(context, name, help);
  return pressed;
}

/// Draws the text and its buttons: beside it or, in a narrow window, below it.
void drawLine(PanelContext& context, const Line& line, float width, bool beside) {
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  ImGui::PushStyleColor(ImGuiCol_Text, line.colour);
  ImGui::TextUnformatted(context.texts(line.text).c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  if (beside) {
    ImGui::SameLine();
  }
  for (const Offer& offer : line.offers) {
    if (!button(context, offer.name, offer.label, offer.help)) {
      // Not pressed.
    } else if (offer.setting == nullptr) {
      context.output.requests.emplace_back(offer.action);
    } else {
      changeSetting(context, *offer.setting, valueOf(*offer.setting, offer.value));
    }
    ImGui::SameLine();
  }
  ImGui::PushStyleColor(ImGuiCol_Button, palette().accentFill);
  if (button(context, line.name, "OK", "Keeps this and closes the line.")) {
    context.memory.accepted.insert(keyOf(context, line));
  }
  ImGui::PopStyleColor();
}

/// The width of the buttons of the widest line [pixels].
float widthOfButtons(const PanelContext& context, const std::vector<Line>& lines) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float widest = 0.0F;
  for (const Line& line : lines) {
    const auto widthOf = [&](const Wording& label) {
      return ImGui::CalcTextSize(context.texts(label).c_str()).x + 2.0F * style.FramePadding.x + style.ItemSpacing.x;
    };
    float width = widthOf("OK");
    for (const Offer& offer : line.offers) {
      width += widthOf(offer.label);
    }
    widest = std::max(widest, width);
  }
  return widest;
}

}  // namespace

void readingNotice(PanelContext& context, OverlayStack& stack) {
  const std::vector<Line> lines = linesOf(context);
  if (lines.empty() || !context.stats.loading.empty()) {
    return;  // the user has answered, and a scene is being built
  }
  stack.begin("reading");
  const float textWidth = stack.textWidth() - widthOfButtons(context, lines);
  const bool beside = textWidth > 12.0F * ImGui::GetFontSize();
  for (const Line& line : lines) {
    drawLine(context, line, beside ? textWidth : stack.textWidth(), beside);
  }
  stack.end();
}

}  // namespace drape::ui
