/* The interface of FMI 3.0, declared here as its specification gives it. */

#include <stdbool.h>
#include <stdint.h>

#include "fmu_core.c"

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORT __attribute__((visibility("default")))
#else
#define EXPORT
#endif

typedef void *fmi3Instance;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef uint32_t Reference;
typedef void (*Logger)(void *, fmi3Status, const char *, const char *);

#define STATUS EXPORT fmi3Status
#define SELF Instance *self = instance; Model *m = &self->model

static fmi3Status told(Instance *self, int failed, const char *message)
{
    Logger logger;
    if (!failed)
        return fmi3OK;
    memcpy(&logger, &self->logger, sizeof logger);
    if (logger != NULL)
        logger(self->environment, fmi3Error, "logStatusError", message);
    return fmi3Error;
}

static const char *const MASS_IS_SINGULAR = "the mass matrix is singular, or a value reference is wrong";

EXPORT const char *fmi3GetVersion(void) { return "3.0"; }

STATUS fmi3SetDebugLogging(fmi3Instance instance, bool on, size_t n, const char *const *categories)
{
    (void)instance, (void)on, (void)n, (void)categories;
    return fmi3OK;
}

/* -- instances ---------------------------------------------------------------------------------- */

static fmi3Instance made(const char *name, const char *token, void *environment, Logger logger)
{
    void *plain;
    memcpy(&plain, &logger, sizeof plain);
    if (token == NULL || strcmp(token, TOKEN) != 0) {
        if (logger != NULL)
            logger(environment, fmi3Error, "logStatusError", "the instantiation token is wrong");
        return NULL;
    }
    return make_instance(name, environment, plain);
}

EXPORT fmi3Instance fmi3InstantiateModelExchange(const char *name, const char *token,
    const char *resources, bool visible, bool logging, void *environment, Logger logger)
{
    (void)resources, (void)visible, (void)logging;
    return made(name, token, environment, logger);
}

EXPORT fmi3Instance fmi3InstantiateCoSimulation(const char *name, const char *token,
    const char *resources, bool visible, bool logging, bool event_mode, bool early_return,
    const Reference *required, size_t n, void *environment, Logger logger, void (*update)(void))
{
    (void)resources, (void)visible, (void)logging, (void)event_mode, (void)early_return;
    (void)required, (void)n, (void)update;
    return made(name, token, environment, logger);
}

EXPORT fmi3Instance fmi3InstantiateScheduledExecution(const char *name, const char *token,
    const char *resources, bool visible, bool logging, void *environment, Logger logger,
    void (*clock)(void), void (*lock)(void), void (*unlock)(void))
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)environment;
    (void)logger, (void)clock, (void)lock, (void)unlock;
    return NULL;
}

EXPORT void fmi3FreeInstance(fmi3Instance instance) { free_instance(instance); }

STATUS fmi3EnterInitializationMode(fmi3Instance instance, bool tolerance_defined, double tolerance,
    double start, bool stop_defined, double stop)
{
    SELF;
    (void)stop_defined, (void)stop;
    m->t = start;
    if (tolerance_defined && tolerance > 0.0)
        m->rtol = tolerance;
    changed(m);
    return fmi3OK;
}

STATUS fmi3ExitInitializationMode(fmi3Instance instance)
{
    SELF;
    take_sides(m);
    return told(self, update_rates(m), MASS_IS_SINGULAR);
}

STATUS fmi3EnterEventMode(fmi3Instance instance) { (void)instance; return fmi3OK; }
STATUS fmi3Terminate(fmi3Instance instance) { (void)instance; return fmi3OK; }

STATUS fmi3Reset(fmi3Instance instance)
{
    SELF;
    model_reset(m);
    self->stopped = 0;
    return fmi3OK;
}

/* -- values -------------------------------------------------------------------------------------- */

