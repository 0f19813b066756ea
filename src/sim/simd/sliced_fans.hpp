#pragma once

#include "sim/simd/sliced_fabric.hpp"

namespace drape::sim::simd {

/// Adds the fans of the vertices of a slice to a sliced fabric: its spokes and sectors. Call it for one slice after the
/// other. @param model must have a fabric
template <typename T>
void addFansOfSlice(const ClothModel& model, const SliceLayout& layout, int slice, SlicedFabric<T>& fabric);

}  // namespace drape::sim::simd
