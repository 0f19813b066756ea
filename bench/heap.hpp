#pragma once

#include <malloc.h>

namespace drape::bench {

/// Memory that the program has allocated from the C library and not freed [bytes].
inline double heapInUse() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

}  // namespace drape::bench
