/* SPDX-License-Identifier: Apache-2.0 */
#include "plant.h"

#include <float.h>
#include <math.h>

#define PI 3.14159265358979323846
#define SQRT2 1.41421356237309504880

static const double kPeriodsPerStep = PLANT_PERIODS_PER_STEP;
/* Speed with which a rotor leaves rest [rad/s]: past the event, and nothing beside any speed. */
static const double kReleaseSpeed = 1e-9;
/* Of the holding torque. Without it a rotor would be caught at the instant of its release. */
static const double kHoldMargin = 1e-6;
/* Events within one step: more means that the rotor rattles between its two sides. */
enum { kMostEvents = 20 };

/* ---- complex numbers, which not every compiler of C has ---- */

typedef struct { double re, im; } Complex;

static Complex complex_of(double re, double im) { Complex z; z.re = re; z.im = im; return z; }
static Complex add(Complex a, Complex b) { return complex_of(a.re + b.re, a.im + b.im); }
static Complex subtract(Complex a, Complex b) { return complex_of(a.re - b.re, a.im - b.im); }
static Complex scaled(double s, Complex a) { return complex_of(s * a.re, s * a.im); }
static Complex times(Complex a, Complex b) { return complex_of(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re); }
static Complex over(Complex a, Complex b) {
  const double size = b.re * b.re + b.im * b.im;
  return complex_of((a.re * b.re + a.im * b.im) / size, (a.im * b.re - a.re * b.im) / size);
}
static double size_of(Complex a) { return hypot(a.re, a.im); }
static Complex turned(Complex a, double angle) { return times(a, complex_of(cos(angle), sin(angle))); }
static Complex zeta_of(const PlantState* s) { return complex_of(s->zeta_real, s->zeta_imaginary); }

/* ---- contact ---- */

/* Values of the contact with their derivatives in amplitude and speed. Torque and speed are in the direction of the wave. */
typedef struct { double value, per_amplitude, per_speed; } Surface;
typedef struct { Surface torque, reactive, active; } Contact;

/* Weights of four neighbours at 0 <= t <= 1 between the second and the third, and their derivatives: the cubic through the two
   whose slopes there are those of their neighbours (Catmull and Rom). */
typedef struct { double of[4], slope[4]; } Weights;

static Weights weights_at(double t) {
  Weights w;
  w.of[0] = 0.5 * t * (-1 + t * (2 - t)), w.slope[0] = 0.5 * (-1 + t * (4 - 3 * t));
  w.of[1] = 0.5 * (2 + t * t * (3 * t - 5)), w.slope[1] = 0.5 * t * (9 * t - 10);
  w.of[2] = 0.5 * t * (1 + t * (4 - 3 * t)), w.slope[2] = 0.5 * (1 + t * (8 - 9 * t));
  w.of[3] = 0.5 * t * t * (t - 1), w.slope[3] = 0.5 * t * (3 * t - 2);
  return w;
}

/* At an edge of the table, where there is no neighbour, the line through the two that there are goes on. */
static void fold_edges(Weights* w, int first, int count) {
  double* of[2];
  int k;
  of[0] = w->of, of[1] = w->slope;
  for (k = 0; k < 2; ++k) {
    if (first < 0) of[k][1] += 2 * of[k][0], of[k][2] -= of[k][0], of[k][0] = 0;
    if (first + 3 >= count) of[k][2] += 2 * of[k][3], of[k][1] -= of[k][3], of[k][3] = 0;
  }
}

/* Where a point lies in the table: its first neighbours, the weights of all, and how fast its place changes. */
typedef struct {
  const PlantContact* table;
  int row, column;
  Weights x, y;
  double x_per_amplitude, y_per_amplitude, y_per_speed;
} Cell;

static int cell_of(double position, int count) {
  const int i = (int)position;
  return i < 0 ? 0 : i > count - 2 ? count - 2 : i;
}

/* `speed` is a size; along says whether it has the wave's direction. */
static Cell cell_at(const PlantData* m, double amplitude, double speed, int along, double omega) {
  const double a1 = m->opening_amplitude, floor_amplitude = 1e-7 * a1;
  const double a = amplitude > floor_amplitude ? amplitude : floor_amplitude;
  const double per_x = (m->amplitudes - 1) / asinh(m->largest_amplitude / a1);
  const double x = per_x * asinh(a / a1);
  const double crest = m->crest_per_amplitude * omega * a;
  const double v = speed / crest, per_y = m->speed_ratios - 1, y = per_y * v / (1 + v);
  const double y_per_v = per_y / ((1 + v) * (1 + v));
  const int j = cell_of(x, m->amplitudes), i = cell_of(y, m->speed_ratios);
  Cell cell;
  cell.table = along ? &m->along : &m->against;
  cell.row = i - 1, cell.column = j - 1;
  cell.x = weights_at(x - j), cell.y = weights_at(y - i);
  fold_edges(&cell.x, cell.column, m->amplitudes);
  fold_edges(&cell.y, cell.row, m->speed_ratios);
  cell.x_per_amplitude = per_x / hypot(a, a1);
  cell.y_per_amplitude = -y_per_v * v / a;
  cell.y_per_speed = (along ? y_per_v : -y_per_v) / crest;
  return cell;
}

