"""Recordings as frames and back."""

from __future__ import annotations

import gzip
import subprocess
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import wbv


def rows(path: Path) -> dict[str, list[float]]:
    """A CSV of wbv's, read by nothing but Python itself."""
    opened = gzip.open(path, "rt", encoding="utf-8") if path.suffix == ".gz" else path.open(encoding="utf-8")
    with opened as file:
        lines = [line.rstrip("\n").split(",") for line in file if not line.startswith("#")]
    return {name: [float(line[i] or "nan") for line in lines[1:]] for i, name in enumerate(lines[0])}


@pytest.mark.parametrize("name", ["one-dof-linear.arff", "ride-subject1.arff", "concealed/003/recording.csv.gz"])
def test_samples_are_those_that_the_command_line_writes(data: Path, tmp_path: Path, name: str) -> None:
    recording = wbv.read(data / name)
    jar, _ = wbv._java.jars()
    subprocess.run(["java", "-jar", str(jar), "convert", str(data / name), "--out", str(tmp_path / "at-shell.csv")], check=True, capture_output=True)
    written = rows(tmp_path / "at-shell.csv")
    assert list(written) == ["t", *(channel.name for channel in recording.channels)]
    for channel in recording.channels:
        assert np.array_equal(recording[channel], written[channel.name], equal_nan=True)
    assert np.array_equal(recording.time, written["t"])


def test_channels_have_units(data: Path) -> None:
    ride = wbv.read(data / "ride-subject1.arff")
    assert ride.units["head.acc.z"] == "m/s²"
    assert ride.units["head.gyr.x"] == "rad/s"
    assert ride.units["seat.force.z"] == "N"
    assert ride.rate == 60 and ride.duration == 150 and len(ride) == 9000
    assert "left_shoulder lack 148 samples of 9000" in " ".join(map(str, ride.findings))
    assert ride.truth["subject_mass_kg"] > 0
    assert "61 channels" in repr(ride)


def test_a_pandas_frame_and_back(data: Path) -> None:
    ride = wbv.read(data / "ride-subject1.arff")
    frame = ride.to_pandas()
    assert frame.index.name == "t" and frame.shape == (9000, 61)
    assert frame.attrs["units"]["head.acc.z"] == "m/s²" and frame.attrs["rate_hz"] == 60
    assert int(frame["head.acc.z"].isna().sum()) == 85
    again = wbv.from_frame(frame, name="again")
    for channel in ride.channels:
        assert np.array_equal(ride[channel], again[channel], equal_nan=True)


def test_a_polars_frame_and_back(data: Path) -> None:
    pytest.importorskip("polars")
    ride = wbv.read(data / "ride-subject1.arff")
    frame = ride.to_polars()
    assert frame.columns[0] == "t" and frame.shape == (9000, 62)
    assert frame["head.acc.z"].null_count() == 85
    again = wbv.from_frame(frame)
    for channel in ride.channels:
        assert np.array_equal(ride[channel], again[channel], equal_nan=True)


def test_rows_that_are_missing_are_found() -> None:
    frame = pd.DataFrame({"t": np.arange(600) / 60, "seat.acc.z": np.sin(np.arange(600.0))}).drop(index=range(100, 110))
    recording = wbv.from_frame(frame)
    assert len(recording) == 600
    assert int(np.isnan(recording["seat.acc.z"]).sum()) == 10
    assert any("10 samples missing" in finding.message for finding in recording.findings)


def test_dates_rates_and_maps_say_the_time() -> None:
    values = np.sin(np.arange(120.0))
    dated = wbv.from_frame(pd.DataFrame({"seat.acc.z": values}, index=pd.date_range("2026-01-01", periods=120, freq="10ms")))
    assert dated.rate == pytest.approx(100)
    rated = wbv.from_frame(pd.DataFrame({"seat.acc.z": values}), rate=50, task="haul road", daily_minutes=380, notes={"made": "simulated"})
    assert rated.rate == 50 and rated.task == "haul road" and rated.daily_minutes == 380 and rated.notes == {"made": "simulated"}
    mapped = wbv.from_frame(pd.DataFrame({"ms": np.arange(120) * 10, "Az": values}), map={
        "time": {"column": "ms", "unit": "ms"}, "channels": {"seat.acc.z": {"column": "Az", "unit": "g", "scale": -1}}})
    assert mapped.rate == pytest.approx(100)
    assert np.allclose(mapped["seat.acc.z"], -9.80665 * values)


def test_writing_is_exact(data: Path, tmp_path: Path) -> None:
    ride = wbv.read(data / "one-dof-step.arff")
    assert np.array_equal(wbv.read(ride.write(tmp_path / "again.csv.gz"))["head.acc.z"], ride["head.acc.z"])
    with pytest.raises(wbv.DataFault, match=r"is written as \.csv"):
        ride.write(tmp_path / "again.xls")


def test_arrays_cannot_be_written_to(data: Path) -> None:
    with pytest.raises(ValueError, match="read-only"):
        wbv.read(data / "one-dof-step.arff")["head.acc.z"][0] = 1


@pytest.mark.parametrize(("make", "said"), [
    (lambda: wbv.read("no/such.csv"), "no/such.csv: no such file"),
    (lambda: wbv.from_frame(pd.DataFrame({"a": [1, 2]})), "a column t"),
    (lambda: wbv.from_frame(pd.DataFrame({"a": [1, 2]}), rate=60), "'a'"),
    (lambda: wbv.from_frame(pd.DataFrame({"t": [0, 0.1, 0.2], "seat.acc.z": [1, "x", 3]})), "column seat.acc.z must be a finite number"),
    (lambda: wbv.read(__file__), "test_recording.py:1: "),
])
def test_faults_are_one_line(make, said) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(wbv.DataFault) as caught:
        make()
    assert said in str(caught.value)
    assert "\n" not in str(caught.value) and not str(caught.value).startswith("wbv:")


def test_a_channel_that_is_not_there(data: Path) -> None:
    with pytest.raises(wbv.DataFault, match="no channel knee.acc.z; the recording has"):
        wbv.read(data / "one-dof-step.arff")["knee.acc.z"]
