#pragma once

#include "fields/colour_map.hpp"
#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"
#include "session/snapshot.hpp"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace drape::render {

/// Draws aids for the user: pins as dots, the attachment as a thread from the attached point to the mouse, contacts as
/// dots with their normals, and intersections as lines. All except the normals have a constant size on the screen.
class Marks {
 public:
  Marks();

  /// Takes over the positions of the pins.
  void setPins(const session::Snapshot& snapshot);
  /// Takes over the contacts: each becomes a dot and a line along its normal.
  void setContacts(const session::Snapshot& snapshot);
  /// Takes over the lines along which the cloth intersects itself.
  void setIntersections(const session::Snapshot& snapshot);

  /// `scale` is the size of a mark's unit [pixels]. Dense pins get smaller dots.
  /// @param pixelsPerMetre of the picture, at the depth of the pins
  void drawPins(float scale, float pixelsPerMetre) const;
  void drawContacts(float scale) const;
  void drawIntersections(float scale) const;
  /// A dot at a picked vertex [m].
  void drawPicked(const Vec3& position, const fields::ScreenColour& colour, float scale) const;
  void drawAttachment(const session::AttachmentStatus& attachment, float scale) const;

 private:
  void drawDot(const Eigen::Vector3f& position, float size, const Eigen::Vector4f& fill) const;

  ShaderProgram dots_;
  ShaderProgram thread_;
  GlVertexArray pinArray_;
  GlBuffer pinBuffer_;
  GlVertexArray nothing_;
  std::vector<Eigen::Vector3f> pins_;
  std::shared_ptr<const sim::ClothModel> pinnedModel_;  // the model of pinGap_
  float pinGap_ = 0.0F;                                 // between neighbouring pins [m]; 0: no neighbours
  ShaderProgram lines_;
  GlVertexArray contactArray_;
  GlBuffer contactBuffer_;
  GlVertexArray intersectionArray_;
  GlBuffer intersectionBuffer_;
  GLsizei intersections_ = 0;
  std::vector<Eigen::Vector3f> contacts_;  // two per contact: its foot and the end of its normal
};

}  // namespace drape::render
