#include "text/number_text.hpp"
#include "ui/export_request.hpp"
#include "ui/number_slider.hpp"
#include "ui/panels.hpp"
#include "ui/widgets.hpp"

#include <fmt/core.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace drape::ui {
namespace {

constexpr std::array<ExportFormat, 16> formatTable{{
    {ExportKind::Frame, "frame.obj", "OBJ", ".obj"},
    {ExportKind::Frame, "frame.ply", "PLY", ".ply"},
    {ExportKind::Frame, "frame.glb", "glTF", ".glb"},
    {ExportKind::Frame, "frame.usda", "USD", ".usda"},
    {ExportKind::Frame, "frame.csv", "CSV", ".csv"},
    {ExportKind::Motion, "motion.pc2", "PC2, point cache", ".pc2"},
    {ExportKind::Motion, "motion.mdd", "MDD, point cache", ".mdd"},
    {ExportKind::Motion, "motion.glb", "glTF, morph targets", ".glb"},
    {ExportKind::Motion, "motion.usda", "USD, time samples", ".usda"},
    {ExportKind::Motion, "motion.csv", "CSV", ".csv"},
    {ExportKind::Motion, "motion.obj", "OBJ, a file for each frame", ".obj", true},
    {ExportKind::Motion, "motion.ply", "PLY, a file for each frame", ".ply", true},
    {ExportKind::Film, "film.mp4", "MP4", ".mp4"},
    {ExportKind::Film, "film.webm", "WebM", ".webm"},
    {ExportKind::Film, "film.gif", "GIF", ".gif"},
    {ExportKind::Film, "film.png", "PNG, a file for each frame", ".png", true},
}};

/// The format of a kind that comes first.
const ExportFormat& firstOf(ExportKind kind) {
  return *std::ranges::find(exportFormats(), kind, &ExportFormat::kind);
}

void kindRow(PanelContext& context, ExportRequest& choice) {
  static constexpr std::array<Segment, 3> kinds{{{"frame", "export|Frame"}, {"motion", "Motion"}, {"film", "Film"}}};
  beginRow(context, "Contents");
  const auto chosen = static_cast<std::size_t>(choice.format->kind);
  const std::size_t next = segments(context, "export.kind", kinds, chosen);
  if (next != chosen) {
    choice.format = &firstOf(static_cast<ExportKind>(next));
  }
}

void formatRow(PanelContext& context, ExportRequest& choice) {
  beginRow(context, "Format");
  ImGui::PushID("export.format");
  if (ImGui::BeginCombo("##format", context.texts(choice.format->title).c_str(), ImGuiComboFlags_HeightLarge)) {
    for (const ExportFormat& format : exportFormats()) {
      if (format.kind != choice.format->kind) {
        continue;
      }
      if (ImGui::Selectable(labelOf(context, format.title, format.name).c_str(), &format == choice.format)) {
        choice.format = &format;
      }
      context.buttons["export.format=" + std::string(format.name)] = lastItemRect();
    }
    ImGui::EndCombo();
  } else {
    context.buttons["export.format"] = lastItemRect();
  }
  ImGui::PopID();
}

void fileRow(PanelContext& context, ExportRequest& choice) {
  beginRow(context, "File");
  const std::string hint = context.texts("a free name {}", choice.format->ending);
  ImGui::InputTextWithHint("##export.file", hint.c_str(), &choice.file);
  context.buttons["export.file"] = lastItemRect();
  explainItem(context, "export.file",
              choice.format->isSequence
                  ? "A name or a path. {frame:4} in it becomes the number of the frame, with four digits. Without a "
                    "name: a new folder in the current one. Existing files stay."
                  : "A name or a path. Without a name: a free name in the current folder. Existing files stay.");
}

/// A number that is typed, within limits. One beyond them becomes the nearest, and a hint says so.
void numberField(PanelContext& context, const std::string& name, const char* title, double& value, double min,
                 double max) {
  ImGui::InputDouble(("##" + name).c_str(), &value, 0.0, 0.0, "%.6g");
  context.buttons[name] = lastItemRect();
  if (ImGui::IsItemActive()) {
    return;
  }
  if (const text::Sentence note = rangeNote(title, value, min, max); !note.empty()) {
    context.output.hint = note;
  }
  value = nearestInRange(value, min, max);
}

void timeRows(PanelContext& context, ExportRequest& choice) {
  static constexpr std::array<Segment, 2> starts{{{"scene", "Start"}, {"present", "Now"}}};
  beginRow(context, "From");
  choice.start = static_cast<ExportRequest::Start>(
      segments(context, "export.start", starts, static_cast<std::size_t>(choice.start)));
  beginRow(context, "Seconds");
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const std::string to = context.texts("to");
  const float words = ImGui::CalcTextSize(to.c_str()).x + 2.0F * gap;
  const float width = 0.5F * (ImGui::CalcItemWidth() - words);
  ImGui::SetNextItemWidth(width);
  numberField(context, "export.from", "The time of the first frame", choice.from, 0.0, longestExport);
  explainItem(context, "export.from",
              "The time of the first frame. The scene is simulated from its start, or from the present state, with the "
              "present settings, pins and bodies. The window goes on meanwhile.");
  ImGui::SameLine(0.0F, gap);
  ImGui::TextUnformatted(to.c_str());
  ImGui::SameLine(0.0F, gap);
  ImGui::SetNextItemWidth(width);
  numberField(context, "export.to", "The time of the last frame", choice.to, 0.0, longestExport);
  explainItem(context, "export.to", "The time of the last frame, up to an hour.");
  beginRow(context, "Frame rate");
  numberField(context, "export.rate", "Frame rate", choice.rate, minExportRate, maxExportRate);
  explainItem(context, "export.rate",
              "Frames per second of simulated time, at exact times. The time step becomes shorter where a frame is not "
              "a whole number of "
              "steps.");
}

void sizeRow(PanelContext& context, ExportRequest& choice) {
  beginRow(context, "Size");
  const auto words = [](const PictureSize& size) { return fmt::format("{} x {}", size.width, size.height); };
  if (ImGui::BeginCombo("##export.size", words({choice.width, choice.height}).c_str())) {
    for (const PictureSize& size : pictureSizes) {
      if (ImGui::Selectable(words(size).c_str(), size.width == choice.width && size.height == choice.height)) {
        choice.width = size.width;
        choice.height = size.height;
      }
      context.buttons[fmt::format("export.size={}x{}", size.width, size.height)] = lastItemRect();
    }
    ImGui::EndCombo();
  } else {
    context.buttons["export.size"] = lastItemRect();
  }
}

}  // namespace

