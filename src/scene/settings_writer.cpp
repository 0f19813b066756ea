#include "scene/settings_writer.hpp"

#include "messages/error.hpp"
#include "settings/own_fabrics.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace drape::scene {
namespace {

/// "1/300" for the number that is exactly that; otherwise empty.
std::string inverseText(double number) {
  constexpr double maxDenominator = 1e6;
  const double denominator = std::round(1.0 / number);
  const bool isInverse =
      number > 0.0 && denominator > 1.0 && denominator < maxDenominator && 1.0 / denominator == number;
  return isInverse ? "1/" + settings::formatValue(static_cast<int>(denominator)) : std::string();
}

void addFabric(std::string_view name, const settings::OwnFabrics& own, std::vector<settings::OwnFabric>& used) {
  if (name.ends_with(settings::changedMark)) {
    name.remove_suffix(settings::changedMark.size());
  }
  const settings::OwnFabric* fabric = settings::findOwnFabric(own, name);
  const bool isNew = fabric != nullptr && std::ranges::none_of(used, [&](const settings::OwnFabric& each) {
                       return each.name == fabric->name;
                     });
  if (isNew) {
    used.push_back(*fabric);
  }
}

}  // namespace

std::string valueText(const settings::SettingValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) {
    return *flag ? "true" : "false";
  }
  if (const auto* text = std::get_if<std::string>(&value)) {
    return quotedText(*text);
  }
  const std::string shortest = settings::formatValue(value);
  if (const double* number = std::get_if<double>(&value)) {
    const std::string inverse = inverseText(*number);
    return !inverse.empty() && inverse.size() < shortest.size() ? quotedText(inverse) : shortest;
  }
  return shortest;
}

std::string settingsText(const settings::Settings& settings, const std::vector<const settings::SettingInfo*>& written) {
  TomlText toml;
  toml.table("[settings]");
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    if (std::ranges::find(written, &info) != written.end()) {
      toml.value(info.key, valueText(settings::settingValue(settings, info)));
    }
  }
  return toml.document();
}

std::vector<const settings::SettingInfo*> settingsToWrite(
    const settings::Settings& target,
    const std::function<settings::Settings(const std::vector<const settings::SettingInfo*>&)>& read) {
  std::vector<const settings::SettingInfo*> written = settings::differingSettings(settings::Settings(), target);
  while (true) {
    const std::vector<const settings::SettingInfo*> wrong = settings::differingSettings(read(written), target);
    const std::size_t count = written.size();
    std::ranges::copy_if(wrong, std::back_inserter(written), [&](const settings::SettingInfo* info) {
      return std::ranges::find(written, info) == written.end();
    });
    if (written.size() == count) {
      if (!wrong.empty()) {
        throw messages::InputError("a scene file cannot have this value of " + std::string(wrong.front()->key) +
                                   " together with the others");
      }
      return written;
    }
  }
}

std::vector<settings::OwnFabric> usedFabrics(const settings::Settings& settings, std::span<const ClothPart> cloths) {
  std::vector<settings::OwnFabric> used;
  addFabric(settings.fabric.preset, settings.fabric.own, used);
  for (const ClothPart& cloth : cloths) {
    for (const OwnSetting& own : cloth.own) {
      if (own.info->isPreset) {
        addFabric(settings::formatValue(own.value), settings.fabric.own, used);
      }
    }
  }
  return used;
}

}  // namespace drape::scene
