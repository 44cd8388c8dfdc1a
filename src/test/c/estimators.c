/*
 * The arithmetic of wbv.filter's estimators of one degree of freedom as plain C loops, to say what the Java costs.
 *
 *   cc -O2 -o estimators estimators.c -lm
 *   ./estimators ekf FILE ROUNDS | ukf FILE ROUNDS | particle FILE ROUNDS PARTICLES
 *
 * FILE holds pairs of doubles, input and output, of this machine's byte order. Prints nanoseconds per sample, then frequency [Hz]
 * and damping ratio after the last sample. `ekf` is Method.EKF operation by operation, with the same result; `ukf` and `particle`
 * are the filters alone, without what adapts their noise, `particle` with random numbers of its own.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { POINTS = 8, LATENCY = 3, N = 5, STATES = 2, PARAMETERS = 2, OFFSET = 4, HALF_SECOND = 30 };

static const double RATE = 60, START_FREQUENCY = 5, START_DAMPING = 0.4, DRIFT = 0.003;
static double noise, reference, decay;

/* ---- input between samples: polynomials of 2 to 8 samples, least wrong over frequencies up to a quarter of the rate ---- */

static double between[LATENCY + 1][POINTS][POINTS];

static double mean_product(double apart) {
    double x = 2 * M_PI * 0.25 * apart;
    return x == 0 ? 1 : sin(x) / x;
}

/* a x = b for columns of b, n by n and n by columns, in place: Gauss with pivots */
static void solve(int n, int columns, double a[POINTS + 1][POINTS + 1], double b[POINTS + 1][POINTS + 1]) {
    for (int k = 0; k < n; k++) {
        int pivot = k;
        for (int i = k + 1; i < n; i++) if (fabs(a[i][k]) > fabs(a[pivot][k])) pivot = i;
        for (int j = 0; j < n; j++) { double t = a[k][j]; a[k][j] = a[pivot][j]; a[pivot][j] = t; }
        for (int j = 0; j < columns; j++) { double t = b[k][j]; b[k][j] = b[pivot][j]; b[pivot][j] = t; }
        for (int i = k + 1; i < n; i++) {
            double f = a[i][k] / a[k][k];
            for (int j = k; j < n; j++) a[i][j] -= f * a[k][j];
            for (int j = 0; j < columns; j++) b[i][j] -= f * b[k][j];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = 0; j < columns; j++) {
            for (int i = k + 1; i < n; i++) b[k][j] -= a[k][i] * b[i][j];
            b[k][j] /= a[k][k];
        }
    }
}

static void make_between(void) {
    for (int m = 1; m <= LATENCY + 1; m++) {
        int points = 2 * m;
        double mean[POINTS + 1][POINTS + 1] = {{0}}, there[POINTS + 1][POINTS + 1], powers[POINTS + 1][POINTS + 1];
        double weights[POINTS + 1][POINTS + 1];
        for (int i = 0; i < points; i++) {
            for (int k = 0; k < points; k++) mean[i][k] = mean_product(i - k);
            mean[i][points] = mean[points][i] = 1;
        }
        for (int k = 0; k < points; k++) {
            double s = 0.5 - 0.5 * cos(M_PI * (k + 0.5) / points);
            for (int i = 0; i < points; i++) there[i][k] = mean_product(s - (i - m + 1));
            there[points][k] = 1;
            for (int j = 0; j < points; j++) powers[k][j] = pow(s, j);
        }
        solve(points + 1, points, mean, there);
        for (int k = 0; k < points; k++) {
            for (int i = 0; i < points; i++) weights[k][i] = there[i][k];
        }
        solve(points, points, powers, weights);
        for (int j = 0; j < points; j++) {
            for (int i = 0; i < points; i++) between[m - 1][j][i] = weights[j][i];
        }
    }
}

static void coefficients(int look_ahead, const double *samples, double *c) {
    int points = 2 * (look_ahead + 1);
    for (int j = 0; j < POINTS; j++) {
        double sum = 0;
        if (j < points) {
            for (int i = 0; i < points; i++) sum += between[look_ahead][j][i] * samples[i];
        }
        c[j] = sum;
    }
}

