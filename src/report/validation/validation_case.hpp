#pragma once

#include "report/validation/test_sheet.hpp"

#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace drape::report::validation {

/// A mesh that a case runs on.
struct CaseMesh {
  int resolution = 0;  ///< cells along the sheet
  MeshKind kind = MeshKind::Grid;
  std::stop_token stop = {};  ///< ends the search for an equilibrium by sim::StepStopped
};

/// A quantity, measured on a mesh and from the closed form.
struct Comparison {
  double measured = 0.0;
  double exact = 0.0;

  /// measured / exact - 1 [-]; NaN if the equilibrium was not found.
  [[nodiscard]] double error() const { return measured / exact - 1.0; }
};

/// A test of the mechanics of fabric against a closed form, declared in the table of cases.cpp.
struct ValidationCase {
  std::string_view name;      ///< "heavy_elastica_15"
  std::string_view title;     ///< "Clamped strip under its weight, Gamma = 15"
  std::string_view compared;  ///< the quantity and its closed form
  std::string_view unit;      ///< of the quantity; empty for a plain number
  double aim = 0.0;           ///< largest error in size at the finest resolution [-]
  Comparison (*run)(const CaseMesh&) = nullptr;
};

/// The resolutions of a full validation: cells along the sheet, each twice the former.
inline constexpr std::array validationResolutions{10, 20, 40};

/// All cases.
[[nodiscard]] std::span<const ValidationCase> validationTable();

/// The case of that name. Throws UsageError when there is none.
[[nodiscard]] const ValidationCase& requireValidationCase(std::string_view name);

/// A result of a case on one mesh.
struct ValidationResult {
  MeshKind kind = MeshKind::Grid;
  int resolution = 0;
  Comparison comparison;
  double seconds = 0.0;  ///< wall clock time
};

/// The results of a case on one kind of mesh, by resolution.
struct ValidationSeries {
  const ValidationCase* validationCase = nullptr;
  MeshKind kind = MeshKind::Grid;
  std::vector<ValidationResult> results;

  /// Whether the error at the finest resolution is within the aim. A NaN is not.
  [[nodiscard]] bool passes() const;
  /// The observed order of convergence p, with the error proportional to h^p, from the two finest resolutions. NaN if
  /// there is only one, or if the errors are below 1e-6 and hence rounding.
  [[nodiscard]] double order() const;
};

/// Runs a case on one kind of mesh at each of these resolutions.
[[nodiscard]] ValidationSeries runValidation(const ValidationCase& validationCase, MeshKind kind,
                                             std::span<const int> resolutions, const std::stop_token& stop = {});

}  // namespace drape::report::validation
