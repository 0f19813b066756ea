// Replaces operator new in the programs: it requests huge pages of 2 MiB for large blocks, instead of pages of 4 KiB.
// Reading a mesh of millions of vertices allocates and frees many large arrays, and page faults then take much of the
// time. Linux uses huge pages only on request (docs/experiments/2026-11-22-large-meshes.md).
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
      // If the kernel refuses, the block still works.
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
