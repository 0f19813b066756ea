#include "sim/contact/self/collision_free_patches.hpp"

#include "sim/contact/self/topology.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace drape {
namespace {

using Direction = std::array<float, 3>;

constexpr int freeTriangle = -1;
constexpr int withoutArea = -2;
constexpr int kept = -3;

/// Triangles whose mean normal is a chart's axis.
constexpr std::size_t trianglesForAxis = 24;

/// Below this square of twice its area [m^4] a triangle has no normal that could be trusted in float.
constexpr float leastSquaredNormal = 1e-20F;

float squaredCosine(double degrees) {
  const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
  return static_cast<float>(cosine * cosine);
}

float dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Direction unit(const Direction& v) {
  const float length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Appends as much of the last entry as fills a vector.
void fillUp(std::vector<std::int32_t>& values) {
  while (values.size() % mostLanes != 0) {
    values.push_back(values.back());
  }
}

}  // namespace

ChartMesh chartMeshOf(const ClothModel& model) {
  ChartMesh mesh;
  mesh.triangles = model.triangles;
  mesh.across = trianglesAcross(model.triangles);
  mesh.vertices = model.vertexCount();
  for (const Triangle& t : model.triangles) {
    mesh.corners.a.push_back(t[0]);
    mesh.corners.b.push_back(t[1]);
    mesh.corners.c.push_back(t[2]);
  }
  for (auto* part : {&mesh.corners.a, &mesh.corners.b, &mesh.corners.c}) {
    fillUp(*part);
  }
  return mesh;
}

bool BorderCheck::simple(const int* border, int count, const PlaceLanes& places, const Direction& axis) {
  if (count < 4) {
    return true;  // a triangle that faces the axis
  }
  const Direction aside = std::abs(axis[0]) < 0.6F ? Direction{1.0F, 0.0F, 0.0F} : Direction{0.0F, 1.0F, 0.0F};
  const Direction u = unit(cross(aside, axis));
  const Direction w = cross(axis, u);
  x_.resize(static_cast<std::size_t>(count) + mostLanes + 1);
  y_.resize(static_cast<std::size_t>(count) + mostLanes + 1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const auto v = static_cast<std::size_t>(border[i]);
    const Direction place = {places.x[v], places.y[v], places.z[v]};
    x_[i] = dot(place, u);
    y_[i] = dot(place, w);
  }
  x_[static_cast<std::size_t>(count)] = x_[0];
  y_[static_cast<std::size_t>(count)] = y_[0];
  return isSimplePolygon(x_.data(), y_.data(), count);
}

void ChartGrower::begin(const ChartMesh& mesh, const PlaceLanes& places, SelfCharts& charts) {
  const std::size_t triangles = mesh.triangles.size();
  normals_.resize(mesh.corners.a.size());
  normalsOf(places, mesh.corners, static_cast<int>(mesh.corners.a.size()), normals_);
  owner_.assign(triangles, freeTriangle);
  for (std::size_t t = 0; t < triangles; ++t) {
    const Direction n = normal(static_cast<int>(t));
    if (!(dot(n, n) > leastSquaredNormal)) {
      owner_[t] = withoutArea;
    }
  }
  place_.resize(triangles);
  touched_.assign(static_cast<std::size_t>(mesh.vertices), -1);
  next_.resize(static_cast<std::size_t>(mesh.vertices));
  attempt_ = 0;
  charts.charts.clear();
  charts.border.clear();
  charts.chartOfVertex.assign(static_cast<std::size_t>(mesh.vertices), -1);
  charts.chartOfTriangle.assign(triangles, -1);
  for (auto* part : {&charts.corners.a, &charts.corners.b, &charts.corners.c}) {
    part->clear();
  }
}

Direction ChartGrower::normal(int triangle) const {
  const auto t = static_cast<std::size_t>(triangle);
  return {normals_.x[t], normals_.y[t], normals_.z[t]};
}

bool ChartGrower::faces(int triangle, const Direction& axis) const {
  static const float least = squaredCosine(growthAngle);
  const Direction n = normal(triangle);
  const float along = dot(n, axis);
  return along > 0.0F && along * along >= least * dot(n, n);
}

bool ChartGrower::leavesDisc(const ChartMesh& mesh, int triangle) const {
  const auto t = static_cast<std::size_t>(triangle);
  int shared = 0;
  std::size_t edge = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const int across = mesh.across[t][c];
    if (across >= 0 && owner_[static_cast<std::size_t>(across)] == attempt_) {
      ++shared;
      edge = c;
    }
  }
  const int third = mesh.triangles[t][(edge + 2) % 3];
  return shared == 2 || (shared == 1 && touched_[static_cast<std::size_t>(third)] != attempt_);
}

