#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace drape::report {

/// The build of a program.
struct BuildInfo {
  std::string compiler;
  std::string flags;
  std::string buildType;
  std::string commit;  ///< "unknown" outside a git checkout
};

/// The machine and the build, for the head of a report: cpu, cores, simd, compiler, flags, build_type, commit, date.
[[nodiscard]] nlohmann::ordered_json machineJson(const BuildInfo& build);

}  // namespace drape::report
