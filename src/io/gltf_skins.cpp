#include "io/gltf_skins.hpp"

#include "messages/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>

namespace drape::io {
namespace {

using Json = nlohmann::json;
using Four = std::array<double, 4>;

/// Component types, by their numbers in the specification.
constexpr std::uint64_t unsignedByte = 5121;
constexpr std::uint64_t unsignedShort = 5123;
constexpr std::uint64_t realNumber = 5126;

/// Offsets and counts stay below this, so that sums and products of two of them do not overflow.
constexpr std::uint64_t largestNumber = std::uint64_t{1} << 31U;

/// The element of a list; null if it is not there.
const Json* elementOf(const Json& object, const char* list, std::optional<std::uint64_t> index) {
  const auto found = object.is_object() ? object.find(list) : object.end();
  const bool isThere = index && object.is_object() && found != object.end() && found->is_array() &&
                       *index < found->size() && (*found)[*index].is_object();
  return isThere ? &(*found)[*index] : nullptr;
}

std::optional<std::uint64_t> numberOf(const Json& object, const char* key) {
  const auto found = object.find(key);
  const bool isNumber =
      found != object.end() && found->is_number_unsigned() && found->get<std::uint64_t>() < largestNumber;
  return isNumber ? std::optional(found->get<std::uint64_t>()) : std::nullopt;
}

/// The elements of an accessor with four components.
class Quadruples {
 public:
  Quadruples(const Json& document, const std::vector<std::string>& buffers, std::optional<std::uint64_t> index) {
    const Json* const accessor = elementOf(document, "accessors", index);
    const Json* const view =
        accessor != nullptr ? elementOf(document, "bufferViews", numberOf(*accessor, "bufferView")) : nullptr;
    if (view == nullptr || accessor->value("type", Json()) != "VEC4" || accessor->contains("sparse")) {
      return;
    }
    component_ = numberOf(*accessor, "componentType").value_or(0);
    const std::uint64_t bytes = componentBytes();
    const std::uint64_t buffer = numberOf(*view, "buffer").value_or(largestNumber);
    const std::uint64_t offset =
        numberOf(*accessor, "byteOffset").value_or(0) + numberOf(*view, "byteOffset").value_or(0);
    const std::uint64_t count = numberOf(*accessor, "count").value_or(0);
    stride_ = numberOf(*view, "byteStride").value_or(4 * bytes);
    if (bytes > 0 && count > 0 && buffer < buffers.size() &&
        offset + (count - 1) * stride_ + 4 * bytes <= buffers[buffer].size()) {
      data_ = buffers[buffer].data() + offset;
      count_ = count;
    }
  }

  /// 0 if they cannot be read.
  [[nodiscard]] std::uint64_t count() const { return count_; }

  /// Whole numbers are shares of the largest one, as of weights.
  [[nodiscard]] Four shares(std::uint64_t index) const {
    const double one = component_ == unsignedByte ? 255.0 : component_ == unsignedShort ? 65535.0 : 1.0;
    Four result = values(index);
    std::ranges::for_each(result, [&](double& value) { value /= one; });
    return result;
  }

  [[nodiscard]] Four values(std::uint64_t index) const {
    Four result{};
    for (std::size_t k = 0; k < result.size(); ++k) {
      const char* const place = data_ + index * stride_ + k * componentBytes();
      if (component_ == realNumber) {
        float value = 0.0F;
        std::memcpy(&value, place, sizeof(value));
        result[k] = value;
      } else {
        std::uint16_t value = 0;
        std::memcpy(&value, place, componentBytes());
        result[k] = value;
      }
    }
    return result;
  }

 private:
  [[nodiscard]] std::uint64_t componentBytes() const {
    return component_ == unsignedByte ? 1 : component_ == unsignedShort ? 2 : component_ == realNumber ? 4 : 0;
  }

  const char* data_ = nullptr;
  std::uint64_t component_ = 0;
  std::uint64_t count_ = 0;
  std::uint64_t stride_ = 0;
};

/// A part of a mesh with a skin.
struct SkinnedPart {
  const Json& attributes;
  std::string name;  ///< for messages
  std::size_t joints = 0;
};

void checkPart(const Json& document, const std::vector<std::string>& buffers, const SkinnedPart& part) {
  std::vector<double> sums;
  for (int set = 0;; ++set) {
    const std::string end = "_" + std::to_string(set);
    const Quadruples joints(document, buffers, numberOf(part.attributes, ("JOINTS" + end).c_str()));
    const Quadruples weights(document, buffers, numberOf(part.attributes, ("WEIGHTS" + end).c_str()));
    const std::uint64_t count = std::min(joints.count(), weights.count());
    if (count == 0) {
      break;
    }
    sums.resize(std::max<std::size_t>(sums.size(), count), 0.0);
    for (std::uint64_t v = 0; v < count; ++v) {
      const Four shares = weights.shares(v);
      const Four followed = joints.values(v);
      for (std::size_t k = 0; k < shares.size(); ++k) {
        if (shares[k] > 0.0 && followed[k] >= static_cast<double>(part.joints)) {
          throw messages::InputError("vertex " + std::to_string(v) + " of " + part.name + " follows joint " +
                                     std::to_string(static_cast<int>(followed[k])) + ", and its skin has only " +
                                     std::to_string(part.joints) +
                                     ", counted from 0. The file is damaged: export or copy it again.");
        }
        sums[v] += std::max(0.0, shares[k]);
      }
    }
  }
  constexpr double maxShare = 0.01;
  const auto free = std::ranges::count_if(sums, [](double sum) { return !(sum > 0.0); });
  if (static_cast<double>(free) > maxShare * static_cast<double>(sums.size())) {
    throw messages::InputError(std::to_string(free) + " of " + std::to_string(sums.size()) + " vertices of " +
                               part.name +
                               " follow no joint: all their weights are 0. Paint the weights, or bind the mesh to its "
                               "skeleton again, and export it.");
  }
}

}  // namespace

void checkSkins(const Json& document, const std::vector<std::string>& buffers) {
  const auto nodes = document.find("nodes");
  const std::size_t count = nodes != document.end() && nodes->is_array() ? nodes->size() : 0;
  for (std::size_t n = 0; n < count; ++n) {
    const Json* const node = elementOf(document, "nodes", n);
    const Json* const skin = node != nullptr ? elementOf(document, "skins", numberOf(*node, "skin")) : nullptr;
    const auto meshIndex = node != nullptr ? numberOf(*node, "mesh") : std::nullopt;
    const Json* const mesh = elementOf(document, "meshes", meshIndex);
    if (skin == nullptr || mesh == nullptr) {
      continue;
    }
    const std::size_t joints = skin->value("joints", Json::array()).size();
    if (joints == 0) {
      throw messages::InputError("the skin of meshes[" + std::to_string(*meshIndex) +
                                 "] has no joints. Bind the mesh to its skeleton again, and export it.");
    }
    for (std::uint64_t p = 0; const Json* const primitive = elementOf(*mesh, "primitives", p); ++p) {
      if (const auto found = primitive->find("attributes"); found != primitive->end() && found->is_object()) {
        checkPart(document, buffers,
                  {*found, "meshes[" + std::to_string(*meshIndex) + "].primitives[" + std::to_string(p) + "]", joints});
      }
    }
  }
}

}  // namespace drape::io
