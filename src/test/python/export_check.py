"""Compares what 'wbv export' writes with 'wbv simulate' on the same input, and prints the tables of docs/export.md.

    pip install numpy fmpy mujoco pymoca
    python3 src/test/python/export_check.py [--wbv './wbv'] [--only 'BEGIN OF A NAME;ANOTHER'] [--to python,fmu,mujoco,modelica]

The models are those of src/test/resources/export/models.json, one for each law, drive and sensor fault and some of several. The input is made here
(simulated: tones of random phases from 1 to 12 Hz and noise, seed 1, 7 s at 60 Hz, one sample missing).

python: greatest difference of an output over that output's root mean square, of the worst output.
fmu, laws: the same, where the forces of the laws are those of the unit in FMPy, stepped at wbv's own points (240 Hz); from 2 s on to 1.5 s before the end.
fmu, sensors; mujoco; modelica: what their own sensors read, past the band limit that the recording has: root mean square of the difference over the
output's, in the same part. The FMU and the Modelica (worked out by this script, see Flat) go at 3840 Hz, MuJoCo at 1920 Hz."""
import argparse
import importlib.util
import json
import math
import os
import re
import shlex
import shutil
import subprocess
import tempfile

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
RUNTIME = os.path.join(HERE, "../../main/resources/wbv/export/runtime.py")
MODELS = os.path.join(HERE, "../resources/export/models.json")
SIZES = {"platform.acc.z": 0.6, "platform.acc.x": 0.6, "platform.gyr.y": 0.1, "platform.vel.z": 0.02, "platform.pos.z": 2e-3, "seat.force.z": 12.0,
         "head.acc.x": 0.6, "head.acc.y": 0.6}


FILES = {"python": "model.py", "fmu": "model.fmu", "mujoco": "in_mujoco.xml", "modelica": "model.mo"}
# What is left out at the begin and at the end where wbv is compared with a simulator that steps forward [s]: seen through a band limit, a record
# that begins and ends all at once has begun before and ends later.
BEGIN = 2.0
END = 1.5


def recording(file, rate=60, seconds=7):
    random = np.random.default_rng(1)
    time = np.arange(rate * seconds) / rate
    columns = []
    for name, size in SIZES.items():
        x = sum(np.sin(2 * np.pi * (1 + 11 * random.random()) * time + 2 * np.pi * random.random()) for _ in range(12))
        columns.append(np.round(size * (x / math.sqrt(6) * np.minimum(1, time / 0.5) + 0.002 * random.standard_normal(len(time))), 9))
    with open(file, "w") as out:
        out.write("# rate: %d Hz\nt,%s\n" % (rate, ",".join(SIZES)))
        for i in range(len(time)):
            out.write(",".join([repr(float(time[i]))] + ["" if i == 300 and c == 0 else repr(float(x[i])) for c, x in enumerate(columns)]) + "\n")


