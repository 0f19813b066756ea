#pragma once

#include "report/section.hpp"

namespace drape {

/// How far the method that chooses for itself may be behind the best other one at equal cost [-].
inline constexpr double maxErrorRatio = 1.5;

/// `auto` on one cloth at one time, held against the others at equal cost: at what each of its calm settings costs, the
/// least wrong of its own calm settings that take no more time against the least wrong of all other methods'. An error
/// below what can be known (noise floor, difference of the reference, 1 nm) counts as that. A row tells at how many
/// costs there was a rival (`points`), at how many it is at most 1.5 times as wrong (`within`) or at most as wrong
/// (`best`), and where it is furthest behind (`ratio`, with the rival's `by_method`, `by_setting` and `by_error_mean`;
/// null without points).
/// @param rows of work_precision, all of that cloth and time  @param row what names them; taken over into the answer
[[nodiscard]] ReportRow equalCostRow(const ReportRows& rows, ReportRow row);

/// The same in words and as a table of the cloths where some setting is further behind than `maxErrorRatio`.
[[nodiscard]] std::vector<Block> equalCostBlocks(const ReportRows& answers);

}  // namespace drape
