/* How the model above is stepped: the linear part exactly, with inputs that run straight from one point to the next; each law is solved at the
   end of its step, so that stiff stops and almost rigid friction stay stable. An input set before a step is that at the step's end. */

#define STATES (2 * BODIES)
#define COLUMNS (1 + LINKS + BODIES)
#define AT_LEAST_1(n) ((n) > 0 ? (n) : 1)

typedef struct {
    double *values;
    int count, room;
} Series;

typedef struct {
    double state[2], last, transition[4], before[2], after[2];
} Mount;

typedef struct {
    double state, last;
} Coupling;

struct Model {
    double p[AT_LEAST_1(PARAMETERS)], u[AT_LEAST_1(INPUTS)], last[AT_LEAST_1(INPUTS)], y[OUTPUTS];
    double start, time, h;
    int steps;
    double w, transition[STATES * STATES], before[STATES * COLUMNS], after[STATES * COLUMNS];
    double x[STATES], base_v, base_x;
    double force[AT_LEAST_1(LAWS)], previous[AT_LEAST_1(LAWS)], memory[AT_LEAST_1(LAWS)], square[AT_LEAST_1(LAWS)];
    double give[AT_LEAST_1(LAWS * LAWS)], give_v[AT_LEAST_1(LAWS * LAWS)];
    double link_r[LINKS], link_v[LINKS], load[LINKS], link_drive[LINKS], body_drive[BODIES];
    double lift[LINKS], rise[LINKS], lift_at_start[LINKS];
    double before_base, before_link[LINKS], before_body[BODIES];
    Series r[AT_LEAST_1(LAWS)], v[AT_LEAST_1(LAWS)], late[AT_LEAST_1(DELAYS)];
    Mount mounts[AT_LEAST_1(MOUNTS)];
    Coupling couplings[AT_LEAST_1(COUPLINGS)];
};

static void append(Series *s, double value) {
    if (s->count == s->room) {
        s->room = s->room ? 2 * s->room : 1024;
        s->values = (double *) realloc(s->values, s->room * sizeof(double));
    }
    s->values[s->count++] = value;
}

/* x(h) = E x(0) + B0 u(0) + B1 u(h) for x' = A x + B u with u straight within the step (Higham 2008, ch. 10). */
#define LARGEST (STATES > 2 ? STATES : 2)
static void multiply(int n, int m, double factor, const double *a, const double *b, double *out) {
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < m; j++) {
            double sum = 0;
            for (int k = 0; k < n; k++) {
                sum += a[i * n + k] * b[k * m + j];
            }
            out[i * m + j] = factor * sum;
        }
    }
}

static void exact_hold(int n, int m, const double *a, const double *b, double h, double *transition, double *before, double *after) {
    double small[LARGEST * LARGEST], term[LARGEST * LARGEST], next[LARGEST * LARGEST], one[LARGEST * LARGEST], two[LARGEST * LARGEST];
    double norm = 1e-300;
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int j = 0; j < n; j++) {
            sum += fabs(a[i * n + j]);
        }
        norm = fmax(norm, sum);
    }
    int doublings = (int) fmax(0, ceil(log(norm * h / 0.5) / log(2.0)));
    for (int i = 0; i < n * n; i++) {
        small[i] = a[i] * h / pow(2, doublings);
        term[i] = i % (n + 1) == 0;
        transition[i] = one[i] = two[i] = 0;
    }
    for (int k = 0; k < 20; k++) {
        for (int i = 0; i < n * n; i++) {
            transition[i] += term[i];
            one[i] += term[i] / (k + 1);
            two[i] += term[i] / ((k + 1.0) * (k + 2.0));
        }
        multiply(n, n, 1.0 / (k + 1), term, small, next);
        memcpy(term, next, sizeof(double) * n * n);
    }
    for (int d = 0; d < doublings; d++) {
        multiply(n, n, 0.25, one, one, next);
        for (int i = 0; i < n * n; i++) {
            two[i] = 0.5 * two[i] + next[i];
        }
        multiply(n, n, 0.5, transition, one, next);
        for (int i = 0; i < n * n; i++) {
            one[i] = 0.5 * one[i] + next[i];
        }
        multiply(n, n, 1, transition, transition, next);
        memcpy(transition, next, sizeof(double) * n * n);
    }
    multiply(n, m, h, two, b, after);
    multiply(n, m, h, one, b, before);
    for (int i = 0; i < n * m; i++) {
        before[i] -= after[i];
    }
}

