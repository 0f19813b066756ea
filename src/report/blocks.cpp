#include "report/blocks.hpp"

#include <algorithm>
#include <cctype>

namespace drape::report {

Curve& curveLabelled(const std::string& label, Plot& plot) {
  const auto found = std::ranges::find(plot.curves, label, &Curve::label);
  return found != plot.curves.end() ? *found : plot.curves.emplace_back(Curve{.label = label, .points = {}});
}

bool holdsWords(const TextTable& table, std::size_t column) {
  std::ptrdiff_t words = 0;
  std::ptrdiff_t fields = 0;
  for (const std::vector<std::string>& row : table.rows) {
    if (column < row.size() && !row[column].empty()) {
      ++fields;
      words += std::isalpha(static_cast<unsigned char>(row[column].front())) != 0 ? 1 : 0;
    }
  }
  return column == 0 || 2 * words > fields;
}

bool isBad(const TextTable& table, std::size_t row) {
  return row < table.tones.size() && table.tones[row] == Tone::Bad;
}

}  // namespace drape::report
