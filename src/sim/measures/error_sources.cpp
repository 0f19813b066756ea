#include "sim/measures/error_sources.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace drape::sim {

ErrorSource dominantSource(const ErrorSources& sources) {
  const std::array all{std::pair(sources.start, ErrorSource::Chaos), std::pair(sources.method, ErrorSource::Method),
                       std::pair(sources.mesh, ErrorSource::Mesh), std::pair(sources.material, ErrorSource::Material)};
  return std::ranges::max_element(all, {}, &std::pair<double, ErrorSource>::first)->second;
}

}  // namespace drape::sim
