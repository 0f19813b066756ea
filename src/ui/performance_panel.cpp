#include "messages/accuracy_text.hpp"
#include "ui/panels.hpp"
#include "ui/text.hpp"
#include "ui/time_plot.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <array>

namespace drape::ui {
namespace {

template <double (sim::EnergyBalance::*part)() const>
std::optional<double> balanceOf(const MeasureSample& sample) {
  return sample.balance ? std::optional(((*sample.balance).*part)()) : std::nullopt;
}

void energyPlot(const PanelContext& context) {
  const auto& colours = palette().plot;
  const std::array curves{
      PlotCurve{"Kinetic", colours[0], [](const MeasureSample& s) { return std::optional(s.energy.kinetic); }},
      PlotCurve{"Elastic", colours[1], [](const MeasureSample& s) { return std::optional(s.energy.elastic); }},
      PlotCurve{"Potential", colours[2], [](const MeasureSample& s) { return std::optional(s.energy.potential); }},
      PlotCurve{"Total", colours[3], [](const MeasureSample& s) { return std::optional(s.energy.total()); }}};
  timePlot(context, "Energy", "J", curves);
}

void balancePlot(const PanelContext& context) {
  const auto& colours = palette().plot;
  const std::array curves{PlotCurve{"Damping", colours[0], balanceOf<&sim::EnergyBalance::damping>},
                          PlotCurve{"Air", colours[2], balanceOf<&sim::EnergyBalance::air>},
                          PlotCurve{"Mouse", colours[1], balanceOf<&sim::EnergyBalance::attachment>},
                          PlotCurve{"Contact", colours[3], balanceOf<&sim::EnergyBalance::contact>},
                          PlotCurve{"Method", colours[4], balanceOf<&sim::EnergyBalance::integrator>}};
  timePlot(context, "Energy added or removed so far", "J", curves);
}

/// A gap where there is no check or its error cannot be known.
std::optional<double> checkedError(const MeasureSample& sample) {
  constexpr double millimetres = 1e3;
  return sample.accuracy && sim::isErrorKnown(*sample.accuracy) ? std::optional(millimetres * sample.accuracy->error)
                                                                : std::nullopt;
}

void errorRows(PanelContext& context) {
  const auto samples = context.memory.measures.samples();
  accuracyText(context);
  if (std::ranges::any_of(samples, [](const MeasureSample& sample) { return checkedError(sample).has_value(); })) {
    const std::array errors{PlotCurve{"Last check", palette().plot[3], checkedError}};
    timePlot(context, "Position error in 0.2 s", "mm", errors);
  }
}

void ghostPlot(const PanelContext& context) {
  const std::array curves{PlotCurve{"Now", palette().ghost, [](const MeasureSample& s) {
                                      return s.ghostDistance ? std::optional(*s.ghostDistance * 1e3) : std::nullopt;
                                    }}};
  timePlot(context, "Mean distance of the ghost", "mm", curves);
}

}  // namespace

void accuracyText(const PanelContext& context) {
  if (context.snapshot.accuracy) {
    mutedText(context.texts("Position error {}", messages::inWords(*context.snapshot.accuracy)));
  }
}

void historyPlot(const PanelContext& context, const History& history) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 4.0F};
  ImGui::Dummy(size);
  ImDrawList& canvas = *ImGui::GetWindowDrawList();
  canvas.AddRectFilled(low, {low.x + size.x, low.y + size.y}, ImGui::GetColorU32(palette().field),
                       ImGui::GetStyle().FrameRounding);
  float top = 0.0F;
  for (std::size_t i = 0; i < history.count(); ++i) {
    top = std::max(top, history.at(i));
  }
  if (history.count() < 2 || top <= 0.0F) {
    return;
  }
  const float plotHeight = size.y - ImGui::GetFontSize() * 1.4F;  // the legend has its own strip at the top
  const auto place = [&](std::size_t i) {
    const float x = low.x + size.x * static_cast<float>(i) / static_cast<float>(History::capacity - 1);
    return ImVec2(x, low.y + size.y - 2.0F * context.scale - plotHeight * history.at(i) / top);
  };
  const ImU32 fill = ImGui::GetColorU32(palette().accentFill);
  const float floor = low.y + size.y;
  // Without antialiasing the pieces of the filled area meet without a seam.
  const ImDrawListFlags smooth = canvas.Flags;
  canvas.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (std::size_t i = 0; i + 1 < history.count(); ++i) {
    const ImVec2 a = place(i);
    const ImVec2 b = place(i + 1);
    canvas.AddQuadFilled({a.x, floor}, a, b, {b.x, floor}, fill);
  }
  canvas.Flags = smooth;
  for (std::size_t i = 0; i < history.count(); ++i) {
    canvas.PathLineTo(place(i));
  }
  canvas.PathStroke(ImGui::GetColorU32(palette().accent), ImDrawFlags_None, 1.5F * context.scale);
  const std::string legend = context.texts("step time, peak {}", text::formatDuration(static_cast<double>(top) * 1e-3));
  canvas.AddText({low.x + 6.0F * context.scale, low.y + 2.0F * context.scale}, ImGui::GetColorU32(palette().muted),
                 legend.c_str());
}

void performanceRows(PanelContext& context) {
  const session::Snapshot& snapshot = context.snapshot;
  valueRow(context, "picture|Frame", text::formatDuration(context.stats.frameSeconds));
  valueRow(context, "Step", text::formatDuration(snapshot.stepSeconds));
  if (const double seconds = snapshot.stepReport.secondsOfContact(); seconds > 0.0) {
    valueRow(context, "Part of contact", text::formatDuration(seconds));
  }
  if (snapshot.ghost) {
    valueRow(context, "Step of the ghost", text::formatDuration(snapshot.ghost->stepSeconds));
  }
  valueRow(context, "Pace", describePace(snapshot, context.texts),
           isTooSlow(snapshot) ? palette().warning : palette().text);
  valueRow(context, "Largest stretch", text::formatQuantity(snapshot.maxStretch * 100.0, "%"));
  historyPlot(context, context.memory.stepTimes);
  if (snapshot.ghost) {
    ghostPlot(context);
  }
  errorRows(context);
  errorSourcesRows(context);
  if (snapshot.stepReport.choice) {
    choicePlots(context);
  }
  energyPlot(context);
  if (snapshot.balance) {
    balancePlot(context);
  }
}

}  // namespace drape::ui