STATUS fmi3GetFloat64(fmi3Instance instance, const Reference *vr, size_t n, double *values, size_t nv)
{
    SELF;
    int failed = n != nv;
    for (size_t k = 0; k < n && !failed; k++)
        failed = get_real(m, vr[k], values + k);
    return told(self, failed, MASS_IS_SINGULAR);
}

STATUS fmi3SetFloat64(
    fmi3Instance instance, const Reference *vr, size_t n, const double *values, size_t nv)
{
    SELF;
    int failed = n != nv;
    for (size_t k = 0; k < n && !failed; k++)
        failed = set_real(m, vr[k], values[k]);
    return told(self, failed, "the variable cannot be set");
}

/* There are variables of no other type. */
#define OTHER(NAME, TYPE) \
    STATUS fmi3Get##NAME(fmi3Instance i, const Reference *vr, size_t n, TYPE *v, size_t nv) \
    { (void)i, (void)vr, (void)v, (void)nv; return n == 0 ? fmi3OK : fmi3Error; } \
    STATUS fmi3Set##NAME(fmi3Instance i, const Reference *vr, size_t n, const TYPE *v, size_t nv) \
    { (void)i, (void)vr, (void)v, (void)nv; return n == 0 ? fmi3OK : fmi3Error; }

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

STATUS fmi3GetBinary(fmi3Instance i, const Reference *vr, size_t n, size_t *sizes,
    const uint8_t **values, size_t nv)
{
    (void)i, (void)vr, (void)sizes, (void)values, (void)nv;
    return n == 0 ? fmi3OK : fmi3Error;
}

STATUS fmi3SetBinary(fmi3Instance i, const Reference *vr, size_t n, const size_t *sizes,
    const uint8_t *const *values, size_t nv)
{
    (void)i, (void)vr, (void)sizes, (void)values, (void)nv;
    return n == 0 ? fmi3OK : fmi3Error;
}

STATUS fmi3GetClock(fmi3Instance i, const Reference *vr, size_t n, bool *values)
{
    (void)i, (void)vr, (void)values;
    return n == 0 ? fmi3OK : fmi3Error;
}

STATUS fmi3SetClock(fmi3Instance i, const Reference *vr, size_t n, const bool *values)
{
    (void)i, (void)vr, (void)values;
    return n == 0 ? fmi3OK : fmi3Error;
}

STATUS fmi3GetNumberOfVariableDependencies(fmi3Instance i, Reference vr, size_t *n)
{
    (void)i, (void)vr, (void)n;
    return fmi3Error;
}

STATUS fmi3GetVariableDependencies(fmi3Instance i, Reference vr, size_t *elements,
    Reference *independents, size_t *others, int *kinds, size_t n)
{
    (void)i, (void)vr, (void)elements, (void)independents, (void)others, (void)kinds, (void)n;
    return fmi3Error;
}

/* -- saved states ---------------------------------------------------------------------------------- */

STATUS fmi3GetFMUState(fmi3Instance instance, void **state)
{
    SELF;
    if (*state == NULL)
        *state = malloc(sizeof *m);
    if (*state == NULL)
        return fmi3Error;
    memcpy(*state, m, sizeof *m);
    return fmi3OK;
}

STATUS fmi3SetFMUState(fmi3Instance instance, void *state)
{
    SELF;
    memcpy(m, state, sizeof *m);
    return fmi3OK;
}

STATUS fmi3FreeFMUState(fmi3Instance instance, void **state)
{
    (void)instance;
    free(*state);
    *state = NULL;
    return fmi3OK;
}

STATUS fmi3SerializedFMUStateSize(fmi3Instance instance, void *state, size_t *size)
{
    (void)instance, (void)state;
    *size = sizeof(Model);
    return fmi3OK;
}

STATUS fmi3SerializeFMUState(fmi3Instance instance, void *state, uint8_t *bytes, size_t size)
{
    (void)instance;
    if (size < sizeof(Model))
        return fmi3Error;
    memcpy(bytes, state, sizeof(Model));
    return fmi3OK;
}

