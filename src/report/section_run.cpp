#include "report/section_run.hpp"

#include "messages/error.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace drape::report {
namespace {

bool isWanted(const ReportOptions& options, const Section& section) {
  const bool named = std::find(options.only.begin(), options.only.end(), section.name) != options.only.end();
  return section.plan != nullptr && (options.only.empty() || named);
}

[[noreturn]] void refuse(const std::string& name, std::span<const Section> sections) {
  std::string known;
  for (const Section& section : sections) {
    if (section.plan == nullptr) {
      continue;
    }
    known += known.empty() ? "" : ", ";
    known += section.name;
  }
  throw messages::UsageError("--only needs the name of a section; '" + name + "' is not one of " + known);
}

void requireSections(std::span<const Section> sections, const ReportOptions& options) {
  for (const std::string& name : options.only) {
    const auto named = [&name](const Section& section) { return section.plan != nullptr && section.name == name; };
    if (std::none_of(sections.begin(), sections.end(), named)) {
      refuse(name, sections);
    }
  }
}

/// The rows of a section, cell by cell.
class CellRows {
 public:
  CellRows(const SectionPlan& plan, const ReportRows& known) : plan_(plan), rows_(plan.cells.size()) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      std::copy_if(known.begin(), known.end(), std::back_inserter(rows_[i]),
                   [&](const ReportRow& row) { return row.value("cell", "") == plan.cells[i].key; });
    }
  }

  [[nodiscard]] const ReportRows& of(std::size_t cell) const { return rows_[cell]; }

  [[nodiscard]] int roundsOf(std::size_t cell) const {
    return rows_[cell].empty() ? 0 : rows_[cell].front().value("rounds", 0);
  }

  /// Updates `all` as well, which has the rows of all cells in the order of the plan. Only the rows of this cell
  /// change.
  void put(std::size_t cell, ReportRows rows, ReportRows& all) {
    const int rounds = roundsOf(cell) + 1;
    for (ReportRow& row : rows) {
      row["cell"] = plan_.cells[cell].key;
      row["rounds"] = rounds;
    }
    const auto first = all.begin() + placeOf(cell);
    const auto next = all.erase(first, first + static_cast<std::ptrdiff_t>(rows_[cell].size()));
    all.insert(next, rows.begin(), rows.end());
    rows_[cell] = std::move(rows);
  }

  /// Copies the rows of all cells, in the order of the plan.
  void copyTo(ReportRows& all) const {
    all.clear();
    for (const ReportRows& rows : rows_) {
      all.insert(all.end(), rows.begin(), rows.end());
    }
  }

 private:
  [[nodiscard]] std::ptrdiff_t placeOf(std::size_t cell) const {
    return std::accumulate(
        rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(cell), std::ptrdiff_t{0},
        [](std::ptrdiff_t sum, const ReportRows& rows) { return sum + static_cast<std::ptrdiff_t>(rows.size()); });
  }

  const SectionPlan& plan_;
  std::vector<ReportRows> rows_;
};

class Runner {
 public:
  Runner(SectionRows& rows, const RunHooks& hooks) : rows_(rows), hooks_(hooks) {}

  void plan(const Section& section, const ReportOptions& options) {
    parts_.push_back({&section, section.plan(options), {}});
    const Part& part = parts_.back();
    const CellRows known(part.plan, rows_[std::string(section.name)]);
    for (std::size_t i = 0; i < part.plan.cells.size(); ++i) {
      total_ += part.plan.cells[i].weight * std::max(0, part.plan.rounds - known.roundsOf(i));
    }
  }

  void run() {
    int rounds = 0;
    for (Part& part : parts_) {
      ReportRows& rows = rows_[std::string(part.section->name)];
      part.cells.emplace(part.plan, rows);
      part.cells->copyTo(rows);  // the rows of an earlier report for these cells, and nothing else
      rounds = std::max(rounds, part.plan.rounds);
    }
    for (int round = 0; round < rounds; ++round) {
      for (Part& part : parts_) {
        measureRound(part, round);
      }
    }
  }

 private:
  struct Part {
    const Section* section;
    SectionPlan plan;
    std::optional<CellRows> cells;  // while the section runs
  };

  void measureRound(Part& part, int round) {
    for (std::size_t i = 0; round < part.plan.rounds && i < part.plan.cells.size(); ++i) {
      if (part.cells->roundsOf(i) != round) {
        continue;
      }
      if (round > 0 && hooks_.outOfTime && hooks_.outOfTime()) {
        return;
      }
      measure(part, i);
    }
  }

  void measure(Part& part, std::size_t index) {
    const auto checkStop = [this] {
      if (hooks_.stopped && hooks_.stopped()) {
        throw ReportStopped();
      }
    };
    checkStop();
    if (hooks_.progress) {
      hooks_.progress(part.section->name, done_, total_);
    }
    const Cell& cell = part.plan.cells[index];
    ReportRows& rows = rows_[std::string(part.section->name)];
    part.cells->put(index, cell.measure({rows, part.cells->of(index), checkStop}), rows);
    done_ += cell.weight;
    if (hooks_.measured) {
      hooks_.measured(rows_);
    }
  }

  SectionRows& rows_;
  const RunHooks& hooks_;
  std::vector<Part> parts_;
  double done_ = 0.0;
  double total_ = 0.0;
};

}  // namespace

void requireSections(const ReportOptions& options) {
  requireSections(sectionTable(), options);
}

bool measureSections(const ReportOptions& options, SectionRows& rows, const RunHooks& hooks) {
  return measureSections(sectionTable(), options, rows, hooks);
}

bool measureSections(std::span<const Section> sections, const ReportOptions& options, SectionRows& rows,
                     const RunHooks& hooks) {
  requireSections(sections, options);
  Runner runner(rows, hooks);
  for (const Section& section : sections) {
    if (isWanted(options, section)) {
      runner.plan(section, options);
    }
  }
  try {
    runner.run();
  } catch (const ReportStopped&) {
    return false;
  }
  return true;
}

}  // namespace drape::report