void ChartGrower::take(const ChartMesh& mesh, int triangle) {
  const auto t = static_cast<std::size_t>(triangle);
  owner_[t] = attempt_;
  place_[t] = static_cast<int>(order_.size());
  order_.push_back(triangle);
  for (std::size_t c = 0; c < 3; ++c) {
    touched_[static_cast<std::size_t>(mesh.triangles[t][c])] = attempt_;
    const int across = mesh.across[t][c];
    if (across >= 0 && owner_[static_cast<std::size_t>(across)] == freeTriangle) {
      queue_.push_back(across);
    }
  }
}

void ChartGrower::takeFrom(const ChartMesh& mesh, int seed, const Direction& axis, std::size_t most) {
  ++attempt_;
  order_.clear();
  queue_.clear();
  take(mesh, seed);
  for (std::size_t i = 0; i < queue_.size() && order_.size() < most; ++i) {
    const int t = queue_[i];
    if (owner_[static_cast<std::size_t>(t)] == freeTriangle && faces(t, axis) && leavesDisc(mesh, t)) {
      take(mesh, t);
    }
  }
}

void ChartGrower::giveBack(std::size_t kept) {
  for (std::size_t i = kept; i < order_.size(); ++i) {
    owner_[static_cast<std::size_t>(order_[i])] = freeTriangle;
  }
  order_.resize(kept);
}

Direction ChartGrower::axisAround(const ChartMesh& mesh, int seed) {
  const Direction own = unit(normal(seed));
  takeFrom(mesh, seed, own, trianglesForAxis);
  Direction sum = {0.0F, 0.0F, 0.0F};
  for (const int t : order_) {
    const Direction n = normal(t);
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += n[k];
    }
  }
  giveBack(0);
  const Direction mean = unit(sum);
  return faces(seed, mean) ? mean : own;
}

void ChartGrower::findBorder(const ChartMesh& mesh, std::size_t count) {
  int start = -1;
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<std::size_t>(order_[i]);
    for (std::size_t c = 0; c < 3; ++c) {
      const int across = mesh.across[t][c];
      const bool inside = across >= 0 && owner_[static_cast<std::size_t>(across)] == attempt_ &&
                          place_[static_cast<std::size_t>(across)] < static_cast<int>(count);
      if (!inside) {
        start = mesh.triangles[t][c];
        next_[static_cast<std::size_t>(start)] = mesh.triangles[t][(c + 1) % 3];
      }
    }
  }
  border_.clear();
  for (int v = start; border_.empty() || v != start; v = next_[static_cast<std::size_t>(v)]) {
    border_.push_back(v);
  }
}

void ChartGrower::cutBack(const ChartMesh& mesh, const PlaceLanes& places, const Direction& axis) {
  const auto simple = [&](std::size_t count) {
    findBorder(mesh, count);
    return check_.simple(border_.data(), static_cast<int>(border_.size()), places, axis);
  };
  if (simple(order_.size())) {
    return;
  }
  std::size_t good = 1;
  std::size_t bad = order_.size();
  while (bad - good > 1) {
    const std::size_t middle = std::midpoint(good, bad);
    (simple(middle) ? good : bad) = middle;
  }
  giveBack(good);
  findBorder(mesh, good);
}

void ChartGrower::add(const ChartMesh& mesh, const Direction& axis, SelfCharts& charts) {
  CollisionFreeChart chart;
  chart.axis = axis;
  chart.firstCorner = static_cast<int>(charts.corners.a.size());
  chart.firstBorder = static_cast<int>(charts.border.size());
  const int index = charts.count();
  for (const int t : order_) {
    charts.chartOfTriangle[static_cast<std::size_t>(t)] = index;
    const Triangle& triangle = mesh.triangles[static_cast<std::size_t>(t)];
    charts.corners.a.push_back(triangle[0]);
    charts.corners.b.push_back(triangle[1]);
    charts.corners.c.push_back(triangle[2]);
    for (const int v : triangle) {
      int& own = charts.chartOfVertex[static_cast<std::size_t>(v)];
      own = own < 0 ? index : own;
    }
  }
  for (auto* part : {&charts.corners.a, &charts.corners.b, &charts.corners.c}) {
    fillUp(*part);
  }
  charts.border.insert(charts.border.end(), border_.begin(), border_.end());
  chart.lastCorner = static_cast<int>(charts.corners.a.size());
  chart.lastBorder = static_cast<int>(charts.border.size());
  charts.charts.push_back(chart);
}

