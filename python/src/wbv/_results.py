"""What the commands find: the JSON that they write, its usual figures by name, its tables as frames."""

from __future__ import annotations

import functools
import json
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pandas as pd


def number(value: float | None) -> float:
    """JSON has no NaN."""
    return math.nan if value is None else float(value)


@dataclass(frozen=True, eq=False, repr=False)
class Result:
    """What a command wrote and printed."""

    summary: str
    """What the command line prints."""
    folder: Path
    """Where its files lie; a temporary folder, which goes with this object, unless ``out`` named one."""
    results: dict[str, Any] = field(repr=False)
    """Everything that it found, as its JSON file holds it."""
    _keep: object = field(default=None, repr=False)

    @property
    def provenance(self) -> dict[str, str]:
        """Command, version, SHA-256 of the inputs."""
        said: dict[str, str] = self.results["provenance"]
        return said

    @property
    def report(self) -> Path | None:
        """The page with the pictures; it opens in any browser."""
        page = self.folder / "report.html"
        return page if page.is_file() else None

    def table(self, name: str) -> pd.DataFrame:
        """A CSV file among the results, such as ``tracks.csv``, every double exactly."""
        exact: dict[str, Any] = {} if int(pd.__version__.split(".")[0]) >= 3 else {"float_precision": "round_trip"}  # as pandas 3 reads by itself
        frame: pd.DataFrame = pd.read_csv(self.folder / name, comment="#", **exact)
        return frame

    def __repr__(self) -> str:
        return self.summary

    def _repr_html_(self) -> str:
        import html

        return f"<pre>{html.escape(self.summary)}</pre>"


@dataclass(frozen=True)
class Mode:
    """One mode of a body, each value with its standard deviation."""

    frequency: float
    """Natural frequency [Hz]."""
    frequency_sd: float
    damping: float
    """Damping ratio."""
    damping_sd: float

    @staticmethod
    def of(json: dict[str, Any]) -> Mode:
        return Mode(*(number(json[key]) for key in
                      ("natural_frequency_hz", "natural_frequency_sd_hz", "damping_ratio", "damping_ratio_sd")))


@dataclass(frozen=True)
class Body:
    """The linear body that would move most like a place."""

    modes: tuple[Mode, ...]
    explained: float
    """Share of the output's variance that it explains, with the other motions of the base that were recorded."""
    no_number: str
    """Why there is no mode; empty where there is one."""


@dataclass(frozen=True, eq=False, repr=False)
class Exposure(Result):
    """A day's exposure against Directive 2002/44/EC."""

    @property
    def a8(self) -> float:
        """A(8) along the worst axis [m/s²]."""
        return float(self.results["day"]["a8_m_s2"])

    @property
    def a8_axis(self) -> str:
        return str(self.results["day"]["a8_axis"])

    @property
    def vdv(self) -> float:
        """Daily dose along its worst axis [m/s^1.75]."""
        return float(self.results["day"]["vdv_m_s1_75"])

    @property
    def points(self) -> float:
        """The HSE's points."""
        return float(self.results["day"]["points"])

    @property
    def verdict(self) -> str:
        """By A(8): below the action value, above it, or above the limit value."""
        return str(self.results["day"]["verdict"])

    @property
    def lower_bound(self) -> bool:
        """Whether a sampling rate was too low for the whole band."""
        return bool(self.results["day"]["lower_bound"])

    @property
    def minutes_until_action(self) -> float:
        """Minutes of such a day until A(8) reaches the action value."""
        return number(self.results["day"]["minutes_until_action_a8"])

    @property
    def minutes_until_limit(self) -> float:
        """Minutes of such a day until A(8) reaches the limit value."""
        return number(self.results["day"]["minutes_until_limit_a8"])

    @functools.cached_property
    def tasks(self) -> pd.DataFrame:
        """One row for each task and axis (``exposure.csv``); units stand in the names."""
        table = self.table("exposure.csv")
        return table[table["measured_s"].notna()]  # the others are sums of the day


@dataclass(frozen=True, eq=False, repr=False)
class Tracking(Result):
    """Natural frequency and damping ratio over time."""

    @property
    def bodies(self) -> dict[str, Body]:
        """The equivalent body over the whole recording, by output."""
        return {name: Body(tuple(map(Mode.of, body["modes"])), number(body["explained_with"]), str(body["no_number"]))
                for name, body in self.results["bodies"].items()}

    @functools.cached_property
    def tracks(self) -> pd.DataFrame:
        """What every estimator knew after each sample (``tracks.csv``); columns are ``output.estimator.quantity``, units in the names."""
        return self.table("tracks.csv").set_index("t")

    @property
    def at_end(self) -> dict[tuple[str, str], tuple[Mode, ...]]:
        """The modes after the last sample, by output and estimator."""
        return {(one["output"], one["estimator"]): tuple(map(Mode.of, one["modes"])) for one in self.results["tracks"]}

    @property
    def changes(self) -> dict[tuple[str, str], list[float]]:
        """Times at which a change was heard [s], by output and estimator."""
        return {(one["output"], one["estimator"]): list(one["changes_s"]) for one in self.results["tracks"]}


