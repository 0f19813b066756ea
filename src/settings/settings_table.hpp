#pragma once

#include "settings/settings.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace drape {

using SettingValue = std::variant<double, int, bool, std::string>;

/// A real number within a closed range.
struct NumberField {
  double& (*ref)(Settings&);
  double min;
  double max;
  bool logarithmic;  ///< a slider should move in decades
};

/// A whole number within a closed range.
struct IntegerField {
  int& (*ref)(Settings&);
  int min;
  int max;
};

/// On or off.
struct FlagField {
  bool& (*ref)(Settings&);
};

/// How a word of a choice stands on the panel, and what it means in one sentence. May be empty.
struct ChoiceLabel {
  std::string_view title;
  std::string_view help;
};

/// One of a list of words, or another text that `accepts` takes.
struct ChoiceField {
  std::string (*get)(const Settings&);
  void (*set)(Settings&, const std::string&);  ///< of one of the choices
  std::vector<std::string> (*choices)();
  ChoiceLabel (*label)(std::string_view word) = nullptr;  ///< of one of the choices; null: words speak for themselves
  bool (*accepts)(std::string_view text) = nullptr;  ///< takes texts that are none of the words; null: there are none
  std::string_view otherTexts = {};                  ///< what `accepts` takes, for messages
};

using SettingField = std::variant<NumberField, IntegerField, FlagField, ChoiceField>;

/// One setting, declared once: the panel, the command line, the scene files and the documentation all read this.
struct SettingInfo {
  std::string_view key;    ///< "wind.x", as typed and as in a scene file
  std::string_view title;  ///< "Wind x", as on the panel
  std::string_view unit;   ///< "m/s"; "-" where there is none
  SettingGroup group;
  SettingEffect effect;
  SettingField field;
  std::string_view help;            ///< what it means, one or two sentences
  std::string_view alsoKey = {};    ///< a setting that giving this one decides ...
  std::string_view alsoValue = {};  ///< ... and its value: giving mass sets mass_given_as to "mass"
  SettingScope scope = SettingScope::Everywhere;
  bool (*relevant)(const Settings&) = nullptr;  ///< whether it has an effect beside the other settings; null: always
};

/// Every setting, in the order in which it is shown.
[[nodiscard]] std::span<const SettingInfo> settingsTable();

/// The setting with that key, or nullptr.
[[nodiscard]] const SettingInfo* findSetting(std::string_view key);

/// The setting with that key. Throws UsageError naming the nearest key when there is none.
[[nodiscard]] const SettingInfo& requireSetting(std::string_view key);

/// The value in force.
[[nodiscard]] SettingValue settingValue(const Settings& settings, const SettingInfo& info);

/// The value as the user would type it; numbers in the shortest form that reads back to the same bits.
[[nodiscard]] std::string formatValue(const SettingValue& value);

/// The default.
[[nodiscard]] SettingValue defaultValue(const SettingInfo& info);

/// "1e-05 to 0.1", "on or off", "m, cm or mm".
[[nodiscard]] std::string describeRange(const SettingInfo& info);

/// What a word of a choice is called where people read it: its title, or the word itself with gaps.
[[nodiscard]] std::string choiceTitle(const ChoiceField& field, std::string_view word);

/// Sets it (and what it decides through `alsoKey`). A whole number is taken where a real one is wanted.
/// Throws UsageError naming key, value, range and unit when the value has the wrong kind or is out of range;
/// `settings` is then unchanged.
void assignSetting(Settings& settings, const SettingInfo& info, const SettingValue& value);

/// Whether the setting has an effect under these settings: one that belongs to another solver, or to a choice that was
/// not made, has none and need not be shown.
[[nodiscard]] bool isRelevant(const SettingInfo& info, const Settings& settings);

/// Throws UsageError where values that are each allowed do not go together, with the reason and what to do. Call it
/// when all the values that belong together have been assigned.
void requireConsistent(const Settings& settings);

/// Assigns from text, as on the command line: "0.01", "1/150", "on", "cm".
void assignSettingText(Settings& settings, const SettingInfo& info, std::string_view text);

/// "key=value" as given to --set. Throws UsageError as above.
void assignSettingExpression(Settings& settings, std::string_view expression);

}  // namespace drape
