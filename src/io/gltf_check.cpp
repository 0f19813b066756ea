#include "io/gltf_check.hpp"

#include "io/gltf_content.hpp"
#include "io/gltf_keys.hpp"
#include "io/gltf_skins.hpp"
#include "io/quoted_text.hpp"
#include "io/text_input.hpp"
#include "messages/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

namespace drape::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// All buffers of a file together [bytes].
constexpr std::uintmax_t largestBuffers = std::uintmax_t{512} << 20;

/// The kinds of the two parts of a binary file.
constexpr std::uint32_t jsonChunk = 0x4e4f534a;
constexpr std::uint32_t binaryMark = 0x4e4942;

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
      throw messages::InputError("its vertices are compressed (" + name +
                                 "), which is not read. Export it without compression.");
    }
  }
  if (arrayOf(json, "meshes").empty()) {
    throw messages::InputError("there is no mesh in it. Export the mesh again.");
  }
}

/// Where the parser stopped, as the rest of a sentence.
std::string placeOf(std::string_view text, const Json::exception& error) {
  const auto* const stopped = dynamic_cast<const Json::parse_error*>(&error);
  if (stopped == nullptr) {
    return "";
  }
  const std::size_t offset = std::min(stopped->byte, text.size());
  const std::size_t lineStart = text.substr(0, offset).find_last_of('\n') + 1;
  return " after line " + std::to_string(lineAt(text, offset)) + ", column " + std::to_string(offset - lineStart);
}

Json parseJson(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos || (text[start] != '{' && text[start] != '[')) {
    throw messages::InputError(
        "it is not a glTF file: it does not begin with '{'. Check what it is, or export it again.");
  }
  try {
    // Writing JSON goes into depth by recursion, so the depth is limited here.
    Json json = Json::parse(text, [](int depth, Json::parse_event_t, const Json&) {
      constexpr int deepest = 200;
      if (depth > deepest) {
        throw messages::InputError("its JSON is nested deeper than any mesh needs. Export the mesh again.");
      }
      return true;
    });
    if (!json.is_object()) {
      throw messages::InputError("its JSON is not an object. Export the mesh again.");
    }
    return json;
  } catch (const Json::exception& error) {
    throw messages::InputError("its JSON cannot be read" + placeOf(text, error) + ": it was cut off or damaged." +
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
    throw messages::InputError(
        "its vertices are in " + drape::io::quoted(name) +
        ", and only files beside it, in the same folder, are read. Export it as binary glTF (.glb).");
  }
  std::error_code problem;
  const fs::path home = fs::canonical(folder, problem);
  fs::path file = fs::canonical(home / relative, problem);
  if (problem) {
    throw messages::InputError(
        "its vertices are in " + drape::io::quoted(name) +
        ", which is not beside it. Put that file into the same folder, or export binary glTF (.glb).");
  }
  if (file.parent_path() != home || !fs::is_regular_file(file)) {
    throw messages::InputError(
        "its vertices are in " + drape::io::quoted(name) +
        ", which is not a regular file of the same folder. Copy it there, or export binary glTF (.glb).");
  }
  return file;
}

/// RFC 4648, section 4.
constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string base64(std::string_view bytes) {
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

[[noreturn]] void failBase64(const std::string& what) {
  throw messages::InputError("the data of its buffer " + what + ": the file is cut off or damaged." + again);
}

std::string fromBase64(std::string_view text) {
  std::array<int, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < letters.size(); ++i) {
    values[static_cast<unsigned char>(letters[i])] = static_cast<int>(i);
  }
  if (text.size() % 4 != 0) {
    failBase64("is base64 of " + std::to_string(text.size()) + " letters, which is not a multiple of 4");
  }
  text.remove_suffix(text.size() >= 2 && text.substr(text.size() - 2) == "==" ? 2 : text.ends_with('=') ? 1 : 0);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t group = 0;
  unsigned bits = 0;
  for (const char letter : text) {
    const int value = values[static_cast<unsigned char>(letter)];
    if (value < 0) {
      failBase64("holds " + drape::io::quoted(std::string_view(&letter, 1)) + ", which is no letter of base64");
    }
    group = (group << 6U | static_cast<std::uint32_t>(value)) & 0xffffffU;
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes += static_cast<char>(group >> bits & 0xffU);
    }
  }
  return bytes;
}

