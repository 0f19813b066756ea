#pragma once

#include "report/section.hpp"

#include <functional>
#include <string>

namespace drape {

/// What stands around a run of the report. All may be empty.
struct RunHooks {
  std::function<bool()> stopped;  ///< asked often; true ends the run
  /// Called before each cell: the section, and of all expected work what is done and what there is [s].
  std::function<void(std::string_view section, double done, double total)> progress;
  /// Asked before a cell is measured again. True: once is enough, for there is no time left.
  std::function<bool()> outOfTime;
  std::function<void(const SectionRows&)> measured;  ///< called after each cell with all there is
};

/// Measures the cells that are not in `rows` already and adds them: all cells of all sections once, before any is
/// measured a second time, so that repeats are far apart and a run that is short of time lacks nothing but repeats.
/// Each row gets `cell`, the key of its cell, and `rounds`, how often it was measured. Rows stand in the order of the
/// plan. Returns false when it was stopped. Throws UsageError for a section in `options.only` that does not exist.
bool measureSections(const ReportOptions& options, SectionRows& rows, const RunHooks& hooks);

/// The same with other sections than those of the table.
bool measureSections(std::span<const Section> sections, const ReportOptions& options, SectionRows& rows,
                     const RunHooks& hooks);

}  // namespace drape
