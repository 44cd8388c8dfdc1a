/*
 * What both versions of the standard share: a unit that holds a model. Variables are numbered by kind. Built with MODEL, the file of the model, and
 * at will BROKEN_AT (the step fails from that time on), NO_START (it cannot be initialised), SUBSTEP (its own step).
 */
#include <stdlib.h>
#include <string.h>
#include MODEL

enum { INPUT = 0, OUTPUT = 100, PARAMETER = 200, STATE = 300, DERIVATIVE = 400 };

#ifndef SUBSTEP
#define SUBSTEP 0.0005
#endif

typedef struct {
    double time;
    double x[N_STATES], u[N_INPUTS], slope[N_INPUTS], p[N_PARAMETERS], next;
    void *environment;
    void (*log)(void);
    const char *name;
    int initialised;
} Unit;

static Unit *unit_new(void) {
    Unit *unit = calloc(1, sizeof(Unit));
    memcpy(unit->p, START_PARAMETERS, sizeof unit->p);
    unit->next = INFINITY;
    model_start(unit->x, unit->p);
    return unit;
}

static int unit_get(Unit *unit, const unsigned int vr[], size_t n, double value[]) {
    double y[N_OUTPUTS], dx[N_STATES];
    model_outputs(unit->time, unit->x, unit->u, unit->p, y);
    model_derivatives(unit->time, unit->x, unit->u, unit->p, dx);
    for (size_t i = 0; i < n; i++) {
        unsigned int kind = vr[i] / 100 * 100, at = vr[i] % 100;
        if (kind == OUTPUT && at < N_OUTPUTS) value[i] = y[at];
        else if (kind == INPUT && at < N_INPUTS) value[i] = unit->u[at];
        else if (kind == PARAMETER && at < N_PARAMETERS) value[i] = unit->p[at];
        else if (kind == STATE && at < N_STATES) value[i] = unit->x[at];
        else if (kind == DERIVATIVE && at < N_STATES) value[i] = dx[at];
        else return 3;
    }
    return 0;
}

static int unit_set(Unit *unit, const unsigned int vr[], size_t n, const double value[]) {
    for (size_t i = 0; i < n; i++) {
        unsigned int kind = vr[i] / 100 * 100, at = vr[i] % 100;
        if (kind == INPUT && at < N_INPUTS) { unit->u[at] = value[i]; unit->slope[at] = 0; }
        else if (kind == PARAMETER && at < N_PARAMETERS) unit->p[at] = value[i];
        else if (kind == STATE && at < N_STATES) unit->x[at] = value[i];
        else return 3;
    }
    return 0;
}

/* Runge and Kutta's classical step, with inputs that are constant or straight lines over it. Returns whether it goes. */
static int unit_step(Unit *unit, double h) {
    int parts = (int) ceil(h / SUBSTEP - 1e-9);
    double step = h / parts;
    double end = unit->time + h;
#if defined(BROKEN_AT)
    if (end > BROKEN_AT) return 0;
#endif
    for (int s = 0; s < parts; s++) {
        double k[4][N_STATES], x[N_STATES], u[N_INPUTS];
        for (int stage = 0; stage < 4; stage++) {
            double along = stage == 0 ? 0 : stage == 3 ? step : step / 2;
            for (int i = 0; i < N_STATES; i++) x[i] = unit->x[i] + (stage == 0 ? 0 : along * k[stage - 1][i]);
            for (int i = 0; i < N_INPUTS; i++) u[i] = unit->u[i] + unit->slope[i] * (s * step + along);
            model_derivatives(unit->time + along, x, u, unit->p, k[stage]);
        }
        for (int i = 0; i < N_STATES; i++) unit->x[i] += step / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
        unit->time += step;
    }
    unit->time = end;
    return 1;
}

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif
