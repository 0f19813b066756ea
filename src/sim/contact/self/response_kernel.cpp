// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/contact/self/response_kernel.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "sim/contact/self/response.hpp"
#include "sim/simd/lanes-inl.hpp"

#include <hwy/highway.h>
#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace drape::sim::contact::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace lanes = simd::HWY_NAMESPACE;

using F = lanes::LanesOf<float>;
using I = hn::Rebind<std::int32_t, F>;
using Vectors = lanes::Lanes3<F>;

HWY_INLINE Vectors between(const PositionLanes& positions, hn::Vec<I> a, hn::Vec<I> b) {
  const F d;
  return {hn::Sub(hn::GatherIndex(d, positions.x.data(), b), hn::GatherIndex(d, positions.x.data(), a)),
          hn::Sub(hn::GatherIndex(d, positions.y.data(), b), hn::GatherIndex(d, positions.y.data(), a)),
          hn::Sub(hn::GatherIndex(d, positions.z.data(), b), hn::GatherIndex(d, positions.z.data(), a))};
}

/// Appends to contacts, whose capacity must suffice.
class Collector {
 public:
  Collector(const PositionLanes& startPositions, const PositionLanes& positions,
            const std::vector<float>& inverseMasses, float thickness, ContactLanes& contacts)
      : startPositions_(startPositions),
        positions_(positions),
        inverseMasses_(inverseMasses),
        thickness_(thickness),
        to_(contacts) {}

  /// Takes as many pairs as there are lanes; only the first `count` are valid.
  HWY_INLINE void take(const VertexPair* pairs, int count) {
    const F d;
    const I di;
    std::array<std::int32_t, maxLanes> first{};
    std::array<std::int32_t, maxLanes> second{};
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
      first[lane] = pairs[lane].a;
      second[lane] = pairs[lane].b;
    }
    const auto a = hn::LoadU(di, first.data());
    const auto b = hn::LoadU(di, second.data());
    const Vectors offset = between(positions_, a, b);
    const Vectors was = between(startPositions_, a, b);
    const float searchDistance = closeMargin * thickness_;
    const auto near = hn::Or(hn::Lt(lanes::dot<F>(offset, offset), hn::Set(d, searchDistance * searchDistance)),
                             hn::Lt(lanes::dot<F>(offset, was), hn::Zero(d)));
    const auto meant = hn::And(near, hn::FirstN(d, static_cast<std::size_t>(count)));
    if (hn::AllFalse(d, meant)) {
      return;
    }
    const auto squared = lanes::dot<F>(was, was);
    const auto inverseMass =
        hn::Add(hn::GatherIndex(d, inverseMasses_.data(), a), hn::GatherIndex(d, inverseMasses_.data(), b));
    const auto usable = hn::And(hn::Gt(squared, hn::Set(d, minSquaredDistance)), hn::Gt(inverseMass, hn::Zero(d)));
    put(hn::And(meant, usable), a, b, offset, was, hn::Sqrt(squared), inverseMass);
  }

  /// Pads the colour to a whole vector with contacts without vertices.
  void fillUp(std::int32_t outside) {
    while (to_.count % maxLanes != 0) {
      const auto at = static_cast<std::size_t>(to_.count++);
      to_.a[at] = outside;
      to_.b[at] = outside;
      to_.normalX[at] = 1.0F;
      to_.offsetX[at] = 1.0F;
      for (auto* part : {&to_.normalY, &to_.normalZ, &to_.offsetY, &to_.offsetZ, &to_.minDistance, &to_.mass,
                         &to_.normalImpulse, &to_.frictionX, &to_.frictionY, &to_.frictionZ}) {
        (*part)[at] = 0.0F;
      }
    }
  }

  [[nodiscard]] bool overlap() const { return overlap_; }

 private:
  /// Minimum squared distance of two vertices whose direction is meaningful [m^2].
  static constexpr float minSquaredDistance = 1e-14F;

  HWY_INLINE void put(hn::Mask<F> mask, hn::Vec<I> a, hn::Vec<I> b, const Vectors& offset, const Vectors& was,
                      hn::Vec<F> distance, hn::Vec<F> inverseMass) {
    const F d;
    const I di;
    const auto thickness = hn::Set(d, thickness_);
    const auto inverse = hn::Div(hn::Set(d, 1.0F), distance);
    const auto zero = hn::Zero(d);
    const auto at = static_cast<std::size_t>(to_.count);
    const auto store = [&](hn::Vec<F> value, std::vector<float>& to) {
      hn::CompressStore(value, mask, d, to.data() + at);
    };
    hn::CompressStore(a, hn::RebindMask(di, mask), di, to_.a.data() + at);
    hn::CompressStore(b, hn::RebindMask(di, mask), di, to_.b.data() + at);
    store(hn::Mul(was.x, inverse), to_.normalX);
    store(hn::Mul(was.y, inverse), to_.normalY);
    store(hn::Mul(was.z, inverse), to_.normalZ);
    store(offset.x, to_.offsetX);
    store(offset.y, to_.offsetY);
    store(offset.z, to_.offsetZ);
    store(hn::Min(thickness, distance), to_.minDistance);
    store(hn::Div(hn::Set(d, 1.0F), inverseMass), to_.mass);
    for (auto* part : {&to_.normalImpulse, &to_.frictionX, &to_.frictionY, &to_.frictionZ}) {
      hn::StoreU(zero, d, part->data() + at);
    }
    to_.count += static_cast<int>(hn::CountTrue(d, mask));
    overlap_ = overlap_ || !hn::AllFalse(d, hn::And(mask, hn::Lt(distance, thickness)));
  }

  const PositionLanes& startPositions_;
  const PositionLanes& positions_;
  const std::vector<float>& inverseMasses_;
  float thickness_;
  ContactLanes& to_;
  bool overlap_ = false;
};

