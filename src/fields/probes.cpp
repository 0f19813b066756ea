#include "fields/probes.hpp"

#include "text/number_text.hpp"

#include <cmath>
#include <limits>

namespace drape::fields {

std::vector<double> probe(SnapshotFields& fields, std::span<const int> vertices) {
  const auto table = sim::fields::fieldTable();
  std::vector<double> all(vertices.size() * table.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t f = 0; f < table.size(); ++f) {
    const std::span<const double> values = fields.values(table[f]);
    for (std::size_t i = 0; i < vertices.size() && !values.empty(); ++i) {
      all[i * table.size() + f] = values[vertices[i]];
    }
  }
  return all;
}

std::string probeTitles(std::span<const int> vertices) {
  std::string line = "time [s]";
  for (const int vertex : vertices) {
    for (const sim::fields::FieldInfo& field : sim::fields::fieldTable()) {
      line +=
          ",vertex " + std::to_string(vertex) + " " + std::string(field.name) + " [" + std::string(field.unit) + "]";
    }
  }
  return line + "\n";
}

std::string probeLine(double time, std::span<const double> values) {
  std::string line = text::exactNumber(time);
  for (const double value : values) {
    line += std::isfinite(value) ? "," + text::exactNumber(value) : ",";
  }
  return line + "\n";
}

}  // namespace drape::fields
