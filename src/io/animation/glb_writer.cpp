// glTF 2.0 in one binary file: frame 0 is the mesh, and each later frame is a morph target, which holds the
// displacements from it. The animation blends from target to target.
#include "io/animation/animation.hpp"
#include "io/animation/number_bytes.hpp"
#include "io/animation/part_file.hpp"
#include "messages/error.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

namespace drape::io::animation {
namespace {

using nlohmann::json;

// Constants of the specification.
constexpr int floatNumber = 5126;
constexpr int unsignedNumber = 5125;
constexpr std::uint32_t fileMark = 0x46546C67;    // "glTF"
constexpr std::uint32_t jsonMark = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t binaryMark = 0x004E4942;  // "BIN"
constexpr std::size_t headerSize = 12;
constexpr std::size_t chunkHeaderSize = 8;

/// The vertices of glTF: those of the file in their order. Each has one texture coordinate, so those with several are
/// followed by copies, at the end.
struct SplitMesh {
  std::vector<int> vertex;  ///< of the file's mesh
  std::vector<Vec2> uvs;    ///< empty when the file has none
  std::vector<std::uint32_t> indices;
};

SplitMesh split(const FileMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  SplitMesh result;
  result.vertex.resize(vertices);
  std::iota(result.vertex.begin(), result.vertex.end(), 0);
  result.uvs.resize(mesh.uvs.empty() ? 0 : vertices, Vec2::Zero());
  std::vector<bool> used(vertices, false);
  std::map<std::pair<int, int>, std::uint32_t> known;
  const auto numberOf = [&](int corner) {
    const int vertex = mesh.corners[corner];
    const int uv = mesh.uvCorners.empty() ? -1 : mesh.uvCorners[corner];
    const auto [place, added] = known.try_emplace({vertex, uv}, static_cast<std::uint32_t>(vertex));
    if (added) {
      if (used[vertex]) {
        place->second = static_cast<std::uint32_t>(result.vertex.size());
        result.vertex.push_back(vertex);
        result.uvs.resize(mesh.uvs.empty() ? 0 : result.vertex.size());
      }
      used[vertex] = true;
      if (!mesh.uvs.empty()) {
        const Vec2 coordinates = uv < 0 ? Vec2(Vec2::Zero()) : mesh.uvs[uv];
        result.uvs[place->second] = {coordinates.x(), 1.0 - coordinates.y()};  // glTF counts v from the top
      }
    }
    return place->second;
  };
  for (std::size_t face = 0; face < mesh.faceEnds.size(); ++face) {
    const int first = mesh.firstCorner(face);
    for (int i = first + 1; i + 1 < mesh.faceEnds[face]; ++i) {
      for (const int corner : {first, i, i + 1}) {
        result.indices.push_back(numberOf(corner));
      }
    }
  }
  return result;
}

/// The smallest and largest coordinates, which glTF requires. Before they are known they are as long as text can be, so
/// that the space for the JSON suffices.
struct Limits {
  std::array<double, 3> low{longest, longest, longest};
  std::array<double, 3> high{longest, longest, longest};

  static constexpr double longest = -1.2345678901234567e-100;
};

/// The parts of the binary data in their order.
class Layout {
 public:
  /// Adds an array and returns the number of its accessor.
  std::size_t add(std::size_t count, int number, const char* type, int components, const Limits* limits = nullptr) {
    constexpr std::size_t numberSize = 4;
    const std::size_t bytes = numberSize * static_cast<std::size_t>(components) * count;
    json accessor{{"bufferView", views_.size()}, {"componentType", number}, {"count", count}, {"type", type}};
    if (limits != nullptr) {
      accessor["min"] = limits->low;
      accessor["max"] = limits->high;
    }
    views_.push_back({{"buffer", 0}, {"byteOffset", size_}, {"byteLength", bytes}});
    accessors_.push_back(std::move(accessor));
    size_ += bytes;
    return accessors_.size() - 1;
  }

