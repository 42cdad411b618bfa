/* SPDX-License-Identifier: Apache-2.0 */
/* The plant behind the functions of FMI 2.0 for co-simulation. Their types are those of the standard, under names of our own, so
   that no header of the standard is needed and none is in the way. */
#include "plant.h"

#include <float.h>
#include <stddef.h>
#include <string.h>

#if defined _WIN32
#define EXPORTED __declspec(dllexport)
#elif defined __GNUC__
#define EXPORTED __attribute__((visibility("default")))
#else
#define EXPORTED
#endif
#ifdef FMI2_FUNCTION_PREFIX
#define JOINED(a, b) a##b
#define JOIN(a, b) JOINED(a, b)
#define FMI(name) JOIN(FMI2_FUNCTION_PREFIX, name)
#else
#define FMI(name) name
#endif

typedef unsigned int Reference;
typedef enum { kOk, kWarning, kDiscard, kError, kFatal, kPending } Status;
typedef enum { kModelExchange, kCoSimulation } Kind;
typedef void (*Logger)(void* environment, const char* instance, Status status, const char* category, const char* message, ...);
typedef struct {
  Logger logger;
  void* (*allocate)(size_t count, size_t size); /* sets to zero, as calloc */
  void (*release)(void* memory);
  void (*step_finished)(void* environment, Status status);
  void* environment;
} Callbacks;

/* Of contact_table.c, which twum writes for a motor. */
extern const PlantData twum_motor;
extern const char twum_guid[];
extern const PlantInputs twum_first_inputs;
extern const PlantParameters twum_first_parameters;

/* Value references, as modelDescription.xml has them. */
enum {
  kVoltage = 1, kFrequency, kLoadTorque, kEnabled, kDirection,
  kRotorInertia = 11, kLoadInertia, kLoadDamping, kLoadFriction, kOffResistance,
  kSpeed = 21, kAngle, kAmplitude, kPhaseLag, kTorque, kPhaseCurrent, kElectricalPower, kSensorVoltage, kHeld
};

typedef enum { kInstantiated, kInitializing, kStepping, kTerminated, kFailed } Phase;

/* All that changes: what get and set of a state copy. */
typedef struct {
  PlantState state;
  PlantInputs inputs;
  PlantParameters parameters;
  double time;
  Phase phase;
} Memory;

typedef struct {
  Memory memory;
  const Callbacks* callbacks;
  int logging;
  char* name;
} Instance;

static Status say(const Instance* of, Status status, const char* message) {
  if (of->callbacks->logger && (of->logging || status >= kError))
    of->callbacks->logger(of->callbacks->environment, of->name, status, status >= kError ? "logStatusError" : "logStatusWarning",
                          "%s", message);
  return status;
}

static Status fail(Instance* of, const char* message) {
  of->memory.phase = kFailed;
  return say(of, kError, message);
}

static Status refuse(const Instance* of, const char* message) { return say(of, kError, message); }

static void begin_anew(Instance* of) {
  of->memory.state = plant_at_rest();
  of->memory.inputs = twum_first_inputs;
  of->memory.parameters = twum_first_parameters;
  of->memory.time = 0;
  of->memory.phase = kInstantiated;
}

/* ---- about the unit ---- */

EXPORTED const char* FMI(fmi2GetTypesPlatform)(void) { return "default"; }
EXPORTED const char* FMI(fmi2GetVersion)(void) { return "2.0"; }

/* ---- life of an instance ---- */

EXPORTED void* FMI(fmi2Instantiate)(const char* name, Kind kind, const char* guid, const char* resources,
                                    const Callbacks* callbacks, int visible, int logging) {
  Instance* of;
  (void)resources, (void)visible;
  if (!callbacks || !callbacks->allocate || !callbacks->release || !name || !guid) return NULL;
  if (kind != kCoSimulation || strcmp(guid, twum_guid) != 0) {
    if (callbacks->logger)
      callbacks->logger(callbacks->environment, name, kError, "logStatusError", "%s",
                        kind != kCoSimulation ? "this unit is for co-simulation"
                                              : "the GUID is not that of this unit's modelDescription.xml");
    return NULL;
  }
  of = callbacks->allocate(1, sizeof *of);
  if (!of) return NULL;
  of->name = callbacks->allocate(strlen(name) + 1, 1);
  if (!of->name) {
    callbacks->release(of);
    return NULL;
  }
  strcpy(of->name, name);
  of->callbacks = callbacks, of->logging = logging;
  begin_anew(of);
  return of;
}

