#include "report/sections/method_curves.hpp"

#include <algorithm>

namespace drape::report::sections {
namespace {

using Words = std::vector<std::string>;

Words upTo(int max) {
  Words words;
  for (int value = 1; value <= max; value *= 2) {
    words.push_back(std::to_string(value));
  }
  return words;
}

/// For slow methods: their small steps would take most of a report's time and add little.
Words few() {
  return {"1", "4", "16"};
}

/// All steps are 1/150 s; substeps stand for shorter steps.
std::vector<MethodCurve> listed() {
  const Words midpoint{"integration=theta", "theta=0.5"};
  // The exact derivative makes Newton's method fast. A solve that needs more than 50 iterations is stuck in buckling,
  // and one step would take seconds.
  const Words newton{"tolerance=1e-6", "derivative=exact", "max_iterations=50"};
  // Stiff and fine cloth needs many substeps.
  Words many = upTo(512);
  many.emplace_back("1000");
  const Words works{"3", "6", "8", "10", "14", "20", "30", "45", "60", "100", "300", "1000"};
  // `auto` should use its whole cost budget and no more, so it softens the springs when needed.
  const Words budgeted{"auto.tolerance=1e-12", "auto.soften=on"};
  const Words thetas{"1", "0.75", "0.6", "0.55", "0.5"};
  return {
      {"one iteration, substeps", "one_iteration", {}, "substeps", upTo(64), {"1", "4", "16"}},
      {"one iteration, sweeps", "one_iteration", {}, "sweeps", {"1", "3", "5", "9", "17", "33"}, {"3", "9"}},
      {"one iteration, float, substeps", "one_iteration", {"precision=float"}, "substeps", upTo(64), {"16"}},
      {"one iteration, theta 0.5, substeps", "one_iteration", midpoint, "substeps", upTo(64), {"4", "16"}},
      {"one iteration, 4 substeps, theta",
       "one_iteration",
       {"substeps=4", "integration=theta"},
       "theta",
       thetas,
       {"0.5", "0.75"}},
      {"auto, cost", "auto", budgeted, "auto.cost", works, {"30"}},
      {"auto, float, cost", "auto", {budgeted[0], budgeted[1], "precision=float"}, "auto.cost", works, {"30"}},
      {"auto, float, softer if needed, cost",
       "auto",
       {budgeted[0], "auto.strain=0.01", "precision=float"},
       "auto.cost",
       works,
       {"30"},
       true},
      {"Chebyshev, iterations", "chebyshev", {}, "iterations", {"3", "5", "9", "17", "33"}, {"9"}},
      {"Chebyshev 5, substeps", "chebyshev", {"iterations=5"}, "substeps", upTo(32), {"4"}},
      {"CG, tolerance", "pcg", {}, "tolerance", {"0.3", "0.1", "1e-2", "1e-3", "1e-5"}, {"1e-2"}},
      {"CG 1e-3, substeps", "pcg", {"tolerance=1e-3"}, "substeps", upTo(16), {"4"}},
      {"CG 1e-3, BDF2, substeps", "pcg", {"tolerance=1e-3", "integration=bdf2"}, "substeps", upTo(16), {"4"}},
      {"CG 1e-3, theta", "pcg", {"tolerance=1e-3", "integration=theta"}, "theta", thetas, {"0.5"}},
      {"Newton, substeps", "newton", newton, "substeps", few(), {"1"}},
      {"Newton, theta 0.5, substeps",
       "newton",
       {newton[0], newton[1], newton[2], midpoint[0], midpoint[1]},
       "substeps",
       few(),
       {"1"}},
      {"Verlet, substeps", "verlet", {}, "substeps", many, {"1", "2", "4", "16"}},
      {"Verlet, float, substeps", "verlet", {"precision=float"}, "substeps", many, {"16"}},
      {"explicit Euler, substeps", "explicit_euler", {}, "substeps", {"16", "64", "200", "800"}, {"200"}},
      {"XPBD 1, substeps", "xpbd", {"iterations=1"}, "substeps", upTo(64), {"4", "16"}},
      {"XPBD 1, float, substeps", "xpbd", {"iterations=1", "precision=float"}, "substeps", upTo(64), {"16"}},
      {"XPBD, iterations", "xpbd", {}, "iterations", {"1", "3", "10", "30", "100"}, {"10"}},
      {"VBD 3, substeps", "vbd", {"iterations=3"}, "substeps", few(), {"4"}},
      {"VBD, iterations", "vbd", {}, "iterations", {"3", "10", "30", "100"}, {"10"}},
      {"local/global, iterations", "local_global", {}, "iterations", {"1", "3", "10", "30"}, {"10"}},
      {"local/global 10, substeps", "local_global", {"iterations=10"}, "substeps", few(), {"4"}},
  };
}

}  // namespace

bool hasVectorLoops(const sim::SolverInfo& solver) {
  return std::find(solver.settings.begin(), solver.settings.end(), "precision") != solver.settings.end();
}

std::vector<MethodCurve> methodCurves() {
  std::vector<MethodCurve> curves = listed();
  for (const sim::SolverInfo& solver : sim::solverTable()) {
    const auto isIts = [&](const MethodCurve& curve) { return curve.method == solver.name; };
    if (std::none_of(curves.begin(), curves.end(), isIts)) {
      const std::string name(solver.name);
      curves.push_back({name + ", substeps", name, {}, "substeps", few(), {"4"}});
    }
  }
  return curves;
}

}  // namespace drape::report::sections
