#pragma once

#include <GL/glew.h>

namespace drape {

/// Which texture unit carries what. Unit 0 is left to whoever draws over the picture.
inline constexpr GLuint shadowUnit = 1U;        ///< the shadow map, comparing
inline constexpr GLuint shadowDepthUnit = 2U;   ///< the shadow map's depths
inline constexpr GLuint groundShadowUnit = 3U;  ///< the shadow on the ground

}  // namespace drape