/// The bytes of a "data:" URI.
std::string dataOf(std::string_view uri) {
  constexpr std::string_view mark = ";base64,";
  const std::size_t found = uri.substr(0, 200).find(mark);
  if (found == std::string_view::npos) {
    failBase64("is not written as base64");
  }
  return fromBase64(uri.substr(found + mark.size()));
}

std::string readBuffer(const fs::path& file, std::uint64_t promised, std::uintmax_t room) {
  const std::uintmax_t size = fs::file_size(file);
  const std::string name = drape::io::quoted(file.filename().string());
  if (size < promised) {
    throw messages::InputError("its buffer " + name + " holds " + std::to_string(size) + " of " +
                               std::to_string(promised) +
                               " bytes: that file was cut off. Export or copy both files again.");
  }
  if (size > room) {
    throw messages::InputError("its buffers are larger than " + std::to_string(largestBuffers >> 20U) +
                               " MiB together. Reduce the mesh first.");
  }
  // The file may hold more than the buffer.
  std::string bytes(static_cast<std::size_t>(promised > 0 ? promised : size), '\0');
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) && !bytes.empty()) {
    throw messages::InputError("its buffer " + name + " cannot be read. Check that file's permissions.");
  }
  return bytes;
}

/// The data of a binary file's second part; empty when there is none.
std::string_view binaryChunk(std::string_view rest) {
  constexpr std::size_t headerSize = 8;
  if (rest.size() < headerSize) {
    return {};
  }
  const std::size_t length = wordAt(rest, 0);
  if (wordAt(rest, 4) != binaryMark) {
    throw messages::InputError("its second part is not the binary data that should follow the JSON: it is damaged." +
                               std::string(again));
  }
  if (length > rest.size() - headerSize) {
    throw messages::InputError("its binary data has " + std::to_string(rest.size() - headerSize) + " of the " +
                               std::to_string(length) + " bytes that it promises: it was cut off or damaged." + again);
  }
  return rest.substr(headerSize, length);
}

/// The contents of one buffer. `binary` is the data inside a binary file.
std::string bufferOf(const Json& buffer, const fs::path& folder, std::optional<std::string_view> binary,
                     std::uintmax_t room) {
  const bool hasUri = buffer.is_object() && buffer.contains("uri") && buffer["uri"].is_string();
  if (!hasUri && binary) {
    return std::string(*binary);
  }
  const std::string uri = hasUri ? buffer["uri"].get<std::string>() : "";
  const std::uint64_t promised = countOf(buffer, "byteLength");
  if (uri.rfind("data:", 0) != 0) {
    return readBuffer(fileOf(uri, folder), promised, room);
  }
  std::string bytes = dataOf(uri);
  if (bytes.size() < promised) {
    failBase64("holds " + std::to_string(bytes.size()) + " of " + std::to_string(promised) + " bytes");
  }
  return bytes;
}

std::vector<std::string> buffersOf(const Json& json, const fs::path& folder, std::optional<std::string_view> binary) {
  if (arrayOf(json, "buffers").empty()) {
    throw messages::InputError("it has no buffers, and so no vertices. Export the mesh again.");
  }
  std::uintmax_t room = largestBuffers;
  std::vector<std::string> buffers;
  for (const Json& buffer : arrayOf(json, "buffers")) {
    buffers.push_back(bufferOf(buffer, folder, buffers.empty() ? binary : std::nullopt, room));
    room -= std::min<std::uintmax_t>(room, buffers.back().size());
  }
  return buffers;
}

void appendWord(std::string& bytes, std::size_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(value >> shift & 0xffU);
  }
}

void appendChunk(std::string& bytes, std::uint32_t mark, std::string_view data, char filler) {
  const std::size_t padding = (4 - data.size() % 4) % 4;
  appendWord(bytes, data.size() + padding);
  appendWord(bytes, mark);
  bytes.append(data).append(padding, filler);
}

/// The buffers of a document as text.
Json bufferTexts(const std::vector<std::string>& buffers) {
  Json texts = Json::array();
  for (const std::string& buffer : buffers) {
    texts.push_back(
        Json{{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}});
  }
  return texts;
}

