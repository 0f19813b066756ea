#include "sim/contact/inverse_mass.hpp"

namespace drape::sim::contact {

std::vector<double> inverseMassOf(const ClothModel& model) {
  std::vector<double> inverse(model.vertexMass.size());
  for (std::size_t v = 0; v < inverse.size(); ++v) {
    inverse[v] = model.pinned[v] ? 0.0 : 1.0 / model.vertexMass[v];
  }
  return inverse;
}

}  // namespace drape::sim::contact