/* ---- one exact step of x' = A x + B u, with derivatives to ln omega and ln zeta ---- */

typedef struct {
    double damper, spring;
    double phi[3][4], gain[3][POINTS][2];
} body;

static double factorials[POINTS + 2];

static void multiply(double left[3][4], double right[3][4], int i, double factor, double *out) {
    for (int r = 0; r < 2; r++) {
        for (int c = 0; c < 2; c++) {
            double sum = 0;
            for (int k = 0; k < 2; k++) {
                sum += left[0][2 * r + k] * right[i][2 * k + c];
                if (i > 0) sum += left[i][2 * r + k] * right[0][2 * k + c];
            }
            out[2 * r + c] = factor * sum;
        }
    }
}

static void set_output(body *b, double log_omega, double log_damping) {
    double omega = exp(log_omega);
    b->damper = 2 * exp(log_damping) * omega;
    b->spring = omega * omega / reference;
}

/* slopes: 2 with derivatives, 0 without */
static void set_body(body *b, double log_omega, double log_damping, int slopes) {
    double m[3][4], term[3][4], work[3][4], half[POINTS][2];
    set_output(b, log_omega, log_damping);
    double a[3][4] = {{-b->damper, -b->spring, reference, 0}, {-b->damper, -2 * b->spring, 0, 0}, {-b->damper, 0, 0, 0}};
    double row = fabs(a[0][0]) + fabs(a[0][1]), time = 1 / RATE;
    double size = (row > reference ? row : reference) * time;
    int halvings = ilogb(size) > 0 ? ilogb(size) : 0;
    double h = scalbn(time, -halvings);
    for (int i = 0; i <= slopes; i++) {
        for (int e = 0; e < 4; e++) {
            m[i][e] = h * a[i][e];
            b->phi[i][e] = 0;
            term[i][e] = 0;
        }
    }
    term[0][0] = term[0][3] = 1 / factorials[POINTS];
    double negligible = 1e-17 / factorials[POINTS];
    for (int k = 1; k <= 40; k++) {
        double largest = 0;
        for (int i = 0; i <= slopes; i++) {
            for (int e = 0; e < 4; e++) {
                b->phi[i][e] += term[i][e];
                if (fabs(term[i][e]) > largest) largest = fabs(term[i][e]);
            }
        }
        if (largest < negligible) break;
        for (int i = 0; i <= slopes; i++) multiply(term, m, i, 1.0 / (k + POINTS), work[i]);
        memcpy(term, work, sizeof term);
    }
    for (int order = POINTS; order >= 1; order--) {
        double factor = h * factorials[order - 1];
        for (int i = 0; i <= slopes; i++) {
            b->gain[i][order - 1][0] = factor * b->phi[i][0];
            b->gain[i][order - 1][1] = factor * b->phi[i][2];
        }
        for (int i = 0; i <= slopes; i++) multiply(m, b->phi, i, 1, work[i]);
        work[0][0] += 1 / factorials[order - 1];
        work[0][3] += 1 / factorials[order - 1];
        memcpy(b->phi, work, sizeof work);
    }
    for (int d = 0; d < halvings; d++) {
        for (int i = slopes; i >= 0; i--) {
            for (int j = 0; j < POINTS; j++) {
                for (int r = 0; r < 2; r++) {
                    double sum = 0, choose = 1;
                    for (int c = 0; c < 2; c++) {
                        sum += b->phi[0][2 * r + c] * b->gain[i][j][c];
                        if (i > 0) sum += b->phi[i][2 * r + c] * b->gain[0][j][c];
                    }
                    for (int k = 0; k <= j; k++) {
                        sum += choose * b->gain[i][k][r];
                        choose = choose * (j - k) / (k + 1);
                    }
                    half[j][r] = scalbn(sum, -j);
                }
            }
            memcpy(b->gain[i], half, sizeof half);
        }
        for (int i = 0; i <= slopes; i++) multiply(b->phi, b->phi, i, 1, work[i]);
        memcpy(b->phi, work, sizeof work);
    }
}

