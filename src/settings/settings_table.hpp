#pragma once

#include "messages/error.hpp"
#include "settings/settings.hpp"
#include "text/sentence.hpp"

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace drape::settings {

/// Values that are each allowed exclude each other.
class ConflictError : public messages::UsageError {
 public:
  /// @param keys of the settings concerned, the most likely cause first
  ConflictError(std::vector<std::string_view> keys, const std::string& message)
      : UsageError(message), keys_(std::move(keys)) {}

  [[nodiscard]] const std::vector<std::string_view>& keys() const { return keys_; }

 private:
  std::vector<std::string_view> keys_;
};

using SettingValue = std::variant<double, int, bool, std::string>;

/// Access to one member of the settings for reading and for writing.
template <typename T>
struct SettingAccess {
  const T& (*get)(const Settings&);
  T& (*ref)(Settings&);

  /// @param accessor `[](auto& settings) -> auto& { return settings.member; }`
  template <typename Accessor, typename = std::enable_if_t<std::is_invocable_r_v<T&, Accessor, Settings&>>>
  constexpr SettingAccess(Accessor /*accessor*/)
      : get([](const Settings& settings) -> const T& { return Accessor()(settings); }),
        ref([](Settings& settings) -> T& { return Accessor()(settings); }) {}
};

/// A real number within a closed range.
struct NumberField {
  SettingAccess<double> access;
  double min;
  double max;
  bool logarithmic;  ///< whether a slider is logarithmic
};

/// A whole number within a closed range.
struct IntegerField {
  SettingAccess<int> access;
  int min;
  int max;
};

/// On or off.
struct FlagField {
  SettingAccess<bool> access;
};

/// The name of a choice on the panel, and its meaning in one sentence. Both may be empty.
struct ChoiceLabel {
  std::string_view title;
  std::string_view help;
};

/// A choice that depends on the settings, as a fabric of the user.
struct OwnChoice {
  std::string word;
  std::string title;
  text::Sentence help;
};

/// One of a list of words, or another text that `accepts` allows.
struct ChoiceField {
  std::string (*get)(const Settings&);
  void (*set)(Settings&, const std::string&);  ///< takes one of the choices
  std::vector<std::string> (*choices)();
  ChoiceLabel (*label)(std::string_view word) = nullptr;  ///< of a word; null: the words need no label
  bool (*accepts)(std::string_view text) = nullptr;       ///< whether another text is allowed; null: words only
  std::string_view otherTexts = {};                       ///< what `accepts` allows, for messages
  std::vector<OwnChoice> (*ownChoices)(const Settings&) = nullptr;  ///< further choices; null: none
};

using SettingField = std::variant<NumberField, IntegerField, FlagField, ChoiceField>;

/// One setting, declared once. The panels, the command line, the scene files and the documentation read it here.
struct SettingInfo {
  std::string_view key;    ///< on the command line and in scene files: "wind.x"
  std::string_view title;  ///< on the panel: "Wind x"
  std::string_view unit;   ///< "m/s"; "-" for a pure number
  SettingGroup group;
  SettingEffect effect;
  SettingField field;
  std::string_view help;            ///< its meaning, in one to four sentences
  std::string_view alsoKey = {};    ///< another setting that this one sets ...
  std::string_view alsoValue = {};  ///< ... and to what: mass sets mass_given_as to "mass"
  SettingScope scope = SettingScope::Everywhere;
  bool (*relevant)(const Settings&) = nullptr;  ///< whether it has an effect under these settings; null: always
  std::string_view formerKey = {};              ///< an earlier key, which is still accepted; empty: none
  bool isPreset = false;                        ///< whether its value is a name for the values of others
};

/// How many settings in a row follow from this one: mass sets mass_given_as, which sets fabric.own_density. A list
/// without order, such as a scene file, assigns settings of larger depth first, so that explicit values win.
[[nodiscard]] int depthOf(const SettingInfo& info);

inline constexpr int maxDepth = 2;  ///< of any setting

/// All settings, in the order of the panels.
[[nodiscard]] std::span<const SettingInfo> settingsTable();

/// The setting with that key or former key, or nullptr.
[[nodiscard]] const SettingInfo* findSetting(std::string_view key);

/// The same. Throws UsageError with the most similar key when there is none.
[[nodiscard]] const SettingInfo& requireSetting(std::string_view key);

/// A note that names the present key, when `key` is a former one. Empty otherwise.
[[nodiscard]] std::string formerKeyNote(std::string_view key);

/// A note when the setting has no effect because of material.model, as a fabric on a cloth of springs. Empty otherwise.
/// For settings that a user gives one by one. A scene file may well prepare the values of both models.
[[nodiscard]] std::string noEffectNote(const Settings& settings, std::string_view key);

/// The current value.
[[nodiscard]] SettingValue settingValue(const Settings& settings, const SettingInfo& info);

/// The value as a user types it. Numbers have the shortest form that reads back to the same bits.
[[nodiscard]] std::string formatValue(const SettingValue& value);

/// The default.
[[nodiscard]] SettingValue defaultValue(const SettingInfo& info);

/// "1e-05 to 0.1", "on or off", "m, cm or mm".
[[nodiscard]] text::Sentence describeRange(const SettingInfo& info);

/// The same, with the choices that these settings add.
[[nodiscard]] text::Sentence describeRange(const SettingInfo& info, const Settings& settings);

/// The name of a choice for the user: its title, or the word with blanks in place of underscores.
[[nodiscard]] std::string choiceTitle(const ChoiceField& field, std::string_view word);

/// The same, also for choices that the settings add, and for a changed fabric: "Cotton, changed".
[[nodiscard]] text::Sentence shownChoice(const ChoiceField& field, std::string_view word, const Settings& settings);

/// The name of the fabric of these settings: "Denim", "Cotton, changed", or that of an own fabric.
[[nodiscard]] text::Sentence fabricTitle(const Settings& settings);

/// Sets the value, and that of `alsoKey`. A real setting also takes a whole number. Throws UsageError with key, value,
/// range and unit when the value has the wrong type or is out of range. `settings` is then unchanged.
void assignSetting(Settings& settings, const SettingInfo& info, const SettingValue& value);

/// Whether the setting has an effect under these settings. The panels hide settings of other solvers and choices.
[[nodiscard]] bool isRelevant(const SettingInfo& info, const Settings& settings);

/// Throws ConflictError when values that are each allowed exclude each other, with the reason and the remedy. Call it
/// after all values are assigned.
void requireConsistent(const Settings& settings);

/// `settings` with another value of one setting. Throws UsageError as assignSetting() and requireConsistent() do.
[[nodiscard]] Settings withSetting(Settings settings, const SettingInfo& info, const SettingValue& value);

/// The settings with different values in `a` and `b`, in the order of the table.
[[nodiscard]] std::vector<const SettingInfo*> differingSettings(const Settings& a, const Settings& b);

/// Sets the value from text, as on the command line: "0.01", "1/150", "on", "cm".
void assignSettingText(Settings& settings, const SettingInfo& info, std::string_view text);

/// The key of "key=value"; the whole text if it has no "=".
[[nodiscard]] std::string_view keyOf(std::string_view expression);

/// Sets a value from "key=value", as given to --set. Throws UsageError as above.
void assignSettingExpression(Settings& settings, std::string_view expression);

}  // namespace drape::settings
