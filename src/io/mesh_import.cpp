#include "io/mesh_import.hpp"

#include "io/gltf_check.hpp"
#include "io/import_protocol.hpp"
#include "io/import_run.hpp"
#include "io/mesh_outliers.hpp"
#include "io/obj_check.hpp"
#include "io/off_check.hpp"
#include "io/ply_check.hpp"
#include "io/stl_check.hpp"
#include "io/text_input.hpp"
#include "messages/error.hpp"
#include "text/words.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace drape::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mebibyte = std::size_t{1} << 20;

/// A format that is not supported, and the advice for its files.
struct OtherFormat {
  std::string_view ending;
  std::string_view cure;
};

constexpr std::string_view fromAnyProgram = "Open it in Blender (File > Import) and export the garment as glTF or OBJ";
constexpr std::string_view fromItsProgram = "Open it in the program that made it and export the garment as glTF or OBJ";
constexpr std::string_view fromBlender = "Open it in Blender and export the garment as glTF or OBJ";
constexpr std::string_view fromClo = "Open it in CLO or Marvelous Designer and export the garment as OBJ, unit m";
constexpr std::string_view fromCad = "Open it in a CAD program or in FreeCAD and export a mesh as OBJ or STL";

constexpr std::array<OtherFormat, 29> otherFormats{{
    {".fbx", fromAnyProgram},  {".dae", fromAnyProgram},  {".usd", fromAnyProgram}, {".usda", fromAnyProgram},
    {".usdc", fromAnyProgram}, {".usdz", fromAnyProgram}, {".abc", fromAnyProgram}, {".x3d", fromAnyProgram},
    {".wrl", fromAnyProgram},  {".bvh", fromAnyProgram},  {".dxf", fromAnyProgram}, {".3ds", fromItsProgram},
    {".max", fromItsProgram},  {".ma", fromItsProgram},   {".mb", fromItsProgram},  {".c4d", fromItsProgram},
    {".lwo", fromItsProgram},  {".3mf", fromItsProgram},  {".skp", fromItsProgram}, {".3dm", fromItsProgram},
    {".vrm", fromAnyProgram},  {".blend", fromBlender},   {".zprj", fromClo},       {".zpac", fromClo},
    {".avt", fromClo},         {".step", fromCad},        {".stp", fromCad},        {".iges", fromCad},
    {".igs", fromCad},
}};

std::string formatList() {
  return fmt::format(".{}", fmt::join(meshFormats(), ", ."));
}

/// The file's extension in lower case, with its dot; empty when there is none.
std::string endingOf(const fs::path& file) {
  return text::lowerCase(file.extension().string());
}

/// The file's format by its extension. Throws InputError when it is not supported.
std::string formatOf(std::string_view name) {
  const std::string ending = endingOf(name);
  if (!isMeshFile(name)) {
    const std::string advice = adviceForFormat(name);
    throw messages::InputError(std::string(name) + ": " +
                               (advice.empty()
                                    ? (ending.empty() ? "no extension" : "'" + ending + "' is not an extension") +
                                          " of a mesh format. The formats are " + formatList() +
                                          ": export the mesh in one of these."
                                    : advice));
  }
  return ending.substr(1);
}

/// A valid file in the form for the import program.
struct CheckedFile {
  std::string storage;  ///< the bytes when they differ from those of the file
  std::string_view bytes;
  int facesSkipped = 0;
  int unusedVertices = 0;
  std::vector<std::string> warnings;
  bool hasSkin = false;
  FileMesh mesh = {};  ///< of OBJ and PLY; empty for formats whose vertices the library returns
};

void takeGltf(GltfMesh&& gltf, CheckedFile& checked) {
  checked.storage = std::move(gltf.file);
  checked.bytes = checked.storage;
  checked.hasSkin = gltf.hasSkin;
}

/// Checks a file of any format and fills in `checked`. Throws InputError when the file is damaged.
void checkFile(const std::string& format, std::string_view bytes, const fs::path& folder, const ImportWatch& watch,
               CheckedFile& checked) {
  if (format == "glb") {
    takeGltf(glbWithMesh(bytes), checked);
    return;
  }
  std::string textStorage;
  const std::string_view text = plainText(bytes, textStorage);
  if (format == "obj") {
    ObjText obj = checkObj(text, watch);
    checked = {std::move(obj.text),     {},    obj.facesSkipped,   obj.unusedVertices,
               std::move(obj.warnings), false, std::move(obj.mesh)};
    checked.bytes = checked.storage;
  } else if (format == "off") {
    OffText off = checkOff(text);
    checked = {std::move(off.text), {}, off.facesSkipped, 0, std::move(off.warnings)};
    checked.bytes = checked.storage;
  } else if (format == "gltf") {
    takeGltf(gltfWithBuffers(text, folder), checked);
  } else {
    if (format == "ply") {
      PlyBytes ply = checkPly(text, bytes, checked.storage);
      checked.bytes = ply.bytes;
      checked.mesh = std::move(ply.mesh);
      checked.warnings = std::move(ply.warnings);
    } else {
      StlBytes stl = checkStl(text, bytes, checked.storage);
      checked.bytes = stl.bytes;
      checked.warnings = std::move(stl.warnings);
    }
    if (!textStorage.empty() && checked.bytes.data() != checked.storage.data()) {
      const std::string kept(checked.bytes);
      checked.storage = kept;
      checked.bytes = checked.storage;
    }
  }
}

void requireFewTriangles(std::size_t triangles, const ImportOptions& options) {
  if (options.maxTriangles > 0 && triangles > static_cast<std::size_t>(options.maxTriangles)) {
    throw messages::InputError(
        fmt::format("it has {} triangles, and the limit for this body is {}. Reduce the mesh first, for example with "
                    "the modifier Decimate of Blender.",
                    triangles, options.maxTriangles));
  }
}

