// drape-mesh-import FORMAT CPU_SECONDS [clips | CLIP RATE SCALE LOOP BLEND]: reads a mesh file from standard input and
// writes an ImportReply to standard output. With "clips" the mesh is the bind pose of a skeletal animation, with the
// list of its clips. With a clip the program also computes the frames of the animation. It is a separate program
// because the parsing library crashes or hangs on some damaged files.
#include "animation_baker.hpp"
#include "io/chained_index.hpp"
#include "io/import_protocol.hpp"
#include "io/message_text.hpp"
#include "messages/error.hpp"
#include "sim/model/fingerprint.hpp"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <bit>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

using drape::io::ImportReply;
using drape::io::RawMesh;
using drape::messages::InputError;

/// A mesh file must not make the library open other files (materials, textures).
class NoOtherFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  [[nodiscard]] char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

void limit(int resource, rlim_t amount) {
  const rlimit limits{amount, amount};
  setrlimit(static_cast<__rlimit_resource>(resource), &limits);
}

void limitThisProcess(long cpuSeconds) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::max(1L, cpuSeconds)));
#ifndef DRAPE_SANITIZED
  limit(RLIMIT_AS, rlim_t{4} << 30);
#endif
}

std::string readStandardInput() {
  std::string bytes;
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t got = read(STDIN_FILENO, buffer.data(), buffer.size());
    if (got == 0 || (got < 0 && errno != EINTR)) {
      return bytes;
    }
    if (got > 0) {
      bytes.append(buffer.data(), static_cast<std::size_t>(got));
    }
  }
}

void writeStandardOutput(const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(STDOUT_FILENO, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno != EINTR) {
      std::exit(EXIT_FAILURE);
    }
    done += written > 0 ? static_cast<std::size_t>(written) : 0;
  }
}

/// Whether an importer's list of extensions ("glb gltf vrm") contains the format.
bool reads(const Assimp::BaseImporter& importer, const std::string& format) {
  std::istringstream endings(importer.GetInfo()->mFileExtensions);
  return std::find(std::istream_iterator<std::string>(endings), std::istream_iterator<std::string>(), format) !=
         std::istream_iterator<std::string>();
}

/// Keeps only the importers of one format: the extension decides how a file is read.
void keepOnly(Assimp::Importer& importer, const std::string& format) {
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    if (!reads(*importer.GetImporter(i), format)) {
      others.push_back(importer.GetImporter(i));
    }
  }
  for (Assimp::BaseImporter* other : others) {
    importer.UnregisterLoader(other);
    delete other;
  }
}

/// Removes the library's internal file name from a message.
std::string withoutInnerName(std::string reason) {
  constexpr std::string_view inner = "$$$___magic___$$$";
  for (std::size_t found = reason.find(inner); found != std::string::npos; found = reason.find(inner)) {
    reason.replace(found, inner.size(), "mesh");
  }
  return drape::io::oneLine(reason);
}

/// Passes on the progress of the library, one byte per per cent.
class ProgressTeller : public Assimp::ProgressHandler {
 public:
  bool Update(float share) override {
    const char byte = drape::io::progressByte(static_cast<double>(share));
    if (share >= 0.0F && byte != last_) {
      last_ = byte;
      writeStandardOutput(std::string(1, byte));
    }
    return true;
  }

 private:
  char last_ = drape::io::progressByte(0.0);
};

/// Parses and triangulates. `steps` are the steps of the library after reading.
const aiScene& read(Assimp::Importer& importer, const std::string& format, const std::string& bytes, unsigned steps) {
  keepOnly(importer, format);
  importer.SetIOHandler(new NoOtherFiles);
  importer.SetProgressHandler(new ProgressTeller);
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), steps, format.c_str());
  if (scene == nullptr) {
    const std::string reason = importer.GetErrorString();
    if (reason.find("bad_alloc") != std::string::npos) {
      throw std::bad_alloc();
    }
    throw InputError("it cannot be read as ." + format + " (" + withoutInnerName(reason) + "). Export the mesh again.");
  }
  if (scene->mNumMeshes == 0 || scene->mRootNode == nullptr) {
    throw InputError("there is no mesh in it. Export the mesh again.");
  }
  return *scene;
}

