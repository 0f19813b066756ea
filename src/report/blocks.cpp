#include "report/blocks.hpp"

#include <algorithm>
#include <cctype>

namespace drape::report {

bool holdsWords(const TextTable& table, std::size_t column) {
  const auto words = std::count_if(table.rows.begin(), table.rows.end(), [&](const std::vector<std::string>& row) {
    return column < row.size() && !row[column].empty() &&
           std::isalpha(static_cast<unsigned char>(row[column].front())) != 0;
  });
  return column == 0 || 2 * words > static_cast<std::ptrdiff_t>(table.rows.size());
}

bool isBad(const TextTable& table, std::size_t row) {
  return row < table.tones.size() && table.tones[row] == Tone::Bad;
}

}  // namespace drape::report
