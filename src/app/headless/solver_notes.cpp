#include "app/headless/solver_notes.hpp"

#include "session/solver_warning.hpp"

#include <iostream>

namespace drape {

void printSolverWarnings(const Settings& settings, const ClothModel& model) {
  if (const std::string words = solverWarning(settings, model); !words.empty()) {
    std::cerr << "warning: " << settings.solver.name << ": " << words << '\n';
  }
  if (const std::string words = ghostWarning(settings, model); !words.empty()) {
    std::cerr << "warning: the ghost's " << settings.ghost.solver << ": " << words << '\n';
  }
}

}  // namespace drape
