#pragma once

#include "report/xml_writer.hpp"

#include <string>

namespace drape::report {

/// Opens the svg element of a picture and writes its title.
/// @param width, height in pixels, as text
void openPicture(XmlWriter& svg, const std::string& title, const std::string& width, const std::string& height,
                 const std::string& titleX);

}  // namespace drape::report
