/*
 * A person in the plane of x and z, for the tests: trunk on cushion and backrest, head on the neck, both with pitch. x and z are relative to the
 * plate, pitch is absolute; the plate's pitch is the integral of its rate. Small angles. BUMP_STOP puts a stop of rubber under the cushion.
 */
#include <math.h>

enum { N_INPUTS = 3, N_OUTPUTS = 6, N_PARAMETERS = 6, N_STATES = 13, N_INDICATORS = 0 };

static const double START_PARAMETERS[N_PARAMETERS] = { 60000, 900, 15000, 400, 90, 3.5 };

#define TRUNK_MASS 45.0
#define TRUNK_INERTIA 3.2
#define HEAD_MASS 5.2
#define HEAD_INERTIA 0.035
#define SEAT_SHEAR 20000.0
#define SEAT_SHEAR_DAMPING 500.0
#define SEAT_ROCKING 450.0
#define SEAT_ROCKING_DAMPING 22.0
#define NECK_STIFFNESS 60000.0
#define NECK_DAMPING 260.0
#define STOP_GAP 0.0006
#define STOP_STIFFNESS 2.5e5

static void model_start(double *x, const double *p) {
    (void) p;
    for (int i = 0; i < N_STATES; i++) x[i] = 0;
}

/* The force of a bushing between points of two bodies, upon the first: positions q = x, z, pitch, arms r = x, z. Pitch turns z towards x. */
static void bushing(const double *qa, const double *va, double rxa, double rza, const double *qb, const double *vb, double rxb, double rzb,
                    double kx, double cx, double kz, double cz, double *fx, double *fz) {
    double dx = qb[0] + rzb * qb[2] - qa[0] - rza * qa[2];
    double dz = qb[1] - rxb * qb[2] - qa[1] + rxa * qa[2];
    double ex = vb[0] + rzb * vb[2] - va[0] - rza * va[2];
    double ez = vb[1] - rxb * vb[2] - va[1] + rxa * va[2];
    *fx = kx * dx + cx * ex;
    *fz = kz * dz + cz * ez;
#if defined(BUMP_STOP)
    /* Of the cushion alone, which is the one with a vertical parameter. */
    if (rza == -0.25 && dz > STOP_GAP) *fz += STOP_STIFFNESS * (dz - STOP_GAP);
#endif
}

static void accelerations(const double *x, const double *u, const double *p, double *a) {
    const double *trunk = x, *head = x + 3, *trunk_v = x + 6, *head_v = x + 9;
    double plate[3] = { 0, 0, x[12] }, plate_v[3] = { 0, 0, u[2] };
    double fx, fz, t[3] = { 0, 0, 0 }, h[3] = { 0, 0, 0 };
    bushing(trunk, trunk_v, 0, -0.25, plate, plate_v, 0, 0.1, SEAT_SHEAR, SEAT_SHEAR_DAMPING, p[0], p[1], &fx, &fz);
    t[0] += fx; t[1] += fz; t[2] += -0.25 * fx;
    bushing(trunk, trunk_v, -0.12, 0.15, plate, plate_v, -0.12, 0.5, p[2], p[3], 0, 0, &fx, &fz);
    t[0] += fx; t[1] += fz; t[2] += 0.15 * fx + 0.12 * fz;
    t[2] += SEAT_ROCKING * (plate[2] - trunk[2]) + SEAT_ROCKING_DAMPING * (plate_v[2] - trunk_v[2]);
    bushing(trunk, trunk_v, 0.02, 0.33, head, head_v, -0.02, -0.09, NECK_STIFFNESS, NECK_DAMPING, NECK_STIFFNESS, NECK_DAMPING, &fx, &fz);
    t[0] += fx; t[1] += fz; t[2] += 0.33 * fx - 0.02 * fz;
    h[0] -= fx; h[1] -= fz; h[2] -= -0.09 * fx + 0.02 * fz;
    double neck = p[4] * (head[2] - trunk[2]) + p[5] * (head_v[2] - trunk_v[2]);
    t[2] += neck; h[2] -= neck;
    a[0] = t[0] / TRUNK_MASS; a[1] = t[1] / TRUNK_MASS; a[2] = t[2] / TRUNK_INERTIA;
    a[3] = h[0] / HEAD_MASS; a[4] = h[1] / HEAD_MASS; a[5] = h[2] / HEAD_INERTIA;
}

static void model_outputs(double t, const double *x, const double *u, const double *p, double *y) {
    double a[6];
    (void) t;
    accelerations(x, u, p, a);
    y[0] = a[0]; y[1] = a[1]; y[2] = x[8];
    y[3] = a[3]; y[4] = a[4]; y[5] = x[11];
}

static void model_derivatives(double t, const double *x, const double *u, const double *p, double *dx) {
    double a[6];
    (void) t;
    accelerations(x, u, p, a);
    for (int i = 0; i < 6; i++) dx[i] = x[6 + i];
    dx[6] = a[0] - u[0]; dx[7] = a[1] - u[1]; dx[8] = a[2];
    dx[9] = a[3] - u[0]; dx[10] = a[4] - u[1]; dx[11] = a[5];
    dx[12] = u[2];
}

static void model_indicators(double t, const double *x, const double *u, const double *p, double *z) {
    (void) t; (void) x; (void) u; (void) p; (void) z;
}

static int model_event(double t, double *x, double *next) {
    (void) t; (void) x;
    *next = INFINITY;
    return 0;
}
