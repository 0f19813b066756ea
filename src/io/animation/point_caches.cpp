// PC2 and MDD: the positions of one mesh in all frames.
#include "io/animation/animation.hpp"
#include "io/animation/number_bytes.hpp"
#include "io/animation/part_file.hpp"
#include "messages/error.hpp"

#include <climits>
#include <cstdint>

namespace drape::io::animation {
namespace {

std::int32_t pointsOf(const Clip& clip) {
  return static_cast<std::int32_t>(clip.objects.front().mesh->positions.size());
}

/// PC2 of Autodesk 3ds Max, little-endian: a header with the number of samples, and the samples.
class Pc2Writer : public Writer {
 public:
  Pc2Writer(const FileOfFrame& files, const Clip& clip)
      : file_(files(clip.firstFrame)), points_(pointsOf(clip)), first_(clip.firstFrame) {
    file_.write(header(0));
  }

  void add(const Frame& frame) override {
    std::string bytes;
    for (const Vec3& position : frame.front().positions) {
      appendBytes(bytes, position);
    }
    file_.write(bytes);
    ++written_;
  }

  void finish() override {
    file_.writeAt(0, header(written_));
    file_.commit();
  }

 private:
  [[nodiscard]] std::string header(std::int32_t samples) const {
    std::string bytes("POINTCACHE2\0", 12);
    appendBytes(bytes, std::int32_t{1});  // the version of the format
    appendBytes(bytes, points_);
    appendBytes(bytes, static_cast<float>(first_));
    appendBytes(bytes, 1.0F);  // frames per sample
    appendBytes(bytes, samples);
    return bytes;
  }

  PartFile file_;
  std::int32_t points_;
  std::int32_t first_;
  std::int32_t written_ = 0;
};

/// MDD of LightWave, big-endian: the number of frames, the number of points, all times, and the positions.
class MddWriter : public Writer {
 public:
  MddWriter(const FileOfFrame& files, const Clip& clip)
      : file_(files(clip.firstFrame)),
        points_(pointsOf(clip)),
        first_(clip.firstFrame),
        planned_(clip.frames),
        rate_(clip.rate) {
    file_.write(header(planned_));
  }

  void add(const Frame& frame) override {
    std::string bytes;
    for (const Vec3& position : frame.front().positions) {
      appendBytes(bytes, position, std::endian::big);
    }
    file_.write(bytes);
    ++written_;
  }

  void finish() override {
    const std::string start = header(written_);
    if (written_ < planned_) {  // the list of times before the positions is shorter
      file_.moveEnd(header(planned_).size(), start.size());
    }
    file_.writeAt(0, start);
    file_.commit();
  }

 private:
  [[nodiscard]] std::string header(std::int32_t frames) const {
    std::string bytes;
    appendBytes(bytes, frames, std::endian::big);
    appendBytes(bytes, points_, std::endian::big);
    for (std::int32_t i = 0; i < frames; ++i) {
      appendBytes(bytes, static_cast<float>((first_ + i) / rate_), std::endian::big);
    }
    return bytes;
  }

  PartFile file_;
  std::int32_t points_;
  std::int32_t first_;
  std::int32_t planned_;
  std::int32_t written_ = 0;
  double rate_;
};

/// A line for each vertex of each frame.
class CsvWriter : public Writer {
 public:
  CsvWriter(const FileOfFrame& files, const Clip& clip)
      : file_(files(clip.firstFrame)), clip_(clip), number_(clip.firstFrame) {
    file_.write("frame,time,cloth,vertex,x,y,z\n");
  }

  void add(const Frame& frame) override {
    std::string text;
    for (std::size_t i = 0; i < frame.size(); ++i) {
      for (std::size_t v = 0; v < frame[i].positions.size(); ++v) {
        const Vec3& at = frame[i].positions[v];
        fmt::format_to(std::back_inserter(text), "{},{:.9g},{},{},{:.9g},{:.9g},{:.9g}\n", number_,
                       number_ / clip_.rate, clip_.objects[i].name, v, at.x(), at.y(), at.z());
      }
    }
    file_.write(text);
    ++number_;
  }

  void finish() override { file_.commit(); }

 private:
  PartFile file_;
  Clip clip_;
  int number_;
};

}  // namespace

std::unique_ptr<Writer> makePc2Writer(const FileOfFrame& files, const Clip& clip) {
  return std::make_unique<Pc2Writer>(files, clip);
}

std::unique_ptr<Writer> makeMddWriter(const FileOfFrame& files, const Clip& clip) {
  return std::make_unique<MddWriter>(files, clip);
}

std::unique_ptr<Writer> makeCsvWriter(const FileOfFrame& files, const Clip& clip) {
  return std::make_unique<CsvWriter>(files, clip);
}

}  // namespace drape::io::animation
