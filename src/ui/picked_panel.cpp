#include "render/picking.hpp"
#include "text/number_text.hpp"
#include "ui/panels.hpp"
#include "ui/time_plot.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace drape::ui {
namespace {

constexpr float titleWidth = 11.0F;  // of the column with the names of the fields [heights of the text]
constexpr const char* widestValue = "-1.234e-10";

ImVec4 colourOf(std::size_t pick) {
  const fields::ScreenColour& colour = render::pickColours()[pick];
  return {colour[0], colour[1], colour[2], 1.0F};
}

std::string titleOf(const PanelContext& context, const sim::fields::FieldInfo& field) {
  return context.texts(field.title) + " [" + context.texts(unitInWords(field.unit)) + "]";
}

float widthOfTitles(const PanelContext& context) {
  float widest = titleWidth * ImGui::GetTextLineHeight();
  for (const sim::fields::FieldInfo& field : sim::fields::fieldTable()) {
    widest = std::max(widest, ImGui::CalcTextSize(titleOf(context, field).c_str()).x);
  }
  return widest;
}

std::string valueText(double value) {
  constexpr double rounding = 1e-9;  // values that are only the rounding error of 0, in all units
  constexpr int digits = 4;
  return std::isfinite(value) ? text::figure(std::abs(value) < rounding ? 0.0 : value, digits) : "\u2013";
}

void rightAligned(const std::string& text) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, room));
  ImGui::TextUnformatted(text.c_str());
}

void headRow(const PanelContext& context, std::span<const int> vertices) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  mutedText(context.texts("Vertex"));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, colourOf(i));
    rightAligned(std::to_string(vertices[i]));
    ImGui::PopStyleColor();
  }
}

/// A field and its values. A click chooses it for the plot.
void fieldRow(PanelContext& context, std::size_t index, const PickedVertices::Sample& now, std::size_t count) {
  const auto table = sim::fields::fieldTable();
  const sim::fields::FieldInfo& field = table[index];
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (ImGui::Selectable((titleOf(context, field) + "###" + std::string(field.name)).c_str(),
                        context.memory.plotsPicked && context.memory.plottedField == index,
                        ImGuiSelectableFlags_SpanAllColumns)) {
    context.memory.plottedField = index;
    context.memory.plotsPicked = true;
  }
  context.buttons["picked." + std::string(field.name)] = lastItemRect();
  explainItem(context, "picked." + std::string(field.name), field.help);
  for (std::size_t i = 0; i < count; ++i) {
    ImGui::TableNextColumn();
    rightAligned(valueText(now.values[i * table.size() + index]));
  }
}

void valueTable(PanelContext& context, const PickedVertices& picked) {
  const float valueWidth = ImGui::CalcTextSize(widestValue).x;
  const std::size_t count = picked.vertices().size();
  if (!ImGui::BeginTable("values", static_cast<int>(count) + 1, ImGuiTableFlags_SizingFixedFit)) {
    return;
  }
  ImGui::TableSetupColumn("field", ImGuiTableColumnFlags_WidthFixed, widthOfTitles(context));
  for (std::size_t i = 0; i < count; ++i) {
    ImGui::TableSetupColumn(std::to_string(i).c_str(), ImGuiTableColumnFlags_WidthFixed, valueWidth);
  }
  headRow(context, picked.vertices());
  for (std::size_t f = 0; f < sim::fields::fieldTable().size(); ++f) {
    fieldRow(context, f, picked.now(), count);
  }
  ImGui::EndTable();
}

void valuePlot(const PanelContext& context, const PickedVertices& picked) {
  const auto table = sim::fields::fieldTable();
  const std::size_t f = context.memory.plottedField;
  std::vector<PlotSeries> series;
  for (std::size_t i = 0; i < picked.vertices().size(); ++i) {
    PlotSeries& each = series.emplace_back();
    each.name = text::Sentence("Vertex {}", picked.vertices()[i]);
    each.colour = colourOf(i);
    for (const PickedVertices::Sample& sample : picked.samples()) {
      each.points.push_back({sample.time, sample.values[i * table.size() + f]});
    }
  }
  seriesPlot(context, table[f].title, context.texts(unitInWords(table[f].unit)), series, table[f].neutral != 0.0,
             picked.now().time);
}

}  // namespace

void pickedPanel(PanelContext& context, const UiRect& view) {
  PickedVertices& picked = context.memory.picked;
  if (picked.vertices().empty() || picked.samples().empty()) {
    return;
  }
  const float margin = 12.0F * context.scale;
  beginCorner(context, "overlay.picked",
              {static_cast<float>(view.x + view.width) - margin, static_cast<float>(view.y) + margin}, {1.0F, 0.0F},
              OverlayStack::Mouse::Taken);
  valueTable(context, picked);
  if (context.memory.plotsPicked) {
    valuePlot(context, picked);
  }
  ImGui::Spacing();
  float width = 4.6F * ImGui::GetTextLineHeight();
  for (const char* word : {"Plot", "No plot", "Write CSV", "Clear"}) {
    width = widthOfButton(context, word, width);
  }
  if (iconButton(context, "plot_picked", Icon::None, context.memory.plotsPicked ? "No plot" : "Plot", width)) {
    context.memory.plotsPicked = !context.memory.plotsPicked;
  }
  explainItem(context, "plot_picked",
              "Plots the quantity that you clicked over 20 seconds. A line marks the present time.");
  ImGui::SameLine();
  if (iconButton(context, "write_csv", Icon::None, "Write CSV", width)) {
    context.output.requests.emplace_back(UiAction::SaveProbes);
  }
  explainItem(context, "write_csv",
              "Writes the values of the plot, over 20 seconds, to a new file in the current folder.");
  ImGui::SameLine();
  if (iconButton(context, "clear_picked", Icon::None, "Clear", width)) {
    picked.clear();
  }
  explainItem(context, "clear_picked", "Removes all marks (Esc).");
  endCorner();
}

}  // namespace drape::ui
