#include "io/gltf_content.hpp"

#include "io/gltf_places.hpp"
#include "io/quoted_text.hpp"
#include "messages/error.hpp"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

namespace drape::io {
namespace {

using Json = nlohmann::json;

/// Component types, by their numbers in the specification.
constexpr std::uint64_t unsignedByte = 5121;
constexpr std::uint64_t unsignedShort = 5123;
constexpr std::uint64_t unsignedInt = 5125;
constexpr std::uint64_t realNumber = 5126;

constexpr std::uint64_t lastMode = 6;  // fans of triangles

/// Offsets and lengths stay below this, so that sums and products of two of them do not overflow.
constexpr std::uint64_t largestNumber = std::uint64_t{1} << 32U;

[[noreturn]] void fail(const std::string& what) {
  throw messages::InputError("its JSON is damaged: " + what + ". Export or copy it again.");
}

std::string element(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

const Json* memberOf(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() ? &*found : nullptr;
}

/// The array under this key; empty when there is none.
const Json& listOf(const Json& object, const char* key, const std::string& where) {
  static const Json none = Json::array();
  const Json* const list = memberOf(object, key);
  if (list != nullptr && !list->is_array()) {
    fail(where + key + " is not a list");
  }
  return list != nullptr ? *list : none;
}

std::uint64_t wholeNumber(const Json& value, const std::string& where) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > largestNumber) {
    fail(where + " is not a whole number that a file can need");
  }
  return value.get<std::uint64_t>();
}

std::optional<std::uint64_t> numberOf(const Json& object, const char* key, const std::string& where) {
  const Json* const value = memberOf(object, key);
  return value != nullptr ? std::optional(wholeNumber(*value, where + "." + key)) : std::nullopt;
}

std::uint64_t sizeOfComponent(std::uint64_t type) {
  return type == unsignedByte ? 1 : type == unsignedShort ? 2 : 4;
}

/// Where the numbers of an accessor lie.
struct Numbers {
  const char* data = nullptr;  ///< empty when they are not in one piece
  std::uint64_t count = 0;
  std::uint64_t stride = 0;
};

class PartsCollector {
 public:
  PartsCollector(const Json& document, const std::vector<std::string>& buffers)
      : document_(document), buffers_(buffers) {}

  Json collect() {
    requireVersion();
    copyExtensions();
    accessors_ = Json(list("accessors").size(), Json::object());
    parts_["bufferViews"] = Json(list("bufferViews").size(), Json::object());
    parts_["nodes"] = Json(list("nodes").size(), Json::object());
    addMeshes();
    addScene();
    parts_["accessors"] = std::move(accessors_);
    return std::move(parts_);
  }

 private:
  const Json& list(const char* key) const { return listOf(document_, key, ""); }

  /// An element of one of the document's lists that `where` names.
  const Json& get(const char* key, std::uint64_t index, const std::string& where) const {
    const Json& all = list(key);
    if (index >= all.size()) {
      fail(where + " names " + element(key, index) + ", and there are only " + std::to_string(all.size()));
    }
    if (!all[index].is_object()) {
      fail(element(key, index) + " is not an object");
    }
    return all[index];
  }

  void requireVersion() {
    const Json* const asset = memberOf(document_, "asset");
    const Json* const version = asset != nullptr && asset->is_object() ? memberOf(*asset, "version") : nullptr;
    if (version == nullptr || !version->is_string()) {
      fail("asset.version, the version of glTF, is missing or not a text");
    }
    const std::string text = version->get<std::string>();
    if (text.rfind("2.", 0) != 0) {
      throw messages::InputError("it is glTF of version " + drape::io::quoted(text) +
                                 ", and version 2.0 is read. Export it as glTF 2.0.");
    }
    parts_["asset"]["version"] = "2.0";
  }

  void copyExtensions() {
    for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
      if (!list(key).empty()) {
        parts_[key] = list(key);
      }
    }
  }

