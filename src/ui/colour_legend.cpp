#include "fields/colour_map.hpp"
#include "fields/shown_field.hpp"
#include "text/number_text.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace drape::ui {
namespace {

constexpr float barWidth = 17.0F;  // [heights of the text]
constexpr int colourSteps = 64;    // in the bar
constexpr int legendTicks = 5;

ImU32 packed(const fields::ScreenColour& colour) {
  return ImGui::ColorConvertFloat4ToU32({colour[0], colour[1], colour[2], 1.0F});
}

/// A value at a tick, without the digits that only rounding makes.
std::string legendNumber(const fields::ColourRange& range, double value) {
  const double extent = std::max(std::abs(range.low), std::abs(range.high));
  return text::figure(std::abs(value) < 1e-9 * extent ? 0.0 : value, 5);
}

void legendBar(const PanelContext& context, const fields::ShownField& shown) {
  const float line = ImGui::GetTextLineHeight();
  const float width = std::round(barWidth * line);
  const float height = std::round(0.7F * line);
  const float margin = std::round(1.2F * line);  // half of a label, which is centred under its tick
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy({width + 2.0F * margin, height + 1.5F * line});
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  const fields::ColourMap& map = fields::coloursOf(*shown.field);
  const auto x = [&](double place) { return at.x + margin + width * static_cast<float>(place); };
  for (int i = 0; i < colourSteps; ++i) {
    const double left = static_cast<double>(i) / colourSteps;
    const double right = static_cast<double>(i + 1) / colourSteps;
    const ImU32 from = packed(fields::colourAt(map, left));
    const ImU32 to = packed(fields::colourAt(map, right));
    canvas.AddRectFilledMultiColor({x(left), at.y}, {x(right), at.y + height}, from, to, to, from);
  }
  const ImU32 text = ImGui::GetColorU32(palette().text);
  for (int i = 0; i < legendTicks; ++i) {
    const double place = static_cast<double>(i) / (legendTicks - 1);
    const std::string label = legendNumber(shown.range, shown.range.low + place * (shown.range.high - shown.range.low));
    canvas.AddLine({std::round(x(place)), at.y + height}, {std::round(x(place)), at.y + height + 0.3F * line}, text,
                   context.scale);
    canvas.AddText({std::round(x(place) - 0.5F * ImGui::CalcTextSize(label.c_str()).x), at.y + height + 0.4F * line},
                   text, label.c_str());
  }
}

}  // namespace

void colourLegend(PanelContext& context, const UiRect& view, float above) {
  const fields::ShownField* shown = context.stats.field;
  if (shown == nullptr || shown->field == nullptr) {
    return;
  }
  const float margin = 12.0F * context.scale;
  beginCorner(context, "hint.colour_map",
              {static_cast<float>(view.x) + margin, static_cast<float>(view.y + view.height) - margin - above},
              {0.0F, 1.0F}, OverlayStack::Mouse::LetThrough);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + (barWidth + 2.4F) * ImGui::GetTextLineHeight());
  ImGui::TextUnformatted(
      (context.texts(shown->field->title) + " [" + context.texts(unitInWords(shown->field->unit)) + "]").c_str());
  if (shown->isShown()) {
    legendBar(context, *shown);
  }
  for (const std::string& sentence : {shown->problem, shown->note}) {
    if (!sentence.empty()) {
      mutedText(context.texts(sentence), palette().warning);
    }
  }
  ImGui::PopTextWrapPos();
  endCorner();
}

}  // namespace drape::ui
