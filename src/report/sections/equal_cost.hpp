#pragma once

#include "report/section.hpp"

namespace drape::report::sections {

/// Acceptable ratio of the error of `auto` to that of the best other method at equal cost [-].
inline constexpr double maxErrorRatio = 1.5;

/// `auto` on one cloth at one time, compared with the others at equal cost. At the cost of each calm setting of `auto`,
/// its own smallest error within that cost is compared with the smallest error of all other methods. An error below the
/// noise level (noise floor, difference of the reference, 1 nm) counts as that level. A row has the number of costs
/// with a rival
/// (`points`), the number with at most 1.5 times its error (`within`) or at most its error (`best`), and the worst case
/// (`ratio`, with the rival's `by_method`, `by_setting` and `by_error_mean`; null without points).
/// @param rows of work_precision, all of that cloth and time  @param row names them; it is copied to the result
[[nodiscard]] ReportRow equalCostRow(const ReportRows& rows, ReportRow row);

/// The same in words and as a table of the cloths with a ratio above `maxErrorRatio`.
[[nodiscard]] std::vector<Block> equalCostBlocks(const ReportRows& answers);

}  // namespace drape::report::sections