  [[nodiscard]] const json& views() const { return views_; }
  [[nodiscard]] json& accessors() { return accessors_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  json views_ = json::array();
  json accessors_ = json::array();
  std::size_t size_ = 0;
};

class GlbWriter : public Writer {
 public:
  GlbWriter(const FileOfFrame& files, Clip clip)
      : name_(files(clip.firstFrame).string()), file_(name_), clip_(std::move(clip)) {
    for (const Object& object : clip_.objects) {
      parts_.push_back(split(*object.mesh));
    }
    limits_.assign(static_cast<std::size_t>(clip_.frames) * parts_.size(), Limits{});
    Document planned = documentFor(clip_.frames);
    jsonSize_ = (planned.text.size() + 3) / 4 * 4;
    if (headerSize + 2 * chunkHeaderSize + jsonSize_ + planned.binarySize > std::numeric_limits<std::uint32_t>::max()) {
      throw messages::InputError(name_ +
                                 ": the animation needs more than 4 GiB, the limit of this format. Use .pc2 or "
                                 ".usda, or fewer frames.");
    }
    file_.write(std::string(headerSize + chunkHeaderSize + jsonSize_ + chunkHeaderSize, ' '));
    for (const SplitMesh& part : parts_) {
      file_.write(topologyOf(part));
    }
  }

  void add(const Frame& frame) override {
    if (written_ == 0) {
      first_ = frame;
    }
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const bool isFirst = written_ == 0;
      Limits& limits = limits_[static_cast<std::size_t>(written_) * parts_.size() + i];
      const std::vector<Vec3> zero(isFirst ? first_[i].positions.size() : 0, Vec3::Zero());
      file_.write(rowsOf(parts_[i], frame[i].positions, isFirst ? zero : first_[i].positions, &limits));
      file_.write(rowsOf(parts_[i], frame[i].normals, isFirst ? zero : first_[i].normals, nullptr));
    }
    ++written_;
  }

  void finish() override {
    file_.write(blendingOf(written_));
    Document document = documentFor(written_);
    document.text.resize(jsonSize_, ' ');
    std::string head;
    const std::size_t whole = headerSize + 2 * chunkHeaderSize + jsonSize_ + document.binarySize;
    for (const std::uint32_t number : {fileMark, std::uint32_t{2}, static_cast<std::uint32_t>(whole),
                                       static_cast<std::uint32_t>(jsonSize_), jsonMark}) {
      appendBytes(head, number);
    }
    head += document.text;
    appendBytes(head, static_cast<std::uint32_t>(document.binarySize));
    appendBytes(head, binaryMark);
    file_.writeAt(0, head);
    file_.commit();
  }

 private:
  struct Document {
    std::string text;
    std::size_t binarySize = 0;
  };

  static std::string topologyOf(const SplitMesh& part) {
    std::string bytes;
    for (const std::uint32_t index : part.indices) {
      appendBytes(bytes, index);
    }
    for (const Vec2& uv : part.uvs) {
      appendBytes(bytes, static_cast<float>(uv.x()));
      appendBytes(bytes, static_cast<float>(uv.y()));
    }
    return bytes;
  }

  /// The differences of two arrays in the order of the split mesh.
  static std::string rowsOf(const SplitMesh& part, const std::vector<Vec3>& rows, const std::vector<Vec3>& from,
                            Limits* limits) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3 low = Vec3::Constant(infinity);
    Vec3 high = Vec3::Constant(-infinity);
    std::string bytes;
    for (const int vertex : part.vertex) {
      // The limits must be those of the stored numbers.
      const Vec3 row = (rows[vertex] - from[vertex]).cast<float>().cast<double>();
      low = low.cwiseMin(row);
      high = high.cwiseMax(row);
      appendBytes(bytes, row);
    }
    if (limits != nullptr) {
      limits->low = {low.x(), low.y(), low.z()};
      limits->high = {high.x(), high.y(), high.z()};
    }
    return bytes;
  }