@dataclass(frozen=True, eq=False, repr=False)
class Response(Result):
    """Frequency responses, with coherences and confidence."""

    @functools.cached_property
    def curves(self) -> pd.DataFrame:
        """One row for each output, input and frequency (``frf.csv``); units stand in the names."""
        return self.table("frf.csv")

    def between(self, input: str, output: str) -> pd.DataFrame:
        """The curves of one path over the frequency [Hz].

        :raises KeyError: if there is no such path
        """
        path = self.curves[(self.curves["input"] == input) & (self.curves["output"] == output)]
        if path.empty:
            raise KeyError(f"no response from {input} to {output}")
        return path.set_index("frequency_Hz")

    def peak(self, input: str, output: str) -> tuple[float, float] | None:
        """Frequency [Hz] and modulus of the peak, or of the highest value; None where nothing is usable.

        :raises KeyError: if there is no such path
        """
        for one in self.results["responses"]:
            if one["input"] == input and one["output"] == output:
                peak = one["peak"]
                return None if peak is None else (number(peak["frequency_hz"]), number(peak["modulus"]))
        raise KeyError(f"no response from {input} to {output}")


@dataclass(frozen=True, eq=False, repr=False)
class Identification(Result):
    """Linear models of a path, with their poles."""

    @property
    def armax(self) -> tuple[Mode, ...]:
        """Modes of the ARMAX model, by prediction error."""
        return tuple(map(Mode.of, (self.results["armax"] or {}).get("modes", [])))

    @property
    def instruments(self) -> tuple[Mode, ...]:
        """Modes of the model in continuous time, by refined instruments."""
        return tuple(map(Mode.of, (self.results["instruments"] or {}).get("modes", [])))


@dataclass(frozen=True)
class Mechanism:
    """One mechanism that may be missing, at one place."""

    name: str
    """Word of the library, such as ``stiffness.softening``."""
    where: str
    probability: float
    parameters: dict[str, float]
    """Its sizes; units stand in the names."""
    intervals: dict[str, tuple[float, float]]
    """Where each lies with 95 %; NaN on a side that the recording does not bound."""
    form: dict[str, str] = field(default_factory=dict)
    """What no number tells, such as the ``side`` of a stop."""


@dataclass(frozen=True, eq=False, repr=False)
class Diagnosis(Result):
    """Which physics a model left out."""

    @property
    def verdict(self) -> str:
        """``missing-physics``, ``nothing-missing``, ``parameters-only``, ``learned-law``, … (docs/proof.md)."""
        return str(self.results["verdict"])

    @property
    def sentence(self) -> str:
        return str(self.results["sentence"])

    @property
    def missing(self) -> tuple[Mechanism, ...]:
        """What is missing; empty where nothing is, or where it has no name."""
        return tuple(map(_mechanism, self.results["missing"]))

    @property
    def alternatives(self) -> tuple[Mechanism, ...]:
        """What else was tried, the likeliest first."""
        return tuple(map(_mechanism, self.results["alternatives"]))

    @property
    def errors(self) -> pd.DataFrame:
        """Held-out error of every channel, as a share of what it recorded: with the model ``before``, ``after``, and what is ``noise``."""
        fit = self.results["fit"]
        return pd.DataFrame({"before": fit["heldout_nrmse_before"], "after": fit["heldout_nrmse_after"], "noise": fit["noise_floor_nrmse"]})

    @functools.cached_property
    def model(self) -> dict[str, Any]:
        """The completed model, which :func:`wbv.simulate` runs."""
        model: dict[str, Any] = json.loads((self.folder / "model.json").read_text(encoding="utf-8"))
        return model

    @functools.cached_property
    def prediction(self) -> pd.DataFrame:
        """What every sensor recorded and what it should have, on data that were not used, over the time ``t`` [s]."""
        return self.table("prediction.csv").set_index("t")

    @functools.cached_property
    def force(self) -> pd.DataFrame | None:
        """What the laws found do in their links [N], over the time ``t`` [s]; None where no law was found."""
        return self.table("force.csv").set_index("t") if (self.folder / "force.csv").is_file() else None


def _mechanism(one: dict[str, Any]) -> Mechanism:
    return Mechanism(one["mechanism"], one["where"], number(one["probability"]),
                     {key: number(value) for key, value in one["parameters"].items()},
                     {key: (number(value["low"]), number(value["high"])) for key, value in one["intervals"].items()},
                     dict(one.get("form", {})))
