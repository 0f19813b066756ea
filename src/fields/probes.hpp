#pragma once

#include "fields/snapshot_fields.hpp"

#include <span>
#include <string>
#include <vector>

namespace drape::fields {

/// The values of all fields at some vertices: first all fields of the first vertex, in the order of fieldTable(). NaN
/// where a field has no value.
[[nodiscard]] std::vector<double> probe(SnapshotFields& fields, std::span<const int> vertices);

/// Text in the format CSV: a line of titles with units, and one line for each time. The columns are the time [s] and
/// the values of probe(). A value that is not defined is an empty cell; numbers have the shortest form that reads back
/// to the same bits.
[[nodiscard]] std::string probeTitles(std::span<const int> vertices);
[[nodiscard]] std::string probeLine(double time, std::span<const double> values);

}  // namespace drape::fields
