// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace twum::inline v0_1::core {

/// How finely a curve of waves is followed.
struct CurveSteps {
  double longest;  ///< step
  double steep;    ///< step where a fold may be near
  double
      settled;  ///< distance to the predicted wave which a step's length is chosen for, and which is not solved again
  double states;  ///< accuracy of the layer's states
};

/// Every constant of the continuation of waves. Lengths are those of a curve in the plane of ln A and the parameter, both in
/// parts of themselves: a motor changes over lengths of 1.
struct ContinuationRules {
  /// Over the speed. The proof of a point between two waves begins at a cubic through them, whose error goes with the fourth
  /// power of the step: at a 24th it is below what one turn of the layer mends. A wave that Newton's method then moves is right
  /// to the square of `settled`. Two folds of a motor that is about to lose both lie a hundredth of A apart.
  CurveSteps speed{1.0 / 24, 0.01, 3e-4, 1e-9};
  /// Over the voltage at one speed, where each amplitude has one wave: steps of ln A, which are halved where `sure_slope` and
  /// `sure_bend` say. Only extrema and the waves of one voltage are asked, which are found by themselves. The states are crude enough
  /// for a track without splits.
  CurveSteps voltage{0.4, 0.4, 0, 1e-5};
  /// Over the frequency at rest, of which only the folds are asked.
  CurveSteps frequency{0.4, 0.1, 0.01, 1e-7};
  /// The same where H may jump (mu_0 > mu), or have no value: it is sampled.
  double jumping_step = 0.05;
  /// What the slopes of two samples may leave of ln H: the third power of `jumping_step`, times what H bends. More of it is a jump, or
  /// bends so much that it is sampled more closely.
  double jump = 1e-4;
  /// What ln H changes from a sample to the edge of amplitudes without a periodic state, in its slope times the distance: 2 for a root.
  /// Beside it what it bends, in the distance squared: its second difference in steps of 0.02 is below 5 in nine of ten places of 300
  /// random motors with mu_0 > mu, and above 100 at jumps.
  double towards_edge = 3, bend = 100;
  /// What a change of the slope may hide of ln H where zones change.
  double hidden_jump = 5e-4;
  /// Component of the tangent along the parameter below which the curve is steep: a fold is less than a step away.
  double steep = 0.2;
  /// Longest first step, where the next ones may be as long as they like.
  double first_step = 0.1;
  /// Shortest step. What stops the curve on a shorter one is a jump of H.
  double shortest = 1e-8;
  /// The same in parts of a short step: islands may be a ten thousandth of ln A wide.
  double settled_share = 0.01;
  /// Share of the step by which Newton's method may move the predicted wave; farther away lies another curve.
  double straight = 0.25;
  /// Cosine of the angle by which the tangent may turn in a step.
  double turn = 0.9;
  /// What a step of Newton's method with the slopes of four nodes leaves of the guess's error in usual motors. The proof of the
  /// point and the balance of its drive tell where it is more.
  double left_by_turn = 1e-5;
  /// Error of the slope of a cubic of ln H, in the step times the jump of the second derivative from one cubic to the next. A smooth H
  /// leaves a twentieth, a jump of its own second derivative, where a zone begins, at most a fourth.
  double sure_slope = 0.5;
  /// Second derivative whose sign is sure, in such jumps.
  double sure_bend = 4;
  /// Second derivative times the square of a step below which two extrema in it differ by less than a millionth of H.
  double hidden_bend = 4e-6;
  /// Shortest step that is halved: what the states leave of H, over its square, is a doubt of no more than one.
  double closest = 1e-4;
  /// Share of the slopes at both ends of a cubic below which its own slope may change its sign in truth.
  double nearly_flat = 0.3;
  /// Length of a step within which the tangent may turn by any angle: a corner, where a zone begins.
  double corner = 1e-7;
  /// A H_A / H of a node whose sign is not sure: `settled` times what H bends.
  double doubtful = 1e-2;
  /// Error of ln A at a fold, as its torque goes with it; rounding of H_A leaves no less.
  double fold = 1e-12;
  /// Product of the last two secants towards it, which is what they leave but for a factor.
  double last_secants = 1e-15;
  /// Error of ln A where only H at the extremum is asked, which goes with the square.
  double extremum = 1e-7;
  /// Error of ln A of a wave that is asked for. Its torque is off by as much.
  double root = 1e-13;
  /// What rounding leaves of ln H; beside a fold it is all that can be asked.
  double rounding = 4e-15;
  /// The same of a layer that is a million times as stiff in shear as across, where stresses are differences of large numbers. More of
  /// it on both sides of an amplitude is a jump of H.
  double noise = 1e-9;
  /// Accuracy of the layer's states where H has an extremum: it is off by as much, and H by the square.
  double slope_states = 1e-10;
  /// Last secant towards a fold: its cube is below the rounding of H.
  double short_secant = 3e-5;
  /// Factor between the error of a secant and the product of the last two: H bends over amplitudes of its own size.
  double secants = 10;
  /// Distance of two amplitudes beside a kink or a jump of H.
  double kink = 1e-11;
  /// Waves of one curve: a closed one has some hundred.
  int most_nodes = 2000;
  /// Zones of the contact that one curve may follow in a slice, a tenth of a second. Usual motors need a thousand, contacts unlike
  /// any motor millions.
  long most_zones = 500'000;
  /// Steps of Newton's method or secants that one wave may take. Near a solution three are enough, beside a kink halving
  /// takes over.
  int most_tries = 60;
  /// Halvings of a step between whose ends two folds may hide; those of a hundredth of it move no answer.
  int hidden_folds = 6;
  /// Doublings of the interval in which a fold is sought beside a node.
  int most_halvings = 20;
  /// Turns of Newton's method towards a point. More are slower than to solve it by itself.
  int most_turns = 8;
  /// Of the amplitude and of the layer's state: distance from which turns still lead to the wave.
  double far_guess = 1e-2;
  /// Share of the last step that the next one may be; more is slower than to solve the wave by itself.
  double quick = 0.2;
  /// Of the amplitude and of the layer's state: largest error after the last turn.
  double settled_turn = 1e-12;
  /// Of the drive's force: an amplitude right to `settled_turn` leaves less, a zone that is not there far more.
  double balanced = 1e-11;
  /// ln A of two waves that are one; two waves of a speed are farther apart but next to a fold.
  double same = 1e-4;
  /// Factor of the amplitude about a wave within which it is sought at a speed nearby.
  double island = 1.35;
  /// Bits of the speed at which an island is sought; its size goes with the square root of what the drive's force exceeds.
  int island_bits = 20;
  /// Smallest amplitude of a wave that drives, in those at which the contact becomes full or H_hold is.
  double smallest_running = 0.3;
  /// Newton's steps from a fold of one frequency to that of another one, and the longest of them; what needs more is followed as a
  /// curve.
  int most_newtons = 20;
  double longest_newton = 0.7;
  /// Last step of ln (f - f_r); it leaves a hundredth.
  double settled_fold = 1e-9;
  /// Distance in ln A at which H tells a maximum from a minimum.
  double probe = 1e-3;
  /// Of the free resonance: distance from it at which no motor has a fold any more.
  double nearest_frequency = 1e-5;
  /// Bits of a frequency at which the extremum of a force that jumps is the drive's: what the samples of the force tell.
  int jump_bits = 40;
  /// Longest distance over which the branch is sought beyond a jump.
  double longest_leap = 0.1;
  /// Factor of the amplitude to which the last wave of a contact that sticks all round is found.
  double last_locked = 1.5;
  /// Of the speed: width of a piece of the branch below which a motor does not notice it as it pulls out.
  double narrowest = 1e-3;
  /// Pieces into which jumps may cut a branch.
  std::size_t most_pieces = 100;
  /// Largest speed, in crest speeds of the largest wave: no motor drives itself beyond.
  double fastest = 1.3;
  /// Amplitudes beyond those of any motor [m]: where the bounds are infinite, without damping or preload.
  double largest_amplitude = 1, smallest_amplitude = 1e-30;
  /// Speeds up to there at which waves are searched if none runs at rest. An island between two of them shows by the minimum
  /// of H between them.
  int speeds = 32;
};
inline constexpr ContinuationRules kRules{};

