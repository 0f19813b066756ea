#pragma once

// The declarations of stb's picture reader and writer. Their implementation is compiled once, in stb.cpp, for PNG only.
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
