// The rows of the box of selected vertices for the keyframes of pins.
#include "scene/toml_reader.hpp"
#include "ui/number_slider.hpp"
#include "ui/panels.hpp"
#include "ui/pin_keys.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace drape::ui {
namespace {

using sim::contact::BodyMotion;
using sim::contact::Keyframe;

constexpr double arrivalTime = 1.0;      // until a change that does not arrive is forgotten [s]
constexpr double minGap = 0.001;         // between two keyframes [s]
constexpr double maxTime = 1e4;          // [s]
constexpr double maxDisplacement = 1e3;  // [m]
constexpr double maxTurn = 36e3;         // [degrees]

/// Numbers that a drag or Ctrl+click changes, with a label at the left.
struct NumberRow {
  const char* name;
  const char* label;
  const char* format;
  const char* help;
  double speed;  // for each pixel of a drag
};

constexpr NumberRow timeRow{"time", "Time", "%.3f s",
                            "When the pins are there. A drag changes it, Ctrl+click types it.", 0.01};
constexpr NumberRow moveRow{"move", "Move", "%.3f", "Displacement from the start along x, y and z [m].", 0.002};
constexpr NumberRow turnRow{"turn", "Turn", "%.1f",
                            "Rotation about the centre of the pins: axis times angle [degrees].", 0.5};

bool numbersChanged(PanelContext& context, const NumberRow& row, float width, double* values, int count, double low,
                    double high) {
  const float label = 3.4F * ImGui::GetFontSize();
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(context.texts(row.label).c_str());
  ImGui::SameLine(left + label);
  ImGui::SetNextItemWidth(width - label);
  const std::string id = fmt::format("##keys.{}", row.name);
  const bool changed =
      ImGui::DragScalarN(id.c_str(), ImGuiDataType_Double, values, count, static_cast<float>(row.speed), &low, &high,
                         row.format, ImGuiSliderFlags_NoRoundToFormat);
  text::Sentence note;
  for (int i = 0; i < count; ++i) {
    note.append(". ", rangeNote(row.label, values[i], low, high));
    values[i] = nearestInRange(values[i], low, high);
  }
  // A number acts while it is typed; what is said about it is about the whole of it.
  if (changed) {
    context.memory.typedNote = note;
  }
  if (ImGui::IsItemDeactivated() && !context.memory.typedNote.empty()) {
    context.output.hint = std::exchange(context.memory.typedNote, {});
  }
  const std::string name = fmt::format("keys.{}", row.name);
  context.buttons[name] = lastItemRect();
  explainItem(context, name, row.help);
  return changed;
}

/// What the user chose last, until the snapshot has it.
const BodyMotion& presentOf(PanelContext& context, const std::vector<int>& pins, const BodyMotion& inForce) {
  std::optional<PendingKeyframes>& pending = context.memory.pendingKeyframes;
  const bool isThis = pending && pending->scene == context.snapshot.scene && pending->pins == pins;
  if (isThis && (pending->motion == inForce || ImGui::GetTime() - pending->since > arrivalTime)) {
    pending.reset();
    return inForce;
  }
  return isThis ? pending->motion : inForce;
}

void choose(PanelContext& context, const std::vector<int>& pins, const BodyMotion& motion) {
  context.memory.pendingKeyframes = PendingKeyframes{context.snapshot.scene, pins, motion, ImGui::GetTime()};
  context.output.commands.emplace_back(withMotion(context.snapshot, pins, motion));
}

/// A button for each keyframe, in as many lines as they need.
void keyButtons(PanelContext& context, const std::vector<Keyframe>& keys, float width) {
  const float right = ImGui::GetCursorPosX() + width;
  const ImGuiStyle& style = ImGui::GetStyle();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string word = fmt::format("{:.4g} s", keys[i].time);
    const float needed = ImGui::CalcTextSize(word.c_str()).x + 2.0F * style.FramePadding.x;
    if (i > 0) {
      ImGui::SameLine();
      if (ImGui::GetCursorPosX() + needed > right) {
        ImGui::NewLine();
      }
    }
    if (iconButton(context, fmt::format("key.{}", i), Icon::None, text::Sentence::verbatim(word), needed,
                   i == context.memory.chosenKey)) {
      context.memory.chosenKey = i;
    }
  }
}