EXPORTED void FMI(fmi2FreeInstance)(void* component) {
  Instance* of = component;
  if (!of) return;
  of->callbacks->release(of->name);
  of->callbacks->release(of);
}

EXPORTED Status FMI(fmi2SetDebugLogging)(void* component, int logging, size_t count, const char* const categories[]) {
  (void)count, (void)categories;
  ((Instance*)component)->logging = logging;
  return kOk;
}

EXPORTED Status FMI(fmi2SetupExperiment)(void* component, int tolerance_defined, double tolerance, double start,
                                         int stop_defined, double stop) {
  Instance* of = component;
  (void)tolerance_defined, (void)tolerance, (void)stop_defined, (void)stop;
  if (of->memory.phase != kInstantiated) return refuse(of, "fmi2SetupExperiment belongs before the initialization");
  of->memory.time = start;
  return kOk;
}

EXPORTED Status FMI(fmi2EnterInitializationMode)(void* component) {
  Instance* of = component;
  if (of->memory.phase != kInstantiated) return refuse(of, "the initialization begins once, after fmi2Instantiate or fmi2Reset");
  of->memory.phase = kInitializing;
  return kOk;
}

EXPORTED Status FMI(fmi2ExitInitializationMode)(void* component) {
  Instance* of = component;
  if (of->memory.phase != kInitializing) return refuse(of, "fmi2ExitInitializationMode without fmi2EnterInitializationMode");
  of->memory.phase = kStepping;
  return kOk;
}

EXPORTED Status FMI(fmi2Terminate)(void* component) {
  ((Instance*)component)->memory.phase = kTerminated;
  return kOk;
}

EXPORTED Status FMI(fmi2Reset)(void* component) {
  begin_anew(component);
  return kOk;
}

/* ---- values ---- */

/* A value that a tool may set; NULL for all others. */
static double* real_input(Memory* m, Reference reference) {
  switch (reference) {
    case kVoltage: return &m->inputs.voltage;
    case kFrequency: return &m->inputs.frequency;
    case kLoadTorque: return &m->inputs.load_torque;
    default: return NULL;
  }
}

static double* parameter(Memory* m, Reference reference) {
  switch (reference) {
    case kRotorInertia: return &m->parameters.rotor_inertia;
    case kLoadInertia: return &m->parameters.load_inertia;
    case kLoadDamping: return &m->parameters.load_damping;
    case kLoadFriction: return &m->parameters.load_friction;
    case kOffResistance: return &m->parameters.off_resistance;
    default: return NULL;
  }
}

static const double* real_output(const PlantOutputs* out, Reference reference) {
  switch (reference) {
    case kSpeed: return &out->speed;
    case kAngle: return &out->angle;
    case kAmplitude: return &out->amplitude;
    case kPhaseLag: return &out->phase_lag;
    case kTorque: return &out->torque;
    case kPhaseCurrent: return &out->phase_current;
    case kElectricalPower: return &out->electrical_power;
    case kSensorVoltage: return twum_motor.has_sensor ? &out->sensor_voltage : NULL;
    default: return NULL;
  }
}

EXPORTED Status FMI(fmi2GetReal)(void* component, const Reference references[], size_t count, double values[]) {
  Instance* of = component;
  Memory* m = &of->memory;
  const PlantOutputs out = plant_outputs(&twum_motor, &m->state, &m->inputs, &m->parameters);
  size_t i;
  for (i = 0; i < count; ++i) {
    const double* value = real_output(&out, references[i]);
    if (!value) value = real_input(m, references[i]);
    if (!value) value = parameter(m, references[i]);
    if (!value) return refuse(of, "fmi2GetReal: no real variable has this value reference");
    values[i] = *value;
  }
  return kOk;
}

