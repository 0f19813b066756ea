#include "sim/contact/broad_phase/prepared_cloth.hpp"

#include "sim/contact/inverse_mass.hpp"
#include "sim/model/mesh_topology.hpp"

namespace drape::sim::contact {

PreparedCloth::PreparedCloth(const ClothModel& model, std::uint64_t identity)
    : number(identity),
      clusters(model),
      owned(ownedFeatures(model.triangles, model.restPositions.size())),
      pieces(componentsOf(model.triangles, model.restPositions.size()).lowestVertex),
      inverseMass(inverseMassOf(model)) {}

}  // namespace drape::sim::contact
