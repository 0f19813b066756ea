#include "messages/step_choice_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace drape::messages {
namespace {

/// Two significant digits, without an exponent.
std::string brief(double value) {
  const double size = value > 0.0 ? std::floor(std::log10(value)) : 0.0;
  const int decimals = std::clamp(1 - static_cast<int>(size), 0, 9);
  std::string words = fmt::format("{:.{}f}", value, decimals);
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

std::string hOmegaInWords(double hOmega) {
  constexpr double soft = 8.0;
  constexpr double stiff = 80.0;
  if (hOmega < soft) {
    return "soft cloth: ";
  }
  return hOmega < stiff ? "stiff cloth: " : "very stiff cloth: ";
}

std::string schemeInWords(const sim::adaptive::StepChoice& choice) {
  std::string words = std::to_string(choice.substeps);
  words += choice.usedFallback ? " substep" : " explicit substep";
  words += choice.substeps == 1 ? "" : "s";
  if (choice.usedFallback) {
    return words + " of the fallback solver";
  }
  return choice.order == 4 ? words + " of fourth order" : words;
}

/// How much of its stiffness the cloth has, if that is not all.
std::string stiffnessInWords(const sim::adaptive::StepChoice& choice) {
  constexpr double almostFull = 0.995;
  std::string words;
  if (choice.stiffnessScale < almostFull) {
    words = " at " + brief(100.0 * choice.stiffnessScale) + " % of the ";
    words += choice.strain < 0.0 ? "stiffness" : "stretch stiffness: " + brief(100.0 * choice.strain) + " % strain";
  }
  if (choice.softenedTriangles > 0) {
    words += words.empty() ? " with " : ", ";
    words += std::to_string(choice.softenedTriangles);
    words += choice.softenedTriangles == 1 ? " small triangle softened" : " small triangles softened";
  }
  return words;
}

/// How fast the cloth runs with its full stiffness, if that is slower than real time.
std::string fullStiffnessInWords(const sim::adaptive::StepChoice& choice, double seconds, double available) {
  constexpr double almostRealTime = 0.95;
  const double load = available > 0.0 ? seconds / available : choice.costRatio;
  const double speed = 1.0 / (load * choice.fullStiffnessCost);
  return choice.fullStiffnessCost > 1.0 && load > 0.0 && speed < almostRealTime
             ? "; full stiffness runs at " + brief(speed) + "x"
             : std::string();
}

}  // namespace

std::string inWords(const sim::adaptive::StepChoice& choice, double seconds, double available) {
  if (choice.sleeping) {
    return "at rest: nothing is computed until something changes";
  }
  std::string words = hOmegaInWords(choice.hOmega) + schemeInWords(choice);
  if (const std::string stiffness = stiffnessInWords(choice); !stiffness.empty()) {
    words += stiffness + fullStiffnessInWords(choice, seconds, available);
  }
  if (choice.coarseLevels > 0) {
    words += choice.coarseLevels == 1 ? " with 1 coarse level"
                                      : " with " + std::to_string(choice.coarseLevels) + " coarse levels";
  }
  if (choice.costRatio > sim::adaptive::toleratedCostRatio) {
    words += ", " + brief(choice.costRatio) + " times the cost budget";
    words += seconds >= available ? ": slow motion" : "";
  }
  if (available > 0.0) {
    words += ", " + brief(seconds * 1e3) + " ms of " + brief(available * 1e3) + " ms";
  }
  if (choice.error >= 0.0) {
    words += ", error " + lengthInWords(choice.error);
  }
  if (choice.retries > 0) {
    words += choice.retries == 1 ? ", 1 retry" : ", " + std::to_string(choice.retries) + " retries";
  }
  return words;
}

}  // namespace drape::messages
