#include "report/xml_writer.hpp"

namespace drape::report {

std::string escapedXml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= ' ' || c == '\n' || c == '\t') {
          escaped += c;
        }
    }
  }
  return escaped;
}

void XmlWriter::begin(std::string_view element, Attributes attributes) {
  xml_ += '<';
  xml_ += element;
  for (const auto& [name, value] : attributes) {
    xml_ += ' ';
    xml_ += name;
    xml_ += "=\"" + escapedXml(value) + '"';
  }
}

void XmlWriter::open(std::string_view element, Attributes attributes) {
  begin(element, attributes);
  xml_ += ">\n";
  open_.emplace_back(element);
}

void XmlWriter::close() {
  xml_ += "</" + open_.back() + ">\n";
  open_.pop_back();
}

void XmlWriter::empty(std::string_view element, Attributes attributes) {
  begin(element, attributes);
  xml_ += "/>\n";
}

void XmlWriter::text(std::string_view element, std::string_view text, Attributes attributes) {
  begin(element, attributes);
  xml_ += '>' + escapedXml(text) + "</" + std::string(element) + ">\n";
}

std::string XmlWriter::take() {
  while (!open_.empty()) {
    close();
  }
  return std::move(xml_);
}

}  // namespace drape::report