static Surface surface_at(const float* values, int columns, const Cell* c) {
  double value = 0, per_x = 0, per_y = 0;
  Surface s;
  int i, j;
  for (i = 0; i < 4; ++i) {
    double across = 0, slope = 0;
    if (c->y.of[i] == 0 && c->y.slope[i] == 0) continue; /* no neighbour */
    for (j = 0; j < 4; ++j) {
      if (c->x.of[j] == 0 && c->x.slope[j] == 0) continue;
      const double f = values[(c->row + i) * columns + c->column + j];
      across += c->x.of[j] * f;
      slope += c->x.slope[j] * f;
    }
    value += c->y.of[i] * across;
    per_x += c->y.of[i] * slope;
    per_y += c->y.slope[i] * across;
  }
  s.value = value;
  s.per_amplitude = per_x * c->x_per_amplitude + per_y * c->y_per_amplitude;
  s.per_speed = per_y * c->y_per_speed;
  return s;
}

static Contact contact_at(const PlantData* m, double amplitude, double speed, int along, double omega) {
  const Cell cell = cell_at(m, amplitude, speed, along, omega);
  Contact contact;
  if (m->before_reading) m->before_reading(m->filler, along, cell.row, cell.column);
  contact.torque = surface_at(cell.table->torque, m->amplitudes, &cell);
  contact.reactive = surface_at(cell.table->reactive_stiffness, m->amplitudes, &cell);
  contact.active = surface_at(cell.table->active_stiffness, m->amplitudes, &cell);
  return contact;
}

/* Contact of a state; its torque and speed have the direction of the rotor. At rest it is the limit from the mode's side. */
static Contact contact_of(const PlantData* m, const PlantState* s, double omega) {
  const double speed = s->side * s->speed;
  Contact contact = contact_at(m, size_of(zeta_of(s)), speed > 0 ? speed : 0, s->side == s->direction, omega);
  contact.torque.value *= s->direction;
  contact.torque.per_amplitude *= s->direction;
  contact.reactive.per_speed *= s->direction;
  contact.active.per_speed *= s->direction;
  return contact; /* the direction stands twice in the derivative of the torque in the speed */
}

/* ---- wave ---- */

typedef struct {
  double omega;
  Complex off_stiffness; /* of the phases on the off resistance (M3.2 at V = 0); 0 while the drive is on */
  Complex voltage_per_zeta;
  double force; /* Theta u_0 */
} Drive;

static Complex capacitive_admittance(const PlantData* m, double omega) {
  const double c = omega * m->blocked_capacitance;
  return complex_of(c * m->loss_tangent, c);
}

static Drive drive_of(const PlantData* m, const PlantInputs* in, const PlantParameters* p, int off) {
  Drive d;
  d.omega = 2 * PI * in->frequency;
  d.force = off ? 0 : m->force_factor * SQRT2 * in->voltage;
  d.voltage_per_zeta = d.off_stiffness = complex_of(0, 0);
  if (off) {
    const Complex current = complex_of(0, -p->off_resistance * d.omega * m->force_factor);
    const Complex one = add(complex_of(1, 0), scaled(p->off_resistance, capacitive_admittance(m, d.omega)));
    d.voltage_per_zeta = over(current, one);
    d.off_stiffness = scaled(m->force_factor, d.voltage_per_zeta);
  }
  return d;
}

/* zeta' = force + growth zeta, of
   i m_s (omega + omega_b) zeta' = Theta u - (k_s - omega^2 m_s + i omega d_s + F / A) zeta   (M2.1) */
typedef struct { Complex force, growth, divisor; double free_rate, rates; } WaveRate;

static WaveRate wave_rate(const PlantData* m, const Drive* d, const Contact* c) {
  const double w = d->omega;
  WaveRate rate;
  Complex stiffness = complex_of(m->modal_stiffness - w * w * m->modal_mass + c->reactive.value,
                                 w * m->modal_damping + c->active.value);
  stiffness = subtract(stiffness, d->off_stiffness);
  rate.free_rate = sqrt((m->modal_stiffness + c->reactive.value) / m->modal_mass);
  rate.rates = w + rate.free_rate;
  rate.divisor = complex_of(0, m->modal_mass * rate.rates);
  rate.force = over(complex_of(d->force, 0), rate.divisor);
  rate.growth = scaled(-1, over(stiffness, rate.divisor));
  return rate;
}

