#pragma once

#include "report/section.hpp"

#include <string_view>

namespace drape::report::sections {

/// The verdicts on a claim of the paper.
inline constexpr std::string_view confirmed = "confirmed";
inline constexpr std::string_view refuted = "refuted";
inline constexpr std::string_view notTestable = "not testable";
inline constexpr std::string_view notMeasured = "not measured";

/// The paper's claims as rows: `claim`, `verdict`, and `figure`, the value of this run that decides it.
[[nodiscard]] ReportRows claimRows(const SectionRows& all);

}  // namespace drape::report::sections