  void addMeshes() {
    Json& meshes = parts_["meshes"] = Json::array();
    std::size_t usable = 0;
    for (std::size_t i = 0; i < list("meshes").size(); ++i) {
      const std::string where = element("meshes", i);
      const Json& mesh = get("meshes", i, where);
      Json primitives = Json::array();
      const Json& all = listOf(mesh, "primitives", where + ".");
      for (std::size_t k = 0; k < all.size(); ++k) {
        addPrimitive(all[k], where + "." + element("primitives", k), primitives);
      }
      usable += primitives.size();
      meshes.push_back(Json{{"primitives", std::move(primitives)}});
    }
    if (usable == 0) {
      throw messages::InputError("none of its meshes has positions of vertices. Export the mesh again.");
    }
  }

  /// A primitive without positions is not drawn, says the specification.
  void addPrimitive(const Json& primitive, const std::string& where, Json& primitives) {
    if (!primitive.is_object()) {
      fail(where + " is not an object");
    }
    requireNoDraco(primitive);
    const Json* const attributes = memberOf(primitive, "attributes");
    if (attributes == nullptr || !attributes->is_object() || memberOf(*attributes, "POSITION") == nullptr) {
      return;
    }
    Json kept;
    const Numbers positions = addPositions(*attributes, where, kept);
    addTexture(*attributes, where, kept);
    if (const auto indices = numberOf(primitive, "indices", where)) {
      addIndices(*indices, where + ".indices", positions.count);
      kept["indices"] = *indices;
    }
    const Json* const mode = memberOf(primitive, "mode");
    if (mode != nullptr && mode->is_number_unsigned() && mode->get<std::uint64_t>() <= lastMode) {
      kept["mode"] = *mode;
    }
    primitives.push_back(std::move(kept));
  }

  static void requireNoDraco(const Json& primitive) {
    const Json* const extensions = memberOf(primitive, "extensions");
    if (extensions != nullptr && extensions->is_object() && extensions->contains("KHR_draco_mesh_compression")) {
      throw messages::InputError(
          "its vertices are compressed (KHR_draco_mesh_compression), which is not read. Export it without "
          "compression.");
    }
  }

  Numbers addPositions(const Json& attributes, const std::string& where, Json& kept) {
    const std::uint64_t index = *numberOf(attributes, "POSITION", where);
    const std::string name = element("accessors", index);
    const Json& accessor = get("accessors", index, where + ".POSITION");
    if (typeOf(accessor) != "VEC3" || componentOf(accessor, name) != realNumber) {
      throw messages::InputError("the positions of its vertices (" + name +
                                 ") are not three float numbers each. Export it without quantization or compression.");
    }
    const Numbers positions = addAccessor(index, 3 * sizeof(float));
    for (std::uint64_t i = 0; positions.data != nullptr && i < positions.count; ++i) {
      std::array<float, 3> place{};
      std::memcpy(place.data(), positions.data + i * positions.stride, sizeof(place));
      if (!std::all_of(place.begin(), place.end(), [](float value) { return std::isfinite(value); })) {
        throw messages::InputError(
            "vertex " + std::to_string(i) + " of " + where +
            " has a coordinate that is not a finite number (nan or inf). Repair the mesh or export it "
            "again.");
      }
    }
    kept["attributes"]["POSITION"] = index;
    return positions;
  }

  /// Only float coordinates are kept. The picture does not need others.
  void addTexture(const Json& attributes, const std::string& where, Json& kept) {
    const auto index = numberOf(attributes, "TEXCOORD_0", where);
    if (!index) {
      return;
    }
    const Json& accessor = get("accessors", *index, where + ".TEXCOORD_0");
    if (typeOf(accessor) == "VEC2" && componentOf(accessor, element("accessors", *index)) == realNumber) {
      (void)addAccessor(*index, 2 * sizeof(float));
      kept["attributes"]["TEXCOORD_0"] = *index;
    }
  }

