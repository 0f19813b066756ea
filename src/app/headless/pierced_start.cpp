#include "app/headless/pierced_start.hpp"

#include "app/dressing/dressing_text.hpp"
#include "dressing/piercing.hpp"

#include <iostream>
#include <vector>

namespace drape::app {

void printPiercedStart(const std::shared_ptr<const scene::Scene>& scene) {
  if (!scene->settings.step.contact.bodies) {
    return;
  }
  const std::vector<dressing::Piercing> piercings =
      dressing::PiercingSearch(scene).find(scene->start.positions, dressing::bodiesAtStart(*scene));
  if (!piercings.empty()) {
    std::cerr << "warning: " << inWords(piercings, *scene)
              << " at the start. 'drape-headless dress' finds a start without intersections.\n";
  }
}

}  // namespace drape::app
