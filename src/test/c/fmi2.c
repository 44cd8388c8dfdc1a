/* A unit of FMI 2.0, for co-simulation and model exchange: the functions that a run needs. Types as the standard defines them. */
#include "unit.h"

typedef void *fmi2Component;
typedef int fmi2Status, fmi2Boolean;
typedef void (*Logger)(void *, const char *, fmi2Status, const char *, const char *, ...);
typedef struct {
    Logger logger;
    void *(*allocateMemory)(size_t, size_t);
    void (*freeMemory)(void *);
    void (*stepFinished)(void *, fmi2Status);
    void *componentEnvironment;
} fmi2CallbackFunctions;
typedef struct {
    fmi2Boolean newDiscreteStatesNeeded, terminateSimulation, nominalsOfContinuousStatesChanged, valuesOfContinuousStatesChanged, nextEventTimeDefined;
    double nextEventTime;
} fmi2EventInfo;

enum { OK = 0, WARNING = 1, DISCARD = 2, ERROR = 3 };

static fmi2Status say(Unit *unit, const char *message) {
    ((Logger) unit->log)(unit->environment, unit->name, ERROR, "logStatusError", "%s at %g s", message, unit->time);
    return ERROR;
}

EXPORT fmi2Component fmi2Instantiate(const char *name, int type, const char *guid, const char *resources, const fmi2CallbackFunctions *functions,
                                     fmi2Boolean visible, fmi2Boolean logging) {
    (void) type; (void) visible; (void) logging;
    if (strcmp(guid, "{" TOKEN "}") != 0 || strncmp(resources, "file:///", 8) != 0) {
        functions->logger(functions->componentEnvironment, name, ERROR, "logStatusError", "wrong GUID or resources");
        return NULL;
    }
    void *memory = functions->allocateMemory(1, 8);
    if (!memory) return NULL;
    functions->freeMemory(memory);
    Unit *unit = unit_new();
    unit->environment = functions->componentEnvironment;
    unit->log = (void (*)(void)) functions->logger;
    unit->name = "unit";
    return unit;
}

EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const char *const categories[]) {
    (void) c; (void) on;
    return n == 0 || strcmp(categories[0], "logStatusError") == 0 ? OK : ERROR;
}

EXPORT fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean tolerant, double tolerance, double start, fmi2Boolean ends, double stop) {
    (void) tolerant; (void) tolerance; (void) ends; (void) stop;
    ((Unit *) c)->time = start;
    return OK;
}

EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
#if defined(NO_START)
    return say(c, "no consistent start values");
#else
    model_start(((Unit *) c)->x, ((Unit *) c)->p);
    return OK;
#endif
}

EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component c) { ((Unit *) c)->initialised = 1; return OK; }
EXPORT fmi2Status fmi2Terminate(fmi2Component c) { return ((Unit *) c)->initialised ? OK : ERROR; }
EXPORT void fmi2FreeInstance(fmi2Component c) { free(c); }
EXPORT fmi2Status fmi2GetReal(fmi2Component c, const unsigned int vr[], size_t n, double value[]) { return unit_get(c, vr, n, value); }
EXPORT fmi2Status fmi2SetReal(fmi2Component c, const unsigned int vr[], size_t n, const double value[]) { return unit_set(c, vr, n, value); }

EXPORT fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const unsigned int vr[], size_t n, const int order[], const double value[]) {
    for (size_t i = 0; i < n; i++) {
        if (vr[i] >= N_INPUTS || order[i] != 1) return ERROR;
        ((Unit *) c)->slope[vr[i]] = value[i];
    }
    return OK;
}

EXPORT fmi2Status fmi2DoStep(fmi2Component c, double time, double step, fmi2Boolean no_prior) {
    (void) no_prior;
    if (fabs(time - ((Unit *) c)->time) > 1e-9) return say(c, "step from a time that was not reached");
    return unit_step(c, step) ? OK : say(c, "the solver found no solution");
}

EXPORT fmi2Status fmi2EnterEventMode(fmi2Component c) { (void) c; return OK; }
EXPORT fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) { (void) c; return OK; }
EXPORT fmi2Status fmi2SetTime(fmi2Component c, double time) { ((Unit *) c)->time = time; return OK; }

EXPORT fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info) {
    Unit *unit = c;
    info->newDiscreteStatesNeeded = info->terminateSimulation = info->nominalsOfContinuousStatesChanged = 0;
    info->valuesOfContinuousStatesChanged = model_event(unit->time, unit->x, &unit->next);
    info->nextEventTimeDefined = isfinite(unit->next);
    info->nextEventTime = unit->next;
    return OK;
}