static void move(const body *b, const double *c, double *x) {
    double v = b->phi[0][0] * x[0] + b->phi[0][1] * x[1];
    double w = b->phi[0][2] * x[0] + b->phi[0][3] * x[1];
    for (int j = 0; j < POINTS; j++) {
        v += b->gain[0][j][0] * c[j];
        w += b->gain[0][j][1] * c[j];
    }
    x[0] = v;
    x[1] = w;
}

static double output(const body *b, const double *x) {
    return b->damper * x[0] + b->spring * x[1];
}

/* derivative of a state after the step to a parameter, the state before held */
static double forced(const body *b, int state, int parameter, const double *c, const double *x) {
    const double *de = b->phi[1 + parameter];
    double sum = de[2 * state] * x[0] + de[2 * state + 1] * x[1];
    for (int j = 0; j < POINTS; j++) sum += b->gain[1 + parameter][j][state] * c[j];
    return sum;
}

/* ---- what all filters share: high-pass, window of the input, outputs that wait, sensitivity ---- */

typedef struct {
    int started;
    double input_mean, output_mean, window[POINTS], delayed[LATENCY + 1];
    double sv[2], sw[2], power[2], squares[HALF_SECOND], square_sum;
    int next;
} front;

static double predict(const front *f, const body *b, const double *xi, double u) {
    double x[N], ahead[POINTS], c[POINTS];
    if (!f->started) return u;
    memcpy(x, xi, sizeof x);
    memcpy(ahead, f->window + 1, (POINTS - 1) * sizeof(double));
    ahead[POINTS - 1] = decay * (u - f->input_mean);
    for (int look_ahead = LATENCY; look_ahead >= 0; look_ahead--) {
        coefficients(look_ahead, ahead + 2 * (LATENCY - look_ahead), c);
        move(b, c, x);
        x[OFFSET] *= decay;
    }
    return f->output_mean + (output(b, x) + x[OFFSET]) / decay;
}

static void push(front *f, double u, double y) {
    if (!f->started) {
        f->started = 1;
        f->input_mean = u;
        f->output_mean = y;
    }
    memmove(f->window, f->window + 1, (POINTS - 1) * sizeof(double));
    f->window[POINTS - 1] = decay * (u - f->input_mean);
    memmove(f->delayed, f->delayed + 1, LATENCY * sizeof(double));
    f->delayed[LATENCY] = decay * (y - f->output_mean);
    f->input_mean += (1 - decay) * (u - f->input_mean);
    f->output_mean += (1 - decay) * (y - f->output_mean);
}

static void feel(front *f, const body *b, const double *c, const double *x) {
    f->square_sum += c[0] * c[0] - f->squares[f->next];
    f->squares[f->next] = c[0] * c[0];
    if (++f->next == HALF_SECOND) f->next = 0;
    for (int i = 0; i < 2; i++) {
        double v = b->phi[0][0] * f->sv[i] + b->phi[0][1] * f->sw[i] + forced(b, 0, i, c, x);
        f->sw[i] = b->phi[0][2] * f->sv[i] + b->phi[0][3] * f->sw[i] + forced(b, 1, i, c, x);
        f->sv[i] = v;
    }
}

static double slope(const body *b, int parameter, const double *x) {
    return b->damper * x[0] + (parameter == 0 ? 2 * b->spring * x[1] : 0);
}

static void hear(front *f, const body *b, const double *x) {
    for (int i = 0; i < 2; i++) {
        double s = b->damper * f->sv[i] + b->spring * f->sw[i] + slope(b, i, x);
        f->power[i] += (s * s - f->power[i]) / RATE;
    }
}

/* ---- a Kalman filter, extended or unscented ---- */

typedef struct {
    front f;
    body b;
    double x[N], p[N][N];
} kalman;

