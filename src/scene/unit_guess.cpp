#include "scene/unit_guess.hpp"

#include "settings/settings_table.hpp"
#include "text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace drape::scene {
namespace {

/// A unit, and the approximate percentage of files that use it.
struct UsualUnit {
  LengthUnit unit;
  double files = 0.0;
};

constexpr std::array<UsualUnit, 6> usualUnits{{{{"m", "metres", 1.0}, 40.0},
                                               {{"cm", "centimetres", 0.01}, 35.0},
                                               {{"mm", "millimetres", 0.001}, 12.0},
                                               {{"inch", "inches", 0.0254}, 8.0},
                                               {{"dm", "decimetres", 0.1}, 5.0},
                                               {{"foot", "feet", 0.3048}, 0.3}}};

/// A kind of object and its size: a normal distribution of the logarithm.
struct UsualSize {
  double metres;
  double spread;  ///< of the logarithm [-]
  double share;   ///< of all files [-]
};

constexpr std::array<UsualSize, 4> sizesOfCloth{{{0.75, 0.25, 0.45},   // T-shirts, skirts, trousers
                                                 {1.2, 0.2, 0.2},      // dresses
                                                 {1.7, 0.1, 0.2},      // bodies
                                                 {0.35, 0.4, 0.15}}};  // socks, caps, handkerchiefs

constexpr std::array<UsualSize, 2> sizesOfBodies{{{1.7, 0.1, 0.8},    // adults
                                                  {1.1, 0.3, 0.2}}};  // children, and busts of adults

constexpr std::array<UsualSize, 1> sizesOfTorsos{{{0.75, 0.25, 1.0}}};

/// What has a usual size.
struct Kind {
  std::span<const UsualSize> sizes;
  double smallest;  ///< of the usual sizes [m]
  double largest;   ///< [m]
};

Kind kindOf(io::MeshUse use, double fullness) {
  if (use != io::MeshUse::Body) {
    return {sizesOfCloth, smallestGarment, largestGarment};
  }
  return isTorso(fullness) ? Kind{sizesOfTorsos, smallestTorso, largestTorso}
                           : Kind{sizesOfBodies, smallestPerson, largestPerson};
}

/// The frequency of objects of that size; only ratios are meaningful.
double frequency(double metres, std::span<const UsualSize> sizes) {
  double sum = 0.0;
  for (const UsualSize& size : sizes) {
    const double apart = std::log(metres / size.metres) / size.spread;
    sum += size.share / size.spread * std::exp(-0.5 * apart * apart);
  }
  return sum;
}

/// The factor by which a size is outside the range of garments [-]; 1 inside.
double misfit(double metres) {
  return std::max({1.0, smallestGarment / metres, metres / largestGarment});
}

const LengthUnit* findUnit(std::string_view word) {
  const auto found =
      std::find_if(usualUnits.begin(), usualUnits.end(), [&](const auto& entry) { return entry.unit.word == word; });
  return found == usualUnits.end() ? nullptr : &found->unit;
}

}  // namespace

bool isTorso(double fullness) {
  return fullness > 0.04 && fullness < 0.3;
}

double metresPerUnit(std::string_view unit) {
  const LengthUnit* known = findUnit(unit);
  return known != nullptr ? known->metres : text::parseNumber(unit).value_or(1.0);
}

std::string wordForUnit(double metres) {
  const auto found =
      std::find_if(usualUnits.begin(), usualUnits.end(), [&](const auto& each) { return each.unit.metres == metres; });
  return found != usualUnits.end() ? std::string(found->unit.word) : settings::formatValue(metres);
}

text::Sentence unitInWords(std::string_view unit) {
  const LengthUnit* known = findUnit(unit);
  return known != nullptr ? text::Sentence(known->plural) : text::Sentence("units of {} m", unit);
}

UnitGuess guessUnit(double largestExtent, io::MeshUse use, double fullness) {
  struct Candidate {
    const LengthUnit* unit;
    double misfit;
    double likelihood;
  };
  UnitGuess guess;
  if (!(largestExtent > 0.0)) {
    return guess;
  }
  const Kind kind = kindOf(use, fullness);
  std::vector<Candidate> candidates;
  for (const UsualUnit& each : usualUnits) {
    const double metres = each.unit.metres * largestExtent;
    candidates.push_back({&each.unit, misfit(metres), each.files * frequency(metres, kind.sizes)});
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::pair(a.misfit, -a.likelihood) < std::pair(b.misfit, -b.likelihood);
  });
  guess.unit = candidates.front().unit->word;
  const double metres = candidates.front().unit->metres * largestExtent;
  guess.isUsual = metres >= kind.smallest && metres <= kind.largest;
  constexpr double negligible = 2e-3;  // relative to the likeliest
  for (std::size_t i = 1; i < candidates.size() && candidates[i].misfit <= 1.0; ++i) {
    if (candidates[i].likelihood > negligible * candidates.front().likelihood) {
      guess.others.emplace_back(candidates[i].unit->word);
    }
  }
  return guess;
}

}  // namespace drape::scene
