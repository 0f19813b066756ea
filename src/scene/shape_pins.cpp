#include "scene/shape_pins.hpp"

#include "scene/boundary_loops.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace drape::scene {
namespace {

constexpr double nearTop = 0.06;      // share of a piece's height: shoulders, straps
constexpr double topOfClosed = 0.03;  // share of the height of a piece without a border
constexpr double deepLoop =
    0.2;  // share of the height: of a loop that extends farther down, only the upper part is pinned
constexpr double smallPiece = 0.05;  // share of the largest piece's area: buttons, pockets

/// Lowest and highest y of some vertices [m].
struct Heights {
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();

  [[nodiscard]] double range() const { return high - low; }
};

class PieceHanger {
 public:
  PieceHanger(const sim::ClothMesh& mesh, const ClothPieces& found, const ClothPiece& piece,
              const std::vector<const BoundaryLoop*>& loops)
      : positions_(mesh.positions), found_(found), piece_(piece), loops_(loops), heights_(heightsOf(piece.vertices)) {}

  [[nodiscard]] std::vector<int> pins() const {
    if (loops_.size() == 1 && found_.isOutline(*loops_.front())) {
      return pinsOfSheet(*loops_.front());
    }
    const BoundaryLoop* loop = topmostOpening();
    if (loop == nullptr) {
      return above(piece_.vertices, heights_.high - topOfClosed * heights_.range());
    }
    const Heights heights = heightsOf(loop->vertices);
    if (heights.range() <= deepLoop * heights_.range()) {
      return loop->vertices;
    }
    std::vector<int> border;
    for (const BoundaryLoop* each : loops_) {
      border.insert(border.end(), each->vertices.begin(), each->vertices.end());
    }
    return above(border, heights.high - nearTop * heights_.range());
  }

 private:
  [[nodiscard]] const Vec3& at(int vertex) const { return positions_[vertex]; }

  [[nodiscard]] Heights heightsOf(const std::vector<int>& vertices) const {
    Heights heights;
    for (const int vertex : vertices) {
      heights.low = std::min(heights.low, at(vertex).y());
      heights.high = std::max(heights.high, at(vertex).y());
    }
    return heights;
  }

  [[nodiscard]] std::vector<int> above(const std::vector<int>& vertices, double height) const {
    std::vector<int> list;
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(list),
                 [&](int vertex) { return at(vertex).y() >= height; });
    return list;
  }

  /// The opening nearest to the top. Of two equally near ones, the one that faces up more, then the shorter one. Null
  /// when all openings are far below, as in a cap.
  [[nodiscard]] const BoundaryLoop* topmostOpening() const {
    constexpr double facingUp = 0.25;  // the bonus for facing up, as a share of the height
    constexpr double equal = 0.02;
    const BoundaryLoop* best = nullptr;
    double bestScore = 0.0;
    for (const BoundaryLoop* loop : loops_) {
      const double height = heights_.range() > 0.0 ? (loop->centre.y() - heights_.low) / heights_.range() : 1.0;
      const double area = loop->area.norm();
      const double score = height + (area > 0.0 ? facingUp * std::abs(loop->area.y()) / area : 0.0);
      const bool better =
          best == nullptr || score > bestScore + equal || (score > bestScore - equal && loop->length < best->length);
      if (height > 0.5 && better) {
        best = loop;
        bestScore = score;
      }
    }
    return best;
  }

  [[nodiscard]] std::vector<int> pinsOfSheet(const BoundaryLoop& outline) const {
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread());
    constexpr double flatness = 0.02;
    const Vec3 sizes = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    const Vec3 normal = axes.eigenvectors().col(0);
    const bool flat = sizes[0] <= flatness * sizes[2];
    const bool level = std::abs(normal.y()) > 0.9;
    if (flat && !level) {
      const Vec3 sideways = Vec3::UnitY().cross(normal).normalized();
      Vec3 up = normal.cross(sideways);
      up *= up.y() < 0.0 ? -1.0 : 1.0;
      return corners(outline, sideways, up);
    }
    const std::vector<int> top = above(outline.vertices, heights_.high - nearTop * heights_.range());
    return flat || top.size() < 2 ? corners(outline, Vec3::UnitX(), -Vec3::UnitZ()) : top;
  }

  /// The two corners of a border that are extreme along `to`, at either end of `across`.
  [[nodiscard]] std::vector<int> corners(const BoundaryLoop& outline, const Vec3& across, const Vec3& to) const {
    const double width = extent(outline, across);
    const double height = extent(outline, to);
    std::vector<int> found;
    for (const double side : {-1.0, 1.0}) {
      const Vec3 direction = side * across / std::max(width, 1e-12) + to / std::max(height, 1e-12);
      found.push_back(*std::max_element(outline.vertices.begin(), outline.vertices.end(),
                                        [&](int a, int b) { return direction.dot(at(a)) < direction.dot(at(b)); }));
    }
    return found;
  }

  [[nodiscard]] double extent(const BoundaryLoop& loop, const Vec3& along) const {
    const auto [low, high] = std::minmax_element(loop.vertices.begin(), loop.vertices.end(),
                                                 [&](int a, int b) { return along.dot(at(a)) < along.dot(at(b)); });
    return along.dot(at(*high) - at(*low));
  }

  /// The covariance of the vertices [m^2].
  [[nodiscard]] Mat3 spread() const {
    Vec3 mean = Vec3::Zero();
    for (const int vertex : piece_.vertices) {
      mean += at(vertex) / static_cast<double>(piece_.vertices.size());
    }
    Mat3 sum = Mat3::Zero();
    for (const int vertex : piece_.vertices) {
      sum += (at(vertex) - mean) * (at(vertex) - mean).transpose();
    }
    return sum / static_cast<double>(piece_.vertices.size());
  }

  const std::vector<Vec3>& positions_;
  const ClothPieces& found_;
  const ClothPiece& piece_;
  const std::vector<const BoundaryLoop*>& loops_;
  Heights heights_;
};

}  // namespace

std::vector<int> pinsByShape(const sim::ClothMesh& mesh) {
  const ClothPieces found = findPieces(mesh);
  std::vector<std::vector<const BoundaryLoop*>> loops(found.pieces.size());
  for (const BoundaryLoop& loop : found.loops) {
    loops[loop.piece].push_back(&loop);
  }
  double largest = 0.0;
  for (const ClothPiece& piece : found.pieces) {
    largest = std::max(largest, piece.area);
  }
  std::vector<int> pins;
  for (std::size_t piece = 0; piece < found.pieces.size(); ++piece) {
    if (found.pieces[piece].area >= smallPiece * largest) {
      const std::vector<int> more = PieceHanger(mesh, found, found.pieces[piece], loops[piece]).pins();
      pins.insert(pins.end(), more.begin(), more.end());
    }
  }
  std::sort(pins.begin(), pins.end());
  pins.erase(std::unique(pins.begin(), pins.end()), pins.end());
  return pins;
}

}  // namespace drape::scene
