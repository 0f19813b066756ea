#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drape::report {

/// Writes well-formed XML: every element is closed, all text is escaped.
class XmlWriter {
 public:
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string>>;

  void open(std::string_view element, Attributes attributes = {});
  void close();
  /// An element without content.
  void empty(std::string_view element, Attributes attributes = {});
  /// An element with a text.
  void text(std::string_view element, std::string_view text, Attributes attributes = {});
  /// Adds text that is well-formed XML.
  void raw(std::string_view xml) { xml_ += xml; }

  /// The whole text, with all open elements closed.
  [[nodiscard]] std::string take();

 private:
  void begin(std::string_view element, Attributes attributes);

  std::string xml_;
  std::vector<std::string> open_;
};

/// The text with XML's reserved characters replaced. Control characters, which XML does not allow, are removed.
[[nodiscard]] std::string escapedXml(std::string_view text);

}  // namespace drape::report
