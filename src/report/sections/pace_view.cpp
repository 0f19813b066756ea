#include "report/sections/pace_view.hpp"

#include "report/number_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

namespace drape::report::sections {
namespace {

constexpr double percent = 100.0;
constexpr double millisecondsPerFrame = 1e3 * frameSeconds;

bool keepsPace(const ReportRow& row) {
  return row.value("ended", false) && numberIn(row, "ms_per_frame") <= millisecondsPerFrame;
}

std::string speedText(const ReportRow& row) {
  return text::figure(millisecondsPerFrame / numberIn(row, "ms_per_frame"), 2) + "x" +
         (keepsPace(row) ? "" : ", slower than the clock");
}

}  // namespace

std::vector<Block> showPace(const ReportOptions&, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  const auto kept = std::count_if(rows.begin(), rows.end(), keepsPace);
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{fmt::format(
      "Every fabric in a curtain of three resolutions, and as a T-shirt that falls onto the mannequin: CPU time of one "
      "thread for a frame of 1/60 s, over the first second of motion, with contact. 'auto' may lower the stretch "
      "stiffness while the strain stays below 1 %. The strain is the one along warp or weft that one triangle in 100 "
      "exceeds. {} of {} rows keep the pace of the clock; the others are red.",
      kept, rows.size())});
  TextTable table{"CPU time of one thread",
                  {"cloth", "vertices", "fabric", "ms per frame", "speed", "force evaluations a step",
                   "lowest stretch stiffness [%]", "strain at the end [%]"},
                  {}};
  for (const ReportRow& row : rows) {
    table.rows.push_back({row.value("scene", ""), std::to_string(row.value("vertices", 0)), row.value("material", ""),
                          figure(row, "ms_per_frame"), speedText(row), figure(row, "evaluations_per_step"),
                          text::figure(percent * numberIn(row, "stiffness_lowest")),
                          text::figure(percent * numberIn(row, "strain_last"))});
    table.tones.push_back(keepsPace(row) ? Tone::None : Tone::Bad);
  }
  blocks.emplace_back(std::move(table));
  return blocks;
}

}  // namespace drape::report::sections