static void start_kalman(kalman *k) {
    memset(k, 0, sizeof *k);
    for (int i = 0; i <= LATENCY; i++) k->f.delayed[i] = NAN;
    k->x[2] = log(2 * M_PI * START_FREQUENCY);
    k->x[3] = log(START_DAMPING);
    k->p[0][0] = k->p[1][1] = 1 / (reference * reference);
    k->p[2][2] = k->p[3][3] = 0.25;
    k->p[4][4] = 1;
    set_body(&k->b, k->x[2], k->x[3], 2);
}

static void symmetrise(kalman *k) {
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < i; j++) k->p[i][j] = k->p[j][i] = (k->p[i][j] + k->p[j][i]) / 2;
    }
}

static void sandwich(double f[N][N], double p[N][N]) {
    double work[N][N];
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            double sum = 0;
            for (int l = 0; l < N; l++) sum += f[i][l] * p[l][j];
            work[i][j] = sum;
        }
    }
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            double sum = 0;
            for (int l = 0; l < N; l++) sum += work[i][l] * f[j][l];
            p[i][j] = sum;
        }
    }
}

static void add_process_noise(kalman *k) {
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) k->p[i][j] += k->b.gain[0][0][i] * k->b.gain[0][0][j] * noise * noise;
    }
    k->p[2][2] += DRIFT * DRIFT / RATE;
    k->p[3][3] += DRIFT * DRIFT / RATE;
}

static void advance_extended(kalman *k, const double *c) {
    double f[N][N] = {{0}};
    for (int r = 0; r < 2; r++) {
        for (int i = 0; i < 2; i++) {
            f[r][i] = k->b.phi[0][2 * r + i];
            f[r][2 + i] = forced(&k->b, r, i, c, k->x);
        }
    }
    f[2][2] = f[3][3] = 1;
    f[4][4] = decay;
    move(&k->b, c, k->x);
    k->x[OFFSET] *= decay;
    sandwich(f, k->p);
}

static void correct_extended(kalman *k, double y) {
    double h[N] = {k->b.damper, k->b.spring, slope(&k->b, 0, k->x), slope(&k->b, 1, k->x), 1};
    double gain[N], variance = 0, r = noise * noise, keep[N][N];
    for (int i = 0; i < N; i++) {
        gain[i] = 0;
        for (int j = 0; j < N; j++) gain[i] += k->p[i][j] * h[j];
        variance += h[i] * gain[i];
    }
    double innovation = y - (output(&k->b, k->x) + k->x[OFFSET]);
    for (int i = 0; i < N; i++) {
        gain[i] /= variance + r;
        k->x[i] += gain[i] * innovation;
    }
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) keep[i][j] = (i == j) - gain[i] * h[j];
    }
    sandwich(keep, k->p);
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) k->p[i][j] += r * gain[i] * gain[j];
    }
}

static const int order[N] = {2, 3, 0, 1, 4};

static void spread(const kalman *k, double points[2 * N][N]) {
    double root[N][N] = {{0}};
    for (int i = 0; i < N; i++) {
        for (int j = 0; j <= i; j++) {
            double sum = k->p[order[i]][order[j]];
            for (int l = 0; l < j; l++) sum -= root[i][l] * root[j][l];
            if (i == j) {
                double least = 1e-9 * k->p[order[i]][order[i]];
                root[i][i] = sqrt(sum > least ? sum : least);
            } else {
                root[i][j] = root[j][j] > 0 ? sum / root[j][j] : 0;
            }
        }
    }
    for (int i = 0; i < N; i++) {
        for (int l = 0; l < N; l++) {
            double step = sqrt(N) * root[l][i];
            points[2 * i][order[l]] = k->x[order[l]] + step;
            points[2 * i + 1][order[l]] = k->x[order[l]] - step;
        }
    }
}

