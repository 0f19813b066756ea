#pragma once

namespace drape::app {

/// The age of this process, from the kernel's record of its start [s]. To a hundredth of a second; 0 when unknown.
[[nodiscard]] double processAge();

}  // namespace drape::app
