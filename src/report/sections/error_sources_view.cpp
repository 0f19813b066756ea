#include "report/sections/error_sources_view.hpp"

#include "report/number_text.hpp"
#include "report/sections/work_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace drape::report::sections {
namespace {

/// A source of error: its key in a row, and its name.
using Source = std::pair<const char*, const char*>;

constexpr std::array<Source, 5> sources{{{"auto", "solver auto"},
                                         {"implicit", "solver newton"},
                                         {"mesh", "mesh"},
                                         {"diagonals", "diagonals"},
                                         {"stiffer", "material"}}};

/// The largest source, without the implicit solver, which is there for comparison.
std::string dominantIn(const ReportRow& row) {
  const char* name = "-";
  double largest = -1.0;
  for (const auto& [key, title] : sources) {
    const double size = numberIn(row, key);
    if (std::string_view(key) != "implicit" && size > largest) {
      largest = size;
      name = title;
    }
  }
  return numberIn(row, "jitter") > largest ? "chaos" : name;
}

}  // namespace

std::vector<Block> showErrorSources(const ReportOptions&, const ReportRows& rows) {
  if (rows.empty()) {
    return {};
  }
  constexpr double millimetres = 1e3;
  std::vector<Block> blocks;
  blocks.emplace_back(Paragraph{
      "How far the cloth moves when one thing changes and all else stays, as the mean distance of the vertices. "
      "'Solver auto' and 'solver newton' (backward Euler with 1/150 s) are compared with 'auto' in double with a "
      "tolerance of 0.1 um. 'Mesh' compares with a grid of half the cell size, at the vertices of both, and shows "
      "twice the distance, which is the error if it halves with the cells. 'Diagonals' compares with the same grid "
      "whose "
      "diagonals are turned: the motion of a symmetric cloth with its mirror image. 'Material' compares with a "
      "material that is stiffer by 10 % in stretch, shear and bending; figures for real fabrics are rarely better "
      "known. 'Jitter' is the distance after a change of the start by up to 0.001 mm."});
  TextTable table{"Distances [mm]", {"cloth"}, {}};
  for (const auto& [key, title] : sources) {
    table.header.emplace_back(title);
  }
  table.header.insert(table.header.end(), {"jitter", "dominant"});
  for (const ReportRow& row : rows) {
    std::vector<std::string> fields{clothOf(row)};
    for (const auto& [key, title] : sources) {
      fields.push_back(text::figure(millimetres * numberIn(row, key)));
    }
    fields.push_back(text::figure(millimetres * numberIn(row, "jitter")));
    fields.push_back(dominantIn(row));
    table.rows.push_back(std::move(fields));
  }
  blocks.emplace_back(std::move(table));
  return blocks;
}

}  // namespace drape::report::sections
