"""What the functions find beside what the command line writes, in a Java of its own, digit by digit."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import wbv

Shell = Callable[..., Path]


def found(path: Path) -> Any:
    results = json.loads(path.read_text(encoding="utf-8"))
    results.pop("provenance", None)
    return results


def same(result: wbv.Result, folder: Path, *files: str) -> None:
    """The same results, and the same bytes but for comments, which name other files."""
    for name in files:
        if name.endswith(".json"):
            assert found(result.folder / name) == found(folder / name), name
        else:
            ours, theirs = ([line for line in (place / name).read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
                            for place in (result.folder, folder))
            assert ours == theirs, name


def test_exposure(data: Path, shell: Shell) -> None:
    day = wbv.exposure(wbv.read(data / "ride-subject1.arff"), minutes=380, tasks="haul road", boxcar=True)
    same(day, shell("exposure", data / "ride-subject1.arff", "--task", "haul road=380", "--boxcar"), "exposure.json", "exposure.csv")
    assert day.results["provenance"]["command"].startswith("wbv exposure ")
    assert f"A(8) is {day.a8:.2f} m/s² along {day.a8_axis}: {day.verdict} ({day.points:.0f} points)" in day.summary
    assert f"daily dose is {day.vdv:.1f}" in day.summary
    assert day.lower_bound and day.minutes_until_action < 380 < day.minutes_until_limit
    assert list(day.tasks["axis"]) == ["x", "y", "z"] and set(day.tasks["task"]) == {"haul road"}
    assert day.tasks["a8_m_s2"].max() == day.a8
    assert day.report is not None and day.report.read_text(encoding="utf-8").startswith("<!")


def test_exposure_of_several_tasks(data: Path, shell: Shell) -> None:
    ride, body = data / "ride-subject1.arff", data / "states-other.arff"
    day = wbv.exposure(wbv.read(ride), body, minutes=[240, 100], tasks=["loaded", "empty"])
    same(day, shell("exposure", ride, body, "--task", "loaded=240", "--task", "empty=100"), "exposure.json", "exposure.csv")
    assert [task["name"] for task in day.results["tasks"]] == ["loaded", "empty"]


def test_track(data: Path, shell: Shell) -> None:
    followed = wbv.track(data / "one-dof-step.arff", estimator=["ekf", "fused"])
    same(followed, shell("track", data / "one-dof-step.arff", "--estimator", "ekf,fused"), "results.json", "tracks.csv")
    assert followed.tracks.shape[0] == 7200 and followed.tracks.index.name == "t"
    mode = followed.at_end["head.acc.z", "fused"][0]
    assert mode.frequency == pytest.approx(followed.tracks["head.acc.z.fused.frequency_Hz"].iloc[-1], rel=1e-4)  # the table is rounded
    assert followed.bodies["head.acc.z"].modes[0].frequency == pytest.approx(4.78, abs=0.2)
    assert len(followed.changes["head.acc.z", "fused"]) == 1


def test_tables_are_read_exactly(data: Path) -> None:
    followed = wbv.track(data / "one-dof-step.arff", estimator="ekf")
    lines = [line.split(",") for line in (followed.folder / "tracks.csv").read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    column = lines[0].index("head.acc.z.ekf.prediction_m_s2")
    assert followed.tracks["head.acc.z.ekf.prediction_m_s2"].tolist() == [float(line[column]) for line in lines[1:]]


def test_frf(data: Path, shell: Shell) -> None:
    answer = wbv.frf(data / "two-dof.arff", output="head.acc.z", model="wei-griffin-1998-1dof")
    same(answer, shell("frf", data / "two-dof.arff", "--output", "head.acc.z", "--model", "wei-griffin-1998-1dof"), "frf.json", "frf.csv")
    curves = answer.between("platform.acc.z", "head.acc.z")
    frequency, modulus = answer.peak("platform.acc.z", "head.acc.z") or (0, 0)
    assert 5 < frequency < 6 and modulus == pytest.approx(curves["h1"].max(), rel=0.02)
    with pytest.raises(KeyError):
        answer.between("platform.acc.z", "knee.acc.z")


def test_identify(data: Path, shell: Shell) -> None:
    body = wbv.identify(data / "two-dof.arff", input="platform.acc.z", output="head.acc.z", poles=4)
    same(body, shell("identify", data / "two-dof.arff", "--input", "platform.acc.z", "--output", "head.acc.z", "--poles", "4"), "identification.json")
    assert [round(mode.frequency, 1) for mode in body.instruments] == [5.9, 14.3]
    assert len(body.armax) == 2


def test_diagnose_and_simulate(data: Path, shell: Shell) -> None:
    case = data / "concealed" / "003"
    model = json.loads((case / "model.json").read_text(encoding="utf-8"))
    answer = wbv.diagnose(wbv.read(case / "recording.csv.gz"), model)
    same(answer, shell("diagnose", case / "recording.csv.gz", "--model", case / "model.json"), "diagnosis.json", "model.json", "prediction.csv", "force.csv")
    assert answer.verdict == "missing-physics" and "softens" in answer.sentence
    found = answer.missing[0]
    low, high = found.intervals["knee_m"]
    assert found.name == "stiffness.softening" and low < found.parameters["knee_m"] < high
    assert answer.errors.loc["head.acc.z", "after"] < 0.05 < answer.errors.loc["head.acc.z", "before"]
    assert answer.force is not None and answer.force.columns.tolist() == ["platform-pelvis"]
    again = wbv.simulate(model=answer.model, input=case / "recording.csv.gz").to_pandas()
    foretold = answer.prediction["head.acc.z model"]
    assert (again["head.acc.z"].reindex(foretold.index) - foretold).abs().max() < 1e-9


def test_simulate_is_the_rig(data: Path, shell: Shell, tmp_path: Path) -> None:
    rig = wbv.simulate(sitter="one-dof", zeta=0.35, f0=5, seconds=20, seed=3)
    wbv.run("simulate", "sitter=one-dof", "zeta=0.35", "f0=5", "seconds=20", "seed=3", "--out", tmp_path / "rig.csv")
    assert rig.to_pandas().equals(wbv.read(tmp_path / "rig.csv").to_pandas())
    assert rig.truth["at_start"]["zeta"] == 0.35
    assert wbv.simulate(out=tmp_path / "rig.arff", channels=["platform.acc.z", "head.acc.z"], seconds=5).path == tmp_path / "rig.arff"


def test_out_names_the_folder(data: Path, tmp_path: Path) -> None:
    body = wbv.identify(data / "one-dof-linear.arff", input="platform.acc.z", output="head.acc.z", poles=2, out=tmp_path / "here")
    assert (tmp_path / "here" / "identification.json").is_file() and body.folder == tmp_path / "here"
    assert body.report is None


@pytest.mark.parametrize(("make", "kind", "said"), [
    (lambda data: wbv.exposure(data / "nothing.csv"), wbv.DataFault, "nothing.csv: no such file"),
    (lambda data: wbv.track(data / "one-dof-step.arff", estimator="guess"), wbv.UsageError, "--estimator must be one of ekf"),
    (lambda data: wbv.exposure(data / "one-dof-step.arff", minutes=[1, 2]), wbv.UsageError, "--task must be given once for each recording"),
    (lambda data: wbv.diagnose(data / "one-dof-step.arff", {"name": "none"}), wbv.DataFault, "model.json: "),
    (lambda data: wbv.run("nonsense"), wbv.UsageError, "nonsense"),
])
def test_faults_are_one_line(data: Path, make: Any, kind: type[Exception], said: str) -> None:
    with pytest.raises(kind) as caught:
        make(data)
    assert said in str(caught.value) and "\n" not in str(caught.value)


def test_run_prints() -> None:
    assert wbv.run("--version") == "wbv " + wbv.__version__ + "\n"
    assert "coermann-1962-1dof" in wbv.run("simulate", "--models")
