#include "sim/model/cloth_state.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

namespace drape::sim {
namespace {

// FNV-1a (Fowler, Noll, Vo), byte by byte. Session logs and the documentation contain its values, so they must not
// change.
constexpr std::uint64_t fnvOffset = 14695981039346656037ULL;
constexpr std::uint64_t fnvPrime = 1099511628211ULL;

std::uint64_t hashVectors(std::uint64_t hash, const std::vector<Vec3>& vectors) {
  for (const Vec3& vector : vectors) {
    std::array<unsigned char, sizeof(double) * 3> bytes{};
    std::memcpy(bytes.data(), vector.data(), bytes.size());
    for (const unsigned char byte : bytes) {
      hash = (hash ^ byte) * fnvPrime;
    }
  }
  return hash;
}

/// Larger numbers count as not finite: while a cloth blows up, its numbers can be finite but their squares are not.
constexpr double maxFinite = 1e15;

}  // namespace

ClothState stateAtRest(std::vector<Vec3> positions) {
  ClothState state;
  state.velocities.assign(positions.size(), Vec3::Zero());
  state.positions = std::move(positions);
  return state;
}

// Every comparison with NaN is false. All values are counted, without an early end, so that the compiler can use vector
// instructions.
bool areWithin(const std::vector<Vec3>& vectors, double limit) {
  const double* const values = vectors.empty() ? nullptr : vectors.front().data();
  std::size_t within = 0;
  for (std::size_t i = 0; i < 3 * vectors.size(); ++i) {
    within += std::abs(values[i]) <= limit ? 1 : 0;
  }
  return within == 3 * vectors.size();
}

bool isFinite(const ClothState& state) {
  return areWithin(state.positions, maxFinite) && areWithin(state.velocities, maxFinite);
}

void movePins(const std::vector<bool>& pinned, const Vec3& by, ClothState& state) {
  state.hasNoSelfIntersection = false;
  for (std::size_t v = 0; v < pinned.size(); ++v) {
    if (pinned[v]) {
      state.positions[v] += by;
    }
  }
}

std::uint64_t stateHash(const ClothState& state) {
  return hashVectors(hashVectors(fnvOffset, state.positions), state.velocities);
}

std::string toHex(std::uint64_t hash) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text(16, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, hash >>= 4U) {
    *digit = digits[hash & 0xFU];
  }
  return text;
}

}  // namespace drape::sim
