"""Vibration of seated people from inertial sensors.

What ``./wbv`` does at a shell, as functions: every one runs the same command inside this process and hands out what it wrote, so that
numbers are those of the command line, digit by digit.

>>> import wbv
>>> ride = wbv.read("ride.csv")
>>> wbv.exposure(ride, minutes=380).a8
>>> wbv.diagnose(ride, "model.json").sentence

Needs a Java 17 or newer. Streams and learners inside CapyMOA: :mod:`wbv.capymoa`.
"""

from ._commands import diagnose, exposure, frf, identify, run, simulate, track
from ._java import DataFault, Fault, UsageError
from ._recording import Channel, Finding, Recording, from_frame, read
from ._results import Body, Diagnosis, Exposure, Identification, Mechanism, Mode, Response, Result, Tracking

__version__ = "0.1.0"

__all__ = [
    "Body",
    "Channel",
    "DataFault",
    "Diagnosis",
    "Exposure",
    "Fault",
    "Finding",
    "Identification",
    "Mechanism",
    "Mode",
    "Recording",
    "Response",
    "Result",
    "Tracking",
    "UsageError",
    "diagnose",
    "exposure",
    "frf",
    "from_frame",
    "identify",
    "read",
    "run",
    "simulate",
    "track",
]
