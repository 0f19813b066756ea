#include "report/machine.hpp"

#include "sim/simd/simd_target.hpp"

#include <array>
#include <ctime>
#include <fstream>
#include <thread>

namespace drape::report {
namespace {

std::string cpuModel() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

/// The current time, "2024-05-31 12:00 UTC".
std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  std::array<char, 40> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", &parts);
  return text.data();
}

}  // namespace

nlohmann::ordered_json machineJson(const BuildInfo& build) {
  return {{"cpu", cpuModel()},
          {"cores", std::thread::hardware_concurrency()},
          {"simd", sim::simd::simdTarget()},
          {"compiler", build.compiler},
          {"flags", build.flags},
          {"build_type", build.buildType},
          {"commit", build.commit},
          {"date", now()}};
}

}  // namespace drape::report
