#pragma once

#include "render/camera.hpp"
#include "session/snapshot.hpp"

namespace drape {

/// A snapshot of a sheet of one square metre that hangs in waves in the x-y plane around (0, 0.9, 0), with its front to
/// +z and two pins; made by hand, so that pictures of it do not depend on how a cloth moves.
/// `waveHeight` in [m]; 0 gives a flat sheet.
[[nodiscard]] Snapshot wavySheet(double waveHeight);

/// A camera that sees all of it from in front.
[[nodiscard]] Camera cameraInFront();

}  // namespace drape