static void advance_unscented(kalman *k, const double *c) {
    double points[2 * N][N], mean[N] = {0};
    body own;
    spread(k, points);
    set_body(&own, k->x[2], k->x[3], 0);
    for (int i = 2 * PARAMETERS; i < 2 * N; i++) {
        move(&own, c, points[i]);
        points[i][OFFSET] *= decay;
    }
    for (int i = 0; i < 2 * PARAMETERS; i++) {
        set_body(&own, points[i][2], points[i][3], 0);
        move(&own, c, points[i]);
        points[i][OFFSET] *= decay;
    }
    for (int i = 0; i < 2 * N; i++) {
        for (int l = 0; l < N; l++) mean[l] += points[i][l] / (2 * N);
    }
    for (int r = 0; r < N; r++) {
        for (int l = 0; l <= r; l++) {
            double sum = 0;
            for (int i = 0; i < 2 * N; i++) sum += (points[i][r] - mean[r]) * (points[i][l] - mean[l]);
            k->p[r][l] = k->p[l][r] = sum / (2 * N);
        }
    }
    k->x[0] = mean[0];
    k->x[1] = mean[1];
    k->x[OFFSET] = mean[OFFSET];
}

static void correct_unscented(kalman *k, double y) {
    double points[2 * N][N], outputs[2 * N], foreseen = 0, variance = 0, cross[N] = {0};
    body own;
    spread(k, points);
    for (int i = 0; i < 2 * N; i++) {
        set_output(&own, points[i][2], points[i][3]);
        outputs[i] = output(&own, points[i]) + points[i][OFFSET];
        foreseen += outputs[i] / (2 * N);
    }
    for (int i = 0; i < 2 * N; i++) {
        double e = outputs[i] - foreseen;
        variance += e * e / (2 * N);
        for (int l = 0; l < N; l++) cross[l] += e * (points[i][l] - k->x[l]) / (2 * N);
    }
    double r = noise * noise + variance;
    for (int i = 0; i < N; i++) {
        double gain = cross[i] / (variance + r);
        k->x[i] += gain * (y - foreseen);
        for (int j = 0; j < N; j++) k->p[i][j] -= gain * cross[j] + (cross[i] - gain * (variance + r)) * cross[j] / (variance + r);
    }
}

static double step_kalman(kalman *k, int unscented, double u, double y) {
    double c[POINTS];
    double said = predict(&k->f, &k->b, k->x, u);
    push(&k->f, u, y);
    coefficients(LATENCY, k->f.window, c);
    feel(&k->f, &k->b, c, k->x);
    if (unscented) {
        advance_unscented(k, c);
    } else {
        advance_extended(k, c);
    }
    hear(&k->f, &k->b, k->x);
    add_process_noise(k);
    symmetrise(k);
    if (!isnan(k->f.delayed[0])) {
        if (unscented) {
            correct_unscented(k, k->f.delayed[0]);
        } else {
            correct_extended(k, k->f.delayed[0]);
        }
        symmetrise(k);
        set_body(&k->b, k->x[2], k->x[3], 2);
    }
    return said;
}

/* ---- a bootstrap particle filter with the kernel of Liu and West ---- */

static uint64_t state = 1;

static double uniform(void) {
    uint64_t z = (state += 0x9E3779B97F4A7C15ULL);
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ z >> 27) * 0x94D049BB133111EBULL;
    return ((z ^ z >> 31) >> 11) * 0x1.0p-53;
}

static double gaussian(void) {
    static double kept;
    static int has;
    double a, b, s;
    if (has) {
        has = 0;
        return kept;
    }
    do {
        a = 2 * uniform() - 1;
        b = 2 * uniform() - 1;
        s = a * a + b * b;
    } while (s >= 1 || s == 0);
    s = sqrt(-2 * log(s) / s);
    kept = b * s;
    has = 1;
    return a * s;
}

typedef struct {
    double x[4], phi[4], gain[POINTS][2], row[2];
} particle;

typedef struct {
    front f;
    body b;
    int count;
    particle *all, *spare;
    double *logs, *weights, *outputs, mean[N], walk[2];
} cloud;

static void take_step(particle *p) {
    body b;
    set_body(&b, p->x[2], p->x[3], 0);
    memcpy(p->phi, b.phi[0], sizeof p->phi);
    memcpy(p->gain, b.gain[0], sizeof p->gain);
    p->row[0] = b.damper;
    p->row[1] = b.spring;
}

