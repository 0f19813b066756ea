#include "io/gltf_skins.hpp"

#include "io/gltf_numbers.hpp"
#include "messages/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace drape::io {
namespace {

using Json = nlohmann::json;

/// A part of a mesh with a skin.
struct SkinnedPart {
  const Json& attributes;
  std::string name;  ///< for messages
  std::size_t joints = 0;
};

void checkPart(const Json& document, const std::vector<std::string>& buffers, const SkinnedPart& part) {
  constexpr std::uint64_t width = 4;  // of a set of joints or weights
  std::vector<double> sums;
  for (int set = 0;; ++set) {
    const std::string end = "_" + std::to_string(set);
    const GltfNumbers joints(document, buffers, gltfIndexOf(part.attributes, ("JOINTS" + end).c_str()));
    const GltfNumbers weights(document, buffers, gltfIndexOf(part.attributes, ("WEIGHTS" + end).c_str()));
    const std::uint64_t count = std::min(joints.count(), weights.count());
    if (count == 0 || joints.components() != width || weights.components() != width) {
      break;
    }
    sums.resize(std::max<std::size_t>(sums.size(), count), 0.0);
    for (std::uint64_t v = 0; v < count; ++v) {
      for (std::uint64_t k = 0; k < width; ++k) {
        const double share = weights.share(v, k);
        const double joint = joints.value(v, k);
        if (share > 0.0 && joint >= static_cast<double>(part.joints)) {
          throw messages::InputError("vertex " + std::to_string(v) + " of " + part.name + " follows joint " +
                                     std::to_string(static_cast<int>(joint)) + ", and its skin has only " +
                                     std::to_string(part.joints) +
                                     ", counted from 0. The file is damaged: export or copy it again.");
        }
        sums[v] += std::max(0.0, share);
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
    const Json* const node = gltfElementOf(document, "nodes", n);
    const Json* const skin = node != nullptr ? gltfElementOf(document, "skins", gltfIndexOf(*node, "skin")) : nullptr;
    const auto meshIndex = node != nullptr ? gltfIndexOf(*node, "mesh") : std::nullopt;
    const Json* const mesh = gltfElementOf(document, "meshes", meshIndex);
    if (skin == nullptr || mesh == nullptr) {
      continue;
    }
    const std::size_t joints = skin->value("joints", Json::array()).size();
    if (joints == 0) {
      throw messages::InputError("the skin of meshes[" + std::to_string(*meshIndex) +
                                 "] has no joints. Bind the mesh to its skeleton again, and export it.");
    }
    for (std::uint64_t p = 0; const Json* const primitive = gltfElementOf(*mesh, "primitives", p); ++p) {
      if (const auto found = primitive->find("attributes"); found != primitive->end() && found->is_object()) {
        checkPart(document, buffers,
                  {*found, "meshes[" + std::to_string(*meshIndex) + "].primitives[" + std::to_string(p) + "]", joints});
      }
    }
  }
}

}  // namespace drape::io