STATUS fmi3DeserializeFMUState(
    fmi3Instance instance, const uint8_t *bytes, size_t size, void **state)
{
    (void)instance;
    if (size != sizeof(Model))
        return fmi3Error;
    if (*state == NULL)
        *state = malloc(sizeof(Model));
    if (*state == NULL)
        return fmi3Error;
    memcpy(*state, bytes, sizeof(Model));
    return fmi3OK;
}

/* -- derivatives ----------------------------------------------------------------------------------- */

STATUS fmi3GetDirectionalDerivative(fmi3Instance instance, const Reference *unknowns, size_t rows,
    const Reference *knowns, size_t columns, const double *seed, size_t ns, double *sensitivity,
    size_t n)
{
    SELF;
    const int failed = ns != columns || n != rows
        || derivative(m, unknowns, rows, knowns, columns, seed, sensitivity, 0);
    return told(self, failed, MASS_IS_SINGULAR);
}

STATUS fmi3GetAdjointDerivative(fmi3Instance instance, const Reference *unknowns, size_t rows,
    const Reference *knowns, size_t columns, const double *seed, size_t ns, double *sensitivity,
    size_t n)
{
    SELF;
    const int failed = ns != rows || n != columns
        || derivative(m, unknowns, rows, knowns, columns, seed, sensitivity, 1);
    return told(self, failed, MASS_IS_SINGULAR);
}

/* -- what this model does not have: structure, clocks, partitions ------------------------------------ */

STATUS fmi3EnterConfigurationMode(fmi3Instance i) { (void)i; return fmi3Error; }
STATUS fmi3ExitConfigurationMode(fmi3Instance i) { (void)i; return fmi3Error; }

STATUS fmi3GetIntervalDecimal(
    fmi3Instance i, const Reference *vr, size_t n, double *intervals, int *qualifiers)
{
    (void)i, (void)vr, (void)n, (void)intervals, (void)qualifiers;
    return fmi3Error;
}

STATUS fmi3GetIntervalFraction(fmi3Instance i, const Reference *vr, size_t n, uint64_t *counters,
    uint64_t *resolutions, int *qualifiers)
{
    (void)i, (void)vr, (void)n, (void)counters, (void)resolutions, (void)qualifiers;
    return fmi3Error;
}

STATUS fmi3GetShiftDecimal(fmi3Instance i, const Reference *vr, size_t n, double *shifts)
{
    (void)i, (void)vr, (void)n, (void)shifts;
    return fmi3Error;
}

STATUS fmi3GetShiftFraction(
    fmi3Instance i, const Reference *vr, size_t n, uint64_t *counters, uint64_t *resolutions)
{
    (void)i, (void)vr, (void)n, (void)counters, (void)resolutions;
    return fmi3Error;
}

STATUS fmi3SetIntervalDecimal(
    fmi3Instance i, const Reference *vr, size_t n, const double *intervals)
{
    (void)i, (void)vr, (void)n, (void)intervals;
    return fmi3Error;
}

STATUS fmi3SetIntervalFraction(fmi3Instance i, const Reference *vr, size_t n,
    const uint64_t *counters, const uint64_t *resolutions)
{
    (void)i, (void)vr, (void)n, (void)counters, (void)resolutions;
    return fmi3Error;
}

STATUS fmi3SetShiftDecimal(fmi3Instance i, const Reference *vr, size_t n, const double *shifts)
{
    (void)i, (void)vr, (void)n, (void)shifts;
    return fmi3Error;
}

STATUS fmi3SetShiftFraction(fmi3Instance i, const Reference *vr, size_t n,
    const uint64_t *counters, const uint64_t *resolutions)
{
    (void)i, (void)vr, (void)n, (void)counters, (void)resolutions;
    return fmi3Error;
}

STATUS fmi3ActivateModelPartition(fmi3Instance i, Reference clock, double time)
{
    (void)i, (void)clock, (void)time;
    return fmi3Error;
}

