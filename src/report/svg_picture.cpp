#include "report/svg_picture.hpp"

#include "report/svg_ink.hpp"

namespace drape::report {

void openPicture(XmlWriter& svg, const std::string& title, const std::string& width, const std::string& height,
                 const std::string& titleX) {
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"class", "drape " + fillClass(Ink::Text)},
                   {"role", "img"},
                   {"width", width},
                   {"height", height},
                   {"viewBox", "0 0 " + width + " " + height},
                   {"font-family", "sans-serif"},
                   {"font-size", "12"},
                   {"fill", lightColour(Ink::Text)}});
  svg.text("title", title);
  svg.text("text", title, {{"font-size", "14"}, {"font-weight", "bold"}, {"x", titleX}, {"y", "20"}});
}

}  // namespace drape::report
