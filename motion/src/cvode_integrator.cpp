// SPDX-License-Identifier: Apache-2.0
#include "integrator.hpp"

#include <twum/base/error.hpp>
#include <twum/motion/integrator_version.hpp>

#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <exception>
#include <type_traits>
#include <utility>

namespace twum::inline v0_1::motion {
namespace {

// What SUNDIALS makes, and how it is freed.
struct Free {
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
};
template <typename Pointer>
using Held = std::unique_ptr<std::remove_pointer_t<Pointer>, Free>;

// As many vectors as there are parameters.
class Vectors {
 public:
  Vectors(std::size_t count, N_Vector like) {
    if (count == 0) return;
    vectors_ = N_VCloneVectorArray(static_cast<int>(count), like);
    TWUM_ASSERT(vectors_);
    count_ = static_cast<int>(count);
  }
  ~Vectors() {
    if (vectors_) N_VDestroyVectorArray(vectors_, count_);
  }
  Vectors(const Vectors&) = delete;
  Vectors& operator=(const Vectors&) = delete;

  N_Vector* data() const { return vectors_; }
  int count() const { return count_; }
  N_Vector operator[](int k) const { return vectors_[k]; }

 private:
  N_Vector* vectors_{nullptr};
  int count_{0};
};

struct FreeMemory {
  void operator()(void* memory) const { CVodeFree(&memory); }
};

SUNContext new_context() {
  SUNContext context = nullptr;
  TWUM_ASSERT(SUNContext_Create(nullptr, &context) == 0);
  return context;
}

std::span<double> numbers(N_Vector vector) {
  return {N_VGetArrayPointer(vector), static_cast<std::size_t>(N_VGetLength(vector))};
}

void ignore_message(int, const char*, const char*, char*, void*) {}  // step() tells the failure

constexpr int kShorterStep = 1, kGiveUp = -1;

// Share of a step's tolerated error that Newton's iteration may leave. By default it is 0.1: more contacts, and no smaller error
// of a start.
constexpr double kNewtonShare = 1;

}  // namespace

struct Integrator::Parts {
  Parts(OdeSystem& of, std::size_t states, int event_count, std::size_t parameters)
      : system(&of),
        events(event_count),
        context(new_context()),
        y(N_VNew_Serial(static_cast<sunindextype>(states), context.get())),
        shown(N_VNew_Serial(static_cast<sunindextype>(states), context.get())),
        matrix(SUNDenseMatrix(static_cast<sunindextype>(states), static_cast<sunindextype>(states),
                              context.get())),
        solver(SUNLinSol_Dense(y.get(), matrix.get(), context.get())),
        slopes(parameters, y.get()),
        memory(CVodeCreate(CV_BDF, context.get())) {}

  // Runs a callback of SUNDIALS, through which no exception may pass.
  template <typename Call>
  int guarded(Call call) {
    try {
      return call() ? 0 : kShorterStep;
    } catch (...) {
      error = std::current_exception();
      return kGiveUp;
    }
  }

  static int rates(realtype time, N_Vector y, N_Vector dy, void* parts) {
    Parts& own = *static_cast<Parts*>(parts);
    return own.guarded([&] { return own.system->rates(time, numbers(y), numbers(dy)); });
  }
  static int jacobian(realtype time, N_Vector y, N_Vector, SUNMatrix matrix, void* parts, N_Vector,
                      N_Vector, N_Vector) {
    Parts& own = *static_cast<Parts*>(parts);
    const std::size_t n = numbers(y).size();
    return own.guarded([&] {
      return own.system->jacobian(time, numbers(y), {SUNDenseMatrix_Data(matrix), n * n});
    });
  }
  // S' = y'_y S + y'_q. Newton's iteration asks several times at one state.
  static int slope_rates(int count, realtype time, N_Vector y, N_Vector, N_Vector* slopes,
                         N_Vector* rates, void* parts, N_Vector, N_Vector) {
    Parts& own = *static_cast<Parts*>(parts);
    return own.guarded([&] {
      if (!own.find_slopes(time, numbers(y), static_cast<std::size_t>(count))) return false;
      const std::size_t n = numbers(y).size();
      for (int k = 0; k < count; ++k) {
        const std::span<double> s = numbers(slopes[k]), ds = numbers(rates[k]);
        for (std::size_t i = 0; i < n; ++i) {
          ds[i] = own.by_parameter[static_cast<std::size_t>(k) * n + i];
          for (std::size_t j = 0; j < n; ++j) ds[i] += own.by_state[j * n + i] * s[j];
        }
      }
      return true;
    });
  }
  bool find_slopes(double at, std::span<const double> state, std::size_t count) {
    if (at == slopes_time && std::ranges::equal(state, slopes_state)) return true;
    const std::size_t n = state.size();
    by_state.resize(n * n), by_parameter.resize(n * count);
    slopes_time = -1;  // until they are found
    if (!system->jacobian(at, state, by_state) ||
        !system->parameter_slopes(at, state, by_parameter))
      return false;
    slopes_time = at, slopes_state.assign(state.begin(), state.end());
    return true;
  }
  static int roots(realtype time, N_Vector y, realtype* values, void* parts) {
    Parts& own = *static_cast<Parts*>(parts);
    return own.guarded([&] {
      return own.system->events(time, numbers(y), {values, static_cast<std::size_t>(own.events)});
    });
  }