/* ---- rates and their Jacobian; the angle follows from the speed ---- */

enum { kReal, kImaginary, kSpeed, kRates };

typedef struct { double of[kRates]; double turn; } Rates;

static double inertia_of(const PlantParameters* p) { return p->rotor_inertia + p->load_inertia; }

static Rates rates_of(const PlantData* m, const PlantState* s, const PlantInputs* in, const PlantParameters* p, const Drive* d, const Contact* c) {
  const WaveRate wave = wave_rate(m, d, c);
  const Complex zeta = zeta_of(s);
  const Complex rate = s->off ? scaled(wave.growth.re, zeta) : add(wave.force, times(wave.growth, zeta));
  Rates r;
  r.of[kReal] = rate.re, r.of[kImaginary] = rate.im;
  r.turn = s->off ? wave.growth.im : 0;
  r.of[kSpeed] = s->held ? 0
                         : (c->torque.value - in->load_torque - p->load_damping * s->speed -
                            s->side * p->load_friction) / inertia_of(p); /* (M2.2) */
  return r;
}

typedef struct { double of[kRates][kRates]; } Jacobian;

/* A column of the wave's rows: how zeta' changes with zeta and with the stiffness of the contact. */
static void put_wave(Jacobian* jacobian, int column, const PlantData* m, const PlantState* s, const WaveRate* wave, Complex dzeta, Complex dstiffness) {
  const double dfree = dstiffness.re / (2 * m->modal_mass * wave->free_rate);
  const Complex dgrowth = subtract(scaled(-1, over(dstiffness, wave->divisor)), scaled(dfree / wave->rates, wave->growth));
  const Complex zeta = zeta_of(s);
  Complex d;
  if (s->off)
    d = add(scaled(wave->growth.re, dzeta), scaled(dgrowth.re, zeta));
  else
    d = add(add(scaled(-dfree / wave->rates, wave->force), times(wave->growth, dzeta)), times(dgrowth, zeta));
  jacobian->of[kReal][column] = d.re;
  jacobian->of[kImaginary][column] = d.im;
}

static Jacobian jacobian_of(const PlantData* m, const PlantState* s, const PlantParameters* p, const Drive* d, const Contact* c) {
  const WaveRate wave = wave_rate(m, d, c);
  const Complex zeta = zeta_of(s);
  const double a = size_of(zeta), x = a > 0 ? zeta.re / a : 0, y = a > 0 ? zeta.im / a : 0; /* dA / dzeta */
  const Complex per_amplitude = complex_of(c->reactive.per_amplitude, c->active.per_amplitude);
  const double moves = s->held ? 0 : 1;
  Jacobian j;
  put_wave(&j, kReal, m, s, &wave, complex_of(1, 0), scaled(x, per_amplitude));
  put_wave(&j, kImaginary, m, s, &wave, complex_of(0, 1), scaled(y, per_amplitude));
  put_wave(&j, kSpeed, m, s, &wave, complex_of(0, 0),
           scaled(moves, complex_of(c->reactive.per_speed, c->active.per_speed)));
  j.of[kSpeed][kReal] = moves * x * c->torque.per_amplitude / inertia_of(p);
  j.of[kSpeed][kImaginary] = moves * y * c->torque.per_amplitude / inertia_of(p);
  j.of[kSpeed][kSpeed] = moves * (c->torque.per_speed - p->load_damping) / inertia_of(p);
  return j;
}

/* ---- a step ---- */

/* Solves m x = b by Cramer's rule. */
static void solve(const Jacobian* m, const double b[kRates], double x[kRates]) {
  const double(*a)[kRates] = m->of;
  const double c0 = a[1][1] * a[2][2] - a[1][2] * a[2][1], c1 = a[1][2] * a[2][0] - a[1][0] * a[2][2],
               c2 = a[1][0] * a[2][1] - a[1][1] * a[2][0];
  const double determinant = a[0][0] * c0 + a[0][1] * c1 + a[0][2] * c2;
  x[0] = (b[0] * c0 + b[1] * (a[0][2] * a[2][1] - a[0][1] * a[2][2]) + b[2] * (a[0][1] * a[1][2] - a[0][2] * a[1][1])) /
         determinant;
  x[1] = (b[0] * c1 + b[1] * (a[0][0] * a[2][2] - a[0][2] * a[2][0]) + b[2] * (a[0][2] * a[1][0] - a[0][0] * a[1][2])) /
         determinant;
  x[2] = (b[0] * c2 + b[1] * (a[0][1] * a[2][0] - a[0][0] * a[2][1]) + b[2] * (a[0][0] * a[1][1] - a[0][1] * a[1][0])) /
         determinant;
}

