// The box of the mode Sew: what is made, the picked borders, and what can be done with them.
#include "messages/sentence_error.hpp"
#include "text/number_text.hpp"
#include "ui/button_row.hpp"
#include "ui/number_slider.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace drape::ui {
namespace {

using Kind = SewingRequest::Kind;

/// The usual lengths of an elastic band, for its slider [-]. A typed one may be in the range of scene files.
constexpr SliderRange usualLengths{0.5, 1.0, false};

void ask(PanelContext& context, SewingRequest request) {
  context.output.requests.emplace_back(request);
}

const char* helpOf(const SewingView& sewing) {
  switch (sewing.extent) {
    case BorderExtent::Corners:
      return "Click an open border. It picks the part between two corners.";
    case BorderExtent::Points:
      return "Click where a part of a border starts, then where it ends. Shift takes the longer way.";
    case BorderExtent::Whole:
      return sewing.kind == SewingKind::Seam ? "Click an open border. The clicked vertices are sewn together first."
                                             : "Click an open border. It picks all of it.";
  }
  return "";
}

void kindRow(PanelContext& context, const SewingView& sewing, float width) {
  static constexpr std::array<Segment, 2> kinds{{{"seam", "Seam"}, {"band", "Elastic band"}}};
  const auto chosen = static_cast<std::size_t>(sewing.kind);
  ImGui::SetNextItemWidth(width);
  const std::size_t next = segments(context, "sewing.kind", kinds, chosen);
  if (next != chosen) {
    ask(context, {.kind = Kind::UseKind, .sewing = static_cast<SewingKind>(next)});
  }
}

void extentRow(PanelContext& context, const SewingView& sewing, float width) {
  static constexpr std::array<Segment, 3> extents{
      {{"corners", "To corners"}, {"points", "Two points"}, {"whole", "Whole"}}};
  const auto chosen = static_cast<std::size_t>(sewing.extent);
  ImGui::SetNextItemWidth(width);
  const std::size_t next = segments(context, "sewing.extent", extents, chosen);
  if (next != chosen) {
    ask(context, {.kind = Kind::UseExtent, .extent = static_cast<BorderExtent>(next)});
  }
}

/// "Blue: 33 vertices, 0.72 m".
void sideRow(const PanelContext& context, const SewingView& sewing, std::size_t index) {
  const char* colour = index == 0 ? "Blue" : "Orange";
  if (index >= sewing.sides.size()) {
    mutedText(context.texts("{}: pick a border", text::Sentence(colour)));
    return;
  }
  const PickedSide& side = sewing.sides[index];
  ImGui::TextUnformatted(
      context
          .texts("{}: {} vertices, {}", text::Sentence(colour), side.vertices, text::formatQuantity(side.length, "m"))
          .c_str());
}

/// What the user should know before the borders are sewn.
void seamNote(PanelContext& context, const SewingView& sewing) {
  if (!sewing.problem.empty()) {
    mutedText(context.texts(sewing.problem), palette().warning);
  } else if (sewing.sides.size() == 2 && sewing.sides[0].vertices != sewing.sides[1].vertices) {
    const auto [fewer, more] = std::minmax(sewing.sides[0].vertices, sewing.sides[1].vertices);
    const auto open = static_cast<long long>(more - fewer);
    mutedText(context.texts(text::Sentence(text::plural(open, "{} vertex stays open: a small slit remains.",
                                                        "{} vertices stay open: small slits remain."),
                                           open)),
              palette().warning);
  } else if (context.snapshot.paused &&
             std::ranges::any_of(sewing.seams, [](const SeamLines& seam) { return !seam.isWelded; })) {
    mutedText(context.texts("The clock is paused. Seams close while it runs (Space)."));
  }
}

void endButton(PanelContext& context, ButtonRow& row) {
  if (row.button(context, "end_sewing", "Done (Esc)", true)) {
    ask(context, {.kind = Kind::End});
  }
}

void seamRows(PanelContext& context, const SewingView& sewing, float width) {
  sideRow(context, sewing, 0);
  sideRow(context, sewing, 1);
  seamNote(context, sewing);
  ButtonRow row(context, width, {"Sew", "Flip", "Done (Esc)"});
  const bool hasBoth = sewing.sides.size() == 2;
  if (row.button(context, "sew", "Sew", hasBoth && sewing.problem.empty(), true)) {
    ask(context, {.kind = Kind::Sew});
  }
  explainItem(context, "sew", "Draws the two borders together in a second, and welds them.");
  if (row.button(context, "flip_seam", "Flip", hasBoth)) {
    ask(context, {.kind = Kind::Flip});
  }
  explainItem(context, "flip_seam", "Turns the direction of the second border, so that the other ends meet.");
  endButton(context, row);
}

void lengthRow(PanelContext& context, const SewingView& sewing, float width) {
  const std::string key = "sewing.length";
  double& length = context.memory.bandLength;
  mutedText(context.texts("Length over that of the border"));
  ImGui::SetNextItemWidth(width);
  const auto changed = bandSlider(context, key, sewing.bandLength.value_or(length));
  explainItem(context, key,
              text::Sentence("Length of the band over that of the border at rest. Ctrl+click types it: {} to {}.",
                             fmt::format("{}", scene::minBandLength), fmt::format("{}", scene::maxBandLength)));
  length = changed.value_or(length);
  if (changed && sewing.bandLength) {
    ask(context, {.kind = Kind::SetBand, .length = length});
  }
}

void bandRows(PanelContext& context, const SewingView& sewing, float width) {
  sideRow(context, sewing, 0);
  lengthRow(context, sewing, width);
  if (!sewing.problem.empty()) {
    mutedText(context.texts(sewing.problem), palette().warning);
  }
  ButtonRow row(context, width, {"Set band", "Done (Esc)"});
  if (row.button(context, "set_band", "Set band", !sewing.sides.empty() && !sewing.bandLength, true)) {
    ask(context, {.kind = Kind::SetBand, .length = context.memory.bandLength});
  }
  explainItem(context, "set_band", "Sews an elastic band of this length to the border.");
  endButton(context, row);
}

double typedLength(const std::string& typed) {
  const auto value = text::parseNumber(typed);
  if (!value || !std::isfinite(*value) || *value < scene::minBandLength || *value > scene::maxBandLength) {
    throw messages::SentenceError(text::Sentence("The length of a band must be a number from {} to {}, not '{}'",
                                                 fmt::format("{}", scene::minBandLength),
                                                 fmt::format("{}", scene::maxBandLength), typed));
  }
  return *value;
}

}  // namespace

