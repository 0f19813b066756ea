#pragma once

#include "text/sentence.hpp"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

namespace drape::text {

/// The texts of one language, by the English ones in the sources. A text without an entry stays English. Copies share
/// their entries.
///
/// Where a word has two meanings, its key names one before a bar, which is not shown: "camera|Frame".
class Catalogue {
 public:
  using Entries = std::map<std::string, std::string, std::less<>>;

  /// English.
  Catalogue() = default;
  explicit Catalogue(Entries entries) : entries_(std::make_shared<const Entries>(std::move(entries))) {}

  [[nodiscard]] std::string operator()(std::string_view english) const;
  [[nodiscard]] std::string operator()(const Sentence& sentence) const;

  /// The template in this language, with its placeholders filled as those of a Sentence.
  template <typename First, typename... Others>
  [[nodiscard]] std::string operator()(std::string_view english, const First& first, const Others&... others) const {
    return (*this)(Sentence(english, first, others...));
  }

  /// Adds every text that has no entry to this set; null: none. For tests.
  void reportMissing(std::set<std::string>* missing) { missing_ = missing; }

 private:
  std::shared_ptr<const Entries> entries_;  // null: English
  std::set<std::string>* missing_ = nullptr;
};

}  // namespace drape::text
