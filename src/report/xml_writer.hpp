#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace drape {

/// Writes XML that is well formed: every element is closed, all text is escaped.
class XmlWriter {
 public:
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string>>;

  void open(std::string_view element, Attributes attributes = {});
  void close();
  /// An element without content.
  void empty(std::string_view element, Attributes attributes = {});
  /// An element that holds a text.
  void text(std::string_view element, std::string_view text, Attributes attributes = {});
  /// What is well-formed XML already.
  void raw(std::string_view xml) { xml_ += xml; }

  /// All that was written; every element that is still open is closed.
  [[nodiscard]] std::string take();

 private:
  void begin(std::string_view element, Attributes attributes);

  std::string xml_;
  std::vector<std::string> open_;
};

/// The text with what XML reserves replaced. Control characters, which XML does not have, are left out.
[[nodiscard]] std::string escapedXml(std::string_view text);

}  // namespace drape
