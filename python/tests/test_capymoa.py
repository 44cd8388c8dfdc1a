"""Streams, learners and detectors inside CapyMOA."""

from __future__ import annotations

from pathlib import Path

import pytest

import wbv

pytest.importorskip("capymoa", reason="CapyMOA is not installed")

import wbv.capymoa  # noqa: E402
from capymoa.drift.detectors import ADWIN  # noqa: E402
from capymoa.evaluation import prequential_evaluation  # noqa: E402
from capymoa.regressor import FIMTDD, AdaptiveRandomForestRegressor  # noqa: E402


def test_a_learner_runs_on_a_stream(data: Path) -> None:
    recording = wbv.read(data / "one-dof-linear.arff")
    stream = wbv.capymoa.stream(recording)
    assert stream.get_schema().get_num_attributes() == 2
    learner = wbv.capymoa.AdwinKalman(stream.get_schema())
    results = prequential_evaluation(stream, learner, max_instances=7200)
    assert results.cumulative.r2() > 0.999
    assert learner.mode.frequency == pytest.approx(5, abs=0.05)


def test_it_knows_what_the_command_line_knows(data: Path) -> None:
    stream = wbv.capymoa.stream(data / "one-dof-step.arff")
    learner = wbv.capymoa.BodyTracker(stream.get_schema(), "-m ekf")
    while stream.has_more_instances():
        learner.train(stream.next_instance())
    assert learner.mode == wbv.track(data / "one-dof-step.arff", estimator="ekf").at_end["head.acc.z", "ekf"][0]


def test_options_are_moas(data: Path) -> None:
    stream = wbv.capymoa.stream(data / "one-dof-linear.arff")
    learner = wbv.capymoa.AdwinKalman(stream.get_schema(), "-f 4 -a (PageHinkleyDM -l 20)")
    assert learner.moa_learner.frequencyOption.getValue() == 4
    assert "PageHinkleyDM" in str(learner.moa_learner.detectorOption.getValueAsCLIString())


def test_learners_of_capymoa_run_on_a_ride_with_losses(data: Path) -> None:
    for kind in (FIMTDD, AdaptiveRandomForestRegressor):
        stream = wbv.capymoa.stream(data / "ride-subject1.arff", lost="skipped")
        results = prequential_evaluation(stream, kind(stream.get_schema()), max_instances=2000)
        assert results.cumulative.rmse() < 5


def test_the_rig_is_a_stream() -> None:
    stream = wbv.capymoa.rig("sitter=one-dof f0=4.5 zeta=0.3 seconds=30", seed=9)
    results = prequential_evaluation(stream, wbv.capymoa.RecursiveArmax(stream.get_schema()), max_instances=1800)
    assert results.cumulative.r2() > 0.9


def test_the_detector_hears_a_fall(data: Path) -> None:
    ours, theirs = wbv.capymoa.TwoSidedAdwin(delta=0.002), ADWIN(delta=0.002)
    for i in range(4000):
        value = (0.7 if i < 2000 else 0.3) + (i * 7919 % 101 - 50) / 500
        ours.add_element(value)
        theirs.add_element(value)
    assert ours.detection_index and 2000 < ours.detection_index[0] < 2100
    assert not theirs.detection_index


def test_faults_of_the_data_are_one_line(data: Path) -> None:
    with pytest.raises(wbv.DataFault, match=r"no-such\.csv"):
        wbv.capymoa.stream(data / "no-such.csv")
    with pytest.raises(wbv.DataFault, match=r"knee\.acc\.z"):
        wbv.capymoa.stream(data / "one-dof-linear.arff", output="knee.acc.z")
