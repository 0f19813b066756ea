#include "ui/setting_widget.hpp"

#include "messages/error.hpp"
#include "settings/own_fabrics.hpp"
#include "ui/number_slider.hpp"
#include "ui/setting_text.hpp"
#include "ui/solver_facts.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace drape::ui {
namespace {

Edit flagWidget(bool value) {
  bool edited = value;
  const bool changed = ImGui::Checkbox("##value", &edited);
  return {.changed = changed, .finished = changed, .value = edited};
}

/// One choice, as it is shown.
struct Choice {
  std::string word;
  std::string title;  ///< translated
  text::Sentence help;
};

/// The meaning of a choice. A choice between solvers has the first sentence of their help, which is translated as a
/// whole.
text::Sentence helpOf(const PanelContext& context, const settings::ChoiceField& field, const std::string& word) {
  const std::string_view help = field.label == nullptr ? std::string_view() : field.label(word).help;
  const sim::SolverInfo* solver = sim::findSolver(word);
  return solver != nullptr && !help.empty() && solver->help.starts_with(help)
             ? text::Sentence::verbatim(shortHelpOf(*solver, context.texts))
             : text::Sentence(help);
}

std::vector<Choice> choicesOf(const PanelContext& context, const settings::ChoiceField& field) {
  std::vector<Choice> choices;
  for (const std::string& word : field.choices()) {
    choices.push_back({word, context.texts(settings::choiceTitle(field, word)), helpOf(context, field, word)});
  }
  if (field.ownChoices != nullptr) {
    for (settings::OwnChoice& own : field.ownChoices(context.settings)) {
      choices.push_back({std::move(own.word), std::move(own.title), std::move(own.help)});
    }
  }
  return choices;
}

/// The meaning of each choice, beside its entry.
void explainChoice(const PanelContext& context, const std::string& name, const Choice& choice, const UiRect& row) {
  if (const std::string help = context.texts(choice.help);
      !help.empty() && ImGui::IsItemHovered() && hoveredLongEnough(context, name)) {
    beginExplanation(context, &row);
    ImGui::TextWrapped("%s", help.c_str());
    endExplanation();
  }
}

Edit segmentsWidget(PanelContext& context, const settings::SettingInfo& info, const std::vector<Choice>& choices,
                    const std::string& value) {
  Edit edit{.value = value};
  const float width = ImGui::CalcItemWidth();
  const float gap = std::round(2.0F * context.scale);
  ImGui::BeginGroup();
  const auto count = static_cast<float>(choices.size());
  const ImVec2 size{(width - gap * (count - 1.0F)) / count, ImGui::GetFrameHeight()};
  for (const Choice& choice : choices) {
    const bool chosen = choice.word == value;
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? palette().accentFill : palette().field);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered,
                          ImGui::GetStyleColorVec4(chosen ? ImGuiCol_Button : ImGuiCol_ButtonHovered));
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? palette().text : palette().muted);
    if (ImGui::Button((choice.title + "###" + choice.word).c_str(), size) && !chosen) {
      edit = {.changed = true, .finished = true, .value = choice.word};
    }
    ImGui::PopStyleColor(3);
    context.buttons[std::string(info.key) + "=" + choice.word] = lastItemRect();
    if (&choice != &choices.back()) {
      ImGui::SameLine(0.0F, gap);
    }
  }
  ImGui::EndGroup();
  return edit;
}

Edit comboWidget(PanelContext& context, const settings::SettingInfo& info, const std::vector<Choice>& choices,
                 const std::string& value) {
  Edit edit{.value = value};
  const auto chosen = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.word == value; });
  const float textWidth = widthBesideArrow();
  const std::string title =
      chosen != choices.end()
          ? chosen->title
          : context.texts(settings::shownChoice(std::get<settings::ChoiceField>(info.field), value, context.settings));
  const std::string shown = fitted(title, textWidth);
  if (ImGui::BeginCombo("##value", shown.c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const Choice& choice : choices) {
      if (ImGui::Selectable((choice.title + "###" + choice.word).c_str(), choice.word == value) &&
          choice.word != value) {
        edit = {.changed = true, .finished = true, .value = choice.word};
      }
      const std::string name = std::string(info.key) + "=" + choice.word;
      const UiRect row = lastItemRect();
      context.buttons[name] = row;
      explainChoice(context, name, choice, row);
    }
    ImGui::EndCombo();
  }
  return edit;
}

