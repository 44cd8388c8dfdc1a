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

from ._java import java
from ._recording import PathLike, Recording
from ._results import Mode

_vm = java()

from capymoa.base import MOARegressor  # noqa: E402  (Java runs, with CapyMOA's MOA on its path)
from capymoa.core import Schema  # noqa: E402
from capymoa.stream import MOAStream  # noqa: E402

__all__ = ["AdwinKalman", "BodyLearner", "BodyTracker", "RecursiveArmax", "RigStream", "stream"]


def stream(recording: Recording | PathLike, *, input: str | Sequence[str] = "platform.acc.z", output: str = "head.acc.z",
           map: PathLike | None = None) -> MOAStream[Any]:
    """A recording as a stream: attributes are the time ``t`` [s] and the inputs, the target is the output; lost samples are missing values.

    :raises DataFault: if the recording lacks a channel
    """
    moa = _vm.JClass("wbv.stream.RecordingStream")()
    moa.fileOption.setValue(str(recording.path) if isinstance(recording, Recording) else os.fspath(recording))
    moa.inputOption.setValue(input if isinstance(input, str) else ",".join(input))
    moa.outputOption.setValue(output)
    if isinstance(recording, Recording) and recording._words[:1] == ("--map",):
        map = recording._words[1]
    if map is not None:
        moa.mapOption.setValue(os.fspath(map))
    return _prepared(moa)


def RigStream(cli: str = "") -> MOAStream[Any]:
    """The virtual rig as a stream without an end. ``cli``: options as ``wbv task`` takes them, such as ``-r 7``."""
    moa = _vm.JClass("wbv.stream.RigStream")()
    moa.getOptions().setViaCLIString(cli)
    return _prepared(moa)


def _prepared(moa: Any) -> MOAStream[Any]:
    from ._java import faults

    with faults("stream"):
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
