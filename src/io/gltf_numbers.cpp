#include "io/gltf_numbers.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace drape::io {
namespace {

using Json = nlohmann::json;

template <typename Number>
double readAs(const char* place) {
  Number number{};
  std::memcpy(&number, place, sizeof(number));
  return static_cast<double>(number);
}

/// A type of component.
struct ComponentType {
  std::uint64_t number;  ///< in the specification
  std::uint64_t bytes;
  double one;  ///< the stored number that stands for 1
  double (*read)(const char*);
};

constexpr std::array componentTypes{
    ComponentType{5120, 1, 127.0, readAs<std::int8_t>}, ComponentType{5121, 1, 255.0, readAs<std::uint8_t>},
    ComponentType{5122, 2, 32767.0, readAs<std::int16_t>}, ComponentType{5123, 2, 65535.0, readAs<std::uint16_t>},
    ComponentType{5126, 4, 1.0, readAs<float>}};

std::uint64_t componentsOf(const Json& accessor) {
  constexpr std::array<std::string_view, 4> types{"SCALAR", "VEC2", "VEC3", "VEC4"};
  const auto type = accessor.find("type");
  const auto* const found =
      type != accessor.end() && type->is_string() ? std::ranges::find(types, type->get<std::string>()) : types.end();
  return found != types.end() ? static_cast<std::uint64_t>(found - types.begin()) + 1 : 0;
}

}  // namespace

std::optional<std::uint64_t> gltfIndexOf(const Json& object, const char* key) {
  // Sums and products of two numbers below this do not overflow.
  constexpr std::uint64_t largestNumber = std::uint64_t{1} << 31U;
  const auto found = object.find(key);
  const bool isNumber =
      found != object.end() && found->is_number_unsigned() && found->get<std::uint64_t>() < largestNumber;
  return isNumber ? std::optional(found->get<std::uint64_t>()) : std::nullopt;
}

const Json* gltfElementOf(const Json& object, const char* list, std::optional<std::uint64_t> index) {
  const auto found = object.is_object() ? object.find(list) : object.end();
  const bool isThere = index && object.is_object() && found != object.end() && found->is_array() &&
                       *index < found->size() && (*found)[*index].is_object();
  return isThere ? &(*found)[*index] : nullptr;
}

GltfNumbers::GltfNumbers(const Json& document, const std::vector<std::string>& buffers,
                         std::optional<std::uint64_t> accessor) {
  const Json* const description = gltfElementOf(document, "accessors", accessor);
  const Json* const view = description != nullptr
                               ? gltfElementOf(document, "bufferViews", gltfIndexOf(*description, "bufferView"))
                               : nullptr;
  if (view == nullptr || description->contains("sparse")) {
    return;
  }
  const auto* const type =
      std::ranges::find(componentTypes, gltfIndexOf(*description, "componentType").value_or(0), &ComponentType::number);
  const std::uint64_t components = componentsOf(*description);
  const std::uint64_t size = type != componentTypes.end() ? components * type->bytes : 0;
  const std::uint64_t count = gltfIndexOf(*description, "count").value_or(0);
  const std::uint64_t offset =
      gltfIndexOf(*description, "byteOffset").value_or(0) + gltfIndexOf(*view, "byteOffset").value_or(0);
  const std::uint64_t stride = gltfIndexOf(*view, "byteStride").value_or(size);
  const auto buffer = gltfIndexOf(*view, "buffer");
  if (size > 0 && count > 0 && buffer && *buffer < buffers.size() &&
      offset + (count - 1) * stride + size <= buffers[*buffer].size()) {
    data_ = buffers[*buffer].data() + offset;
    components_ = components;
    read_ = type->read;
    componentBytes_ = type->bytes;
    one_ = type->one;
    count_ = count;
    stride_ = stride;
  }
}

double GltfNumbers::value(std::uint64_t element, std::uint64_t component) const {
  return read_(data_ + element * stride_ + component * componentBytes_);
}

double GltfNumbers::share(std::uint64_t element, std::uint64_t component) const {
  const double stored = value(element, component);
  return one_ == 1.0 ? stored : std::max(-1.0, stored / one_);
}

}  // namespace drape::io