static double stretch(const Model *s, const double *x, int stride, int link) {
    return (x[UPPER[link] * stride] - (LOWER[link] < 0 ? 0 : x[LOWER[link] * stride])) / s->w;
}

static double speed(const double *x, int stride, int link) {
    return x[(BODIES + UPPER[link]) * stride] - (LOWER[link] < 0 ? 0 : x[(BODIES + LOWER[link]) * stride]);
}

/* Prepares for steps of h [s]. */
static void prepare(Model *s, double h) {
    const double *p = s->p;
    s->h = h;
    for (int i = 0; i < MOUNTS; i++) {
        double w = 2 * PI * p[MOUNT[i]], a[4] = {0, 1, -w * w, -2 * p[MOUNT[i] + 1] * w}, b[2] = {0, 1};
        exact_hold(2, 1, a, b, h, s->mounts[i].transition, s->mounts[i].before, s->mounts[i].after);
    }
    if (DRIVEN) {
        return;
    }
    double a[STATES * STATES] = {0}, b[STATES * COLUMNS] = {0};
    double largest = 1;
    for (int l = 0; l < LINKS; l++) {
        largest = fmax(largest, p[STIFFNESS + l] / p[MASS + UPPER[l]]);
    }
    s->w = sqrt(largest);
    for (int i = 0; i < BODIES; i++) {
        a[i * STATES + BODIES + i] = s->w;
        b[(BODIES + i) * COLUMNS] = -1;
        b[(BODIES + i) * COLUMNS + 1 + LINKS + i] = 1 / p[MASS + i];
    }
    for (int l = 0; l < LINKS; l++) {
        for (int i = 0; i < BODIES; i++) {
            int own = (UPPER[l] == i) - (LOWER[l] == i);
            b[(BODIES + i) * COLUMNS + 1 + l] = -own / p[MASS + i];
            for (int j = 0; j < BODIES; j++) {
                int other = (UPPER[l] == j) - (LOWER[l] == j);
                a[(BODIES + i) * STATES + j] -= own * other * p[STIFFNESS + l] / s->w / p[MASS + i];
                a[(BODIES + i) * STATES + BODIES + j] -= own * other * p[DAMPING + l] / p[MASS + i];
            }
        }
    }
    exact_hold(STATES, COLUMNS, a, b, h, s->transition, s->before, s->after);
    for (int i = 0; i < LAWS; i++) {
        for (int j = 0; j < LAWS; j++) {
            s->give[i * LAWS + j] = stretch(s, s->after + 1 + LAW_LINK[j], COLUMNS, LAW_LINK[i]);
            s->give_v[i * LAWS + j] = speed(s->after + 1 + LAW_LINK[j], COLUMNS, LAW_LINK[i]);
        }
    }
}

/* A series some time before the point that comes next, by a straight line between points; 0 before the start. */
static double earlier(const Series *s, double ago) {
    double at = s->count - fmax(1, ago);
    int floor_at = (int) floor(at);
    double share = at - floor_at;
    return floor_at < 0 ? 0 : s->values[floor_at] * (1 - share) + (floor_at + 1 < s->count ? s->values[floor_at + 1] * share : 0);
}

/* The last value of a series some points before, later and later by the drift; cubic between points. */
static double delayed(const Series *s, double ago, double drift) {
    double at = s->count - 1 - ago - drift * (s->count - 1);
    int i = (int) floor(at);
    double u = at - i;
    const double *x = s->values + i;
    if (i < 0) {
        return 0;
    }
    if (i < 1 || i + 2 >= s->count) {
        return i + 1 < s->count ? x[0] + u * (x[1] - x[0]) : x[0];
    }
    return x[0] + u * (0.5 * (x[1] - x[-1]) + u * (0.5 * (2 * x[-1] - 5 * x[0] + 4 * x[1] - x[2]) + u * 0.5 * (3 * (x[0] - x[1]) + x[2] - x[-1])));
}

