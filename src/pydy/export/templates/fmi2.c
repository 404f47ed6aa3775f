/* The interface of FMI 2.0, declared here as its specification gives it. */

#include "fmu_core.c"

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORT __attribute__((visibility("default")))
#else
#define EXPORT
#endif

typedef void *fmi2Component;
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef unsigned int Reference;
typedef void (*Logger)(void *, const char *, fmi2Status, const char *, const char *, ...);

typedef struct {
    Logger logger;
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*finished)(void *, fmi2Status);
    void *environment;
} Callbacks;

typedef struct {
    int again, terminate, nominals_changed, states_changed, next_event_defined;
    double next_event;
} EventInfo;

#define STATUS EXPORT fmi2Status
#define SELF Instance *self = instance; Model *m = &self->model

static fmi2Status told(Instance *self, int failed, const char *message)
{
    Logger logger;
    if (!failed)
        return fmi2OK;
    memcpy(&logger, &self->logger, sizeof logger);
    if (logger != NULL)
        logger(self->environment, self->name, fmi2Error, "logStatusError", "%s", message);
    return fmi2Error;
}

static const char *const MASS_IS_SINGULAR = "the mass matrix is singular, or a value reference is wrong";

EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }
EXPORT const char *fmi2GetVersion(void) { return "2.0"; }

STATUS fmi2SetDebugLogging(fmi2Component instance, int on, size_t n, const char *const *categories)
{
    (void)instance, (void)on, (void)n, (void)categories;
    return fmi2OK;
}

EXPORT fmi2Component fmi2Instantiate(const char *name, int type, const char *guid,
    const char *resources, const Callbacks *callbacks, int visible, int logging)
{
    void *plain = NULL;
    (void)type, (void)resources, (void)visible, (void)logging;
    if (callbacks != NULL)
        memcpy(&plain, &callbacks->logger, sizeof plain);
    if (guid == NULL || strcmp(guid, TOKEN) != 0) {
        if (plain != NULL)
            callbacks->logger(callbacks->environment, name, fmi2Error, "logStatusError",
                "the GUID is wrong");
        return NULL;
    }
    return make_instance(name, callbacks == NULL ? NULL : callbacks->environment, plain);
}

EXPORT void fmi2FreeInstance(fmi2Component instance) { free_instance(instance); }

STATUS fmi2SetupExperiment(fmi2Component instance, int tolerance_defined, double tolerance,
    double start, int stop_defined, double stop)
{
    SELF;
    (void)stop_defined, (void)stop;
    m->t = start;
    if (tolerance_defined && tolerance > 0.0)
        m->rtol = tolerance;
    changed(m);
    return fmi2OK;
}

STATUS fmi2EnterInitializationMode(fmi2Component instance) { (void)instance; return fmi2OK; }

STATUS fmi2ExitInitializationMode(fmi2Component instance)
{
    SELF;
    take_sides(m);
    return told(self, update_rates(m), MASS_IS_SINGULAR);
}

STATUS fmi2Terminate(fmi2Component instance) { (void)instance; return fmi2OK; }

STATUS fmi2Reset(fmi2Component instance)
{
    SELF;
    model_reset(m);
    self->stopped = 0;
    return fmi2OK;
}

/* -- values -------------------------------------------------------------------------------------- */

STATUS fmi2GetReal(fmi2Component instance, const Reference *vr, size_t n, double *values)
{
    SELF;
    int failed = 0;
    for (size_t k = 0; k < n && !failed; k++)
        failed = get_real(m, vr[k], values + k);
    return told(self, failed, MASS_IS_SINGULAR);
}

STATUS fmi2SetReal(fmi2Component instance, const Reference *vr, size_t n, const double *values)
{
    SELF;
    int failed = 0;
    for (size_t k = 0; k < n && !failed; k++)
        failed = set_real(m, vr[k], values[k]);
    return told(self, failed, "the variable cannot be set");
}

/* There are variables of no other type. */
#define OTHER(NAME, TYPE) \
    STATUS fmi2Get##NAME(fmi2Component i, const Reference *vr, size_t n, TYPE *v) \
    { (void)i, (void)vr, (void)v; return n == 0 ? fmi2OK : fmi2Error; } \
    STATUS fmi2Set##NAME(fmi2Component i, const Reference *vr, size_t n, const TYPE *v) \
    { (void)i, (void)vr, (void)v; return n == 0 ? fmi2OK : fmi2Error; }

OTHER(Integer, int)
OTHER(Boolean, int)
OTHER(String, char *)

/* -- saved states ---------------------------------------------------------------------------------- */

STATUS fmi2GetFMUstate(fmi2Component instance, void **state)
{
    SELF;
    if (*state == NULL)
        *state = malloc(sizeof *m);
    if (*state == NULL)
        return fmi2Error;
    memcpy(*state, m, sizeof *m);
    return fmi2OK;
}

STATUS fmi2SetFMUstate(fmi2Component instance, void *state)
{
    SELF;
    memcpy(m, state, sizeof *m);
    return fmi2OK;
}

STATUS fmi2FreeFMUstate(fmi2Component instance, void **state)
{
    (void)instance;
    free(*state);
    *state = NULL;
    return fmi2OK;
}

STATUS fmi2SerializedFMUstateSize(fmi2Component instance, void *state, size_t *size)
{
    (void)instance, (void)state;
    *size = sizeof(Model);
    return fmi2OK;
}

STATUS fmi2SerializeFMUstate(fmi2Component instance, void *state, char *bytes, size_t size)
{
    (void)instance;
    if (size < sizeof(Model))
        return fmi2Error;
    memcpy(bytes, state, sizeof(Model));
    return fmi2OK;
}

