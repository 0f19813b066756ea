// The rows of the section Scene for seams and elastic bands.
#include "ui/panels.hpp"
#include "ui/sewing_mode.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>

#include <array>
#include <string>

namespace drape::ui {
namespace {

void startRow(PanelContext& context) {
  beginRow(context, "Sew");
  static constexpr std::array<Segment, 2> kinds{{{"seam", "Seam (S)"}, {"band", "Elastic band"}}};
  constexpr std::size_t none = kinds.size();
  const std::size_t chosen = context.stats.sewing ? static_cast<std::size_t>(context.stats.sewing->kind) : none;
  const std::size_t next = segments(context, "sew", kinds, chosen);
  if (next != chosen) {
    context.output.requests.emplace_back(next == 0 ? UiAction::Sew : UiAction::SetBand);
  }
}

/// A button at the right end of a row. @return whether it was pressed
bool removeButton(PanelContext& context, const std::string& name, const char* help) {
  const float width = widthOfButton(context, "Remove", 0.0F);
  ImGui::SameLine(0.0F, 0.0F);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width);
  const bool pressed = ImGui::Button(labelOf(context, "Remove", name).c_str(), {width, 0.0F});
  context.buttons["button." + name] = lastItemRect();
  explainItem(context, name, help);
  return pressed;
}

/// "33 pairs, welded".
text::Sentence seamInWords(std::size_t pairs, bool isWelded) {
  const auto count = static_cast<long long>(pairs);
  return isWelded ? text::Sentence(text::plural(count, "{} pair, welded", "{} pairs, welded"), pairs)
                  : text::Sentence(text::plural(count, "{} pair, open", "{} pairs, open"), pairs);
}

void seamRow(PanelContext& context, std::size_t index) {
  const session::Snapshot& snapshot = context.snapshot;
  ImGui::PushID(static_cast<int>(index));
  const UiRect row = beginRow(context, text::Sentence("Seam {}", index + 1));
  if (hoversRow(row)) {
    context.memory.hoveredSeam = index;
  }
  ImGui::TextUnformatted(
      context.texts(seamInWords((*snapshot.seams)[index].pairs.size(), snapshot.isWelded[index] != 0)).c_str());
  if (removeButton(context, fmt::format("remove_seam.{}", index),
                   "Removes the seam. A welded one opens again, where it is.")) {
    context.output.commands.emplace_back(withoutSeam(snapshot, index));
  }
  ImGui::PopID();
}

void bandRow(PanelContext& context, std::size_t cloth, std::size_t index, std::size_t number) {
  const session::Snapshot& snapshot = context.snapshot;
  const std::string key = fmt::format("band.{}", number);
  ImGui::PushID(key.c_str());
  beginRow(context, text::Sentence("Band {}", number + 1));
  const float button = widthOfButton(context, "Remove", 0.0F);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemInnerSpacing.x);
  if (const auto length = bandSlider(context, key, snapshot.sewing->bands[cloth][index].length)) {
    context.output.commands.emplace_back(withBandLength(snapshot, cloth, index, *length));
  }
  explainItem(context, key, "Length of the elastic band over that of its border at rest.");
  if (removeButton(context, fmt::format("remove_band.{}", number), "Removes the elastic band.")) {
    context.output.commands.emplace_back(withoutBand(snapshot, cloth, index));
  }
  ImGui::PopID();
}

}  // namespace

void sewingRows(PanelContext& context) {
  startRow(context);
  context.memory.hoveredSeam.reset();
  for (std::size_t i = 0; i < context.snapshot.seams->size(); ++i) {
    seamRow(context, i);
  }
  std::size_t number = 0;
  for (std::size_t cloth = 0; cloth < context.snapshot.sewing->bands.size(); ++cloth) {
    for (std::size_t i = 0; i < context.snapshot.sewing->bands[cloth].size(); ++i) {
      bandRow(context, cloth, i, number++);
    }
  }
}

}  // namespace drape::ui