bool collect(const ColouredPairs& pairs, const PositionLanes& startPositions, const PositionLanes& positions,
             const std::vector<float>& inverseMasses, float thickness, ContactLanes& contacts) {
  const int lanes = static_cast<int>(hn::Lanes(F()));
  contacts.resize(static_cast<std::size_t>(pairs.count()) + (pairs.colourCount() + 2) * maxLanes);
  contacts.count = 0;
  Collector collector(startPositions, positions, inverseMasses, thickness, contacts);
  const auto outside = static_cast<std::int32_t>(inverseMasses.size()) - 1 - maxLanes;
  for (std::size_t c = 0; c < pairs.colourCount(); ++c) {
    const std::span<const VertexPair> colour = pairs.colour(c);
    const int count = static_cast<int>(colour.size());
    for (int i = 0; i < count; i += lanes) {
      collector.take(colour.data() + i, std::min(lanes, count - i));
    }
    collector.fillUp(outside);
  }
  return collector.overlap();
}

HWY_INLINE Vectors loadVectors(const std::vector<float>& x, const std::vector<float>& y, const std::vector<float>& z,
                               std::size_t at) {
  const F d;
  return {hn::LoadU(d, x.data() + at), hn::LoadU(d, y.data() + at), hn::LoadU(d, z.data() + at)};
}

/// Updates the impulses of one vector of contacts. Returns their displacements along their normals.
HWY_INLINE hn::Vec<F> visit(const Friction& friction, ContactLanes& contacts, std::size_t at, float* displacements) {
  const F d;
  const lanes::Lanes4<F> a = lanes::fetch4(d, displacements, contacts.a.data() + at);
  const lanes::Lanes4<F> b = lanes::fetch4(d, displacements, contacts.b.data() + at);
  const Vectors n = loadVectors(contacts.normalX, contacts.normalY, contacts.normalZ, at);
  const Vectors solved = loadVectors(contacts.offsetX, contacts.offsetY, contacts.offsetZ, at);
  const Vectors offset = lanes::add<F>(solved, Vectors{hn::Sub(b.x, a.x), hn::Sub(b.y, a.y), hn::Sub(b.z, a.z)});
  const auto zero = hn::Zero(d);
  const auto mass = hn::LoadU(d, contacts.mass.data() + at);
  const auto minDistance = hn::LoadU(d, contacts.minDistance.data() + at);
  const auto along = lanes::dot<F>(offset, n);
  const Vectors across = lanes::multiplyAdd<F>(n, hn::Neg(along), offset);
  const auto left = hn::NegMulAdd(minDistance, minDistance, lanes::dot<F>(across, across));  // l^2 - T^2
  // No constraint if they are side by side, |l| >= T.
  const auto minNormal = hn::IfThenElse(hn::Lt(left, zero), hn::Sqrt(hn::Max(zero, hn::Neg(left))), along);
  const auto previousNormal = hn::LoadU(d, contacts.normalImpulse.data() + at);
  const auto normalImpulse = hn::Max(zero, hn::MulAdd(mass, hn::Sub(minNormal, along), previousNormal));
  const Vectors previousFriction = loadVectors(contacts.frictionX, contacts.frictionY, contacts.frictionZ, at);
  Vectors frictionImpulse = lanes::multiplyAdd<F>(across, hn::Neg(mass), previousFriction);
  const auto size = hn::Sqrt(lanes::dot<F>(frictionImpulse, frictionImpulse));
  const auto slides = hn::Gt(size, hn::Mul(normalImpulse, hn::Set(d, friction.staticCoefficient)));
  const auto limit =
      hn::Div(hn::Mul(normalImpulse, hn::Set(d, friction.kineticCoefficient)), hn::Max(size, hn::Set(d, 1e-30F)));
  frictionImpulse = lanes::scaled<F>(frictionImpulse, hn::IfThenElse(slides, limit, hn::Set(d, 1.0F)));
  const Vectors impulse = lanes::multiplyAdd<F>(n, hn::Sub(normalImpulse, previousNormal),
                                                lanes::subtract<F>(frictionImpulse, previousFriction));
  lanes::store4(d,
                lanes::Lanes4<F>{hn::NegMulAdd(a.w, impulse.x, a.x), hn::NegMulAdd(a.w, impulse.y, a.y),
                                 hn::NegMulAdd(a.w, impulse.z, a.z), a.w},
                displacements, contacts.a.data() + at);
  lanes::store4(d,
                lanes::Lanes4<F>{hn::MulAdd(b.w, impulse.x, b.x), hn::MulAdd(b.w, impulse.y, b.y),
                                 hn::MulAdd(b.w, impulse.z, b.z), b.w},
                displacements, contacts.b.data() + at);
  hn::StoreU(normalImpulse, d, contacts.normalImpulse.data() + at);
  hn::StoreU(frictionImpulse.x, d, contacts.frictionX.data() + at);
  hn::StoreU(frictionImpulse.y, d, contacts.frictionY.data() + at);
  hn::StoreU(frictionImpulse.z, d, contacts.frictionZ.data() + at);
  return hn::Abs(hn::Mul(hn::Sub(normalImpulse, previousNormal), hn::Add(a.w, b.w)));
}

