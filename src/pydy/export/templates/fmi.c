/* The interfaces of FMI 2.0 and 3.0, declared here as their specifications give them. */

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "fmu_core.c"

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORT __attribute__((visibility("default")))
#pragma GCC diagnostic ignored "-Wunused-parameter" /* importers say much that this model needs not */
#else
#define EXPORT
#endif

typedef enum { OK, WARNING, DISCARD, ERROR } Status;
typedef uint32_t Reference;

#if FMI == 3
#define NAME(function) fmi3##function
typedef bool Flag;
typedef uint8_t Byte;
typedef void (*Logger)(void *, Status, const char *, const char *);
#define LOG(logger, environment, name, status, category, message) \
    (logger)(environment, status, category, message)
#else
#define NAME(function) fmi2##function
typedef int Flag;
typedef char Byte;
typedef void (*Logger)(void *, const char *, Status, const char *, const char *, ...);
#define LOG(logger, environment, name, status, category, message) \
    (logger)(environment, name, status, category, "%s", message)
#endif

#define STATUS EXPORT Status
#define SELF Instance *self = instance; Model *m = &self->model
/* Functions of the interface that have nothing to do, or that this model does not have. */
#define TRIVIAL(FUNCTION, ...) STATUS NAME(FUNCTION)(__VA_ARGS__) { return OK; }
#define ABSENT(FUNCTION, ...) STATUS NAME(FUNCTION)(__VA_ARGS__) { return ERROR; }

#define MASS_IS_SINGULAR "the mass matrix is singular, or a value reference is wrong"
#define WRONG_SIZE "an array has the wrong size"

/* Return a status, and log why it is not well. */
static Status logged(Instance *self, Status status, const char *message)
{
    Logger logger;
    memcpy(&logger, &self->logger, sizeof logger);
    if (status != OK && logger != NULL)
        LOG(logger, self->environment, self->name, status,
            status == WARNING       ? "logStatusWarning"
                : status == DISCARD ? "logStatusDiscard"
                                    : "logStatusError",
            message);
    return status;
}

static Status told(Instance *self, int failed, const char *message)
{
    return logged(self, failed ? ERROR : OK, message);
}

/* Log why the motion has ended or failed, except by a terminal event; ERROR where it has failed. */
static Status ended(Instance *self)
{
    const Model *m = &self->model;
    const char *event = "";
    char message[512];
#if NE > 0
    event = MODEL(event_names)[m->event];
#endif
    switch (m->outcome) {
    case FINISHED:
    case TERMINATED:
        return OK;
    case EVENTS_ACCUMULATE:
        snprintf(message, sizeof message,
            "the simulation ends at t = %.9g, where the events %s accumulate: they follow each other ever"
            " faster, or faster than the importer's steps. Make the event terminal, or let its reset stop"
            " the motion as it stops in reality",
            m->t, event);
        return logged(self, WARNING, message), OK;
    case RESET_NOT_FINITE:
        snprintf(message, sizeof message, "the reset of the event %s gives a state that is not finite at t = %.9g",
            event, m->t);
        break;
    case EVENT_UNDEFINED:
        snprintf(message, sizeof message, "the event %s is NaN at t = %.9g", event, m->t);
        break;
    default:
        snprintf(message, sizeof message, "%s at t = %.9g",
            m->outcome == SINGULAR             ? "the mass matrix is singular"
                : m->outcome == NOT_FINITE     ? "derivatives or errors are not finite"
                : m->outcome == TOO_MANY_STEPS ? "the communication step takes too many steps of the solver"
                                               : "steps of the solver become ever smaller",
            m->t);
    }
    return logged(self, ERROR, message);
}

/* Warn where the motion begins off the constraints, onto which nothing brings it back. */
static Status checked_start(Instance *self)
{
    Model *m = &self->model;
    double residual;
    int singular;
    const char *constraint = "";
    char message[768];
    const int worst = violated_constraint(m, &residual, &singular);
    if (singular)
        return told(self, 1, MASS_IS_SINGULAR);
    if (worst < 0)
        return OK;
#if NC > 0
    constraint = MODEL(constraint_names)[worst];
#endif
    snprintf(message, sizeof message,
        "the start values do not satisfy the constraints, and nothing will bring the motion back onto them: the"
        " residual at t = %.9g is %.3g in the %s. Set start values of the states that satisfy them at this time"
        " with these constants, or export the model with `times` that begin there, with these constants and after"
        " set_dependent_initial_conditions()",
        m->t, residual, constraint);
    return logged(self, WARNING, message);
}

