# How the model above is solved. Spectra are complex arrays over the lines x.omega.


def covering(least):
    """The least even number, not below one given, with no prime factor above 5: a length that transforms fast."""
    n = least + least % 2
    while True:
        rest = n
        for prime in (2, 3, 5):
            while rest % prime == 0:
                rest //= prime
        if rest == 1:
            return n
        n += 2


REACH = 16  # samples: the longest gap that is filled by what the samples about it tell, and those asked on either side


def gaps(lost):
    """First sample and the one after the last of each run of lost ones."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], lost, [False]]).astype(int)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist()))


def bridged(values):
    """Lost samples as those about them make them likeliest: the linear combination of least mean square error (Wiener 1949).

    By the series' own autocorrelation, found in a few rounds; a straight line over what is longer than REACH."""
    values = np.asarray(values, float)
    lost = np.isnan(values)
    if not lost.any():
        return values
    known = np.flatnonzero(~lost)
    if len(known) == 0:
        return np.zeros(len(values))
    out = np.interp(np.arange(len(values)), known, values[known])
    far = np.zeros(len(values), bool)
    for begin, end in gaps(lost):
        far[begin:end] = end - begin > REACH
    for _ in range(3):
        out = filled(out, lost, far)
    return out


def filled(out, lost, far):
    """A round of it. far: what is lost in gaps too long."""
    mean = out[~far].mean()
    centred = np.where(far, 0, out - mean)
    correlation = np.array([centred[lag:] @ centred[:len(out) - lag] for lag in range(3 * REACH + 1)])
    correlation[0] *= 1 + 1e-10
    if not correlation[0] > 0:
        return out
    following = out.copy()
    for begin, end in gaps(lost):
        if end - begin > REACH or begin == 0 or end == len(out):
            continue
        near = [i for i in [*range(begin - REACH, begin), *range(end, end + REACH)] if 0 <= i < len(out) and not lost[i]]
        among = correlation[np.abs(np.subtract.outer(near, near))]
        towards = correlation[np.abs(np.subtract.outer(near, range(begin, end)))]
        following[begin:end] = mean + np.linalg.solve(among, towards).T @ (out[near] - mean)
    return following


def resting(values, pause):
    """The same, at its mean where more samples than that are lost together, within REACH of what was measured."""
    values = np.array(values, float)
    lost = np.isnan(values)
    mean = values[~lost].mean() if not lost.all() else 0.0
    for begin, end in gaps(lost):
        if begin > 0 and end < len(values) and end - begin + 1 > max(pause, 2 * REACH):
            values[begin + REACH:end - REACH] = mean
    return bridged(values)


class Excitation:
    """What drives the model: spectra over a record padded with silence, of lines below 45 % of the sampling rate.

    rate [Hz], base: its acceleration [m/s^2], channels: everything recorded, by name; gain: of the sensors' anti-alias filter by frequency
    in units of the rate; finer: least points of the free run for each sample; pushing: measured forces that drive the model, by name."""

    def __init__(self, rate, base, channels, gain=None, finer=2, pushing=()):
        self.rate = rate
        self.samples = len(base)
        self.channels = channels
        self.pushing = pushing
        self.padded = covering(int(self.samples + 4 * rate))
        wanted = math.ceil(240 / rate) * 2 - 1
        self.oversampling = 1 if finer == 1 else max(finer, 1 << (wanted.bit_length() - 1))
        self.step = 1 / (rate * self.oversampling)
        lines = int(0.45 * self.padded)
        self.omega = 2 * math.pi * np.arange(lines) * rate / self.padded
        self.omega[0] = 1e-3 * 2 * math.pi * rate / self.padded
        self.base = self.spectrum(base)
        self.forced = finer == 4
        self.track = 0  # what of the base's position its acceleration does not hold
        self.roll_off = np.ones(lines) if gain is None else gain(np.arange(lines) / self.padded)

    def channel(self, name):
        if name not in self.channels:
            raise ValueError("the model needs the channel " + name + ", which the input lacks")
        values = self.channels[name]
        return self.spectrum(resting(values, int(2 * self.rate)) if name in self.pushing else bridged(values))

    def spectrum(self, series):
        return np.fft.rfft(series, self.padded)[:len(self.omega)]

    def spectrum_of_fine(self, series):
        return np.fft.rfft(series, self.padded * self.oversampling)[:len(self.omega)] / self.oversampling

    def spectrum_of_force(self, series):
        return self.spectrum_of_fine(series) * self.roll_off

    def series(self, spectrum):
        return np.fft.irfft(whole(spectrum, self.padded), self.padded)[:self.samples]

    def fine_series(self, spectrum):
        points = self.padded * self.oversampling
        return np.fft.irfft(whole(spectrum, points), points)[:self.samples * self.oversampling] * self.oversampling

    def held(self, spectrum):
        """The fine series raised by what straight lines between its points take away, (x / sin x)^2."""
        x = self.omega * self.step / 2
        gain = (x / np.sin(x)) ** 2
        gain[0] = 1
        return self.fine_series(spectrum * gain)


