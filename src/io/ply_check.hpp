#pragma once

#include <string_view>

namespace drape {

/// Walks through a PLY file and throws InputError when it does not hold what its header promises: when it is cut off,
/// has a coordinate that is not a finite number, or a face with a vertex that is not there. The parsing library
/// crashes on such files, stalls, or makes up vertices.
void checkPly(std::string_view bytes);

}  // namespace drape
