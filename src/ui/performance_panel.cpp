#include "ui/panels.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <algorithm>

namespace drape {
namespace {

const ImVec4& paceColour(const Snapshot& snapshot) {
  const bool slow = !snapshot.paused && snapshot.realTimeFactor > 0.0 &&
                    snapshot.realTimeFactor < 0.95 * snapshot.settings.playback.speed;
  return slow ? palette().warning : palette().text;
}

}  // namespace

void historyPlot(const PanelContext& context, const History& history) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 4.0F};
  ImGui::Dummy(size);
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  canvas.AddRectFilled(low, {low.x + size.x, low.y + size.y}, ImGui::GetColorU32(palette().field),
                       ImGui::GetStyle().FrameRounding);
  float top = 0.0F;
  for (int i = 0; i < history.count(); ++i) {
    top = std::max(top, history.at(i));
  }
  if (history.count() < 2 || top <= 0.0F) {
    return;
  }
  const float room = size.y - ImGui::GetFontSize() * 1.4F;  // the legend has its own strip at the top
  const auto place = [&](int i) {
    const float x = low.x + size.x * static_cast<float>(i) / static_cast<float>(History::capacity - 1);
    return ImVec2(x, low.y + size.y - 2.0F * context.scale - room * history.at(i) / top);
  };
  const ImU32 fill = ImGui::GetColorU32(palette().accentFill);
  const float floor = low.y + size.y;
  // Without smoothing the pieces of the filled area meet without a seam.
  const ImDrawListFlags smooth = canvas.Flags;
  canvas.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (int i = 0; i + 1 < history.count(); ++i) {
    const ImVec2 a = place(i);
    const ImVec2 b = place(i + 1);
    canvas.AddQuadFilled({a.x, floor}, a, b, {b.x, floor}, fill);
  }
  canvas.Flags = smooth;
  for (int i = 0; i < history.count(); ++i) {
    canvas.PathLineTo(place(i));
  }
  canvas.PathStroke(ImGui::GetColorU32(palette().accent), ImDrawFlags_None, 1.5F * context.scale);
  const std::string legend = "step time, peak " + formatDuration(static_cast<double>(top) * 1e-3);
  canvas.AddText({low.x + 6.0F * context.scale, low.y + 2.0F * context.scale}, ImGui::GetColorU32(palette().muted),
                 legend.c_str());
}

void performancePanel(PanelContext& context) {
  if (!beginSection(context, "Performance", true)) {
    return;
  }
  const Snapshot& snapshot = context.snapshot;
  valueRow(context, "Frame", formatDuration(context.stats.frameSeconds));
  valueRow(context, "Step", formatDuration(snapshot.stepSeconds));
  valueRow(context, "Pace", describePace(snapshot), paceColour(snapshot));
  historyPlot(context, context.memory.stepTimes);
  valueRow(context, "Kinetic energy", formatQuantity(snapshot.energy.kinetic, "J"));
  valueRow(context, "Elastic energy", formatQuantity(snapshot.energy.elastic, "J"));
  valueRow(context, "Potential energy", formatQuantity(snapshot.energy.potential, "J"));
  valueRow(context, "Total energy", formatQuantity(snapshot.energy.total(), "J"));
  valueRow(context, "Largest stretch", formatQuantity(snapshot.maxStretch * 100.0, "%"));
  endSection();
}

}  // namespace drape
