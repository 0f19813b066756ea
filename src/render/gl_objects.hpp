#pragma once

#include <GL/glew.h>
#include <utility>

namespace drape::render {

/// Owns an OpenGL object. `Kind` creates and deletes it. The context must outlive it.
template <typename Kind>
class GlObject {
 public:
  GlObject() { Kind::make(&name_); }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0U)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0U) {
      Kind::free(&name_);
    }
  }

  [[nodiscard]] GLuint name() const { return name_; }

 private:
  GLuint name_ = 0U;
};

struct BufferKind {
  static void make(GLuint* name) { glGenBuffers(1, name); }
  static void free(const GLuint* name) { glDeleteBuffers(1, name); }
};
struct VertexArrayKind {
  static void make(GLuint* name) { glGenVertexArrays(1, name); }
  static void free(const GLuint* name) { glDeleteVertexArrays(1, name); }
};
struct TextureKind {
  static void make(GLuint* name) { glGenTextures(1, name); }
  static void free(const GLuint* name) { glDeleteTextures(1, name); }
};
struct SamplerKind {
  static void make(GLuint* name) { glGenSamplers(1, name); }
  static void free(const GLuint* name) { glDeleteSamplers(1, name); }
};
struct RenderbufferKind {
  static void make(GLuint* name) { glGenRenderbuffers(1, name); }
  static void free(const GLuint* name) { glDeleteRenderbuffers(1, name); }
};
struct FramebufferKind {
  static void make(GLuint* name) { glGenFramebuffers(1, name); }
  static void free(const GLuint* name) { glDeleteFramebuffers(1, name); }
};

using GlBuffer = GlObject<BufferKind>;
using GlVertexArray = GlObject<VertexArrayKind>;
using GlTexture = GlObject<TextureKind>;
using GlSampler = GlObject<SamplerKind>;
using GlRenderbuffer = GlObject<RenderbufferKind>;
using GlFramebuffer = GlObject<FramebufferKind>;

/// In debug builds: throws std::logic_error with the place when an OpenGL call since the last check failed.
void checkGl(const char* where);

/// Throws std::runtime_error when the bound framebuffer is not complete.
void requireCompleteFramebuffer(const char* what);

}  // namespace drape::render
