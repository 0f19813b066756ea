#pragma once

#include "report/section.hpp"

#include <functional>
#include <string>

namespace drape::report {

/// Callbacks of a run of the report. All may be empty.
struct RunHooks {
  std::function<bool()> stopped;  ///< called often; true stops the run
  /// Called before each cell: the section, and the finished and total expected work [s].
  std::function<void(std::string_view section, double done, double total)> progress;
  /// Called before a cell is measured again. True when there is no time left for repeats.
  std::function<bool()> outOfTime;
  std::function<void(const SectionRows&)> measured;  ///< called after each cell with all rows so far
};

/// Throws UsageError for an unknown section in `options.only`.
void requireSections(const ReportOptions& options);

/// Measures the cells that are not in `rows` and adds them: all cells of all sections once, before any is repeated.
/// Repeats are thus far apart in time, and a run that is short of time lacks only repeats. Each row gets `cell`, the
/// key of its cell, and `rounds`, the number of its measurements. Rows are in the order of the plan. Returns false when
/// it was stopped. Throws UsageError for an unknown section in `options.only`.
bool measureSections(const ReportOptions& options, SectionRows& rows, const RunHooks& hooks);

/// The same with other sections than those of the table.
bool measureSections(std::span<const Section> sections, const ReportOptions& options, SectionRows& rows,
                     const RunHooks& hooks);

}  // namespace drape::report
