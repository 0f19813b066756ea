#include "io/import_protocol.hpp"

#include "messages/error.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace drape::io {
namespace {

constexpr std::uint64_t openingMark = 0x314853454d505244ULL;  // "DRPMESH1"
constexpr std::uint64_t closingMark = 0x31444e4550524425ULL;

struct Header {
  std::uint64_t mark = openingMark;
  std::uint64_t vertices = 0;
  std::uint64_t uvs = 0;
  std::uint64_t triangles = 0;
  std::uint64_t facesSkipped = 0;
  std::uint64_t errorLength = 0;
  std::uint64_t frames = 0;
  double frameTime = 0.0;
  std::uint64_t leadFrames = 0;
  std::uint64_t clips = 0;
};

/// Before the name of a clip.
struct ClipHeader {
  double duration = 0.0;
  std::uint64_t nameLength = 0;
};

static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(Vec2) == 2 * sizeof(double));
static_assert(sizeof(Triangle) == 3 * sizeof(int) && std::is_trivially_copyable_v<Header> &&
              std::is_trivially_copyable_v<ClipHeader>);

[[noreturn]] void throwGarbled(const std::string& what) {
  throw messages::InputError("the answer of drape-mesh-import " + what +
                             ". Both programs must be from the same build: install them again.");
}

void append(std::string& bytes, const void* data, std::size_t size) {
  if (size > 0) {
    bytes.append(static_cast<const char*>(data), size);
  }
}

/// Reads values from a sequence of bytes.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  [[nodiscard]] std::size_t left() const { return rest_.size(); }

  void take(void* into, std::size_t size) {
    if (size > rest_.size()) {
      throwGarbled("ends too early");
    }
    if (size > 0) {
      std::memcpy(into, rest_.data(), size);
    }
    rest_.remove_prefix(size);
  }

  /// An array of `count` values. The count is checked against the available bytes before memory is allocated.
  template <typename T>
  std::vector<T> takeArray(std::uint64_t count) {
    if (count > INT_MAX || count > rest_.size() / sizeof(T)) {
      throwGarbled("contradicts its own counts");
    }
    std::vector<T> values(count);
    if (count > 0) {
      take(values.front().data(), values.size() * sizeof(T));
    }
    return values;
  }

  std::string takeText(std::uint64_t length) {
    if (length > rest_.size()) {
      throwGarbled("contradicts its own counts");
    }
    std::string text(rest_.substr(0, static_cast<std::size_t>(length)));
    rest_.remove_prefix(text.size());
    return text;
  }

 private:
  std::string_view rest_;
};

}  // namespace

std::string encodeReply(const ImportReply& reply) {
  const RawMesh& mesh = reply.mesh;
  Header header;
  header.vertices = mesh.positions.size();
  header.uvs = mesh.uvs.size();
  header.triangles = mesh.triangles.size();
  header.facesSkipped = static_cast<std::uint64_t>(mesh.facesSkipped);
  header.errorLength = reply.error.size();
  header.frames = reply.frames.size();
  header.frameTime = reply.frameTime;
  header.leadFrames = reply.leadFrames;
  header.clips = reply.clips.size();
  std::string bytes;
  bytes.reserve(sizeof(Header) + mesh.positions.size() * sizeof(Vec3) + mesh.uvs.size() * sizeof(Vec2) +
                mesh.triangles.size() * sizeof(Triangle) + reply.error.size() + sizeof(closingMark) +
                reply.frames.size() * mesh.positions.size() * sizeof(Vec3));
  append(bytes, &header, sizeof(header));
  append(bytes, mesh.positions.data(), mesh.positions.size() * sizeof(Vec3));
  append(bytes, mesh.uvs.data(), mesh.uvs.size() * sizeof(Vec2));
  append(bytes, mesh.triangles.data(), mesh.triangles.size() * sizeof(Triangle));
  for (const std::vector<Vec3>& frame : reply.frames) {
    append(bytes, frame.data(), frame.size() * sizeof(Vec3));
  }
  for (const ClipFacts& clip : reply.clips) {
    const ClipHeader facts{clip.duration, clip.name.size()};
    append(bytes, &facts, sizeof(facts));
    append(bytes, clip.name.data(), clip.name.size());
  }
  append(bytes, reply.error.data(), reply.error.size());
  append(bytes, &closingMark, sizeof(closingMark));
  return bytes;
}

char progressByte(double share) {
  return static_cast<char>(0x80U | static_cast<unsigned>(std::lround(100.0 * std::clamp(share, 0.0, 1.0))));
}

std::optional<double> progressOf(char byte) {
  const auto value = static_cast<unsigned char>(byte);
  return value >= 0x80U ? std::optional(std::min(1.0, (value & 0x7fU) / 100.0)) : std::nullopt;
}

std::string_view withoutProgress(std::string_view output) {
  const auto* const start = std::find_if_not(output.begin(), output.end(), progressOf);
  return output.substr(static_cast<std::size_t>(start - output.begin()));
}

ImportReply decodeReply(std::string_view bytes) {
  Reader reader(bytes);
  Header header;
  reader.take(&header, sizeof(header));
  if (header.mark != openingMark || header.facesSkipped > INT_MAX) {
    throwGarbled("has an unknown format");
  }
  ImportReply reply;
  reply.mesh.positions = reader.takeArray<Vec3>(header.vertices);
  reply.mesh.uvs = reader.takeArray<Vec2>(header.uvs);
  reply.mesh.triangles = reader.takeArray<Triangle>(header.triangles);
  reply.mesh.facesSkipped = static_cast<int>(header.facesSkipped);
  if (header.leadFrames > header.frames || (header.frames > 0 && (header.vertices == 0 || !(header.frameTime > 0.0)))) {
    throwGarbled("contradicts its own counts");
  }
  for (std::uint64_t frame = 0; frame < header.frames; ++frame) {
    reply.frames.push_back(reader.takeArray<Vec3>(header.vertices));
  }
  reply.frameTime = header.frameTime;
  reply.leadFrames = static_cast<std::size_t>(header.leadFrames);
  for (std::uint64_t clip = 0; clip < header.clips; ++clip) {
    ClipHeader facts;
    reader.take(&facts, sizeof(facts));
    reply.clips.push_back({reader.takeText(facts.nameLength), facts.duration});
  }
  reply.error = reader.takeText(header.errorLength);
  std::uint64_t mark = 0;
  reader.take(&mark, sizeof(mark));
  if (mark != closingMark || reader.left() != 0) {
    throwGarbled("has a wrong length");
  }
  return reply;
}

}  // namespace drape::io
