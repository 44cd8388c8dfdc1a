# How MuJoCo is given what it has not.


def in_mujoco(x, file, laws, modulators, drives, sensors):
    """Runs the model in MuJoCo and reads its sensors, past the same band limit as the recording.

    Seen from the base, its acceleration is gravity turned round; MuJoCo's accelerometers so read what those on the bodies do. Laws and drives act
    as generalized forces, in the callback of MuJoCo that adds passive forces."""
    import mujoco
    model = mujoco.MjModel.from_xml_path(file)
    data = mujoco.MjData(model)
    inner = math.ceil(x.step / model.opt.timestep - 1e-9)
    model.opt.timestep = h = x.step / inner
    points = x.samples * x.oversampling
    base = x.held(x.base)
    body = np.zeros((len(MASS), points))
    link_force = np.zeros((len(LINKS), points))
    for kind, place, force in drives:
        if kind == "launch":
            data.qvel[place] = force
        else:
            (body if kind == "body" else link_force)[place] += x.held(force)
    series = [modulator(x, None) if modulator and not modulator.other else None for modulator in modulators]
    steps = [Step(law[0], h) for law in laws]
    past_r = [[0.0] for _ in laws]
    past_v = [[0.0] for _ in laws]
    load = [0.0] * len(LINKS)
    begun = [0.0]

    def motion_of(link):
        lower, upper = LINKS[link]
        return (float(data.qpos[upper] - (data.qpos[lower] if lower >= 0 else 0)),
                float(data.qvel[upper] - (data.qvel[lower] if lower >= 0 else 0)))

    def between(values, time):
        at = min(time / x.step, points - 1.0)
        j = min(int(at), points - 2)
        return (1 - at + j) * values[j] + (at - j) * values[j + 1]

    def late(values, time, ago):
        at = (time - ago) / h
        j = int(math.floor(at))
        return 0.0 if j < 0 else values[j] if j + 1 >= len(values) else values[j] + (at - j) * (values[j + 1] - values[j])

    moved = {"load": lambda link: load[link], "deflection": lambda link: motion_of(link)[0], "speed": lambda link: motion_of(link)[1]}

    class Now:
        """A modulator that goes by another link, at this moment."""
        fine_series = staticmethod(lambda value: value)

    def forces(length):
        out = []
        for i, (link, law, lateness) in enumerate(laws):
            step = steps[i]
            step.r, step.v = motion_of(link)
            step.t = data.time
            step.h = max(length, 1e-9)
            if lateness > 0:
                step.late_r, step.late_v = late(past_r[i], data.time, lateness), late(past_v[i], data.time, lateness)
            if series[i] is not None:
                step.modulation = float(between(series[i], data.time))
            elif modulators[i]:
                step.modulation = float(modulators[i](Now, moved))
            out.append(law(step))
        for link in range(len(LINKS)):
            r, v = motion_of(link)
            load[link] = STIFFNESS[link] * r + DAMPING[link] * v
        for (link, _, _), (force, _) in zip(laws, out):
            load[link] += force
        return out

    def passive(_, __):
        model.opt.gravity[AXIS] = -between(base, data.time)
        found = [(law[0], force) for law, (force, _) in zip(laws, forces(data.time - begun[0]))]
        for link, force in found + [(link, between(values, data.time)) for link, values in enumerate(link_force)]:
            lower, upper = LINKS[link]
            data.qfrc_passive[upper] -= force
            if lower >= 0:
                data.qfrc_passive[lower] += force
        for place, values in enumerate(body):
            data.qfrc_passive[place] += between(values, data.time)

    read = np.zeros((len(sensors), points * inner))
    mujoco.set_mjcb_passive(passive)
    try:
        for j in range(points * inner):
            mujoco.mj_forward(model, data)
            for o, (place, reading, _) in enumerate(sensors):
                read[o, j] = (load[place] + between(link_force[place], data.time) if reading == "force"
                              else data.sensor(OUTPUTS[o]).data[AXIS if reading == "acceleration" else 0])
            mujoco.mj_step(model, data)
            for i, (_, remembered) in enumerate(forces(h)):
                steps[i].memory = remembered
                steps[i].r_before = steps[i].r
                past_r[i].append(steps[i].r)
                past_v[i].append(steps[i].v)
            begun[0] = data.time
    finally:
        mujoco.set_mjcb_passive(None)
    outputs = []
    for values, (place, reading, faults) in zip(read, sensors):
        spectrum = np.fft.rfft(values, x.padded * x.oversampling * inner)[:len(x.omega)] / (x.oversampling * inner)
        moving = over_j_omega(x, x.base) if reading in ("velocity", "position") else 0
        spectrum = spectrum + (over_j_omega(x, moving) if reading == "position" else moving)
        outputs.append(x.series(faults(x, spectrum)))
    return outputs
