#include "render/osmesa_context.hpp"

#include "messages/error.hpp"

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <array>
#include <cstdint>
#include <string_view>

// Debian's GLEW gets the functions from glXGetProcAddressARB, and ImGui's OpenGL backend opens libGL for the same name.
// Neither supports off-screen Mesa, so a program with OSMesa provides this function and redirects that library.
extern "C" {

__attribute__((visibility("default"))) void (*glXGetProcAddressARB(const unsigned char* name))() {
  return OSMesaGetProcAddress(static_cast<const char*>(static_cast<const void*>(name)));
}

// The linker's option --wrap needs these names.
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming)
void* __real_dlopen(const char* file, int mode);
void* __wrap_dlopen(const char* file, int mode);

void* __wrap_dlopen(const char* file, int mode) {
  const bool wantsLibGl = file != nullptr && std::string_view(file).starts_with("libGL.so");
  return __real_dlopen(wantsLibGl ? nullptr : file, mode);
}

#ifdef DRAPE_SANITIZED
// OSMesa leaks a few hundred bytes per context. Only these leaks are suppressed.
const char* __lsan_default_suppressions();
__attribute__((visibility("default"))) const char* __lsan_default_suppressions() {
  return "leak:libOSMesa\n";
}
#endif
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

}  // extern "C"

namespace drape::render {

struct OsmesaContext::State {
  static constexpr int side = 16;  // [pixels]
  OSMesaContext context = nullptr;
  std::array<std::uint8_t, std::size_t{4} * side * side> pixels{};
};

OsmesaContext::OsmesaContext() : state_(std::make_unique<State>()) {
  const std::array<int, 11> attributes{OSMESA_FORMAT,
                                       OSMESA_RGBA,
                                       OSMESA_PROFILE,
                                       OSMESA_CORE_PROFILE,
                                       OSMESA_CONTEXT_MAJOR_VERSION,
                                       3,
                                       OSMESA_CONTEXT_MINOR_VERSION,
                                       3,
                                       OSMESA_DEPTH_BITS,
                                       0,
                                       0};
  state_->context = OSMesaCreateContextAttribs(attributes.data(), nullptr);
  if (state_->context == nullptr) {
    throw messages::InputError("off-screen drawing: this OSMesa has no OpenGL 3.3 core; Mesa 17 or newer is needed");
  }
  if (OSMesaMakeCurrent(state_->context, state_->pixels.data(), GL_UNSIGNED_BYTE, State::side, State::side) !=
      GL_TRUE) {
    OSMesaDestroyContext(state_->context);
    throw messages::InputError("off-screen drawing: the OSMesa context cannot be made current");
  }
  try {
    loadGlFunctions("off-screen drawing");
  } catch (const messages::InputError&) {
    OSMesaDestroyContext(state_->context);
    throw;
  }
}

OsmesaContext::~OsmesaContext() {
  OSMesaDestroyContext(state_->context);
}

}  // namespace drape::render
