#pragma once

#include "report/validation/test_sheet.hpp"

#include <limits>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace drape::report::validation {

/// The shape of a cloth at rest, for a picture.
struct DrapedShape {
  std::vector<Vec3> positions;  ///< [m]
  std::vector<Triangle> triangles;
};

/// A quantity, measured on a mesh and from the closed form or a usual range.
struct Comparison {
  double measured = 0.0;
  double exact = 0.0;  ///< of the closed form, or the lower end of the range
  /// The upper end of a usual range; not a number for a closed form.
  double upper = std::numeric_limits<double>::quiet_NaN();
  std::string note = {};                          ///< what else was found; may be empty
  std::shared_ptr<const DrapedShape> shape = {};  ///< null: there is no picture

  /// measured / exact - 1 [-]; NaN if the equilibrium was not found. For a range: 0 within it, else relative to its
  /// nearer end.
  [[nodiscard]] double error() const;
};

/// The parts of the mechanics that the cases test.
enum class CaseGroup { Membrane, Bending, Frequency, Motion, Drape };

inline constexpr std::array caseGroups{CaseGroup::Membrane, CaseGroup::Bending, CaseGroup::Frequency, CaseGroup::Motion,
                                       CaseGroup::Drape};

/// "membrane", "bending", "frequency", "motion", "drape".
[[nodiscard]] std::string_view nameOf(CaseGroup group);

/// The resolutions of most cases: cells along the sheet, each twice the former.
inline constexpr std::array validationResolutions{10, 20, 40};

/// A test of the mechanics of fabric against a closed form, declared in the table of case_table.cpp.
struct ValidationCase {
  CaseGroup group = CaseGroup::Membrane;
  std::string name;      ///< "heavy_elastica_15"
  std::string title;     ///< "Clamped strip under its weight, Gamma = 15"
  std::string compared;  ///< the quantity and its closed form
  std::string unit;      ///< of the quantity; empty for a plain number
  double aim = 0.0;      ///< largest error in size [-]
  Comparison (*run)(const CaseMesh&) = nullptr;
  std::array<int, 3> resolutions = validationResolutions;  ///< cells along the sheet, ascending
  std::span<const MeshKind> kinds = meshKinds;
  std::span<const MeshKind> slowKinds = {};  ///< further ones, on which the search takes minutes
  bool everyResolution = false;              ///< the aim holds for every resolution, not only for the finest
  std::size_t shortResolutions = 2;          ///< how many of them the short form has, the coarsest first
  std::string_view subject = {};             ///< CaseMesh::subject
  std::string_view reason = {};              ///< the known reason why its error exceeds the aim; empty if it does not
};

/// All cases.
[[nodiscard]] std::span<const ValidationCase> validationTable();

/// The case of that name. Throws UsageError when there is none.
[[nodiscard]] const ValidationCase& requireValidationCase(std::string_view name);

/// The resolutions of a case; only the coarsest ones in the short form.
[[nodiscard]] std::span<const int> resolutionsOf(const ValidationCase& validationCase, bool shortForm);

/// The kinds of mesh of a case, without the slow ones in the short form.
[[nodiscard]] std::vector<MeshKind> kindsOf(const ValidationCase& validationCase, bool shortForm);

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

  /// Whether the error at the finest resolution, or at every one, is within the aim. A NaN is not.
  [[nodiscard]] bool passes() const;
  /// The observed order of convergence p, with the error proportional to h^p, from the two finest resolutions. NaN if
  /// there is only one, or if the errors are below 1e-6 and hence rounding.
  [[nodiscard]] double order() const;
};

/// Runs a case on one kind of mesh at each of these resolutions.
[[nodiscard]] ValidationSeries runValidation(const ValidationCase& validationCase, MeshKind kind,
                                             std::span<const int> resolutions, const std::stop_token& stop = {});

}  // namespace drape::report::validation
