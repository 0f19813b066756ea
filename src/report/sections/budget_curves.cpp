#include "report/sections/budget_curves.hpp"

#include "report/sections/stable_substeps.hpp"

#include <string>
#include <utility>

namespace drape::report::sections {
namespace {

using Words = std::vector<std::string>;

/// Multiples of the first number of substeps that is stable.
Words substepsOf(const char* solver, const scene::Scene& scene) {
  const int first = stableSubsteps(*sim::findSolver(solver), *scene.model, scene.settings.step);
  Words words;
  for (const int factor : {1, 2, 4, 8}) {
    words.push_back(std::to_string(factor * first));
  }
  return words;
}

Words with(Words words, const char* more) {
  words.emplace_back(more);
  return words;
}

}  // namespace

std::vector<MethodCurve> budgetCurves(const scene::Scene& scene) {
  const bool fabric = scene.model->fabric != nullptr;
  const Words exact{"auto.tolerance=1e-12", "precision=float"};
  const Words costs{"1", "3", "10", "30", "100", "300", "1000", "3000"};
  const Words doubled{"1", "2", "4", "8", "16", "32", "64"};
  std::vector<MethodCurve> curves{
      {"auto", "auto", with(exact, fabric ? "auto.strain=0" : "auto.soften=off"), "auto.cost", costs, {"100"}},
      {"auto, softer if needed",
       "auto",
       with(exact, fabric ? "auto.strain=0.01" : "auto.soften=on"),
       "auto.cost",
       costs,
       {}},
      {"Verlet", "verlet", {"precision=float"}, "substeps", substepsOf("verlet", scene), {}},
      {"one iteration", "one_iteration", {"precision=float"}, "substeps", doubled, {"1"}},
      {"one iteration, theta 0.5",
       "one_iteration",
       {"precision=float", "integration=theta", "theta=0.5"},
       "substeps",
       doubled,
       {}},
      {"XPBD", "xpbd", {"precision=float", "iterations=1"}, "substeps", doubled, {"4"}},
      {"CG, BDF2", "pcg", {"tolerance=1e-3", "integration=bdf2"}, "substeps", doubled, {}},
      {"Newton", "newton", {"tolerance=1e-6", "derivative=exact", "max_iterations=50"}, "substeps", {"1", "4"}, {}},
  };
  std::erase_if(curves,
                [&](const MethodCurve& curve) { return fabric && !sim::findSolver(curve.method)->takesFabric; });
  return curves;
}

}  // namespace drape::report::sections
