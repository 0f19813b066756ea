// USD as text: each object is a mesh whose points and normals have a value for each frame.
#include "io/animation/animation.hpp"
#include "io/animation/number_bytes.hpp"
#include "io/animation/part_file.hpp"

#include <cctype>
#include <string_view>
#include <utility>

namespace drape::io::animation {
namespace {

/// The object that contains all meshes.
constexpr std::string_view rootName = "Drape";

/// A name of letters, digits and underscores that starts with no digit, as USD requires.
std::string identifierOf(const std::string& name) {
  std::string word;
  for (const char c : name) {
    const bool allowed = std::isalnum(static_cast<unsigned char>(c)) != 0;
    word += allowed ? c : '_';
  }
  return word.empty() || std::isdigit(static_cast<unsigned char>(word[0])) != 0 ? "_" + word : word;
}

void appendTuple(std::string& text, const Vec3& point) {
  text += '(';
  appendFloat(text, point.x());
  text += ", ";
  appendFloat(text, point.y());
  text += ", ";
  appendFloat(text, point.z());
  text += ')';
}

std::string sampleOf(int frame, const std::vector<Vec3>& rows) {
  std::string text = fmt::format("        {}: [", frame);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += i == 0 ? "" : ", ";
    appendTuple(text, rows[i]);
  }
  return text + "],\n";
}

std::string listOf(const std::vector<int>& numbers) {
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string topologyOf(const FileMesh& mesh) {
  std::vector<int> counts;
  for (std::size_t face = 0; face < mesh.faceEnds.size(); ++face) {
    counts.push_back(mesh.faceEnds[face] - mesh.firstCorner(face));
  }
  std::string text = "    uniform token subdivisionScheme = \"none\"\n    uniform bool doubleSided = 1\n";
  text += "    int[] faceVertexCounts = " + listOf(counts) + "\n";
  text += "    int[] faceVertexIndices = " + listOf(mesh.corners) + "\n";
  if (!mesh.uvs.empty()) {
    text += "    texCoord2f[] primvars:st = [";
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
      const Vec2 uv = mesh.uvCorners[i] < 0 ? Vec2(Vec2::Zero()) : mesh.uvs[mesh.uvCorners[i]];
      text += i == 0 ? "(" : ", (";
      appendFloat(text, uv.x());
      text += ", ";
      appendFloat(text, uv.y());
      text += ')';
    }
    text += "] (\n        interpolation = \"faceVarying\"\n    )\n";
  }
  return text;
}

/// The samples of an object, which are next to each other in the file but come frame by frame.
struct Samples {
  std::unique_ptr<PartFile> points;
  std::unique_ptr<PartFile> normals;
};

class UsdaWriter : public Writer {
 public:
  UsdaWriter(const FileOfFrame& files, Clip clip) : file_(files(clip.firstFrame)), clip_(std::move(clip)) {
    const std::string name = files(clip_.firstFrame).string();
    for (std::size_t i = 0; i < clip_.objects.size(); ++i) {
      samples_.push_back({std::make_unique<PartFile>(fmt::format("{}.points{}", name, i)),
                          std::make_unique<PartFile>(fmt::format("{}.normals{}", name, i))});
    }
  }

  void add(const Frame& frame) override {
    for (std::size_t i = 0; i < frame.size(); ++i) {
      samples_[i].points->write(sampleOf(clip_.firstFrame + written_, frame[i].positions));
      samples_[i].normals->write(sampleOf(clip_.firstFrame + written_, frame[i].normals));
    }
    ++written_;
  }

  void finish() override {
    file_.write(header() + "\ndef Xform \"" + std::string(rootName) + "\"\n{\n");
    for (std::size_t i = 0; i < clip_.objects.size(); ++i) {
      const Object& object = clip_.objects[i];
      file_.write("def Mesh \"" + identifierOf(object.name) + "\"\n{\n" + topologyOf(*object.mesh));
      file_.write("    point3f[] points.timeSamples = {\n");
      file_.append(*samples_[i].points);
      file_.write("    }\n    normal3f[] normals (\n        interpolation = \"vertex\"\n    )\n");
      file_.write("    normal3f[] normals.timeSamples = {\n");
      file_.append(*samples_[i].normals);
      file_.write("    }\n}\n");
    }
    file_.write("}\n");
    file_.commit();
  }

 private:
  [[nodiscard]] std::string header() const {
    const char up = static_cast<char>(std::toupper(static_cast<unsigned char>(clip_.up)));
    return fmt::format(
        "#usda 1.0\n(\n    doc = \"{}\"\n    defaultPrim = \"{}\"\n    metersPerUnit = {}\n    upAxis = \"{}\"\n"
        "    startTimeCode = {}\n    endTimeCode = {}\n    timeCodesPerSecond = {}\n    framesPerSecond = {}\n)\n",
        clip_.comment, rootName, clip_.metresPerUnit, up, clip_.firstFrame, clip_.firstFrame + written_ - 1, clip_.rate,
        clip_.rate);
  }

  PartFile file_;
  Clip clip_;
  std::vector<Samples> samples_;
  int written_ = 0;
};

}  // namespace

std::unique_ptr<Writer> makeUsdaWriter(const FileOfFrame& files, const Clip& clip) {
  return std::make_unique<UsdaWriter>(files, clip);
}

}  // namespace drape::io::animation
