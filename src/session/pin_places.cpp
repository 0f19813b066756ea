#include "session/pin_places.hpp"

namespace drape::session {

void placeVertices(const std::vector<int>& vertices, const std::vector<Vec3>& places, sim::ClothState& state) {
  state.hasNoSelfIntersection = false;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    state.positions[vertices[i]] = places[i];
    state.velocities[vertices[i]].setZero();
  }
}

}  // namespace drape::session