  void addIndices(std::uint64_t index, const std::string& where, std::uint64_t vertices) {
    const Json& accessor = get("accessors", index, where);
    const std::string name = element("accessors", index);
    const std::uint64_t type = componentOf(accessor, name);
    if (typeOf(accessor) != "SCALAR" || (type != unsignedByte && type != unsignedShort && type != unsignedInt)) {
      fail(name + " holds the numbers of corners, and they are not whole numbers without a sign");
    }
    const std::uint64_t size = sizeOfComponent(type);
    const Numbers corners = addAccessor(index, size);
    for (std::uint64_t i = 0; corners.data != nullptr && i < corners.count; ++i) {
      std::uint32_t vertex = 0;
      std::memcpy(&vertex, corners.data + i * corners.stride, size);
      if (vertex >= vertices) {
        throw messages::InputError("a face uses vertex " + std::to_string(vertex) + ", and its mesh has only " +
                                   std::to_string(vertices) + " counted from 0 (" + name +
                                   "). The file is damaged: export or copy it again.");
      }
    }
  }

  static std::string typeOf(const Json& accessor) {
    const Json* const type = memberOf(accessor, "type");
    return type != nullptr && type->is_string() ? type->get<std::string>() : "";
  }

  static std::uint64_t componentOf(const Json& accessor, const std::string& name) {
    return numberOf(accessor, "componentType", name).value_or(0);
  }

  Numbers addAccessor(std::uint64_t index, std::uint64_t size) {
    const std::string name = element("accessors", index);
    const Json& accessor = get("accessors", index, name);
    Numbers numbers;
    numbers.count = numberOf(accessor, "count", name).value_or(0);
    if (numbers.count == 0) {
      fail(name + ".count is 0 or missing");
    }
    Json kept{{"componentType", accessor["componentType"]}, {"type", accessor["type"]}, {"count", numbers.count}};
    const Json* const sparse = memberOf(accessor, "sparse");
    const auto view = numberOf(accessor, "bufferView", name);
    if (!view && sparse == nullptr) {
      fail(name + " has no bufferView, and so no data");
    }
    if (view) {
      kept["bufferView"] = *view;
      kept["byteOffset"] = numberOf(accessor, "byteOffset", name).value_or(0);
      const std::uint64_t stride = addView(*view, name);
      numbers.stride = stride != 0 ? stride : size;
      numbers.data = dataOf(*view, kept["byteOffset"].get<std::uint64_t>(), numbers, size, name);
    }
    if (sparse != nullptr) {
      addSparse(*sparse, size, numbers.count, name + ".sparse");
      kept["sparse"] = *sparse;
      numbers.data = nullptr;
    }
    accessors_[index] = std::move(kept);
    return numbers;
  }

  /// Checks a buffer view and keeps it. Returns its stride, 0 when it has none.
  std::uint64_t addView(std::uint64_t index, const std::string& user) {
    const std::string name = element("bufferViews", index);
    const Json& view = get("bufferViews", index, user);
    const std::uint64_t buffer = numberOf(view, "buffer", name).value_or(largestNumber);
    if (buffer >= buffers_.size()) {
      fail(name + " names a buffer that is not there");
    }
    const std::uint64_t offset = numberOf(view, "byteOffset", name).value_or(0);
    const std::uint64_t length = numberOf(view, "byteLength", name).value_or(0);
    const std::uint64_t stride = numberOf(view, "byteStride", name).value_or(0);
    if (offset + length > buffers_[buffer].size()) {
      fail(name + " ends at byte " + std::to_string(offset + length) + " of a buffer of " +
           std::to_string(buffers_[buffer].size()));
    }
    Json& kept = parts_["bufferViews"][index];
    kept = Json{{"buffer", buffer}, {"byteOffset", offset}, {"byteLength", length}};
    if (stride != 0) {
      kept["byteStride"] = stride;
    }
    return stride;
  }

  [[nodiscard]] const char* dataOf(std::uint64_t view, std::uint64_t offset, const Numbers& numbers, std::uint64_t size,
                                   const std::string& name) const {
    const Json& kept = parts_["bufferViews"][view];
    const auto length = kept["byteLength"].get<std::uint64_t>();
    // A stride below the size would let elements overlap; it is damage too.
    if (numbers.stride < size || offset + size > length ||
        (numbers.count - 1) > (length - offset - size) / numbers.stride) {
      fail(name + " needs " + std::to_string(numbers.count) + " elements, more than " + element("bufferViews", view) +
           " holds");
    }
    const std::string& buffer = buffers_[kept["buffer"].get<std::size_t>()];
    return buffer.data() + kept["byteOffset"].get<std::uint64_t>() + offset;
  }

