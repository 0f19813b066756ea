#pragma once

#include "sim/model/vector.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace drape::io {

/// The positions of the vertices of a mesh at several times.
struct PointCache {
  std::vector<double> times;                         ///< of the frames [s]; ascending, the first one is 0
  std::vector<std::vector<Eigen::Vector3f>> frames;  ///< one position per vertex of the mesh's file, in its unit
};

/// Whether the file's extension, in any case, is that of a vertex cache: .pc2 or .mdd.
[[nodiscard]] bool isPointCache(const std::filesystem::path& file);

/// Whether the file's format contains the times of its frames, as MDD does.
[[nodiscard]] bool hasOwnTimes(const std::filesystem::path& file);

/// Reads a vertex cache: PC2 of 3ds Max, whose frames are numbered, or MDD of LightWave, which has times. Throws
/// InputError with the name of the file when it is missing, too large, of another format or cut off, has no frames, has
/// another number of vertices, positions that are no finite numbers, or times that do not increase.
/// @param vertices of the file of its mesh  @param rate of a PC2, frames per second [1/s]
[[nodiscard]] PointCache importPointCache(const std::filesystem::path& file, std::size_t vertices, double rate);

}  // namespace drape::io
