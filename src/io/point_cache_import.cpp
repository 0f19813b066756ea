#include "io/point_cache_import.hpp"

#include "io/import_run.hpp"
#include "messages/error.hpp"
#include "text/words.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace drape::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t numberSize = 4;              // of all numbers in these files [bytes]
constexpr std::size_t pointSize = 3 * numberSize;  // [bytes]
constexpr float largestCoordinate = 1e9F;          // beyond it the file is damaged
constexpr std::string_view exportAgain = " Export the cache again.";

std::string endingOf(const fs::path& file) {
  return text::lowerCase(file.extension().string());
}

/// Takes numbers off bytes that are long enough.
class Numbers {
 public:
  Numbers(std::string_view bytes, std::endian order) : rest_(bytes), order_(order) {}

  template <typename Number>
  Number next() {
    std::array<char, numberSize> raw{};
    std::copy_n(rest_.begin(), numberSize, raw.begin());
    rest_.remove_prefix(numberSize);
    if (order_ != std::endian::native) {
      std::reverse(raw.begin(), raw.end());
    }
    Number value{};
    std::memcpy(&value, raw.data(), numberSize);
    return value;
  }

 private:
  std::string_view rest_;
  std::endian order_;
};

/// What the header of a cache announces.
struct Header {
  std::int32_t vertices = 0;
  std::int32_t frames = 0;
};

/// Throws unless the counts are positive and the file has as many bytes as they need. Only then may memory be taken.
void requireSize(const Header& header, std::size_t fixedSize, std::size_t sizePerFrame, std::size_t bytes) {
  if (header.vertices <= 0 || header.frames <= 0) {
    throw messages::InputError(fmt::format("its header announces {} frames of {} vertices; both must be at least 1.{}",
                                           header.frames, header.vertices, exportAgain));
  }
  const std::uint64_t perFrame = sizePerFrame + pointSize * static_cast<std::uint64_t>(header.vertices);
  const std::uint64_t needed = fixedSize + perFrame * static_cast<std::uint64_t>(header.frames);
  if (needed != bytes) {
    throw messages::InputError(fmt::format(
        "it has {} bytes, but its header announces {} frames of {} vertices, which take {} bytes. It is {}.{}", bytes,
        header.frames, header.vertices, needed, bytes < needed ? "cut off or damaged" : "damaged, or of another format",
        exportAgain));
  }
}

void requireVertices(const Header& header, std::size_t vertices) {
  if (static_cast<std::size_t>(header.vertices) != vertices) {
    throw messages::InputError(
        fmt::format("it moves {} vertices, but the file of the mesh has {}. Export both from the same mesh, without "
                    "modifiers that change the number of vertices.",
                    header.vertices, vertices));
  }
}

void readFrames(const Header& header, Numbers& numbers, PointCache& cache) {
  for (std::int32_t frame = 0; frame < header.frames; ++frame) {
    std::vector<Eigen::Vector3f>& positions = cache.frames.emplace_back();
    positions.reserve(static_cast<std::size_t>(header.vertices));
    for (std::int32_t vertex = 0; vertex < header.vertices; ++vertex) {
      const auto x = numbers.next<float>();
      const auto y = numbers.next<float>();
      const auto z = numbers.next<float>();
      if (!(std::abs(x) < largestCoordinate && std::abs(y) < largestCoordinate && std::abs(z) < largestCoordinate)) {
        throw messages::InputError(
            fmt::format("in frame {} (counted from 0) the position of vertex {} is ({}, {}, {}), "
                        "which is no place.{}",
                        frame, vertex, x, y, z, exportAgain));
      }
      positions.emplace_back(x, y, z);
    }
  }
}

PointCache readPc2(std::string_view bytes, std::size_t vertices, double rate) {
  using namespace std::string_view_literals;
  constexpr std::string_view mark = "POINTCACHE2\0"sv;
  constexpr std::size_t headerSize = 32;
  constexpr std::int32_t version = 1;
  if (!bytes.starts_with(mark)) {
    throw messages::InputError("it does not begin with POINTCACHE2, so it is no PC2 file. Export a PC2 or MDD file.");
  }
  if (bytes.size() < headerSize) {
    throw messages::InputError("it ends within its header." + std::string(exportAgain));
  }
  Numbers numbers(bytes.substr(mark.size()), std::endian::little);
  if (const auto found = numbers.next<std::int32_t>(); found != version) {
    throw messages::InputError(
        fmt::format("it has version {} of the format, and Drape reads version {}.", found, version));
  }
  Header header;
  header.vertices = numbers.next<std::int32_t>();
  (void)numbers.next<float>();  // the number of the first frame; it is at time 0 here
  const auto framesPerSample = static_cast<double>(numbers.next<float>());
  header.frames = numbers.next<std::int32_t>();
  requireSize(header, headerSize, 0, bytes.size());
  requireVertices(header, vertices);
  constexpr double minStep = 1e-6;
  constexpr double maxStep = 1e6;
  if (!(framesPerSample >= minStep && framesPerSample <= maxStep)) {
    throw messages::InputError(
        fmt::format("its header announces a sample each {} frames; this must be from {} to {}.{}", framesPerSample,
                    minStep, maxStep, exportAgain));
  }
  PointCache cache;
  for (std::int32_t frame = 0; frame < header.frames; ++frame) {
    cache.times.push_back(frame * framesPerSample / rate);
  }
  readFrames(header, numbers, cache);
  return cache;
}

PointCache readMdd(std::string_view bytes, std::size_t vertices) {
  constexpr std::size_t headerSize = 2 * numberSize;
  if (bytes.size() < headerSize) {
    throw messages::InputError("it ends within its header." + std::string(exportAgain));
  }
  Numbers numbers(bytes, std::endian::big);
  Header header;
  header.frames = numbers.next<std::int32_t>();
  header.vertices = numbers.next<std::int32_t>();
  requireSize(header, headerSize, numberSize, bytes.size());
  requireVertices(header, vertices);
  PointCache cache;
  double first = 0.0;
  for (std::int32_t frame = 0; frame < header.frames; ++frame) {
    const auto time = static_cast<double>(numbers.next<float>());
    first = frame == 0 ? time : first;
    if (!std::isfinite(time) || (frame > 0 && !(time - first > cache.times.back()))) {
      throw messages::InputError(
          fmt::format("its times must increase, but frame {} (counted from 0) is at {} s{}.{}", frame, time,
                      frame == 0 ? "" : fmt::format(", after {} s", cache.times.back() + first), exportAgain));
    }
    cache.times.push_back(time - first);
  }
  readFrames(header, numbers, cache);
  return cache;
}

}  // namespace

bool isPointCache(const fs::path& file) {
  const std::string ending = endingOf(file);
  return ending == ".pc2" || ending == ".mdd";
}

bool hasOwnTimes(const fs::path& file) {
  return endingOf(file) == ".mdd";
}

PointCache importPointCache(const fs::path& file, std::size_t vertices, double rate) {
  const std::string bytes = readWholeFile(file, [](const std::string& name) {
    if (!isPointCache(name)) {
      throw messages::InputError(name +
                                 ": a vertex cache is a .pc2 or an .mdd file. Export it in one of these formats.");
    }
  });
  try {
    return hasOwnTimes(file) ? readMdd(bytes, vertices) : readPc2(bytes, vertices, rate);
  } catch (const messages::InputError& error) {
    throw messages::InputError(file.string() + ": " + error.what());
  }
}

}  // namespace drape::io
