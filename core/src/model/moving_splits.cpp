// SPDX-License-Identifier: Apache-2.0
#include "model/moving_splits.hpp"

#include "model/contact_directions.hpp"
#include "model/mapped_motor.hpp"
#include "model/track.hpp"
#include "model/zone_splits.hpp"

namespace twum::inline v0_1::core {
namespace {

using contact::MotionDual;

constexpr int kAlong = 0;  // direction of a split's place

// The scalar of the margin that goes with one of the motor.
template <typename S>
struct MarginScalar {
  using Outer = contact::WithState<contact::NumbersDual>::Type;
};
template <>
struct MarginScalar<ModelDual2> {
  using Outer = contact::NumbersDual2;
};

// The margin of the contact at a split (W4.5).
template <typename S>
S margin_at(const DrivenMotor<S>& m, const S& speed, const SplitPlace<S>& split,
            const contact::Jump& jump) {
  const Piece<S>& piece = m.pieces[split.piece];
  const S place = split.place + jump.beside * kBesideJump;
  const S radius = piece.low + place * (piece.high - piece.low);
  const contact::ContactNumbers<S> n = contact_numbers(m, slice_at(m, radius, m.b), speed);
  return chained(contact::jump_margin(seeded<typename MarginScalar<S>::Outer>(n), jump), listed(n));
}

}  // namespace

template <typename S>
Vector<SplitPlace<S>> moving_splits(const DrivenMotor<S>& m, const S& speed,
                                    std::span<const Split> splits) {
  Vector<SplitPlace<S>> places;
  std::optional<DrivenMotor<MotionDual>> still;
  for (const Split& split : splits) {
    SplitPlace<S> at{split.piece, S(split.place), split.gap};
    if (split.jump) {
      if (!still) still = mapped<MotionDual>(m, [](const S& x) { return MotionDual(value_of(x)); });
      const MotionDual along = MotionDual::variable(split.place, kAlong);
      const double slope = margin_at<MotionDual>(*still, MotionDual(value_of(speed)),
                                                 {split.piece, along}, *split.jump)
                               .d[kAlong];
      for (int i = 0; i < kDualDepth<S>; ++i) {
        const S margin = margin_at(m, speed, at, *split.jump);
        at.place = with_value(S(at.place - with_value(margin, 0.0) / slope), split.place);
      }
    }
    places.push_back(at);
  }
  return places;
}

template Vector<SplitPlace<MotionDual>> moving_splits(const DrivenMotor<MotionDual>&,
                                                      const MotionDual&, std::span<const Split>);
template Vector<SplitPlace<ModelDual>> moving_splits(const DrivenMotor<ModelDual>&,
                                                     const ModelDual&, std::span<const Split>);
template Vector<SplitPlace<ModelDual2>> moving_splits(const DrivenMotor<ModelDual2>&,
                                                      const ModelDual2&, std::span<const Split>);

}  // namespace twum::inline v0_1::core
