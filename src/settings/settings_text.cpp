#include "messages/error.hpp"
#include "settings/settings_table.hpp"
#include "sim/solvers/solver.hpp"
#include "text/number_text.hpp"
#include "text/words.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace drape::settings {
namespace {

using text::Sentence;

template <typename... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <typename... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

std::string quoted(std::string_view text) {
  return "'" + std::string(text) + "'";
}

Sentence withUnit(const SettingInfo& info, Sentence text) {
  return info.unit == "-" ? text : text.append(" ", Sentence::verbatim(info.unit));
}

/// The words of a choice, with those that the settings add.
std::vector<std::string> wordsOf(const ChoiceField& field, const Settings& settings) {
  std::vector<std::string> words = field.choices();
  if (field.ownChoices != nullptr) {
    for (OwnChoice& choice : field.ownChoices(settings)) {
      words.push_back(std::move(choice.word));
    }
  }
  return words;
}

Sentence listWords(const std::vector<std::string>& words) {
  std::string first;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    first += (i == 0 ? "" : ", ") + words[i];
  }
  return first.empty() ? Sentence::verbatim(words.front()) : Sentence("{} or {}", first, words.back());
}

std::string nearestKey(std::string_view key) {
  std::vector<std::string> keys;
  for (const SettingInfo& info : settingsTable()) {
    keys.emplace_back(info.key);
  }
  return text::nearestWord(key, keys);
}

[[noreturn]] void refuse(const SettingInfo& info, const std::string& given, const Settings& settings,
                         const std::string& meant = {}) {
  throw messages::UsageError(std::string(info.key) + " must be " + describeRange(info, settings).english() + "; " +
                             given + " is not" + (meant.empty() ? "" : ". Did you mean " + quoted(meant) + "?"));
}

void assignNumber(Settings& settings, const SettingInfo& info, const NumberField& field, const SettingValue& value) {
  const auto* real = std::get_if<double>(&value);
  const auto* whole = std::get_if<int>(&value);
  if (real == nullptr && whole == nullptr) {
    refuse(info, quoted(formatValue(value)), settings);
  }
  const double number = real != nullptr ? *real : static_cast<double>(*whole);
  if (!(number >= field.min && number <= field.max)) {
    refuse(info, text::exactNumber(number), settings);
  }
  field.access.ref(settings) = number;
}

void assignInteger(Settings& settings, const SettingInfo& info, const IntegerField& field, const SettingValue& value) {
  const auto* whole = std::get_if<int>(&value);
  if (whole == nullptr || *whole < field.min || *whole > field.max) {
    refuse(info, quoted(formatValue(value)), settings);
  }
  field.access.ref(settings) = *whole;
}

void assignChoice(Settings& settings, const SettingInfo& info, const ChoiceField& field, const SettingValue& value) {
  const std::string text = formatValue(value);
  const std::vector<std::string> choices = wordsOf(field, settings);
  const bool isWord =
      std::holds_alternative<std::string>(value) && std::find(choices.begin(), choices.end(), text) != choices.end();
  const std::string_view base =
      text.ends_with(changedMark) ? std::string_view(text).substr(0, text.size() - changedMark.size()) : "";
  const bool isOther = !std::holds_alternative<bool>(value) && field.accepts != nullptr && field.accepts(text) &&
                       (base.empty() || std::find(choices.begin(), choices.end(), base) != choices.end());
  if (!isWord && !isOther) {
    refuse(info, quoted(text), settings, text::nearestWord(text, choices));
  }
  field.set(settings, text);
}

void assignFlag(Settings& settings, const SettingInfo& info, const FlagField& field, const SettingValue& value) {
  const auto* flag = std::get_if<bool>(&value);
  if (flag == nullptr) {
    refuse(info, quoted(formatValue(value)), settings);
  }
  field.access.ref(settings) = *flag;
}

