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
namespace drape::HWY_NAMESPACE {

using F = LanesOf<float>;
using I = hn::Rebind<std::int32_t, F>;
using Vectors = Lanes3<F>;

HWY_INLINE Vectors between(const PlaceLanes& places, hn::Vec<I> a, hn::Vec<I> b) {
  const F d;
  return {hn::Sub(hn::GatherIndex(d, places.x.data(), b), hn::GatherIndex(d, places.x.data(), a)),
          hn::Sub(hn::GatherIndex(d, places.y.data(), b), hn::GatherIndex(d, places.y.data(), a)),
          hn::Sub(hn::GatherIndex(d, places.z.data(), b), hn::GatherIndex(d, places.z.data(), a))};
}

/// Appends to contacts, which have room.
class Collector {
 public:
  Collector(const PlaceLanes& before, const PlaceLanes& places, const std::vector<float>& inverseMasses,
            float thickness, ContactLanes& contacts)
      : before_(before), places_(places), inverseMasses_(inverseMasses), thickness_(thickness), to_(contacts) {}

  /// As many pairs as there are lanes, of which the first `count` are meant.
  HWY_INLINE void take(const VertexPair* pairs, int count) {
    const F d;
    const I di;
    std::array<std::int32_t, mostLanes> first{};
    std::array<std::int32_t, mostLanes> second{};
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
      first[lane] = pairs[lane].a;
      second[lane] = pairs[lane].b;
    }
    const auto a = hn::LoadU(di, first.data());
    const auto b = hn::LoadU(di, second.data());
    const Vectors offset = between(places_, a, b);
    const Vectors was = between(before_, a, b);
    const float look = closeMargin * thickness_;
    const auto near =
        hn::Or(hn::Lt(dot<F>(offset, offset), hn::Set(d, look * look)), hn::Lt(dot<F>(offset, was), hn::Zero(d)));
    const auto meant = hn::And(near, hn::FirstN(d, static_cast<std::size_t>(count)));
    if (hn::AllFalse(d, meant)) {
      return;
    }
    const auto squared = dot<F>(was, was);
    const auto inverseMass =
        hn::Add(hn::GatherIndex(d, inverseMasses_.data(), a), hn::GatherIndex(d, inverseMasses_.data(), b));
    const auto usable = hn::And(hn::Gt(squared, hn::Set(d, leastSquared)), hn::Gt(inverseMass, hn::Zero(d)));
    put(hn::And(meant, usable), a, b, offset, was, hn::Sqrt(squared), inverseMass);
  }

  /// Fills the colour up to a whole vector by contacts of nothing with nothing.
  void fillUp(std::int32_t outside) {
    while (to_.count % mostLanes != 0) {
      const auto at = static_cast<std::size_t>(to_.count++);
      to_.a[at] = outside;
      to_.b[at] = outside;
      to_.nx[at] = 1.0F;
      to_.ox[at] = 1.0F;
      for (auto* part :
           {&to_.ny, &to_.nz, &to_.oy, &to_.oz, &to_.apart, &to_.mass, &to_.press, &to_.rubX, &to_.rubY, &to_.rubZ}) {
        (*part)[at] = 0.0F;
      }
    }
  }

  [[nodiscard]] bool overlap() const { return overlap_; }

 private:
  /// Below this square of their distance [m^2] two vertices have no direction that means anything.
  static constexpr float leastSquared = 1e-14F;

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
    store(hn::Mul(was.x, inverse), to_.nx);
    store(hn::Mul(was.y, inverse), to_.ny);
    store(hn::Mul(was.z, inverse), to_.nz);
    store(offset.x, to_.ox);
    store(offset.y, to_.oy);
    store(offset.z, to_.oz);
    store(hn::Min(thickness, distance), to_.apart);
    store(hn::Div(hn::Set(d, 1.0F), inverseMass), to_.mass);
    for (auto* part : {&to_.press, &to_.rubX, &to_.rubY, &to_.rubZ}) {
      hn::StoreU(zero, d, part->data() + at);
    }
    to_.count += static_cast<int>(hn::CountTrue(d, mask));
    overlap_ = overlap_ || !hn::AllFalse(d, hn::And(mask, hn::Lt(distance, thickness)));
  }

  const PlaceLanes& before_;
  const PlaceLanes& places_;
  const std::vector<float>& inverseMasses_;
  float thickness_;
  ContactLanes& to_;
  bool overlap_ = false;
};