/// Parses and triangulates. Drops data that cloth does not need (normals, colours, further texture coordinates).
const aiScene& parse(Assimp::Importer& importer, const std::string& format, const std::string& bytes) {
  int unwanted = aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
                 aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS | aiComponent_TEXTURES | aiComponent_LIGHTS |
                 aiComponent_CAMERAS | aiComponent_MATERIALS;
  // assimp supports eight sets of texture coordinates, but has flags for the first seven only.
  constexpr unsigned flaggedSets = 7;
  for (unsigned set = 1; set < flaggedSets; ++set) {
    unwanted |= static_cast<int>(aiComponent_TEXCOORDSn(set));
  }
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, unwanted);
  return read(importer, format, bytes, aiProcess_RemoveComponent | aiProcess_Triangulate);
}

/// The length of a unit of the file [m]. The readers of glTF and COLLADA return metres; that of FBX only tells the unit
/// [cm].
double unitOf(const aiScene& scene, const std::string& format) {
  if (format != "fbx") {
    return 1.0;
  }
  double exact = 1.0;
  float stated = 1.0F;
  if (scene.mMetaData != nullptr && !scene.mMetaData->Get("UnitScaleFactor", exact) &&
      scene.mMetaData->Get("UnitScaleFactor", stated)) {
    exact = static_cast<double>(stated);
  }
  return 0.01 * exact;
}

/// Appends the meshes of a scene to one raw mesh.
class Collector {
 public:
  explicit Collector(const aiScene& scene) : scene_(scene) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      hasUvs_ = hasUvs_ || scene.mMeshes[i]->HasTextureCoords(0);
    }
  }

  void addNode(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 placement = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene_.mNumMeshes) {
        throw InputError("one of its nodes uses a missing mesh. Export the mesh again.");
      }
      addMesh(*scene_.mMeshes[node.mMeshes[i]], placement);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      addNode(*node.mChildren[i], placement);
    }
  }

  RawMesh take() { return std::move(raw_); }

 private:
  void addMesh(const aiMesh& mesh, const aiMatrix4x4& placement) {
    if (raw_.positions.size() + mesh.mNumVertices > INT_MAX) {
      throw InputError("it has too many vertices. Reduce the mesh first.");
    }
    const std::vector<int> number = addVertices(mesh, placement);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      addFace(mesh.mFaces[i], number, placement.Determinant() < 0.0F);
    }
  }

  static aiVector3D uvOf(const aiMesh& mesh, unsigned vertex) {
    return mesh.HasTextureCoords(0) ? mesh.mTextureCoords[0][vertex] : aiVector3D();
  }

  /// Adding 0 turns -0 into 0, which is equal but has other bits.
  static std::uint64_t hashOf(const aiVector3D& position, const aiVector3D& uv) {
    std::uint64_t hash = 0;
    for (const float value : {position.x, position.y, position.z, uv.x, uv.y}) {
      hash = drape::sim::mixHash(hash, std::bit_cast<std::uint32_t>(value + 0.0F));
    }
    return hash;
  }

  /// Adds the vertices of a mesh. Vertices with equal position and texture coordinates become one. Returns the index in
  /// the raw mesh for each vertex of the mesh. The library has a similar step, but it takes four times as long as the
  /// import.
  std::vector<int> addVertices(const aiMesh& mesh, const aiMatrix4x4& placement) {
    drape::io::ChainedIndex index(mesh.mNumVertices);
    std::vector<int> number(mesh.mNumVertices, -1);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& place = mesh.mVertices[i];
      const aiVector3D uv = uvOf(mesh, i);
      const std::uint64_t hash = hashOf(place, uv);
      int same = index.first(hash);
      while (same != drape::io::ChainedIndex::none && !agree(mesh, static_cast<unsigned>(same), place, uv)) {
        same = index.next(same);
      }
      if (same != drape::io::ChainedIndex::none) {
        number[i] = number[same];
        continue;
      }
      index.insert(hash, static_cast<int>(i));
      number[i] = static_cast<int>(raw_.positions.size());
      addVertex(placement * place, uv);
    }
    return number;
  }

  static bool agree(const aiMesh& mesh, unsigned vertex, const aiVector3D& place, const aiVector3D& uv) {
    const aiVector3D& other = mesh.mVertices[vertex];
    const aiVector3D otherUv = uvOf(mesh, vertex);
    return other.x == place.x && other.y == place.y && other.z == place.z && otherUv.x == uv.x && otherUv.y == uv.y;
  }

  void addVertex(const aiVector3D& position, const aiVector3D& uv) {
    raw_.positions.emplace_back(position.x, position.y, position.z);
    if (!raw_.positions.back().allFinite()) {
      throw InputError(
          "one of its vertices has a coordinate that is not a finite number (nan or inf). "
          "Repair the mesh or export it again.");
    }
    if (hasUvs_) {
      raw_.uvs.emplace_back(uv.x, uv.y);
    }
  }

  /// The library can return faces of one or two vertices, so each face is checked.
  void addFace(const aiFace& face, const std::vector<int>& number, bool mirrored) {
    if (face.mNumIndices != 3) {
      ++raw_.facesSkipped;
      return;
    }
    drape::Triangle triangle{};
    for (unsigned corner = 0; corner < 3; ++corner) {
      if (face.mIndices[corner] >= number.size()) {
        throw InputError("one of its faces uses a missing vertex. Export the mesh again.");
      }
      triangle[corner] = number[face.mIndices[corner]];
    }
    if (mirrored) {
      std::swap(triangle[1], triangle[2]);
    }
    raw_.triangles.push_back(triangle);
  }

  const aiScene& scene_;
  bool hasUvs_ = false;
  RawMesh raw_;
};