SettingValue parseValue(const SettingInfo& info, std::string_view text) {
  if (std::holds_alternative<NumberField>(info.field)) {
    if (const auto number = text::parseNumber(text)) {
      return *number;
    }
  } else if (std::holds_alternative<IntegerField>(info.field)) {
    int whole = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), whole);
    if (result.ec == std::errc() && result.ptr == text.data() + text.size()) {
      return whole;
    }
  } else if (std::holds_alternative<FlagField>(info.field)) {
    if (text == "on" || text == "true" || text == "1" || text == "yes") {
      return true;
    }
    if (text == "off" || text == "false" || text == "0" || text == "no") {
      return false;
    }
  }
  return std::string(text);
}

/// The ranges of the single values exclude all other unstable fabrics.
void requireStable(const sim::fabric::Material& fabric) {
  const double minBias = 0.25 * (fabric.bendWarp + fabric.bendWeft);
  if (fabric.bendBias < minBias) {
    throw ConflictError(
        {"fabric.bend_bias", "fabric.bend_warp", "fabric.bend_weft"},
        "fabric.bend_bias must be at least a quarter of the sum of fabric.bend_warp and fabric.bend_weft, " +
            text::exactNumber(minBias) + " N m; " + text::exactNumber(fabric.bendBias) +
            " is not. Otherwise the fabric would twist by itself. Raise fabric.bend_bias, or lower the other two");
  }
}

}  // namespace

const SettingInfo& requireSetting(std::string_view key) {
  if (const SettingInfo* info = findSetting(key)) {
    return *info;
  }
  const std::string meant = nearestKey(key);
  throw messages::UsageError("there is no setting " + quoted(key) + "; " +
                             (meant.empty() ? "" : "did you mean " + quoted(meant) + "? ") +
                             "'drape-headless list settings' lists all settings");
}

int depthOf(const SettingInfo& info) {
  if (!info.alsoKey.empty()) {
    return 1 + depthOf(requireSetting(info.alsoKey));
  }
  return info.isPreset ? 1 : 0;
}

std::string formerKeyNote(std::string_view key) {
  const SettingInfo* info = findSetting(key);
  if (info == nullptr || info->key == key) {
    return {};
  }
  return "the setting " + quoted(key) + " is now called " + quoted(info->key);
}

std::string noEffectNote(const Settings& settings, std::string_view key) {
  const SettingInfo* info = findSetting(key);
  Settings other = settings;
  other.material.model = usesFabric(settings) ? "springs" : "fabric";
  if (info == nullptr || isRelevant(*info, settings) || !isRelevant(*info, other)) {
    return {};
  }
  return "the setting " + quoted(info->key) + " has no effect while material.model is " + settings.material.model;
}

SettingValue settingValue(const Settings& settings, const SettingInfo& info) {
  return std::visit(Overloaded{[&](const ChoiceField& field) -> SettingValue { return field.get(settings); },
                               [&](const auto& field) -> SettingValue { return field.access.get(settings); }},
                    info.field);
}

std::string formatValue(const SettingValue& value) {
  return std::visit(Overloaded{[](double number) { return text::exactNumber(number); },
                               [](int whole) { return std::to_string(whole); },
                               [](bool flag) { return std::string(flag ? "on" : "off"); },
                               [](const std::string& word) { return word; }},
                    value);
}

std::string choiceTitle(const ChoiceField& field, std::string_view word) {
  if (const std::string_view title = field.label == nullptr ? "" : field.label(word).title; !title.empty()) {
    return std::string(title);
  }
  std::string spoken(word);
  std::replace(spoken.begin(), spoken.end(), '_', ' ');
  return spoken;
}

Sentence shownChoice(const ChoiceField& field, std::string_view word, const Settings& settings) {
  if (word.ends_with(changedMark)) {
    return Sentence("{}, changed", shownChoice(field, word.substr(0, word.size() - changedMark.size()), settings));
  }
  for (const OwnChoice& own : field.ownChoices == nullptr ? std::vector<OwnChoice>() : field.ownChoices(settings)) {
    if (own.word == word) {
      return Sentence::verbatim(own.title);
    }
  }
  return Sentence(choiceTitle(field, word));
}

Sentence fabricTitle(const Settings& settings) {
  const auto& field = std::get<ChoiceField>(requireSetting("material.preset").field);
  return shownChoice(field, field.get(settings), settings);
}