void ChartGrower::sortVertices(SelfCharts& charts) {
  for (int& chart : charts.chartOfVertex) {
    if (chart < 0) {
      chart = charts.count();
      CollisionFreeChart loose;
      loose.firstCorner = loose.lastCorner = static_cast<int>(charts.corners.a.size());
      loose.firstBorder = loose.lastBorder = static_cast<int>(charts.border.size());
      charts.charts.push_back(loose);
    }
    ++charts.charts[static_cast<std::size_t>(chart)].lastVertex;
  }
  int sum = 0;
  for (CollisionFreeChart& chart : charts.charts) {
    chart.firstVertex = sum;
    sum += chart.lastVertex;
    chart.lastVertex = chart.firstVertex;
  }
  charts.vertices.resize(charts.chartOfVertex.size());
  for (std::size_t v = 0; v < charts.vertices.size(); ++v) {
    CollisionFreeChart& chart = charts.charts[static_cast<std::size_t>(charts.chartOfVertex[v])];
    charts.vertices[static_cast<std::size_t>(chart.lastVertex++)] = static_cast<int>(v);
  }
}

void ChartGrower::keep(const SelfCharts& old, const std::vector<char>& holds, SelfCharts& charts) {
  std::vector<int> indices(holds.size(), -1);
  for (std::size_t c = 0; c < holds.size(); ++c) {
    CollisionFreeChart chart = old.charts[c];
    if (holds[c] == 0 || chart.firstCorner == chart.lastCorner) {
      continue;
    }
    indices[c] = charts.count();
    const auto copied = [&](const std::vector<int>& from, int first, int last, std::vector<int>& to) {
      to.insert(to.end(), from.begin() + first, from.begin() + last);
    };
    const int firstCorner = static_cast<int>(charts.corners.a.size());
    const int firstBorder = static_cast<int>(charts.border.size());
    copied(old.corners.a, chart.firstCorner, chart.lastCorner, charts.corners.a);
    copied(old.corners.b, chart.firstCorner, chart.lastCorner, charts.corners.b);
    copied(old.corners.c, chart.firstCorner, chart.lastCorner, charts.corners.c);
    copied(old.border, chart.firstBorder, chart.lastBorder, charts.border);
    for (auto i = static_cast<std::size_t>(firstCorner); i < charts.corners.a.size(); ++i) {
      for (const int v : {charts.corners.a[i], charts.corners.b[i], charts.corners.c[i]}) {
        int& own = charts.chartOfVertex[static_cast<std::size_t>(v)];
        own = own < 0 ? indices[c] : own;
      }
    }
    chart.firstCorner = firstCorner;
    chart.lastCorner = static_cast<int>(charts.corners.a.size());
    chart.firstBorder = firstBorder;
    chart.lastBorder = static_cast<int>(charts.border.size());
    chart.firstVertex = chart.lastVertex = 0;
    charts.charts.push_back(chart);
  }
  for (std::size_t t = 0; t < owner_.size(); ++t) {
    const int was = old.chartOfTriangle[t];
    if (was >= 0 && indices[static_cast<std::size_t>(was)] >= 0) {
      owner_[t] = kept;
      charts.chartOfTriangle[t] = indices[static_cast<std::size_t>(was)];
    }
  }
}

void ChartGrower::growRest(const ChartMesh& mesh, const PlaceLanes& places, SelfCharts& charts) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (owner_[t] == freeTriangle) {
      const int seed = static_cast<int>(t);
      const Direction axis = axisAround(mesh, seed);
      takeFrom(mesh, seed, axis, mesh.triangles.size());
      cutBack(mesh, places, axis);
      add(mesh, axis, charts);
    }
  }
  sortVertices(charts);
}

void ChartGrower::grow(const ChartMesh& mesh, const PlaceLanes& places, SelfCharts& charts) {
  begin(mesh, places, charts);
  growRest(mesh, places, charts);
}

void ChartGrower::mend(const ChartMesh& mesh, const PlaceLanes& places, const SelfCharts& old,
                       const std::vector<char>& holds, SelfCharts& charts) {
  begin(mesh, places, charts);
  keep(old, holds, charts);
  growRest(mesh, places, charts);
}

int ChartCheck::failures(const SelfCharts& charts, const PlaceLanes& places, std::vector<char>& holds) {
  static const float least = squaredCosine(holdAngle);
  holds.assign(charts.charts.size(), 1);
  int failed = 0;
  for (std::size_t c = 0; c < holds.size(); ++c) {
    const CollisionFreeChart& chart = charts.charts[c];
    if (!normalsWithin(places, charts.corners, chart.firstCorner, chart.lastCorner, chart.axis, least) ||
        !border_.simple(charts.border.data() + chart.firstBorder, chart.lastBorder - chart.firstBorder, places,
                        chart.axis)) {
      holds[c] = 0;
      ++failed;
    }
  }
  return failed;
}

}  // namespace drape