/// The numbers of the chosen keyframe. @return whether the user changed them
bool keyRows(PanelContext& context, std::vector<Keyframe>& keys, float width) {
  const std::size_t chosen = context.memory.chosenKey;
  Keyframe& key = keys[chosen];
  const double earliest = chosen == 0 ? 0.0 : keys[chosen - 1].time + minGap;
  const double latest = chosen + 1 == keys.size() ? maxTime : keys[chosen + 1].time - minGap;
  Vec3 degrees = key.rotation / scene::degree;
  bool changed =
      numbersChanged(context, timeRow, width, &key.time, 1, std::min(earliest, key.time), std::max(latest, key.time));
  changed |= numbersChanged(context, moveRow, width, key.position.data(), 3, -maxDisplacement, maxDisplacement);
  if (numbersChanged(context, turnRow, width, degrees.data(), 3, -maxTurn, maxTurn)) {
    key.rotation = degrees * scene::degree;
    changed = true;
  }
  return changed;
}

/// Buttons for all keyframes and for the chosen one. @return whether the user changed them
bool keyActions(PanelContext& context, BodyMotion& motion, float width) {
  bool changed = false;
  const float third = (width - 2.0F * ImGui::GetStyle().ItemSpacing.x) / 3.0F;
  bool loop = motion.loop;
  ImGui::BeginDisabled(motion.keyframes.size() < 2);
  if (ImGui::Checkbox(labelOf(context, "Loop", "keys.loop").c_str(), &loop)) {
    motion.loop = loop;
    changed = true;
  }
  ImGui::EndDisabled();
  context.buttons["keys.loop"] = lastItemRect();
  explainItem(context, "keys.loop", "The motion begins anew after the last keyframe.");
  ImGui::SameLine(ImGui::GetCursorPosX() + third + ImGui::GetStyle().ItemSpacing.x);
  if (iconButton(context, "remove_key", Icon::None, "Remove", third)) {
    motion.keyframes.erase(motion.keyframes.begin() + static_cast<std::ptrdiff_t>(context.memory.chosenKey));
    motion.loop = motion.loop && motion.keyframes.size() > 1;
    changed = true;
  }
  explainItem(context, "remove_key", "Removes the chosen keyframe.");
  ImGui::SameLine();
  if (iconButton(context, "remove_keys", Icon::None, "Remove all", third)) {
    motion.keyframes.clear();
    motion.loop = false;
    changed = true;
  }
  explainItem(context, "remove_keys", "The pins stay at their start from now on.");
  return changed;
}

}  // namespace

void pinKeyRows(PanelContext& context, const std::vector<int>& selected, float width) {
  const std::vector<int> pins = pinnedOf(context.snapshot, selected);
  if (pins.empty()) {
    return;
  }
  const text::Sentence word("Keyframe at {} s", fmt::format("{:.3f}", context.snapshot.time));
  if (iconButton(context, "add_key", Icon::None, word, width)) {
    const session::SetPinPathsCommand command = withKeyframeHere(context.snapshot, pins);
    const std::vector<Keyframe>& keys = command.paths.back().motion.keyframes;
    const auto here = std::ranges::find(keys, context.snapshot.time, &Keyframe::time);
    context.memory.chosenKey = static_cast<std::size_t>(here - keys.begin());
    context.output.commands.emplace_back(command);
  }
  explainItem(context, "add_key",
              "From now on the selected pins are at this time where they are now. A drag moves them.");
  const BodyMotion* inForce = commonMotion(context.snapshot, pins);
  if (inForce == nullptr) {
    return;
  }
  BodyMotion motion = presentOf(context, pins, *inForce);
  if (motion.keyframes.empty()) {
    return;
  }
  context.memory.chosenKey = std::min(context.memory.chosenKey, motion.keyframes.size() - 1);
  keyButtons(context, motion.keyframes, width);
  bool changed = keyRows(context, motion.keyframes, width);
  changed |= keyActions(context, motion, width);
  if (changed) {
    choose(context, pins, motion);
  }
}

}  // namespace drape::ui
