#include "app/headless/solver_notes.hpp"

#include "session/solver_warning.hpp"

#include <iostream>

namespace drape::app {

void printSolverWarnings(const settings::Settings& settings, const sim::ClothModel& model) {
  if (const text::Sentence words = session::solverWarning(settings, model); !words.empty()) {
    std::cerr << "warning: " << settings.solver.name << ": " << words << '\n';
  }
  if (const text::Sentence words = session::ghostWarning(settings, model); !words.empty()) {
    std::cerr << "warning: the ghost's " << settings.ghost.solver << ": " << words << '\n';
  }
}

}  // namespace drape::app
