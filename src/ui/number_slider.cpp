#include "ui/number_slider.hpp"

#include "messages/sentence_error.hpp"
#include "text/number_text.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>
#include <fmt/printf.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace drape::ui {
namespace {

double asNumber(const settings::SettingValue& value) {
  const int* whole = std::get_if<int>(&value);
  return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(value);
}

bool isAllowed(const settings::SettingInfo& info, const settings::Settings& settings, int value) {
  try {
    static_cast<void>(settings::withSetting(settings, info, value));
    return true;
  } catch (const messages::UsageError&) {
    return false;
  }
}

/// The nearest value of the setting's type within its range. When other settings exclude a whole number, the result is
/// its neighbour, so that a slider skips it.
settings::SettingValue allowedValue(const settings::SettingInfo& info, const settings::Settings& settings,
                                    double value) {
  if (const auto* integer = std::get_if<settings::IntegerField>(&info.field)) {
    const int nearest = nearestAllowed(*integer, value);
    for (const int candidate : {nearest, nearest + 1, nearest - 1}) {
      if (isAllowed(info, settings, candidate)) {
        return candidate;
      }
    }
    return nearest;
  }
  const auto& number = std::get<settings::NumberField>(info.field);
  return std::clamp(value, number.min, number.max);
}

/// Rounds to four significant digits, so that the setting equals the displayed value.
double roundedForDisplay(double value) {
  if (value == 0.0) {
    return 0.0;
  }
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 3.0);
  return std::strtod(settings::formatValue(std::round(value / unit) * unit).c_str(), nullptr);
}

/// The number of a slider. Where it is wider than the slider, it has fewer digits and no unit.
std::string shownNumber(const SliderInput& input, double value, float width) {
  const float room = width - 2.0F * ImGui::GetStyle().FramePadding.x;
  std::string text = fmt::sprintf(input.format, value);
  for (int digits = 4; digits > 0 && ImGui::CalcTextSize(text.c_str()).x > room; --digits) {
    text = fmt::format("{:.{}g}", value, digits);
  }
  return text;
}

/// Draws field, filled part, slider handle and number over the last item.
void paint(const PanelContext& context, const SliderInput& input, const settings::SettingValue& value) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const float width = high.x - low.x;
  const float rounding = ImGui::GetStyle().FrameRounding;
  const bool active = ImGui::IsItemActive();
  const ImGuiCol background = active                   ? ImGuiCol_FrameBgActive
                              : ImGui::IsItemHovered() ? ImGuiCol_FrameBgHovered
                                                       : ImGuiCol_FrameBg;
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  canvas.AddRectFilled(low, high, ImGui::GetColorU32(background), rounding);
  // A range with negative values fills from zero, any other from its left end.
  const double origin = input.range.min < 0.0 ? sliderFraction(input.range, 0.0) : 0.0;
  const double place = sliderFraction(input.range, asNumber(value));
  const float left = low.x + width * static_cast<float>(std::min(origin, place));
  const float right = low.x + width * static_cast<float>(std::max(origin, place));
  if (right - left > rounding) {
    canvas.AddRectFilled({left, low.y}, {right, high.y}, ImGui::GetColorU32(palette().accentFill), rounding);
  }
  const float half = 1.5F * context.scale;
  const float handle = std::clamp(low.x + width * static_cast<float>(place), low.x + half, high.x - half);
  const std::string text = shownNumber(input, asNumber(value), width);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at{high.x - size.x - ImGui::GetStyle().FramePadding.x, low.y + ImGui::GetStyle().FramePadding.y};
  // Where the handle meets the number, only its foot is drawn, so that the number can be read.
  const float top = handle + half < at.x ? low.y : std::min(at.y + size.y, high.y - half);
  canvas.AddRectFilled({handle - half, top}, {handle + half, high.y},
                       ImGui::GetColorU32(active ? palette().text : palette().accent), half);
  canvas.AddText(at, ImGui::GetColorU32(palette().text), text.c_str());
}

/// Says that a typed number became another one. Empty when it did not, and for a text that is no number.
text::Sentence changeOf(const std::string& typed, const settings::SettingValue& value) {
  const std::optional<double> number = text::parseNumber(typed);
  if (!number || *number == asNumber(value)) {
    return {};
  }
  return text::Sentence("{} is not allowed here. The nearest allowed value is {}", typed, settings::formatValue(value));
}