STATUS fmi2DeSerializeFMUstate(fmi2Component instance, const char *bytes, size_t size, void **state)
{
    (void)instance;
    if (size != sizeof(Model))
        return fmi2Error;
    if (*state == NULL)
        *state = malloc(sizeof(Model));
    if (*state == NULL)
        return fmi2Error;
    memcpy(*state, bytes, sizeof(Model));
    return fmi2OK;
}

STATUS fmi2GetDirectionalDerivative(fmi2Component instance, const Reference *unknowns, size_t rows,
    const Reference *knowns, size_t columns, const double *seed, double *sensitivity)
{
    SELF;
    const int failed = derivative(m, unknowns, rows, knowns, columns, seed, sensitivity, 0);
    return told(self, failed, MASS_IS_SINGULAR);
}

/* -- Model Exchange ----------------------------------------------------------------------------------- */

STATUS fmi2EnterEventMode(fmi2Component instance) { (void)instance; return fmi2OK; }

STATUS fmi2NewDiscreteStates(fmi2Component instance, EventInfo *info)
{
    SELF;
    int moved;
    info->terminate = handle_events(m, &moved);
    info->again = info->nominals_changed = info->next_event_defined = 0;
    info->states_changed = moved;
    info->next_event = 0.0;
    return fmi2OK;
}

STATUS fmi2EnterContinuousTimeMode(fmi2Component instance) { (void)instance; return fmi2OK; }

STATUS fmi2CompletedIntegratorStep(
    fmi2Component instance, int no_set_state, int *event_mode, int *terminate)
{
    (void)instance, (void)no_set_state;
    *event_mode = *terminate = 0;
    return fmi2OK;
}

STATUS fmi2SetTime(fmi2Component instance, double time)
{
    SELF;
    m->t = time;
    changed(m);
    return fmi2OK;
}

STATUS fmi2SetContinuousStates(fmi2Component instance, const double *x, size_t n)
{
    SELF;
    if (n != NX)
        return fmi2Error;
    memcpy(m->x, x, NX * sizeof(double));
    changed(m);
    return fmi2OK;
}

STATUS fmi2GetContinuousStates(fmi2Component instance, double *x, size_t n)
{
    SELF;
    if (n != NX)
        return fmi2Error;
    memcpy(x, m->x, NX * sizeof(double));
    return fmi2OK;
}

STATUS fmi2GetDerivatives(fmi2Component instance, double *rates, size_t n)
{
    SELF;
    const int failed = n != NX || update_rates(m);
    if (!failed)
        memcpy(rates, m->rates, NX * sizeof(double));
    return told(self, failed, MASS_IS_SINGULAR);
}

STATUS fmi2GetEventIndicators(fmi2Component instance, double *values, size_t n)
{
    SELF;
    if (n != NE)
        return fmi2Error;
    event_values(m, m->t, m->x, m->z);
    memcpy(values, m->z, NE * sizeof(double));
    return fmi2OK;
}

STATUS fmi2GetNominalsOfContinuousStates(fmi2Component instance, double *nominals, size_t n)
{
    (void)instance;
    for (size_t k = 0; k < n; k++)
        nominals[k] = 1.0;
    return fmi2OK;
}

/* -- Co-Simulation ------------------------------------------------------------------------------------- */

STATUS fmi2SetRealInputDerivatives(fmi2Component instance, const Reference *vr, size_t n,
    const int *orders, const double *values)
{
    (void)instance, (void)vr, (void)n, (void)orders, (void)values;
    return fmi2Error;
}

STATUS fmi2GetRealOutputDerivatives(fmi2Component instance, const Reference *vr, size_t n,
    const int *orders, double *values)
{
    (void)instance, (void)vr, (void)n, (void)orders, (void)values;
    return fmi2Error;
}

/* A step that an event ended is discarded, as FMI 2.0 has it: fmi2Terminated tells why. */
STATUS fmi2DoStep(fmi2Component instance, double point, double step, int no_set_state)
{
    SELF;
    int outcome = ENDED;
    (void)no_set_state;
    if (!self->stopped)
        outcome = integrate(m, point + step);
    self->stopped = outcome == ENDED;
    if (outcome == ENDED)
        return fmi2Discard;
    return told(self, outcome == FAILED, "the state is singular or infinite, or an event is NaN");
}

STATUS fmi2CancelStep(fmi2Component instance) { (void)instance; return fmi2Error; }

enum { DO_STEP_STATUS, PENDING_STATUS, LAST_SUCCESSFUL_TIME, TERMINATED };

STATUS fmi2GetStatus(fmi2Component instance, int kind, fmi2Status *value)
{
    (void)instance, (void)kind, (void)value;
    return fmi2Discard;
}

STATUS fmi2GetRealStatus(fmi2Component instance, int kind, double *value)
{
    SELF;
    if (kind != LAST_SUCCESSFUL_TIME)
        return fmi2Discard;
    *value = m->t;
    return fmi2OK;
}

STATUS fmi2GetIntegerStatus(fmi2Component instance, int kind, int *value)
{
    (void)instance, (void)kind, (void)value;
    return fmi2Discard;
}

STATUS fmi2GetBooleanStatus(fmi2Component instance, int kind, int *value)
{
    Instance *self = instance;
    if (kind != TERMINATED)
        return fmi2Discard;
    *value = self->stopped;
    return fmi2OK;
}

STATUS fmi2GetStringStatus(fmi2Component instance, int kind, const char **value)
{
    (void)instance, (void)kind, (void)value;
    return fmi2Discard;
}
