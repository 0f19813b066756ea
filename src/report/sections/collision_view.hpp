#pragma once

#include "report/section.hpp"

namespace drape::report::sections {

/// Target of body contact for 1,000 triangles in a step, on one core [us].
inline constexpr double targetOfBodyContact = 150.0;

/// The tables and texts of the collision section, from its rows.
[[nodiscard]] std::vector<Block> showCollision(const ReportOptions& options, const ReportRows& rows);

/// "fold (33x33)", the scene and the grid of a row.
[[nodiscard]] std::string sceneText(const ReportRow& row);

}  // namespace drape::report::sections
