// OBJ and PLY: one file per frame.
#include "io/animation/animation.hpp"
#include "io/animation/number_bytes.hpp"
#include "io/animation/part_file.hpp"

#include <utility>

namespace drape::io::animation {
namespace {

void appendRow(std::string& text, std::string_view keyword, const Vec3& row) {
  text += keyword;
  for (const double value : row) {
    text += ' ';
    appendFloat(text, value);
  }
  text += '\n';
}

/// The polygons, whose normals have the numbers of their vertices.
void appendObjFaces(std::string& text, const FileMesh& mesh, std::size_t firstVertex, std::size_t firstUv) {
  const auto out = std::back_inserter(text);
  for (std::size_t face = 0; face < mesh.faceEnds.size(); ++face) {
    text += 'f';
    for (int i = mesh.firstCorner(face); i < mesh.faceEnds[face]; ++i) {
      const std::size_t vertex = firstVertex + static_cast<std::size_t>(mesh.corners[i]);
      const int uv = mesh.uvCorners.empty() ? -1 : mesh.uvCorners[i];
      if (uv < 0) {
        fmt::format_to(out, " {}//{}", vertex, vertex);
      } else {
        fmt::format_to(out, " {}/{}/{}", vertex, firstUv + static_cast<std::size_t>(uv), vertex);
      }
    }
    text += '\n';
  }
}

std::string objOf(const Clip& clip, const Frame& frame) {
  std::string text = "# " + clip.comment + "\n";
  std::size_t firstVertex = 1;
  std::size_t firstUv = 1;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const FileMesh& mesh = *clip.objects[i].mesh;
    if (clip.objects.size() > 1) {
      text += "o " + clip.objects[i].name + "\n";
    }
    for (const Vec3& position : frame[i].positions) {
      appendRow(text, "v", position);
    }
    for (const Vec2& uv : mesh.uvs) {
      text += "vt ";
      appendFloat(text, uv.x());
      text += ' ';
      appendFloat(text, uv.y());
      text += '\n';
    }
    for (const Vec3& normal : frame[i].normals) {
      appendRow(text, "vn", normal);
    }
    appendObjFaces(text, mesh, firstVertex, firstUv);
    firstVertex += mesh.positions.size();
    firstUv += mesh.uvs.size();
  }
  return text;
}

/// Whether each vertex has one texture coordinate, so that they can be properties of the vertices.
bool hasUvsOfVertices(const FileMesh& mesh) {
  return !mesh.uvs.empty() && mesh.uvs.size() == mesh.positions.size() && mesh.uvCorners == mesh.corners;
}

std::string plyHeader(const Clip& clip, const FileMesh& mesh) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment " + clip.comment + "\n";
  text += fmt::format("element vertex {}\n", mesh.positions.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) {
    text += "property float " + std::string(name) + "\n";
  }
  if (hasUvsOfVertices(mesh)) {
    text += "property float s\nproperty float t\n";
  }
  text += fmt::format("element face {}\nproperty list int int vertex_indices\n", mesh.faceEnds.size());
  if (!hasUvsOfVertices(mesh) && !mesh.uvs.empty()) {
    text += "property list int float texcoord\n";
  }
  return text + "end_header\n";
}

std::string plyOf(const Clip& clip, const Frame& frame) {
  const FileMesh& mesh = *clip.objects.front().mesh;
  const Shape& shape = frame.front();
  const bool ofVertices = hasUvsOfVertices(mesh);
  std::string bytes = plyHeader(clip, mesh);
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    appendBytes(bytes, shape.positions[v]);
    appendBytes(bytes, shape.normals[v]);
    if (ofVertices) {
      appendBytes(bytes, static_cast<float>(mesh.uvs[v].x()));
      appendBytes(bytes, static_cast<float>(mesh.uvs[v].y()));
    }
  }
  for (std::size_t face = 0; face < mesh.faceEnds.size(); ++face) {
    const int first = mesh.firstCorner(face);
    const int count = mesh.faceEnds[face] - first;
    appendBytes(bytes, count);
    for (int i = first; i < first + count; ++i) {
      appendBytes(bytes, mesh.corners[i]);
    }
    if (!ofVertices && !mesh.uvs.empty()) {
      appendBytes(bytes, 2 * count);
      for (int i = first; i < first + count; ++i) {
        const Vec2 uv = mesh.uvCorners[i] < 0 ? Vec2(Vec2::Zero()) : mesh.uvs[mesh.uvCorners[i]];
        appendBytes(bytes, static_cast<float>(uv.x()));
        appendBytes(bytes, static_cast<float>(uv.y()));
      }
    }
  }
  return bytes;
}

/// Writes each frame to its own file.
class MeshFilesWriter : public Writer {
 public:
  using Encode = std::string (*)(const Clip&, const Frame&);

  MeshFilesWriter(FileOfFrame files, Clip clip, Encode encode)
      : files_(std::move(files)),
        clip_(std::move(clip)),
        encode_(encode),
        first_(std::make_unique<PartFile>(files_(clip_.firstFrame))) {}

  void add(const Frame& frame) override {
    const std::unique_ptr<PartFile> file =
        first_ ? std::move(first_) : std::make_unique<PartFile>(files_(clip_.firstFrame + written_));
    file->write(encode_(clip_, frame));
    file->commit();
    ++written_;
  }

  void finish() override {}

 private:
  FileOfFrame files_;
  Clip clip_;
  Encode encode_;
  std::unique_ptr<PartFile> first_;  // opened at once, so that a wrong folder shows before the run
  int written_ = 0;
};

}  // namespace

std::unique_ptr<Writer> makeObjWriter(const FileOfFrame& files, const Clip& clip) {
  return std::make_unique<MeshFilesWriter>(files, clip, objOf);
}

std::unique_ptr<Writer> makePlyWriter(const FileOfFrame& files, const Clip& clip) {
  return std::make_unique<MeshFilesWriter>(files, clip, plyOf);
}

}  // namespace drape::io::animation