def whole(spectrum, points):
    out = np.zeros(points // 2 + 1, complex)
    out[:len(spectrum)] = spectrum
    out[0] = out[0].real
    return out


def over_j_omega(x, spectrum):
    """Integral over time; nothing at the first line."""
    out = spectrum / (1j * x.omega)
    out[0] = 0
    return out


def moved_base(rate, channels, name, of_rate=(0.5,), gain=(1.0,)):
    """The excitation by the base's measured motion: acceleration less its mean, or velocity or position turned into acceleration.

    gain: what the sensors' anti-alias filter lets through, at frequencies of_rate over the rate."""
    values = bridged(channels[name])
    quantity = name.split(".")[1]
    passed = lambda relative: np.interp(relative, of_rate, gain)
    if quantity == "acc":
        return Excitation(rate, values - np.nanmean(channels[name]), channels, passed)
    still = Excitation(rate, np.zeros(len(values)), channels, passed)
    last = len(values) - 1
    line = values[0] + (values[last] - values[0]) * np.arange(last + 1) / max(1, last)
    levelled = still.spectrum(values - line)
    still.base = levelled * (1j * still.omega if quantity == "vel" else -still.omega ** 2)
    if quantity == "pos":
        still.track = still.spectrum(line)
        still.track[0] += levelled[0]
    return still


class Linear:
    """The linear part at every line: q = Z^-1 f, exact, with no step. further: dynamic stiffness that linear laws add, by link."""

    def __init__(self, x, further):
        self.x = x
        n = len(MASS)
        self.stiffness = [STIFFNESS[l] + 1j * x.omega * DAMPING[l] + further[l] for l in range(len(LINKS))]
        z = np.zeros((len(x.omega), n, n), complex)
        for l, (lower, upper) in enumerate(LINKS):
            z[:, upper, upper] += self.stiffness[l]
            if lower >= 0:
                z[:, lower, lower] += self.stiffness[l]
                z[:, lower, upper] -= self.stiffness[l]
                z[:, upper, lower] -= self.stiffness[l]
        for i in range(n):
            z[:, i, i] -= x.omega ** 2 * MASS[i]
        self.inverse = np.linalg.inv(z)

    def add_body_force(self, q, body, force):
        for i in range(len(MASS)):
            q[i] += self.inverse[:, i, body] * force

    def add_link_force(self, q, link, force):
        """A force that pulls the link's ends together."""
        lower, upper = LINKS[link]
        self.add_body_force(q, upper, -force)
        if lower >= 0:
            self.add_body_force(q, lower, force)

    def add_launch(self, q, body, velocity):
        """A body that moves at the first sample."""
        self.add_body_force(q, body, np.full(len(self.x.omega), MASS[body] * velocity * self.x.rate, complex))

    def still(self, acceleration):
        return acceleration


class LinearFree(Linear):
    """The same where no spring holds a part of the model.

    A spectrum stands for what repeats, and what no spring holds would not be at rest again before the record comes round: so along each such
    motion phi (K phi = 0, phi' M phi = 1) two smooth forces act in the silence behind the record, and a constant displacement is free, such that
    it starts from rest at 0."""

    def __init__(self, x, further):
        super().__init__(x, further)
        n = len(MASS)
        stiffness = np.zeros((n, n))
        for l, (lower, upper) in enumerate(LINKS):
            ends = np.zeros(n)
            ends[upper] = 1
            if lower >= 0:
                ends[lower] = -1
            stiffness += np.outer(ends, ends) * (STIFFNESS[l] + np.real(np.atleast_1d(further[l])[0]))
        root = np.sqrt(MASS)
        values, vectors = np.linalg.eigh(stiffness / np.outer(root, root))
        loose = np.abs(values) <= 1e-12 * np.abs(values).max()
        self.motions = (vectors[:, loose] / root[:, None]).T
        r = len(self.motions)
        self.seconds = (x.padded - x.samples) / x.rate
        size = max(np.abs(stiffness).sum(axis=0).max(), 1)
        bordered = np.zeros((n + r, n + r))
        bordered[:n, :n] = stiffness
        bordered[:n, n:] = size * (MASS * self.motions).T
        bordered[n:, :n] = size * MASS * self.motions
        self.balanced = np.linalg.inv(bordered)[:n, :n]
        self.end = np.exp(-1j * x.omega * (x.samples - 1) / x.rate)
        u = np.arange(1, x.padded - x.samples + 1) / (x.padded - x.samples + 1)
        self.lead_in = self.silence(smooth_step(1 - 4 * (1 - u)))
        self.lead_out = self.silence(smooth_step(1 - 4 * u))
        push = np.sin(math.pi * u) ** 8
        shapes = [self.silence(push), self.silence(push * 4 * (u - 0.5))]
        self.answers = []
        amiss = np.zeros((3 * r, 3 * r))
        for b in range(2 * r):
            q = np.zeros((n, len(x.omega)), complex)
            for body in range(n):
                self.add(q, body, shapes[b % 2] * MASS[body] * self.motions[b // 2][body])
            self.answers.append(q)
            mean = np.zeros(r)
            mean[b // 2] = shapes[b % 2][0].real
            amiss[:, b] = self.amiss(q, mean)
        for i in range(r):
            q = np.zeros((n, len(x.omega)), complex)
            self.shift(q, i, 1)
            amiss[:, 2 * r + i] = self.amiss(q, np.zeros(r))
        self.correction = -np.linalg.pinv(amiss, rcond=1e-15) if r else amiss

    def still(self, acceleration):
        """What repeats has no mean acceleration."""
        if len(self.motions):
            acceleration[0] = 0
        return acceleration

    def silence(self, series):
        return self.x.spectrum(np.concatenate([np.zeros(self.x.samples), series]))

    def add_body_force(self, q, body, force):
        if len(self.motions) == 0:
            super().add_body_force(q, body, force)
            return
        whole_force = force + self.lead_in * self.first(force) + self.lead_out * self.last(force)
        own = np.zeros_like(q)
        self.add(own, body, whole_force)
        self.correct(q, self.amiss(own, self.motions[:, body] * whole_force[0].real))
        q += own

    def add_launch(self, q, body, velocity):
        momentum = MASS[body] * velocity
        r = len(self.motions)
        blow = np.full(len(self.x.omega), self.x.rate, complex)
        for b in range(len(MASS)):
            carried = MASS[b] * np.dot(self.motions[:, b], self.motions[:, body])
            rest = momentum * ((b == body) - carried)
            if abs((b == body) - carried) >= 1e-12:
                super().add_body_force(q, b, blow * rest)
        if r:
            self.correct(q, np.concatenate([np.zeros(2 * r), -self.motions[:, body] * momentum / self.seconds]))

    def add(self, q, body, force):
        """What a force does that repeats, what no spring holds left out of its mean."""
        for i in range(len(MASS)):
            before = q[i][0].real
            q[i] += self.inverse[:, i, body] * force
            q[i][0] = before + self.balanced[i, body] * force[0].real

    def correct(self, q, amiss):
        amount = self.correction @ amiss
        for b, answer in enumerate(self.answers):
            q += answer * amount[b]
        for i in range(len(self.motions)):
            self.shift(q, i, amount[len(self.answers) + i])

    def shift(self, q, motion, amount):
        q[:, 0] += amount * self.motions[motion] * self.x.padded

    def amiss(self, q, mean):
        """Mean force, displacement and velocity at the first sample along each motion, all as accelerations."""
        at = np.array([self.first(each) for each in q])
        speed = np.array([self.first(1j * self.x.omega * each) for each in q])
        along = self.motions * MASS
        return np.concatenate([mean / self.x.padded, along @ at / self.seconds ** 2, along @ speed / self.seconds])

    def first(self, spectrum):
        return (spectrum[0].real + 2 * spectrum[1:].real.sum()) / self.x.padded

    def last(self, spectrum):
        return (spectrum[0].real + 2 * (spectrum[1:].real * self.end[1:].real + spectrum[1:].imag * self.end[1:].imag).sum()) / self.x.padded


def smooth_step(u):
    return np.where(u <= 0, 0, u ** 4 * (35 + u * (-84 + u * (70 - 20 * u))))


def stretch(q, link):
    lower, upper = LINKS[link]
    return q[upper] - (q[lower] if lower >= 0 else 0)


def run(x, linear_model, further, laws, modulators, drives, sensors):
    """All of it: motion of the bodies against the base from base, drives and laws; then what the sensors read."""
    linear = linear_model(x, further)
    q = np.zeros((len(MASS), len(x.omega)), complex)
    for body in range(len(MASS)):
        linear.add_body_force(q, body, -MASS[body] * x.base)
    for kind, place, force in drives:
        add_drive(linear, q, kind, place, force)
    forces = []
    if laws:
        lift = Lift(x, drives)
        known = known_forces(x, drives, lift)
        forces = [x.spectrum_of_force(force) for force in free_run(x, linear, known, lift, laws, modulators)]
        for law, force in zip(laws, forces):
            linear.add_link_force(q, law[0], force)
    outputs = []
    for place, reading, faults in sensors:
        if reading == "force":
            read = linear.stiffness[place] * stretch(q, place)
            read = read + sum(force for law, force in zip(laws, forces) if law[0] == place)
            read = read + sum(force for kind, link, force in drives if kind == "link" and link == place)
            read = read - linear.stiffness[place] * sum(lift for kind, link, lift in drives if kind == "lift" and link == place)
        else:
            read = body_motion(x, linear, q, place, reading)
        outputs.append(x.series(faults(x, read)))
    return outputs


def body_motion(x, linear, q, body, reading):
    if reading == "acceleration":
        return x.base - linear.still(x.omega ** 2 * q[body])
    base = over_j_omega(x, x.base)
    return 1j * x.omega * q[body] + base if reading == "velocity" else q[body] + over_j_omega(x, base) + x.track


def add_drive(linear, q, kind, place, force):
    if kind == "launch":
        linear.add_launch(q, place, force)
    elif kind == "body":
        linear.add_body_force(q, place, force)
    elif kind == "lift":
        linear.add_link_force(q, place, -linear.stiffness[place] * force)
    else:
        linear.add_link_force(q, place, force)


class Lift:
    """How far the lower ends of links are lifted since the start [m], and how fast [m/s], by link and point: a link is that much shorter."""

    def __init__(self, x, drives):
        points = len(x.held(x.base))
        self.height = np.zeros((len(LINKS), points))
        self.rate = np.zeros((len(LINKS), points))
        self.start = np.zeros(len(LINKS))
        for kind, link, lift in drives:
            if kind == "lift":
                height = x.fine_series(lift)
                self.start[link] += height[0]
                self.height[link] += height - height[0]
                self.rate[link] += x.fine_series(1j * x.omega * lift)


def known_forces(x, drives, lift):
    """Force on each body by the drives, at the free run's points; nothing where there is no drive."""
    if not drives:
        return None
    body = np.zeros((len(MASS), len(x.omega)), complex)
    for kind, place, force in drives:
        if kind == "body":
            body[place] += force
        elif kind in ("link", "lift"):
            pull = force if kind == "link" else -(STIFFNESS[place] + 1j * x.omega * DAMPING[place]) * force
            lower, upper = LINKS[place]
            body[upper] -= pull
            if lower >= 0:
                body[lower] += pull
    series = np.array([x.held(each) for each in body])
    for (lower, upper), stiffness, start in zip(LINKS, STIFFNESS, lift.start):
        series[upper] -= stiffness * start
        if lower >= 0:
            series[lower] += stiffness * start
    for kind, place, velocity in drives:
        if kind == "launch":
            series[place][0] += 2 / x.step * MASS[place] * velocity
    return series


class Modulator:
    """What a law is multiplied by: a series, or a part of what another link does, which moves with the law within the step."""

    def __init__(self, of, other=None, part=lambda whole: whole):
        self.of = of
        self.other = other
        self.part = part

    def __call__(self, x, links):
        return self.of(x, links)


def measured_value(channel):
    return Modulator(lambda x, links: x.fine_series(centred(x, channel)))


def measured_level(channel, low, high):
    """Where a channel stands in a range, -1 to 1, straight between its samples."""
    def of(x, links):
        values = bridged(x.channels[channel])[:x.samples]
        fine = np.interp(np.arange(x.samples * x.oversampling) / x.oversampling, np.arange(x.samples), values)
        return np.clip((2 * fine - low - high) / (high - low), -1, 1)
    return Modulator(of)


def measured_angle(rate):
    return Modulator(lambda x, links: x.fine_series(above(x, 0.03, over_j_omega(x, centred(x, rate)))))


def lean(upper, lower):
    """How far one place has moved against another."""
    return Modulator(lambda x, links: x.fine_series(above(x, 0.3, over_j_omega(x, over_j_omega(x, x.channel(upper) - x.channel(lower))))))


def ride(seconds):
    """How hard the base was shaken of late."""
    def of(x, links):
        out = x.fine_series(x.base)
        decay = math.exp(-x.step / seconds)
        square = 0.0
        for i, value in enumerate(out):
            square = decay * square + (1 - decay) * value * value
            out[i] = math.sqrt(square)
        return out
    return Modulator(of)


def other_link(of, link):
    """Load, deflection or speed of another link."""
    return Modulator(lambda x, links: x.fine_series(links[of](link)), (of, link))


def part_of(part, modulator):
    of = {"magnitude": np.abs, "positive": lambda y: np.maximum(0, y), "negative": lambda y: np.maximum(0, -y)}[part]
    return Modulator(lambda x, links: of(modulator(x, links)), modulator.other, of)


def centred(x, name):
    """A channel without its mean."""
    series = x.series(x.channel(name))
    return x.spectrum(series - series.mean())


def above(x, lowest, spectrum):
    """What is faster than a frequency [Hz]."""
    u = (x.omega / (2 * math.pi * lowest)) ** 8
    return spectrum * u / (1 + u)


class Step:
    """One step of a link as a law sees it: r [m] and v [m/s] at its end, r before, the law's memory, time t [s], length h [s], k [N/m], c [N s/m]."""

    def __init__(self, link, h):
        self.k = STIFFNESS[link]
        self.c = DAMPING[link]
        self.h = h
        self.t = self.r = self.v = self.r_before = self.memory = self.late_r = self.late_v = 0.0
        self.modulation = 1.0


def exact_hold(h):
    """The exact step over h [s] of the states [w q, q'] with inputs linear within the step: base acceleration, force in each link, on each body.

    x(h) = E x(0) + B0 u(0) + B1 u(h), from the functions phi by their series and doublings (Higham 2008, ch. 10)."""
    n = len(MASS)
    w = math.sqrt(max(1, max(STIFFNESS[l] / MASS[LINKS[l][1]] for l in range(len(LINKS)))))
    a = np.zeros((2 * n, 2 * n))
    b = np.zeros((2 * n, 1 + len(LINKS) + n))
    a[:n, n:] = w * np.eye(n)
    b[n:, 0] = -1
    for l, (lower, upper) in enumerate(LINKS):
        ends = np.zeros(n)
        ends[upper] = 1
        if lower >= 0:
            ends[lower] = -1
        a[n:, :n] -= np.outer(ends / MASS, ends) * (STIFFNESS[l] / w)
        a[n:, n:] -= np.outer(ends / MASS, ends) * DAMPING[l]
        b[n:, 1 + l] = -ends / MASS
    b[n:, 1 + len(LINKS):] = np.diag(1 / MASS)
    doublings = max(0, math.ceil(math.log2(max(np.abs(a).sum(axis=1).max(), 1e-300) * h / 0.5)))
    small = a * (h / 2 ** doublings)
    term = np.eye(2 * n)
    zero, one, two = np.zeros((3, 2 * n, 2 * n))
    for k in range(20):
        zero += term
        one += term / (k + 1)
        two += term / ((k + 1) * (k + 2))
        term = term @ small / (k + 1)
    for _ in range(doublings):
        two = 0.25 * one @ one + 0.5 * two
        one = 0.5 * zero @ one + 0.5 * one
        zero = zero @ zero
    after = h * two @ b
    return w, zero, h * one @ b - after, after


def free_run(x, linear, known, lift, laws, modulators):
    """Force of each law [N] at every point."""
    base = x.held(x.base)
    late = any(law[2] > 0 for law in laws)
    modulation = [modulator(x, None) if modulator and not modulator.other else None for modulator in modulators]
    others = [modulator if modulator and modulator.other else None for modulator in modulators]
    way = FreeRun(x.step, laws, others, 0 if late or not x.forced else 3 if isinstance(linear, LinearFree) else 1)
    way.begin(len(base), True)
    for j in range(len(base) - 1):
        way.go(base, known, lift.height, lift.rate, modulation, j, 0.0)
        if not np.abs(way.x).max() < 1e4:
            raise ValueError("the simulation leaves all bounds: a law of the model is unstable with these values")
    return way.force


class FreeRun:
    """The linear part steps exactly, each law is solved at the end of its step. A step in which a force jumps is gone through again in parts, and
    what is told of the force at its two ends is what has the same impulse."""

    PARTS = 8

    def __init__(self, h, laws, others, divisions):
        self.h = h
        self.laws = laws
        self.others = others
        self.finer = FreeRun(h / self.PARTS, laws, others, divisions - 1) if divisions > 0 else None
        self.w, self.transition, self.before, self.after = exact_hold(h)
        m = len(laws)
        self.links = [law[0] for law in laws]
        effect = [self.after[:, 1 + link] for link in self.links]
        self.give = [[float(self.stretch_of(effect[j], self.links[i])) for j in range(m)] for i in range(m)]
        self.give_speed = [[float(self.speed_of(effect[j], self.links[i])) for j in range(m)] for i in range(m)]
        self.give_other = [[float(self.whole_of(effect[j], i)) + self.carries(i, j) for j in range(m)] for i in range(m)]
        self.steps = [Step(link, h) for link in self.links]

    def whole_of(self, state, i):
        """What law i goes by of another link, but for the forces of laws in that; nothing where it goes by none."""
        if not self.others[i]:
            return 0.0
        of, link = self.others[i].other
        k, c = {"load": (STIFFNESS[link], DAMPING[link]), "deflection": (1, 0), "speed": (0, 1)}[of]
        return k * self.stretch_of(state, link) + c * self.speed_of(state, link)

    def carries(self, i, j):
        """Whether law j acts in the link whose load law i goes by."""
        return 1.0 if self.others[i] and self.others[i].other == ("load", self.links[j]) else 0.0

    def stretch_of(self, state, link):
        lower, upper = LINKS[link]
        return (state[upper] - (state[lower] if lower >= 0 else 0)) / self.w

    def speed_of(self, state, link):
        lower, upper = LINKS[link]
        n = len(MASS)
        return state[n + upper] - (state[n + lower] if lower >= 0 else 0)

    def begin(self, points, whole):
        m = len(self.laws)
        self.whole = whole
        self.displacement, self.velocity, self.force = (np.zeros((m, points)) for _ in range(3))
        self.now, self.last, self.memory, self.greatest = ([0.0] * m for _ in range(4))
        self.x = np.zeros(2 * len(MASS))
        if self.finer:
            self.finer.begin(self.PARTS + 1, False)

    def earlier(self, series, index, ago):
        at = index - max(1, ago / self.h)
        floor = math.floor(at)
        share = at - floor
        return 0.0 if floor < 0 else series[floor] * (1 - share) + (series[floor + 1] * share if floor + 1 < index else 0)

    def lifted(self, i, height, rate):
        """What law i goes by of another link is the less by."""
        if not self.others[i]:
            return 0.0
        of, link = self.others[i].other
        k, c = {"load": (STIFFNESS[link], DAMPING[link]), "deflection": (1, 0), "speed": (0, 1)}[of]
        return float(k * height[link] + c * rate[link])

    def place(self, i, j, r, v, whole, modulation, since):
        step = self.steps[i]
        step.t = since + (j + 1) * self.h
        step.r_before = float(self.displacement[i, j])
        step.memory = self.memory[i]
        step.modulation = 1.0 if modulation[i] is None else float(modulation[i][j + 1])
        if self.others[i]:
            step.modulation = float(self.others[i].part(whole[i] + sum(self.give_other[i][k] * self.now[k] for k in range(len(r)))))
        step.r = r[i] + sum(self.give[i][k] * self.now[k] for k in range(len(r)))
        step.v = v[i] + sum(self.give_speed[i][k] * self.now[k] for k in range(len(r)))
        if self.laws[i][2] > 0:
            step.late_r = float(self.earlier(self.displacement[i], j + 1, self.laws[i][2]))
            step.late_v = float(self.earlier(self.velocity[i], j + 1, self.laws[i][2]))

    def go(self, base, known, height, rate, modulation, j, since):
        """A step, in parts where a force jumps in it."""
        m = len(self.laws)
        earlier, old = self.last, self.x
        self.step(base, known, height[:, j + 1], rate[:, j + 1], modulation, j, since)
        self.greatest = [max(a, abs(b)) for a, b in zip(self.greatest, self.now)]
        jumped = any(abs(self.now[i] - (2 * self.last[i] - earlier[i])) > 0.1 * self.greatest[i] for i in range(m))
        if jumped and self.finer:
            self.in_parts(old, earlier, base, known, height, rate, modulation, j, since)
        else:
            self.memory = [self.laws[i][1](self.steps[i])[1] for i in range(m)]

    def step(self, base, known, height, rate, modulation, j, since):
        m = len(self.laws)
        free = self.transition @ self.x + self.before[:, 0] * base[j] + self.after[:, 0] * base[j + 1]
        for i in range(m):
            free += self.before[:, 1 + self.links[i]] * self.now[i]
        if known is not None:
            free += self.before[:, 1 + len(LINKS):] @ known[:, j] + self.after[:, 1 + len(LINKS):] @ known[:, j + 1]
        self.now, self.last = [2 * f - g for f, g in zip(self.now, self.last)], self.now
        r = [float(self.stretch_of(free, link) - height[link]) for link in self.links]
        v = [float(self.speed_of(free, link) - rate[link]) for link in self.links]
        whole = [float(self.whole_of(free, i)) - self.lifted(i, height, rate) for i in range(m)]
        for _ in range(1 if m == 1 else 40):
            moved = 0.0
            for i in range(m):
                self.place(i, j, r, v, whole, modulation, since)
                kept = self.now[i]
                self.now[i] = root(self.laws[i][1], self.steps[i], self.give[i][i], self.give_speed[i][i], kept, self.followed(i, whole))
                moved = max(moved, abs(self.now[i] - kept) / (1 + abs(self.now[i])))
            if moved < 1e-12:
                break
        self.x = free
        for i in range(m):
            self.x = self.x + self.after[:, 1 + self.links[i]] * self.now[i]
        for i in range(m):
            self.place(i, j, r, v, whole, modulation, since)
            self.displacement[i, j + 1] = self.steps[i].r
            self.velocity[i, j + 1] = self.steps[i].v
            self.force[i, j + 1] = self.now[i]

    def followed(self, i, whole):
        """What law i is multiplied by where it has a force; none where that does not move with it."""
        if not self.others[i]:
            return None
        rest = whole[i] + sum(self.give_other[i][k] * self.now[k] for k in range(len(whole)) if k != i)
        return lambda f: float(self.others[i].part(rest + self.give_other[i][i] * f))

    def in_parts(self, old, earlier, base, known, height, rate, modulation, j, since):
        part, count, m = self.finer, self.PARTS, len(self.laws)
        share = np.arange(count + 1) / count
        between = lambda series: None if series is None else series[..., j, None] + (series[..., j + 1] - series[..., j])[..., None] * share
        part.x, part.memory, part.greatest = old, list(self.memory), list(self.greatest)
        part.now = list(self.last)
        part.last = [f - (f - g) / count for f, g in zip(self.last, earlier)]
        part.force[:, 0] = self.last
        part.displacement[:, 0] = self.displacement[:, j]
        part.velocity[:, 0] = self.velocity[:, j]
        shaken, pushed, modulated = between(base), between(known), [between(each) for each in modulation]
        lifted, rising = between(height), between(rate)
        for k in range(count):
            part.go(shaken, pushed, lifted, rising, modulated, k, since + j * self.h)
        self.x, self.now, self.memory = part.x, list(part.now), list(part.memory)
        self.displacement[:, j + 1] = part.displacement[:, count]
        self.velocity[:, j + 1] = part.velocity[:, count]
        for i in range(m):
            inner = part.force[i, 1:count]
            first = (part.force[i, 0] - self.last[i] / 2) / count + float((inner * (1 - share[1:count])).sum()) / count
            second = (part.force[i, count] - self.now[i] / 2) / count + float((inner * share[1:count]).sum()) / count
            self.force[i, j] += first - self.last[i] / 2
            self.force[i, j + 1] = self.now[i] + second - self.now[i] / 2
            if j == 0 and self.whole:
                self.force[i, 0] = 2 * first


def root(law, step, give, give_speed, start, followed=None):
    """f = law(r + g (f - f0), v + h (f - f0)), times what another link does then, by secants, now and then a Newton step, kept within a bracket."""
    r = step.r - give * start
    v = step.v - give_speed * start

    def excess(f):
        step.r = r + give * f
        step.v = v + give_speed * f
        if followed:
            step.modulation = followed(f)
        return f - law(step)[0]

    f = start
    low, high = -math.inf, math.inf
    over = excess(f)
    gradient = math.nan
    for k in range(60):
        if abs(over) <= 1e-12 * (1 + abs(f)):
            break
        if over > 0:
            high = f
        else:
            low = f
        if k % 3 == 0:
            difference = 1e-6 * (1 + abs(f))
            gradient = (excess(f + difference) - over) / difference
        following = f - over / gradient if gradient > 0.05 else f - over
        if low > -math.inf and high < math.inf and not low < following < high:
            following = (low + high) / 2
        there = excess(following)
        gradient = gradient if following == f else (there - over) / (following - f)
        f, over = following, there
    step.r = r + give * f
    step.v = v + give_speed * f
    return f


def maxwell_arm_stiffness(omega, arm_stiffness_N_per_m, relaxation_s):
    """Force over displacement of a spring and a dashpot in series."""
    u = omega * relaxation_s
    return arm_stiffness_N_per_m * (u * u + 1j * u) / (1 + u * u)


def reflex_stiffness(omega, reflex_N_per_m, reflex_Ns_per_m, delay_s):
    """Force over displacement of a muscle that answers late."""
    return (reflex_N_per_m + 1j * omega * reflex_Ns_per_m) * np.exp(-1j * omega * delay_s)


def muscle_reflex_stiffness(omega, reflex_N_per_m, reflex_Ns_per_m, delay_s, twitch_s, side):
    """Force over displacement of two muscles that answer late and slowly, each one way."""
    return (reflex_N_per_m + 1j * omega * reflex_Ns_per_m) * np.exp(-1j * omega * delay_s) / (1 + 1j * omega * twitch_s)


def learned_inertance_stiffness(omega, inertance_kg):
    """Force over displacement of a force on the relative acceleration."""
    return -omega ** 2 * inertance_kg + 0j


def tone(x, cosine_N, sine_N, frequency_hz):
    """A steady force on a body."""
    phase = 2 * math.pi * frequency_hz * np.arange(x.samples) / x.rate
    return x.spectrum(cosine_N * np.cos(phase) + sine_N * np.sin(phase))


def measured(x, channel, offset_N):
    """A measured force on a body."""
    return x.channel(channel) + x.spectrum(np.full(x.samples, -offset_N))


def given(x, channel, share):
    """The force that another simulation gave for a link."""
    return x.channel(channel) * share


def across_body(x, pushed_by, coupled_mass_kg):
    """Acceleration along another axis pushes a body along the model's."""
    return x.channel(pushed_by) * coupled_mass_kg


def across_link(x, across, coupled_mass_kg):
    """Acceleration along another axis pushes between the ends of a link."""
    return x.channel(across) * coupled_mass_kg


def passed(x):
    """Part that is told of a displacement from accelerations: below 0.6 Hz drift would drown it."""
    u = (x.omega / (2 * math.pi * 0.6)) ** 8
    return u / (1 + u)


def cross_axis(x, upper, lower, cross_stiffness_N_per_m):
    """Relative motion along another axis stretches the link, above 0.6 Hz."""
    gain = -cross_stiffness_N_per_m * passed(x) / x.omega ** 2
    gain[0] = 0
    return (x.channel(upper) - x.channel(lower)) * gain


def swing(x, base, rate, swing_frequency_hz, swing_damping_ratio, height_m):
    """How far what carries no sensor swings across, riding on the base's rotation."""
    w = 2 * math.pi * swing_frequency_hz
    lift = height_m * over_j_omega(x, x.channel(rate))
    out = lift - (x.channel(base) - x.omega ** 2 * lift) / (w * w - x.omega ** 2 + 2j * swing_damping_ratio * w * x.omega)
    out[0] = 0
    return out * passed(x)


def upper_swings(x, swings_on, tilted_by, lower, cross_stiffness_N_per_m, swing_frequency_hz, swing_damping_ratio, height_m):
    """The link is stretched along another axis; its upper end carries no sensor and swings."""
    own = swing(x, swings_on, tilted_by, swing_frequency_hz, swing_damping_ratio, height_m)
    return cross_stiffness_N_per_m * own - cross_axis(x, lower, swings_on, cross_stiffness_N_per_m)


def lower_swings(x, swings_on, tilted_by, upper, cross_stiffness_N_per_m, swing_frequency_hz, swing_damping_ratio, height_m):
    """The same where the lower end does."""
    return -upper_swings(x, swings_on, tilted_by, upper, cross_stiffness_N_per_m, swing_frequency_hz, swing_damping_ratio, height_m)


def rotation(x, rate, lever_arm_m):
    """How far the lower end of a link is lifted by rotation [m]."""
    return lever_arm_m * over_j_omega(x, x.channel(rate))


def launch(x, velocity_m_per_s):
    """A body that moves when the recording begins [m/s]: a start, and no force."""
    return velocity_m_per_s


def mount_resonance(x, reading, frequency_hz, damping_ratio):
    """The sensor rides on its strap."""
    u = x.omega / (2 * math.pi * frequency_hz)
    return reading * (1 + 2j * damping_ratio * u) / (1 - u * u + 2j * damping_ratio * u)


def ac_coupling(x, reading, corner_hz):
    """The sensor is AC coupled: a first-order high-pass."""
    u = x.omega / (2 * math.pi * corner_hz)
    return reading * 1j * u / (1 + 1j * u)


def stiffening_mount(x, reading, frequency_hz, damping_ratio, cubic_per_m2):
    """The sensor rides on a strap that stiffens: y" + 2 zeta w y' + w^2 (y + c y^3) = -a, of which it reads a + y" (Runge and Kutta, fourth order)."""
    w = 2 * math.pi * frequency_hz
    spring, loss = w * w, 2 * damping_ratio * w
    a = x.held(reading)
    parts = math.ceil(w * x.step / 0.2)
    h = x.step / parts

    def bend(y, v, push):
        return -push - loss * v - spring * y * (1 + cubic_per_m2 * y * y)

    out = np.zeros(len(a))
    y = v = 0.0
    for i in range(len(a)):
        out[i] = -loss * v - spring * y * (1 + cubic_per_m2 * y * y)
        slope = float(a[i + 1] - a[i]) / parts if i + 1 < len(a) else 0.0
        for part in range(parts):
            push = float(a[i]) + part * slope
            b1 = bend(y, v, push)
            v2 = v + h / 2 * b1
            b2 = bend(y + h / 2 * v, v2, push + slope / 2)
            v3 = v + h / 2 * b2
            b3 = bend(y + h / 2 * v2, v3, push + slope / 2)
            v4 = v + h * b3
            b4 = bend(y + h * v3, v4, push + slope)
            y += h / 6 * (v + 2 * v2 + 2 * v3 + v4)
            v += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4)
    return x.spectrum_of_fine(out)


def delay(x, reading, delay_s, drift_s_per_s):
    """Samples are late, and later and later where the sensor's clock runs slow."""
    if abs(drift_s_per_s) <= 3e-9:
        return reading * np.exp(-1j * x.omega * delay_s)
    return late_by(x, reading, lambda t: delay_s + drift_s_per_s * t)


def wandering_delay(x, reading, delay_s, cosine_s, sine_s, wandering_hz):
    """Samples are late by what comes and goes."""
    w = 2 * np.pi * wandering_hz
    return late_by(x, reading, lambda t: delay_s + cosine_s * np.cos(w * t) + sine_s * np.sin(w * t))


def late_by(x, reading, late):
    """What was there as much earlier as it is late, by cubic interpolation."""
    series = x.fine_series(reading)
    out = np.zeros(len(series))
    at = np.arange(len(series)) - late(x.step * np.arange(len(series))) / x.step
    i = np.floor(at).astype(int)
    inside = np.flatnonzero((i >= 1) & (i + 2 < len(series)))
    u, i = at[inside] - i[inside], i[inside]
    before, here, next_one, behind = series[i - 1], series[i], series[i + 1], series[i + 2]
    one = 0.5 * (next_one - before)
    two = 0.5 * (2 * before - 5 * here + 4 * next_one - behind)
    three = 0.5 * (3 * (here - next_one) + behind - before)
    out[inside] = here + u * (one + u * (two + u * three))
    return x.spectrum_of_fine(out)


def gain(x, reading, factor):
    """Wrong sensitivity."""
    return reading * factor


def beside(x, reading, beside):
    """What else moves the sensor that is known and no part of the model."""
    return reading + x.channel(beside)


def bias(x, reading, bias):
    """A constant is added."""
    return reading + x.spectrum(np.full(x.samples, bias))


def misalignment(x, reading, across, beside, towards_x_rad, towards_y_rad):
    """The sensor is turned, and all its axes with it."""
    a, b = math.tan(towards_x_rad), math.tan(towards_y_rad)
    return reading * math.sqrt(1 + a * a + b * b) + x.channel(across) * a + x.channel(beside) * b


def turned(x, reading, across, angle_rad):
    """The sensor is turned about one axis, and all its axes with it."""
    return reading / math.cos(angle_rad) + x.channel(across) * math.tan(angle_rad)


def lever_arm(x, reading, rate, lever_arm_m):
    """The sensor sits off the point: rotation adds arm times angular acceleration."""
    return reading + lever_arm_m * 1j * x.omega * x.channel(rate)


def clipping(x, reading, low, high):
    """Values beyond a range are cut."""
    return x.spectrum_of_fine(np.clip(x.fine_series(reading), low, high))


def late(x, late_channel, delay_s):
    """What a measured force leaves out because its channel is late."""
    return x.channel(late_channel) * (np.exp(1j * x.omega * delay_s) - 1)


def coupled(x, coupled_channel, corner_hz):
    """What a measured force leaves out because its channel is AC coupled."""
    passed = x.series(x.channel(coupled_channel))
    lost = np.concatenate([[0], np.cumsum(math.pi * corner_hz / x.rate * (passed[1:] + passed[:-1]))])
    return x.spectrum(lost)


def quantised(x, reading, step, level):
    """Values are rounded to whole steps."""
    return x.spectrum(level + step * np.rint((x.series(reading) - level) / step))


def rectifying(x, reading):
    """The sign is lost."""
    return x.spectrum_of_fine(np.abs(x.fine_series(reading)))


def driven(rate, channels, name, laws, modulators, drives, sensors):
    """Links whose ends both move as measured: k r + c v and the laws along the measured motion, sample by sample.

    A law with memory starts where the force measured at the first sample puts it, and again after every gap. sensors: link, channel, bias, faults."""
    h = 1 / rate
    raw = np.asarray(channels[name], float)
    x = Excitation(rate, np.zeros(len(raw)), channels, finer=1)
    position, velocity = stroke(channels, name, h)
    r, v = -position, -velocity
    total = [STIFFNESS[l] * r + DAMPING[l] * v for l in range(len(LINKS))]
    for kind, place, force in drives(x):
        total[place] = total[place] + x.series(force)
    starts = {i for i in range(len(raw)) if not math.isnan(raw[i]) and (i == 0 or math.isnan(raw[i - 1]))}
    begun = set()
    links = {"load": lambda link: x.spectrum(total[link]), "deflection": lambda link: x.spectrum(r),
             "speed": lambda link: 1j * x.omega * x.spectrum(r)}
    for (link, law, _, memory_of), modulator in zip(laws, modulators):
        begins = memory_of is not None and link not in begun
        if begins:
            begun.add(link)
        modulation = modulator(x, links) if modulator else None
        step = Step(link, h)
        force = np.zeros(len(r))
        for j in range(len(r)):
            step.t = j * h
            step.r_before = float(r[max(0, j - 1)])
            step.r = float(r[j])
            step.v = float(v[j])
            step.modulation = 1.0 if modulation is None else float(modulation[j])
            if j in starts:
                step.r_before = step.r
                carried = 0.0
                for place, channel, bias_N, _ in sensors:
                    if begins and place == link and channel in channels and not math.isnan(channels[channel][j]):
                        carried = float(channels[channel][j] - total[link][j] - bias_N)
                step.memory = memory_of(carried) if memory_of else 0.0
            force[j], remembered = law(step)
            step.memory = remembered
        total[link] = total[link] + force
    return [x.series(faults(x, x.spectrum(total[place]))) for place, _, _, faults in sensors]


def stroke(channels, name, h):
    """Position [m] and velocity [m/s] of the base."""
    own = bridged(channels[name])
    location, quantity, axis = name.split(".")
    if quantity == "vel":
        position = np.zeros(len(own))
        for i in range(1, len(own)):
            position[i] = position[i - 1] + h * (own[i - 1] + own[i]) / 2
        return position, own
    beside = location + ".vel." + axis
    if beside in channels:
        return own, bridged(channels[beside])
    before = np.maximum(0, np.arange(len(own)) - 1)
    after = np.minimum(len(own) - 1, np.arange(len(own)) + 1)
    return own, (own[after] - own[before]) / ((after - before) * h)


def read_recording(file):
    """Sampling rate [Hz], time [s] and channels of a CSV as 'wbv convert' writes it: even times, empty cells where a sample is missing."""
    import gzip
    rate = None
    with (gzip.open if file.endswith(".gz") else open)(file, "rt") as lines:
        for line in lines:
            if line.startswith("# rate:"):
                rate = float(line.split()[2])
            if not line.startswith("#"):
                break
        names = line.strip().split(",")
        rows = [[float(cell) if cell else math.nan for cell in row.rstrip("\r\n").split(",")] for row in lines if not row.startswith("#")]
    table = np.array(rows).T
    time = table[0]
    if rate is None:
        rate = 1 / np.median(np.diff(time))
        rate = round(rate) if abs(rate - round(rate)) < 0.01 * rate else rate
    if np.abs(time - time[0] - np.arange(len(time)) / rate).max() > 0.25 / rate:
        raise ValueError(file + ": its rows are not 1/%g s apart; 'wbv convert' makes them so" % rate)
    return rate, time, dict(zip(names[1:], table[1:]))


def main():
    import sys
    if len(sys.argv) != 3:
        sys.exit("usage: python3 " + sys.argv[0] + " RECORDING.csv OUT.csv")
    try:
        rate, time, channels = read_recording(sys.argv[1])
        outputs = simulate(rate, channels)
    except ValueError as fault:
        sys.exit(str(fault))
    with open(sys.argv[2], "w") as out:
        out.write("t," + ",".join(OUTPUTS) + "\n")
        for i in range(len(time)):
            out.write(repr(float(time[i])) + "," + ",".join(repr(float(values[i])) for values in outputs) + "\n")


if __name__ == "__main__":
    main()
