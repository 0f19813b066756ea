#pragma once

#include "render/gl_objects.hpp"
#include "render/shader_program.hpp"
#include "session/snapshot.hpp"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace drape {

/// Draws what is not there in the scene but helps the hand: pins as dots and the grab as a thread from the held point
/// to the hand, contacts as dots with their normals. All but these are as large on the screen from near as from afar.
class Marks {
 public:
  Marks();

  /// Takes over where the pins are.
  void setPins(const Snapshot& snapshot);
  /// Takes over where the cloth touches something: each place becomes a dot and a line along its normal.
  void setContacts(const Snapshot& snapshot);

  /// `scale` is the size of a mark's unit [pixels]. Pins that stand so close that their dots would touch get smaller
  /// ones.
  /// @param pixelsPerMetre of the picture, where the pins are
  void drawPins(float scale, float pixelsPerMetre) const;
  void drawContacts(float scale) const;
  void drawAttachment(const AttachmentStatus& attachment, float scale) const;

 private:
  void drawDot(const Eigen::Vector3f& position, float size, const Eigen::Vector4f& fill) const;

  ShaderProgram dots_;
  ShaderProgram thread_;
  GlVertexArray pinArray_;
  GlBuffer pinBuffer_;
  GlVertexArray nothing_;
  std::vector<Eigen::Vector3f> pins_;
  std::shared_ptr<const ClothModel> pinnedModel_;  // that pinGap_ belongs to
  float pinGap_ = 0.0F;                            // between neighbouring pins [m]; 0: none has a neighbour
  ShaderProgram lines_;
  GlVertexArray contactArray_;
  GlBuffer contactBuffer_;
  std::vector<Eigen::Vector3f> contacts_;  // two a place: its foot and the end of its normal
};

}  // namespace drape
