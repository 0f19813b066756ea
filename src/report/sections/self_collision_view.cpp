#include "report/sections/self_collision_view.hpp"

#include "report/number_text.hpp"
#include "report/sections/collision_view.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace drape::report::sections {
namespace {

/// The rows of one scene at one resolution; null where it did not run.
struct Compared {
  std::string name;
  const ReportRow* off = nullptr;
  const ReportRow* hash = nullptr;
  const ReportRow* exact = nullptr;
};

bool endsWith(const ReportRow& row, const std::string& word) {
  return row.value("mode", "").ends_with(word);
}

std::vector<Compared> compare(const ReportRows& rows) {
  std::vector<Compared> all;
  for (const ReportRow& row : rows) {
    const std::string name = sceneText(row);
    auto found = std::find_if(all.begin(), all.end(), [&](const Compared& one) { return one.name == name; });
    if (found == all.end()) {
      found = all.insert(all.end(), Compared{name});
    }
    (endsWith(row, "exact") ? found->exact : endsWith(row, "hash") ? found->hash : found->off) = &row;
  }
  std::erase_if(all, [](const Compared& one) { return one.hash == nullptr || one.exact == nullptr; });
  return all;
}

/// A number of a row, in another unit; "-" if there is none.
std::string scaled(const ReportRow* row, const char* key, double factor) {
  return row == nullptr ? "-" : figure(ReportRow{{key, finiteOrNull(factor * numberIn(*row, key))}}, key);
}

}  // namespace

TextTable selfCollisionTable(const ReportRows& rows) {
  constexpr double milliseconds = 1e-3;  // from microseconds
  constexpr double percent = 100.0;
  constexpr double millimetres = 1e3;
  constexpr std::array<std::pair<const char*, double>, 4> values{{{"self_us_per_step", milliseconds},
                                                                  {"self_us_p99", milliseconds},
                                                                  {"energy_gained", percent},
                                                                  {"end_speed", millimetres}}};
  TextTable table{
      "Self-collision",
      {"scene", "pairs, off", "pairs, hash", "pairs, exact", "paper [ms]", "hash [ms]", "exact [ms]", "hash, 99 % [ms]",
       "exact, 99 % [ms]", "energy gained, hash [%]", "exact [%]", "speed at the end, hash [mm/s]", "exact [mm/s]"},
      {}};
  for (const Compared& one : compare(rows)) {
    std::vector<std::string> line{one.name};
    for (const ReportRow* row : {one.off, one.hash, one.exact}) {
      line.push_back(row == nullptr ? "-" : figure(*row, "intersecting_pairs_self_max", 5));
    }
    line.push_back(scaled(one.hash, "paper_self_us", milliseconds));
    for (const auto& [key, factor] : values) {
      line.push_back(scaled(one.hash, key, factor));
      line.push_back(scaled(one.exact, key, factor));
    }
    table.rows.push_back(line);
  }
  return table;
}

std::string aboutExact(const ReportRows& rows) {
  std::string left;
  double minRatio = 0.0;
  double maxRatio = 0.0;
  const std::vector<Compared> all = compare(rows);
  for (const Compared& one : all) {
    const double pairs = numberIn(*one.exact, "intersecting_pairs_self_max");
    if (!(pairs <= 0.0)) {
      left += (left.empty() ? "" : ", ") + one.name + " " + figure(*one.exact, "intersecting_pairs_self_max", 5);
    }
    const double ratio = numberIn(*one.exact, "self_us_per_step") / numberIn(*one.hash, "self_us_per_step");
    minRatio = &one == &all.front() ? ratio : std::min(minRatio, ratio);
    maxRatio = std::max(maxRatio, ratio);
  }
  if (all.empty()) {
    return "";
  }
  return std::string("Exact self-collision separates vertices from triangles and edges from edges. ") +
         (left.empty() ? "With it no two triangles of the cloth intersected in any count. "
                       : "With it these pairs of triangles intersected at once: " + left + ". ") +
         "It took " + text::figure(minRatio, 2) + " to " + text::figure(maxRatio, 2) +
         " times as long as the hash. Energy gained is the largest rise of the total energy above its start, relative "
         "to "
         "m g D, with D the diagonal of the cloth. The speed is the root mean square over the vertices in the last 0.2 "
         "s.";
}

}  // namespace drape::report::sections