  /// Values that replace some of an accessor's. The library reads them, so only the sizes are checked.
  void addSparse(const Json& sparse, std::uint64_t size, std::uint64_t maxCount, const std::string& name) {
    const Json* const indices = sparse.is_object() ? memberOf(sparse, "indices") : nullptr;
    const Json* const values = sparse.is_object() ? memberOf(sparse, "values") : nullptr;
    if (indices == nullptr || values == nullptr || !indices->is_object() || !values->is_object()) {
      fail(name + " has no indices or no values");
    }
    Numbers numbers;
    numbers.count = numberOf(sparse, "count", name).value_or(0);
    if (numbers.count == 0 || numbers.count > maxCount) {
      fail(name + ".count is not between 1 and " + std::to_string(maxCount));
    }
    const std::uint64_t type = componentOf(*indices, name);
    const std::uint64_t indexSize = sizeOfComponent(type);
    numbers.stride = indexSize;
    const char* const places = sparseData(*indices, numbers, indexSize, name);
    for (std::uint64_t i = 0; i < numbers.count; ++i) {
      std::uint32_t place = 0;
      std::memcpy(&place, places + i * indexSize, indexSize);
      if (place >= maxCount) {
        fail(name + " replaces element " + std::to_string(place) + " of " + std::to_string(maxCount));
      }
    }
    numbers.stride = size;
    (void)sparseData(*values, numbers, size, name);
  }

  const char* sparseData(const Json& part, const Numbers& numbers, std::uint64_t size, const std::string& name) {
    const std::uint64_t view = numberOf(part, "bufferView", name).value_or(largestNumber);
    (void)addView(view, name);
    return dataOf(view, numberOf(part, "byteOffset", name).value_or(0), numbers, size, name);
  }

  void addScene() {
    const std::uint64_t index = numberOf(document_, "scene", "JSON").value_or(0);
    if (list("scenes").empty()) {
      throw messages::InputError("it has no scene, so nothing says which meshes belong to it. Export the mesh again.");
    }
    const std::string name = element("scenes", index);
    Json roots = Json::array();
    seen_.assign(list("nodes").size(), false);
    for (const Json& root : listOf(get("scenes", index, "scene"), "nodes", name + ".")) {
      roots.push_back(addNode(root, name, 0));
    }
    if (!hasMesh_) {
      throw messages::InputError("no node of its scene uses a mesh. Export the mesh again.");
    }
    placeSkinnedMeshes(roots);
    parts_["scene"] = 0;
    parts_["scenes"] = Json::array({Json{{"nodes", std::move(roots)}}});
  }

  /// Section 3.5.2: nodes are trees, so that each has one place.
  std::uint64_t addNode(const Json& reference, const std::string& parent, int depth) {
    constexpr int deepest = 1000;
    const std::uint64_t index = wholeNumber(reference, "a node of " + parent);
    const std::string name = element("nodes", index);
    const Json& node = get("nodes", index, parent);
    if (seen_[index]) {
      fail(name + " belongs to two nodes, or to itself");
    }
    if (depth > deepest) {
      fail("its nodes are nested deeper than " + std::to_string(deepest));
    }
    seen_[index] = true;
    Json kept = placementOf(node, name);
    if (const auto mesh = numberOf(node, "mesh", name)) {
      (void)get("meshes", *mesh, name);
      kept["mesh"] = *mesh;
      hasMesh_ = true;
    }
    for (const Json& child : listOf(node, "children", name + ".")) {
      kept["children"].push_back(addNode(child, name, depth + 1));
    }
    parts_["nodes"][index] = std::move(kept);
    return index;
  }

