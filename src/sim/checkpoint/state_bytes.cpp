#include "sim/checkpoint/state_bytes.hpp"

#include "sim/adaptive/step_memory.hpp"
#include "sim/contact/self/memory.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace drape::sim {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double));

/// Whether the bytes of a value are the value.
template <typename T>
constexpr bool isPlain = std::is_trivially_copyable_v<T> || std::is_same_v<T, Vec3>;

class ByteWriter {
 public:
  static constexpr bool reads = false;

  template <typename T>
  void operator()(const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    append(&value, sizeof(T));
  }

  template <typename T>
  void operator()(const std::vector<T>& values) {
    static_assert(isPlain<T>);
    (*this)(static_cast<std::uint64_t>(values.size()));
    append(values.data(), values.size() * sizeof(T));
  }

  std::string take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    if (size > 0) {
      bytes_.append(static_cast<const char*>(data), size);
    }
  }

  std::string bytes_;
};

/// Reads until something is missing; then `failed` stays true and values keep what they have.
class ByteReader {
 public:
  static constexpr bool reads = true;

  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <typename T>
  void operator()(T& value) {
    static_assert(std::is_arithmetic_v<T>);
    take(&value, sizeof(T));
  }

  template <typename T>
  void operator()(std::vector<T>& values) {
    std::uint64_t count = 0;
    (*this)(count);
    if (failed_ || count > rest_.size() / sizeof(T)) {
      failed_ = true;
      return;
    }
    values.resize(static_cast<std::size_t>(count));
    take(static_cast<void*>(values.data()), values.size() * sizeof(T));
  }

  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] bool isAtEnd() const { return !failed_ && rest_.empty(); }

 private:
  void take(void* into, std::size_t size) {
    failed_ = failed_ || size > rest_.size();
    if (!failed_ && size > 0) {
      std::memcpy(into, rest_.data(), size);
      rest_.remove_prefix(size);
    }
  }

  std::string_view rest_;
  bool failed_ = false;
};

// Each function lists the fields of a type once, for the writer and for the reader.

template <typename Archive, typename Patches>
void patchFields(Archive& archive, Patches& patches) {
  archive(patches.patches);
  archive(patches.patchOfVertex);
  archive(patches.patchOfTriangle);
  archive(patches.corners.a);
  archive(patches.corners.b);
  archive(patches.corners.c);
  archive(patches.border);
  archive(patches.vertices);
}

/// The contents behind a pointer, with whether there are any.
template <typename T, typename Archive, typename Fields>
void pointerFields(Archive& archive, std::shared_ptr<const T>& pointer, const Fields& fields) {
  std::uint8_t exists = pointer == nullptr ? 0 : 1;
  archive(exists);
  if (exists == 0) {
    return;
  }
  if constexpr (Archive::reads) {
    auto made = std::make_shared<T>();
    fields(archive, *made);
    pointer = std::move(made);
  } else {
    fields(archive, *pointer);
  }
}

template <typename Archive, typename Memory>
void selfContactFields(Archive& archive, Memory& memory) {
  const auto patchesBehind = [&](auto& pointer) {
    auto patches = pointer;
    pointerFields(archive, patches, [](auto& to, auto& fields) { patchFields(to, fields); });
    if constexpr (Archive::reads) {
      pointer = std::move(patches);
    }
  };
  patchesBehind(memory.patches.patches);
  for (auto& set : memory.patches.acrossBorders) {
    patchesBehind(set);
  }
  archive(memory.patches.updatesSinceGrowth);
  archive(memory.patches.patchesGrown);
  archive(memory.positions.x);
  archive(memory.positions.y);
  archive(memory.positions.z);
  archive(memory.pairs.pairs);
  archive(memory.pairs.begin);
  archive(memory.thickness);
  archive(memory.reach);
  archive(memory.vertices);
  archive(memory.triangles);
  archive(memory.searches);
}

