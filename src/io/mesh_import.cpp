#include "io/mesh_import.hpp"

#include "io/import_process.hpp"
#include "io/import_protocol.hpp"
#include "io/obj_diagnosis.hpp"
#include "io/ply_check.hpp"
#include "sim/error.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace drape {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mebibyte = std::size_t{1} << 20;
constexpr std::size_t largestFile = 512 * mebibyte;

/// The time that an import may take when nothing else is asked for: ten seconds and one for each 2 MiB [s].
double defaultTimeLimit(std::size_t bytes) {
  return 10.0 + static_cast<double>(bytes) / static_cast<double>(2 * mebibyte);
}

std::string formatList() {
  std::string list;
  for (const std::string& format : meshFormats()) {
    list += (list.empty() ? "." : ", .") + format;
  }
  return list;
}

/// The file's ending in small letters, with its dot; empty when it has none.
std::string endingOf(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return ending;
}

/// The file's format by its ending. Throws InputError when it is none of those that are offered.
std::string formatOf(std::string_view name) {
  const std::string ending = endingOf(name);
  if (!isMeshFile(name)) {
    throw InputError(std::string(name) + ": " + (ending.empty() ? "no ending" : "'" + ending + "' is not an ending") +
                     " that tells a mesh format. Meshes are read from " + formatList() +
                     ": export the mesh in one of these.");
  }
  return ending.substr(1);
}

std::string readWholeFile(const fs::path& file) {
  const std::string name = file.string();
  std::error_code problem;
  const fs::file_status status = fs::status(file, problem);
  if (!fs::exists(status)) {
    throw InputError(name + ": " + (status.type() == fs::file_type::not_found ? "no such file" : problem.message()) +
                     ". Check the path.");
  }
  if (fs::is_directory(status)) {
    throw InputError(name + ": is a directory. Name a mesh file inside it.");
  }
  if (!fs::is_regular_file(status)) {
    throw InputError(name + ": is not a file that can be read as a whole. Copy it to a regular file.");
  }
  (void)formatOf(name);
  const std::uintmax_t size = fs::file_size(file, problem);
  if (!problem && size > largestFile) {
    throw InputError(name + ": is " + std::to_string(size / mebibyte) + " MiB large, and the limit is " +
                     std::to_string(largestFile / mebibyte) + " MiB. Reduce the mesh first.");
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(problem ? 0 : static_cast<std::size_t>(size), '\0');
  if (!stream || !stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    throw InputError(name + ": cannot be read (" + std::strerror(errno != 0 ? errno : EIO) +
                     "). Check the file's permissions.");
  }
  return bytes;
}

/// Where the import program is: next to this one, or where DRAPE_MESH_IMPORT says.
fs::path importProgram() {
  if (const char* chosen = std::getenv("DRAPE_MESH_IMPORT"); chosen != nullptr && *chosen != '\0') {
    return chosen;
  }
  std::error_code problem;
  const fs::path self = fs::read_symlink("/proc/self/exe", problem);
  fs::path program = self.parent_path() / "drape-mesh-import";
  if (problem || !fs::exists(program, problem)) {
    throw InputError("the program drape-mesh-import, which reads meshes, is not at " + program.string() +
                     ". Install it there or set DRAPE_MESH_IMPORT to its path.");
  }
  return program;
}

std::string secondsText(double seconds) {
  const std::string text = std::to_string(std::round(seconds * 10.0) / 10.0);
  return text.substr(0, text.find('.') + 2) + " s";
}

/// Why the import program has no answer, as the rest of a sentence.
std::string describeFailure(const ProcessOutcome& outcome, double timeLimit) {
  if (outcome.end == ProcessOutcome::End::TimedOut ||
      (outcome.end == ProcessOutcome::End::Killed && outcome.code == SIGXCPU)) {
    return "reading it took longer than " + secondsText(timeLimit) + " and was given up";
  }
  if (outcome.end == ProcessOutcome::End::TooMuch) {
    return "it unfolds to more data than a mesh can have here";
  }
  if (outcome.end == ProcessOutcome::End::Killed) {
    return std::string("the mesh reader crashed on it (") + strsignal(outcome.code) + ")";
  }
  return "the mesh reader failed on it (exit status " + std::to_string(outcome.code) + ")";
}

RawMesh readInChild(const std::string& format, std::string_view bytes, double timeLimit) {
  ProcessLimits limits;
  limits.wallClock = std::chrono::milliseconds(static_cast<long long>(std::ceil(timeLimit * 1000.0)));
  limits.outputBytes = std::min(64 * mebibyte + 64 * bytes.size(), 4096 * mebibyte);
  const auto cpuSeconds = static_cast<long long>(std::ceil(timeLimit)) + 1;
  const ProcessOutcome outcome = runProcess(importProgram(), {format, std::to_string(cpuSeconds)}, bytes, limits);
  if (outcome.end != ProcessOutcome::End::Exited || outcome.code != 0) {
    throw InputError(describeFailure(outcome, timeLimit) +
                     ". The file is probably damaged: export it again, or in another format (" + formatList() + ").");
  }
  ImportReply reply = decodeReply(outcome.output);
  if (!reply.error.empty()) {
    throw InputError(reply.error);
  }
  return std::move(reply.mesh);
}

}  // namespace

std::vector<std::string> meshFormats() {
  return {"obj", "ply", "stl", "glb"};
}

bool isMeshFile(const fs::path& file) {
  const std::string ending = endingOf(file);
  const std::vector<std::string> formats = meshFormats();
  return !ending.empty() && std::find(formats.begin(), formats.end(), ending.substr(1)) != formats.end();
}

FormatFacts factsOfFormat(std::string_view format) {
  // glTF 2.0, section 3.4: "The units for all linear distances are meters", "+Y as up".
  return format == "glb" || format == "gltf" ? FormatFacts{1.0, 'y'} : FormatFacts{};
}

ImportedMesh importMesh(const std::filesystem::path& file, const ImportOptions& options) {
  const std::string bytes = readWholeFile(file);
  return importMeshFromMemory(file.string(), bytes, options);
}

ImportedMesh importMeshFromMemory(std::string_view nameView, std::string_view bytes, const ImportOptions& options) {
  const std::string name(nameView);
  const std::string format = formatOf(name);
  if (bytes.empty()) {
    throw InputError(name + ": the file is empty. Export the mesh again.");
  }
  if (bytes.size() > largestFile) {
    throw InputError(name + ": is larger than " + std::to_string(largestFile / mebibyte) +
                     " MiB. Reduce the mesh first.");
  }
  constexpr double longestTime = 86400.0;
  const double timeLimit =
      options.timeLimit > 0.0 ? std::min(options.timeLimit, longestTime) : defaultTimeLimit(bytes.size());
  RawMesh raw;
  try {
    if (format == "ply") {
      checkPly(bytes);
    }
    raw = readInChild(format, bytes, timeLimit);
  } catch (const InputError& error) {
    const std::string problem = format == "obj" ? diagnoseObj(bytes) : "";
    throw InputError(name + ": " +
                     (problem.empty() ? error.what() : problem + ". Correct it, or export the mesh again."));
  }
  ImportedMesh mesh = weldMesh(raw, name, options);
  mesh.format = factsOfFormat(format);
  return mesh;
}

}  // namespace drape
