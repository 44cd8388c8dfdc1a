"""Recordings: channels over one uniform clock."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pandas as pd

from ._java import DataFault, faults, java

TIME = "t"
PathLike = str | os.PathLike[str]


@dataclass(frozen=True)
class Channel:
    """One measured axis at one place, named ``location.quantity.axis``, such as ``head.acc.z``."""

    name: str
    location: str
    quantity: str
    axis: str
    unit: str
    """Of every value, always SI: m/s², rad/s, …"""

    def __str__(self) -> str:
        return self.name


@dataclass(frozen=True)
class Finding:
    """Something about a recording that its user has to know."""

    severity: str
    """``NOTE``, ``WARNING`` or ``ERROR``."""
    message: str
    advice: str

    def __str__(self) -> str:
        return f"{self.severity}: {self.message}"


@dataclass(frozen=True, eq=False)
class Recording:
    """Channels over one uniform clock; samples that the file lacks are NaN. Arrays are not to be written to.

    Sample i is at ``start + i / rate``.
    """

    path: Path
    """The file that it is read from."""
    rate: float
    """Samples per second [Hz]."""
    start: float
    """Time of sample 0 [s]."""
    channels: tuple[Channel, ...]
    findings: tuple[Finding, ...]
    """What was found in the file, and what was done about it."""
    task: str | None
    """What was done while it was recorded."""
    daily_minutes: float | None
    """Minutes a day of this task."""
    notes: dict[str, str]
    """Anything else that file and sidecar say."""
    truth: dict[str, Any]
    """What a simulated recording was made from; empty where nobody knows."""
    _values: dict[str, npt.NDArray[np.float64]] = field(repr=False)
    _words: tuple[str, ...] = field(default=(), repr=False)
    _keep: object = field(default=None, repr=False)

    def __len__(self) -> int:
        return len(next(iter(self._values.values())))

    def __getitem__(self, channel: str | Channel) -> npt.NDArray[np.float64]:
        """Samples of a channel, in its unit.

        :raises DataFault: if the recording has no such channel
        """
        try:
            return self._values[str(channel)]
        except KeyError:
            raise DataFault(f"{self.path}: no channel {channel}; the recording has {', '.join(self._values)}") from None

    def __contains__(self, channel: object) -> bool:
        return str(channel) in self._values

    @property
    def duration(self) -> float:
        """Length [s]: samples over rate."""
        return len(self) / self.rate

    @property
    def time(self) -> npt.NDArray[np.float64]:
        """Time of every sample [s]."""
        times: npt.NDArray[np.float64] = self.start + np.arange(len(self)) / self.rate
        return times

    @property
    def units(self) -> dict[str, str]:
        """Unit by channel."""
        return {channel.name: channel.unit for channel in self.channels}

    def to_pandas(self) -> pd.DataFrame:
        """A column for each channel, over the time ``t`` [s] as index; ``attrs`` holds ``units`` and ``rate_hz``."""
        frame = pd.DataFrame(dict(self._values), index=pd.Index(self.time, name=TIME))
        frame.attrs.update(units=self.units, rate_hz=self.rate)
        return frame

    def to_polars(self) -> Any:
        """The same as a polars frame with a column ``t``; missing samples are null.

        :raises ImportError: if polars is not installed
        """
        import polars

        return polars.DataFrame({TIME: self.time, **self._values}).fill_nan(None)

    def write(self, path: PathLike) -> Path:
        """Writes it as ``.csv``, ``.csv.gz`` or ``.arff``, exactly, with its sidecar; the file appears whole or not at all.

        :raises DataFault: if the name ends otherwise, or the file cannot be written
        """
        vm = java()
        target = Path(path)
        with faults(str(target)):
            recording = _load(vm, self.path, self._words)[1]
            vm.JClass("wbv.recording.format.RecordingWriter").write(_path(vm, target), recording)
        return target

    def __repr__(self) -> str:
        places = ", ".join(dict.fromkeys(channel.location for channel in self.channels))
        return f"<Recording {self.path.name}: {self.duration:.1f} s at {self.rate:.2f} Hz, {len(self.channels)} channels of {places}>"


def read(path: PathLike, *, map: PathLike | None = None, rate: float | None = None,
         locations: Mapping[str, str] | None = None) -> Recording:
    """Reads a recording in any format that wbv knows, recognised by its content, and lays it on its uniform clock.

    :param map: JSON file that says which column of a foreign CSV is which channel
    :param rate: sampling rate [Hz], where the file does not state it
    :param locations: place by sensor serial, device tag or file name
    :raises DataFault: if there is no such file, or it is no recording
    """
    words: list[str] = []
    if map is not None:
        words += ["--map", os.fspath(map)]
    if rate is not None:
        words += ["--rate", repr(float(rate))]
    for sensor, place in (locations or {}).items():
        words += ["--location", f"{sensor}={place}"]
    return _recording(Path(path), tuple(words))


def from_frame(frame: Any, *, rate: float | None = None, name: str = "frame", map: PathLike | Mapping[str, Any] | None = None,
               task: str | None = None, daily_minutes: float | None = None, subject: Mapping[str, Any] | None = None,
               notes: Mapping[str, str] | None = None) -> Recording:
    """A recording from a pandas or polars frame.

    Columns are channels in SI units (``seat.acc.z`` in m/s²); others need a ``map``, as files do. The time [s] is a column ``t``, or a pandas
    index of numbers or of dates; without either the rows are taken ``1 / rate`` apart. Rows may be lost, late or doubled: they are laid on a
    uniform clock, and :attr:`Recording.findings` say what was done.

    :param frame: pandas or polars; NaN, null and NA are missing samples
    :param rate: sampling rate [Hz]
    :param name: what to call it in reports
    :param map: which column is which channel, as a JSON file or as what would stand in it
    :param task: what was done while it was recorded
    :param daily_minutes: minutes a day of it
    :param subject: ``mass_kg``, ``height_m``, ``age``, ``sex``, what is known
    :param notes: anything else, by name
    :raises DataFault: if a column is no channel, or a cell no number
    """
    polars = not isinstance(frame, pd.DataFrame) and hasattr(frame, "to_dict")
    table = pd.DataFrame(frame.to_dict(as_series=False) if polars else frame)
    times = _times(table, rate, timed=map is not None)
    folder = tempfile.TemporaryDirectory(prefix="wbv-")
    path = Path(folder.name) / f"{name}.csv"
    data = table if times is None else pd.concat([times, table.drop(columns=TIME, errors="ignore").reset_index(drop=True)], axis=1)
    data.to_csv(path, index=False)
    known = {"rate_hz": rate, "task": task, "daily_minutes": daily_minutes, "subject": subject and dict(subject), "notes": notes and dict(notes)}
    said = {key: value for key, value in known.items() if value is not None}
    if said:
        path.with_suffix(".json").write_text(json.dumps(said), encoding="utf-8")
    words: tuple[str, ...] = ()
    if map is not None:
        if isinstance(map, Mapping):
            columns = Path(folder.name) / "columns.json"
            columns.write_text(json.dumps(dict(map)), encoding="utf-8")
            map = columns
        words = ("--map", os.fspath(map))
    return _recording(path, words, keep=folder)


def _times(table: pd.DataFrame, rate: float | None, *, timed: bool) -> pd.Series[float] | None:
    """The column ``t`` [s], or None where a map names a column of times."""
    if TIME in table.columns:
        return table[TIME].reset_index(drop=True)
    index = table.index
    if isinstance(index, pd.DatetimeIndex):
        return pd.Series((index - index[0]) / pd.Timedelta(seconds=1), name=TIME)
    if timed:
        return None
    if isinstance(index, pd.RangeIndex) and index.name != TIME:
        if rate is None:
            raise DataFault(f"a frame needs a column {TIME} or an index of times [s], or its rate said; its columns are "
                            f"{', '.join(map(str, list(table.columns)[:6]))}")
        return pd.Series(np.arange(len(table)) / rate, name=TIME)
    return pd.Series(index.to_numpy(), name=TIME)


def _path(vm: Any, path: PathLike) -> Any:
    return vm.JPackage("java").nio.file.Path.of(os.fspath(path))


def _load(vm: Any, path: Path, words: tuple[str, ...]) -> tuple[Any, Any]:
    """What Java found in a file, and what it holds."""
    util, form = vm.JPackage("java").util, vm.JPackage("wbv").recording.format
    said = list(zip(words[::2], words[1::2]))
    maps = [value for name, value in said if name == "--map"]
    rates = [float(value) for name, value in said if name == "--rate"]
    if rates and not rates[0] > 0:
        raise DataFault(f"rate must be > 0 Hz: {rates[0]}")
    places = util.LinkedHashMap()
    for name, value in said:
        if name == "--location":
            places.put(*value.split("=", 1))
    columns = util.Optional.of(form.ColumnMap.read(_path(vm, maps[0]))) if maps else util.Optional.empty()
    hertz = util.OptionalDouble.of(rates[0]) if rates else util.OptionalDouble.empty()
    source = form.RecordingFile(_path(vm, path), form.ReadOptions(columns, hertz, places))
    inspection = source.inspect()
    return inspection, source.load(inspection)


def _recording(path: Path, words: tuple[str, ...] = (), keep: object = None) -> Recording:
    vm = java()
    with faults(str(path)):
        inspection, loaded = _load(vm, path, words)
    channels, values = [], {}
    for one in loaded.channels():
        channel = Channel(str(one), str(one.location()), str(one.quantity().symbol()), str(one.axis()), str(one.quantity().unit()))
        samples = np.array(loaded.values(one), dtype=np.float64)
        samples.setflags(write=False)
        channels.append(channel)
        values[channel.name] = samples
    metadata = loaded.metadata()
    minutes = metadata.dailyMinutes()
    return Recording(
        path=path,
        rate=float(loaded.clock().rate()),
        start=float(loaded.clock().start()),
        channels=tuple(channels),
        findings=tuple(Finding(str(one.severity()), str(one.message()), str(one.advice())) for one in inspection.findings()),
        task=str(metadata.task().get()) if metadata.task().isPresent() else None,
        daily_minutes=float(minutes.getAsDouble()) if minutes.isPresent() else None,
        notes={str(entry.getKey()): str(entry.getValue()) for entry in metadata.notes().entrySet()},
        truth=_truth(path),
        _values=values,
        _words=words,
        _keep=keep,
    )


def _truth(path: Path) -> dict[str, Any]:
    """What the virtual rig wrote beside a recording."""
    stem = path.name.removesuffix(".gz").rpartition(".")[0]
    beside = path.with_name(f"{stem}.truth.json")
    if not beside.is_file():
        return {}
    truth: dict[str, Any] = json.loads(beside.read_text(encoding="utf-8"))
    return truth
