#pragma once

#include "report/report_document.hpp"

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace drape::report {

/// The changes between two reports, as stored in report.json under "comparison":
///
/// - `commit`, `date`: of the older one
/// - `times_compared`: false when the older one was made on another processor
/// - `compared`: number of values that are in both and comparable; `not_compared`: times without repeats in one report
/// - `moved`: section, cell, row (its index in the cell), figure, before, after, verdict
///
/// Both reports have passed requireComparable. A time has changed when the samples of the two reports do not overlap
/// and the medians differ by more than `timeTolerance`; its verdict is "faster" or "slower". Errors have no noise: the
/// same source gives the same bits. They have changed when they differ by more than `errorTolerance`; the verdict is
/// "better", "worse", or "other" for values without a better direction.
[[nodiscard]] nlohmann::ordered_json compareReports(const nlohmann::ordered_json& older, const Report& report);

inline constexpr double timeTolerance = 0.05;   ///< of the older median [-]
inline constexpr double errorTolerance = 1e-6;  ///< of the older figure [-]

inline constexpr std::string_view comparisonTitle = "Changes since an earlier report";

/// The comparison in words and as a table, for the report and the terminal.
[[nodiscard]] std::vector<Block> showComparison(const nlohmann::ordered_json& comparison);

}  // namespace drape::report
