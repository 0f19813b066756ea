// The box of the mode Place: the thing, the tool, and its placement in numbers.
#include "messages/error.hpp"
#include "text/number_text.hpp"
#include "ui/button_row.hpp"
#include "ui/names_in_words.hpp"
#include "ui/number_slider.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace drape::ui {
namespace {

using Kind = PlacingRequest::Kind;

/// A number of a placement, as the box shows it.
struct PlacingNumber {
  std::string key;
  std::string title;  ///< for messages
  std::string format;
  std::string unit;  ///< for messages
  SliderRange range;
  double min = 0.0;  ///< of a typed number
  double max = 0.0;
  double value = 0.0;
};

/// What the user did with a number in this frame.
struct PlacingEdit {
  std::optional<double> value;  ///< the new one
  bool finished = false;        ///< whether the user let go of it
};

void ask(PanelContext& context, PlacingRequest request) {
  context.output.requests.emplace_back(std::move(request));
}

const char* helpOf(PlacingTool tool) {
  switch (tool) {
    case PlacingTool::Move:
      return "Drag an arrow, a square or the middle. Ctrl: steps of 1 cm.";
    case PlacingTool::Turn:
      return "Drag a ring. Ctrl: steps of 5 degrees.";
    case PlacingTool::Scale:
      return "Drag the square. Ctrl: steps of 10 %. Cloth is made in this size.";
  }
  return "";
}

double parsedNumber(const PlacingNumber& number, const std::string& typed) {
  const auto value = text::parseNumber(typed);
  if (!value || !std::isfinite(*value) || *value < number.min || *value > number.max) {
    throw messages::UsageError(fmt::format("{} must be a number from {} to {}{}, not '{}'", number.title, number.min,
                                           number.max, number.unit, typed));
  }
  return *value;
}

PlacingEdit numberField(PanelContext& context, const PlacingNumber& number, float width) {
  const SliderInput input{
      number.key, number.range, number.format,
      [&](double value) -> settings::SettingValue { return std::clamp(value, number.range.min, number.range.max); },
      [&](const std::string& typed) -> settings::SettingValue { return parsedNumber(number, typed); }};
  ImGui::PushID(number.key.c_str());
  ImGui::SetNextItemWidth(width);
  const Edit edit = numberSlider(context, input, number.value);
  context.widgets[number.key] = lastItemRect();
  ImGui::PopID();
  return {edit.changed ? std::optional(std::get<double>(edit.value)) : std::nullopt, edit.finished};
}

/// Shows a placement while the user drags a number, and gives it to the thing at the end.
void take(PanelContext& context, const PlacingEdit& edit, const std::optional<scene::Placement>& placement) {
  if (placement) {
    ask(context, {.kind = edit.finished ? Kind::Place : Kind::Preview, .placement = *placement});
  } else if (edit.finished) {
    ask(context, {.kind = Kind::Keep});
  }
}

constexpr std::array<const char*, 3> axisNames{"x", "y", "z"};

/// A row of three numbers. @return the new vector when the user changed one; the edit says whether that is finished
std::optional<Vec3> vectorRow(PanelContext& context, const char* title, const PlacingNumber& common, const Vec3& value,
                              float boxWidth, PlacingEdit& edit) {
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (boxWidth - 2.0F * gap) / 3.0F;
  mutedText(context.texts(title));
  std::optional<Vec3> changed;
  for (int axis = 0; axis < 3; ++axis) {
    const char* name = axisNames[static_cast<std::size_t>(axis)];
    PlacingNumber number = common;
    number.key += std::string(".") + name;
    number.title += std::string(" ") + name;
    number.value = value[axis];
    const PlacingEdit one = numberField(context, number, width);
    explainItem(context, number.key,
                text::Sentence("{} {}. Drag, or Ctrl+click and type: {} to {}{}.", text::Sentence(common.title), name,
                               fmt::format("{}", number.min), fmt::format("{}", number.max), number.unit));
    if (one.value) {
      changed = value;
      (*changed)[axis] = *one.value;
    }
    edit.finished = edit.finished || one.finished;
    if (axis < 2) {
      ImGui::SameLine(0.0F, gap);
    }
  }
  return changed;
}

void positionRow(PanelContext& context, const PlacingView& placing, float width) {
  constexpr double near = 3.0;   // [m]
  constexpr double far = 100.0;  // [m]
  PlacingEdit edit;
  const auto changed = vectorRow(context, "Position of the middle [m]",
                                 {"placing.position", "Position", "%.3f", " m", {-near, near, false}, -far, far, 0.0},
                                 placing.middle, width, edit);
  std::optional<scene::Placement> placement;
  if (changed) {
    placement = scene::movedTo(placing.placement, placing.rawMiddle, *changed);
  }
  take(context, edit, placement);
}

void rotationRow(PanelContext& context, const PlacingView& placing, float width) {
  constexpr double half = 180.0;   // [degrees]
  constexpr double whole = 360.0;  // [degrees]
  PlacingEdit edit;
  const auto changed =
      vectorRow(context, "Rotation, axis times angle [degrees]",
                {"placing.rotation", "Rotation", "%.1f", " \u00B0", {-half, half, false}, -whole, whole, 0.0},
                placing.placement.rotation, width, edit);
  std::optional<scene::Placement> placement;
  if (changed) {
    placement = scene::withRotation(placing.placement, placing.rawMiddle, *changed);
  }
  take(context, edit, placement);
}

void scaleRow(PanelContext& context, const PlacingView& placing, float width) {
  mutedText(context.texts("Scale"));
  const std::string refusal = scene::whyNotScaled(context.snapshot.scene->description, placing.thing);
  if (!refusal.empty()) {
    ImGui::TextUnformatted(context.texts(refusal).c_str());
    return;
  }
  const PlacingEdit edit = numberField(context,
                                       {"placing.scale",
                                        "Scale",
                                        "%.3f",
                                        "",
                                        {0.1, 10.0, true},
                                        scene::minPlacementScale,
                                        scene::maxPlacementScale,
                                        placing.placement.scale},
                                       width);
  explainItem(
      context, "placing.scale",
      "Factor of the size in the scene. A cloth is larger at rest then, so it weighs more and is not stretched.");
  std::optional<scene::Placement> placement;
  if (edit.value) {
    placement = scene::scaledAbout(placing.placement, placing.rawMiddle, *edit.value);
  }
  take(context, edit, placement);
}

void thingRow(PanelContext& context, const PlacingView& placing, float width) {
  const scene::SceneDescription& description = context.snapshot.scene->description;
  const std::vector<scene::Placeable> things = scene::placeablesOf(description);
  const std::string name = context.texts(inWords(description, placing.thing));
  if (things.size() == 1) {
    ImGui::TextUnformatted(context.texts("Place {}", name).c_str());
    return;
  }
  ImGui::AlignTextToFramePadding();
  const std::string place = context.texts("Place");
  ImGui::TextUnformatted(place.c_str());
  ImGui::SameLine();
  ImGui::SetNextItemWidth(width - ImGui::CalcTextSize(place.c_str()).x - ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::BeginCombo("##thing", name.c_str())) {
    for (const scene::Placeable& thing : things) {
      if (ImGui::Selectable(context.texts(inWords(description, thing)).c_str(), thing == placing.thing)) {
        ask(context, {.kind = Kind::Choose, .thing = thing});
      }
      context.buttons["placing.thing=" + scene::nameOf(description, thing)] = lastItemRect();
    }
    ImGui::EndCombo();
  }
  context.buttons["placing.thing"] = lastItemRect();
}

void toolRow(PanelContext& context, const PlacingView& placing, float width) {
  static constexpr std::array<Segment, 3> tools{{{"move", "Move"}, {"turn", "Turn"}, {"scale", "Scale"}}};
  const auto chosen = static_cast<std::size_t>(placing.tool);
  ImGui::SetNextItemWidth(width);
  const std::size_t next = segments(context, "placing.tool", tools, chosen);
  if (next != chosen) {
    ask(context, {.kind = Kind::UseTool, .tool = static_cast<PlacingTool>(next)});
  }
}

/// The unit and the up axis of its file, if the user can change them.
void readingRows(PanelContext& context, const PlacingView& placing, float width) {
  if (!placing.reading) {
    return;
  }
  scene::ReadingChoice reading = *placing.reading;
  mutedText(context.texts("Unit of its file"));
  ImGui::SetNextItemWidth(width);
  reading.unit = unitChoice(context, "placing.unit", reading.unit);
  mutedText(context.texts("Up axis of its file"));
  ImGui::SetNextItemWidth(width);
  reading.up = upChoice(context, "placing.up", reading.up);
  if (reading != *placing.reading) {
    ask(context, {.kind = Kind::Read, .reading = reading});
  }
}

/// Puts the cloth on a body, and dresses the body from there.
void dressRow(PanelContext& context, float width) {
  if (!hasBodyToDress(context.snapshot)) {
    return;
  }
  ButtonRow row(context, width, {"To the body", "Dress"});
  if (row.button(context, "place_on_body", "To the body")) {
    context.output.requests.emplace_back(UiAction::PlaceOnBody);
  }
  explainItem(context, "place_on_body",
              "Puts the cloth where the body would wear it: by neck, sleeves or waist, else by its size.");
  if (row.button(context, "dress_placed", "Dress")) {
    context.output.requests.emplace_back(UiAction::Dress);
  }
  explainItem(context, "dress_placed",
              "Removes all intersections of cloth and body from here. If the body cannot wear it here, the cloth gets "
              "another place.");
}

void buttonRow(PanelContext& context, float width) {
  ButtonRow row(context, width, {"To ground", "Restore", "Done (Esc)"});
  if (row.button(context, "place_on_ground", "To ground")) {
    ask(context, {.kind = Kind::OnGround});
  }
  explainItem(context, "place_on_ground",
              "Lets the lowest point touch the ground. Cloth keeps its contact offset from it.");
  if (row.button(context, "restore_placement", "Restore")) {
    ask(context, {.kind = Kind::Restore});
  }
  explainItem(context, "restore_placement", "Puts it back to where the scene file has it.");
  if (row.button(context, "end_placing", "Done (Esc)", true, true)) {
    ask(context, {.kind = Kind::End});
  }
}

}  // namespace

void placeRow(PanelContext& context) {
  beginRow(context, "Place");
  if (iconButton(context, "place", Icon::None, "Move, turn, scale (G)", ImGui::CalcItemWidth(),
                 context.stats.placing.has_value())) {
    if (context.stats.placing) {
      ask(context, {.kind = Kind::End});
    } else {
      context.output.requests.emplace_back(UiAction::Place);
    }
  }
  explainItem(context, "place", "Moves, turns and scales a cloth or a body. The scene starts anew with it.");
}

void placingBox(PanelContext& context, const UiRect& view) {
  if (!context.stats.placing) {
    return;
  }
  const PlacingView& placing = *context.stats.placing;
  drawGizmo(context, placing, view);
  beginModeBox(context, "overlay.placing", view);
  const float width = modeBoxWidth(context, view);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  thingRow(context, placing, width);
  toolRow(context, placing, width);
  mutedText(context.texts(helpOf(placing.tool)));
  positionRow(context, placing, width);
  rotationRow(context, placing, width);
  scaleRow(context, placing, width);
  readingRows(context, placing, width);
  dressRow(context, width);
  buttonRow(context, width);
  ImGui::PopTextWrapPos();
  endCorner();
}

}  // namespace drape::ui