static void start_cloud(cloud *k, int count) {
    memset(k, 0, sizeof *k);
    for (int i = 0; i <= LATENCY; i++) k->f.delayed[i] = NAN;
    k->count = count;
    k->all = calloc(count, sizeof(particle));
    k->spare = calloc(count, sizeof(particle));
    k->logs = calloc(count, sizeof(double));
    k->weights = calloc(count, sizeof(double));
    k->outputs = calloc(count, sizeof(double));
    for (int i = 0; i < count; i++) {
        k->all[i].x[0] = gaussian() / reference;
        k->all[i].x[1] = gaussian() / reference;
        k->all[i].x[2] = log(2 * M_PI * START_FREQUENCY) + 0.5 * gaussian();
        k->all[i].x[3] = log(START_DAMPING) + 0.5 * gaussian();
        take_step(&k->all[i]);
        k->weights[i] = 1.0 / count;
        k->logs[i] = log(k->weights[i]);
    }
    k->mean[2] = log(2 * M_PI * START_FREQUENCY);
    k->mean[3] = log(START_DAMPING);
    set_body(&k->b, k->mean[2], k->mean[3], 2);
}

static void take_mean(cloud *k) {
    for (int i = 0; i < 4; i++) k->mean[i] = 0;
    for (int n = 0; n < k->count; n++) {
        for (int i = 0; i < 4; i++) k->mean[i] += k->weights[n] * k->all[n].x[i];
    }
}

static void resample(cloud *k) {
    double c[4][4] = {{0}}, root[4][4] = {{0}}, normal[4];
    const double shrink = (3 * 0.98 - 1) / (2 * 0.98), kernel = sqrt(1 - shrink * shrink);
    take_mean(k);
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j <= i; j++) {
            for (int n = 0; n < k->count; n++) {
                c[i][j] += k->weights[n] * (k->all[n].x[i] - k->mean[i]) * (k->all[n].x[j] - k->mean[j]);
            }
            double sum = c[i][j] + (i == j ? 1e-12 * (1 + k->mean[i] * k->mean[i]) : 0);
            for (int l = 0; l < j; l++) sum -= root[i][l] * root[j][l];
            root[i][j] = i == j ? sqrt(fmax(0, sum)) : root[j][j] > 0 ? sum / root[j][j] : 0;
        }
    }
    double at = uniform() / k->count, sum = k->weights[0];
    int parent = 0;
    for (int n = 0; n < k->count; n++, at += 1.0 / k->count) {
        while (at > sum && parent < k->count - 1) sum += k->weights[++parent];
        for (int i = 0; i < 4; i++) normal[i] = gaussian();
        for (int i = 0; i < 4; i++) {
            double moved = 0;
            for (int l = 0; l <= i; l++) moved += root[i][l] * normal[l];
            k->spare[n].x[i] = shrink * k->all[parent].x[i] + (1 - shrink) * k->mean[i] + kernel * moved;
            if (i >= 2) k->spare[n].x[i] += sqrt(k->walk[i - 2]) * gaussian();
        }
    }
    particle *moved = k->spare;
    k->spare = k->all;
    k->all = moved;
    k->walk[0] = k->walk[1] = 0;
    for (int n = 0; n < k->count; n++) {
        k->weights[n] = 1.0 / k->count;
        k->logs[n] = log(k->weights[n]);
        take_step(&k->all[n]);
    }
}

static void weigh(cloud *k, double y) {
    double foreseen = 0, variance = 0, largest = -INFINITY, sum = 0, squares = 0;
    for (int n = 0; n < k->count; n++) foreseen += k->weights[n] * k->outputs[n];
    for (int n = 0; n < k->count; n++) {
        variance += k->weights[n] * (k->outputs[n] - foreseen) * (k->outputs[n] - foreseen);
    }
    double r = noise * noise + variance;
    for (int n = 0; n < k->count; n++) {
        double e = y - k->outputs[n];
        k->logs[n] -= e * e / (2 * r);
        if (k->logs[n] > largest) largest = k->logs[n];
    }
    for (int n = 0; n < k->count; n++) sum += k->weights[n] = exp(k->logs[n] - largest);
    for (int n = 0; n < k->count; n++) {
        k->weights[n] /= sum;
        k->logs[n] -= largest + log(sum);
        squares += k->weights[n] * k->weights[n];
    }
    if (1 / squares < k->count / 2.0) resample(k);
}

