#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace drape::sim {

/// Data that cannot be simulated, as a code with numbers; what() lists them. src/messages makes the sentence.
class SimError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A fault of a cloth's mesh, masses, stiffnesses or pins. Indices count from 0.
class ClothModelError : public SimError {
 public:
  enum class Fault {
    NoTriangle,       ///< the mesh has `count` vertices and `found` triangles
    VertexNotFinite,  ///< vertex `index` has a coordinate that is not a finite number
    NoSuchVertex,     ///< triangle `index` names vertex `found` of `count`
    NoSuchPin,        ///< vertex `index` of `count` is to be pinned
    Mass,             ///< the mass `value` [kg] of the cloth is not positive and finite
    VertexMass,       ///< the mass `value` [kg] of vertex `index` is not positive and finite
    Stiffness,        ///< the relative stiffness `value` [-] of spring `index` is negative or not finite
    MassCount,        ///< there are `found` masses for `count` vertices
    StiffnessCount,   ///< there are `found` stiffnesses for `count` springs
    PinCount,         ///< there are `found` pins for `count` vertices
    ClothCount,       ///< there are `found` numbers of cloths for `count` vertices
    Material,         ///< the fabric's moduli are negative, not finite, or not positive definite
    MaterialsMeet,    ///< vertex `index` has triangles of different materials
    WarpCount,        ///< there are `found` directions of warp for `count` triangles
    PatternCount,     ///< there are `found` triangles of a pattern for `count` triangles
    LengthCount,      ///< there are `found` rest lengths for `count` springs
    AreaCount,        ///< there are `found` areas for `count` vertices
    TooManySprings,   ///< a vertex has more than `count` springs
  };

  /// Numbers of a fault; the others are 0.
  struct Numbers {
    std::int64_t index = 0;  ///< of a vertex, triangle or spring
    std::int64_t found = 0;
    std::int64_t count = 0;
    double value = 0.0;  ///< [kg] or [-]
  };

  ClothModelError(Fault fault, const Numbers& numbers);

  [[nodiscard]] Fault fault() const { return fault_; }
  [[nodiscard]] const Numbers& numbers() const { return numbers_; }

 private:
  Fault fault_;
  Numbers numbers_;
};

/// There is no solver of that name.
class UnknownSolver : public SimError {
 public:
  explicit UnknownSolver(std::string_view name);

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// The solver of that name cannot move a cloth with a fabric.
class NoFabricSolver : public SimError {
 public:
  explicit NoFabricSolver(std::string_view name);

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
};

}  // namespace drape::sim
