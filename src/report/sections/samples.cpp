#include "report/sections/samples.hpp"

#include "report/timing.hpp"

#include <vector>

namespace drape::report::sections {

void addSample(const ReportRows& own, std::size_t place, const char* key, ReportRow& row) {
  ReportRow samples = place < own.size() ? own[place].value("samples", ReportRow::array()) : ReportRow::array();
  if (row[key].is_number()) {
    samples.push_back(row[key]);
    row[key] = medianOf(samples.get<std::vector<double>>());
  }
  row["samples"] = samples;
}

}  // namespace drape::report::sections
