#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace drape {

/// What a program was built from, and how.
struct BuildInfo {
  std::string compiler;
  std::string flags;
  std::string buildType;
  std::string commit;  ///< "unknown" when it was not built from a git checkout
};

/// The machine that the program runs on and the build, for the head of a report: cpu, cores, simd, compiler, flags,
/// build_type, commit, date.
[[nodiscard]] nlohmann::ordered_json machineJson(const BuildInfo& build);

}  // namespace drape
