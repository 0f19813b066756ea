#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace drape::report::testing {

/// The defect of an XML text: an element that is not closed, an attribute without quotes, a bare '&' or '<'. Empty when
/// it is well formed. Supports elements, attributes, text, the XML declaration and DOCTYPE, as in the report.
class XmlCheck {
 public:
  [[nodiscard]] static std::string faultOf(std::string_view xml) { return XmlCheck(xml).check(); }

 private:
  explicit XmlCheck(std::string_view xml) : xml_(xml) {}

  std::string check() {
    while (at_ < xml_.size() && fault_.empty()) {
      if (xml_[at_] == '<') {
        element();
      } else if (xml_[at_] == '&') {
        entity();
      } else {
        ++at_;
      }
    }
    return !fault_.empty() ? fault_ : open_.empty() ? "" : "not closed: " + open_.back();
  }

  void entity() {
    for (const std::string_view known : {"&amp;", "&lt;", "&gt;", "&quot;"}) {
      if (xml_.substr(at_).starts_with(known)) {
        at_ += known.size();
        return;
      }
    }
    fault_ = "a bare '&'";
  }

  void element() {
    const std::size_t end = xml_.find('>', at_);
    if (end == std::string_view::npos) {
      fault_ = "'<' without '>'";
      return;
    }
    std::string_view inside = xml_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    if (inside.starts_with('?') || inside.starts_with('!')) {
      return;
    }
    if (inside.starts_with('/')) {
      close(inside.substr(1));
      return;
    }
    const bool empty = inside.ends_with('/');
    inside.remove_suffix(empty ? 1 : 0);
    const std::string name(inside.substr(0, inside.find(' ')));
    attributes(inside.substr(name.size()));
    if (!empty) {
      open_.push_back(name);
    }
  }

  void close(std::string_view name) {
    if (open_.empty() || open_.back() != name) {
      fault_ = "closes " + std::string(name) + " where that is not open";
    } else {
      open_.pop_back();
    }
  }

  void attributes(std::string_view text) {
    while (!text.empty() && fault_.empty()) {
      const std::size_t quote = text.find("=\"");
      const std::size_t end = quote == std::string_view::npos ? quote : text.find('"', quote + 2);
      if (text[0] != ' ' || end == std::string_view::npos ||
          text.substr(quote, end - quote).find('<') != std::string_view::npos) {
        fault_ = "a wrong attribute in" + std::string(text);
        return;
      }
      text = text.substr(end + 1);
    }
  }

  std::string_view xml_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  std::string fault_;
};

}  // namespace drape::report::testing