float sweep(const Friction& friction, ContactLanes& contacts, std::vector<float>& displacements) {
  const F d;
  auto maximum = hn::Zero(d);
  for (int i = 0; i < contacts.count; i += static_cast<int>(hn::Lanes(d))) {
    maximum = hn::Max(maximum, visit(friction, contacts, static_cast<std::size_t>(i), displacements.data()));
  }
  return hn::GetLane(hn::MaxOfLanes(d, maximum));
}

void pushOut(float thickness, float share, const ContactLanes& contacts, const std::vector<float>& displacements,
             std::vector<float>& pushOuts) {
  const F d;
  const auto whole = hn::Set(d, thickness);
  for (int i = 0; i < contacts.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto at = static_cast<std::size_t>(i);
    const std::int32_t* const a = contacts.a.data() + at;
    const std::int32_t* const b = contacts.b.data() + at;
    const lanes::Lanes4<F> movedA = lanes::fetch4(d, displacements.data(), a);
    const lanes::Lanes4<F> movedB = lanes::fetch4(d, displacements.data(), b);
    const lanes::Lanes4<F> pushedA = lanes::fetch4(d, pushOuts.data(), a);
    const lanes::Lanes4<F> pushedB = lanes::fetch4(d, pushOuts.data(), b);
    Vectors offset = loadVectors(contacts.offsetX, contacts.offsetY, contacts.offsetZ, at);
    offset = lanes::add<F>(
        offset, Vectors{hn::Sub(movedB.x, movedA.x), hn::Sub(movedB.y, movedA.y), hn::Sub(movedB.z, movedA.z)});
    offset = lanes::add<F>(
        offset, Vectors{hn::Sub(pushedB.x, pushedA.x), hn::Sub(pushedB.y, pushedA.y), hn::Sub(pushedB.z, pushedA.z)});
    const auto distance = hn::Sqrt(lanes::dot<F>(offset, offset));
    const auto wanted =
        hn::And(hn::And(hn::Lt(hn::LoadU(d, contacts.minDistance.data() + at), whole), hn::Lt(distance, whole)),
                hn::Gt(distance, hn::Set(d, 1e-7F)));
    const auto size = hn::Mul(hn::Set(d, share), hn::Mul(hn::LoadU(d, contacts.mass.data() + at),
                                                         hn::Div(hn::Sub(whole, distance), distance)));
    const auto strength = hn::IfThenElseZero(wanted, size);
    const auto forA = hn::Mul(strength, pushedA.w);
    const auto forB = hn::Mul(strength, pushedB.w);
    lanes::store4(d,
                  lanes::Lanes4<F>{hn::NegMulAdd(forA, offset.x, pushedA.x), hn::NegMulAdd(forA, offset.y, pushedA.y),
                                   hn::NegMulAdd(forA, offset.z, pushedA.z), pushedA.w},
                  pushOuts.data(), a);
    lanes::store4(d,
                  lanes::Lanes4<F>{hn::MulAdd(forB, offset.x, pushedB.x), hn::MulAdd(forB, offset.y, pushedB.y),
                                   hn::MulAdd(forB, offset.z, pushedB.z), pushedB.w},
                  pushOuts.data(), b);
  }
}

}  // namespace drape::sim::contact::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::sim::contact {

HWY_EXPORT(collect);
HWY_EXPORT(sweep);
HWY_EXPORT(pushOut);

bool collectContacts(const ColouredPairs& pairs, const PositionLanes& startPositions, const PositionLanes& positions,
                     const std::vector<float>& inverseMasses, float thickness, ContactLanes& contacts) {
  return HWY_DYNAMIC_DISPATCH(collect)(pairs, startPositions, positions, inverseMasses, thickness, contacts);
}

float sweepContacts(const Friction& friction, ContactLanes& contacts, std::vector<float>& displacements) {
  return HWY_DYNAMIC_DISPATCH(sweep)(friction, contacts, displacements);
}

void pushOutContacts(float thickness, float share, const ContactLanes& contacts,
                     const std::vector<float>& displacements, std::vector<float>& pushOuts) {
  HWY_DYNAMIC_DISPATCH(pushOut)(thickness, share, contacts, displacements, pushOuts);
}

}  // namespace drape::sim::contact
#endif
