#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <vector>

namespace drape::bench {

/// XPBD in its simplest form: float, arrays of structs, the springs in the order of their colours, a scalar loop
/// without intrinsics. It is the yardstick for other times.
class PlainXpbd {
 public:
  explicit PlainXpbd(const sim::ClothModel& model);

  void load(const sim::ClothModel& model, const sim::ClothState& state);

  /// One iteration over all springs (Macklin, Mueller, Chentanez 2016, eqs. 17 and 18). @param inverseCompliance h^2 k
  void iterate(float inverseCompliance);

 private:
  struct Vertex {
    float x, y, z;
    float inverseMass;
  };
  struct Constraint {
    int a, b;
    float restLength;
    float multiplier;
  };

  std::vector<Vertex> vertices_;
  std::vector<Constraint> constraints_;
};

}  // namespace drape::bench
