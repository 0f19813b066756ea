#pragma once

namespace drape {

/// How long this process has existed, from the kernel's record of its start [s]. To a hundredth of a second; 0 where
/// the kernel does not tell.
[[nodiscard]] double processAge();

}  // namespace drape
