#include "io/gltf_check.hpp"

#include "io/message_text.hpp"
#include "io/quoted_text.hpp"
#include "sim/error.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>

namespace drape {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// All buffers of a file together [bytes].
constexpr std::uintmax_t largestBuffers = std::uintmax_t{512} << 20;

constexpr const char* again = " Export or copy it again.";

std::uint32_t wordAt(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

/// The array under this key; empty when there is none.
const Json& arrayOf(const Json& parent, const char* key) {
  static const Json none = Json::array();
  const auto found = parent.find(key);
  return found != parent.end() && found->is_array() ? *found : none;
}

std::uint64_t countOf(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}

void checkContent(const Json& json) {
  for (const Json& extension : arrayOf(json, "extensionsRequired")) {
    const std::string name = extension.is_string() ? extension.get<std::string>() : "";
    if (name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression") {
      throw InputError("its vertices are compressed (" + name + "), which is not read. Export it without compression.");
    }
  }
  if (arrayOf(json, "meshes").empty()) {
    throw InputError("there is no mesh in it. Export the mesh again.");
  }
}

Json parseJson(std::string_view text) {
  try {
    // Writing JSON goes into depth by recursion, so the depth is limited here.
    Json json = Json::parse(text, [](int depth, Json::parse_event_t, const Json&) {
      constexpr int deepest = 200;
      if (depth > deepest) {
        throw InputError("its JSON is nested deeper than any mesh needs. Export the mesh again.");
      }
      return true;
    });
    if (!json.is_object()) {
      throw InputError("its JSON is not an object. Export the mesh again.");
    }
    return json;
  } catch (const Json::exception& error) {
    throw InputError("its JSON cannot be read: " + oneLine(error.what()) + ". The file was cut off or damaged." +
                     again);
  }
}

/// "a%20b.bin" as "a b.bin".
std::string decodePercent(const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto isHex = [&uri](std::size_t at) { return std::isxdigit(static_cast<unsigned char>(uri[at])) != 0; };
    if (uri[i] == '%' && i + 2 < uri.size() && isHex(i + 1) && isHex(i + 2)) {
      name += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      name += uri[i];
    }
  }
  return name;
}

/// The file that a buffer names. Throws when it is not a regular file of this folder.
fs::path fileOf(const std::string& uri, const fs::path& folder) {
  const std::string name = decodePercent(uri);
  const fs::path relative(name);
  const bool plain = !name.empty() && name.find('\0') == std::string::npos && name.find("://") == std::string::npos &&
                     relative.filename() == relative && name != "." && name != "..";
  if (!plain || folder.empty()) {
    throw InputError("its vertices are in " + drape::quoted(name) +
                     ", and only files beside it, in the same folder, are read. Export it as binary glTF (.glb).");
  }
  std::error_code problem;
  const fs::path home = fs::canonical(folder, problem);
  const fs::path file = fs::canonical(home / relative, problem);
  if (problem) {
    throw InputError("its vertices are in " + drape::quoted(name) +
                     ", which is not beside it. Put that file into the same folder, or export binary glTF (.glb).");
  }
  if (file.parent_path() != home || !fs::is_regular_file(file)) {
    throw InputError("its vertices are in " + drape::quoted(name) +
                     ", which is not a regular file of the same folder. Copy it there, or export binary glTF (.glb).");
  }
  return file;
}

/// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? letters[group >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

std::string readBuffer(const fs::path& file, std::uint64_t promised, std::uintmax_t room) {
  const std::uintmax_t size = fs::file_size(file);
  const std::string name = drape::quoted(file.filename().string());
  if (size < promised) {
    throw InputError("its buffer " + name + " holds " + std::to_string(size) + " of " + std::to_string(promised) +
                     " bytes: that file was cut off. Export or copy both files again.");
  }
  if (size > room) {
    throw InputError("its buffers are larger than " + std::to_string(largestBuffers >> 20U) +
                     " MiB together. Reduce the mesh first.");
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) && !bytes.empty()) {
    throw InputError("its buffer " + name + " cannot be read. Check that file's permissions.");
  }
  return bytes;
}

}  // namespace

void checkGlb(std::string_view bytes) {
  constexpr std::size_t headerSize = 20;  // that of the file and that of the first chunk
  constexpr std::uint32_t jsonChunk = 0x4e4f534a;
  if (bytes.substr(0, 4) != std::string_view("glTF").substr(0, bytes.size())) {
    throw InputError(
        "it is not a binary glTF file: it does not begin with 'glTF'. Check what it is, or export it again.");
  }
  if (bytes.size() < headerSize) {
    throw InputError("it ends in its header: it was cut off." + std::string(again));
  }
  if (wordAt(bytes, 4) != 2) {
    return;  // The parsing library reads version 1 too, and refuses others.
  }
  if (wordAt(bytes, 8) > bytes.size()) {
    throw InputError("it holds " + std::to_string(bytes.size()) + " of the " + std::to_string(wordAt(bytes, 8)) +
                     " bytes that it promises: it was cut off." + again);
  }
  const std::size_t length = wordAt(bytes, 12);
  if (wordAt(bytes, 16) != jsonChunk || length > bytes.size() - headerSize) {
    throw InputError("its first part is not the JSON that a binary glTF file begins with: it is damaged." +
                     std::string(again));
  }
  checkContent(parseJson(bytes.substr(headerSize, length)));
}

std::string gltfWithBuffers(std::string_view text, const fs::path& folder) {
  Json json = parseJson(text);
  checkContent(json);
  if (!json.contains("buffers") || !json["buffers"].is_array()) {
    throw InputError("it has no buffers, and so no vertices. Export the mesh again.");
  }
  std::uintmax_t room = largestBuffers;
  for (Json& buffer : json["buffers"]) {
    const std::string uri = buffer.is_object() && buffer.contains("uri") && buffer["uri"].is_string()
                                ? buffer["uri"].get<std::string>()
                                : "";
    if (uri.rfind("data:", 0) == 0) {
      continue;
    }
    const std::string bytes = readBuffer(fileOf(uri, folder), countOf(buffer, "byteLength"), room);
    room -= bytes.size();
    buffer["uri"] = "data:application/octet-stream;base64," + base64(bytes);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace drape