/// Up to three short words stand side by side; more of them form a drop-down list.
Edit choiceWidget(PanelContext& context, const settings::SettingInfo& info, const settings::ChoiceField& field,
                  const std::string& value) {
  const std::vector<Choice> choices = choicesOf(context, field);
  float widest = 0.0F;
  for (const Choice& choice : choices) {
    widest = std::max(widest, ImGui::CalcTextSize(choice.title.c_str()).x);
  }
  const float needed = (widest + 2.0F * ImGui::GetStyle().FramePadding.x) * static_cast<float>(choices.size());
  const bool sideBySide = choices.size() > 1 && choices.size() <= 3 && needed <= ImGui::CalcItemWidth();
  return sideBySide ? segmentsWidget(context, info, choices, value) : comboWidget(context, info, choices, value);
}

Edit fieldWidget(PanelContext& context, const settings::SettingInfo& info, const settings::SettingValue& value) {
  if (std::holds_alternative<settings::FlagField>(info.field)) {
    return flagWidget(std::get<bool>(value));
  }
  if (const auto* choice = std::get_if<settings::ChoiceField>(&info.field)) {
    return choiceWidget(context, info, *choice, std::get<std::string>(value));
  }
  return numberSlider(context, sliderOf(info, context.settings, context.texts), value);
}

/// The value as typed, with few digits for a real number.
std::string shortValue(const settings::SettingValue& value) {
  const double* number = std::get_if<double>(&value);
  if (number == nullptr) {
    return settings::formatValue(value);
  }
  return fmt::format("{:.6g}", *number);
}

void explain(const PanelContext& context, const settings::SettingInfo& info, const UiRect& row) {
  beginExplanation(context, &row);
  const auto line = [&](const Wording& wording) { ImGui::TextWrapped("%s", context.texts(wording).c_str()); };
  ImGui::TextUnformatted(context.texts(info.title).c_str());
  ImGui::PushStyleColor(ImGuiCol_Text, palette().muted);
  line(info.help);
  ImGui::Spacing();
  const auto valueOf = [&](const settings::SettingValue& value) {
    return withUnit(text::Sentence::verbatim(shortValue(value)), info.unit);
  };
  line(text::Sentence("Range: {}", settings::describeRange(info, context.settings)));
  line(text::Sentence("In the scene: {}", valueOf(settings::settingValue(context.sceneSettings, info))));
  line(text::Sentence("Default: {}", valueOf(settings::defaultValue(info))));
  line(text::Sentence("Command line: --set {}={}", info.key,
                      shortValue(settings::settingValue(context.settings, info))));
  ImGui::Spacing();
  const bool typed = std::holds_alternative<settings::NumberField>(info.field) ||
                     std::holds_alternative<settings::IntegerField>(info.field);
  line(typed ? "Ctrl+click types a value. A right click restores the scene's value, another one the default."
             : "A right click restores the scene's value, another one the default.");
  ImGui::PopStyleColor();
  endExplanation();
}

void applyEdit(PanelContext& context, const settings::SettingInfo& info, const Edit& edit) {
  if (info.effect != settings::SettingEffect::Scene) {
    if (edit.changed) {
      changeSetting(context, info, edit.value);
    }
  } else if (!edit.finished) {
    // Rebuilding a scene takes a while, so such a slider acts when it is released.
    if (edit.changed) {
      context.memory.pending.add(info, edit.value, ImGui::GetTime());
    }
  } else if (edit.value != settings::settingValue(context.snapshot.settings, info)) {
    changeSetting(context, info, edit.value);
  }
}

}  // namespace

