#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace drape::io::animation {

/// A file that is written beside its name, as NAME.part, and renamed when it is complete. Without `commit` it is
/// removed again. All functions throw InputError with the name and the reason.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path file);
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  /// Writes at the end.
  void write(std::string_view bytes);
  /// Replaces bytes that were written before.
  void writeAt(std::uint64_t offset, std::string_view bytes);
  /// Moves everything from `from` on to `to`, which is nearer to the start, and cuts off the rest.
  void moveEnd(std::uint64_t from, std::uint64_t to);
  /// Appends everything that another file contains.
  void append(PartFile& other);

  void commit();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void require(bool success) const;
  std::size_t readAt(std::uint64_t offset, char* into, std::size_t size);

  std::filesystem::path name_;
  std::filesystem::path part_;
  std::unique_ptr<std::FILE, Closer> file_;
  bool committed_ = false;
};

}  // namespace drape::io::animation
