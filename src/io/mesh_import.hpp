#pragma once

#include "io/import_watch.hpp"
#include "sim/cloth_model.hpp"
#include "sim/error.hpp"
#include "sim/vector.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// A mesh as a file holds it, after triangulation: a vertex is split wherever its texture coordinates differ.
struct RawMesh {
  std::vector<Vec3> positions;      ///< in the file's unit
  std::vector<Vec2> uvs;            ///< one a position, or empty when the file has none
  std::vector<Triangle> triangles;  ///< indices into positions
  int facesSkipped = 0;             ///< points and lines, which a cloth has no use for
  int unusedVertices = 0;           ///< vertices of the file without a face that are not among the positions
};

/// What a mesh is drawn from: vertices split at texture seams, each riding on a particle of the cloth.
struct RenderMesh {
  std::vector<int> particle;        ///< for each render vertex the cloth vertex that carries it
  std::vector<Vec2> uvs;            ///< one a render vertex
  bool uvsInMetres = false;         ///< the file had none: these are lengths [m]
  std::vector<Triangle> triangles;  ///< indices into `particle`; triangle t is the cloth's triangle t
};

/// What was found in a mesh and done to it.
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
  int components = 0;                 ///< pieces that hang together by edges
  int boundaryLoops = 0;              ///< closed chains of edges with one face
  int nonManifoldEdges = 0;           ///< edges with more than two faces
  int misorientedEdges = 0;           ///< edges whose two faces run in the same direction
  std::array<double, 3> size{};       ///< extent of the bounding box [m]
  std::vector<std::string> warnings;
};

/// What the specification of a file format says about coordinates. Empty where it leaves them to the author, as OBJ,
/// PLY and STL do.
struct FormatFacts {
  std::optional<double> metresPerUnit;  ///< length of the file's unit [m]
  std::optional<char> up;               ///< the axis that points up: 'x', 'y' or 'z'
};

/// A mesh ready to become a cloth.
struct ImportedMesh {
  ClothMesh cloth;
  RenderMesh render;
  MeshSummary summary;
  FormatFacts format;
};

/// Vertices that lie far from all others are an error, or left out with their faces.
enum class OutlierRule { Refuse, LeaveOut };

/// What the mesh will be. A body needs no pins, may have any size, and need not be one piece.
enum class MeshUse { Cloth, Body };

/// How to read a mesh.
struct ImportOptions {
  double metresPerUnit = 1.0;
  /// Vertices nearer than this times the diagonal of the bounding box, without outliers, become one particle. It counts
  /// no further than to half of the median edge.
  double weldTolerance = 1e-6;
  double timeLimit = 0.0;  ///< reading may take this long [s]; 0: ten seconds and one for each 2 MiB of the file
  OutlierRule outliers = OutlierRule::Refuse;
  MeshUse use = MeshUse::Cloth;
  ImportWatch watch = {};  ///< hears about progress, and can cancel
};

/// The endings of the formats that are offered, lower case, without the dot.
[[nodiscard]] std::vector<std::string> meshFormats();

/// True when the file's ending, in capitals or not, is that of a format that is offered.
[[nodiscard]] bool isMeshFile(const std::filesystem::path& file);

/// For a file of a known format that is not read: what to export instead, as a sentence. Empty for other files.
[[nodiscard]] std::string adviceForFormat(const std::filesystem::path& file);

/// What a format, given by its ending without the dot in small letters, says about unit and up axis.
[[nodiscard]] FormatFacts factsOfFormat(std::string_view format);

/// Reads a mesh file. The parsing happens in a child process with limits on memory and time, so that a file that
/// crashes or stalls the parser costs a message. Throws InputError (missing, a directory, unknown format, too large,
/// not a mesh, no faces, NaN, cut off, crash, time-out), naming file, place and remedy; and Cancelled.
/// Of other files it reads only the buffers that a glTF file names, from the same folder.
[[nodiscard]] ImportedMesh importMesh(const std::filesystem::path& file, const ImportOptions& options);

/// The same for a file that is already in memory. `name` is for messages and its ending tells the format.
[[nodiscard]] ImportedMesh importMeshFromMemory(std::string_view name, std::string_view bytes,
                                                const ImportOptions& options);

/// A vertex far from all others, which ImportOptions::outliers refuses.
class OutlierError : public InputError {
 public:
  OutlierError(const std::string& message, int rawVertex) : InputError(message), rawVertex_(rawVertex) {}

  [[nodiscard]] int rawVertex() const { return rawVertex_; }  ///< index into RawMesh::positions

 private:
  int rawVertex_;
};

/// Welds, cleans and measures a raw mesh. Throws InputError when most of it cannot be used, when it is smaller than
/// 1 mm, and OutlierError.
[[nodiscard]] ImportedMesh weldMesh(const RawMesh& raw, std::string_view name, const ImportOptions& options);

/// One line a fact, for a terminal or a panel.
[[nodiscard]] std::vector<std::string> describe(const MeshSummary& summary);

}  // namespace drape
