from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

import wbv._java

HOME = Path(__file__).resolve().parents[2]
DATA = HOME / "data" / "arff"


@pytest.fixture(scope="session")
def data() -> Path:
    """The recordings that ship with wbv."""
    return DATA


@pytest.fixture
def shell(tmp_path: Path) -> Callable[..., Path]:
    """Runs a command of wbv in a Java of its own, as at a shell; returns the folder that it wrote."""
    jar, _ = wbv._java.jars()

    def run(*words: str | os.PathLike[str]) -> Path:
        out = tmp_path / "shell"
        subprocess.run(["java", "-jar", os.fspath(jar), *map(os.fspath, words), "--out", os.fspath(out)], check=True, capture_output=True)
        return out

    return run