template <typename Archive>
void stretchFields(Archive& archive, std::vector<adaptive::StretchMemory>& materials) {
  std::vector<int> levels;
  std::ranges::transform(materials, std::back_inserter(levels), &adaptive::StretchMemory::level);
  archive(levels);
  materials.resize(levels.size());
  for (std::size_t i = 0; i < materials.size(); ++i) {
    materials[i].level = levels[i];
    archive(materials[i].strain);
    archive(materials[i].imposed);
    archive(materials[i].raisedFrom);
    archive(materials[i].changed);
    archive(materials[i].peak);
  }
}

template <typename Archive>
void stepMemoryFields(Archive& archive, adaptive::StepMemory& memory) {
  archive(memory.forceEvaluations);
  archive(memory.error);
  archive(memory.steps);
  archive(memory.retryLevel);
  archive(memory.calmSteps);
  archive(memory.schemeEnergyDrift);
  archive(memory.energyDrift);
  archive(memory.energy);
  archive(memory.fingerprint);
  archive(memory.planFingerprint);
  archive(memory.stiffeningEnergy);
  archive(memory.visibleEnergy);
  archive(memory.visibleDrift);
  archive(memory.withoutLevels);
  std::uint8_t taut = memory.taut ? 1 : 0;
  archive(taut);
  memory.taut = taut != 0;
  archive(memory.tautFingerprint);
  archive(memory.tautSteps);
  archive(memory.tautEnergy);
  archive(memory.speed);
  archive(memory.doubleSteps);
  archive(memory.everySubstep);
  stretchFields(archive, memory.stretch);
  archive(memory.strainsMeasured);
  pointerFields(archive, memory.sleepReference, [](auto& to, auto& positions) { to(positions); });
  archive(memory.sleepReferenceTime);
  archive(memory.sleepFingerprint);
  std::uint8_t disturbed = memory.disturbed ? 1 : 0;
  archive(disturbed);
  memory.disturbed = disturbed != 0;
  pointerFields(archive, memory.settlingReference, [](auto& to, auto& positions) { to(positions); });
  archive(memory.settlingReferenceTime);
  archive(memory.slowIntervals);
}

template <typename Archive>
void stateFields(Archive& archive, ClothState& state) {
  archive(state.positions);
  archive(state.velocities);
  archive(state.time);
  archive(state.history.positions);
  archive(state.history.velocities);
  archive(state.history.timeStep);
  std::uint8_t hasNoSelfIntersection = state.hasNoSelfIntersection ? 1 : 0;
  archive(hasNoSelfIntersection);
  pointerFields(archive, state.selfContact, [](auto& to, auto& memory) { selfContactFields(to, memory); });
  std::uint8_t hasMemory = state.memory == nullptr ? 0 : 1;
  archive(hasMemory);
  if (hasMemory != 0) {
    adaptive::StepMemory memory = adaptive::stepMemoryOf(state);
    stepMemoryFields(archive, memory);
    adaptive::storeStepMemory(std::move(memory), state);
  }
  state.hasNoSelfIntersection = hasNoSelfIntersection != 0;
}

bool hasOneEntryPerVertex(const ClothState& state) {
  const std::size_t count = state.positions.size();
  const auto fits = [count](const std::vector<Vec3>& vectors) { return vectors.empty() || vectors.size() == count; };
  return state.velocities.size() == count && fits(state.history.positions) && fits(state.history.velocities);
}

}  // namespace

std::string bytesOf(const ClothState& state) {
  ByteWriter writer;
  ClothState copy = state;  // the fields are listed once, for reading too
  stateFields(writer, copy);
  return writer.take();
}

std::optional<ClothState> stateFromBytes(std::string_view bytes) {
  ByteReader reader(bytes);
  ClothState state;
  stateFields(reader, state);
  if (!reader.isAtEnd() || !hasOneEntryPerVertex(state)) {
    return std::nullopt;
  }
  return state;
}

}  // namespace drape::sim
