#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace drape::io {

/// The mesh of a glTF file.
struct GltfMesh {
  std::string file;      ///< a glTF file
  bool hasSkin = false;  ///< whether bones move the mesh
};

/// A binary glTF file with only the parts that its mesh is made of (meshPartsOf). Throws InputError when it is cut off,
/// does not match its header, its JSON cannot be read, or its vertices are stored in a way that is not read (Draco
/// and meshopt compression, other files). Source: glTF 2.0 specification, section 4.4 (GLB) and section 3.
[[nodiscard]] GltfMesh glbWithMesh(std::string_view bytes);

/// The same as glbWithMesh for a glTF file of text (plainText), and the text with all buffers inside. Buffers in other
/// files are read from `folder`, and only from there: a name that leads elsewhere is refused, and so is one that the
/// file system resolves to elsewhere. Without a folder every other file is refused.
[[nodiscard]] GltfMesh gltfWithBuffers(std::string_view text, const std::filesystem::path& folder);

/// The text with all buffers inside, like gltfWithBuffers, but with all other parts of the document as they are: its
/// skins and animations too. Only keys that are no straight lines become such (straightenKeys). Throws InputError also
/// as checkSkins.
[[nodiscard]] std::string gltfWithEverything(std::string_view text, const std::filesystem::path& folder);

/// The same for a binary glTF file. Throws InputError also when it is damaged, as glbWithMesh.
[[nodiscard]] std::string glbWithEverything(std::string bytes);

}  // namespace drape::io