/* -- instances ------------------------------------------------------------------------------------ */

EXPORT const char *NAME(GetVersion)(void) { return FMI == 3 ? "3.0" : "2.0"; }

TRIVIAL(SetDebugLogging, void *instance, Flag on, size_t n, const char *const *categories)

static void *made(const char *name, const char *token, void *environment, Logger logger)
{
    void *plain;
    memcpy(&plain, &logger, sizeof plain);
    if (token == NULL || strcmp(token, TOKEN) != 0) {
        if (logger != NULL)
            LOG(logger, environment, name, ERROR, "logStatusError",
                FMI == 3 ? "the instantiation token is wrong" : "the GUID is wrong");
        return NULL;
    }
    return make_instance(name, environment, plain);
}

static void started_at(Model *m, int tolerance_defined, double tolerance, double start)
{
    m->t = m->passed = start;
    if (tolerance_defined && tolerance > 0.0)
        m->rtol = tolerance;
    changed(m);
}

#if FMI == 3

EXPORT void *fmi3InstantiateModelExchange(const char *name, const char *token,
    const char *resources, bool visible, bool logging, void *environment, Logger logger)
{
    return made(name, token, environment, logger);
}

EXPORT void *fmi3InstantiateCoSimulation(const char *name, const char *token,
    const char *resources, bool visible, bool logging, bool event_mode, bool early_return,
    const Reference *required, size_t n, void *environment, Logger logger, void (*update)(void))
{
    return made(name, token, environment, logger);
}

EXPORT void *fmi3InstantiateScheduledExecution(const char *name, const char *token,
    const char *resources, bool visible, bool logging, void *environment, Logger logger,
    void (*clock)(void), void (*lock)(void), void (*unlock)(void))
{
    return NULL;
}

STATUS fmi3EnterInitializationMode(void *instance, bool tolerance_defined, double tolerance,
    double start, bool stop_defined, double stop)
{
    SELF;
    started_at(m, tolerance_defined, tolerance, start);
    return OK;
}

#else

typedef struct {
    Logger logger;
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*finished)(void *, Status);
    void *environment;
} Callbacks;

EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }

EXPORT void *fmi2Instantiate(const char *name, int type, const char *guid,
    const char *resources, const Callbacks *callbacks, int visible, int logging)
{
    const Callbacks none = {0}, *given = callbacks == NULL ? &none : callbacks;
    return made(name, guid, given->environment, given->logger);
}

STATUS fmi2SetupExperiment(void *instance, int tolerance_defined, double tolerance,
    double start, int stop_defined, double stop)
{
    SELF;
    started_at(m, tolerance_defined, tolerance, start);
    return OK;
}

TRIVIAL(EnterInitializationMode, void *instance)

#endif

EXPORT void NAME(FreeInstance)(void *instance) { free_instance(instance); }

STATUS NAME(ExitInitializationMode)(void *instance)
{
    SELF;
    take_sides(m);
    remember_inputs(m);
    if (update_rates(m))
        return told(self, 1, MASS_IS_SINGULAR);
    return checked_start(self);
}

TRIVIAL(EnterEventMode, void *instance)
TRIVIAL(Terminate, void *instance)

STATUS NAME(Reset)(void *instance)
{
    SELF;
    model_reset(m);
    return OK;
}

/* -- values: all are real numbers ----------------------------------------------------------------- */

static Status got(Instance *self, const Reference *vr, size_t n, double *values)
{
    int failed = 0;
    for (size_t k = 0; k < n && !failed; k++)
        failed = get_real(&self->model, vr[k], values + k);
    return told(self, failed, MASS_IS_SINGULAR);
}

static Status set(Instance *self, const Reference *vr, size_t n, const double *values)
{
    int failed = 0;
    for (size_t k = 0; k < n && !failed; k++)
        failed = set_real(&self->model, vr[k], values[k]);
    return told(self, failed, "the variable cannot be set");
}

#define NONE(FUNCTION, ...) \
    STATUS NAME(FUNCTION)(void *i, const Reference *vr, size_t n, __VA_ARGS__) \
    { return n == 0 ? OK : ERROR; }