  /// The times of the frames, and the weight of each target at each of them.
  [[nodiscard]] std::string blendingOf(int frames) const {
    std::string bytes;
    for (int frame = 0; frames > 1 && frame < frames; ++frame) {
      appendBytes(bytes, static_cast<float>((clip_.firstFrame + frame) / clip_.rate));
    }
    for (int frame = 0; frames > 1 && frame < frames; ++frame) {
      for (int target = 1; target < frames; ++target) {
        appendBytes(bytes, target == frame ? 1.0F : 0.0F);
      }
    }
    return bytes;
  }

  [[nodiscard]] Document documentFor(int frames) const {
    Layout layout;
    json meshes = json::array();
    for (const SplitMesh& part : parts_) {
      json attributes = json::object();
      const std::size_t indices = layout.add(part.indices.size(), unsignedNumber, "SCALAR", 1);
      if (!part.uvs.empty()) {
        attributes["TEXCOORD_0"] = layout.add(part.uvs.size(), floatNumber, "VEC2", 2);
      }
      json primitive{{"attributes", attributes}, {"indices", indices}, {"material", 0}};
      meshes.push_back({{"primitives", json::array({primitive})}});
    }
    for (int frame = 0; frame < frames; ++frame) {
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        const std::size_t count = parts_[i].vertex.size();
        const Limits& limits = limits_[static_cast<std::size_t>(frame) * parts_.size() + i];
        const std::size_t positions = layout.add(count, floatNumber, "VEC3", 3, &limits);
        const std::size_t normals = layout.add(count, floatNumber, "VEC3", 3);
        json& primitive = meshes[i]["primitives"][0];
        if (frame == 0) {
          primitive["attributes"]["POSITION"] = positions;
          primitive["attributes"]["NORMAL"] = normals;
        } else {
          primitive["targets"].push_back({{"POSITION", positions}, {"NORMAL", normals}});
        }
      }
    }
    return finished(std::move(layout), std::move(meshes), frames);
  }

  [[nodiscard]] Document finished(Layout layout, json meshes, int frames) const {
    json document{{"asset", {{"version", "2.0"}, {"generator", clip_.comment}}},
                  {"scene", 0},
                  {"materials", json::array({{{"name", "cloth"}, {"doubleSided", true}}})}};
    json channels = json::array();
    json nodes = json::array();
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < clip_.objects.size(); ++i) {
      meshes[i]["name"] = clip_.objects[i].name;
      nodes.push_back({{"name", clip_.objects[i].name}, {"mesh", i}});
      roots.push_back(i);
      channels.push_back({{"sampler", 0}, {"target", {{"node", i}, {"path", "weights"}}}});
    }
    if (frames > 1) {
      const auto count = static_cast<std::size_t>(frames);
      const std::size_t times = layout.add(count, floatNumber, "SCALAR", 1);
      layout.accessors()[times]["min"] = {static_cast<double>(static_cast<float>(clip_.firstFrame / clip_.rate))};
      layout.accessors()[times]["max"] = {
          static_cast<double>(static_cast<float>((clip_.firstFrame + frames - 1) / clip_.rate))};
      const std::size_t weights = layout.add(count * (count - 1), floatNumber, "SCALAR", 1);
      document["animations"] = json::array(
          {{{"name", "motion"},
            {"channels", channels},
            {"samplers", json::array({{{"input", times}, {"output", weights}, {"interpolation", "LINEAR"}}})}}});
    }
    document["scenes"] = json::array({{{"nodes", roots}}});
    document["nodes"] = std::move(nodes);
    document["meshes"] = std::move(meshes);
    document["accessors"] = layout.accessors();
    document["bufferViews"] = layout.views();
    document["buffers"] = json::array({{{"byteLength", layout.size()}}});
    return {document.dump(-1, ' ', false, json::error_handler_t::replace), layout.size()};
  }

  std::string name_;
  PartFile file_;
  Clip clip_;
  std::vector<SplitMesh> parts_;
  std::vector<Limits> limits_;  // of the positions, by frame and object
  Frame first_;
  std::size_t jsonSize_ = 0;
  int written_ = 0;
};

}  // namespace

std::unique_ptr<Writer> makeGlbWriter(const FileOfFrame& files, const Clip& clip) {
  return std::make_unique<GlbWriter>(files, clip);
}

}  // namespace drape::io::animation