/// Every constant of the waves over the drive frequency, whose path is followed over the amplitude (D5.1). Its nodes are neighbours in
/// amplitude and frequency, so that each starts from the one before.
struct ResponseRules {
  /// Waves of a flank. One is sought between two neighbours, which are near enough to start from.
  int flank_nodes = 80;
  /// Factor from amplitude to amplitude where the drive's force is compared with the least that holds a wave.
  double scan = 1.25;
  /// Last step of omega^2 and of the speed ratio, in parts of themselves.
  double settled_square = 1e-14, settled_ratio = 1e-12;
  /// Steps with learned slopes towards a wave: three are usual.
  int most_broydens = 12;
  /// Of the speed ratio: what is farther away from the guess than the sum of the first and a share of the guess is another wave.
  double near_ratio = 0.05, near_share = 0.3;
  /// Share of the guess's slope of the torque below which the torque is about to fold.
  double least_slope = 0.1;
  /// Of the speed ratio, for a difference that only begins a search.
  double slope_step = 1e-5;
  /// Secants over the frequency where no wave nearby is known.
  int most_secants = 40;
  /// Of the speed ratio: where the speed is sought first, about a guess and about the last secant's.
  double far_window = 0.02, near_window = 1e-3;
  /// Speed ratio above which no contact drives, and the step from there down.
  double fastest_sought = 1.5, sought_step = 0.05;
  /// The same backwards: any load turns the rotor back fast under a very small wave.
  double fastest_back = 1e3;
  /// Of the amplitude: a step of which an error remains that is a share of it, with slopes that are right at its begin.
  double near_root = 1e-10;
  /// Steps of the last digits of a wave; three are usual.
  int most_polishes = 12;
  /// Of mu_0 F_N r: a larger residual of the torque is a jump.
  double torque_kept = 1e-9;
  /// Of the range of jumps and resonances, on both sides: how much of a response is shown where no range is given, and the least of it
  /// in parts of the frequency.
  double margin = 0.15, least_margin = 0.01;
  /// Jumps at one frequency: each ends on another piece, and a motor has few.
  int most_jumps = 8;
};
inline constexpr ResponseRules kResponseRules{};

}  // namespace twum::inline v0_1::core