/// What to do with the file.
struct Task {
  std::string format;
  bool listsClips = false;                      ///< whether it is the bind pose with the clips that is asked for
  std::optional<drape::app::BakeOptions> bake;  ///< absent: no frames
};

ImportReply perform(const Task& task, const std::string& bytes) {
  Assimp::Importer importer;
  if (!task.bake && !task.listsClips) {
    const aiScene& scene = parse(importer, task.format, bytes);
    Collector collector(scene);
    collector.addNode(*scene.mRootNode, aiMatrix4x4());
    ImportReply reply;
    reply.mesh = collector.take();
    return reply;
  }
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  const aiScene& scene = read(importer, task.format, bytes, aiProcess_Triangulate);
  if (task.listsClips) {
    return drape::app::bindPoseWithClips(scene, unitOf(scene, task.format));
  }
  drape::app::BakeOptions bake = *task.bake;
  bake.metresPerUnit *= unitOf(scene, task.format);
  return drape::app::bakeAnimation(scene, bake);
}

ImportReply import(const Task& task) {
  ImportReply reply;
  try {
    return perform(task, readStandardInput());
  } catch (const InputError& error) {
    reply.error = error.what();
  } catch (const std::bad_alloc&) {
    reply.error = "reading it needs more memory than the limit of 4 GiB. Reduce the mesh, or export it again.";
  }
  return reply;
}

}  // namespace

int main(int argumentCount, char** arguments) {
  const bool listsClips = argumentCount == 4 && std::string_view(arguments[3]) == "clips";
  const bool bakes = argumentCount == 8;
  if ((argumentCount != 3 && !listsClips && !bakes) || isatty(STDIN_FILENO) != 0) {
    constexpr std::string_view usage =
        "usage: drape-mesh-import FORMAT CPU_SECONDS [clips | CLIP RATE SCALE LOOP BLEND] < MESH > REPLY\n"
        "Drape starts this program; do not run it directly.\n";
    return write(STDERR_FILENO, usage.data(), usage.size()) < 0 ? EXIT_FAILURE : 2;
  }
  limitThisProcess(std::strtol(arguments[2], nullptr, 10));
  Task task{arguments[1], listsClips, std::nullopt};
  if (bakes) {
    task.bake = {arguments[3], std::strtod(arguments[4], nullptr), std::strtod(arguments[5], nullptr),
                 std::string_view(arguments[6]) == "1", std::strtod(arguments[7], nullptr)};
  }
  writeStandardOutput(drape::io::encodeReply(import(task)));
  return EXIT_SUCCESS;
}
