/* A unit of FMI 3.0, for co-simulation and model exchange: the functions that a run needs. Types as the standard defines them. */
#include <stdbool.h>
#include "unit.h"

typedef void *fmi3Instance;
typedef int fmi3Status;
typedef void (*Logger)(void *, fmi3Status, const char *, const char *);
typedef unsigned int Reference;

enum { OK = 0, WARNING = 1, DISCARD = 2, ERROR = 3 };

static fmi3Status say(Unit *unit, const char *message) {
    ((Logger) unit->log)(unit->environment, ERROR, "logStatusError", message);
    return ERROR;
}

static fmi3Instance made(const char *token, const char *resources, void *environment, Logger log) {
    size_t length = strlen(resources);
    if (strcmp(token, "{" TOKEN "}") != 0 || length == 0 || (resources[length - 1] != '/' && resources[length - 1] != '\\')) {
        log(environment, ERROR, "logStatusError", "wrong token or resources");
        return NULL;
    }
    Unit *unit = unit_new();
    unit->environment = environment;
    unit->log = (void (*)(void)) log;
    unit->name = "unit";
    return unit;
}

EXPORT fmi3Instance fmi3InstantiateCoSimulation(const char *name, const char *token, const char *resources, bool visible, bool logging, bool events,
                                                bool early, const Reference intermediate[], size_t n, void *environment, Logger log, void *update) {
    (void) name; (void) visible; (void) logging; (void) intermediate; (void) update;
    return events || early || n != 0 ? NULL : made(token, resources, environment, log);
}

EXPORT fmi3Instance fmi3InstantiateModelExchange(const char *name, const char *token, const char *resources, bool visible, bool logging, void *environment,
                                                 Logger log) {
    (void) name; (void) visible; (void) logging;
    return made(token, resources, environment, log);
}

EXPORT fmi3Status fmi3SetDebugLogging(fmi3Instance c, bool on, size_t n, const char *const categories[]) {
    (void) c; (void) on; (void) n; (void) categories;
    return OK;
}

EXPORT fmi3Status fmi3EnterInitializationMode(fmi3Instance c, bool tolerant, double tolerance, double start, bool ends, double stop) {
    (void) tolerant; (void) tolerance; (void) ends; (void) stop;
#if defined(NO_START)
    return say(c, "no consistent start values");
#else
    ((Unit *) c)->time = start;
    model_start(((Unit *) c)->x, ((Unit *) c)->p);
    return OK;
#endif
}

EXPORT fmi3Status fmi3ExitInitializationMode(fmi3Instance c) { ((Unit *) c)->initialised = 1; return OK; }
EXPORT fmi3Status fmi3Terminate(fmi3Instance c) { return ((Unit *) c)->initialised ? OK : ERROR; }
EXPORT void fmi3FreeInstance(fmi3Instance c) { free(c); }

EXPORT fmi3Status fmi3GetFloat64(fmi3Instance c, const Reference vr[], size_t n, double value[], size_t values) {
    return n == values ? unit_get(c, vr, n, value) : ERROR;
}

EXPORT fmi3Status fmi3SetFloat64(fmi3Instance c, const Reference vr[], size_t n, const double value[], size_t values) {
    return n == values ? unit_set(c, vr, n, value) : ERROR;
}

EXPORT fmi3Status fmi3DoStep(fmi3Instance c, double time, double step, bool no_prior, bool *event, bool *terminate, bool *early, double *last) {
    (void) no_prior;
    *event = *terminate = *early = false;
    *last = time + step;
    if (fabs(time - ((Unit *) c)->time) > 1e-9) return say(c, "step from a time that was not reached");
    return unit_step(c, step) ? OK : say(c, "the solver found no solution");
}

EXPORT fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, size_t *n) { (void) c; *n = N_STATES; return OK; }
EXPORT fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, size_t *n) { (void) c; *n = N_INDICATORS; return OK; }
EXPORT fmi3Status fmi3EnterEventMode(fmi3Instance c) { (void) c; return OK; }
EXPORT fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance c) { (void) c; return OK; }
EXPORT fmi3Status fmi3SetTime(fmi3Instance c, double time) { ((Unit *) c)->time = time; return OK; }