Edit typing(PanelContext& context, const SliderInput& input, const settings::SettingValue& value) {
  TypedText& typed = context.memory.typed;
  if (typed.frames++ == 0) {
    ImGui::SetKeyboardFocusHere();
  }
  const bool confirmed = ImGui::InputText("##typed", &typed.text,
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool left = ImGui::IsItemDeactivated() || (typed.frames > 4 && !ImGui::IsItemActive());
  if (!confirmed && !left) {
    return {.value = value};
  }
  Edit edit{.finished = true, .value = value};
  if (confirmed || !ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
    try {
      edit.value = input.typed(typed.text);
      edit.changed = edit.value != value;
      if (const text::Sentence change = changeOf(typed.text, edit.value); !change.empty()) {
        context.output.hint = change;
      }
    } catch (const messages::SentenceError& refusal) {
      context.output.hint = refusal.sentence();
    } catch (const messages::UsageError& error) {
      context.output.hint = text::Sentence::verbatim(error.what());
    }
  }
  typed = {};
  return edit;
}

}  // namespace

int nearestAllowed(const settings::IntegerField& field, double value) {
  const double inside = std::clamp(value, static_cast<double>(field.min), static_cast<double>(field.max));
  return static_cast<int>(std::lround(inside));
}

settings::SettingValue typedValue(const settings::SettingInfo& info, const settings::Settings& settings,
                                  const std::string& text) {
  settings::Settings changed = settings;
  try {
    settings::assignSettingText(changed, info, text);
    return settings::settingValue(changed, info);
  } catch (const messages::UsageError&) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || *end != '\0' || !std::isfinite(number)) {
      throw;
    }
    return allowedValue(info, settings, number);
  }
}

double nearestInRange(double typed, double min, double max) {
  return std::isfinite(typed) ? std::clamp(typed, min, max) : min;
}

text::Sentence rangeNote(const char* title, double typed, double min, double max) {
  if (typed >= min && typed <= max) {
    return {};
  }
  const auto inWords = [](double number) { return fmt::format("{:.6g}", number); };
  return text::Sentence("{} must be a number from {} to {}, so {} became {}", text::Sentence(title), inWords(min),
                        inWords(max), inWords(typed), inWords(nearestInRange(typed, min, max)));
}

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

SliderInput sliderOf(const settings::SettingInfo& info, const settings::Settings& settings,
                     const text::Catalogue& texts) {
  const std::string unit = info.unit == "-" ? std::string(info.unit) : texts(unitInWords(info.unit));
  SliderInput input{.key = std::string(info.key),
                    .range = {},
                    .format = numberFormat("%.4g", unit),
                    .nearest = [&](double value) { return allowedValue(info, settings, value); },
                    .typed = [&](const std::string& text) { return typedValue(info, settings, text); }};
  if (const auto* integer = std::get_if<settings::IntegerField>(&info.field)) {
    constexpr int many = 32;  // above this the slider is logarithmic
    input.range = {static_cast<double>(integer->min), static_cast<double>(integer->max), integer->max > many};
    input.format = numberFormat("%.0f", unit);
  } else {
    input.range =
        commonRange(std::get<settings::NumberField>(info.field), std::get<double>(settings::defaultValue(info)));
  }
  return input;
}

Edit numberSlider(PanelContext& context, const SliderInput& input, const settings::SettingValue& value) {
  if (context.memory.typed.key == input.key) {
    return typing(context, input, value);
  }
  ImGui::InvisibleButton("##value", {ImGui::CalcItemWidth(), ImGui::GetFrameHeight()});
  Edit edit{.finished = ImGui::IsItemDeactivated(), .value = value};
  if (ImGui::IsItemActivated() && ImGui::GetIO().KeyCtrl) {
    context.memory.typed = {.key = input.key, .text = settings::formatValue(value), .frames = 0};
  } else if (ImGui::IsItemActive()) {
    const float width = ImGui::GetItemRectSize().x;
    const double fraction = static_cast<double>((ImGui::GetMousePos().x - ImGui::GetItemRectMin().x) / width);
    edit.value = input.nearest(roundedForDisplay(sliderValue(input.range, fraction)));
    edit.changed = edit.value != value;
  }
  paint(context, input, edit.value);
  return edit;
}

}  // namespace drape::ui