/* A sensor that rides on its strap: frequency [Hz], damping ratio. */
static double mounted(Mount *m, double frequency, double ratio, double y, int first) {
    double w = 2 * PI * frequency, x[2];
    for (int i = 0; i < 2 && !first; i++) {
        x[i] = m->transition[2 * i] * m->state[0] + m->transition[2 * i + 1] * m->state[1] + m->before[i] * m->last + m->after[i] * y;
    }
    if (!first) {
        memcpy(m->state, x, sizeof x);
    }
    m->last = y;
    return w * w * m->state[0] + 2 * ratio * w * m->state[1];
}

/* A sensor that is AC coupled reads what is above its low-pass; exact over h [s] for a reading that runs straight. */
static double coupled(Coupling *c, double h, double corner, double y, int first) {
    double w = 2 * PI * corner;
    if (!first) {
        double share = -expm1(-w * h) / (w * h);
        c->state = exp(-w * h) * c->state + (share - exp(-w * h)) * c->last + (1 - share) * y;
    }
    c->last = y;
    return y - c->state;
}

static double bend(double y, double v, double push, double spring, double loss, double cubic) {
    return -push - loss * v - spring * y * (1 + cubic * y * y);
}

/* The same where the strap stiffens, by Runge and Kutta's fourth-order steps over h [s]. */
static double stiffened(Mount *m, double h, double frequency, double ratio, double cubic, double a, int first) {
    double w = 2 * PI * frequency, spring = w * w, loss = 2 * ratio * w, y = m->state[0], v = m->state[1];
    int parts = (int) fmax(1, ceil(w * h / 0.2));
    double s = h / parts, slope = (a - m->last) / parts;
    for (int part = 0; part < parts && !first; part++) {
        double push = m->last + part * slope;
        double b1 = bend(y, v, push, spring, loss, cubic);
        double v2 = v + s / 2 * b1, b2 = bend(y + s / 2 * v, v2, push + slope / 2, spring, loss, cubic);
        double v3 = v + s / 2 * b2, b3 = bend(y + s / 2 * v2, v3, push + slope / 2, spring, loss, cubic);
        double v4 = v + s * b3, b4 = bend(y + s * v3, v4, push + slope, spring, loss, cubic);
        y += s / 6 * (v + 2 * v2 + 2 * v3 + v4);
        v += s / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
    }
    m->state[0] = y;
    m->state[1] = v;
    m->last = a;
    return -loss * v - spring * y * (1 + cubic * y * y);
}

/*MODEL*/

static double excess(const Model *s, int i, Motion *m, double r, double v, double f) {
    double remembered;
    m->r = r + s->give[i * LAWS + i] * f;
    m->v = v + s->give_v[i * LAWS + i] * f;
    return f - law(i, s->p, m, &remembered);
}

/* f = law(r + g (f - f0), v + h (f - f0)) by secants, now and then a Newton step, kept within a bracket. */
static double root(const Model *s, int i, Motion *m, double start) {
    double r = m->r - s->give[i * LAWS + i] * start, v = m->v - s->give_v[i * LAWS + i] * start;
    double f = start, low = -HUGE_VAL, high = HUGE_VAL, gradient = 0, over = excess(s, i, m, r, v, f);
    for (int k = 0; k < 60 && !(fabs(over) <= 1e-12 * (1 + fabs(f))); k++) {
        if (over > 0) {
            high = f;
        } else {
            low = f;
        }
        if (k % 3 == 0) {
            double difference = 1e-6 * (1 + fabs(f));
            gradient = (excess(s, i, m, r, v, f + difference) - over) / difference;
        }
        double next = gradient > 0.05 ? f - over / gradient : f - over;
        if (low > -HUGE_VAL && high < HUGE_VAL && !(next > low && next < high)) {
            next = (low + high) / 2;
        }
        double there = excess(s, i, m, r, v, next);
        gradient = next == f ? gradient : (there - over) / (next - f);
        f = next;
        over = there;
    }
    m->r = r + s->give[i * LAWS + i] * f;
    m->v = v + s->give_v[i * LAWS + i] * f;
    return f;
}

