#include "settings/own_fabrics.hpp"

#include "fabrics/presets.hpp"
#include "messages/error.hpp"
#include "settings/settings_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace drape::settings {
namespace {

constexpr std::array<std::string_view, 13> valueKeys{
    "fabric.density",     "fabric.stretch_warp",      "fabric.stretch_weft",    "fabric.shear",
    "fabric.poisson",     "fabric.stiffening_strain", "fabric.stiffening_warp", "fabric.stiffening_weft",
    "fabric.bend_warp",   "fabric.bend_weft",         "fabric.bend_bias",       "fabric.stretch_damping",
    "fabric.bend_damping"};

bool sameLetters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char one, unsigned char other) { return std::tolower(one) == std::tolower(other); });
}

const fabrics::Preset* presetCalled(std::string_view name) {
  const auto presets = fabrics::presetTable();
  const auto found = std::find_if(presets.begin(), presets.end(), [&](const fabrics::Preset& preset) {
    return sameLetters(name, preset.name) || sameLetters(name, preset.title);
  });
  return found == presets.end() ? nullptr : &*found;
}

bool hasControlCharacter(std::string_view name) {
  constexpr unsigned char firstPrintable = 0x20;
  constexpr unsigned char erase = 0x7f;
  return std::any_of(name.begin(), name.end(), [](char each) {
    const auto byte = static_cast<unsigned char>(each);
    return byte < firstPrintable || byte == erase;
  });
}

}  // namespace

std::span<const std::string_view> fabricValueKeys() {
  return valueKeys;
}

std::string problemWithFabricName(std::string_view name) {
  if (name.find_first_not_of(' ') == std::string_view::npos) {
    return "the fabric needs a name";
  }
  const std::string quoted = "'" + std::string(name) + "'";
  if (name.size() > longestFabricName) {
    return "the name " + quoted + " is too long; use at most " + std::to_string(longestFabricName) + " bytes";
  }
  if (name.front() == ' ' || name.back() == ' ' || hasControlCharacter(name)) {
    return "the name " + quoted + " must neither begin nor end with a blank, and have no control characters";
  }
  if (const fabrics::Preset* preset = presetCalled(name)) {
    return "the name " + quoted + " belongs to the built-in fabric " + std::string(preset->title) +
           "; choose another name";
  }
  if (sameLetters(name, noPreset) || name.ends_with(changedMark)) {
    return "the name " + quoted + " marks changed fabrics; choose another name";
  }
  return {};
}

const OwnFabric* findOwnFabric(const OwnFabrics& fabrics, std::string_view name) {
  if (!fabrics) {
    return nullptr;
  }
  const auto found =
      std::find_if(fabrics->begin(), fabrics->end(), [&](const OwnFabric& fabric) { return fabric.name == name; });
  return found == fabrics->end() ? nullptr : &*found;
}

OwnFabrics withOwnFabric(const OwnFabrics& fabrics, OwnFabric fabric) {
  std::vector<OwnFabric> list = fabrics ? *fabrics : std::vector<OwnFabric>();
  const auto same =
      std::find_if(list.begin(), list.end(), [&](const OwnFabric& each) { return each.name == fabric.name; });
  if (same == list.end()) {
    list.push_back(std::move(fabric));
  } else {
    *same = std::move(fabric);
  }
  return std::make_shared<const std::vector<OwnFabric>>(std::move(list));
}

OwnFabrics joined(const OwnFabrics& fabrics, const OwnFabrics& more) {
  OwnFabrics all = fabrics;
  for (const OwnFabric& fabric : more ? *more : std::vector<OwnFabric>()) {
    all = withOwnFabric(all, fabric);
  }
  return all;
}

OwnFabric fabricOf(const Settings& settings, std::string_view name) {
  OwnFabric fabric{.name = std::string(name),
                   .basedOn = settings.fabric.preset,
                   .source = {},
                   .density = settings.fabric.density,
                   .material = settings.fabric.moduli};
  if (const OwnFabric* base = findOwnFabric(settings.fabric.own, settings.fabric.preset)) {
    fabric.basedOn = base->basedOn;
  }
  return fabric;
}

void requireAllowed(const OwnFabric& fabric) {
  if (const std::string problem = problemWithFabricName(fabric.name); !problem.empty()) {
    throw messages::UsageError(problem);
  }
  Settings values;
  useFabric(values, fabric);
  try {
    if (!fabric.basedOn.empty() && fabrics::findPreset(fabric.basedOn) == nullptr) {
      throw messages::UsageError("based_on must be a built-in fabric; '" + fabric.basedOn + "' is not");
    }
    requireFabricValues(values);
  } catch (const messages::UsageError& error) {
    throw messages::UsageError("the fabric '" + fabric.name + "': " + error.what());
  }
}

void requireFabricValues(const Settings& settings) {
  Settings values = settings;
  for (const std::string_view key : valueKeys) {
    const SettingInfo& info = requireSetting(key);
    assignSetting(values, info, settingValue(settings, info));
  }
  requireConsistent(values);
}

std::span<const std::string_view> fabricFrictionKeys() {
  static constexpr std::array<std::string_view, 3> keys{"self_static_friction", "self_friction", "body_friction"};
  return keys;
}

void useFriction(Settings& settings, std::string_view preset) {
  if (const fabrics::Preset* found = fabrics::findPreset(preset)) {
    settings.step.contact.staticFriction = found->friction.selfStatic;
    settings.step.contact.kineticFriction = found->friction.selfKinetic;
    settings.step.contact.bodyFriction = fabrics::skinFrictionRatio(found->friction);
  }
}

void useFabric(Settings& settings, const OwnFabric& fabric) {
  useFriction(settings, fabric.basedOn);
  settings.fabric.moduli = fabric.material;
  settings.fabric.density = fabric.density;
  settings.fabric.preset = fabric.name;
}

}  // namespace drape::settings