EXPORTED Status FMI(fmi2GetInteger)(void* component, const Reference references[], size_t count, int values[]) {
  Instance* of = component;
  size_t i;
  for (i = 0; i < count; ++i) {
    if (references[i] != kDirection) return refuse(of, "fmi2GetInteger: no integer variable has this value reference");
    values[i] = of->memory.inputs.direction;
  }
  return kOk;
}

EXPORTED Status FMI(fmi2GetBoolean)(void* component, const Reference references[], size_t count, int values[]) {
  Instance* of = component;
  size_t i;
  for (i = 0; i < count; ++i) {
    if (references[i] == kEnabled)
      values[i] = of->memory.inputs.enabled;
    else if (references[i] == kHeld)
      values[i] = of->memory.state.held;
    else
      return refuse(of, "fmi2GetBoolean: no boolean variable has this value reference");
  }
  return kOk;
}

EXPORTED Status FMI(fmi2GetString)(void* component, const Reference references[], size_t count, const char* values[]) {
  (void)references, (void)values;
  return count == 0 ? kOk : refuse(component, "fmi2GetString: this unit has no strings");
}

EXPORTED Status FMI(fmi2SetReal)(void* component, const Reference references[], size_t count, const double values[]) {
  Instance* of = component;
  size_t i;
  for (i = 0; i < count; ++i) {
    double* input = real_input(&of->memory, references[i]);
    double* fixed = parameter(&of->memory, references[i]);
    if (!input && !fixed) return refuse(of, "fmi2SetReal: no input and no parameter has this value reference");
    if (fixed && of->memory.phase > kInitializing) return refuse(of, "fmi2SetReal: a parameter is set before the first step");
    if (fixed && !(values[i] >= 0 && values[i] <= DBL_MAX)) return refuse(of, "fmi2SetReal: a parameter must be 0 or more, and finite");
    *(input ? input : fixed) = values[i];
  }
  return kOk;
}

EXPORTED Status FMI(fmi2SetInteger)(void* component, const Reference references[], size_t count, const int values[]) {
  Instance* of = component;
  size_t i;
  for (i = 0; i < count; ++i) {
    if (references[i] != kDirection) return refuse(of, "fmi2SetInteger: no integer input has this value reference");
    if (values[i] != 1 && values[i] != -1) return refuse(of, "fmi2SetInteger: the direction is 1 or -1");
    of->memory.inputs.direction = values[i];
  }
  return kOk;
}

EXPORTED Status FMI(fmi2SetBoolean)(void* component, const Reference references[], size_t count, const int values[]) {
  Instance* of = component;
  size_t i;
  for (i = 0; i < count; ++i) {
    if (references[i] != kEnabled) return refuse(of, "fmi2SetBoolean: no boolean input has this value reference");
    of->memory.inputs.enabled = values[i] != 0;
  }
  return kOk;
}

EXPORTED Status FMI(fmi2SetString)(void* component, const Reference references[], size_t count, const char* const values[]) {
  (void)references, (void)values;
  return count == 0 ? kOk : refuse(component, "fmi2SetString: this unit has no strings");
}

/* ---- steps ---- */

EXPORTED Status FMI(fmi2DoStep)(void* component, double time, double step, int no_way_back) {
  Instance* of = component;
  Memory* m = &of->memory;
  const char* wrong;
  (void)no_way_back;
  if (m->phase != kStepping) return refuse(of, "fmi2DoStep belongs after the initialization, and not behind an error");
  if (!(step >= 0 && step < 1e6)) return refuse(of, "fmi2DoStep: the step must be 0 s or more, and finite");
  wrong = plant_advance(&twum_motor, &m->state, &m->inputs, &m->parameters, step);
  if (wrong) return fail(of, wrong);
  m->time = time + step;
  return kOk;
}

EXPORTED Status FMI(fmi2CancelStep)(void* component) { return refuse(component, "fmi2CancelStep: a step has ended when it returns"); }

EXPORTED Status FMI(fmi2GetStatus)(void* component, int kind, Status* value) {
  (void)kind, (void)value;
  return say(component, kDiscard, "fmi2GetStatus: a step has ended when it returns");
}

