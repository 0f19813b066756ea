#include "ui/setting_widget.hpp"

#include "sim/error.hpp"
#include "ui/slider_range.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drape {
namespace {

/// How an edit ended in this frame.
struct Edit {
  bool changed = false;
  bool finished = false;  ///< the mouse let go, or the text was confirmed
  SettingValue value;
};

/// Paints the field and its filled part; the slider that is drawn on top then leaves its own background out.
void paintTrack(const SliderRange& range, double value) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::CalcItemWidth(), ImGui::GetFrameHeight()};
  const float rounding = ImGui::GetStyle().FrameRounding;
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  canvas.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(palette().field), rounding);
  // A range that goes both ways fills from its zero, any other from its left end.
  const double origin = range.min < 0.0 ? sliderFraction(range, 0.0) : 0.0;
  const auto [low, high] = std::minmax(origin, sliderFraction(range, value));
  const float left = corner.x + size.x * static_cast<float>(low);
  const float right = corner.x + size.x * static_cast<float>(high);
  if (right - left > 1.0F) {
    canvas.AddRectFilled({left, corner.y}, {right, corner.y + size.y}, ImGui::GetColorU32(palette().accentFill),
                         rounding);
  }
}

void pushTransparentFrame() {
  ImGui::PushStyleColor(ImGuiCol_FrameBg, ImVec4(0.0F, 0.0F, 0.0F, 0.0F));
  ImGui::PushStyleColor(ImGuiCol_FrameBgHovered, ImVec4(1.0F, 1.0F, 1.0F, 0.05F));
  ImGui::PushStyleColor(ImGuiCol_FrameBgActive, ImVec4(1.0F, 1.0F, 1.0F, 0.08F));
}