/// The triangles of the polygons of a file.
std::size_t trianglesOf(const FileMesh& mesh) {
  return mesh.corners.size() - 2 * mesh.faceEnds.size();
}

/// Welds the mesh. Messages name an outlier by the vertex number of the file.
ImportedMesh weldNamed(const RawMesh& raw, const std::string& name, std::string_view bytes, const std::string& format,
                       const ImportOptions& options) {
  try {
    return weldMesh(raw, name, options);
  } catch (const OutlierError& error) {
    const Vec3& place = raw.positions[error.rawVertex()];
    std::string vertex = fmt::format("the vertex at ({:.6g}, {:.6g}, {:.6g})", place.x(), place.y(), place.z());
    if (format == "obj") {
      std::string storage;
      vertex = nameObjVertex(plainText(bytes, storage), place);
    }
    throw messages::InputError(name + ": " + vertex + " " + error.what());
  }
}

/// A warning if the coordinates are so large that single precision, in which the importer reads them, changes the
/// edges.
std::optional<std::string> roundingWarning(const RawMesh& raw) {
  constexpr double roundoff = 0x1p-24;
  constexpr double visible = 1e-3;  // share of an edge
  constexpr double percent = 100.0;
  double largest = 0.0;
  for (const Vec3& position : raw.positions) {
    largest = std::max(largest, position.cwiseAbs().maxCoeff());
  }
  const double edge = medianEdge(raw.positions, raw.triangles);
  const double rounding = roundoff * largest;
  if (edge <= 0.0 || rounding < visible * edge) {
    return std::nullopt;
  }
  return fmt::format(
      "The coordinates are as large as {:.3g}, and single precision rounds them: edges are off by up to {:.2g} % of "
      "the median edge. Move the mesh to the origin in its program and export it again.",
      largest, percent * 2.0 * rounding / edge);
}

ImportedMesh importBytes(const std::string& name, std::string_view bytes, const fs::path& folder,
                         const ImportOptions& options) {
  const std::string format = formatOf(name);
  if (bytes.empty()) {
    throw messages::InputError(name + ": the file is empty. Export the mesh again.");
  }
  if (bytes.size() > largestFile) {
    throw messages::InputError(name + ": is larger than " + std::to_string(largestFile / mebibyte) +
                               " MiB. Reduce the mesh first.");
  }
  constexpr double longestTime = 86400.0;
  const double timeLimit =
      options.timeLimit > 0.0 ? std::min(options.timeLimit, longestTime) : defaultTimeLimit(bytes.size());
  CheckedFile checked;
  RawMesh raw;
  try {
    checkFile(format, bytes, folder, options.watch.part(0.0, 0.2), checked);
    requireFewTriangles(trianglesOf(checked.mesh), options);  // before the slow part
    raw = replyOf({format}, checked.bytes, timeLimit, "another format (" + formatList() + ")",
                  options.watch.part(0.2, 0.7))
              .mesh;
    requireFewTriangles(raw.triangles.size(), options);
  } catch (const messages::InputError& error) {
    throw messages::InputError(name + ": " + error.what());
  }
  if (options.use == MeshUse::Cloth || options.keepsFile) {
    raw.file = std::move(checked.mesh);
  }
  raw.facesSkipped += checked.facesSkipped;
  raw.unusedVertices += checked.unusedVertices;
  ImportOptions welding = options;
  welding.watch = options.watch.part(0.7, 1.0);
  ImportedMesh mesh = weldNamed(raw, name, bytes, format, welding);
  mesh.format = factsOfFormat(format);
  mesh.summary.hasSkin = checked.hasSkin;
  if (const auto warning = roundingWarning(raw)) {
    mesh.summary.warnings.push_back(*warning);
  }
  mesh.summary.warnings.insert(mesh.summary.warnings.begin(), checked.warnings.begin(), checked.warnings.end());
  return mesh;
}

}  // namespace

std::vector<std::string> meshFormats() {
  return {"obj", "ply", "stl", "off", "glb", "gltf"};
}

bool isMeshFile(const fs::path& file) {
  const std::string ending = endingOf(file);
  const std::vector<std::string> formats = meshFormats();
  return !ending.empty() && std::find(formats.begin(), formats.end(), ending.substr(1)) != formats.end();
}

std::string adviceForFormat(const fs::path& file) {
  const std::string ending = endingOf(file);
  const auto* const found = std::find_if(otherFormats.begin(), otherFormats.end(),
                                         [&ending](const OtherFormat& format) { return format.ending == ending; });
  if (found == otherFormats.end()) {
    return "";
  }
  return "'" + ending + "' files are not supported. " + std::string(found->cure) +
         ". (Supported formats: " + formatList() + ".)";
}

FormatFacts factsOfFormat(std::string_view format) {
  // glTF 2.0, section 3.4: "The units for all linear distances are meters", "+Y as up".
  return format == "glb" || format == "gltf" ? FormatFacts{1.0, 'y'} : FormatFacts{};
}

ImportedMesh importMesh(const std::filesystem::path& file, const ImportOptions& options) {
  options.watch.tell(0.0, "Reading");
  const std::string bytes = readWholeFile(file, [](const std::string& name) { (void)formatOf(name); });
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  return importBytes(file.string(), bytes, folder, options);
}

ImportedMesh importMeshFromMemory(std::string_view name, std::string_view bytes, const ImportOptions& options) {
  return importBytes(std::string(name), bytes, {}, options);
}

}  // namespace drape::io
