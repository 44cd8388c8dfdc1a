/*
 * A quarter car with a seat, for the tests: axle on its tyre, body on its suspension, a person on the seat; z relative to the road's plate, which is
 * shaken. Linear, but for what a build conceals: BUMP_STOP a stop of rubber in the suspension, FRICTION a dry friction in it.
 */
#include <math.h>

enum { N_INPUTS = 3, N_OUTPUTS = 3, N_PARAMETERS = 9, N_STATES = 6 };
#if defined(BUMP_STOP)
enum { N_INDICATORS = 1 };
#else
enum { N_INDICATORS = 0 };
#endif

#define STOP_GAP 0.004
#define STOP_STIFFNESS 2.0e5
#define FRICTION_FORCE 40.0
#define FRICTION_SPEED 0.002

static const double START_PARAMETERS[N_PARAMETERS] = { 40, 160000, 300, 250, 22000, 1500, 60, 15000, 700 };

static void model_start(double *x, const double *p) {
    (void) p;
    for (int i = 0; i < N_STATES; i++) x[i] = 0;
}

/* Forces in the links, which pull their ends together. */
static void links(const double *x, const double *u, const double *p, double f[3]) {
    double stretch[3] = { x[0], x[1] - x[0], x[2] - x[1] };
    double speed[3] = { x[3], x[4] - x[3], x[5] - x[4] };
    for (int l = 0; l < 3; l++) f[l] = p[3 * l + 1] * stretch[l] + p[3 * l + 2] * speed[l];
    f[1] += u[1];
    f[2] += u[2];
#if defined(BUMP_STOP)
    if (stretch[1] < -STOP_GAP) f[1] += STOP_STIFFNESS * (stretch[1] + STOP_GAP);
#endif
#if defined(FRICTION)
    f[1] += FRICTION_FORCE * tanh(speed[1] / FRICTION_SPEED);
#endif
}

static void model_outputs(double t, const double *x, const double *u, const double *p, double *y) {
    double f[3];
    (void) t;
    links(x, u, p, f);
    y[0] = (f[1] - f[0]) / p[0];
    y[1] = (f[2] - f[1]) / p[3];
    y[2] = -f[2] / p[6];
}

static void model_derivatives(double t, const double *x, const double *u, const double *p, double *dx) {
    double y[3];
    model_outputs(t, x, u, p, y);
    for (int b = 0; b < 3; b++) {
        dx[b] = x[3 + b];
        dx[3 + b] = y[b] - u[0];
    }
}

static void model_indicators(double t, const double *x, const double *u, const double *p, double *z) {
    (void) t; (void) u; (void) p;
#if defined(BUMP_STOP)
    z[0] = x[1] - x[0] + STOP_GAP;
#else
    (void) x; (void) z;
#endif
}

/* What an event changes, and when the next is. Returns whether states changed. */
static int model_event(double t, double *x, double *next) {
    (void) t; (void) x;
    *next = INFINITY;
    return 0;
}