EXPORT fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, bool *again, bool *terminate, bool *nominals, bool *states, bool *defined, double *next) {
    Unit *unit = c;
    *again = *terminate = *nominals = false;
    *states = model_event(unit->time, unit->x, &unit->next);
    *defined = isfinite(unit->next);
    *next = unit->next;
    return OK;
}

EXPORT fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, bool no_prior, bool *event, bool *terminate) {
    (void) c; (void) no_prior;
    *event = *terminate = false;
    return OK;
}

EXPORT fmi3Status fmi3SetContinuousStates(fmi3Instance c, const double x[], size_t n) {
    memcpy(((Unit *) c)->x, x, n * sizeof(double));
    return n == N_STATES ? OK : ERROR;
}

EXPORT fmi3Status fmi3GetContinuousStates(fmi3Instance c, double x[], size_t n) {
    memcpy(x, ((Unit *) c)->x, n * sizeof(double));
    return n == N_STATES ? OK : ERROR;
}

EXPORT fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, double dx[], size_t n) {
    Unit *unit = c;
    model_derivatives(unit->time, unit->x, unit->u, unit->p, dx);
    return n == N_STATES ? OK : ERROR;
}

EXPORT fmi3Status fmi3GetEventIndicators(fmi3Instance c, double z[], size_t n) {
    Unit *unit = c;
    model_indicators(unit->time, unit->x, unit->u, unit->p, z);
    return n == N_INDICATORS ? OK : ERROR;
}

/* What a run does not need, and the standard asks to be there: refused, whatever is asked. */
#define REFUSED(name) EXPORT fmi3Status fmi3##name(void) { return ERROR; }
EXPORT const char *fmi3GetVersion(void) { return "3.0"; }
EXPORT fmi3Instance fmi3InstantiateScheduledExecution(void) { return NULL; }
EXPORT fmi3Status fmi3Reset(fmi3Instance c) { model_start(((Unit *) c)->x, ((Unit *) c)->p); return OK; }
EXPORT fmi3Status fmi3EnterStepMode(fmi3Instance c) { (void) c; return OK; }
EXPORT fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance c, double x[], size_t n) {
    (void) c;
    for (size_t i = 0; i < n; i++) x[i] = 1;
    return OK;
}
REFUSED(GetFloat32)
REFUSED(GetInt8)
REFUSED(GetUInt8)
REFUSED(GetInt16)
REFUSED(GetUInt16)
REFUSED(GetInt32)
REFUSED(GetUInt32)
REFUSED(GetInt64)
REFUSED(GetUInt64)
REFUSED(GetBoolean)
REFUSED(GetString)
REFUSED(GetBinary)
REFUSED(GetClock)
REFUSED(SetFloat32)
REFUSED(SetInt8)
REFUSED(SetUInt8)
REFUSED(SetInt16)
REFUSED(SetUInt16)
REFUSED(SetInt32)
REFUSED(SetUInt32)
REFUSED(SetInt64)
REFUSED(SetUInt64)
REFUSED(SetBoolean)
REFUSED(SetString)
REFUSED(SetBinary)
REFUSED(SetClock)
REFUSED(GetNumberOfVariableDependencies)
REFUSED(GetVariableDependencies)
REFUSED(GetFMUState)
REFUSED(SetFMUState)
REFUSED(FreeFMUState)
REFUSED(SerializedFMUStateSize)
REFUSED(SerializeFMUState)
REFUSED(DeserializeFMUState)
REFUSED(GetDirectionalDerivative)
REFUSED(GetAdjointDerivative)
REFUSED(EnterConfigurationMode)
REFUSED(ExitConfigurationMode)
REFUSED(GetIntervalDecimal)
REFUSED(GetIntervalFraction)
REFUSED(GetShiftDecimal)
REFUSED(GetShiftFraction)
REFUSED(SetIntervalDecimal)
REFUSED(SetIntervalFraction)
REFUSED(SetShiftDecimal)
REFUSED(SetShiftFraction)
REFUSED(EvaluateDiscreteStates)
REFUSED(GetOutputDerivatives)
REFUSED(ActivateModelPartition)
