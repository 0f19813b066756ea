#include "app/headless/end_warnings.hpp"

#include "scene/scene.hpp"
#include "session/snapshot.hpp"

#include <iostream>

namespace drape::app {

void printEndWarnings(const session::Simulation& simulation) {
  session::Snapshot end;
  simulation.capture(end);
  if (!end.message.empty() && !simulation.blewUp()) {
    std::cerr << "warning: " << end.message << '\n';
  }
  if (end.overstretched) {
    const scene::Advice& advice = end.overstretched->advice;
    if (advice.text != end.message && !simulation.blewUp()) {
      std::cerr << "warning: " << advice.text << '\n';
    }
    if (!advice.key.empty()) {
      std::cerr << "note: --set " << advice.key << '=' << advice.value << " would help\n";
    }
  }
  if (const int pairs = end.stepReport.contact.intersections; pairs > 0) {
    std::cerr << "warning: at the start of the last step, " << pairs << (pairs == 1 ? " pair" : " pairs")
              << " of triangles of the cloth intersected\n";
  }
}

}  // namespace drape::app
