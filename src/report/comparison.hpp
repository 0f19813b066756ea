#pragma once

#include "report/report_document.hpp"

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace drape {

/// What moved between two reports, as it stands in report.json under "comparison":
///
/// - `commit`, `date`: of the older one
/// - `times_compared`: false when it was made on another processor
/// - `judged`: how many figures stand in both and can be judged; `unjudged`: times of which one report has no repeat
/// - `moved`: section, cell, row (its place in the cell), figure, before, after, verdict
///
/// The two have passed requireComparable. A time has moved when the samples of its rounds in the two reports do not
/// overlap and the medians differ by more than `timeTolerance`; verdict "faster" or "slower". Errors have no noise: the
/// same source gives the same bits. They have moved when they differ by more than `errorTolerance`; "better" or
/// "worse", or "other" where neither is meant.
[[nodiscard]] nlohmann::ordered_json compareReports(const nlohmann::ordered_json& older, const Report& report);

inline constexpr double timeTolerance = 0.05;   ///< of the older median [-]
inline constexpr double errorTolerance = 1e-6;  ///< of the older figure [-]

inline constexpr std::string_view comparisonTitle = "What moved since an earlier report";

/// The comparison in words and as a table, for the report and the terminal.
[[nodiscard]] std::vector<Block> showComparison(const nlohmann::ordered_json& comparison);

}  // namespace drape
