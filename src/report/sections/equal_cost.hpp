#pragma once

#include "report/section.hpp"

namespace drape {

/// How far the method that chooses for itself may be behind the best other one at equal cost [-].
inline constexpr double mostBehind = 1.5;

/// `auto` on one cloth at one time, held against the others at equal cost: each of its calm settings against the
/// calm setting of another method that has the least error and takes no more time. An error below what can be known
/// (noise floor, difference of the reference, 1 nm) counts as that. A row tells how many settings had such a rival
/// (`points`), how many are at most 1.5 times as wrong (`within`) or at most as wrong (`best`), and the one that is
/// furthest behind (`ratio`, with its rival's `by_method`, `by_setting` and `by_error_mean`; null without points).
/// @param rows of work_precision, all of that cloth and time  @param row what names them; taken over into the answer
[[nodiscard]] ReportRow equalCostRow(const ReportRows& rows, ReportRow row);

/// The same in words and as a table of the cloths where some setting is further behind than `mostBehind`.
[[nodiscard]] std::vector<Block> equalCostBlocks(const ReportRows& answers);

}  // namespace drape