static double step_cloud(cloud *k, double u, double y) {
    double c[POINTS], spread[4] = {0};
    double said = predict(&k->f, &k->b, k->mean, u);
    push(&k->f, u, y);
    coefficients(LATENCY, k->f.window, c);
    feel(&k->f, &k->b, c, k->mean);
    for (int n = 0; n < k->count; n++) {
        particle *p = &k->all[n];
        double shaken = noise * gaussian();
        double v = p->phi[0] * p->x[0] + p->phi[1] * p->x[1] + p->gain[0][0] * shaken;
        double w = p->phi[2] * p->x[0] + p->phi[3] * p->x[1] + p->gain[0][1] * shaken;
        for (int j = 0; j < POINTS; j++) {
            v += p->gain[j][0] * c[j];
            w += p->gain[j][1] * c[j];
        }
        p->x[0] = v;
        p->x[1] = w;
        k->outputs[n] = p->row[0] * v + p->row[1] * w;
    }
    take_mean(k);
    hear(&k->f, &k->b, k->mean);
    k->walk[0] += DRIFT * DRIFT / RATE;
    k->walk[1] += DRIFT * DRIFT / RATE;
    if (!isnan(k->f.delayed[0])) {
        weigh(k, k->f.delayed[0]);
        take_mean(k);
        for (int n = 0; n < k->count; n++) {
            for (int i = 0; i < 4; i++) spread[i] += k->weights[n] * (k->all[n].x[i] - k->mean[i]) * (k->all[n].x[i] - k->mean[i]);
        }
        set_body(&k->b, k->mean[2], k->mean[3], 2);
    }
    return said + 0 * spread[3];
}

int main(int count, char **words) {
    if (count < 4) {
        fprintf(stderr, "estimators ekf|ukf|particle FILE ROUNDS [PARTICLES]\n");
        return 2;
    }
    FILE *file = fopen(words[2], "rb");
    if (!file) {
        fprintf(stderr, "%s: no such file\n", words[2]);
        return 1;
    }
    fseek(file, 0, SEEK_END);
    long samples = ftell(file) / (2 * (long) sizeof(double));
    rewind(file);
    double *data = malloc(2 * samples * sizeof(double));
    if (fread(data, 2 * sizeof(double), samples, file) != (size_t) samples) return 1;
    fclose(file);

    noise = 200e-6 * 9.80665 * sqrt(RATE / 2);
    reference = 2 * M_PI * START_FREQUENCY;
    decay = exp(-2 * M_PI * 0.1 / RATE);
    factorials[0] = 1;
    for (int i = 1; i < POINTS + 2; i++) factorials[i] = i * factorials[i - 1];
    make_between();

    int rounds = atoi(words[3]), particles = count > 4 ? atoi(words[4]) : 1000;
    kalman filter;
    cloud many;
    double sum = 0, *estimate = words[1][0] == 'p' ? many.mean : filter.x;
    struct timespec from, to;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &from);
    for (int round = 0; round < rounds; round++) {
        if (words[1][0] == 'p') {
            start_cloud(&many, particles);
            for (long i = 0; i < samples; i++) sum += step_cloud(&many, data[2 * i], data[2 * i + 1]);
            free(many.all), free(many.spare), free(many.logs), free(many.weights), free(many.outputs);
        } else {
            start_kalman(&filter);
            for (long i = 0; i < samples; i++) sum += step_kalman(&filter, words[1][0] == 'u', data[2 * i], data[2 * i + 1]);
        }
    }
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &to);
    double nanoseconds = (to.tv_sec - from.tv_sec) * 1e9 + (to.tv_nsec - from.tv_nsec);
    printf("%.1f %.15g %.15g %.6g\n", nanoseconds / rounds / samples, exp(estimate[2]) / (2 * M_PI), exp(estimate[3]), sum);
    return 0;
}