/* What pulls the ends of a link together beside its laws and its own stretch: its lower end is lifted since the start. */
static double pulled(const Model *s, int l) {
    return s->link_drive[l] - s->p[STIFFNESS + l] * (s->lift[l] - s->lift_at_start[l]) - s->p[DAMPING + l] * s->rise[l];
}

static void see(Model *s) {
    for (int l = 0; l < LINKS; l++) {
        s->link_r[l] = stretch(s, s->x, 1, l) - (s->lift[l] - s->lift_at_start[l]);
        s->link_v[l] = speed(s->x, 1, l) - s->rise[l];
    }
}

static void place(const Model *s, int i, Motion *m, const double *free_x, const double *multiplied, double t) {
    int link = LAW_LINK[i];
    m->k = s->p[STIFFNESS + link];
    m->c = s->p[DAMPING + link];
    m->h = s->h;
    m->t = t;
    m->r_before = s->link_r[link];
    m->memory = s->memory[i];
    m->modulation = multiplied[i];
    m->r = stretch(s, free_x, 1, link) - (s->lift[link] - s->lift_at_start[link]);
    m->v = speed(free_x, 1, link) - s->rise[link];
    for (int k = 0; k < LAWS; k++) {
        m->r += s->give[i * LAWS + k] * s->force[k];
        m->v += s->give_v[i * LAWS + k] * s->force[k];
    }
    double ago = lateness(i, s->p);
    m->late_r = ago > 0 ? earlier(&s->r[i], ago / s->h) : 0;
    m->late_v = ago > 0 ? earlier(&s->v[i], ago / s->h) : 0;
}

/* What the links carry, and what the sensors read. */
static void read_all(Model *s, const double *u, double t, int first) {
    double reading[OUTPUTS];
    for (int l = 0; l < LINKS; l++) {
        s->load[l] = s->p[STIFFNESS + l] * s->link_r[l] + s->p[DAMPING + l] * s->link_v[l];
    }
    for (int i = 0; i < LAWS; i++) {
        s->load[LAW_LINK[i]] += s->force[i];
    }
    for (int o = 0; o < OUTPUTS; o++) {
        int place = PLACE[o];
        if (READING[o] == FORCE) {
            reading[o] = s->load[place] + s->link_drive[place];
        } else if (READING[o] == ACCELERATION) {
            double force = s->body_drive[place];
            for (int l = 0; l < LINKS; l++) {
                force -= ((UPPER[l] == place) - (LOWER[l] == place)) * (s->load[l] + s->link_drive[l]);
            }
            reading[o] = force / s->p[MASS + place];
        } else if (READING[o] == VELOCITY) {
            reading[o] = s->x[BODIES + place] + s->base_v;
        } else {
            reading[o] = s->x[place] / s->w + s->base_x;
        }
    }
    sense(s, u, t, first, reading);
}