/* -- events ------------------------------------------------------------------------------------------ */

STATUS fmi3EvaluateDiscreteStates(fmi3Instance instance) { (void)instance; return fmi3OK; }

STATUS fmi3UpdateDiscreteStates(fmi3Instance instance, bool *again, bool *terminate,
    bool *nominals_changed, bool *states_changed, bool *next_event_defined, double *next_event)
{
    SELF;
    int moved;
    *terminate = handle_events(m, &moved);
    *again = *nominals_changed = *next_event_defined = false;
    *states_changed = moved;
    *next_event = 0.0;
    return fmi3OK;
}

/* -- Model Exchange ----------------------------------------------------------------------------------- */

STATUS fmi3EnterContinuousTimeMode(fmi3Instance instance) { (void)instance; return fmi3OK; }

STATUS fmi3CompletedIntegratorStep(
    fmi3Instance instance, bool no_set_state, bool *event_mode, bool *terminate)
{
    (void)instance, (void)no_set_state;
    *event_mode = *terminate = false;
    return fmi3OK;
}

STATUS fmi3SetTime(fmi3Instance instance, double time)
{
    SELF;
    m->t = time;
    changed(m);
    return fmi3OK;
}

STATUS fmi3SetContinuousStates(fmi3Instance instance, const double *x, size_t n)
{
    SELF;
    if (n != NX)
        return fmi3Error;
    memcpy(m->x, x, NX * sizeof(double));
    changed(m);
    return fmi3OK;
}

STATUS fmi3GetContinuousStates(fmi3Instance instance, double *x, size_t n)
{
    SELF;
    if (n != NX)
        return fmi3Error;
    memcpy(x, m->x, NX * sizeof(double));
    return fmi3OK;
}

STATUS fmi3GetContinuousStateDerivatives(fmi3Instance instance, double *rates, size_t n)
{
    SELF;
    const int failed = n != NX || update_rates(m);
    if (!failed)
        memcpy(rates, m->rates, NX * sizeof(double));
    return told(self, failed, MASS_IS_SINGULAR);
}

STATUS fmi3GetEventIndicators(fmi3Instance instance, double *values, size_t n)
{
    SELF;
    if (n != NE)
        return fmi3Error;
    event_values(m, m->t, m->x, m->z);
    memcpy(values, m->z, NE * sizeof(double));
    return fmi3OK;
}

STATUS fmi3GetNominalsOfContinuousStates(fmi3Instance instance, double *nominals, size_t n)
{
    (void)instance;
    for (size_t k = 0; k < n; k++)
        nominals[k] = 1.0;
    return fmi3OK;
}

STATUS fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t *n)
{
    (void)instance;
    *n = NE;
    return fmi3OK;
}

STATUS fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t *n)
{
    (void)instance;
    *n = NX;
    return fmi3OK;
}

/* -- Co-Simulation ------------------------------------------------------------------------------------- */

STATUS fmi3EnterStepMode(fmi3Instance instance) { (void)instance; return fmi3OK; }

STATUS fmi3GetOutputDerivatives(fmi3Instance instance, const Reference *vr, size_t n,
    const int32_t *orders, double *values, size_t nv)
{
    (void)instance, (void)vr, (void)n, (void)orders, (void)values, (void)nv;
    return fmi3Error;
}

STATUS fmi3DoStep(fmi3Instance instance, double point, double step, bool no_set_state,
    bool *event_needed, bool *terminate, bool *early, double *last)
{
    SELF;
    int outcome = ENDED;
    (void)no_set_state;
    if (!self->stopped)
        outcome = integrate(m, point + step);
    self->stopped = outcome == ENDED;
    *event_needed = *early = false;
    *terminate = outcome == ENDED;
    *last = m->t;
    return told(self, outcome == FAILED, "the state is singular or infinite, or an event is NaN");
}
