#pragma once

#include "scene/found_mesh.hpp"
#include "text/sentence.hpp"

#include <optional>
#include <string>

namespace drape::ui {

/// A mesh file that was dropped on the window, and what it contains.
struct FoundFile {
  std::string file;
  std::optional<scene::FoundMesh> mesh;  ///< empty: it is not read yet, or it cannot be read
  text::Sentence problem;                ///< why it cannot be read; empty if it can
};

}  // namespace drape::ui
