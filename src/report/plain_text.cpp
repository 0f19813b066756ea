#include "report/plain_text.hpp"

#include <algorithm>
#include <vector>

namespace drape::report {
namespace {

std::string lineOf(const std::vector<std::string>& fields, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string space(widths[i] - fields[i].size(), ' ');
    line += i == 0 ? fields[i] + space : "  " + space + fields[i];
  }
  return line + "\n";
}

}  // namespace

std::string plainText(const TextTable& table) {
  std::vector<std::size_t> widths(table.header.size());
  const auto widen = [&widths](const std::vector<std::string>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      widths.at(i) = std::max(widths[i], fields[i].size());
    }
  };
  widen(table.header);
  std::for_each(table.rows.begin(), table.rows.end(), widen);
  std::string text = table.title + "\n" + lineOf(table.header, widths);
  for (const auto& row : table.rows) {
    text += lineOf(row, widths);
  }
  return text;
}

}  // namespace drape::report