bool collect(const ColouredPairs& pairs, const PlaceLanes& before, const PlaceLanes& places,
             const std::vector<float>& inverseMasses, float thickness, ContactLanes& contacts) {
  const int lanes = static_cast<int>(hn::Lanes(F()));
  const std::size_t colours = pairs.begin.empty() ? 0 : pairs.begin.size() - 1;
  contacts.resize(static_cast<std::size_t>(pairs.count()) + (colours + 2) * mostLanes);
  contacts.begin.assign(1, 0);
  contacts.count = 0;
  Collector collector(before, places, inverseMasses, thickness, contacts);
  const auto outside = static_cast<std::int32_t>(inverseMasses.size()) - 1 - mostLanes;
  for (std::size_t c = 0; c < colours; ++c) {
    for (int i = pairs.begin[c]; i < pairs.begin[c + 1]; i += lanes) {
      collector.take(pairs.pairs.data() + i, std::min(lanes, pairs.begin[c + 1] - i));
    }
    collector.fillUp(outside);
    contacts.begin.push_back(contacts.count);
  }
  return collector.overlap();
}

HWY_INLINE Vectors loadVectors(const std::vector<float>& x, const std::vector<float>& y, const std::vector<float>& z,
                               std::size_t at) {
  const F d;
  return {hn::LoadU(d, x.data() + at), hn::LoadU(d, y.data() + at), hn::LoadU(d, z.data() + at)};
}

/// The impulses of as many contacts as there are lanes. Returns by how much they move along their normals.
HWY_INLINE hn::Vec<F> visit(const Friction& friction, ContactLanes& contacts, std::size_t at, float* moves) {
  const F d;
  const Lanes4<F> a = fetch4(d, moves, contacts.a.data() + at);
  const Lanes4<F> b = fetch4(d, moves, contacts.b.data() + at);
  const Vectors n = loadVectors(contacts.nx, contacts.ny, contacts.nz, at);
  const Vectors solved = loadVectors(contacts.ox, contacts.oy, contacts.oz, at);
  const Vectors offset = add<F>(solved, Vectors{hn::Sub(b.x, a.x), hn::Sub(b.y, a.y), hn::Sub(b.z, a.z)});
  const auto zero = hn::Zero(d);
  const auto mass = hn::LoadU(d, contacts.mass.data() + at);
  const auto apart = hn::LoadU(d, contacts.apart.data() + at);
  const auto along = dot<F>(offset, n);
  const Vectors across = multiplyAdd<F>(n, hn::Neg(along), offset);
  const auto left = hn::NegMulAdd(apart, apart, dot<F>(across, across));  // l^2 - T^2
  // Beside each other nothing is asked for.
  const auto least = hn::IfThenElse(hn::Lt(left, zero), hn::Sqrt(hn::Max(zero, hn::Neg(left))), along);
  const auto before = hn::LoadU(d, contacts.press.data() + at);
  const auto press = hn::Max(zero, hn::MulAdd(mass, hn::Sub(least, along), before));
  const Vectors rubbed = loadVectors(contacts.rubX, contacts.rubY, contacts.rubZ, at);
  Vectors rub = multiplyAdd<F>(across, hn::Neg(mass), rubbed);
  const auto size = hn::Sqrt(dot<F>(rub, rub));
  const auto slides = hn::Gt(size, hn::Mul(press, hn::Set(d, friction.atRest)));
  const auto limit = hn::Div(hn::Mul(press, hn::Set(d, friction.sliding)), hn::Max(size, hn::Set(d, 1e-30F)));
  rub = scaled<F>(rub, hn::IfThenElse(slides, limit, hn::Set(d, 1.0F)));
  const Vectors impulse = multiplyAdd<F>(n, hn::Sub(press, before), subtract<F>(rub, rubbed));
  store4(d,
         Lanes4<F>{hn::NegMulAdd(a.w, impulse.x, a.x), hn::NegMulAdd(a.w, impulse.y, a.y),
                   hn::NegMulAdd(a.w, impulse.z, a.z), a.w},
         moves, contacts.a.data() + at);
  store4(
      d,
      Lanes4<F>{hn::MulAdd(b.w, impulse.x, b.x), hn::MulAdd(b.w, impulse.y, b.y), hn::MulAdd(b.w, impulse.z, b.z), b.w},
      moves, contacts.b.data() + at);
  hn::StoreU(press, d, contacts.press.data() + at);
  hn::StoreU(rub.x, d, contacts.rubX.data() + at);
  hn::StoreU(rub.y, d, contacts.rubY.data() + at);
  hn::StoreU(rub.z, d, contacts.rubZ.data() + at);
  return hn::Abs(hn::Mul(hn::Sub(press, before), hn::Add(a.w, b.w)));
}