/* One step of length h to time t with inputs that go from the last to u. */
static int step(Model *s, const double *u, double t) {
    double multiplied[AT_LEAST_1(LAWS)];
    Motion m;
    modulate(s, u, multiplied);
    for (int l = 0; l < LINKS; l++) {
        s->before_link[l] = pulled(s, l);
    }
    memcpy(s->before_body, s->body_drive, sizeof s->before_body);
    drive(s, u, t);
    if (DRIVEN) {
        for (int l = 0; l < LINKS; l++) {
            double before = s->link_r[l];
            s->link_r[l] = -u[0];
            s->link_v[l] = -u[1];
            for (int i = 0; i < LAWS; i++) {
                if (LAW_LINK[i] == l) {
                    Motion now = {-u[0], -u[1], before, s->memory[i], t, s->h, s->p[STIFFNESS + l], s->p[DAMPING + l], multiplied[i], 0, 0};
                    s->force[i] = law(i, s->p, &now, &s->memory[i]);
                }
            }
        }
        return 1;
    }
    double base = BASE_MOVES ? u[0] : 0, free_x[STATES], now[AT_LEAST_1(LAWS)];
    for (int i = 0; i < STATES; i++) {
        free_x[i] = s->before[i * COLUMNS] * s->before_base + s->after[i * COLUMNS] * base;
        for (int k = 0; k < STATES; k++) {
            free_x[i] += s->transition[i * STATES + k] * s->x[k];
        }
        for (int k = 0; k < LAWS; k++) {
            free_x[i] += s->before[i * COLUMNS + 1 + LAW_LINK[k]] * s->force[k];
        }
        for (int l = 0; l < LINKS; l++) {
            free_x[i] += s->before[i * COLUMNS + 1 + l] * s->before_link[l] + s->after[i * COLUMNS + 1 + l] * pulled(s, l);
        }
        for (int b = 0; b < BODIES; b++) {
            free_x[i] += s->before[i * COLUMNS + 1 + LINKS + b] * s->before_body[b] + s->after[i * COLUMNS + 1 + LINKS + b] * s->body_drive[b];
        }
    }
    for (int i = 0; i < LAWS; i++) {
        double ahead = 2 * s->force[i] - s->previous[i];
        s->previous[i] = s->force[i];
        s->force[i] = ahead;
    }
    for (int sweep = 0; sweep < (LAWS == 1 ? 1 : 40); sweep++) {
        double moved = 0;
        for (int i = 0; i < LAWS; i++) {
            place(s, i, &m, free_x, multiplied, t);
            double kept = s->force[i];
            s->force[i] = root(s, i, &m, kept);
            moved = fmax(moved, fabs(s->force[i] - kept) / (1 + fabs(s->force[i])));
        }
        if (moved < 1e-12) {
            break;
        }
    }
    for (int i = 0; i < LAWS; i++) {
        double remembered;
        place(s, i, &m, free_x, multiplied, t);
        law(i, s->p, &m, &remembered);
        now[i] = remembered;
        append(&s->r[i], m.r);
        append(&s->v[i], m.v);
    }
    memcpy(s->memory, now, sizeof now);
    for (int i = 0; i < STATES; i++) {
        s->x[i] = free_x[i];
        for (int k = 0; k < LAWS; k++) {
            s->x[i] += s->after[i * COLUMNS + 1 + LAW_LINK[k]] * s->force[k];
        }
        if (!(fabs(s->x[i]) < 1e4)) {
            return 0;
        }
    }
    see(s);
    s->base_x += s->h * s->base_v + s->h * s->h * (2 * s->before_base + base) / 6;
    s->base_v += s->h * (s->before_base + base) / 2;
    s->before_base = base;
    return 1;
}

static void begin(Model *s) {
    double multiplied[AT_LEAST_1(LAWS)] = {0};
    s->w = 1;
    s->before_base = BASE_MOVES && !DRIVEN ? s->u[0] : 0;
    drive(s, s->u, 0);
    memcpy(s->lift_at_start, s->lift, sizeof s->lift);
    launch(s);
    modulate(s, s->u, multiplied);
    see(s);
    for (int i = 0; i < LAWS; i++) {
        append(&s->r[i], 0);
        append(&s->v[i], 0);
    }
    if (DRIVEN) {
        s->h = s->p[PARAMETERS - 1];
        for (int l = 0; l < LINKS; l++) {
            s->link_r[l] = -s->u[0];
            s->link_v[l] = -s->u[1];
            s->load[l] = s->p[STIFFNESS + l] * s->link_r[l] + s->p[DAMPING + l] * s->link_v[l] + s->link_drive[l];
        }
        for (int i = 0; i < LAWS; i++) {
            int l = LAW_LINK[i];
            s->memory[i] = first_memory(i, s->p, CARRIED[i] < 0 ? 0 : s->p[CARRIED[i]]);
            Motion now = {-s->u[0], -s->u[1], -s->u[0], s->memory[i], 0, s->h, s->p[STIFFNESS + l], s->p[DAMPING + l], multiplied[i], 0, 0};
            s->force[i] = law(i, s->p, &now, &s->memory[i]);
            s->load[l] += s->force[i];
        }
    }
    memcpy(s->last, s->u, sizeof s->u);
    read_all(s, s->u, 0, 1);
}

