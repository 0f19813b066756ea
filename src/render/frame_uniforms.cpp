#include "render/frame_uniforms.hpp"

#include "render/shader_program.hpp"

namespace drape::render {

static_assert(sizeof(FrameUniforms) == (2 * 16 + 7 * 4) * sizeof(float), "the block must have no gaps");

FrameBlock::FrameBlock() {
  glBindBuffer(GL_UNIFORM_BUFFER, buffer_.name());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(FrameUniforms), nullptr, GL_DYNAMIC_DRAW);
}

void FrameBlock::upload(const FrameUniforms& uniforms) {
  glBindBuffer(GL_UNIFORM_BUFFER, buffer_.name());
  glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(FrameUniforms), &uniforms);
  glBindBufferBase(GL_UNIFORM_BUFFER, frameBlockBinding, buffer_.name());
}

}  // namespace drape::render
