#include "io/mesh_import.hpp"

#include "io/gltf_check.hpp"
#include "io/import_process.hpp"
#include "io/import_protocol.hpp"
#include "io/obj_check.hpp"
#include "io/off_check.hpp"
#include "io/ply_check.hpp"
#include "io/stl_check.hpp"
#include "io/text_input.hpp"
#include "messages/error.hpp"
#include "text/words.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace drape::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mebibyte = std::size_t{1} << 20;
constexpr std::size_t largestFile = 512 * mebibyte;

/// The default time limit of an import: ten seconds and one second per 2 MiB [s].
double defaultTimeLimit(std::size_t bytes) {
  return 10.0 + static_cast<double>(bytes) / static_cast<double>(2 * mebibyte);
}

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
  std::string list;
  for (const std::string& format : meshFormats()) {
    list += (list.empty() ? "." : ", .") + format;
  }
  return list;
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

std::string readWholeFile(const fs::path& file) {
  const std::string name = file.string();
  std::error_code problem;
  const fs::file_status status = fs::status(file, problem);
  if (!fs::exists(status)) {
    throw messages::InputError(name + ": " +
                               (status.type() == fs::file_type::not_found ? "no such file" : problem.message()) +
                               ". Check the path.");
  }
  if (fs::is_directory(status)) {
    throw messages::InputError(name + ": is a directory. Give a mesh file inside it.");
  }
  if (!fs::is_regular_file(status)) {
    throw messages::InputError(name + ": is not a regular file. Copy it to a regular file.");
  }
  (void)formatOf(name);
  const std::uintmax_t size = fs::file_size(file, problem);
  if (!problem && size > largestFile) {
    throw messages::InputError(name + ": is " + std::to_string(size / mebibyte) + " MiB large, and the limit is " +
                               std::to_string(largestFile / mebibyte) + " MiB. Reduce the mesh first.");
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(problem ? 0 : static_cast<std::size_t>(size), '\0');
  if (!stream || !stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    throw messages::InputError(name + ": cannot be read (" + std::strerror(errno != 0 ? errno : EIO) +
                               "). Check the file's permissions.");
  }
  return bytes;
}

/// The path of the import program: beside this program, or in DRAPE_MESH_IMPORT.
fs::path importProgram() {
  if (const char* chosen = std::getenv("DRAPE_MESH_IMPORT"); chosen != nullptr && *chosen != '\0') {
    return chosen;
  }
  std::error_code problem;
  const fs::path self = fs::read_symlink("/proc/self/exe", problem);
  fs::path program = self.parent_path() / "drape-mesh-import";
  if (problem || !fs::exists(program, problem)) {
    throw messages::InputError("the program drape-mesh-import, which reads meshes, is not at " + program.string() +
                               ". Install it there or set DRAPE_MESH_IMPORT to its path.");
  }
  return program;
}

/// Why the import program failed, as the rest of a sentence.
std::string describeFailure(const ProcessOutcome& outcome, double timeLimit) {
  if (outcome.end == ProcessOutcome::End::TimedOut ||
      (outcome.end == ProcessOutcome::End::Killed && outcome.code == SIGXCPU)) {
    return fmt::format("reading it took longer than {:.1f} s and was stopped", std::round(timeLimit * 10.0) / 10.0);
  }
  if (outcome.end == ProcessOutcome::End::TooMuch) {
    return "it expands to more data than a mesh may have";
  }
  if (outcome.end == ProcessOutcome::End::Killed) {
    return std::string("the mesh reader crashed on it (") + strsignal(outcome.code) + ")";
  }
  return "the mesh reader failed on it (exit status " + std::to_string(outcome.code) + ")";
}

/// Runs the import program. Throws Cancelled when the watch cancels.
RawMesh readInChild(const std::string& format, std::string_view bytes, double timeLimit, const ImportWatch& watch) {
  ProcessLimits limits;
  limits.wallClock = std::chrono::milliseconds(static_cast<long long>(std::ceil(timeLimit * 1000.0)));
  limits.outputBytes = std::min(64 * mebibyte + 64 * bytes.size(), 4096 * mebibyte);
  limits.stop = watch.stop;
  const auto cpuSeconds = static_cast<long long>(std::ceil(timeLimit)) + 1;
  bool replying = false;
  const auto listen = [&](std::string_view piece) {
    for (std::size_t i = 0; i < piece.size() && !replying; ++i) {
      const auto share = progressOf(piece[i]);
      replying = !share;
      if (share && watch.progress) {
        watch.progress(*share, "Reading");
      }
    }
  };
  const ProcessOutcome outcome =
      runProcess(importProgram(), {format, std::to_string(cpuSeconds)}, bytes, limits, listen);
  if (outcome.end == ProcessOutcome::End::Cancelled) {
    throw Cancelled();
  }
  if (outcome.end != ProcessOutcome::End::Exited || outcome.code != 0) {
    throw messages::InputError(describeFailure(outcome, timeLimit) +
                               ". The file is probably damaged: export it again, or in another format (" +
                               formatList() + ").");
  }
  ImportReply reply = decodeReply(withoutProgress(outcome.output));
  if (!reply.error.empty()) {
    throw messages::InputError(reply.error);
  }
  return std::move(reply.mesh);
}

/// A valid file in the form for the import program.
struct CheckedFile {
  std::string storage;  ///< the bytes when they differ from those of the file
  std::string_view bytes;
  int facesSkipped = 0;
  int unusedVertices = 0;
  std::vector<std::string> warnings;
};

/// Checks a file of any format and fills in `checked`. Throws InputError when the file is damaged.
void checkFile(const std::string& format, std::string_view bytes, const fs::path& folder, const ImportWatch& watch,
               CheckedFile& checked) {
  if (format == "glb") {
    checked.storage = glbWithMesh(bytes);
    checked.bytes = checked.storage;
    return;
  }
  std::string textStorage;
  const std::string_view text = plainText(bytes, textStorage);
  if (format == "obj") {
    ObjText obj = checkObj(text, watch);
    checked = {std::move(obj.text), {}, obj.facesSkipped, obj.unusedVertices, std::move(obj.warnings)};
    checked.bytes = checked.storage;
  } else if (format == "off") {
    OffText off = checkOff(text);
    checked = {std::move(off.text), {}, off.facesSkipped, 0, std::move(off.warnings)};
    checked.bytes = checked.storage;
  } else if (format == "gltf") {
    checked.storage = gltfWithBuffers(text, folder);
    checked.bytes = checked.storage;
  } else {
    if (format == "ply") {
      PlyBytes ply = checkPly(text, bytes, checked.storage);
      checked.bytes = ply.bytes;
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
    raw = readInChild(format, checked.bytes, timeLimit, options.watch.part(0.2, 0.7));
  } catch (const messages::InputError& error) {
    throw messages::InputError(name + ": " + error.what());
  }
  raw.facesSkipped += checked.facesSkipped;
  raw.unusedVertices += checked.unusedVertices;
  ImportOptions welding = options;
  welding.watch = options.watch.part(0.7, 1.0);
  ImportedMesh mesh = weldNamed(raw, name, bytes, format, welding);
  mesh.format = factsOfFormat(format);
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
  const std::string bytes = readWholeFile(file);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  return importBytes(file.string(), bytes, folder, options);
}

ImportedMesh importMeshFromMemory(std::string_view name, std::string_view bytes, const ImportOptions& options) {
  return importBytes(std::string(name), bytes, {}, options);
}

}  // namespace drape::io