  /// Section 3.7.3.3: the transform of a node with a skin is ignored; its joints place the mesh. A node that is
  /// elsewhere loses its mesh to a node of its own. Its skin may be damaged; then the node decides.
  void placeSkinnedMeshes(Json& roots) {
    constexpr double largestDifference = 0.6;  // of a matrix: that of a rotation by 45 degrees
    const GltfPlaces places(parts_["nodes"]);
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      Json& node = parts_["nodes"][i];
      const std::optional<GltfMatrix> bySkin = seen_[i] ? placeBySkin(list("nodes")[i], places) : std::nullopt;
      if (!bySkin) {
        continue;
      }
      const Eigen::Matrix3d byNode = places.of(i).topLeftCorner<3, 3>();
      if ((bySkin->topLeftCorner<3, 3>() - byNode).norm() > largestDifference * byNode.norm()) {
        roots.push_back(parts_["nodes"].size());
        parts_["nodes"].push_back(Json{{"mesh", node["mesh"]}, {"matrix", numbersOf(*bySkin)}});
        parts_["nodes"][i].erase("mesh");
      }
    }
  }

  /// The index of the joint that is nearest to the root of the scene. @param name of the skin
  [[nodiscard]] std::size_t rootOf(const Json& joints, const GltfPlaces& places, const std::string& name) const {
    std::vector<std::size_t> depths;
    for (const Json& joint : joints) {
      const std::uint64_t node = wholeNumber(joint, name + ".joints");
      if (node >= seen_.size() || !seen_[node]) {
        fail(name + " has a joint that is not in the scene");
      }
      depths.push_back(places.depthOf(node));
    }
    return static_cast<std::size_t>(std::ranges::min_element(depths) - depths.begin());
  }

  /// Where the root of its joints places a mesh in the pose in which it was modelled.
  std::optional<GltfMatrix> placeBySkin(const Json& node, const GltfPlaces& places) {
    try {
      const auto skin = numberOf(node, "skin", "node");
      if (!skin || !node.contains("mesh")) {
        return std::nullopt;
      }
      const std::string name = element("skins", *skin);
      const Json& described = get("skins", *skin, name);
      const Json& joints = listOf(described, "joints", name + ".");
      const auto binds = numberOf(described, "inverseBindMatrices", name);
      if (joints.empty() || !binds) {
        return std::nullopt;
      }
      const std::size_t root = rootOf(joints, places, name);
      const Numbers numbers = addAccessor(*binds, sizeof(Eigen::Matrix4f));
      if (numbers.data == nullptr || root >= numbers.count) {
        return std::nullopt;
      }
      Eigen::Matrix4f inverseBind;
      std::memcpy(inverseBind.data(), numbers.data + root * numbers.stride, sizeof(inverseBind));
      const GltfMatrix place = places.of(joints[root].get<std::size_t>()) * inverseBind.cast<double>();
      return place.allFinite() ? std::optional(place) : std::nullopt;
    } catch (const messages::InputError&) {
      return std::nullopt;
    }
  }

  static Json placementOf(const Json& node, const std::string& name) {
    constexpr std::array<std::pair<const char*, std::size_t>, 4> members{
        {{"matrix", 16}, {"translation", 3}, {"rotation", 4}, {"scale", 3}}};
    Json kept = Json::object();
    for (const auto& [key, size] : members) {
      if (!node.contains(key)) {
        continue;
      }
      const Json& values = listOf(node, key, name + ".");
      if (values.size() != size ||
          !std::all_of(values.begin(), values.end(), [](const Json& value) { return value.is_number(); })) {
        fail(name + "." + key + " is not a list of " + std::to_string(size) + " numbers");
      }
      kept[key] = values;
    }
    return kept;
  }

  const Json& document_;
  const std::vector<std::string>& buffers_;
  Json parts_ = Json::object();
  Json accessors_;
  std::vector<bool> seen_;
  bool hasMesh_ = false;
};

}  // namespace

Json meshPartsOf(const Json& document, const std::vector<std::string>& buffers) {
  return PartsCollector(document, buffers).collect();
}

}  // namespace drape::io
