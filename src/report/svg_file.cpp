#include "report/svg.hpp"
#include "report/svg_ink.hpp"

#include <cstddef>

namespace drape::report {

std::string svgFile(std::string_view svg) {
  // The background is inserted after the opening tag of the picture.
  const std::size_t end = svg.find('>') + 1;
  std::string file = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  file += svg.substr(0, end);
  file += "<rect width=\"100%\" height=\"100%\" fill=\"" + lightColour(Ink::Paper) + "\"/>";
  file += svg.substr(end);
  return file;
}

}  // namespace drape::report
