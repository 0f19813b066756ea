#pragma once

#include "report/hardcases/hard_case.hpp"
#include "session/simulation.hpp"
#include "sim/cloth_model.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace drape {

/// Thrown by a case that cannot go on, as when the numbers ended.
struct CaseEnded {
  std::string why;
};

/// Thrown when a case takes too long.
struct CaseTooSlow {};

/// What a case works with: which solver is on trial, and where its figures go.
class CaseTrial {
 public:
  explicit CaseTrial(const CaseOptions& options);

  [[nodiscard]] const std::string& solver() const { return options_.solver; }
  [[nodiscard]] bool shortForm() const { return options_.shortForm; }

  /// What the form that is run asks for.
  template <typename T>
  [[nodiscard]] T pick(T full, T brief) const {
    return options_.shortForm ? brief : full;
  }

  /// The program's defaults with these settings ("key=value"), the solver on trial and what was asked for it.
  [[nodiscard]] Settings settings(const std::vector<std::string>& changes) const;

  /// A figure that must not be larger than its limit. Of several with the same name the largest counts.
  void expect(const std::string& name, const std::string& unit, double value, double limit);
  /// A figure that is shown only.
  void show(const std::string& name, const std::string& unit, double value);
  /// Something to be told beside the figures.
  void say(const std::string& words);

  /// To be called every few steps. Throws CaseTooSlow, or what `checkStop` throws.
  void tick() const;

  [[nodiscard]] const std::vector<CaseFigure>& figures() const { return figures_; }
  [[nodiscard]] const std::string& words() const { return words_; }
  [[nodiscard]] double seconds() const;

 private:
  const CaseOptions& options_;
  std::vector<CaseFigure> figures_;
  std::string words_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// A cloth for a case, before it is built.
struct CaseCloth {
  ClothMesh mesh;
  std::vector<int> pins;
  Settings settings;
  std::vector<Vec3> start;        ///< [m]; empty: the rest shape
  std::vector<Vec3> velocities;   ///< [m/s]; empty: at rest
  std::vector<double> stiffness;  ///< of the springs, relative [-]; empty: all alike
  std::vector<double> masses;     ///< of the vertices [kg]; empty: as the settings say
};

/// Where a case's sheet is held.
enum class Held { Nowhere, TwoCorners, OneCorner, TopEdge };

/// A square sheet of 0.1 kg with so many vertices a side, about the origin: level, or upright with its top edge level.
[[nodiscard]] CaseCloth sheetCloth(const Settings& settings, int resolution, Held held, double side = 1.0,
                                   bool upright = false);

/// The model that a case's cloth becomes.
[[nodiscard]] std::shared_ptr<const ClothModel> modelOf(const CaseCloth& cloth);

/// In how many parts an explicit method has to take its step to stay at half of its stability limit; 1 for others.
[[nodiscard]] int stableSubsteps(const ClothModel& model, const Settings& settings);

/// Numbers that are the same at every run.
class CaseNumbers {
 public:
  explicit CaseNumbers(std::uint64_t seed) : engine_(seed) {}
  /// From 0 to 1, evenly.
  double next() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace drape
