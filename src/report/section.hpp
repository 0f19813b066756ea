#pragma once

#include "report/blocks.hpp"

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// How a report is made.
struct ReportOptions {
  bool quick = false;             ///< fewer and smaller cells
  std::string scene;              ///< that methods are compared on; empty: all of the report's own
  int threads = 1;                ///< that a step may use, in the sections that do not ask for one thread
  std::vector<std::string> only;  ///< sections to measure; empty: all
};

/// A row of a section's array in report.json.
using ReportRow = nlohmann::ordered_json;
using ReportRows = std::vector<ReportRow>;

/// The rows of each section, by its name.
using SectionRows = std::map<std::string, ReportRows, std::less<>>;

/// Thrown out of a measurement when the user wants it to end; what the cell has so far is dropped.
struct ReportStopped {};

/// What a cell may ask while it measures.
struct CellContext {
  const ReportRows& section;                ///< what the section has found so far, this cell's last round included
  const ReportRows& own;                    ///< this cell's rows after its last round; empty in the first
  std::function<void()> checkStop = [] {};  ///< to be called now and then (each some ms): throws ReportStopped
};

/// A part of a section that is measured by itself, and skipped when an earlier run of the report has it.
struct Cell {
  std::string key;      ///< the same in every run with the same options, and unlike all others of the section
  double weight = 1.0;  ///< how long a round takes, about [s]
  std::function<ReportRows(const CellContext&)> measure;
};

/// A section measures its cells round by round: all cells once, then all again. So repeats of the same measurement
/// are apart in time, and a disturbance of the machine does not hit one method alone.
struct SectionPlan {
  std::vector<Cell> cells;
  int rounds = 1;
};

/// How a section presents itself.
struct Section {
  std::string_view name;                                ///< of its array in report.json, and for --only
  std::string_view title;                               ///< as a heading
  SectionPlan (*plan)(const ReportOptions&) = nullptr;  ///< null when it measures nothing itself
  /// What to show of the rows, which may be incomplete or none.
  std::vector<Block> (*show)(const ReportOptions&, const ReportRows&) = nullptr;
  /// Its rows as they follow from those of the other sections; null when it measures them.
  ReportRows (*derive)(const SectionRows&) = nullptr;
};

/// Every section, in the order of the report.
[[nodiscard]] std::span<const Section> sectionTable();

}  // namespace drape
