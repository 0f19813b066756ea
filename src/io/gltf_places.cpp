#include "io/gltf_places.hpp"

#include <Eigen/Geometry>

namespace drape::io {
namespace {

using Json = nlohmann::json;

GltfMatrix matrixOf(const Json& node) {
  GltfMatrix matrix = GltfMatrix::Identity();
  const auto number = [&](const char* key, std::size_t i) { return node[key][i].get<double>(); };
  if (node.contains("matrix")) {
    for (std::size_t i = 0; i < 16; ++i) {
      matrix.data()[i] = number("matrix", i);
    }
    return matrix;
  }
  Eigen::Affine3d place = Eigen::Affine3d::Identity();
  if (node.contains("translation")) {
    place.translate(Eigen::Vector3d(number("translation", 0), number("translation", 1), number("translation", 2)));
  }
  if (node.contains("rotation")) {
    place.rotate(
        Eigen::Quaterniond(number("rotation", 3), number("rotation", 0), number("rotation", 1), number("rotation", 2)));
  }
  if (node.contains("scale")) {
    place.scale(Eigen::Vector3d(number("scale", 0), number("scale", 1), number("scale", 2)));
  }
  return place.matrix();
}

}  // namespace

Json numbersOf(const GltfMatrix& matrix) {
  return std::vector<double>(matrix.data(), matrix.data() + matrix.size());
}

GltfPlaces::GltfPlaces(const Json& nodes) : nodes_(nodes), parents_(nodes.size(), nodes.size()) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const Json& child : nodes[i].value("children", Json::array())) {
      parents_[child.get<std::size_t>()] = i;
    }
  }
}

std::size_t GltfPlaces::depthOf(std::size_t node) const {
  std::size_t depth = 0;
  for (std::size_t above = parents_[node]; above < parents_.size(); above = parents_[above]) {
    ++depth;
  }
  return depth;
}

GltfMatrix GltfPlaces::of(std::size_t node) const {
  GltfMatrix place = matrixOf(nodes_[node]);
  for (std::size_t above = parents_[node]; above < parents_.size(); above = parents_[above]) {
    place = matrixOf(nodes_[above]) * place;
  }
  return place;
}

}  // namespace drape::io