#if FMI == 3

STATUS fmi3GetFloat64(void *instance, const Reference *vr, size_t n, double *values, size_t nv)
{
    return n != nv ? told(instance, 1, WRONG_SIZE) : got(instance, vr, n, values);
}

STATUS fmi3SetFloat64(
    void *instance, const Reference *vr, size_t n, const double *values, size_t nv)
{
    return n != nv ? told(instance, 1, WRONG_SIZE) : set(instance, vr, n, values);
}

#define OTHER(KIND, TYPE) \
    NONE(Get##KIND, TYPE *v, size_t nv) \
    NONE(Set##KIND, const TYPE *v, size_t nv)

OTHER(Float32, float)
OTHER(Int8, int8_t)
OTHER(UInt8, uint8_t)
OTHER(Int16, int16_t)
OTHER(UInt16, uint16_t)
OTHER(Int32, int32_t)
OTHER(UInt32, uint32_t)
OTHER(Int64, int64_t)
OTHER(UInt64, uint64_t)
OTHER(Boolean, bool)
OTHER(String, char *)
NONE(GetBinary, size_t *sizes, const uint8_t **values, size_t nv)
NONE(SetBinary, const size_t *sizes, const uint8_t *const *values, size_t nv)
NONE(GetClock, bool *values)
NONE(SetClock, const bool *values)
ABSENT(GetNumberOfVariableDependencies, void *i, Reference vr, size_t *n)
ABSENT(GetVariableDependencies, void *i, Reference vr, size_t *elements, Reference *independents,
    size_t *others, int *kinds, size_t n)

#else

STATUS fmi2GetReal(void *instance, const Reference *vr, size_t n, double *values)
{
    return got(instance, vr, n, values);
}

STATUS fmi2SetReal(void *instance, const Reference *vr, size_t n, const double *values)
{
    return set(instance, vr, n, values);
}

#define OTHER(KIND, TYPE) \
    NONE(Get##KIND, TYPE *v) \
    NONE(Set##KIND, const TYPE *v)

OTHER(Integer, int)
OTHER(Boolean, int)
OTHER(String, char *)

#endif

/* -- saved states --------------------------------------------------------------------------------- */

#if FMI == 3
#define SAVED(verb, rest) fmi3##verb##FMUState##rest
#define RESTORE fmi3DeserializeFMUState
#else
#define SAVED(verb, rest) fmi2##verb##FMUstate##rest
#define RESTORE fmi2DeSerializeFMUstate
#endif

static Status copied(void **state, const void *source)
{
    if (*state == NULL)
        *state = malloc(sizeof(Model));
    if (*state == NULL)
        return ERROR;
    memcpy(*state, source, sizeof(Model));
    return OK;
}

STATUS SAVED(Get, )(void *instance, void **state)
{
    SELF;
    return copied(state, m);
}

STATUS SAVED(Set, )(void *instance, void *state)
{
    SELF;
    memcpy(m, state, sizeof *m);
    return OK;
}

STATUS SAVED(Free, )(void *instance, void **state)
{
    free(*state);
    *state = NULL;
    return OK;
}

STATUS SAVED(Serialized, Size)(void *instance, void *state, size_t *size)
{
    *size = sizeof(Model);
    return OK;
}

STATUS SAVED(Serialize, )(void *instance, void *state, Byte *bytes, size_t size)
{
    if (size < sizeof(Model))
        return ERROR;
    memcpy(bytes, state, sizeof(Model));
    return OK;
}

STATUS RESTORE(void *instance, const Byte *bytes, size_t size, void **state)
{
    return size == sizeof(Model) ? copied(state, bytes) : ERROR;
}

/* -- derivatives ---------------------------------------------------------------------------------- */

#if FMI == 3

STATUS fmi3GetDirectionalDerivative(void *instance, const Reference *unknowns, size_t rows,
    const Reference *knowns, size_t columns, const double *seed, size_t ns, double *sensitivity,
    size_t n)
{
    SELF;
    const int failed = ns != columns || n != rows
        || derivative(m, unknowns, rows, knowns, columns, seed, sensitivity, 0);
    return told(self, failed, MASS_IS_SINGULAR);
}

STATUS fmi3GetAdjointDerivative(void *instance, const Reference *unknowns, size_t rows,
    const Reference *knowns, size_t columns, const double *seed, size_t ns, double *sensitivity,
    size_t n)
{
    SELF;
    const int failed = ns != rows || n != columns
        || derivative(m, unknowns, rows, knowns, columns, seed, sensitivity, 1);
    return told(self, failed, MASS_IS_SINGULAR);
}

/* There are neither structure, clocks nor partitions. */
ABSENT(EnterConfigurationMode, void *i)
ABSENT(ExitConfigurationMode, void *i)
ABSENT(GetIntervalDecimal, void *i, const Reference *vr, size_t n, double *intervals, int *kinds)
ABSENT(GetIntervalFraction, void *i, const Reference *vr, size_t n, uint64_t *counters,
    uint64_t *resolutions, int *kinds)
ABSENT(GetShiftDecimal, void *i, const Reference *vr, size_t n, double *shifts)
ABSENT(GetShiftFraction, void *i, const Reference *vr, size_t n, uint64_t *counters,
    uint64_t *resolutions)
ABSENT(SetIntervalDecimal, void *i, const Reference *vr, size_t n, const double *intervals)
ABSENT(SetIntervalFraction, void *i, const Reference *vr, size_t n, const uint64_t *counters,
    const uint64_t *resolutions)
ABSENT(SetShiftDecimal, void *i, const Reference *vr, size_t n, const double *shifts)
ABSENT(SetShiftFraction, void *i, const Reference *vr, size_t n, const uint64_t *counters,
    const uint64_t *resolutions)
ABSENT(ActivateModelPartition, void *i, Reference clock, double time)

#else

STATUS fmi2GetDirectionalDerivative(void *instance, const Reference *unknowns, size_t rows,
    const Reference *knowns, size_t columns, const double *seed, double *sensitivity)
{
    SELF;
    const int failed = derivative(m, unknowns, rows, knowns, columns, seed, sensitivity, 0);
    return told(self, failed, MASS_IS_SINGULAR);
}

#endif

/* -- Model Exchange ------------------------------------------------------------------------------- */

#if FMI == 3

TRIVIAL(EvaluateDiscreteStates, void *instance)

STATUS fmi3UpdateDiscreteStates(void *instance, bool *again, bool *terminate,
    bool *nominals_changed, bool *states_changed, bool *next_event_defined, double *next_event)
{
    SELF;
    int moved;
    *terminate = is_end(handle_events(m, &moved));
    *again = *nominals_changed = false;
    *states_changed = moved;
    *next_event = next_switch(m);
    *next_event_defined = isfinite(*next_event);
    return ended(self);
}

STATUS fmi3GetNumberOfEventIndicators(void *instance, size_t *n) { *n = NE; return OK; }
STATUS fmi3GetNumberOfContinuousStates(void *instance, size_t *n) { *n = NX; return OK; }

#define GET_DERIVATIVES fmi3GetContinuousStateDerivatives

#else

typedef struct {
    int again, terminate, nominals_changed, states_changed, next_event_defined;
    double next_event;
} EventInfo;

STATUS fmi2NewDiscreteStates(void *instance, EventInfo *info)
{
    SELF;
    int moved;
    info->terminate = is_end(handle_events(m, &moved));
    info->again = info->nominals_changed = 0;
    info->states_changed = moved;
    info->next_event = next_switch(m);
    info->next_event_defined = isfinite(info->next_event);
    return ended(self);
}

#define GET_DERIVATIVES fmi2GetDerivatives

#endif

TRIVIAL(EnterContinuousTimeMode, void *instance)

STATUS NAME(CompletedIntegratorStep)(
    void *instance, Flag no_set_state, Flag *event_mode, Flag *terminate)
{
    SELF;
    int waits;
    *terminate = is_end(complete_step(m, &waits));
    *event_mode = waits;
    return ended(self);
}

STATUS NAME(SetTime)(void *instance, double time)
{
    SELF;
    m->t = time;
    changed(m);
    return OK;
}

STATUS NAME(SetContinuousStates)(void *instance, const double *x, size_t n)
{
    SELF;
    if (n == NX) {
        memcpy(m->x, x, NX * sizeof(double));
        changed(m);
    }
    return told(self, n != NX, WRONG_SIZE);
}

STATUS NAME(GetContinuousStates)(void *instance, double *x, size_t n)
{
    SELF;
    if (n == NX)
        memcpy(x, m->x, NX * sizeof(double));
    return told(self, n != NX, WRONG_SIZE);
}

STATUS GET_DERIVATIVES(void *instance, double *rates, size_t n)
{
    SELF;
    const int failed = n != NX || update_rates(m);
    if (!failed)
        memcpy(rates, m->rates, NX * sizeof(double));
    return told(self, failed, MASS_IS_SINGULAR);
}

/* A NaN has no sign to change: the importer may try a smaller step, or has to stop. */
STATUS NAME(GetEventIndicators)(void *instance, double *values, size_t n)
{
    SELF;
    if (n != NE)
        return told(self, 1, WRONG_SIZE);
#if NE > 0
    event_values(m, m->t, m->x, m->z);
    note_seen(m, SEEN);
    memcpy(values, m->z, NE * sizeof(double));
    for (int k = 0; k < NE; k++)
        if (isnan(values[k])) {
            char message[256];
            snprintf(message, sizeof message, "the event %s is NaN", MODEL(event_names)[k]);
            return logged(self, DISCARD, message);
        }
#endif
    return OK;
}

STATUS NAME(GetNominalsOfContinuousStates)(void *instance, double *nominals, size_t n)
{
    for (size_t k = 0; k < n; k++)
        nominals[k] = 1.0;
    return OK;
}

/* -- Co-Simulation -------------------------------------------------------------------------------- */

/* Integrate over a step, unless an event has ended the motion before. A point is told with roundings. */
static Status stepped(Instance *self, double point, double step)
{
    Model *m = &self->model;
    const double goal = point + step, apart = fabs(point - m->t);
    const double told_to = CLOSE * step + ROUNDINGS * ROUNDING * fabs(m->t);
    if (!(step >= 0.0 && isfinite(goal) && (apart <= told_to || is_end(m->outcome))))
        return told(self, 1, "the step must be finite, not negative, and begin at the present time");
    if (is_end(m->outcome))
        return OK;
    m->outcome = FINISHED;
    integrate(m, goal);
    return ended(self);
}

#if FMI == 3

TRIVIAL(EnterStepMode, void *instance)
ABSENT(GetOutputDerivatives, void *instance, const Reference *vr, size_t n, const int32_t *orders,
    double *values, size_t nv)

STATUS fmi3DoStep(void *instance, double point, double step, bool no_set_state,
    bool *event_needed, bool *terminate, bool *early, double *last)
{
    SELF;
    const Status status = stepped(self, point, step);
    *event_needed = *early = false;
    *terminate = is_end(m->outcome);
    *last = m->t;
    return status;
}

#else

ABSENT(SetRealInputDerivatives, void *instance, const Reference *vr, size_t n, const int *orders,
    const double *values)
ABSENT(GetRealOutputDerivatives, void *instance, const Reference *vr, size_t n, const int *orders,
    double *values)
ABSENT(CancelStep, void *instance)

/* A step that an event ended is discarded, as FMI 2.0 has it: fmi2Terminated tells why. */
STATUS fmi2DoStep(void *instance, double point, double step, int no_set_state)
{
    Instance *self = instance;
    const Status status = stepped(self, point, step);
    return status == OK && is_end(self->model.outcome) ? DISCARD : status;
}

enum { DO_STEP_STATUS, PENDING_STATUS, LAST_SUCCESSFUL_TIME, HAS_TERMINATED };

#define ASKED(KIND, TYPE, WHAT, VALUE) \
    STATUS fmi2Get##KIND##Status(void *instance, int kind, TYPE *value) \
    { \
        Instance *self = instance; \
        if (kind != (WHAT) || self == NULL) \
            return DISCARD; \
        *value = (VALUE); \
        return OK; \
    }

ASKED(Real, double, LAST_SUCCESSFUL_TIME, self->model.t)
ASKED(Boolean, int, HAS_TERMINATED, is_end(self->model.outcome))

STATUS fmi2GetStatus(void *instance, int kind, Status *value) { return DISCARD; }
STATUS fmi2GetIntegerStatus(void *instance, int kind, int *value) { return DISCARD; }
STATUS fmi2GetStringStatus(void *instance, int kind, const char **value) { return DISCARD; }

#endif
