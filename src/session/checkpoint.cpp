#include "session/checkpoint.hpp"

#include "messages/error.hpp"
#include "session/scene_fingerprints.hpp"
#include "settings/settings_table.hpp"
#include "sim/checkpoint/state_bytes.hpp"
#include "sim/model/fingerprint.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <optional>

namespace drape::session {
namespace {

constexpr std::string_view fileMark = "DRAPECKP";
constexpr std::uint32_t version = 8;
constexpr std::uint32_t byteOrder = 0x01020304;

constexpr std::string_view saveAgain = " Save it again, or start without it.";

void append(std::string& bytes, std::uint64_t number) {
  std::array<char, sizeof(number)> raw{};
  std::memcpy(raw.data(), &number, raw.size());
  bytes.append(raw.data(), raw.size());
}

void appendText(std::string& bytes, std::string_view text) {
  append(bytes, text.size());
  bytes += text;
}

[[noreturn]] void failDamaged() {
  throw messages::InputError("the checkpoint is damaged or cut off." + std::string(saveAgain));
}

/// Takes numbers and texts off bytes whose checksum was right.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    const std::string_view raw = take(sizeof(value));
    std::memcpy(&value, raw.data(), sizeof(value));
    return value;
  }
  std::string_view text() { return take(number()); }

 private:
  std::string_view take(std::uint64_t size) {
    if (size > rest_.size()) {
      failDamaged();
    }
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(size));
    rest_.remove_prefix(taken.size());
    return taken;
  }

  std::string_view rest_;
};

std::uint64_t checksumOf(std::string_view bytes) {
  std::uint64_t sum = sim::mixHash(1, bytes.size());
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min(sizeof(word), bytes.size() - at));
    sum = sim::mixHash(sum, word);
  }
  return sum;
}

/// Of seams and elastic bands that the scene does not have.
void addSewing(const Simulation& simulation, sim::Fingerprint& print) {
  if (simulation.sewing() == scene::sewingOf(simulation.scene().description)) {
    return;
  }
  for (const sim::Seam& seam : *simulation.cloth().seams()) {
    print.add(seam.start);
    print.add(seam.duration);
    for (const sim::SeamPair& pair : seam.pairs) {
      print.add(static_cast<std::uint64_t>(pair.a));
      print.add(static_cast<std::uint64_t>(pair.b));
    }
  }
  for (const sim::Spring& spring : simulation.cloth().pieces()->springs) {
    print.add(spring.restLength);
  }
}

/// Of everything that the vertices of a state belong to: triangles, start, pins, bodies, and the user's sewing.
std::uint64_t fingerprintOf(const Simulation& simulation) {
  sim::Fingerprint print;
  const sim::ClothModel& model = *simulation.cloth().pieces();
  for (const Triangle& triangle : model.triangles) {
    for (const int vertex : triangle) {
      print.add(static_cast<std::uint64_t>(vertex));
    }
  }
  for (const Vec3& position : simulation.scene().start.positions) {
    print.add(position);
  }
  for (const bool pinned : model.pinned) {
    print.add(static_cast<std::uint64_t>(pinned ? 1 : 0));
  }
  print.add(static_cast<std::uint64_t>(simulation.bodies().bodies().size()));
  addSewing(simulation, print);
  return print.value();
}

/// Whether a setting can change the motion. The number of threads does not, nor does what is drawn.
bool changesMotion(const settings::SettingInfo& info) {
  return info.key != "threads" && info.key != "speed" && !info.key.starts_with("view.") &&
         !info.key.starts_with("measures.") && !info.key.starts_with("ghost.");
}

std::string settingsText(const settings::Settings& settings) {
  std::string text;
  for (const settings::SettingInfo& info : settings::settingsTable()) {
    if (changesMotion(info)) {
      appendText(text, info.key);
      appendText(text, settings::formatValue(settings::settingValue(settings, info)));
    }
  }
  return text;
}