SettingValue defaultValue(const SettingInfo& info) {
  return settingValue(Settings{}, info);
}

Sentence describeRange(const SettingInfo& info) {
  return describeRange(info, Settings{});
}

Sentence describeRange(const SettingInfo& info, const Settings& settings) {
  return std::visit(
      Overloaded{
          [&](const NumberField& field) {
            return withUnit(info, Sentence("{} to {}", text::exactNumber(field.min), text::exactNumber(field.max)));
          },
          [&](const IntegerField& field) {
            return withUnit(info, Sentence("a whole number from {} to {}", field.min, field.max));
          },
          [](const FlagField&) { return Sentence("on or off"); },
          [&](const ChoiceField& field) {
            Sentence words = listWords(wordsOf(field, settings));
            return field.otherTexts.empty() ? words : words.append(", ", Sentence("or {}", Sentence(field.otherTexts)));
          }},
      info.field);
}

void assignSetting(Settings& settings, const SettingInfo& info, const SettingValue& value) {
  std::visit(Overloaded{[&](const NumberField& field) { assignNumber(settings, info, field, value); },
                        [&](const IntegerField& field) { assignInteger(settings, info, field, value); },
                        [&](const FlagField& field) { assignFlag(settings, info, field, value); },
                        [&](const ChoiceField& field) { assignChoice(settings, info, field, value); }},
             info.field);
  if (!info.alsoKey.empty()) {
    assignSettingText(settings, requireSetting(info.alsoKey), info.alsoValue);
  }
}

bool isRelevant(const SettingInfo& info, const Settings& settings) {
  const auto lists = [&](const sim::SolverInfo& solver) {
    return std::find(solver.settings.begin(), solver.settings.end(), info.key) != solver.settings.end();
  };
  const auto solvers = sim::solverTable();
  const auto read = [&](const std::string& name) {
    const sim::SolverInfo* chosen = sim::findSolver(name);
    return chosen != nullptr && lists(*chosen);
  };
  const bool special = std::any_of(solvers.begin(), solvers.end(), lists);
  return (!special || read(settings.solver.name) || read(settings.ghost.solver)) &&
         (info.relevant == nullptr || info.relevant(settings));
}

void requireConsistent(const Settings& settings) {
  if (settings.step.jacobi.sweeps % 2 == 0 && settings.step.jacobi.relaxation > sim::simd::evenSweepsRelaxation) {
    throw ConflictError(
        {"sweeps", "relaxation"},
        "sweeps must be odd while relaxation is above " + text::exactNumber(sim::simd::evenSweepsRelaxation) + "; " +
            std::to_string(settings.step.jacobi.sweeps) +
            " is not. An even number of block-Jacobi sweeps amplifies the stiffest modes up to twofold, and stiff "
            "cloth vibrates. Use an odd number, or a lower relaxation (damped Jacobi)");
  }
  requireStable(settings.fabric.moduli);
}

Settings withSetting(Settings settings, const SettingInfo& info, const SettingValue& value) {
  assignSetting(settings, info, value);
  requireConsistent(settings);
  return settings;
}

std::vector<const SettingInfo*> differingSettings(const Settings& a, const Settings& b) {
  std::vector<const SettingInfo*> differing;
  for (const SettingInfo& info : settingsTable()) {
    if (settingValue(a, info) != settingValue(b, info)) {
      differing.push_back(&info);
    }
  }
  return differing;
}

void assignSettingText(Settings& settings, const SettingInfo& info, std::string_view text) {
  assignSetting(settings, info, parseValue(info, text));
}

std::string_view keyOf(std::string_view expression) {
  return expression.substr(0, expression.find('='));
}

void assignSettingExpression(Settings& settings, std::string_view expression) {
  const auto equals = expression.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    throw messages::UsageError("a setting is given as key=value, for example --set stiffness=100; " +
                               quoted(expression) + " is not");
  }
  assignSettingText(settings, requireSetting(keyOf(expression)), expression.substr(equals + 1));
}

}  // namespace drape::settings