EXPORT fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean no_prior, fmi2Boolean *event, fmi2Boolean *terminate) {
    (void) c; (void) no_prior;
    *event = *terminate = 0;
    return OK;
}

EXPORT fmi2Status fmi2SetContinuousStates(fmi2Component c, const double x[], size_t n) {
    memcpy(((Unit *) c)->x, x, n * sizeof(double));
    return n == N_STATES ? OK : ERROR;
}

EXPORT fmi2Status fmi2GetContinuousStates(fmi2Component c, double x[], size_t n) {
    memcpy(x, ((Unit *) c)->x, n * sizeof(double));
    return n == N_STATES ? OK : ERROR;
}

EXPORT fmi2Status fmi2GetDerivatives(fmi2Component c, double dx[], size_t n) {
    Unit *unit = c;
    model_derivatives(unit->time, unit->x, unit->u, unit->p, dx);
    return n == N_STATES ? OK : ERROR;
}

EXPORT fmi2Status fmi2GetEventIndicators(fmi2Component c, double z[], size_t n) {
    Unit *unit = c;
    model_indicators(unit->time, unit->x, unit->u, unit->p, z);
    return n == N_INDICATORS ? OK : ERROR;
}

/* What a run does not need, and the standard asks to be there. */
#define REFUSED { (void) c; return ERROR; }
EXPORT const char *fmi2GetTypesPlatform(void) { return "default"; }
EXPORT const char *fmi2GetVersion(void) { return "2.0"; }
EXPORT fmi2Status fmi2Reset(fmi2Component c) { model_start(((Unit *) c)->x, ((Unit *) c)->p); return OK; }
EXPORT fmi2Status fmi2GetInteger(fmi2Component c, const unsigned int vr[], size_t n, int v[]) { (void) vr; (void) v; (void) c; return n ? ERROR : OK; }
EXPORT fmi2Status fmi2GetBoolean(fmi2Component c, const unsigned int vr[], size_t n, int v[]) { (void) vr; (void) v; (void) c; return n ? ERROR : OK; }
EXPORT fmi2Status fmi2GetString(fmi2Component c, const unsigned int vr[], size_t n, const char *v[]) { (void) vr; (void) v; (void) c; return n ? ERROR : OK; }
EXPORT fmi2Status fmi2SetInteger(fmi2Component c, const unsigned int vr[], size_t n, const int v[]) { (void) vr; (void) v; (void) c; return n ? ERROR : OK; }
EXPORT fmi2Status fmi2SetBoolean(fmi2Component c, const unsigned int vr[], size_t n, const int v[]) { (void) vr; (void) v; (void) c; return n ? ERROR : OK; }
EXPORT fmi2Status fmi2SetString(fmi2Component c, const unsigned int vr[], size_t n, const char *const v[]) { (void) vr; (void) v; (void) c; return n ? ERROR : OK; }
EXPORT fmi2Status fmi2GetFMUstate(fmi2Component c, void **s) { (void) s; REFUSED }
EXPORT fmi2Status fmi2SetFMUstate(fmi2Component c, void *s) { (void) s; REFUSED }
EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component c, void **s) { (void) s; REFUSED }
EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, void *s, size_t *n) { (void) s; (void) n; REFUSED }
EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component c, void *s, char b[], size_t n) { (void) s; (void) b; (void) n; REFUSED }
EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const char b[], size_t n, void **s) { (void) s; (void) b; (void) n; REFUSED }
EXPORT fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const unsigned int u[], size_t nu, const unsigned int k[], size_t nk, const double dk[], double du[]) {
    (void) u; (void) nu; (void) k; (void) nk; (void) dk; (void) du; REFUSED
}
EXPORT fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, double x[], size_t n) {
    (void) c;
    for (size_t i = 0; i < n; i++) x[i] = 1;
    return OK;
}
EXPORT fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const unsigned int vr[], size_t n, const int order[], double v[]) {
    (void) vr; (void) n; (void) order; (void) v; REFUSED
}
EXPORT fmi2Status fmi2CancelStep(fmi2Component c) REFUSED
EXPORT fmi2Status fmi2GetStatus(fmi2Component c, int kind, fmi2Status *v) { (void) kind; (void) v; REFUSED }
EXPORT fmi2Status fmi2GetRealStatus(fmi2Component c, int kind, double *v) { (void) kind; (void) v; REFUSED }
EXPORT fmi2Status fmi2GetIntegerStatus(fmi2Component c, int kind, int *v) { (void) kind; (void) v; REFUSED }
EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component c, int kind, int *v) { (void) kind; (void) v; REFUSED }
EXPORT fmi2Status fmi2GetStringStatus(fmi2Component c, int kind, const char **v) { (void) kind; (void) v; REFUSED }
