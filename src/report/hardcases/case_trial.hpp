#pragma once

#include "report/hardcases/hard_case.hpp"
#include "session/simulation.hpp"
#include "sim/contact/bodies/body.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/solvers/solver_warning.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace drape::report::hardcases {

/// Thrown by a case that cannot continue, for example after the state is no longer finite.
struct CaseEnded {
  std::string why;
};

/// Thrown by a case with a fabric when the solver under test takes springs only.
struct CaseRefused {};

/// Thrown when a case exceeds its time limit.
struct CaseTooSlow {};

/// The context of a case: the solver under test, and the results.
class CaseTrial {
 public:
  explicit CaseTrial(const CaseOptions& options);

  [[nodiscard]] const std::string& solver() const { return options_.solver; }
  [[nodiscard]] bool shortForm() const { return options_.shortForm; }
  /// 0: the start of the case; n: the n-th jittered one, in cases of contact.
  [[nodiscard]] int start() const { return options_.start; }

  /// The first value in the full form, the second in the short form.
  template <typename T>
  [[nodiscard]] T pick(T full, T brief) const {
    return options_.shortForm ? brief : full;
  }

  /// The default settings with these changes ("key=value"), the solver under test and the user's changes.
  [[nodiscard]] settings::Settings settings(const std::vector<std::string>& changes) const;

  /// The settings of a scene with these changes, the solver under test and the user's changes.
  [[nodiscard]] settings::Settings changed(settings::Settings settings, const std::vector<std::string>& changes) const;

  /// The same as `settings` for a fabric with its own density. Throws CaseRefused when the solver under test takes
  /// springs only.
  /// @param preset of the table in fabrics/presets.hpp
  [[nodiscard]] settings::Settings fabricSettings(const std::string& preset,
                                                  const std::vector<std::string>& changes) const;

  /// Adds a value that must not exceed its limit. Of several with the same name the largest counts.
  void expect(const std::string& name, const std::string& unit, double value, double limit);
  /// Adds a value that is only shown.
  void show(const std::string& name, const std::string& unit, double value);
  /// Adds a remark.
  void say(const std::string& words);

  /// Adds the warning of the solver about a cloth of this case. Of several, the one that asks for the most substeps
  /// counts.
  void warn(const sim::SolverWarning& warning);

  /// Call it every few steps. Throws CaseTooSlow, and forwards exceptions from `checkStop`.
  void tick() const;

  [[nodiscard]] const std::vector<CaseFigure>& figures() const { return figures_; }
  [[nodiscard]] const std::string& words() const { return words_; }
  [[nodiscard]] const std::optional<sim::SolverWarning>& warning() const { return warning_; }
  [[nodiscard]] double seconds() const;

 private:
  const CaseOptions& options_;
  std::vector<CaseFigure> figures_;
  std::string words_;
  std::optional<sim::SolverWarning> warning_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// A cloth for a case, before it is built.
struct CaseCloth {
  sim::ClothMesh mesh;
  std::vector<int> pins;
  settings::Settings settings;
  std::vector<Vec3> start;        ///< [m]; empty: the rest shape
  std::vector<Vec3> velocities;   ///< [m/s]; empty: at rest
  std::vector<double> stiffness;  ///< relative stiffness of the springs [-]; empty: equal
  std::vector<double> masses;     ///< of the vertices [kg]; empty: from the settings
  std::vector<sim::contact::Body> bodies = {};
};

/// The pins of a case's sheet.
enum class Pinned { Nowhere, TwoCorners, OneCorner, TopEdge };

/// A square sheet of 0.1 kg with that number of vertices per side, centred on the origin: level, or upright.
[[nodiscard]] CaseCloth sheetCloth(const settings::Settings& settings, int resolution, Pinned pinned, double side = 1.0,
                                   bool upright = false);

/// The model of a case's cloth.
[[nodiscard]] std::shared_ptr<const sim::ClothModel> modelOf(const CaseCloth& cloth);

/// The number of substeps with which an explicit method stays at half of its stability limit; 1 for others.
[[nodiscard]] int stableSubsteps(const sim::ClothModel& model, const settings::Settings& settings);

/// Random numbers that are the same in every run.
class CaseNumbers {
 public:
  explicit CaseNumbers(std::uint64_t seed) : engine_(seed) {}
  /// Uniform from 0 to 1.
  double next() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace drape::report::hardcases