/* To a time length [s] ahead, in steps of the last parameter's length at most. */
static int advance(Model *s, double length) {
    int count = DRIVEN ? 1 : (int) fmax(1, ceil(length / s->p[PARAMETERS - 1] - 1e-6));
    double h = length / count, u[AT_LEAST_1(INPUTS)];
    if (s->steps == 0 || fabs(h / s->h - 1) > 1e-6) {
        if (s->steps > 0 && REMEMBERS) {
            return 0;
        }
        prepare(s, h);
    }
    for (int n = 1; n <= count; n++) {
        for (int i = 0; i < INPUTS; i++) {
            u[i] = s->last[i] + (s->u[i] - s->last[i]) * n / count;
        }
        s->steps++;
        if (!step(s, u, s->time + n * h)) {
            return 0;
        }
        read_all(s, u, s->time + n * h, 0);
    }
    s->time += length;
    memcpy(s->last, s->u, sizeof s->u);
    return 1;
}

static Model *create(void) {
    Model *s = (Model *) calloc(1, sizeof(Model));
    if (s) {
        memcpy(s->p, VALUES, sizeof VALUES);
    }
    return s;
}

static void forget(Model *s) {
    for (int i = 0; i < LAWS; i++) {
        free(s->r[i].values);
        free(s->v[i].values);
    }
    for (int i = 0; i < DELAYS; i++) {
        free(s->late[i].values);
    }
}

/* The FMI 3.0 interface (fmi-standard.org): what co-simulation needs; all else is refused. */

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif

typedef enum { OK, WARNING, DISCARD, FAULT, FATAL } Status;
typedef unsigned int Reference;
typedef unsigned char Bit;

EXPORT const char *fmi3GetVersion(void) {
    return "3.0";
}

EXPORT Status fmi3SetDebugLogging(void *s, Bit on, size_t n, const char *const *categories) {
    (void) s, (void) on, (void) n, (void) categories;
    return OK;
}

EXPORT void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *resources, Bit visible, Bit logging, Bit events, Bit early,
                                         const Reference *required, size_t n, void *environment, void *log, void *update) {
    (void) name, (void) resources, (void) visible, (void) logging, (void) events, (void) early, (void) required, (void) n;
    (void) environment, (void) log, (void) update;
    return strcmp(token, TOKEN) ? NULL : create();
}

EXPORT void *fmi3InstantiateModelExchange(void) {
    return NULL;
}

EXPORT void *fmi3InstantiateScheduledExecution(void) {
    return NULL;
}

EXPORT void fmi3FreeInstance(void *s) {
    if (s) {
        forget((Model *) s);
        free(s);
    }
}

EXPORT Status fmi3EnterInitializationMode(void *s, Bit toleranceDefined, double tolerance, double start, Bit stopDefined, double stop) {
    (void) toleranceDefined, (void) tolerance, (void) stopDefined, (void) stop;
    ((Model *) s)->start = start;
    return OK;
}

EXPORT Status fmi3ExitInitializationMode(void *s) {
    begin((Model *) s);
    return OK;
}

EXPORT Status fmi3Terminate(void *s) {
    (void) s;
    return OK;
}

EXPORT Status fmi3Reset(void *s) {
    Model *fresh = create();
    if (!fresh) {
        return FAULT;
    }
    forget((Model *) s);
    memcpy(s, fresh, sizeof(Model));
    free(fresh);
    return OK;
}

static double *variable(Model *s, Reference reference) {
    unsigned int i = reference - 1;
    if (i < INPUTS) {
        return &s->u[i];
    }
    i -= INPUTS;
    if (i < OUTPUTS) {
        return &s->y[i];
    }
    i -= OUTPUTS;
    if (i < LAWS) {
        return &s->force[i];
    }
    i -= LAWS;
    return i < PARAMETERS ? &s->p[i] : NULL;
}

EXPORT Status fmi3GetFloat64(void *s, const Reference *references, size_t n, double *values, size_t m) {
    (void) m;
    for (size_t i = 0; i < n; i++) {
        double *found = references[i] == 0 ? NULL : variable((Model *) s, references[i]);
        if (references[i] && !found) {
            return FAULT;
        }
        values[i] = found ? *found : ((Model *) s)->start + ((Model *) s)->time;
    }
    return OK;
}