  OdeSystem* system;
  int events;
  Held<SUNContext> context;  // freed last
  Held<N_Vector> y, shown;
  Held<SUNMatrix> matrix;
  Held<SUNLinearSolver> solver;
  Vectors slopes;
  std::vector<double> by_state, by_parameter, slopes_state;  // at slopes_time
  double slopes_time{-1};
  std::unique_ptr<void, FreeMemory> memory;
  std::exception_ptr error;
  double time{0};
  long earlier_steps{0};  // before the last restart
};

Integrator::Integrator(OdeSystem& system, int event_count, double tolerance,
                       std::vector<double> absolute, std::size_t parameters)
    : parts_(std::make_unique<Parts>(system, absolute.size(), event_count, parameters)) {
  Parts& own = *parts_;
  void* memory = own.memory.get();
  TWUM_ASSERT(own.context && own.y && own.shown && own.matrix && own.solver && memory);
  N_VConst(0, own.y.get());
  std::ranges::copy(absolute, numbers(own.shown.get()).begin());
  const bool made =
      CVodeInit(memory, Parts::rates, 0, own.y.get()) == CV_SUCCESS &&
      CVodeSetUserData(memory, &own) == CV_SUCCESS &&
      CVodeSVtolerances(memory, tolerance, own.shown.get()) == CV_SUCCESS &&
      CVodeSetLinearSolver(memory, own.solver.get(), own.matrix.get()) == CV_SUCCESS &&
      CVodeSetJacFn(memory, Parts::jacobian) == CV_SUCCESS &&
      CVodeSetNonlinConvCoef(memory, kNewtonShare) == CV_SUCCESS &&
      CVodeSetStabLimDet(memory, system.rings()) == CV_SUCCESS &&
      CVodeRootInit(memory, event_count, Parts::roots) == CV_SUCCESS &&
      CVodeSetErrHandlerFn(memory, ignore_message, nullptr) == CV_SUCCESS &&
      CVodeSetNoInactiveRootWarn(memory) == CV_SUCCESS;
  TWUM_ASSERT(made);
  if (parameters > 0) take_parameters();
}

void Integrator::take_parameters() {
  Parts& own = *parts_;
  void* memory = own.memory.get();
  std::vector<realtype> scales(static_cast<std::size_t>(own.slopes.count()), 1.0);
  for (int k = 0; k < own.slopes.count(); ++k) N_VConst(0, own.slopes[k]);
  const bool made = CVodeSensInit(memory, own.slopes.count(), CV_STAGGERED, Parts::slope_rates,
                                  own.slopes.data()) == CV_SUCCESS &&
                    CVodeSetSensParams(memory, nullptr, scales.data(), nullptr) == CV_SUCCESS &&
                    CVodeSensEEtolerances(memory) == CV_SUCCESS &&
                    CVodeSetSensErrCon(memory, SUNTRUE) == CV_SUCCESS;
  TWUM_ASSERT(made);
}

Integrator::~Integrator() = default;

void Integrator::restart(double time, std::span<const double> y, double stop,
                         std::span<const double> slopes) {
  Parts& own = *parts_;
  own.earlier_steps = steps();
  own.time = time;
  std::ranges::copy(y, numbers(own.y.get()).begin());
  TWUM_ASSERT(CVodeReInit(own.memory.get(), time, own.y.get()) == CV_SUCCESS);
  if (own.slopes.count() > 0) {
    for (int k = 0; k < own.slopes.count(); ++k)
      std::ranges::copy(slopes.subspan(static_cast<std::size_t>(k) * y.size(), y.size()),
                        numbers(own.slopes[k]).begin());
    TWUM_ASSERT(CVodeSensReInit(own.memory.get(), CV_STAGGERED, own.slopes.data()) == CV_SUCCESS);
  }
  TWUM_ASSERT(CVodeSetStopTime(own.memory.get(), stop) == CV_SUCCESS);
}

StepEnd Integrator::step() {
  Parts& own = *parts_;
  const double far = own.time + 1;  // only its sign counts where one step is taken
  const int end = CVode(own.memory.get(), far, own.y.get(), &own.time, CV_ONE_STEP);
  if (own.error) std::rethrow_exception(std::exchange(own.error, nullptr));
  switch (end) {
    case CV_SUCCESS: return StepEnd::advanced;
    case CV_TSTOP_RETURN: return StepEnd::stop_time;
    case CV_ROOT_RETURN: return StepEnd::event;
    default: return StepEnd::failed;
  }
}

double Integrator::time() const { return parts_->time; }

std::span<const double> Integrator::y() const { return numbers(parts_->y.get()); }

std::vector<double> Integrator::at(double time, int derivative) const {
  const Parts& own = *parts_;
  CVodeGetDky(own.memory.get(), time, derivative, own.shown.get());
  const std::span<double> y = numbers(own.shown.get());
  return {y.begin(), y.end()};
}

std::vector<double> Integrator::slopes_at(double time) const {
  const Parts& own = *parts_;
  std::vector<double> all;
  for (int k = 0; k < own.slopes.count(); ++k) {
    CVodeGetSensDky1(own.memory.get(), time, 0, k, own.shown.get());
    const std::span<double> one = numbers(own.shown.get());
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

long Integrator::steps() const {
  long steps = 0;
  CVodeGetNumSteps(parts_->memory.get(), &steps);
  return parts_->earlier_steps + steps;
}

bool has_integrator() noexcept { return true; }

std::string integrator_version() {
  char text[32] = "";
  SUNDIALSGetVersion(text, sizeof text);
  return text;
}

}  // namespace twum::inline v0_1::motion
