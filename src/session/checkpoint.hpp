#pragma once

#include "session/simulation.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drape::session {

/// A simulation between two steps, as bytes that a file can keep. A simulation that continues from it takes the same
/// steps to the last bit.
///
/// The bytes begin with a version and a checksum. They also contain a fingerprint of the mesh, those of the
/// other parts of the scene, and the settings.

/// The checkpoint of a simulation. Throws UsageError when it has a ghost, which checkpoints do not contain.
[[nodiscard]] std::string checkpointOf(const Simulation& simulation);

/// Continues from a checkpoint. Throws InputError, and leaves the simulation as it is, when the bytes are not a
/// checkpoint, are damaged, have another version, or belong to another mesh.
/// @returns one sentence for each setting that has another value than in the checkpoint, and for each part of the scene
/// (fingerprintsOf) that has changed since
std::vector<std::string> continueFrom(std::string_view checkpoint, Simulation& simulation);

}  // namespace drape::session
