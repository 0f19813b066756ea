#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace drape::io {

/// The whole number under this key; empty if there is none, or one that no file needs. `object` must be an object.
[[nodiscard]] std::optional<std::uint64_t> gltfIndexOf(const nlohmann::json& object, const char* key);

/// The object at this place of a list of `object`; null if it is not there.
[[nodiscard]] const nlohmann::json* gltfElementOf(const nlohmann::json& object, const char* list,
                                                  std::optional<std::uint64_t> index);

/// The numbers of an accessor of a glTF document: elements of 1 to 4 components each. There are no elements where they
/// cannot be read: a missing part, an accessor that is a matrix or sparse, or data that ends too early.
/// Source: glTF 2.0 specification, sections 3.6.2 and 5.1.
class GltfNumbers {
 public:
  /// `buffers` are the contents of the document's buffers. They must outlive this object.
  GltfNumbers(const nlohmann::json& document, const std::vector<std::string>& buffers,
              std::optional<std::uint64_t> accessor);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] std::uint64_t components() const { return components_; }

  /// A number as it is stored.
  [[nodiscard]] double value(std::uint64_t element, std::uint64_t component) const;
  /// The same, but whole numbers as shares of the largest one, -1 to 1.
  [[nodiscard]] double share(std::uint64_t element, std::uint64_t component) const;

 private:
  const char* data_ = nullptr;
  std::uint64_t components_ = 0;
  double (*read_)(const char*) = nullptr;  ///< of a component
  std::uint64_t componentBytes_ = 0;
  double one_ = 1.0;  ///< the stored number that stands for 1
  std::uint64_t count_ = 0;
  std::uint64_t stride_ = 0;
};

}  // namespace drape::io
