#include "messages/step_choice_text.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace drape::messages {
namespace {

using text::plural;
using text::Sentence;

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

Sentence lengthInWords(double metres) {
  constexpr double shortest = 1e-9;
  if (metres < shortest) {
    return Sentence("below 1 nm");
  }
  if (metres < 1e-6) {
    return Sentence("about {} nm", brief(metres * 1e9));
  }
  if (metres < 1e-4) {
    return Sentence("about {} \u00B5m", brief(metres * 1e6));
  }
  return metres < 0.1 ? Sentence("about {} mm", brief(metres * 1e3)) : Sentence("about {} m", brief(metres));
}

Sentence clothInWords(double hOmega, const Sentence& scheme) {
  constexpr double soft = 8.0;
  constexpr double stiff = 80.0;
  if (hOmega < soft) {
    return Sentence("soft cloth: {}", scheme);
  }
  return hOmega < stiff ? Sentence("stiff cloth: {}", scheme) : Sentence("very stiff cloth: {}", scheme);
}

Sentence schemeInWords(const sim::adaptive::StepChoice& choice) {
  const int count = choice.substeps;
  if (choice.usedFallback) {
    return Sentence(plural(count, "{} substep of the fallback solver", "{} substeps of the fallback solver"), count);
  }
  if (choice.order == 4) {
    return Sentence(plural(count, "{} explicit substep of fourth order", "{} explicit substeps of fourth order"),
                    count);
  }
  return Sentence(plural(count, "{} explicit substep", "{} explicit substeps"), count);
}

/// How much of its stiffness the cloth has, if that is not all.
Sentence stiffnessInWords(const sim::adaptive::StepChoice& choice) {
  constexpr double almostFull = 0.995;
  Sentence words;
  if (choice.stiffnessScale < almostFull) {
    const std::string share = brief(100.0 * choice.stiffnessScale);
    words = choice.strain < 0.0
                ? Sentence("at {} % of the stiffness", share)
                : Sentence("at {} % of the stretch stiffness: {} % strain", share, brief(100.0 * choice.strain));
  }
  if (const int count = choice.softenedTriangles; count > 0) {
    words =
        words.empty()
            ? Sentence(plural(count, "with {} small triangle softened", "with {} small triangles softened"), count)
            : words.append(", ",
                           Sentence(plural(count, "{} small triangle softened", "{} small triangles softened"), count));
  }
  return words;
}

/// How fast the cloth runs with its full stiffness, if that is slower than real time.
Sentence fullStiffnessInWords(const sim::adaptive::StepChoice& choice, double seconds, double available) {
  constexpr double almostRealTime = 0.95;
  const double load = available > 0.0 ? seconds / available : choice.costRatio;
  const double speed = 1.0 / (load * choice.fullStiffnessCost);
  return choice.fullStiffnessCost > 1.0 && load > 0.0 && speed < almostRealTime
             ? Sentence("full stiffness runs at {}x", brief(speed))
             : Sentence();
}

}  // namespace

text::Sentence inWords(const sim::adaptive::StepChoice& choice, double seconds, double available) {
  if (choice.sleeping) {
    return Sentence("at rest: nothing is computed until something changes");
  }
  Sentence words = clothInWords(choice.hOmega, schemeInWords(choice));
  if (const Sentence stiffness = stiffnessInWords(choice); !stiffness.empty()) {
    words.append(" ", stiffness).append("; ", fullStiffnessInWords(choice, seconds, available));
  }
  if (choice.coarseLevels > 0) {
    words.append(" ", Sentence(plural(choice.coarseLevels, "with {} coarse level", "with {} coarse levels"),
                               choice.coarseLevels));
  }
  if (choice.costRatio > sim::adaptive::toleratedCostRatio) {
    words.append(", ",
                 Sentence(seconds >= available ? "{} times the cost budget: slow motion" : "{} times the cost budget",
                          brief(choice.costRatio)));
  }
  if (available > 0.0) {
    words.append(", ", Sentence("{} ms of {} ms", brief(seconds * 1e3), brief(available * 1e3)));
  }
  if (choice.error >= 0.0) {
    words.append(", ", Sentence("error {}", lengthInWords(choice.error)));
  }
  if (choice.retries > 0) {
    words.append(", ", Sentence(plural(choice.retries, "{} retry", "{} retries"), choice.retries));
  }
  return words;
}

}  // namespace drape::messages
