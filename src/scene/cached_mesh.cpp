#include "scene/cached_mesh.hpp"

#include "messages/error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace drape::scene {
namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr double together = 1e-5;  // of the size of the mesh: rounding of single precision

/// The positions at given times.
class TimedFrames final : public sim::contact::Deformation {
 public:
  /// @param period after which the frames repeat [s]; 0: they do not
  TimedFrames(std::vector<double> times, std::vector<Points> frames, double scale, double period)
      : times_(std::move(times)), frames_(std::move(frames)), scale_(scale), period_(period) {}

  void positionsAt(double time, std::vector<Vec3>& positions) const override {
    const double at = period_ > 0.0 ? time - period_ * std::floor(time / period_) : time;
    const auto after = std::upper_bound(times_.begin(), times_.end(), at);
    const auto next = static_cast<std::size_t>(after - times_.begin());
    const std::size_t from = next == 0 ? 0 : next - 1;
    const bool isLast = next == times_.size();
    const std::size_t to = !isLast ? next : period_ > 0.0 ? 0 : from;
    const double length = (isLast ? period_ : times_[to]) - times_[from];
    const double share = from == to || next == 0 ? 0.0 : std::clamp((at - times_[from]) / length, 0.0, 1.0);
    positions.resize(frames_[from].size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
      positions[v] = scale_ * ((1.0 - share) * frames_[from][v].cast<double>() + share * frames_[to][v].cast<double>());
    }
  }

 private:
  std::vector<double> times_;   // ascending, the first one is 0 [s]
  std::vector<Points> frames_;  // one a time
  double scale_;
  double period_;
};

double sizeOf(const Points& points) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : points) {
    box.extend(point);
  }
  return static_cast<double>(box.sizes().norm());
}

bool areEqual(const Points& first, const Points& second) {
  const double tolerance = together * sizeOf(first);
  return std::equal(first.begin(), first.end(), second.begin(),
                    [&](const auto& a, const auto& b) { return static_cast<double>((a - b).norm()) <= tolerance; });
}

bool stayTogether(const io::PointCache& cache, double size, std::size_t first, std::size_t second) {
  return std::all_of(cache.frames.begin(), cache.frames.end(), [&](const Points& frame) {
    return static_cast<double>((frame[first] - frame[second]).norm()) <= together * size;
  });
}

}  // namespace

VertexMatch vertexMatchOf(const io::FileMesh& file, std::size_t vertices, const io::PointCache& cache) {
  VertexMatch match;
  match.fileVertex.assign(vertices, -1);
  const double size = sizeOf(cache.frames.front());
  for (std::size_t v = 0; v < file.particle.size(); ++v) {
    const int vertex = file.particle[v];
    if (vertex < 0) {
      continue;
    }
    int& first = match.fileVertex[vertex];
    if (first < 0) {
      first = static_cast<int>(v);
    } else {
      match.parted += stayTogether(cache, size, static_cast<std::size_t>(first), v) ? 0 : 1;
    }
  }
  if (std::ranges::find(match.fileVertex, -1) != match.fileVertex.end()) {
    throw messages::InputError(
        "the vertices of the mesh cannot be found in its file, so a cache cannot move them. Export the mesh as OBJ.");
  }
  return match;
}

std::shared_ptr<const sim::contact::MeshShape> cachedMesh(std::vector<Triangle> triangles, const io::PointCache& cache,
                                                          const VertexMatch& match, double scale, bool loop) {
  std::vector<Points> frames;
  for (const Points& all : cache.frames) {
    Points& own = frames.emplace_back();
    std::ranges::transform(match.fileVertex, std::back_inserter(own), [&](int vertex) { return all[vertex]; });
  }
  std::vector<double> times = cache.times;
  double period = 0.0;
  if (loop && frames.size() > 1) {
    period = times.back();
    if (areEqual(frames.front(), frames.back())) {
      frames.pop_back();
      times.pop_back();
    } else {
      period += times.back() / static_cast<double>(times.size() - 1);
    }
  }
  auto shape = std::make_shared<sim::contact::MeshShape>();
  shape->triangles = std::move(triangles);
  shape->deformation = std::make_shared<TimedFrames>(std::move(times), std::move(frames), scale, period);
  shape->deformation->positionsAt(0.0, shape->positions);
  return shape;
}

}  // namespace drape::scene