bool settingApplies(const settings::SettingInfo& info, const settings::Settings& settings, const scene::Scene& scene) {
  const auto isGrid = [](const scene::ClothDescription& cloth) {
    return std::holds_alternative<scene::GridSource>(cloth.source);
  };
  const std::vector<scene::ClothDescription>& cloths = scene.description.cloths;
  if ((info.scope == settings::SettingScope::Grid && std::ranges::none_of(cloths, isGrid)) ||
      (info.scope == settings::SettingScope::MeshFile && std::ranges::all_of(cloths, isGrid))) {
    return false;
  }
  if (!settings::isRelevant(info, settings)) {
    return false;
  }
  if (!info.alsoKey.empty()) {
    const settings::SettingInfo& other = settings::requireSetting(info.alsoKey);
    return !settings::isRelevant(other, settings) ||
           settings::formatValue(settings::settingValue(settings, other)) == info.alsoValue;
  }
  return true;
}

void changeSetting(PanelContext& context, const settings::SettingInfo& info, const settings::SettingValue& value) {
  try {
    settings::Settings changed = settings::withSetting(context.settings, info, value);
    if (info.effect == settings::SettingEffect::Scene) {
      context.output.requests.emplace_back(RebuildSceneRequest{std::move(changed)});
    } else {
      context.output.commands.emplace_back(session::SetSettingCommand{std::string(info.key), value});
    }
    context.memory.pending.add(info, value, ImGui::GetTime());
  } catch (const messages::UsageError& error) {
    context.output.hint = text::Sentence::verbatim(error.what());
  }
}

namespace {

/// Restores the value of the scene, or the default where the scene's is in force. A fabric that the scene gives by
/// single values has no name that would restore them.
void restoreSetting(PanelContext& context, const settings::SettingInfo& info) {
  const settings::SettingValue value = settings::settingValue(context.settings, info);
  const settings::SettingValue ofScene = settings::settingValue(context.sceneSettings, info);
  if (value == ofScene) {
    if (const settings::SettingValue usual = settings::defaultValue(info); value != usual) {
      changeSetting(context, info, usual);
    }
  } else if (info.isPreset) {
    context.output.commands.emplace_back(
        session::UseFabricCommand{settings::fabricOf(context.sceneSettings, context.sceneSettings.fabric.preset)});
  } else {
    changeSetting(context, info, ofScene);
  }
}

}  // namespace

void settingWidget(PanelContext& context, const settings::SettingInfo& info) {
  const settings::SettingValue value = settings::settingValue(context.settings, info);
  const settings::SettingValue sceneValue = settings::settingValue(context.sceneSettings, info);
  const std::string key(info.key);
  ImGui::PushID(key.c_str());
  const UiRect row = beginRow(context, info.title, value != sceneValue);
  const Edit edit = fieldWidget(context, info, value);
  context.widgets[key] = lastItemRect();
  applyEdit(context, info, edit);
  if (hoversRow(row)) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
      restoreSetting(context, info);
    }
    if (hoveredLongEnough(context, key)) {
      explain(context, info, row);
    }
  }
  revealRow(context, key, row);
  ImGui::PopID();
}

namespace {

/// Whether a setting is one of the moduli and damping times that the name of a fabric stands for. They are folded
/// at first, so that the other settings are in sight.
bool isFolded(const settings::SettingInfo& info) {
  const auto keys = settings::fabricValueKeys();
  return info.key != "fabric.density" && std::find(keys.begin(), keys.end(), info.key) != keys.end();
}

bool revealsFolded(const PanelContext& context) {
  const RevealedRow& revealed = context.memory.revealed;
  const settings::SettingInfo* info = settings::findSetting(revealed.key);
  return revealed.isPending && info != nullptr && isFolded(*info);
}

}  // namespace

void settingsOfGroup(PanelContext& context, settings::SettingGroup group) {
  std::optional<bool> unfolded;  // nothing: no folded setting yet
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    if (info.group != group || !settingApplies(info, context.settings, *context.snapshot.scene)) {
      continue;
    }
    if (isFolded(info)) {
      unfolded = unfolded ? unfolded : beginFold(context, "Moduli and damping", "moduli", revealsFolded(context));
      if (!*unfolded) {
        continue;
      }
    }
    settingWidget(context, info);
  }
}

}  // namespace drape::ui
