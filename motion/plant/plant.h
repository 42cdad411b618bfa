/* SPDX-License-Identifier: Apache-2.0 */
/* A travelling wave ultrasonic motor in time: one averaged wave, the rotor and its load, with the contact read from tables.
   SI units. Equations (M...) are those of twum's documentation, docs/theory/motion.md. */
#ifndef TWUM_PLANT_H
#define TWUM_PLANT_H

#ifdef __cplusplus
extern "C" {
#endif

/* Length of a step, in periods of the table's frequency: 2 us at 40 kHz. */
#define PLANT_PERIODS_PER_STEP 0.08

/* The contact while the rotor turns to one side: values at amplitude j and speed ratio i stand at [i * amplitudes + j]. */
typedef struct {
  const float* torque;             /* T in the direction of the wave [N m] */
  const float* reactive_stiffness; /* Re F / A [N/m] */
  const float* active_stiffness;   /* Im F / A [N/m] */
} PlantContact;

/* What a motor is. */
typedef struct {
  double modal_mass, modal_damping, modal_stiffness;       /* m_s, d_s, k_s */
  double force_factor, blocked_capacitance, loss_tangent;  /* Theta, C_0, tan delta */
  double frequency;                                        /* of the table, the design's */
  double opening_amplitude;                                /* A_1, or what amplitudes are measured by without a preload */
  double holding_torque;                                   /* of the motor without a wave */
  double crest_per_amplitude;                              /* speed of the crest over r, of A = 1 m at omega = 1 rad/s */
  int has_sensor;
  double sensor_force_factor, sensor_capacitance, sensor_conductance; /* of the sensor and what loads it */
  int amplitudes, speed_ratios;
  double largest_amplitude;
  PlantContact along, against; /* rotor turns with the wave, and against it */
  /* Called before 4 rows and 4 columns of a side are read, of which the first may be -1 and the last one too many. It fills
     what is missing there. 0 for tables that have all values. */
  void (*before_reading)(void* filler, int along, int row, int column);
  void* filler;
} PlantData;

typedef struct {
  double voltage;     /* of each phase, rms [V] */
  double frequency;   /* of the drive [Hz] */
  double load_torque; /* against positive motion [N m] */
  int enabled;        /* 0: the phases are on the off resistance */
  int direction;      /* of the wave: 1, or -1 with swapped phases */
} PlantInputs;

typedef struct {
  double rotor_inertia, load_inertia; /* [kg m^2] */
  double load_damping;                /* [N m s] */
  double load_friction;               /* [N m] */
  double off_resistance;              /* across each phase while the drive is off [ohm]; 0 for shorted phases */
} PlantParameters;

typedef struct {
  double zeta_real, zeta_imaginary; /* A e^(-i phi) [m] */
  double speed, angle;              /* of the rotor [rad/s], [rad] */
  double turn;                      /* angle by which zeta has turned while the drive is off [rad] */
  int held;                         /* the contact holds the rotor at rest */
  int side;                         /* sign of the speed where it does not */
  int off, direction;               /* of the drive, as the state was last moved */
} PlantState;

typedef struct {
  double speed, angle;      /* [rad/s], [rad] */
  double amplitude;         /* of the wave [m] */
  double phase_lag;         /* of the wave behind the voltage [rad] */
  double torque;            /* of the contact on the rotor; of a held one, what holds the load [N m] */
  double phase_current;     /* rms [A] */
  double electrical_power;  /* of both phases [W] */
  double sensor_voltage;    /* rms [V] */
  int held;
} PlantOutputs;

/* A rotor at rest, without a wave. */
PlantState plant_at_rest(void);

/* Follows the motor for `duration` seconds under constant inputs. Returns 0, or why it could not: the state is then as far as it
   came. */
const char* plant_advance(const PlantData* motor, PlantState* state, const PlantInputs* inputs, const PlantParameters* parameters, double duration);

PlantOutputs plant_outputs(const PlantData* motor, const PlantState* state, const PlantInputs* inputs, const PlantParameters* parameters);

#ifdef __cplusplus
}
#endif

#endif
