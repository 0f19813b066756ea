#include "sim/adaptive/step_choice.hpp"

#include <algorithm>

namespace drape::sim::adaptive {

void StepChoice::add(const StepChoice& next) {
  const StepChoice before = *this;
  *this = next;
  substeps += before.substeps;
  forceEvaluations += before.forceEvaluations;
  retries += before.retries;
  hOmega += before.hOmega;
  costRatio = std::max(costRatio, before.costRatio);
  stiffnessScale = std::min(stiffnessScale, before.stiffnessScale);
  inParts = inParts || before.inParts;
  usedFallback = usedFallback || before.usedFallback;
  sleeping = sleeping && before.sleeping;
}

std::vector<std::pair<std::string_view, double>> figuresOf(const StepChoice& choice) {
  return {{"order", choice.order},
          {"substeps", choice.substeps},
          {"force_evaluations", choice.forceEvaluations},
          {"h_omega", choice.hOmega},
          {"cost_ratio", choice.costRatio},
          {"stiffness_scale", choice.stiffnessScale},
          {"strain", choice.strain},
          {"softened_triangles", choice.softenedTriangles},
          {"full_stiffness_cost", choice.fullStiffnessCost},
          {"coarse_levels", choice.coarseLevels},
          {"retries", choice.retries},
          {"error", choice.error},
          {"energy_drift", choice.energyDrift},
          {"used_fallback", choice.usedFallback ? 1.0 : 0.0},
          {"sleeping", choice.sleeping ? 1.0 : 0.0}};
}

}  // namespace drape::sim::adaptive
