#include "io/gltf_keys.hpp"

#include "io/clip_facts.hpp"
#include "io/gltf_numbers.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace drape::io {
namespace {

using Json = nlohmann::json;

/// A value of a key, or a tangent; the last component of a place or a scale is 0.
using Value = std::array<double, 4>;

constexpr std::size_t turnSize = 4;   // components of a rotation
constexpr std::size_t placeSize = 3;  // of a translation or a scale

/// Keys with straight lines between them.
struct StraightKeys {
  std::vector<float> times;   ///< [s]
  std::vector<float> values;  ///< `size` for each time
  std::size_t size = 0;

  void add(float time, const Value& value) {
    times.push_back(time);
    for (std::size_t k = 0; k < size; ++k) {
      values.push_back(static_cast<float>(value.at(k)));
    }
  }
};

/// The keys of a sampler as they are in the file.
class StoredKeys {
 public:
  StoredKeys(const Json& document, const std::vector<std::string>& buffers, const Json& sampler)
      : times_(document, buffers, gltfIndexOf(sampler, "input")),
        values_(document, buffers, gltfIndexOf(sampler, "output")) {}

  /// Whether there are `each` values for each time, and the times are finite, ascend and are not too far apart.
  [[nodiscard]] bool areSound(std::size_t each) const {
    const bool moves = values_.components() == placeSize || values_.components() == turnSize;
    if (!moves || times_.components() != 1 || times_.count() == 0 || values_.count() != each * times_.count()) {
      return false;
    }
    for (std::size_t k = 0; k < count(); ++k) {
      if (!std::isfinite(time(k)) || (k > 0 && !(time(k) > time(k - 1)))) {
        return false;
      }
    }
    return time(count() - 1) - time(0) <= longestClip;
  }

  [[nodiscard]] std::size_t count() const { return times_.count(); }
  [[nodiscard]] std::size_t size() const { return values_.components(); }
  [[nodiscard]] float time(std::size_t key) const { return static_cast<float>(times_.value(key, 0)); }

  [[nodiscard]] Value value(std::size_t element) const {
    Value result{};
    for (std::size_t k = 0; k < size(); ++k) {
      result.at(k) = values_.share(element, k);
    }
    return result;
  }

 private:
  GltfNumbers times_;
  GltfNumbers values_;
};

StraightKeys straightSteps(const StoredKeys& keys) {
  StraightKeys straight{.times = {}, .values = {}, .size = keys.size()};
  for (std::size_t k = 0; k < keys.count(); ++k) {
    if (k > 0) {
      const float before = std::nextafter(keys.time(k), -std::numeric_limits<float>::infinity());
      straight.add(std::max(before, keys.time(k - 1)), keys.value(k - 1));
    }
    straight.add(keys.time(k), keys.value(k));
  }
  return straight;
}

Value normalised(Value turn) {
  const double length = std::sqrt(std::inner_product(turn.begin(), turn.end(), turn.begin(), 0.0));
  std::ranges::for_each(turn, [&](double& component) { component /= length > 0.0 ? length : 1.0; });
  return turn;
}

/// A point of the curve from one key to the next one. @param s 0 to 1
Value curveAt(const StoredKeys& keys, std::size_t key, double s) {
  const double span = keys.time(key + 1) - keys.time(key);
  // A key has three elements: the tangent before it, its value, and the tangent after it.
  const Value from = keys.value(3 * key + 1);
  const Value out = keys.value(3 * key + 2);
  const Value in = keys.value(3 * key + 3);
  const Value to = keys.value(3 * key + 4);
  const double squared = s * s;
  const double cubed = squared * s;
  Value value{};
  for (std::size_t k = 0; k < value.size(); ++k) {
    value[k] = (2.0 * cubed - 3.0 * squared + 1.0) * from[k] + span * (cubed - 2.0 * squared + s) * out[k] +
               (-2.0 * cubed + 3.0 * squared) * to[k] + span * (cubed - squared) * in[k];
  }
  return keys.size() == turnSize ? normalised(value) : value;
}

StraightKeys straightCurve(const StoredKeys& keys) {
  constexpr double longestPiece = 1.0 / 120.0;  // [s]
  StraightKeys straight{.times = {}, .values = {}, .size = keys.size()};
  for (std::size_t k = 0; k + 1 < keys.count(); ++k) {
    const double span = keys.time(k + 1) - keys.time(k);
    const double pieces = std::ceil(span / longestPiece);
    for (double piece = 0.0; piece < pieces; piece += 1.0) {
      const double share = piece / pieces;
      straight.add(static_cast<float>(keys.time(k) + share * span), curveAt(keys, k, share));
    }
  }
  straight.add(keys.time(keys.count() - 1), keys.value(3 * (keys.count() - 1) + 1));
  return straight;
}

/// The keys of a sampler with straight lines; empty where they are straight already or damaged.
std::optional<StraightKeys> straightKeysOf(const Json& document, const std::vector<std::string>& buffers,
                                           const Json& sampler) {
  const auto found = sampler.find("interpolation");
  const std::string kind = found != sampler.end() && found->is_string() ? found->get<std::string>() : "";
  const StoredKeys keys(document, buffers, sampler);
  if (kind == "STEP" && keys.areSound(1)) {
    return straightSteps(keys);
  }
  if (kind == "CUBICSPLINE" && keys.areSound(3)) {
    return straightCurve(keys);
  }
  return std::nullopt;
}

/// Appends numbers to the new buffer of a document, with an accessor. Returns the number of the accessor.
class NumbersWriter {
 public:
  NumbersWriter(Json& document, std::size_t buffer) : document_(document), buffer_(buffer) {}

  std::size_t add(const std::vector<float>& numbers, std::size_t components) {
    const std::size_t bytes = numbers.size() * sizeof(float);
    Json& views = document_["bufferViews"];
    Json& accessors = document_["accessors"];
    views.push_back(Json{{"buffer", buffer_}, {"byteOffset", data_.size()}, {"byteLength", bytes}});
    const char* const type = components == 1 ? "SCALAR" : components == placeSize ? "VEC3" : "VEC4";
    Json accessor{{"bufferView", views.size() - 1},
                  {"componentType", 5126U},
                  {"count", numbers.size() / components},
                  {"type", type}};
    if (components == 1) {
      accessor["min"] = {numbers.front()};
      accessor["max"] = {numbers.back()};
    }
    accessors.push_back(std::move(accessor));
    const std::size_t end = data_.size();
    data_.resize(end + bytes);
    std::memcpy(data_.data() + end, numbers.data(), bytes);
    return accessors.size() - 1;
  }

  [[nodiscard]] std::string& data() { return data_; }

 private:
  Json& document_;
  std::size_t buffer_;
  std::string data_;
};

}  // namespace

bool straightenKeys(Json& document, std::vector<std::string>& buffers) {
  NumbersWriter writer(document, buffers.size());
  for (std::size_t a = 0; gltfElementOf(document, "animations", a) != nullptr; ++a) {
    for (std::size_t s = 0; gltfElementOf(document["animations"][a], "samplers", s) != nullptr; ++s) {
      Json& sampler = document["animations"][a]["samplers"][s];
      if (const auto keys = straightKeysOf(document, buffers, sampler)) {
        sampler["input"] = writer.add(keys->times, 1);
        sampler["output"] = writer.add(keys->values, keys->size);
        sampler["interpolation"] = "LINEAR";
      }
    }
  }
  if (writer.data().empty()) {
    return false;
  }
  buffers.push_back(std::move(writer.data()));
  return true;
}

}  // namespace drape::io