def load(file):
    spec = importlib.util.spec_from_file_location("model", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    exec(open(RUNTIME).read(), module.__dict__)   # all of it, not only what this model needs
    return module


def difference(expected, found):
    return max(np.abs(np.asarray(b) - a).max() / math.sqrt((a ** 2).mean()) for a, b in zip(expected, found))


def seen(x, outputs, laws):
    """As a recording at the sampling rate has them: what is faster than 45 % of it is gone; led in and out within a second, which is not compared.

    Without a law nothing is faster than the input: then the samples as they are."""
    if not laws:
        return outputs[:, ::x.oversampling]
    ends = np.clip(np.minimum(np.arange(1, outputs.shape[1] + 1), np.arange(outputs.shape[1], 0, -1)) * x.step, 0, 1)
    taper = ends ** 4 * (35 + ends * (-84 + ends * (70 - 20 * ends)))
    return [x.series(x.spectrum_of_fine(each * taper)) for each in outputs]


def within(expected, found, rate):
    """Root mean square of the difference over that of the output, of the worst output."""
    part = slice(int(BEGIN * rate), -int(END * rate))
    return max(math.sqrt(((b - a)[part] ** 2).mean() / (a[part] ** 2).mean()) for a, b in zip(expected, found))


class Unit:
    """An FMU in FMPy."""

    def __init__(self, file, start={}):
        from fmpy import extract, read_model_description
        from fmpy.fmi3 import FMU3Slave
        self.description = read_model_description(file)
        self.folder = extract(file)
        self.reference = {each.name: each.valueReference for each in self.description.modelVariables}
        self.inputs = [each.name for each in self.description.modelVariables if each.causality == "input"]
        self.outputs = [each.name for each in self.description.modelVariables if each.causality == "output"]
        self.slave = FMU3Slave(guid=self.description.guid, unzipDirectory=self.folder, modelIdentifier=self.description.coSimulation.modelIdentifier,
                               instanceName="check")
        self.slave.instantiate()
        for name, value in start.items():
            self.slave.setFloat64([self.reference[name]], [value])

    def run(self, h, inputs, wanted):
        """inputs by name at points h [s] apart. @return wanted variables at the points"""
        names = [self.reference[name] for name in self.inputs]
        table = np.array([inputs[name] for name in self.inputs]).T
        get = [self.reference[name] for name in wanted]
        self.slave.enterInitializationMode()
        self.slave.setFloat64(names, list(map(float, table[0])))
        self.slave.exitInitializationMode()
        out = np.zeros((len(table), len(get)))
        out[0] = self.slave.getFloat64(get)
        for i in range(1, len(table)):
            self.slave.setFloat64(names, list(map(float, table[i])))
            self.slave.doStep((i - 1) * h, h)
            out[i] = self.slave.getFloat64(get)
        self.slave.terminate()
        self.slave.freeInstance()
        shutil.rmtree(self.folder)
        return out.T


def signal(module, x, name, modulated):
    """An input of a simulator that steps forward, at the fine points."""
    if name in modulated:
        return modulated[name]
    words = name.split(" ")
    if name.startswith("value of "):
        return module.measured_value(words[2])(x, None)
    if name.startswith("angle of "):
        return x.held(module.over_j_omega(x, x.channel(words[2])))
    if name.startswith("lean of "):
        return x.held(module.cross_axis(x, words[2], words[4], 1.0))
    if name.startswith("angular acceleration of "):
        return x.held(1j * x.omega * x.channel(words[3]))
    return x.held(x.channel(name))


def signals(module, x, model, base, names):
    modulated = {}
    for link in model["links"]:
        for law in link.get("laws", []):
            text = law.get("modulator", "1").split(" of the ")[-1]
            if text.startswith("angle of "):
                modulated[text] = module.measured_angle(text.split(" ")[2])(x, None)
            elif text.startswith("lean of "):
                modulated[text] = module.lean(text.split(" ")[2], text.split(" ")[4])(x, None)
    sensor = model["base"].get("sensor")
    if sensor:
        place, _, axis = sensor.split(".")
        modulated[place + ".acc." + axis] = base
    return {name: signal(module, x, name, modulated) for name in names}


def excitation(module, model, rate, channels, finer):
    """As 'simulate' makes it, with more points between samples."""
    sensor = model["base"].get("sensor")
    if not sensor:
        return module.Excitation(rate, np.zeros(len(next(iter(channels.values())))), channels, finer=finer)
    x = module.moved_base(rate, channels, sensor)
    fine = module.Excitation(rate, np.zeros(x.samples), channels, finer=finer)
    fine.base = x.base
    return fine


def check_fmu(module, model, file, rate, channels, expected):
    """What its law forces, at wbv's own points, make of wbv's outputs; and its own outputs, at 16 times as many points."""
    if model["bodies"][0].get("fixed"):
        place, _, axis = model["base"]["sensor"].split(".")
        position, velocity = module.stroke(channels, model["base"]["sensor"], 1 / rate)
        x = module.Excitation(rate, np.zeros(len(position)), channels, finer=1)
        start = {"step_s": 1 / rate}
        for i, law in enumerate(module.LAWS):
            if "law_%d.force_at_start_N" % i in Unit(file).reference:
                r, v = -position[0], -velocity[0]
                own = float(channels[module.SENSORS[0][1]][0] - module.SENSORS[0][2] - module.STIFFNESS[0] * r - module.DAMPING[0] * v)
                start["law_%d.force_at_start_N" % i] = own
        unit = Unit(file, start)
        inputs = signals(module, x, model, None, [name for name in unit.inputs if not name.startswith(place)])
        inputs.update({place + ".pos." + axis: position, place + ".vel." + axis: velocity})
        return (difference(expected, [x.series(x.spectrum(each)) for each in unit.run(1 / rate, inputs, unit.outputs)]),) * 2
    x = excitation(module, model, rate, channels, 64)
    unit = Unit(file, {"longest_step_s": 1.0})
    laws = getattr(module, "LAWS", [])
    direct = within(expected, seen(x, unit.run(x.step, signals(module, x, model, x.held(x.base), unit.inputs), unit.outputs), laws), rate)
    if not laws:
        return math.nan, direct

    def forces(h, base, known, laws, modulation):
        x = excitation(module, model, rate, channels, 4)
        unit = Unit(file, {"longest_step_s": 1.0})
        return unit.run(h, signals(module, x, model, base, unit.inputs), ["law_%d.force" % i for i in range(len(laws))])
    module.free_run = forces
    part = slice(int(BEGIN * rate), -int(END * rate))
    return difference([each[part] for each in expected], [each[part] for each in module.simulate(rate, channels)]), direct


def check_mujoco(file, rate, channels, expected):
    module = load(file)
    return within(expected, module.simulate(rate, channels), rate)


class Flat:
    """The flat Modelica that wbv writes, worked out as it stands: equations in their order, 'der' by Runge and Kutta's fourth-order steps."""

    def __init__(self, text):
        if "delay(" in text or "der(s_" in text.split("equation")[1].replace("\n  der(s_", ""):
            raise NotImplementedError("delays and implied accelerations are left to Modelica")
        self.start, self.inputs, self.outputs, lines, slopes = {}, [], {}, [], {}
        declarations, equations = text.split("\nequation\n")
        for line in declarations.splitlines()[1:]:
            name = re.match(r"\s*(?:parameter |input |output )?Real (\w+)", line).group(1)
            label = re.findall(r'"([^"]*)";$', line)
            start = re.search(r"start = (\S+?), fixed", line)
            if line.strip().startswith("parameter"):
                lines.append("%s = %s" % (name, re.search(r"(?:\w|\)) = ([^\";]+)", line.split("Real ")[1]).group(1)))
            elif line.strip().startswith("input"):
                self.inputs.append((name, label[0]))
            elif line.strip().startswith("output"):
                self.outputs[label[0]] = name
            if start:
                self.start[name] = start.group(1)
        constants = {}
        exec("\n".join(lines), {}, constants)
        self.start = {name: float(constants.get(value, value) if not re.match(r"-?[\d.]", value) else value) for name, value in self.start.items()}
        body = []
        for line in equations.splitlines()[:-1]:
            left, right = line.strip().rstrip(";").split(" = ", 1)
            right = self.python(right)
            if left.startswith("der("):
                slopes[left[4:-1]] = right
            elif " * " in left:
                body.append("%s = (%s) / %s" % (left.split(" * ")[1], right, left.split(" * ")[0]))
            else:
                body.append("%s = %s" % (left, right))
        states = ", ".join(self.start)
        code = ["def work(time, x, u):", "    [%s] = x" % states, "    [%s] = u" % ", ".join(name for name, _ in self.inputs)] + ["    " + each for each in body]
        code.append("    return [%s], [%s]" % (", ".join(slopes[name] for name in self.start), ", ".join(self.outputs.values())))
        space = {name: getattr(math, name) for name in ("exp", "log", "sqrt", "sin", "cos", "tan", "tanh")}
        space.update(constants, abs=abs, min=min, max=max)
        exec("\n".join(code), space)
        self.work = space["work"]

    def python(self, text):
        """'if a then b else c' as Python has it."""
        out, depth, begin = "", 0, 0
        for i, letter in enumerate(text):
            if letter == "(":
                depth += 1
                if depth == 1:
                    out, begin = out + text[begin:i + 1], i + 1
            elif letter == ")":
                depth -= 1
                if depth == 0:
                    out, begin = out + self.python(text[begin:i]).replace(" if ", " IF ").replace(" else ", " ELSE "), i
        out = out + text[begin:]
        if out.startswith("if "):
            condition, rest = out[3:].split(" then ", 1)
            then, otherwise = rest.split(" else ", 1)
            out = "%s IF %s ELSE %s" % (then, condition, self.python(otherwise))
        out = out.replace(" IF ", " if ").replace(" ELSE ", " else ").replace("^", "**")
        return out

    def run(self, h, inputs, points):
        u = np.array([inputs[name] for _, name in self.inputs]).T
        x = np.array(list(self.start.values()))
        out = []
        for j in range(points):
            last = j + 1 == points
            ahead = u[j] if last else u[j + 1]
            one, read = self.work(j * h, x, u[j])
            out.append(read)
            two = self.work((j + 0.5) * h, x + h / 2 * np.array(one), (u[j] + ahead) / 2)[0]
            three = self.work((j + 0.5) * h, x + h / 2 * np.array(two), (u[j] + ahead) / 2)[0]
            four = self.work((j + 1) * h, x + h * np.array(three), ahead)[0]
            x = x + h / 6 * (np.array(one) + 2 * np.array(two) + 2 * np.array(three) + np.array(four))
        return np.array(out).T


def check_modelica(module, model, file, rate, channels, expected):
    text = open(file).read()
    try:
        import pymoca.parser
        if pymoca.parser.parse(text) is None:
            raise SystemExit("pymoca cannot read the Modelica of " + model["name"])
    except ImportError:
        pass
    try:
        flat = Flat(text)
    except NotImplementedError:
        return math.nan
    x = excitation(module, model, rate, channels, 64)
    inputs = signals(module, x, model, x.held(x.base), [name for _, name in flat.inputs])
    return within(expected, seen(x, flat.run(x.step, inputs, x.samples * x.oversampling), getattr(module, "LAWS", [])), rate)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--wbv", default="./wbv")
    options.add_argument("--only", default="")
    options.add_argument("--to", default="python,fmu,mujoco,modelica")
    given = options.parse_args()
    wbv = shlex.split(given.wbv)
    formats = given.to.split(",")
    folder = tempfile.mkdtemp()
    at = lambda name: os.path.join(folder, name)
    recording(at("recording.csv"))
    heads = {"python": ["python"], "fmu": ["fmu: laws", "fmu: sensors"], "mujoco": ["mujoco"],
             "modelica": ["modelica"]}
    columns = [head for format in formats for head in heads[format]]
    print("| model | " + " | ".join(columns) + " |")
    print("|---|" + "---|" * len(columns))
    for model in json.load(open(MODELS)):
        if not any(model["name"].startswith(each) for each in given.only.split(";")):
            continue
        json.dump(model, open(at("model.json"), "w"))
        subprocess.run(wbv + ["simulate", "--model", at("model.json"), "--input", at("recording.csv"), "--out", at("simulated.csv")], check=True,
                       stdout=subprocess.DEVNULL)
        refused = any(body.get("fixed") for body in model["bodies"])
        for format in ["python"] + [other for other in formats if other != "python" and not (refused and other == "mujoco")]:
            made = subprocess.run(wbv + ["export", at("model.json"), "--to", format, "--out", at(FILES[format])], capture_output=True, text=True)
            if made.returncode and (format == "mujoco" or "--to python can" in made.stderr):
                refused = True
            elif made.returncode:
                raise SystemExit(made.stderr)
        module = load(at("model.py"))
        rate, time, channels = module.read_recording(at("recording.csv"))
        simulated = module.read_recording(at("simulated.csv"))[2]
        expected = [simulated[name] for name in module.OUTPUTS]
        cells = [difference(expected, module.simulate(rate, channels))]
        if "fmu" in formats and refused and not os.path.exists(at("model.fmu")):
            cells += [math.nan, math.nan]
        elif "fmu" in formats:
            cells += check_fmu(module, model, at("model.fmu"), rate, channels, expected)
        if "mujoco" in formats:
            cells.append(math.nan if refused else check_mujoco(at("in_mujoco.py"), rate, channels, expected))
        if "modelica" in formats:
            cells.append(math.nan if model["bodies"][0].get("fixed") else check_modelica(module, model, at("model.mo"), rate, channels, expected))
        print("| " + model["name"] + " | " + " | ".join("" if math.isnan(cell) else "%.1e" % cell for cell in cells) + " |", flush=True)
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()