float sweep(const Friction& friction, ContactLanes& contacts, std::vector<float>& moves) {
  const F d;
  auto most = hn::Zero(d);
  for (int i = 0; i < contacts.count; i += static_cast<int>(hn::Lanes(d))) {
    most = hn::Max(most, visit(friction, contacts, static_cast<std::size_t>(i), moves.data()));
  }
  return hn::GetLane(hn::MaxOfLanes(d, most));
}

void push(float thickness, float share, const ContactLanes& contacts, const std::vector<float>& moves,
          std::vector<float>& pushes) {
  const F d;
  const auto whole = hn::Set(d, thickness);
  for (int i = 0; i < contacts.count; i += static_cast<int>(hn::Lanes(d))) {
    const auto at = static_cast<std::size_t>(i);
    const std::int32_t* const a = contacts.a.data() + at;
    const std::int32_t* const b = contacts.b.data() + at;
    const Lanes4<F> movedA = fetch4(d, moves.data(), a);
    const Lanes4<F> movedB = fetch4(d, moves.data(), b);
    const Lanes4<F> pushedA = fetch4(d, pushes.data(), a);
    const Lanes4<F> pushedB = fetch4(d, pushes.data(), b);
    Vectors offset = loadVectors(contacts.ox, contacts.oy, contacts.oz, at);
    offset =
        add<F>(offset, Vectors{hn::Sub(movedB.x, movedA.x), hn::Sub(movedB.y, movedA.y), hn::Sub(movedB.z, movedA.z)});
    offset = add<F>(
        offset, Vectors{hn::Sub(pushedB.x, pushedA.x), hn::Sub(pushedB.y, pushedA.y), hn::Sub(pushedB.z, pushedA.z)});
    const auto distance = hn::Sqrt(dot<F>(offset, offset));
    const auto wanted =
        hn::And(hn::And(hn::Lt(hn::LoadU(d, contacts.apart.data() + at), whole), hn::Lt(distance, whole)),
                hn::Gt(distance, hn::Set(d, 1e-7F)));
    const auto size = hn::Mul(hn::Set(d, share), hn::Mul(hn::LoadU(d, contacts.mass.data() + at),
                                                         hn::Div(hn::Sub(whole, distance), distance)));
    const auto strength = hn::IfThenElseZero(wanted, size);
    const auto forA = hn::Mul(strength, pushedA.w);
    const auto forB = hn::Mul(strength, pushedB.w);
    store4(d,
           Lanes4<F>{hn::NegMulAdd(forA, offset.x, pushedA.x), hn::NegMulAdd(forA, offset.y, pushedA.y),
                     hn::NegMulAdd(forA, offset.z, pushedA.z), pushedA.w},
           pushes.data(), a);
    store4(d,
           Lanes4<F>{hn::MulAdd(forB, offset.x, pushedB.x), hn::MulAdd(forB, offset.y, pushedB.y),
                     hn::MulAdd(forB, offset.z, pushedB.z), pushedB.w},
           pushes.data(), b);
  }
}

}  // namespace drape::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape {

HWY_EXPORT(collect);
HWY_EXPORT(sweep);
HWY_EXPORT(push);

bool collectContacts(const ColouredPairs& pairs, const PlaceLanes& before, const PlaceLanes& places,
                     const std::vector<float>& inverseMasses, float thickness, ContactLanes& contacts) {
  return HWY_DYNAMIC_DISPATCH(collect)(pairs, before, places, inverseMasses, thickness, contacts);
}

float sweepContacts(const Friction& friction, ContactLanes& contacts, std::vector<float>& moves) {
  return HWY_DYNAMIC_DISPATCH(sweep)(friction, contacts, moves);
}

void pushContacts(float thickness, float share, const ContactLanes& contacts, const std::vector<float>& moves,
                  std::vector<float>& pushes) {
  HWY_DYNAMIC_DISPATCH(push)(thickness, share, contacts, moves, pushes);
}

}  // namespace drape
#endif
