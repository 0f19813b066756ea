#pragma once

#include "report/section.hpp"

namespace drape {

/// Adds the row's figure `key` to the samples that earlier rounds left in `own` (rows of the same cell; the row of the
/// same place counts), writes them as "samples", and makes the figure their median. Comparisons of two reports take
/// their noise from there.
void addSample(const ReportRows& own, std::size_t place, const char* key, ReportRow& row);

}  // namespace drape
