#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/solvers/step_parameters.hpp"

#include <memory>

namespace drape::bench {

using ModelPtr = std::shared_ptr<const sim::ClothModel>;

/// A sheet of 1 m x 1 m and 0.1 kg with n x n vertices in rows, one diagonal a quad, pinned at two corners.
[[nodiscard]] sim::ClothMesh gridMesh(int n);
[[nodiscard]] ModelPtr grid(int n);

/// The same sheet, its vertices numbered at random.
[[nodiscard]] ModelPtr shuffledGrid(int n);

/// An irregular sheet: vertices displaced by up to a third of a cell, a random diagonal in each quad (so that vertices
/// have 4 to 8 springs), random numbering.
[[nodiscard]] sim::ClothMesh irregularMesh(int n);
[[nodiscard]] ModelPtr irregularSheet(int n);

/// The built-in T-shirt: 2014 vertices, 5944 springs.
[[nodiscard]] ModelPtr tshirt();

/// A moving state with waves of some centimetres, so that springs are stretched and compressed and no two steps have
/// the same numbers.
[[nodiscard]] sim::ClothState waving(const sim::ClothModel& model);

/// 1/150 s, 10 N/m, gravity.
[[nodiscard]] sim::StepParameters stillAir();

/// The same with damping, drag, lift and wind.
[[nodiscard]] sim::StepParameters fullStep();

}  // namespace drape::bench
