#pragma once

#include "io/file_mesh.hpp"
#include "io/import_watch.hpp"
#include "messages/error.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/vector.hpp"
#include "text/sentence.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drape::io {

/// A mesh of a file after triangulation. Vertices are split where their texture coordinates differ.
struct RawMesh {
  std::vector<Vec3> positions;      ///< in the file's unit
  std::vector<Vec2> uvs;            ///< one per position, or empty when the file has none
  std::vector<Triangle> triangles;  ///< indices into positions
  int facesSkipped = 0;             ///< points and lines
  int unusedVertices = 0;           ///< vertices without a face, which are not among the positions
  FileMesh file;                    ///< the mesh of the file itself; empty: it is this mesh
};

/// The mesh for drawing: vertices split at texture seams, each tied to a particle of the cloth.
struct RenderMesh {
  std::vector<int> particle;        ///< the cloth vertex of each render vertex
  std::vector<Vec2> uvs;            ///< one per render vertex
  bool uvsInMetres = false;         ///< the file had none; these are lengths [m]
  std::vector<Triangle> triangles;  ///< indices into `particle`; triangle t is the cloth's triangle t
};

/// The contents of a mesh and its repairs.
struct MeshSummary {
  std::string source;      ///< file name or "grid"
  int verticesInFile = 0;  ///< after the import, split at seams
  int vertices = 0;        ///< particles after the weld
  int triangles = 0;
  int springs = 0;                    ///< edges
  int degenerateFaces = 0;            ///< dropped: no area
  int duplicateFaces = 0;             ///< dropped: the same three vertices as an earlier face
  int facesSkipped = 0;               ///< dropped: points and lines
  int isolatedVertices = 0;           ///< dropped: used by no face
  int outliers = 0;                   ///< dropped: vertices that lie far from all others
  int shortEdges = 0;                 ///< merged to one vertex: edges far shorter than the median edge
  int shortEdgesKept = 0;             ///< such edges that could not be merged
  std::array<double, 3> shortEdge{};  ///< where the shortest of them is, in the file's own coordinates
  int components = 0;                 ///< pieces that are connected by edges
  int boundaryLoops = 0;              ///< closed chains of edges with one face
  int nonManifoldEdges = 0;           ///< edges with more than two faces
  int misorientedEdges = 0;           ///< edges whose two faces run in the same direction
  std::array<double, 3> size{};       ///< extent of the bounding box [m]
  bool hasSkin = false;               ///< whether bones move the mesh in its file, as those of a figure
  std::vector<std::string> warnings;
};

/// The unit and axes that the specification of a file format prescribes. Empty when it prescribes none, as for OBJ, PLY
/// and STL.
struct FormatFacts {
  std::optional<double> metresPerUnit;  ///< length of the file's unit [m]
  std::optional<char> up;               ///< the axis that points up: 'x', 'y' or 'z'
};

/// A mesh ready to become a cloth.
struct ImportedMesh {
  sim::ClothMesh cloth;
  RenderMesh render;
  MeshSummary summary;
  FormatFacts format;
  std::shared_ptr<const FileMesh> file;  ///< null for a body, unless ImportOptions::keepsFile
};

/// Whether vertices far from all others are an error or are left out with their faces.
enum class OutlierRule { Refuse, LeaveOut };

/// The use of the mesh. A body needs no pins, may have any size, and may have several pieces.
enum class MeshUse { Cloth, Body };

/// The most triangles of a body that moves its vertices or is dressed.
inline constexpr int maxMovingTriangles = 300'000;

/// How to read a mesh.
struct ImportOptions {
  double metresPerUnit = 1.0;
  /// Vertices closer than this times the diagonal of the bounding box, without outliers, become one particle. The
  /// distance is limited to half of the median edge.
  double weldTolerance = 1e-6;
  double timeLimit = 0.0;  ///< time limit [s]; 0: ten seconds and one second per 2 MiB of the file
  OutlierRule outliers = OutlierRule::Refuse;
  MeshUse use = MeshUse::Cloth;
  bool keepsFile = false;  ///< whether the result has the mesh of the file for a body too
  int maxTriangles = 0;    ///< a file with more is refused before it is welded; 0: no limit
  ImportWatch watch = {};  ///< receives progress, and can cancel
};

/// The extensions of the supported formats, lower case, without the dot.
[[nodiscard]] std::vector<std::string> meshFormats();

/// Whether the file's extension, in any case, is that of a supported format.
[[nodiscard]] bool isMeshFile(const std::filesystem::path& file);

/// For a known but unsupported format: a sentence with the formats to export instead. Empty for other files.
[[nodiscard]] std::string adviceForFormat(const std::filesystem::path& file);

/// The unit and up axis of a format, by its extension in lower case without the dot.
[[nodiscard]] FormatFacts factsOfFormat(std::string_view format);

/// Reads a mesh file. A child process with limits of memory and time parses it, so that a file that crashes or hangs
/// the parser only causes a message. Throws InputError (missing, a directory, unknown format, too large, not a mesh, no
/// faces, NaN, cut off, crash, time-out) with file, place and remedy; and Cancelled. It reads no other files, except
/// the buffers of a glTF file from the same folder.
[[nodiscard]] ImportedMesh importMesh(const std::filesystem::path& file, const ImportOptions& options);

/// The same for a file in memory. `name` is for messages; its extension gives the format.
[[nodiscard]] ImportedMesh importMeshFromMemory(std::string_view name, std::string_view bytes,
                                                const ImportOptions& options);

/// A vertex far from all others, when ImportOptions::outliers refuses it.
class OutlierError : public messages::InputError {
 public:
  OutlierError(const std::string& message, int rawVertex) : messages::InputError(message), rawVertex_(rawVertex) {}

  [[nodiscard]] int rawVertex() const { return rawVertex_; }  ///< index into RawMesh::positions

 private:
  int rawVertex_;
};

/// Welds, cleans and measures a raw mesh. Throws InputError when most of it is unusable or it is smaller than 1 mm, and
/// OutlierError.
[[nodiscard]] ImportedMesh weldMesh(const RawMesh& raw, std::string_view name, const ImportOptions& options);

/// A fact about a mesh.
struct MeshFact {
  std::string_view title;  ///< "vertices"
  text::Sentence value;
};

/// The facts, without the warnings; and one line per fact, for a terminal.
[[nodiscard]] std::vector<MeshFact> factsOf(const MeshSummary& summary);
[[nodiscard]] std::vector<std::string> describe(const MeshSummary& summary);

}  // namespace drape::io
