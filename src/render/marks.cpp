#include "render/marks.hpp"

#include <algorithm>

namespace drape::render {
namespace {

// Screen colours, with opacity.
const Eigen::Vector4f pinColour(0.16F, 0.18F, 0.22F, 1.0F);
const Eigen::Vector4f attachmentColour(0.96F, 0.62F, 0.16F, 1.0F);
constexpr float pinSize = 8.0F;        // of a single pin [units of a mark]
constexpr float manySize = 4.5F;       // of many pins, so that they do not hide the cloth
constexpr float shareOfGap = 0.5F;     // maximum size relative to the distance of the next pin
constexpr float smallestPin = 1.5F;    // [pixels]
constexpr float attachedSize = 12.0F;  // in units of a mark
constexpr float targetSize = 16.0F;    // in units of a mark
constexpr float pickedSize = 11.0F;    // in units of a mark
const Eigen::Vector4f contactColour(0.86F, 0.16F, 0.36F, 1.0F);
constexpr double contactLength = 0.03;  // of a drawn normal [m]
constexpr float contactSize = 6.5F;     // [units of a mark]; the rim takes two
constexpr float threadWidth = 2.5F;
const Eigen::Vector4f intersectionColour(0.90F, 0.08F, 0.10F, 1.0F);
constexpr float intersectionWidth = 3.0F;

float sizeOfPins(std::size_t count) {
  constexpr float few = 6.0F;
  const float share = std::min(few / static_cast<float>(count), 1.0F);
  return manySize + (pinSize - manySize) * share;
}

/// The median length of the edges with two pinned ends [m]; 0 when there is none.
float gapBetweenPins(const sim::ClothModel& model) {
  std::vector<double> gaps;
  for (const sim::Spring& spring : model.springs) {
    if (model.pinned[spring.a] && model.pinned[spring.b]) {
      gaps.push_back(spring.restLength);
    }
  }
  if (gaps.empty()) {
    return 0.0F;
  }
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return static_cast<float>(*middle);
}

}  // namespace

Marks::Marks()
    : dots_("dot.vert", "dot.frag"), thread_("thread.vert", "thread.frag"), lines_("contact.vert", "contact.frag") {
  glBindVertexArray(pinArray_.name());
  glBindBuffer(GL_ARRAY_BUFFER, pinBuffer_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(contactArray_.name());
  glBindBuffer(GL_ARRAY_BUFFER, contactBuffer_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(intersectionArray_.name());
  glBindBuffer(GL_ARRAY_BUFFER, intersectionBuffer_.name());
  for (const GLuint end : {0U, 1U}) {
    glEnableVertexAttribArray(end);
    const std::size_t offset = end * sizeof(Eigen::Vector3f);
    glVertexAttribPointer(end, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(Eigen::Vector3f),
                          reinterpret_cast<const void*>(offset));  // NOLINT(performance-no-int-to-ptr)
    glVertexAttribDivisor(end, 1);
  }
  glBindVertexArray(0);
}

void Marks::setIntersections(const session::Snapshot& snapshot) {
  std::vector<Eigen::Vector3f> ends;
  for (const sim::contact::IntersectionSegment& segment : snapshot.intersections) {
    ends.emplace_back(segment.from.cast<float>());
    ends.emplace_back(segment.to.cast<float>());
  }
  intersections_ = static_cast<GLsizei>(snapshot.intersections.size());
  glBindBuffer(GL_ARRAY_BUFFER, intersectionBuffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ends.size() * sizeof(Eigen::Vector3f)), ends.data(),
               GL_STREAM_DRAW);
}

void Marks::drawIntersections(float scale) const {
  if (intersections_ == 0) {
    return;
  }
  thread_.use();
  thread_.set("width", intersectionWidth * scale);
  thread_.set("colour", intersectionColour);
  glBindVertexArray(intersectionArray_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, intersections_);
  glBindVertexArray(0);
}

void Marks::setContacts(const session::Snapshot& snapshot) {
  contacts_.clear();
  for (const sim::contact::ContactPoint& contact : snapshot.contactPoints) {
    contacts_.emplace_back(contact.point.cast<float>());
    contacts_.emplace_back((contact.point + contactLength * contact.normal).cast<float>());
  }
  glBindBuffer(GL_ARRAY_BUFFER, contactBuffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(contacts_.size() * sizeof(Eigen::Vector3f)), contacts_.data(),
               GL_STREAM_DRAW);
}

void Marks::drawContacts(float scale) const {
  if (contacts_.empty()) {
    return;
  }
  glBindVertexArray(contactArray_.name());
  lines_.use();
  lines_.set("colour", contactColour);
  glBindBuffer(GL_ARRAY_BUFFER, contactBuffer_.name());
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(contacts_.size()));
  // Every second point is the foot of a normal.
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(Eigen::Vector3f), nullptr);
  dots_.use();
  dots_.set("fill", contactColour);
  dots_.set("size", contactSize * scale);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(contacts_.size() / 2));
  glBindVertexArray(0);
}

