#pragma once

#include "report/number_text.hpp"
#include "report/section.hpp"

#include <string>

namespace drape::report::sections {

/// Whether a row of work_precision is a calm setting with known time and error.
[[nodiscard]] inline bool isJudged(const ReportRow& row) {
  return row.value("state", "") == "calm" && row["us_per_simulated_second"].is_number() &&
         row["error_of_diagonal"].is_number();
}

/// "hang, 17x17, 10 N/m, 0.2 s".
[[nodiscard]] inline std::string clothOf(const ReportRow& row) {
  return row.value("scene", "") + ", " + gridText(row.value("resolution", 0)) + ", " + figure(row, "stiffness", 6) +
         " N/m, " + figure(row, "time") + " s";
}

}  // namespace drape::report::sections