/// A binary file whose first buffer is inside, and all others as text.
std::string joinGlb(Json parts, std::vector<std::string>& buffers) {
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    Json buffer{{"byteLength", buffers[i].size()}};
    if (i > 0) {
      buffer["uri"] = "data:application/octet-stream;base64," + base64(buffers[i]);
    }
    parts["buffers"].push_back(std::move(buffer));
  }
  const std::string text = parts.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string chunks;
  chunks.reserve(text.size() + buffers.front().size() + 32);
  appendChunk(chunks, jsonChunk, text, ' ');
  appendChunk(chunks, binaryMark, buffers.front(), '\0');
  std::string bytes = "glTF";
  appendWord(bytes, 2);
  appendWord(bytes, chunks.size() + 12);
  return bytes += chunks;
}

/// Skins that are no list do no harm to the mesh.
bool hasSkin(const Json& document) {
  const auto skins = document.find("skins");
  return skins != document.end() && skins->is_array() && !skins->empty();
}

constexpr std::size_t glbHeader = 20;  // that of the file and that of the first chunk [bytes]

/// Whether it is binary glTF of version 1, whose first chunk has another kind.
bool isGlbOfVersion1(std::string_view bytes) {
  return bytes.size() >= glbHeader && bytes.starts_with("glTF") && wordAt(bytes, 4) == 1 && wordAt(bytes, 16) == 0;
}

/// The two parts of a binary file.
struct GlbParts {
  Json json;
  std::string_view binary;
};

GlbParts partsOfGlb(std::string_view bytes) {
  if (bytes.substr(0, 4) != std::string_view("glTF").substr(0, bytes.size())) {
    throw messages::InputError(
        "it is not a binary glTF file: it does not begin with 'glTF'. Check what it is, or export it again.");
  }
  if (bytes.size() < glbHeader) {
    throw messages::InputError("it ends in its header: it was cut off." + std::string(again));
  }
  const std::uint32_t version = wordAt(bytes, 4);
  if (version != 2) {
    throw messages::InputError("it is binary glTF of version " + std::to_string(version) +
                               ", and version 2 is read. Export it as glTF 2.0.");
  }
  if (wordAt(bytes, 8) > bytes.size()) {
    throw messages::InputError("it holds " + std::to_string(bytes.size()) + " of the " +
                               std::to_string(wordAt(bytes, 8)) + " bytes that it promises: it was cut off." + again);
  }
  const std::size_t length = wordAt(bytes, 12);
  if (wordAt(bytes, 16) != jsonChunk || length > bytes.size() - glbHeader) {
    throw messages::InputError("its first part is not the JSON that a binary glTF file begins with: it is damaged." +
                               std::string(again));
  }
  return {parseJson(bytes.substr(glbHeader, length)), binaryChunk(bytes.substr(glbHeader + length))};
}

}  // namespace

GltfMesh glbWithMesh(std::string_view bytes) {
  if (isGlbOfVersion1(bytes)) {
    return {std::string(bytes)};  // The parsing library reads this version too.
  }
  const GlbParts glb = partsOfGlb(bytes);
  checkContent(glb.json);
  std::vector<std::string> buffers = buffersOf(glb.json, {}, glb.binary);
  Json parts = meshPartsOf(glb.json, buffers);
  return {joinGlb(std::move(parts), buffers), hasSkin(glb.json)};
}

std::string glbWithEverything(std::string bytes) {
  if (isGlbOfVersion1(bytes)) {
    return bytes;
  }
  GlbParts glb = partsOfGlb(bytes);
  checkContent(glb.json);
  std::vector<std::string> buffers = buffersOf(glb.json, {}, glb.binary);
  checkSkins(glb.json, buffers);
  if (!straightenKeys(glb.json, buffers)) {
    return bytes;
  }
  glb.json["buffers"] = Json::array();
  return joinGlb(std::move(glb.json), buffers);
}

GltfMesh gltfWithBuffers(std::string_view text, const fs::path& folder) {
  const Json json = parseJson(text);
  checkContent(json);
  const std::vector<std::string> buffers = buffersOf(json, folder, std::nullopt);
  Json parts = meshPartsOf(json, buffers);
  parts["buffers"] = bufferTexts(buffers);
  return {parts.dump(-1, ' ', false, Json::error_handler_t::replace), hasSkin(json)};
}

std::string gltfWithEverything(std::string_view text, const fs::path& folder) {
  Json json = parseJson(text);
  checkContent(json);
  std::vector<std::string> buffers = buffersOf(json, folder, std::nullopt);
  checkSkins(json, buffers);
  (void)straightenKeys(json, buffers);
  json["buffers"] = bufferTexts(buffers);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace drape::io
