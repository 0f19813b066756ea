#include "report/sections/stretch_limit_view.hpp"

#include "report/number_text.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace drape::report::sections {
namespace {

constexpr double millimetres = 1e3;
constexpr double percent = 100.0;
constexpr double milliseconds = 1e-3;

std::string scaled(const ReportRow& row, const char* key, double factor) {
  return text::figure(factor * numberIn(row, key));
}

std::string clothOf(const ReportRow& row) {
  return row.value("scene", "") + ", " + sizeText(resolutionIn(row));
}

TextTable tableOf(const std::string& cloth, const ReportRows& rows) {
  TextTable table{cloth,
                  {"preset", "limit [%]", "ms per frame, to 0.5 s / to 1.5 s", "stiffness lowest / at rest [%]",
                   "difference at 0.5 s, mean / max [mm]", "jitter at 0.5 s [mm]", "at rest, mean / max [mm]",
                   "jitter at rest [mm]", "strain largest / at rest [%]", "speed at rest [mm/s]", "note"},
                  {}};
  const auto pairOf = [](const ReportRow& row, const char* first, const char* second, double factor) {
    return scaled(row, first, factor) + " / " + scaled(row, second, factor);
  };
  for (const ReportRow& row : rows) {
    const std::string note = limitNote(row);
    table.rows.push_back({row.value("material", ""), scaled(row, "strain_limit", percent),
                          pairOf(row, "us_per_frame", "us_per_frame_later", milliseconds),
                          pairOf(row, "stiffness_lowest", "stiffness_rest", percent),
                          pairOf(row, "moved_mean", "moved_max", millimetres), scaled(row, "noise_moved", millimetres),
                          pairOf(row, "rest_mean", "rest_max", millimetres), scaled(row, "noise_rest", millimetres),
                          pairOf(row, "strain_largest", "strain_rest", percent), scaled(row, "speed_rest", millimetres),
                          note});
    table.tones.push_back(note.empty() ? Tone::None : Tone::Bad);
  }
  return table;
}

/// The difference at rest over the cost, a curve for each preset.
Plot plotOf(const std::string& cloth, const std::string& name, const ReportRows& rows) {
  Plot plot{"stretch-limit-" + name,
            cloth + ": difference to full stiffness at rest",
            {"strain limit [%]", Scale::Logarithmic},
            {"mean difference [mm]", Scale::Logarithmic},
            {}};
  std::map<std::string, Curve> curves;
  for (const ReportRow& row : rows) {
    Curve& curve = curves[row.value("material", "")];
    curve.label = row.value("material", "");
    if (numberIn(row, "strain_limit") > 0.0) {
      curve.points.push_back({percent * numberIn(row, "strain_limit"), millimetres * numberIn(row, "rest_mean")});
    }
  }
  for (auto& [preset, curve] : curves) {
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace

std::string limitNote(const ReportRow& row) {
  constexpr double rounding = 1.001;
  const double limit = numberIn(row, "strain_limit");
  if (!(limit > 0.0)) {
    return {};
  }
  if (numberIn(row, "stiffness_rest") < 1.0 && numberIn(row, "strain_rest") > limit) {
    return "above the limit at rest";
  }
  const bool lowered = numberIn(row, "stiffness_lowest") < 1.0;
  const double largest = numberIn(row, "strain_largest");
  return lowered && largest > limit && largest > rounding * numberIn(row, "strain_largest_full")
             ? "above the limit while moving"
             : std::string();
}

std::vector<Block> showStretchLimit(const ReportOptions&, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "With 'auto.strain' above 0, 'auto' lowers the stretch stiffness of a fabric as far as its cost budget needs and "
      "the strain stays below this limit. Here the budget is so small that the limit alone decides. The difference is "
      "the distance of the vertices from a run of 'auto' with full stiffness and its default budget, after 0.5 s of "
      "motion and at rest. The jitter is the mean distance of a second such run, from a start that differs by up to "
      "0.001 mm: smaller differences are meaningless, because the cloth comes to rest in other folds. The strain is "
      "the one along warp or weft that one triangle in 100 exceeds. A row is red where a lowered stiffness strains the "
      "cloth by more than the limit and by more than full stiffness does. A frame is 1/60 s; its time is the mean over "
      "the first 0.5 s, and over the next second, in float on one thread, without contact. 'corners' is a sheet of "
      "1 m that hangs from four corners, 'tshirt' a T-shirt of 2,014 vertices that hangs from its shoulders."});
  std::map<std::string, ReportRows> cloths;
  for (const ReportRow& row : rows) {
    cloths[clothOf(row)].push_back(row);
  }
  for (const auto& [cloth, own] : cloths) {
    blocks.emplace_back(plotOf(cloth, own.front().value("scene", ""), own));
    blocks.emplace_back(tableOf(cloth, own));
  }
  return blocks;
}

}  // namespace drape::report::sections