std::vector<std::string> differences(std::string_view kept, const settings::Settings& present) {
  std::vector<std::string> notes;
  Fields fields(kept);
  for (std::size_t read = 0; read < kept.size();) {
    const std::string key(fields.text());
    const std::string value(fields.text());
    read += 2 * sizeof(std::uint64_t) + key.size() + value.size();
    const settings::SettingInfo* info = settings::findSetting(key);
    const std::string now = info == nullptr ? value : settings::formatValue(settings::settingValue(present, *info));
    if (now != value) {
      notes.push_back(fmt::format("{} is {}, and was {} when the checkpoint was saved", key, now, value));
    }
  }
  return notes;
}

/// The fingerprints of the parts that a state does not depend on, but the further motion does.
std::string partsText(const scene::Scene& scene) {
  std::string text;
  for (const PartFingerprint& print : fingerprintsOf(scene)) {
    append(text, print.value);
  }
  return text;
}

/// One sentence for each part that differs.
std::vector<std::string> changedParts(std::string_view kept, const scene::Scene& scene) {
  std::vector<std::string> notes;
  Fields fields(kept);
  for (const PartFingerprint& print : fingerprintsOf(scene)) {
    if (fields.number() != print.value) {
      notes.push_back(fmt::format("{} of the scene changed since the checkpoint was saved", print.part));
    }
  }
  return notes;
}

/// The payload of a checkpoint after all checks of its form.
std::string_view payloadOf(std::string_view bytes) {
  if (!bytes.starts_with(fileMark)) {
    throw messages::InputError("it is not a checkpoint of Drape. Give a file that --save wrote.");
  }
  Fields header(bytes.substr(fileMark.size()));
  if (header.number() != byteOrder) {
    throw messages::InputError("the checkpoint is damaged, or from a machine with another byte order." +
                               std::string(saveAgain));
  }
  if (const std::uint64_t found = header.number(); found != version) {
    throw messages::InputError("the checkpoint has version " + std::to_string(found) + ", and this program reads " +
                               std::to_string(version) + ". Use the version of Drape that saved it.");
  }
  const std::uint64_t checksum = header.number();
  const std::string_view payload = header.text();
  const std::size_t size = fileMark.size() + 4 * sizeof(std::uint64_t) + payload.size();
  if (size != bytes.size() || checksumOf(payload) != checksum) {
    failDamaged();
  }
  return payload;
}

}  // namespace

std::string checkpointOf(const Simulation& simulation) {
  if (simulation.ghost() != nullptr) {
    throw messages::UsageError("a checkpoint does not contain the ghost; use --set ghost.solver=off");
  }
  std::string payload;
  append(payload, fingerprintOf(simulation));
  append(payload, static_cast<std::uint64_t>(simulation.stepIndex()));
  appendText(payload, simulation.scene().description.name);
  appendText(payload, settingsText(simulation.settings()));
  appendText(payload, partsText(simulation.scene()));
  appendText(payload, sim::bytesOf(simulation.state()));
  std::string bytes(fileMark);
  append(bytes, byteOrder);
  append(bytes, version);
  append(bytes, checksumOf(payload));
  appendText(bytes, payload);
  return bytes;
}

std::vector<std::string> continueFrom(std::string_view checkpoint, Simulation& simulation) {
  Fields fields(payloadOf(checkpoint));
  const std::uint64_t fingerprint = fields.number();
  const auto step = static_cast<std::int64_t>(fields.number());
  const std::string name(fields.text());
  const std::string_view kept = fields.text();
  const std::string_view keptParts = fields.text();
  std::optional<sim::ClothState> state = sim::stateFromBytes(fields.text());
  if (fingerprint != fingerprintOf(simulation)) {
    throw messages::InputError(
        "the checkpoint belongs to another mesh, start, pins, seams or number of bodies than this scene (it was saved "
        "from '" +
        name + "'). Give the same scene, --set and --jitter as then.");
  }
  if (!state || state->positions.size() != simulation.state().positions.size()) {
    failDamaged();
  }
  std::vector<std::string> notes = differences(kept, simulation.settings());
  std::ranges::move(changedParts(keptParts, simulation.scene()), std::back_inserter(notes));
  simulation.continueFrom(std::move(*state), step);
  return notes;
}

}  // namespace drape::session
