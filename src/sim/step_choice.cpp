#include "sim/step_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace drape {
namespace {

/// Two significant digits, without an exponent.
std::string brief(double value) {
  std::array<char, 32> text{};
  const double size = value > 0.0 ? std::floor(std::log10(value)) : 0.0;
  const int decimals = std::clamp(1 - static_cast<int>(size), 0, 9);
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  std::string words = text.data();
  if (words.find('.') != std::string::npos) {
    words.erase(words.find_last_not_of('0') + 1);
    if (words.back() == '.') {
      words.pop_back();
    }
  }
  return words;
}

std::string lengthInWords(double metres) {
  constexpr double shortest = 1e-9;
  if (metres < shortest) {
    return "below 1 nm";
  }
  if (metres < 1e-6) {
    return "about " + brief(metres * 1e9) + " nm";
  }
  if (metres < 1e-4) {
    return "about " + brief(metres * 1e6) + " \u00B5m";
  }
  return metres < 0.1 ? "about " + brief(metres * 1e3) + " mm" : "about " + brief(metres) + " m";
}

std::string hardnessInWords(double hardness) {
  constexpr double soft = 8.0;
  constexpr double stiff = 80.0;
  if (hardness < soft) {
    return "soft cloth: ";
  }
  return hardness < stiff ? "stiff cloth: " : "very stiff cloth: ";
}

std::string schemeInWords(const StepChoice& choice) {
  std::string words = std::to_string(choice.substeps);
  words += choice.lastResort ? " substep" : " explicit substep";
  words += choice.substeps == 1 ? "" : "s";
  if (choice.lastResort) {
    return words + " of XPBD";
  }
  return choice.order == 4 ? words + " of fourth order" : words;
}

}  // namespace

void StepChoice::add(const StepChoice& next) {
  const StepChoice before = *this;
  *this = next;
  substeps += before.substeps;
  passes += before.passes;
  retaken += before.retaken;
  hardness += before.hardness;
  demand = std::max(demand, before.demand);
  stiffness = std::min(stiffness, before.stiffness);
  lastResort = lastResort || before.lastResort;
  resting = resting && before.resting;
}

std::vector<std::pair<std::string_view, double>> figuresOf(const StepChoice& choice) {
  return {{"order", choice.order},
          {"substeps", choice.substeps},
          {"passes", choice.passes},
          {"hardness", choice.hardness},
          {"demand", choice.demand},
          {"stiffness", choice.stiffness},
          {"levels", choice.levels},
          {"retaken", choice.retaken},
          {"error", choice.error},
          {"gained", choice.gained},
          {"last_resort", choice.lastResort ? 1.0 : 0.0},
          {"resting", choice.resting ? 1.0 : 0.0}};
}

std::string inWords(const StepChoice& choice, double seconds, double available) {
  constexpr double allOfIt = 0.995;
  if (choice.resting) {
    return "at rest: nothing to do until something changes";
  }
  std::string words = hardnessInWords(choice.hardness) + schemeInWords(choice);
  if (choice.stiffness < allOfIt) {
    words += " at " + brief(100.0 * choice.stiffness) + " % of the stiffness";
  }
  if (choice.levels > 0) {
    words += choice.levels == 1 ? " with 1 coarse level" : " with " + std::to_string(choice.levels) + " coarse levels";
  }
  if (choice.demand > stretchedBudget) {
    words += ", " + brief(choice.demand) + " times the work allowed";
    words += seconds >= available ? ": slow motion" : "";
  }
  if (available > 0.0) {
    words += ", " + brief(seconds * 1e3) + " ms of " + brief(available * 1e3) + " ms";
  }
  if (choice.error >= 0.0) {
    words += ", error " + lengthInWords(choice.error);
  }
  if (choice.retaken > 0) {
    words += choice.retaken == 1 ? ", taken again once" : ", taken again " + std::to_string(choice.retaken) + " times";
  }
  return words;
}

}  // namespace drape
