#pragma once

#include "report/blocks.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape::report {

/// One's own cloth, for which the report finds a method.
struct OwnCloth {
  std::shared_ptr<const scene::Scene> scene;
  std::vector<std::string> settings;  ///< "key=value", which the scene already has
  double budget = 0.0;                ///< computing time for each frame of 1/60 s [ms]
  double seconds = 0.5;               ///< of motion, at the end of which errors count [s]
};

/// The options of a report.
struct ReportOptions {
  bool quick = false;                ///< fewer and smaller cells
  std::string scene;                 ///< the scene for comparing methods; empty: the report's own scenes
  int threads = 1;                   ///< threads of a step, in sections that do not need one thread
  std::vector<std::string> only;     ///< sections to measure; empty: all
  std::optional<OwnCloth> own = {};  ///< the cloth of `scene`, if the report is about that alone
};

/// A row of a section's array in report.json.
using ReportRow = nlohmann::ordered_json;
using ReportRows = std::vector<ReportRow>;

/// The rows of each section, by its name.
using SectionRows = std::map<std::string, ReportRows, std::less<>>;

/// Thrown from a measurement when the user stops it; the rows of the current cell are dropped.
struct ReportStopped {};

/// The context of a cell during its measurement.
struct CellContext {
  const ReportRows& section;                ///< all rows of the section so far, including this cell's last round
  const ReportRows& own;                    ///< the rows of this cell's last round; empty in the first
  std::function<void()> checkStop = [] {};  ///< call it every few ms; throws ReportStopped
};

/// A part of a section that is measured separately, and skipped when an earlier run of the report has it.
struct Cell {
  std::string key;      ///< constant for the same options, and unique in the section
  double weight = 1.0;  ///< approximate duration of a round [s]
  std::function<ReportRows(const CellContext&)> measure;
};

/// A section measures its cells in rounds: all cells once, then all again. Repeats are thus apart in time, and a
/// disturbance of the machine does not affect one method only.
struct SectionPlan {
  std::vector<Cell> cells;
  int rounds = 1;
};

/// A section of the report.
struct Section {
  std::string_view name;                                ///< of its array in report.json, and for --only
  std::string_view title;                               ///< heading
  SectionPlan (*plan)(const ReportOptions&) = nullptr;  ///< null when it measures nothing
  /// Shows the rows, which may be incomplete or missing.
  std::vector<Block> (*show)(const ReportOptions&, const ReportRows&) = nullptr;
  /// Derives its rows from those of other sections; null when it measures them.
  ReportRows (*derive)(const SectionRows&) = nullptr;
};

/// The name of the section about a cloth with its contact, which alone is measured for one's own cloth.
inline constexpr std::string_view budgetSection = "budget";

/// All sections, in the order of the report.
[[nodiscard]] std::span<const Section> sectionTable();

}  // namespace drape::report
