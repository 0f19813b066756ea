#pragma once

#include "report/section.hpp"

namespace drape::report::sections {

/// The tables and texts of the collision section, from its rows.
[[nodiscard]] std::vector<Block> showCollision(const ReportOptions& options, const ReportRows& rows);

}  // namespace drape::report::sections