Edit numberWidget(const SettingInfo& info, const NumberField& field, double value) {
  const SliderRange range = everydayRange(field, std::get<double>(defaultValue(info)));
  const std::string format = numberFormat("%.4g", info.unit);
  paintTrack(range, value);
  pushTransparentFrame();
  double edited = value;
  const bool touched =
      ImGui::SliderScalar("##value", ImGuiDataType_Double, &edited, &range.min, &range.max, format.c_str(),
                          range.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  ImGui::PopStyleColor(3);
  Edit edit{.finished = ImGui::IsItemDeactivatedAfterEdit(), .value = value};
  if (touched && std::isfinite(edited)) {
    const double clamped = std::clamp(edited, field.min, field.max);
    edit.changed = clamped != value;
    edit.value = clamped;
  }
  return edit;
}

Edit integerWidget(const SettingInfo& info, const IntegerField& field, int value) {
  const SliderRange range{static_cast<double>(field.min), static_cast<double>(field.max), field.max > 100};
  paintTrack(range, value);
  pushTransparentFrame();
  int edited = value;
  const std::string format = numberFormat("%d", info.unit);
  const bool touched =
      ImGui::SliderScalar("##value", ImGuiDataType_S32, &edited, &field.min, &field.max, format.c_str(),
                          range.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  ImGui::PopStyleColor(3);
  Edit edit{.finished = ImGui::IsItemDeactivatedAfterEdit(), .value = value};
  if (touched) {
    const int allowed = nearestAllowed(field, edited);
    edit.changed = allowed != value;
    edit.value = allowed;
  }
  return edit;
}

Edit flagWidget(bool value) {
  bool edited = value;
  const bool changed = ImGui::Checkbox("##value", &edited);
  return {.changed = changed, .finished = changed, .value = edited};
}

std::string spoken(std::string word) {
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

Edit segmentsWidget(PanelContext& context, const SettingInfo& info, const std::vector<std::string>& choices,
                    const std::string& value) {
  Edit edit{.value = value};
  const float width = ImGui::CalcItemWidth();
  const int count = static_cast<int>(choices.size());
  const float gap = std::round(2.0F * context.scale);
  ImGui::BeginGroup();
  for (int i = 0; i < count; ++i) {
    const std::string& choice = choices[static_cast<std::size_t>(i)];
    const bool chosen = choice == value;
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? palette().accentFill : palette().field);
    ImGui::PushStyleColor(ImGuiCol_Text, chosen ? palette().text : palette().muted);
    if (ImGui::Button(
            spoken(choice).c_str(),
            {(width - gap * static_cast<float>(count - 1)) / static_cast<float>(count), ImGui::GetFrameHeight()}) &&
        !chosen) {
      edit = {.changed = true, .finished = true, .value = choice};
    }
    ImGui::PopStyleColor(2);
    context.buttons[std::string(info.key) + "=" + choice] = lastItemRect();
    if (i + 1 < count) {
      ImGui::SameLine(0.0F, gap);
    }
  }
  ImGui::EndGroup();
  return edit;
}

Edit comboWidget(const std::vector<std::string>& choices, const std::string& value) {
  Edit edit{.value = value};
  if (ImGui::BeginCombo("##value", spoken(value).c_str())) {
    for (const std::string& choice : choices) {
      if (ImGui::Selectable(spoken(choice).c_str(), choice == value) && choice != value) {
        edit = {.changed = true, .finished = true, .value = choice};
      }
    }
    ImGui::EndCombo();
  }
  return edit;
}

/// Up to three short words stand side by side; more of them share a list that drops down.
Edit choiceWidget(PanelContext& context, const SettingInfo& info, const ChoiceField& field, const std::string& value) {
  const std::vector<std::string> choices = field.choices();
  float widest = 0.0F;
  for (const std::string& choice : choices) {
    widest = std::max(widest, ImGui::CalcTextSize(spoken(choice).c_str()).x);
  }
  const float needed = (widest + 2.0F * ImGui::GetStyle().FramePadding.x) * static_cast<float>(choices.size());
  const bool sideBySide = choices.size() > 1 && choices.size() <= 3 && needed <= ImGui::CalcItemWidth();
  return sideBySide ? segmentsWidget(context, info, choices, value) : comboWidget(choices, value);
}

Edit fieldWidget(PanelContext& context, const SettingInfo& info, const SettingValue& value) {
  if (const auto* number = std::get_if<NumberField>(&info.field)) {
    return numberWidget(info, *number, std::get<double>(value));
  }
  if (const auto* integer = std::get_if<IntegerField>(&info.field)) {
    return integerWidget(info, *integer, std::get<int>(value));
  }
  if (std::holds_alternative<FlagField>(info.field)) {
    return flagWidget(std::get<bool>(value));
  }
  return choiceWidget(context, info, std::get<ChoiceField>(info.field), std::get<std::string>(value));
}

std::string withUnit(const std::string& text, std::string_view unit) {
  return unit == "-" ? text : text + " " + prettyUnit(unit);
}

void explain(const PanelContext& context, const SettingInfo& info) {
  beginExplanation(context);
  ImGui::TextUnformatted(info.title.data(), info.title.data() + info.title.size());
  ImGui::PushStyleColor(ImGuiCol_Text, palette().muted);
  ImGui::TextWrapped("%.*s", static_cast<int>(info.help.size()), info.help.data());
  ImGui::Spacing();
  ImGui::TextWrapped("Range: %s", withUnit(describeRange(info), info.unit).c_str());
  ImGui::TextWrapped("Default: %s", withUnit(formatValue(defaultValue(info)), info.unit).c_str());
  ImGui::TextWrapped("On the command line: --set %.*s=%s", static_cast<int>(info.key.size()), info.key.data(),
                     formatValue(settingValue(context.settings, info)).c_str());
  ImGui::Spacing();
  const bool typed =
      std::holds_alternative<NumberField>(info.field) || std::holds_alternative<IntegerField>(info.field);
  ImGui::TextWrapped(
      "%s", typed ? "Ctrl+click to type a value, right click for the default." : "Right click for the default.");
  ImGui::PopStyleColor();
  endExplanation();
}

void takeEdit(PanelContext& context, const SettingInfo& info, const Edit& edit) {
  // Building a scene takes a while, so a slider that needs it acts when it is let go.
  const bool waits = info.effect == SettingEffect::Scene;
  if (waits && edit.changed && !edit.finished) {
    context.memory.pending.add(info, edit.value, ImGui::GetTime());
  } else if (edit.changed || (waits && edit.finished)) {
    changeSetting(context, info, edit.value);
  }
}

}  // namespace

std::string numberFormat(std::string_view digits, std::string_view unit) {
  std::string format(digits);
  if (unit == "-") {
    return format;
  }
  format += ' ';
  for (const char letter : prettyUnit(unit)) {
    format += letter == '%' ? std::string("%%") : std::string(1, letter);
  }
  return format;
}

int nearestAllowed(const IntegerField& field, int value) {
  const int inside = std::clamp(value, field.min, field.max);
  const int steps = (inside - field.min + field.step / 2) / field.step;
  const int last = (field.max - field.min) / field.step;
  return field.min + std::min(steps, last) * field.step;
}

bool settingApplies(const SettingInfo& info, const Settings& settings, const Scene& scene) {
  const bool isGrid = std::holds_alternative<GridSource>(scene.description.source);
  if (info.key.starts_with("grid.")) {
    return isGrid;
  }
  if (info.key == "unit" || info.key == "weld_tolerance") {
    return !isGrid;
  }
  if (!info.alsoKey.empty()) {
    const SettingInfo* decided = findSetting(info.alsoKey);
    return decided == nullptr || formatValue(settingValue(settings, *decided)) == info.alsoValue;
  }
  return true;
}

void changeSetting(PanelContext& context, const SettingInfo& info, const SettingValue& value) {
  Settings changed = context.settings;
  try {
    assignSetting(changed, info, value);
  } catch (const UsageError& error) {
    context.output.hint = error.what();
    return;
  }
  context.memory.pending.add(info, value, ImGui::GetTime());
  if (info.effect == SettingEffect::Scene) {
    context.output.requests.emplace_back(RebuildSceneRequest{std::move(changed)});
  } else {
    context.output.commands.emplace_back(SetSettingCommand{std::string(info.key), value});
  }
}

void settingWidget(PanelContext& context, const SettingInfo& info) {
  const SettingValue value = settingValue(context.settings, info);
  const SettingValue usual = defaultValue(info);
  const std::string key(info.key);
  ImGui::PushID(key.c_str());
  const UiRect row = beginRow(context, info.title, value != usual);
  const Edit edit = fieldWidget(context, info, value);
  context.widgets[key] = lastItemRect();
  takeEdit(context, info, edit);
  if (hoversRow(row)) {
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) && value != usual) {
      changeSetting(context, info, usual);
    }
    if (hoveredLongEnough(context, key)) {
      explain(context, info);
    }
  }
  ImGui::PopID();
}

void settingsOfGroup(PanelContext& context, SettingGroup group) {
  for (const SettingInfo& info : settingsTable()) {
    if (info.group == group && settingApplies(info, context.settings, *context.snapshot.scene)) {
      settingWidget(context, info);
    }
  }
}

}  // namespace drape
