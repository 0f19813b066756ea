#include "report/validation/cases.hpp"

#include "messages/error.hpp"
#include "sim/model/seconds_since.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace drape::report::validation {

double Comparison::error() const {
  if (std::isnan(upper)) {
    return measured / exact - 1.0;
  }
  return measured >= exact && measured <= upper ? 0.0 : measured / (measured < exact ? exact : upper) - 1.0;
}

std::string_view nameOf(CaseGroup group) {
  switch (group) {
    case CaseGroup::Membrane:
      return "membrane";
    case CaseGroup::Bending:
      return "bending";
    case CaseGroup::Frequency:
      return "frequency";
    case CaseGroup::Motion:
      return "motion";
    case CaseGroup::Drape:
      break;
  }
  return "drape";
}

std::span<const int> resolutionsOf(const ValidationCase& validationCase, bool shortForm) {
  const std::span<const int> all = validationCase.resolutions;
  return shortForm ? all.first(validationCase.shortResolutions) : all;
}

std::vector<MeshKind> kindsOf(const ValidationCase& validationCase, bool shortForm) {
  std::vector<MeshKind> kinds(validationCase.kinds.begin(), validationCase.kinds.end());
  if (!shortForm) {
    kinds.insert(kinds.end(), validationCase.slowKinds.begin(), validationCase.slowKinds.end());
  }
  return kinds;
}

const ValidationCase& requireValidationCase(std::string_view name) {
  const std::span<const ValidationCase> table = validationTable();
  const auto found = std::ranges::find_if(table, [&](const ValidationCase& one) { return one.name == name; });
  if (found == table.end()) {
    std::string names;
    for (const ValidationCase& one : table) {
      names += (names.empty() ? "" : ", ") + std::string(one.name);
    }
    throw messages::UsageError("there is no validation case '" + std::string(name) + "'; the cases are " + names);
  }
  return *found;
}

bool ValidationSeries::passes() const {
  const auto isWithin = [this](const ValidationResult& result) {
    return std::abs(result.comparison.error()) <= validationCase->aim;
  };
  return !results.empty() &&
         (validationCase->everyResolution ? std::ranges::all_of(results, isWithin) : isWithin(results.back()));
}

double ValidationSeries::order() const {
  constexpr double smallest = 1e-6;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (results.size() < 2) {
    return none;
  }
  const ValidationResult& coarse = results[results.size() - 2];
  const ValidationResult& fine = results.back();
  const double before = std::abs(coarse.comparison.error());
  const double after = std::abs(fine.comparison.error());
  if (!(before > smallest) || !(after > smallest)) {
    return none;
  }
  return std::log(before / after) / std::log(static_cast<double>(fine.resolution) / coarse.resolution);
}

ValidationSeries runValidation(const ValidationCase& validationCase, MeshKind kind, std::span<const int> resolutions,
                               const std::stop_token& stop) {
  ValidationSeries series{.validationCase = &validationCase, .kind = kind, .results = {}};
  for (const int resolution : resolutions) {
    const auto start = std::chrono::steady_clock::now();
    const Comparison comparison =
        validationCase.run({.resolution = resolution, .kind = kind, .subject = validationCase.subject, .stop = stop});
    const double seconds = sim::secondsSince(start);
    series.results.push_back({.kind = kind, .resolution = resolution, .comparison = comparison, .seconds = seconds});
  }
  return series;
}

}  // namespace drape::report::validation