static PlantState moved(const PlantState* s, const double by[kRates]) {
  PlantState next = *s;
  next.zeta_real += by[kReal];
  next.zeta_imaginary += by[kImaginary];
  next.speed += by[kSpeed];
  return next;
}

/* One step of a Rosenbrock method of two stages, of second order for any Jacobian and with strong damping of fast parts
   (ROS2: J. G. Verwer et al., SIAM J. Sci. Comput. 20 (1999) 1456), g = 1 - 1/sqrt(2):
     (1 - g h J) k1 = f(y),  (1 - g h J) k2 = f(y + h k1) - 2 k1,  y += h (3 k1 + k2) / 2 */
static PlantState step_of(const PlantData* m, const PlantState* s, const PlantInputs* in, const PlantParameters* p, const Drive* d, double h) {
  const double g = 1 - 0.5 * SQRT2;
  const Contact contact = contact_of(m, s, d->omega);
  const Rates first = rates_of(m, s, in, p, d, &contact);
  const Jacobian j = jacobian_of(m, s, p, d, &contact);
  Jacobian left;
  double k1[kRates], k2[kRates], by[kRates], right[kRates];
  int r, c;
  for (r = 0; r < kRates; ++r)
    for (c = 0; c < kRates; ++c) left.of[r][c] = (r == c) - g * h * j.of[r][c];
  solve(&left, first.of, k1);
  for (r = 0; r < kRates; ++r) by[r] = h * k1[r];
  const PlantState between = moved(s, by);
  const Contact contact_between = contact_of(m, &between, d->omega);
  const Rates second = rates_of(m, &between, in, p, d, &contact_between);
  for (r = 0; r < kRates; ++r) right[r] = second.of[r] - 2 * k1[r];
  solve(&left, right, k2);
  for (r = 0; r < kRates; ++r) by[r] = 0.5 * h * (3 * k1[r] + k2[r]);
  PlantState next = moved(s, by);
  next.angle += 0.5 * h * (s->speed + next.speed);
  next.turn += 0.5 * h * (first.turn + second.turn);
  return next;
}

/* ---- rest ---- */

/* Limits of the torque that the contact carries at rest: T(0+) on a rotor that begins to turn forward, and T(0-) (M4.1). */
typedef struct { double forward, backward; } HoldingLimits;

static HoldingLimits holding_limits(const PlantData* m, const PlantState* s, double omega) {
  const double a = size_of(zeta_of(s));
  const double with = contact_at(m, a, 0, 1, omega).torque.value, against = contact_at(m, a, 0, 0, omega).torque.value;
  HoldingLimits limits;
  limits.forward = s->direction > 0 ? with : -against;
  limits.backward = s->direction > 0 ? against : -with;
  return limits;
}

/* At rest: the rotor is held, or goes on to one side. */
static void change_mode(const PlantData* m, PlantState* s, const PlantInputs* in, const PlantParameters* p, double omega) {
  const HoldingLimits limits = holding_limits(m, s, omega);
  const double above = limits.forward - p->load_friction - in->load_torque;   /* > 0: the wave turns the rotor forward */
  const double below = in->load_torque - limits.backward - p->load_friction; /* > 0: the load turns it backward */
  const double margin = kHoldMargin * m->holding_torque;
  s->held = above < -margin && below < -margin;
  s->side = above >= below ? 1 : -1;
  s->speed = s->held ? 0 : s->side * kReleaseSpeed;
}

/* One step, which ends in parts where the rotor comes to rest. */
static void step_with_events(const PlantData* m, PlantState* s, const PlantInputs* in, const PlantParameters* p, const Drive* d, double h) {
  double left = h;
  int events;
  for (events = 0; events < kMostEvents && left > 0; ++events) {
    const PlantState next = step_of(m, s, in, p, d, left);
    if (s->held || s->side * next.speed >= 0) {
      *s = next;
      if (s->held) change_mode(m, s, in, p, d->omega);
      return;
    }
    const double part = left * s->speed / (s->speed - next.speed); /* the speed is linear within a step */
    *s = step_of(m, s, in, p, d, part);
    change_mode(m, s, in, p, d->omega);
    left -= part;
  }
  if (left > 0) { /* rattles: it rests for what is left of the step */
    s->held = 1, s->speed = 0;
    *s = step_of(m, s, in, p, d, left);
    change_mode(m, s, in, p, d->omega);
  }
}

