#pragma once

#include <string>

namespace drape::io {

/// The largest duration of a clip that can be played [s].
inline constexpr double longestClip = 600.0;

/// A clip of a file with a skeletal animation.
struct ClipFacts {
  std::string name;       ///< empty if it has none
  double duration = 0.0;  ///< [s]

  bool operator==(const ClipFacts&) const = default;
};

}  // namespace drape::io
