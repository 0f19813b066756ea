#pragma once

#include <GL/glew.h>

namespace drape::render {

/// The assignment of the texture units. Unit 0 is free for drawing over the picture.
inline constexpr GLuint shadowUnit = 1U;        ///< the shadow map, comparing
inline constexpr GLuint shadowDepthUnit = 2U;   ///< the shadow map's depths
inline constexpr GLuint groundShadowUnit = 3U;  ///< the shadow on the ground
inline constexpr GLuint occlusionUnit = 4U;     ///< ambient occlusion of the picture
inline constexpr GLuint normalsUnit = 5U;       ///< normals of the picture's surfaces, while it is computed

}  // namespace drape::render