/* ---- drive ---- */

/* What changes when the drive is switched, or its phases are swapped. */
static const char* take_inputs(const PlantData* m, PlantState* s, const PlantInputs* in, const PlantParameters* p) {
  const double omega = 2 * PI * in->frequency;
  const int off = !in->enabled, direction = in->direction < 0 ? -1 : 1;
  if (!(in->frequency > 0.5 * m->frequency && in->frequency < 2 * m->frequency))
    return "the frequency must be between half and twice that of the motor's file";
  if (!(in->voltage >= 0 && in->voltage <= DBL_MAX)) return "the voltage must be 0 V or more, and finite";
  if (!(fabs(in->load_torque) <= DBL_MAX)) return "the load torque must be finite";
  if (!(inertia_of(p) > 0)) return "the inertia of rotor and load must be more than 0 kg.m^2";
  if (direction != s->direction) {
    if (size_of(zeta_of(s)) >= 2 * m->opening_amplitude)
      return "the phases were swapped while the wave still runs: switch the drive off first, until it has decayed (swap-too-early)";
    s->zeta_real = s->zeta_imaginary = 0; /* the other wave begins from rest */
  }
  if (off != s->off) { /* the drive's phase goes on while it is off */
    const Complex zeta = turned(zeta_of(s), s->turn);
    s->zeta_real = zeta.re, s->zeta_imaginary = zeta.im, s->turn = 0;
  }
  s->direction = direction, s->off = off;
  if (s->held) change_mode(m, s, in, p, omega);
  return 0;
}

PlantState plant_at_rest(void) {
  PlantState s;
  s.zeta_real = s.zeta_imaginary = s.speed = s.angle = s.turn = 0;
  s.held = 1, s.side = 1, s.off = 0, s.direction = 1;
  return s;
}

const char* plant_advance(const PlantData* m, PlantState* state, const PlantInputs* inputs, const PlantParameters* parameters, double duration) {
  const char* wrong = take_inputs(m, state, inputs, parameters);
  if (wrong) return wrong;
  const Drive drive = drive_of(m, inputs, parameters, state->off);
  const double steps = ceil(duration * m->frequency / kPeriodsPerStep - 1e-9);
  double done;
  for (done = 0; done < steps; ++done) {
    step_with_events(m, state, inputs, parameters, &drive, duration / steps);
    if (!(size_of(zeta_of(state)) <= m->largest_amplitude))
      return "the wave is larger than the table of the contact reaches: the voltage is too high for this table";
  }
  return 0;
}

static double held_torque(const PlantData* m, const PlantState* s, const PlantInputs* in, double omega) {
  const HoldingLimits limits = holding_limits(m, s, omega);
  const double least = fmin(limits.forward, limits.backward), most = fmax(limits.forward, limits.backward);
  return fmin(fmax(in->load_torque, least), most);
}

/* U_e = -i omega Theta_e zeta e^(-i theta_e) / (i omega (C_e + C_load) + 1 / R_load)   (D7.1), rms */
static double sensor_voltage(const PlantData* m, Complex zeta, double omega) {
  if (!m->has_sensor) return 0;
  return omega * m->sensor_force_factor * size_of(zeta) / hypot(omega * m->sensor_capacitance, m->sensor_conductance) / SQRT2;
}

PlantOutputs plant_outputs(const PlantData* m, const PlantState* s, const PlantInputs* in, const PlantParameters* p) {
  const double omega = 2 * PI * in->frequency;
  const Drive drive = drive_of(m, in, p, s->off);
  const Complex zeta = zeta_of(s);
  const Complex u = s->off ? times(drive.voltage_per_zeta, zeta) : complex_of(SQRT2 * in->voltage, 0);
  const Complex motional = times(complex_of(0, omega * m->force_factor), zeta);
  const Complex current = add(times(capacitive_admittance(m, omega), u), motional); /* (D4.1) */
  const double lag = -atan2(zeta.im, zeta.re) - s->turn;
  PlantOutputs out;
  out.speed = s->speed, out.angle = s->angle;
  out.amplitude = size_of(zeta);
  out.phase_lag = remainder(lag, 2 * PI);
  out.torque = s->held ? held_torque(m, s, in, omega) : contact_of(m, s, omega).torque.value;
  out.phase_current = size_of(current) / SQRT2;
  out.electrical_power = u.re * current.re + u.im * current.im;
  out.sensor_voltage = sensor_voltage(m, zeta, omega);
  out.held = s->held;
  return out;
}
