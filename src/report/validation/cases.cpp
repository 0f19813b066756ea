#include "report/validation/cases.hpp"

#include "messages/error.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

namespace drape::report::validation {
namespace {

constexpr CaseGroup membrane = CaseGroup::Membrane;
constexpr CaseGroup bending = CaseGroup::Bending;
constexpr CaseGroup frequency = CaseGroup::Frequency;
constexpr CaseGroup motion = CaseGroup::Motion;

constexpr std::array dynamicResolutions{8, 16, 32};
constexpr std::array coarseResolutions{5, 10, 20};

constexpr ValidationCase membraneFrequencyOf(std::string_view name, std::string_view solver) {
  return {frequency,
          name,
          "Stretched square membrane, mode 1, 1",
          "frequency, sqrt(S / density) sqrt(2) / (2 L)",
          "1/s",
          0.01,
          membraneMode11,
          dynamicResolutions,
          solver};
}

constexpr ValidationCase stripFrequencyOf(std::string_view name, std::string_view solver) {
  return {frequency,
          name,
          "Clamped strip, lowest mode",
          "frequency, 3.516 sqrt(B / density) / (2 pi L^2)",
          "1/s",
          0.01,
          stripMode,
          dynamicResolutions,
          solver};
}

// clang-format off
constexpr std::array casesOfValidation{
    ValidationCase{membrane, "end_load_modulus", "Strip under an end load: stiffness",
        "E h from the strain in the middle, with Saint Venant-Kirchhoff's law", "N/m", 0.005, endLoadModulus},
    ValidationCase{membrane, "end_load_poisson", "Strip under an end load: contraction",
        "Poisson's ratio from the strains in the middle", "", 0.005, endLoadPoisson},
    ValidationCase{membrane, "own_weight", "Strip that hangs from one end",
        "elongation by its own weight, from the nonlinear law integrated over the strip", "m", 0.005, ownWeight},
    ValidationCase{membrane, "picture_frame", "Picture frame",
        "shear modulus from the work of the frame at 0.3 rad", "N/m", 0.005, pictureFrame},
    ValidationCase{membrane, "hanging_strip", "Strip that hangs from both ends",
        "sag of the catenary", "m", 0.005, hangingStrip},
    ValidationCase{bending, "heavy_elastica_1.5", "Clamped strip under its weight, Gamma = 1.5",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaSmall},
    ValidationCase{bending, "heavy_elastica_5", "Clamped strip under its weight, Gamma = 5",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaMedium},
    ValidationCase{bending, "heavy_elastica_15", "Clamped strip under its weight, Gamma = 15",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaLarge},
    ValidationCase{bending, "heavy_elastica_46", "Clamped strip under its weight, Gamma = 46",
        "drop of the tip of the heavy elastica, in lengths", "", 0.01, heavyElasticaHanging},
    ValidationCase{bending, "peirce_denim", "Peirce's cantilever, denim along warp",
        "overhang at a chord of 41.5 degrees, from the heavy elastica", "m", 0.01, peirceDenim},
    ValidationCase{bending, "peirce_cotton", "Peirce's cantilever, cotton-polyester along warp",
        "overhang at a chord of 41.5 degrees, from the heavy elastica", "m", 0.01, peirceCotton},
    ValidationCase{bending, "peirce_polyester", "Peirce's cantilever, polyester along warp",
        "overhang at a chord of 41.5 degrees, from the heavy elastica", "m", 0.01, peircePolyester},
    ValidationCase{bending, "buckling", "Compressed strip with hinged ends",
        "load per width at which the flat strip becomes unstable, pi^2 B / L^2", "N/m", 0.01, buckling},
    ValidationCase{bending, "twist", "Square plate on a saddle",
        "twist stiffness of a plate whose corners are moved to y = k x z, energy 2 D_33 k^2 an area", "N m", 0.01, twist},
    ValidationCase{frequency, "membrane_12", "Stretched square membrane, mode 1, 2",
        "frequency, sqrt(S / density) sqrt(5) / (2 L)", "1/s", 0.01, membraneMode12, dynamicResolutions, "auto"},
    ValidationCase{frequency, "membrane_22", "Stretched square membrane, mode 2, 2",
        "frequency, sqrt(S / density) sqrt(8) / (2 L)", "1/s", 0.01, membraneMode22, dynamicResolutions, "auto"},
    membraneFrequencyOf("membrane_11_auto", "auto"),
    membraneFrequencyOf("membrane_11_verlet", "verlet"),
    membraneFrequencyOf("membrane_11_explicit_euler", "explicit_euler"),
    membraneFrequencyOf("membrane_11_one_iteration", "one_iteration"),
    membraneFrequencyOf("membrane_11_chebyshev", "chebyshev"),
    membraneFrequencyOf("membrane_11_pcg", "pcg"),
    membraneFrequencyOf("membrane_11_newton", "newton"),
    membraneFrequencyOf("membrane_11_vbd", "vbd"),
    stripFrequencyOf("strip_auto", "auto"),
    stripFrequencyOf("strip_verlet", "verlet"),
    stripFrequencyOf("strip_explicit_euler", "explicit_euler"),
    stripFrequencyOf("strip_one_iteration", "one_iteration"),
    stripFrequencyOf("strip_chebyshev", "chebyshev"),
    stripFrequencyOf("strip_pcg", "pcg"),
    stripFrequencyOf("strip_newton", "newton"),
    stripFrequencyOf("strip_vbd", "vbd"),
    ValidationCase{motion, "incline_sticks", "Sheet on an incline: where it begins to slide",
        "slope, the coefficient of static friction", "", 0.01, inclineSticks, coarseResolutions, "auto"},
    ValidationCase{motion, "incline_slides", "Sheet on an incline: acceleration",
        "acceleration, g (sin a - mu cos a)", "m/s^2", 0.01, inclineSlides, coarseResolutions, "auto"},
    ValidationCase{motion, "terminal_velocity", "Falling sheet: terminal velocity",
        "speed at which drag carries the weight", "m/s", 0.01, terminalVelocity, coarseResolutions, "auto"},
    ValidationCase{motion, "fall_distance", "Falling sheet: distance",
        "distance after the terminal velocity over g, v^2 / g log(cosh(1))", "m", 0.01, fallDistance, coarseResolutions, "auto"},
};
// clang-format on

}  // namespace

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
  return shortForm ? all.first(all.size() - 1) : all;
}

std::span<const ValidationCase> validationTable() {
  return casesOfValidation;
}

const ValidationCase& requireValidationCase(std::string_view name) {
  const auto* const found = std::find_if(casesOfValidation.begin(), casesOfValidation.end(),
                                         [&](const ValidationCase& one) { return one.name == name; });
  if (found == casesOfValidation.end()) {
    std::string names;
    for (const ValidationCase& one : casesOfValidation) {
      names += (names.empty() ? "" : ", ") + std::string(one.name);
    }
    throw messages::UsageError("there is no validation case '" + std::string(name) + "'; the cases are " + names);
  }
  return *found;
}

bool ValidationSeries::passes() const {
  return !results.empty() && std::abs(results.back().comparison.error()) <= validationCase->aim;
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
  using Clock = std::chrono::steady_clock;
  ValidationSeries series{.validationCase = &validationCase, .kind = kind, .results = {}};
  for (const int resolution : resolutions) {
    const auto start = Clock::now();
    const Comparison comparison =
        validationCase.run({.resolution = resolution, .kind = kind, .subject = validationCase.subject, .stop = stop});
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    series.results.push_back({.kind = kind, .resolution = resolution, .comparison = comparison, .seconds = seconds});
  }
  return series;
}

}  // namespace drape::report::validation