EXPORTED Status FMI(fmi2GetRealStatus)(void* component, int kind, double* value) {
  enum { kLastSuccessfulTime = 2 };
  if (kind != kLastSuccessfulTime) return say(component, kDiscard, "fmi2GetRealStatus: only fmi2LastSuccessfulTime is known");
  *value = ((Instance*)component)->memory.time;
  return kOk;
}

EXPORTED Status FMI(fmi2GetIntegerStatus)(void* component, int kind, int* value) {
  (void)kind, (void)value;
  return say(component, kDiscard, "fmi2GetIntegerStatus: there is none");
}

EXPORTED Status FMI(fmi2GetBooleanStatus)(void* component, int kind, int* value) {
  enum { kTerminatedStatus = 3 };
  if (kind != kTerminatedStatus) return say(component, kDiscard, "fmi2GetBooleanStatus: only fmi2Terminated is known");
  *value = 0;
  return kOk;
}

EXPORTED Status FMI(fmi2GetStringStatus)(void* component, int kind, const char** value) {
  (void)kind, (void)value;
  return say(component, kDiscard, "fmi2GetStringStatus: there is none");
}

/* ---- what this unit does not offer, as its capability flags say ---- */

EXPORTED Status FMI(fmi2SetRealInputDerivatives)(void* component, const Reference references[], size_t count, const int orders[],
                                                 const double values[]) {
  (void)references, (void)count, (void)orders, (void)values;
  return refuse(component, "fmi2SetRealInputDerivatives: inputs are constant over a step");
}

EXPORTED Status FMI(fmi2GetRealOutputDerivatives)(void* component, const Reference references[], size_t count, const int orders[],
                                                  double values[]) {
  (void)references, (void)count, (void)orders, (void)values;
  return refuse(component, "fmi2GetRealOutputDerivatives: this unit has no derivatives of outputs");
}

EXPORTED Status FMI(fmi2GetDirectionalDerivative)(void* component, const Reference unknowns[], size_t unknown_count,
                                                  const Reference knowns[], size_t known_count, const double dknown[],
                                                  double dunknown[]) {
  (void)unknowns, (void)unknown_count, (void)knowns, (void)known_count, (void)dknown, (void)dunknown;
  return refuse(component, "fmi2GetDirectionalDerivative: this unit has no derivatives");
}

/* ---- states ---- */

EXPORTED Status FMI(fmi2GetFMUstate)(void* component, void** state) {
  Instance* of = component;
  if (!*state) *state = of->callbacks->allocate(1, sizeof(Memory));
  if (!*state) return say(of, kError, "fmi2GetFMUstate: no memory");
  memcpy(*state, &of->memory, sizeof(Memory));
  return kOk;
}

EXPORTED Status FMI(fmi2SetFMUstate)(void* component, void* state) {
  Instance* of = component;
  if (!state) return refuse(of, "fmi2SetFMUstate: there is no state");
  memcpy(&of->memory, state, sizeof(Memory));
  return kOk;
}

EXPORTED Status FMI(fmi2FreeFMUstate)(void* component, void** state) {
  if (state && *state) {
    ((Instance*)component)->callbacks->release(*state);
    *state = NULL;
  }
  return kOk;
}

EXPORTED Status FMI(fmi2SerializedFMUstateSize)(void* component, void* state, size_t* size) {
  (void)component, (void)state;
  *size = sizeof(Memory);
  return kOk;
}

EXPORTED Status FMI(fmi2SerializeFMUstate)(void* component, void* state, char bytes[], size_t size) {
  if (!state || size != sizeof(Memory)) return refuse(component, "fmi2SerializeFMUstate: ask for the size first");
  memcpy(bytes, state, size);
  return kOk;
}

EXPORTED Status FMI(fmi2DeSerializeFMUstate)(void* component, const char bytes[], size_t size, void** state) {
  Instance* of = component;
  if (size != sizeof(Memory)) return refuse(of, "fmi2DeSerializeFMUstate: these bytes are not of this unit");
  if (!*state) *state = of->callbacks->allocate(1, sizeof(Memory));
  if (!*state) return say(of, kError, "fmi2DeSerializeFMUstate: no memory");
  memcpy(*state, bytes, size);
  return kOk;
}