std::optional<double> bandSlider(PanelContext& context, const std::string& key, double length) {
  const SliderInput input{key, usualLengths, "%.2f",
                          [](double value) -> settings::SettingValue {
                            constexpr double steps = 100.0;
                            const double rounded = std::round(steps * value) / steps;
                            return std::clamp(rounded, usualLengths.min, usualLengths.max);
                          },
                          [](const std::string& typed) -> settings::SettingValue { return typedLength(typed); }};
  ImGui::PushID(key.c_str());
  const Edit edit = numberSlider(context, input, length);
  context.widgets[key] = lastItemRect();
  ImGui::PopID();
  return edit.changed ? std::optional(std::get<double>(edit.value)) : std::nullopt;
}

void sewingBox(PanelContext& context, const UiRect& view) {
  if (!context.stats.sewing) {
    return;
  }
  const SewingView& sewing = *context.stats.sewing;
  drawSewing(context, sewing, view);
  beginModeBox(context, "overlay.sewing", view);
  const float width = modeBoxWidth(context, view);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  kindRow(context, sewing, width);
  extentRow(context, sewing, width);
  mutedText(context.texts(helpOf(sewing)));
  if (sewing.kind == SewingKind::Seam) {
    seamRows(context, sewing, width);
  } else {
    bandRows(context, sewing, width);
  }
  ImGui::PopTextWrapPos();
  endCorner();
}

}  // namespace drape::ui