std::span<const ExportFormat> exportFormats() {
  return formatTable;
}

void exportRows(PanelContext& context) {
  ExportRequest& choice = context.memory.exported;
  kindRow(context, choice);
  formatRow(context, choice);
  fileRow(context, choice);
  if (choice.format->kind != ExportKind::Frame) {
    timeRows(context, choice);
  }
  if (choice.format->kind == ExportKind::Film) {
    sizeRow(context, choice);
  }
  if (choice.format->kind == ExportKind::Film) {
    beginRow(context, "Turntable");
    ImGui::Checkbox("##export.turns", &choice.turns);
    context.buttons["export.turns"] = lastItemRect();
    explainItem(context, "export.turns", "The camera turns once around the cloth during the film.");
  }
  const bool isRunning = context.stats.exporting.has_value();
  ImGui::BeginDisabled(isRunning);
  const float width = ImGui::GetContentRegionAvail().x;
  if (iconButton(context, "export", Icon::None, isRunning ? "An export is running" : "Export", width, true)) {
    context.output.requests.emplace_back(choice);
  }
  const UiRect row = lastItemRect();
  ImGui::EndDisabled();
  revealRow(context, std::string(exportSection), row);
}

void exportNotice(PanelContext& context, OverlayStack& stack) {
  const ExportProgress& progress = *context.stats.exporting;
  stack.begin("export");
  const std::string percent = fmt::format("{:.0f}", std::floor(100.0 * progress.share));
  const std::string words = progress.secondsLeft < 0.0
                                ? context.texts("Writing {}: {} %", progress.file, percent)
                                : context.texts("Writing {}: {} %, {} left", progress.file, percent,
                                                text::formatMinutes(progress.secondsLeft));
  ImGui::TextUnformatted(words.c_str());
  stack.progressBar(progress.share);
  if (iconButton(context, "cancel_export", Icon::None, "Cancel",
                 widthOfButton(context, "Cancel", 5.0F * ImGui::GetFontSize()))) {
    context.output.requests.emplace_back(UiAction::CancelExport);
  }
  stack.end();
}

}  // namespace drape::ui
