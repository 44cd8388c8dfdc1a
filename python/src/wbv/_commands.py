"""The commands as functions. Every option has the command's meaning and its default; ``wbv COMMAND --help`` says them all."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

from ._java import command
from ._recording import PathLike, Recording, _recording
from ._results import Diagnosis, Exposure, Identification, Response, Result, Tracking

Recorded = Recording | str | os.PathLike[str]
Model = str | os.PathLike[str] | Mapping[str, Any]
Names = str | Sequence[str]
R = TypeVar("R", bound=Result)


def run(*words: str | os.PathLike[str]) -> str:
    """Runs any command line of wbv, such as ``run("convert", "ride.mvnx", "--out", "ride.csv")``, and returns what it printed.

    :raises DataFault: if the data or the model is at fault
    :raises UsageError: if an argument is wrong
    """
    return command([os.fspath(word) for word in words])


def exposure(*recordings: Recorded, minutes: float | Sequence[float] | None = None, tasks: Names | None = None, seat: str | None = None,
             base: str | None = None, boxcar: bool = False, out: PathLike | None = None) -> Exposure:
    """A day's exposure to whole-body vibration; every recording is one task of the day.

    :param minutes: daily minutes of each task; by default what the recording's sidecar says, or 8 h
    :param tasks: name of each task
    :param seat: place where the vibration enters the sitter
    :param base: place below the seat, for its SEAT value
    :param boxcar: samples are means over the sampling period (Xsens MTw, DOT): undo their droop
    :param out: folder for the files
    """
    names = [tasks] if isinstance(tasks, str) else list(tasks or [])
    times = [minutes] if isinstance(minutes, (int, float)) else list(minutes or [])
    words = [*_recordings(recordings), *_options(seat=seat, base=base, boxcar=boxcar)]
    if names or times:
        read = [one if isinstance(one, Recording) else _recording(Path(one)) for one in recordings]
        names = names or [one.task or one.path.name for one in read]
        times = times or [480.0 if one.daily_minutes is None else one.daily_minutes for one in read]
        for i in range(max(len(names), len(times))):  # a wrong number of them is the command's to tell
            words += ["--task", f"{names[min(i, len(names) - 1)]}={float(times[min(i, len(times) - 1)])!r}"]
    return _result(Exposure, "exposure", words, "exposure.json", out)


def track(recording: Recorded, *, estimator: Names = "fused", input: str | None = None, output: Names | None = None,
          cross: Names | None = None, degrees: int = 1, start_frequency: float = 5.0, start_damping: float = 0.4, noise: float | None = None,
          particles: int = 1000, seed: int = 1, bound: Mapping[str, tuple[float, float]] | None = None, detector: str | None = None,
          out: PathLike | None = None) -> Tracking:
    """Follows natural frequency and damping ratio through a recording.

    :param estimator: ``ekf``, ``ekf-adwin``, ``ukf``, ``particle``, ``constrained``, ``fused``, several of them, or ``all``
    :param input: exciting channel
    :param output: answering channels
    :param cross: other motions of the base that move the body too
    :param degrees: degrees of freedom of the body, 1 or 2
    :param start_frequency: natural frequency to start from [Hz]
    :param start_damping: damping ratio to start from
    :param noise: noise density of the sensors, m/s²/√Hz or rad/s/√Hz
    :param bound: bounds for the constrained estimator, such as ``{"frequency": (3, 8)}``
    :param detector: any of MOA's change detectors, such as ``"PageHinkleyDM -l 20"``, or ``"none"``
    :param out: folder for the files
    """
    bounds = [f"{name}={low!r}:{high!r}" for name, (low, high) in (bound or {}).items()]
    return _result(Tracking, "track", [*_recordings([recording]), *_options(
        estimator=estimator, input=input, output=output, cross=cross, degrees=degrees, start_frequency=float(start_frequency),
        start_damping=float(start_damping), noise=noise, particles=particles, seed=seed, bound=bounds, detector=detector)], "results.json", out)


def frf(recording: Recorded, *, input: Names | None = None, output: Names | None = None, also: Sequence[PathLike] = (),
        model: Model | None = None, plate: float | None = None, segment: float | None = None, level: float = 0.95,
        skin: Mapping[str, tuple[float, float]] | None = None, wavelet: bool = False, out: PathLike | None = None) -> Response:
    """Frequency responses from one or several inputs that act at once, by H1, H2 and Hv.

    :param input: exciting channels
    :param output: answering channels
    :param also: recordings of further people with the same channels
    :param model: to draw over the responses: a file, the name of a published one, or the JSON itself
    :param plate: mass between load cell and sitter, taken off apparent masses [kg]
    :param segment: length of a segment [s]
    :param level: confidence of the bands
    :param skin: natural frequency [Hz] and damping ratio of the skin under a place's sensor
    :param wavelet: follow the response through time, too
    :param out: folder for the files
    """
    with tempfile.TemporaryDirectory(prefix="wbv-") as room:
        words = [*_recordings([recording]), *_options(input=input, output=output, plate=plate, segment=segment, level=level, wavelet=wavelet)]
        for other in also:
            words += ["--also", os.fspath(other)]
        for place, (hertz, ratio) in (skin or {}).items():
            words += ["--skin", f"{place}={hertz!r}:{ratio!r}"]
        if model is not None:
            words += ["--model", _model(model, room)]
        return _result(Response, "frf", words, "frf.json", out)


def identify(recording: Recorded, *, input: Names, output: str, poles: int | Sequence[int] = (), out: PathLike | None = None) -> Identification:
    """Linear models from inputs to an output: ARMAX by prediction error, and a model in continuous time by refined instruments.

    :param input: exciting channels
    :param output: answering channel
    :param poles: numbers of poles to choose among, 2 to 20
    :param out: folder for the files
    """
    numbers = [poles] if isinstance(poles, int) else list(poles)
    words = [*_recordings([recording]), *_options(input=input, output=output, poles=[str(n) for n in numbers])]
    return _result(Identification, "identify", words, "identification.json", out)


def diagnose(recording: Recorded, model: Model | None = None, *, simulation: Recorded | None = None, also: Sequence[Recorded] = (),
             prove: Recorded | None = None, noise: float | None = None, input: str | None = None, out: PathLike | None = None) -> Diagnosis:
    """Says where a model and a recording differ, which physics was left out, and completes the model.

    :param model: a file, the name of a published model, or the JSON itself
    :param simulation: without a model: a CSV of a simulation's outputs, or an FMU; beside a model: the channel that holds them
    :param also: further recordings of the same subject and sensors, fitted together with the first
    :param prove: recording that takes no part in the fit and proves it
    :param noise: standard deviation of a sample of the outputs, where it is known
    :param input: without a model: the channel that drove the simulation
    :param out: folder for the files
    """
    with tempfile.TemporaryDirectory(prefix="wbv-") as room:
        words = [*_recordings([recording]), *_options(noise=noise, input=input)]
        if model is not None:
            words += ["--model", _model(model, room)]
        if simulation is not None:
            words += ["--simulation", str(_file(simulation))]
        for other in also:
            words += ["--with", str(_file(other))]
        if prove is not None:
            words += ["--prove", str(_file(prove))]
        return _result(Diagnosis, "diagnose", words, "diagnosis.json", out)


def simulate(*, model: Model | None = None, input: Recorded | None = None, fmu: PathLike | None = None, out: PathLike | None = None,
             **words: Any) -> Recording:
    """Plays an experiment of the virtual rig, or runs a model or an FMU on a recording's input.

    An experiment is told by its words, each with a default: ``simulate(subject="random:7", posture="slouched", seconds=60)``;
    ``wbv.run("simulate", "--help")`` lists them. Its truth is :attr:`Recording.truth`. The same words give the same samples.

    :param model: a file, the name of a published model, or the JSON itself
    :param input: recording whose input the model or the FMU is run on
    :param fmu: a functional mock-up unit (FMI 2.0 or 3.0)
    :param out: name of the recording, ending in ``.csv``, ``.csv.gz`` or ``.arff``
    """
    room = tempfile.TemporaryDirectory(prefix="wbv-")
    target = Path(room.name) / "simulated.csv" if out is None else Path(out)
    line = [f"{name}={','.join(map(str, value)) if isinstance(value, (list, tuple)) else value}" for name, value in words.items()]
    if model is not None:
        line += ["--model", _model(model, room.name)]
    if fmu is not None:
        line += ["--fmu", os.fspath(fmu)]
    if input is not None:
        recorded = _recordings([input])
        line += ["--input", recorded[0], *recorded[1:]]
    command(["simulate", *line, "--out", str(target)])
    return _recording(target, keep=room if out is None else None)


def _file(recorded: Recorded) -> Path | str:
    return recorded.path if isinstance(recorded, Recording) else os.fspath(recorded)


def _recordings(recorded: Sequence[Recorded]) -> list[str]:
    """Files, and behind them the options with which the first was read."""
    said = [word for one in recorded[:1] if isinstance(one, Recording) for word in one._words]
    return [*(str(_file(one)) for one in recorded), *said]


def _options(**options: Any) -> list[str]:
    """Options as words; what is None, empty or False is not said."""
    words = []
    for name, value in options.items():
        if value is None or value is False or (isinstance(value, (list, tuple)) and not value):
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            words.append(",".join(value) if isinstance(value, (list, tuple)) else str(value))
    return words


def _model(model: Model, room: str) -> str:
    if not isinstance(model, Mapping):
        return os.fspath(model)
    file = Path(room) / "model.json"
    file.write_text(json.dumps(dict(model), ensure_ascii=False), encoding="utf-8")
    return str(file)


def _result(kind: type[R], name: str, words: list[str], results: str, out: PathLike | None) -> R:
    room = tempfile.TemporaryDirectory(prefix="wbv-") if out is None else None
    folder = Path(room.name) / "out" if room is not None else Path(os.fspath(out or ""))
    printed = command([name, *words, "--out", str(folder)])
    summary = "\n".join(line for line in printed.splitlines() if not line.startswith("Wrote "))
    return kind(summary, folder, json.loads((folder / results).read_text(encoding="utf-8")), room)
