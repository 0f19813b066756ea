#include "render/smooth_mesh.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace drape::render {
namespace {

constexpr GLuint positionAttribute = 0U;
constexpr GLuint normalAttribute = 1U;
constexpr GLuint surfaceAttribute = 2U;
constexpr GLuint curvatureAttribute = 3U;
constexpr GLuint yarnAttribute = 4U;
constexpr GLuint valueAttribute = 5U;
constexpr GLuint wrinkleAttribute = 6U;  // the first of three

const void* bufferOffset(std::size_t bytes) {
  // OpenGL takes offsets as pointers.
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

}  // namespace

SmoothMesh::SmoothMesh() {
  glBindVertexArray(vertexArray_.name());
  glBindBuffer(GL_ARRAY_BUFFER, moving_.name());
  glEnableVertexAttribArray(positionAttribute);
  glVertexAttribPointer(positionAttribute, 3, GL_FLOAT, GL_FALSE, sizeof(MovingVertex), bufferOffset(0));
  glEnableVertexAttribArray(normalAttribute);
  glVertexAttribPointer(normalAttribute, 3, GL_FLOAT, GL_FALSE, sizeof(MovingVertex),
                        bufferOffset(offsetof(MovingVertex, shape.normal)));
  glEnableVertexAttribArray(curvatureAttribute);
  glVertexAttribPointer(curvatureAttribute, 1, GL_FLOAT, GL_FALSE, sizeof(MovingVertex),
                        bufferOffset(offsetof(MovingVertex, shape.curvature)));
  glBindBuffer(GL_ARRAY_BUFFER, fixed_.name());
  glEnableVertexAttribArray(surfaceAttribute);
  glVertexAttribPointer(surfaceAttribute, 2, GL_FLOAT, GL_FALSE, sizeof(FixedVertex),
                        bufferOffset(offsetof(FixedVertex, surface)));
  glEnableVertexAttribArray(yarnAttribute);
  glVertexAttribPointer(yarnAttribute, 2, GL_FLOAT, GL_FALSE, sizeof(FixedVertex),
                        bufferOffset(offsetof(FixedVertex, yarns)));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glBindVertexArray(0);
}

std::vector<SmoothMesh::FixedVertex> SmoothMesh::fixedVertices(const MeshTopology& topology, std::size_t count) {
  std::vector<FixedVertex> vertices(count);
  for (std::size_t i = 0; i < std::min(count, topology.surfaceCoordinates.size()); ++i) {
    vertices[i].surface = topology.surfaceCoordinates[i].cast<float>();
  }
  for (std::size_t i = 0; i < std::min(count, topology.yarnCoordinates.size()); ++i) {
    vertices[i].yarns = topology.yarnCoordinates[i].cast<float>();
  }
  return vertices;
}

void SmoothMesh::setTopology(const MeshTopology& topology) {
  particleTriangles_.assign(topology.particleTriangles.begin(), topology.particleTriangles.end());
  particleOfVertex_.assign(topology.particleOfVertex.begin(), topology.particleOfVertex.end());
  if (particleOfVertex_.empty()) {
    int count = 0;
    for (const Triangle& triangle : particleTriangles_) {
      count = std::max(count, *std::max_element(triangle.begin(), triangle.end()) + 1);
    }
    particleOfVertex_.resize(count);
    std::iota(particleOfVertex_.begin(), particleOfVertex_.end(), 0);
  }

  const std::vector<FixedVertex> vertices = fixedVertices(topology, particleOfVertex_.size());
  glBindVertexArray(vertexArray_.name());
  glBindBuffer(GL_ARRAY_BUFFER, fixed_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(FixedVertex)), vertices.data(),
               GL_STATIC_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(topology.drawnTriangles.size_bytes()),
               topology.drawnTriangles.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
  indexCount_ = static_cast<GLsizei>(3 * topology.drawnTriangles.size());
}

void SmoothMesh::setPositions(std::span<const Vec3> positions) {
  shapes_.compute(positions, particleTriangles_);
  const std::span<const SurfaceShape> shapes = shapes_.values();
  bounds_.setEmpty();
  for (const Vec3& position : positions) {
    bounds_.extend(position);
  }
  if (particleOfVertex_.empty()) {
    return;  // OpenGL does not map empty buffers
  }
  const auto size = static_cast<GLsizeiptr>(particleOfVertex_.size() * sizeof(MovingVertex));
  glBindBuffer(GL_ARRAY_BUFFER, moving_.name());
  // New storage each time, so that the driver does not wait for the old one.
  glBufferData(GL_ARRAY_BUFFER, size, nullptr, GL_STREAM_DRAW);
  auto* vertex = static_cast<MovingVertex*>(
      glMapBufferRange(GL_ARRAY_BUFFER, 0, size, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT));
  if (vertex == nullptr) {
    return;  // the driver is out of memory: skip the cloth instead of crashing
  }
  for (const int particle : particleOfVertex_) {
    vertex->position = positions[particle].cast<float>();
    vertex->shape = shapes[particle];
    ++vertex;
  }
  glUnmapBuffer(GL_ARRAY_BUFFER);
}

void SmoothMesh::setValues(std::span<const float> values) {
  valueOfVertex_.resize(particleOfVertex_.size());
  std::transform(particleOfVertex_.begin(), particleOfVertex_.end(), valueOfVertex_.begin(),
                 [&](int particle) { return values[particle]; });
  glBindVertexArray(vertexArray_.name());
  glBindBuffer(GL_ARRAY_BUFFER, values_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(valueOfVertex_.size() * sizeof(float)), valueOfVertex_.data(),
               GL_STREAM_DRAW);
  glEnableVertexAttribArray(valueAttribute);
  glVertexAttribPointer(valueAttribute, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
}

void SmoothMesh::setWrinkles(std::span<const Wrinkles> wrinkles) {
  wrinklesOfVertex_.resize(particleOfVertex_.size());
  std::transform(particleOfVertex_.begin(), particleOfVertex_.end(), wrinklesOfVertex_.begin(),
                 [&](int particle) { return wrinkles[particle]; });
  glBindVertexArray(vertexArray_.name());
  glBindBuffer(GL_ARRAY_BUFFER, wrinkles_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(wrinklesOfVertex_.size() * sizeof(Wrinkles)),
               wrinklesOfVertex_.data(), GL_STREAM_DRAW);
  const std::array offsets{offsetof(Wrinkles, place), offsetof(Wrinkles, diagonal), offsetof(Wrinkles, mixed)};
  for (GLuint i = 0; i < offsets.size(); ++i) {
    glEnableVertexAttribArray(wrinkleAttribute + i);
    glVertexAttribPointer(wrinkleAttribute + i, 3, GL_FLOAT, GL_FALSE, sizeof(Wrinkles), bufferOffset(offsets[i]));
  }
  glBindVertexArray(0);
}

void SmoothMesh::draw() const {
  draw(0, indexCount_ / 3);
}

void SmoothMesh::draw(int first, int count) const {
  const std::size_t offset = std::size_t{3} * first * sizeof(GLuint);
  glBindVertexArray(vertexArray_.name());
  // OpenGL takes an offset in bytes as a pointer.
  glDrawElements(GL_TRIANGLES, 3 * count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));  // NOLINT
  glBindVertexArray(0);
}

}  // namespace drape::render