EXPORT Status fmi3SetFloat64(void *s, const Reference *references, size_t n, const double *values, size_t m) {
    (void) m;
    for (size_t i = 0; i < n; i++) {
        double *found = references[i] == 0 ? NULL : variable((Model *) s, references[i]);
        if (!found || references[i] > INPUTS && (references[i] <= INPUTS + OUTPUTS + LAWS || ((Model *) s)->steps > 0)) {
            return FAULT;
        }
        *found = values[i];
    }
    return OK;
}

EXPORT Status fmi3DoStep(void *s, double time, double length, Bit noSetBefore, Bit *event, Bit *terminate, Bit *early, double *reached) {
    (void) time, (void) noSetBefore;
    *event = *terminate = *early = 0;
    Status status = advance((Model *) s, length) ? OK : FAULT;
    *reached = ((Model *) s)->start + ((Model *) s)->time;
    return status;
}

#define REFUSED(name) EXPORT Status name(void) { return FAULT; }
REFUSED(fmi3EnterEventMode) REFUSED(fmi3EnterStepMode) REFUSED(fmi3EnterConfigurationMode) REFUSED(fmi3ExitConfigurationMode)
REFUSED(fmi3GetFloat32) REFUSED(fmi3GetInt8) REFUSED(fmi3GetUInt8) REFUSED(fmi3GetInt16) REFUSED(fmi3GetUInt16) REFUSED(fmi3GetInt32)
REFUSED(fmi3GetUInt32) REFUSED(fmi3GetInt64) REFUSED(fmi3GetUInt64) REFUSED(fmi3GetBoolean) REFUSED(fmi3GetString) REFUSED(fmi3GetBinary)
REFUSED(fmi3GetClock) REFUSED(fmi3SetFloat32) REFUSED(fmi3SetInt8) REFUSED(fmi3SetUInt8) REFUSED(fmi3SetInt16) REFUSED(fmi3SetUInt16)
REFUSED(fmi3SetInt32) REFUSED(fmi3SetUInt32) REFUSED(fmi3SetInt64) REFUSED(fmi3SetUInt64) REFUSED(fmi3SetBoolean) REFUSED(fmi3SetString)
REFUSED(fmi3SetBinary) REFUSED(fmi3SetClock) REFUSED(fmi3GetNumberOfVariableDependencies) REFUSED(fmi3GetVariableDependencies)
REFUSED(fmi3GetFMUState) REFUSED(fmi3SetFMUState) REFUSED(fmi3FreeFMUState) REFUSED(fmi3SerializedFMUStateSize) REFUSED(fmi3SerializeFMUState)
REFUSED(fmi3DeserializeFMUState) REFUSED(fmi3GetDirectionalDerivative) REFUSED(fmi3GetAdjointDerivative) REFUSED(fmi3GetIntervalDecimal)
REFUSED(fmi3GetIntervalFraction) REFUSED(fmi3GetShiftDecimal) REFUSED(fmi3GetShiftFraction) REFUSED(fmi3SetIntervalDecimal)
REFUSED(fmi3SetIntervalFraction) REFUSED(fmi3SetShiftDecimal) REFUSED(fmi3SetShiftFraction) REFUSED(fmi3EvaluateDiscreteStates)
REFUSED(fmi3UpdateDiscreteStates) REFUSED(fmi3EnterContinuousTimeMode) REFUSED(fmi3CompletedIntegratorStep) REFUSED(fmi3SetTime)
REFUSED(fmi3SetContinuousStates) REFUSED(fmi3GetContinuousStateDerivatives) REFUSED(fmi3GetEventIndicators) REFUSED(fmi3GetContinuousStates)
REFUSED(fmi3GetNominalsOfContinuousStates) REFUSED(fmi3GetNumberOfEventIndicators) REFUSED(fmi3GetNumberOfContinuousStates)
REFUSED(fmi3GetOutputDerivatives) REFUSED(fmi3ActivateModelPartition)
