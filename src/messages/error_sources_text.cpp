#include "messages/error_sources_text.hpp"

#include "messages/length_text.hpp"
#include "sim/measures/accuracy.hpp"

#include <cmath>
#include <string>

namespace drape::messages {
namespace {

using text::Sentence;

/// A distance after a time; where it is infinite, the cloth blew up.
Sentence afterTime(double metres, const std::string& seconds) {
  return std::isfinite(metres) ? Sentence("{} after {} s", lengthInWords(metres), seconds)
                               : Sentence("the cloth blew up before {} s", seconds);
}

}  // namespace

text::Sentence inWords(const sim::ErrorSources& sources) {
  const std::string seconds = brief(sources.time);
  switch (sim::dominantSource(sources)) {
    case sim::ErrorSource::Method:
      return Sentence("Most of the error comes from the method: {}", afterTime(sources.method, seconds));
    case sim::ErrorSource::Mesh:
      return Sentence("Most of the error comes from the mesh: {}", afterTime(sources.mesh, seconds));
    case sim::ErrorSource::Material:
      return Sentence("A material that is stiffer by a tenth changes most: {}", afterTime(sources.material, seconds));
    case sim::ErrorSource::Chaos:
      break;
  }
  if (!std::isfinite(sources.start)) {
    return Sentence("The motion cannot be known: {}", afterTime(sources.start, seconds));
  }
  return Sentence("The motion cannot be known: starts {} \u00B5m apart are {} apart after {} s",
                  brief(sim::testDisplacement * 1e6), lengthInWords(sources.start), seconds);
}

}  // namespace drape::messages
