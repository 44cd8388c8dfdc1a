/*
 * A ball that falls from 1 m onto the plate and loses a part of its speed there; at KICK seconds it is thrown up. For the events of model exchange:
 * a change of sign that sets states, and a moment that is announced.
 */
#include <math.h>

enum { N_INPUTS = 1, N_OUTPUTS = 2, N_PARAMETERS = 2, N_STATES = 2, N_INDICATORS = 1 };

static const double START_PARAMETERS[N_PARAMETERS] = { 9.81, 0.8 };

#define KICK 1.25
#define THROWN 3.0

static void model_start(double *x, const double *p) {
    (void) p;
    x[0] = 1;
    x[1] = 0;
}

static void model_outputs(double t, const double *x, const double *u, const double *p, double *y) {
    (void) t; (void) u; (void) p;
    y[0] = x[0];
    y[1] = x[1];
}

static void model_derivatives(double t, const double *x, const double *u, const double *p, double *dx) {
    (void) t;
    dx[0] = x[1];
    dx[1] = -p[0] - u[0];
}

static void model_indicators(double t, const double *x, const double *u, const double *p, double *z) {
    (void) t; (void) u; (void) p;
    /* Behind the plate and on its way further: after the event its sign is the other again. */
    z[0] = x[0] <= 0 && x[1] < 0 ? -1 : 1;
}

static int model_event(double t, double *x, double *next) {
    int changed = 0;
    *next = t < KICK ? KICK : INFINITY;
    if (x[0] <= 0 && x[1] < 0) {
        x[0] = 0;
        x[1] = -0.8 * x[1];
        changed = 1;
    }
    if (t >= KICK && t < KICK + 1e-9) {
        x[1] = THROWN;
        changed = 1;
    }
    return changed;
}
