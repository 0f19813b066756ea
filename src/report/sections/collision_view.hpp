#pragma once

#include "report/section.hpp"

namespace drape {

/// The collision section's tables and what they say in words, from its rows.
[[nodiscard]] std::vector<Block> showCollision(const ReportOptions& options, const ReportRows& rows);

}  // namespace drape
