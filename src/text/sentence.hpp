#pragma once

#include <concepts>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace drape::text {

/// A sentence, or a part of one, that can be shown in every language of a Catalogue: an English template, and what
/// fills its placeholders. `{}` stands for the next argument; `{0}` and `{1}` name arguments, so that a translation can
/// take them in another order. A sentence with a number needs one template for one thing and one for several.
///
///     Sentence("{} is {} m long", name, figure(length))
class Sentence {
 public:
  Sentence() = default;

  /// @param english the template, which the catalogues have  @param arguments names, whole numbers and other sentences;
  /// only sentences are translated
  template <typename... Arguments>
  explicit Sentence(std::string_view english, const Arguments&... arguments) {
    Part& part = parts_.emplace_back();
    part.english = english;
    (part.arguments.push_back(asArgument(arguments)), ...);
  }

  /// A name, a number, or a text that is not translated.
  [[nodiscard]] static Sentence verbatim(std::string_view text);

  [[nodiscard]] bool empty() const { return parts_.empty(); }
  [[nodiscard]] std::string english() const;

  /// Adds another one after a text between them, which is left out where one of them is empty.
  Sentence& append(std::string_view separator, const Sentence& more);

  bool operator==(const Sentence& other) const = default;

 private:
  friend class Catalogue;

  struct Part {
    std::string english;
    bool isVerbatim = false;
    std::vector<Sentence> arguments;

    bool operator==(const Part& other) const = default;
  };

  static Sentence asArgument(const Sentence& sentence) { return sentence; }
  static Sentence asArgument(std::string_view text) { return verbatim(text); }
  static Sentence asArgument(std::integral auto number) { return verbatim(std::to_string(number)); }

  std::vector<Part> parts_;
};

/// Compares and writes the English text, for tests and the command line.
[[nodiscard]] bool operator==(const Sentence& sentence, std::string_view english);
std::ostream& operator<<(std::ostream& out, const Sentence& sentence);

/// One of two sentences: for one thing, and for any other number of them.
[[nodiscard]] inline std::string_view plural(long long count, std::string_view one, std::string_view many) {
  return count == 1 ? one : many;
}

/// The template with its placeholders replaced. A template without arguments is not changed.
[[nodiscard]] std::string filled(std::string_view pattern, const std::vector<std::string>& arguments);

/// The indices of the arguments that a template names, in order: "{1} of {0}" has 1 and 0, "{} of {}" has 0 and 1.
[[nodiscard]] std::vector<std::size_t> placeholdersOf(std::string_view pattern);

}  // namespace drape::text
