#include "messages/step_choice_text.hpp"

#include "messages/length_text.hpp"

namespace drape::messages {
namespace {

using text::plural;
using text::Sentence;

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
  if (choice.order == 1) {
    return Sentence(plural(count, "{} implicit substep for taut cloth", "{} implicit substeps for taut cloth"), count);
  }
  return Sentence(plural(count, "{} explicit substep", "{} explicit substeps"), count);
}

/// How much of its stiffness the cloth has, if that is not all.
Sentence stiffnessInWords(const sim::adaptive::StepChoice& choice, const Sentence& fabric) {
  constexpr double almostFull = 0.995;
  Sentence words;
  if (choice.stiffnessScale < almostFull) {
    const std::string share = brief(100.0 * choice.stiffnessScale);
    words = choice.strain < 0.0 ? Sentence("at {} % of the stiffness", share)
                                : Sentence("at {} % of the stretch stiffness of {}: {} % strain", share, fabric,
                                           brief(100.0 * choice.strain));
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

/// How fast the cloth runs with its full stiffness, if that is slower than real time. Without a measured time, how
/// often it exceeds the cost budget.
Sentence fullStiffnessInWords(const sim::adaptive::StepChoice& choice, double seconds, double available) {
  constexpr double almostRealTime = 0.95;
  const double load = (available > 0.0 ? seconds / available : choice.costRatio) * choice.fullStiffnessCost;
  if (choice.fullStiffnessCost <= 1.0 || load * almostRealTime <= 1.0) {
    return {};
  }
  return available > 0.0 ? Sentence("full stiffness runs at {}x", brief(1.0 / load))
                         : Sentence("full stiffness costs {} times the budget", brief(load));
}

}  // namespace

text::Sentence inWords(const sim::adaptive::StepChoice& choice, const text::Sentence& fabric, double seconds,
                       double available) {
  if (choice.sleeping) {
    return Sentence("at rest: nothing is computed until something changes");
  }
  Sentence words = clothInWords(choice.hOmega, schemeInWords(choice));
  if (const Sentence stiffness = stiffnessInWords(choice, fabric); !stiffness.empty()) {
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
  if (choice.retries > 0) {
    words.append(", ", Sentence(plural(choice.retries, "{} retry", "{} retries"), choice.retries));
  }
  return words;
}

}  // namespace drape::messages
