#pragma once

#include "report/section.hpp"

namespace drape::report::sections {

/// The runs of a scene with different self-collision, side by side: pairs, cost, energy and rest. Scenes that ran with
/// one kind only are left out.
[[nodiscard]] TextTable selfCollisionTable(const ReportRows& rows);

/// What exact self-collision left, and what it costs compared with the hash, in words.
[[nodiscard]] std::string aboutExact(const ReportRows& rows);

}  // namespace drape::report::sections