void Marks::setPins(const session::Snapshot& snapshot) {
  pins_.clear();
  const std::vector<bool>& pinned = snapshot.model->pinned;
  const int count = static_cast<int>(std::min(pinned.size(), snapshot.positions.size()));
  for (const scene::ClothPart& cloth : snapshot.scene->cloths) {
    const int end = std::min(cloth.firstVertex + cloth.vertexCount, count);
    // Dots at every vertex would hide a frozen cloth.
    const bool isFrozen =
        std::find(pinned.begin() + cloth.firstVertex, pinned.begin() + end, false) == pinned.begin() + end;
    for (int v = cloth.firstVertex; !isFrozen && v < end; ++v) {
      if (pinned[v]) {
        pins_.emplace_back(snapshot.positions[v].cast<float>());
      }
    }
  }
  if (snapshot.model != pinnedModel_) {
    pinnedModel_ = snapshot.model;
    pinGap_ = gapBetweenPins(*pinnedModel_);
  }
  glBindBuffer(GL_ARRAY_BUFFER, pinBuffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(pins_.size() * sizeof(Eigen::Vector3f)), pins_.data(),
               GL_STREAM_DRAW);
}

void Marks::drawPins(float scale, float pixelsPerMetre) const {
  if (pins_.empty()) {
    return;
  }
  float size = sizeOfPins(pins_.size()) * scale;
  if (pinGap_ > 0.0F) {
    size = std::clamp(shareOfGap * pinGap_ * pixelsPerMetre, std::min(smallestPin, size), size);
  }
  dots_.use();
  dots_.set("fill", pinColour);
  dots_.set("size", size);
  glBindVertexArray(pinArray_.name());
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(pins_.size()));
  glBindVertexArray(0);
}

void Marks::drawAttachment(const session::AttachmentStatus& attachment, float scale) const {
  const Eigen::Vector3f attached = attachment.point.cast<float>();
  const Eigen::Vector3f target = attachment.target.cast<float>();
  thread_.use();
  thread_.set("width", threadWidth * scale);
  thread_.set("colour", attachmentColour);
  glBindVertexArray(nothing_.name());
  glVertexAttrib3fv(0, attached.data());
  glVertexAttrib3fv(1, target.data());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  drawDot(target, targetSize * scale, attachmentColour);
  drawDot(attached, attachedSize * scale, attachment.pinned ? pinColour : Eigen::Vector4f(1.0F, 1.0F, 1.0F, 1.0F));
  glBindVertexArray(0);
}

void Marks::drawPicked(const Vec3& position, const fields::ScreenColour& colour, float scale) const {
  constexpr Eigen::Index channels = 3;
  Eigen::Vector4f fill = Eigen::Vector4f::Ones();
  fill.head<channels>() = Eigen::Vector3f(colour[0], colour[1], colour[2]);
  const Eigen::Vector4f rim(0.05F, 0.06F, 0.08F, 1.0F);
  glBindVertexArray(nothing_.name());
  drawDot(position.cast<float>(), pickedSize * scale + 5.0F, rim);
  drawDot(position.cast<float>(), pickedSize * scale, fill);
  glBindVertexArray(0);
}

void Marks::drawDot(const Eigen::Vector3f& position, float size, const Eigen::Vector4f& fill) const {
  dots_.use();
  dots_.set("fill", fill);
  dots_.set("size", size);
  // One point: a constant attribute value replaces a buffer.
  glVertexAttrib3fv(0, position.data());
  glDrawArrays(GL_POINTS, 0, 1);
}

}  // namespace drape::render
