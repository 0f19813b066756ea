#pragma once

#include "render/camera.hpp"
#include "session/snapshot.hpp"

namespace drape::render {

/// A snapshot of a sheet of one square metre with waves, in the x-y plane around (0, 0.9, 0), with its front to +z and
/// two pins. It is constructed directly, so that its pictures do not depend on the simulation. `waveHeight` in [m]; 0
/// gives a flat sheet.
[[nodiscard]] session::Snapshot wavySheet(double waveHeight);

/// A camera in front that sees all of it.
[[nodiscard]] Camera cameraInFront();

}  // namespace drape::render
