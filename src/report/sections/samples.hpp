#pragma once

#include "report/section.hpp"

namespace drape::report::sections {

/// Adds the row's value `key` to the samples of earlier rounds in `own` (rows of the same cell, same index), stores
/// them as "samples", and replaces the value by their median. Comparisons of reports take the noise from these samples.
void addSample(const ReportRows& own, std::size_t place, const char* key, ReportRow& row);

}  // namespace drape::report::sections
