// Replaces operator new in the programs: large blocks come in huge pages of 2 MiB instead of pages of 4 KiB. The arrays
// of a mesh of millions of vertices are allocated and freed many times while it is read, and most of that time is
// otherwise spent on page faults. Linux gives huge pages only to who asks for them.
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace {

constexpr std::size_t hugePage = std::size_t{2} << 20;  // [bytes]
/// Smaller blocks are left to malloc: rounding them to huge pages would waste memory.
constexpr std::size_t largeBlock = 2 * hugePage;  // [bytes]

/// Null when there is no memory.
void* allocateOrNull(std::size_t size) {
#ifdef __linux__
  if (size >= largeBlock) {
    void* const block = std::aligned_alloc(hugePage, (size + hugePage - 1) / hugePage * hugePage);
    if (block != nullptr) {
      // Without huge pages the block is as good, only slower.
      static_cast<void>(madvise(block, size, MADV_HUGEPAGE));
    }
    return block;
  }
#endif
  return std::malloc(size == 0 ? 1 : size);
}

}  // namespace

void* operator new(std::size_t size) {
  for (;;) {
    if (void* const block = allocateOrNull(size)) {
      return block;
    }
    const std::new_handler makeRoom = std::get_new_handler();
    if (makeRoom == nullptr) {
      throw std::bad_alloc();
    }
    makeRoom();
  }
}

void operator delete(void* block) noexcept {
  std::free(block);
}

void operator delete(void* block, std::size_t /*size*/) noexcept {
  std::free(block);
}
