// What a motion depends on, in the section Performance.
#include "messages/error_sources_text.hpp"
#include "messages/length_text.hpp"
#include "ui/panels.hpp"
#include "ui/text.hpp"
#include "ui/widgets.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drape::ui {
namespace {

constexpr const char* comparisonHelp =
    "Runs the scene from its start in the background: with this method, and with an accurate one on this mesh, on a "
    "mesh of four times the triangles, with a material that is stiffer by 10 %, and from a displaced start. Shows how "
    "far the cloth then moves away; for the mesh twice as far, since its error halves with its cells. This can take "
    "minutes.";

struct Row {
  const char* label;
  double sim::ErrorSources::*distance;
  sim::ErrorSource source;
};

constexpr std::array rows{Row{"Method", &sim::ErrorSources::method, sim::ErrorSource::Method},
                          Row{"Mesh", &sim::ErrorSources::mesh, sim::ErrorSource::Mesh},
                          Row{"Material, 10 % stiffer", &sim::ErrorSources::material, sim::ErrorSource::Material},
                          Row{"Start, 1 \u00B5m away", &sim::ErrorSources::start, sim::ErrorSource::Chaos}};

std::string distanceText(double metres) {
  constexpr double smallest = 1e-6;  // [m]
  if (!std::isfinite(metres)) {
    return "-";
  }
  return metres < smallest ? "< 0.001 mm" : text::formatQuantity(metres * 1e3, "mm");
}

void resultRows(const PanelContext& context, const std::vector<sim::ErrorSources>& sources) {
  const sim::ErrorSources& last = sources.back();
  mutedText(context.texts(messages::inWords(last)));
  for (const sim::ErrorSources& at : sources) {
    mutedText(context.texts("Mean distance after {} s", messages::brief(at.time)));
    for (const Row& row : rows) {
      const bool dominates = sim::dominantSource(at) == row.source;
      valueRow(context, row.label, distanceText(at.*row.distance), dominates ? palette().warning : palette().text);
    }
  }
}

}  // namespace

void errorSourcesRows(PanelContext& context) {
  const ErrorComparisonView& view = context.stats.errors;
  const Wording word =
      view.share ? Wording(text::Sentence("Cancel the comparison ({} %)", static_cast<int>(100.0 * *view.share)))
                 : Wording("Compare the sources of error");
  if (ImGui::Button(labelOf(context, word, "compare_errors").c_str(), {ImGui::GetContentRegionAvail().x, 0.0F})) {
    context.output.requests.emplace_back(view.share ? UiAction::CancelComparison : UiAction::CompareErrors);
  }
  context.buttons["compare_errors"] = lastItemRect();
  explainItem(context, "compare_errors", comparisonHelp);
  if (!view.sources.empty()) {
    resultRows(context, view.sources);
  }
}

}  // namespace drape::ui
