"""wbv's streams, learners and detectors inside CapyMOA.

``pip install 'wbv[capymoa]'``; import wbv before CapyMOA, so that Java is started with both.

>>> import wbv.capymoa
>>> from capymoa.evaluation import prequential_evaluation
>>> stream = wbv.capymoa.stream("ride.csv", input="platform.acc.z", output="head.acc.z")
>>> learner = wbv.capymoa.AdwinKalman(stream.get_schema())
>>> prequential_evaluation(stream, learner, max_instances=7200).cumulative.r2()
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

from ._java import faults, java
from ._recording import PathLike, Recording
from ._results import Mode

_vm = java()

from capymoa.base import MOARegressor  # noqa: E402  (Java runs, with CapyMOA's MOA on its path)
from capymoa.drift.base_detector import MOADriftDetector  # noqa: E402
from capymoa.stream import MOAStream, Schema  # noqa: E402

__all__ = ["AdwinKalman", "BodyLearner", "BodyTracker", "RecursiveArmax", "TwoSidedAdwin", "rig", "stream"]


def stream(recording: Recording | PathLike, *, input: str | Sequence[str] = "platform.acc.z", output: str = "head.acc.z",
           lost: str = "missing", map: PathLike | None = None) -> MOAStream[Any]:
    """A recording as a stream: attributes are the time ``t`` [s] and the inputs, the target is the output.

    :param lost: what becomes of samples that sensors lost: ``"missing"`` values, as learners of wbv take them, or ``"skipped"`` instances, for
        learners that take no missing values, as most of CapyMOA's
    :param map: JSON file that says which column of a foreign CSV is which channel
    :raises DataFault: if the recording lacks a channel
    """
    moa = _vm.JClass("wbv.stream.RecordingStream")()
    if isinstance(recording, Recording):
        map = dict(zip(recording._words[::2], recording._words[1::2])).get("--map", map)
        recording = recording.path
    moa.fileOption.setValue(os.fspath(recording))
    if map is not None:
        moa.mapOption.setValue(os.fspath(map))
    return _prepared(moa, os.fspath(recording), input, output, lost)


def rig(experiment: str = "sitter=one-dof", *, seed: int = 0, input: str | Sequence[str] = "platform.acc.z", output: str = "head.acc.z",
        lost: str = "missing") -> MOAStream[Any]:
    """A simulated experiment as a stream. ``experiment``: its words, as :func:`wbv.simulate` takes them."""
    moa = _vm.JClass("wbv.stream.RigStream")()
    moa.experimentOption.setValue(experiment)
    moa.seedOption.setValue(seed)
    return _prepared(moa, "experiment", input, output, lost)


def _prepared(moa: Any, name: str, input: str | Sequence[str], output: str, lost: str) -> MOAStream[Any]:
    moa.inputOption.setValue(input if isinstance(input, str) else ",".join(input))
    moa.outputOption.setValue(output)
    moa.lostOption.setChosenLabel(lost)
    with faults(name):
        moa.prepareForUse()
    return MOAStream(moa_stream=moa)


class BodyLearner(MOARegressor):  # type: ignore[misc]
    """A learner of wbv that knows the body's natural frequency and damping."""

    _java_name: str

    def __init__(self, schema: Schema, cli: str = "") -> None:
        """:param cli: options as MOA writes them, such as ``-f 4 -a (ADWINChangeDetector -a 0.01)``"""
        super().__init__(schema=schema, CLI=cli, random_seed=None, moa_learner=_vm.JClass(self._java_name)())

    @property
    def mode(self) -> Mode:
        """What it knows after the last instance."""
        track = self.moa_learner.track()
        return Mode(*(float(value) for value in (track.frequency(0), track.frequencyDeviation(0), track.damping(0), track.dampingDeviation(0))))


class AdwinKalman(BodyLearner):
    """A bank of extended Kalman filters with a change detector listening. Options: ``-i -f -d -r -n -w -a``."""

    _java_name = "wbv.learn.AdwinKalman"


class BodyTracker(BodyLearner):
    """Any of wbv's estimators by its name: ``-m ekf``, ``ukf``, ``particle``, …"""

    _java_name = "wbv.learn.BodyTracker"


class RecursiveArmax(MOARegressor):  # type: ignore[misc]
    """ARMAX sample by sample, predictions one step ahead."""

    def __init__(self, schema: Schema, cli: str = "") -> None:
        super().__init__(schema=schema, CLI=cli, random_seed=None, moa_learner=_vm.JClass("wbv.learn.RecursiveArmaxLearner")())


class TwoSidedAdwin(MOADriftDetector):  # type: ignore[misc]
    """wbv's own ADWIN, for values between 0 and 1: it hears a fall of the mean as well as a rise."""

    def __init__(self, delta: float = 0.002) -> None:
        """:param delta: probability of a false cut at one look"""
        super().__init__(cli=f"-d {delta}", moa_detector_type=_vm.JClass("wbv.learn.TwoSidedAdwin"))
