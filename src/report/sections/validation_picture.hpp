#pragma once

#include "report/section.hpp"

namespace drape::report::sections {

/// The draped cloths of rows of the section `validation` that have a `shape`, from obliquely above.
[[nodiscard]] Drawing pictureOf(const ReportRows& rows);

}  // namespace drape::report::sections
