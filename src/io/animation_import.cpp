#include "io/animation_import.hpp"

#include "io/gltf_check.hpp"
#include "io/import_run.hpp"
#include "io/text_input.hpp"
#include "messages/error.hpp"
#include "text/words.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace drape::io {
namespace {

namespace fs = std::filesystem;

std::string animationFormatList() {
  return fmt::format(".{}", fmt::join(animationFormats(), ", ."));
}

/// The extension in lower case, without the dot.
std::string formatOf(const fs::path& file) {
  const std::string ending = text::lowerCase(file.extension().string());
  return ending.empty() ? "" : ending.substr(1);
}

std::string animationFormatOf(const std::string& name) {
  if (!isAnimationFile(name)) {
    throw messages::InputError(name + ": an animation is read from " + animationFormatList() +
                               ". Export it in one of these formats.");
  }
  return formatOf(name);
}

/// Gives vertices that stay together in all frames one number. Splits at texture seams and between normals vanish.
/// @return the number of each vertex, and how many there are
std::pair<std::vector<int>, int> joinedVertices(const std::vector<std::vector<Vec3>>& frames) {
  const auto key = [](const Vec3& p) { return std::array<double, 3>{p.x(), p.y(), p.z()}; };
  std::multimap<std::array<double, 3>, int> byPlace;  // of the first frame
  std::vector<int> numbers(frames.front().size(), -1);
  int count = 0;
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    const auto [first, last] = byPlace.equal_range(key(frames.front()[v]));
    const auto same = std::find_if(first, last, [&](const auto& other) {
      return std::all_of(frames.begin(), frames.end(), [&](const auto& frame) {
        return (frame[v] - frame[other.second]).squaredNorm() < 1e-12;  // a micrometre
      });
    });
    if (same != last) {
      numbers[v] = numbers[same->second];
    } else {
      numbers[v] = count++;
      byPlace.emplace(key(frames.front()[v]), static_cast<int>(v));
    }
  }
  return {std::move(numbers), count};
}

AnimatedMesh joined(const ImportReply& reply) {
  const auto [numbers, count] = joinedVertices(reply.frames);
  AnimatedMesh mesh;
  mesh.frameTime = reply.frameTime;
  mesh.leadFrames = reply.leadFrames;
  mesh.clips = reply.clips;
  for (const auto& [a, b, c] : reply.mesh.triangles) {
    const Triangle triangle{numbers[a], numbers[b], numbers[c]};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
      mesh.triangles.push_back(triangle);
    }
  }
  for (const std::vector<Vec3>& frame : reply.frames) {
    std::vector<Vec3>& positions = mesh.frames.emplace_back(count);
    for (std::size_t v = 0; v < frame.size(); ++v) {
      positions[numbers[v]] = frame[v];
    }
  }
  return mesh;
}

void checkReply(const ImportReply& reply) {
  for (const Triangle& triangle : reply.mesh.triangles) {
    for (const int corner : triangle) {
      if (corner < 0 || corner >= static_cast<int>(reply.mesh.positions.size())) {
        throw messages::InputError("one of its faces uses a missing vertex. Export the mesh again.");
      }
    }
  }
  if (reply.mesh.triangles.empty() || reply.frames.size() == 1) {
    throw messages::InputError("there is no mesh in it that moves. Export the mesh again.");
  }
}

/// Reads the file and runs the import program. @param task its arguments after the limits
ImportReply replyAbout(const fs::path& file, std::vector<std::string> task, const ImportWatch& watch) {
  watch.tell(0.0, "Reading");
  std::string bytes = readWholeFile(file, [](const std::string& each) { (void)animationFormatOf(each); });
  const std::string format = animationFormatOf(file.string());
  try {
    if (format == "gltf") {
      std::string storage;
      const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
      bytes = gltfWithEverything(plainText(bytes, storage), folder);
    }
    if (format == "glb") {
      bytes = glbWithEverything(std::move(bytes));
    }
    task.insert(task.begin(), format);
    ImportReply reply = replyOf(std::move(task), bytes, defaultTimeLimit(bytes.size()),
                                "another format (" + animationFormatList() + ")", watch);
    checkReply(reply);
    return reply;
  } catch (const messages::InputError& error) {
    throw messages::InputError(file.string() + ": " + error.what());
  }
}

}  // namespace

std::vector<std::string> animationFormats() {
  return {"glb", "gltf", "fbx", "dae"};
}

bool isAnimationFile(const fs::path& file) {
  const std::vector<std::string> formats = animationFormats();
  return std::ranges::find(formats, formatOf(file)) != formats.end();
}

bool isOnlyAnimationFile(const fs::path& file) {
  return isAnimationFile(file) && !isMeshFile(file);
}

AnimatedMesh importAnimation(const fs::path& file, const AnimationOptions& options) {
  return joined(replyAbout(file,
                           {options.clip, fmt::format("{}", options.rate), fmt::format("{}", options.metresPerUnit),
                            options.loop ? "1" : "0", fmt::format("{}", options.blend)},
                           options.watch));
}

BindPose importBindPose(const fs::path& file, const ImportOptions& options) {
  ImportReply reply = replyAbout(file, {"clips"}, options.watch);
  BindPose pose{weldMesh(reply.mesh, file.string(), options), std::move(reply.clips)};
  pose.mesh.format = {1.0, 'y'};
  return pose;
}

}  // namespace drape::io
