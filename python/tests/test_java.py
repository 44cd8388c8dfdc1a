"""How the jar and Java are found."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

import wbv._java


def python(code: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env={**os.environ, **environment})


def test_a_home_without_a_jar_is_told(tmp_path: Path) -> None:
    ran = python("import wbv; wbv.read('x.csv')", WBV_HOME=str(tmp_path))
    assert ran.returncode == 1
    assert ran.stderr.splitlines()[-1] == (f"wbv._java.Fault: WBV_HOME={tmp_path}: there is no target/wbv.jar with target/lib beside it; run ./wbv "
                                           "there once, which builds them")


def test_a_home_is_the_repository_or_its_target() -> None:
    jar, _ = wbv._java.jars()
    for home in (jar.parent, jar.parent.parent):
        if home == jar.parent.parent and jar.parent.name != "target":
            continue  # the package's own jars
        ran = python("import wbv; print(wbv.run('--version'), end='')", WBV_HOME=str(home))
        assert ran.stdout == f"wbv {wbv.__version__}\n", ran.stderr


def test_no_java_is_told(tmp_path: Path) -> None:
    ran = python("import jpype, wbv\n"
                 "def nowhere(*_): raise jpype.JVMNotFoundException('none')\n"
                 "jpype.getDefaultJVMPath = nowhere\n"
                 "wbv.run('--version')")
    assert "no Java was found; wbv needs a JDK or JRE 17 or newer" in ran.stderr.splitlines()[-1]


def test_java_that_was_started_without_wbv_is_told() -> None:
    ran = python("import jpype; jpype.startJVM(classpath=[])\nimport wbv\nwbv.run('--version')")
    assert "Java was started without wbv: import wbv before" in ran.stderr.splitlines()[-1]


@pytest.mark.parametrize("installed", [True, False])
def test_our_libraries_come_first_and_the_hosts_moa_replaces_ours(installed: bool, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    host = tmp_path / "moa.jar"
    monkeypatch.setattr(wbv._java, "_capymoa", lambda: host if installed else None)
    names = [one.name for one in wbv._java.class_path()]
    assert any(name.startswith("moa-") for name in names) != installed
    assert (names.index("moa.jar") > max(i for i, name in enumerate(names) if name.startswith("ejml"))) if installed else "moa.jar" not in names
