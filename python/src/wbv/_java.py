"""Java inside this process: finds wbv's jar, starts Java once, and turns its faults into Python's."""

from __future__ import annotations

import contextlib
import importlib.util
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jpype

OLDEST_JAVA = 17
HOME = "WBV_HOME"
OPTIONS = "WBV_JAVA_OPTS"


class Fault(Exception):
    """Something is wrong; one line says what, and where."""


class DataFault(Fault, ValueError):
    """The data or the model is at fault (exit code 1 of the command): file, line or channel, what is wrong, what would be right."""


class UsageError(Fault, ValueError):
    """An argument is wrong (exit code 2 of the command)."""


def jars() -> tuple[Path, list[Path]]:
    """wbv's jar, and its libraries: of ``WBV_HOME``, of this package, or of the repository that this package lies in.

    :raises Fault: if there is none
    """
    here = Path(__file__).resolve()
    named = os.environ.get(HOME)
    homes = [Path(named), Path(named) / "target"] if named else [here.parent / "jars", here.parents[3] / "target"]
    for home in homes:
        jar, libraries = home / "wbv.jar", sorted((home / "lib").glob("*.jar"))
        if jar.is_file() and libraries:
            return jar, libraries
    if named:
        raise Fault(f"{HOME}={named}: there is no target/wbv.jar with target/lib beside it; run ./wbv there once, which builds them")
    raise Fault(f"wbv.jar was not built when this package was installed; run ./wbv once in its repository and set {HOME} to that folder, "
                "or install again")


def _capymoa() -> Path | None:
    """The jar with CapyMOA's own MOA, if CapyMOA is installed."""
    named = os.environ.get("CAPYMOA_MOA_JAR")
    if named:
        return Path(named)
    try:
        spec = importlib.util.find_spec("capymoa")
    except ValueError:  # half imported
        return None
    if spec is None or spec.origin is None:
        return None
    jar = Path(spec.origin).parent / "jar" / "moa.jar"
    return jar if jar.is_file() else None


def class_path() -> list[Path]:
    """What Java is to look for classes in, in this order.

    CapyMOA brings a MOA and a Weka of its own, newer than ours, which it cannot do without, and old versions of other libraries, which we
    cannot do with: ours come first but for MOA and Weka.
    """
    jar, libraries = jars()
    host = _capymoa()
    if host is None:
        return [jar, *libraries]
    return [*(one for one in libraries if not one.name.startswith(("moa-", "weka-"))), host, jar]


def _start() -> None:
    try:
        path = jpype.getDefaultJVMPath()
    except jpype.JVMNotFoundException as missing:
        raise Fault(f"no Java was found; wbv needs a JDK or JRE {OLDEST_JAVA} or newer, and JAVA_HOME if it is in no usual place") from missing
    options = os.environ.get(OPTIONS, "").split()
    jpype.startJVM(path, *options, "--enable-native-access=ALL-UNNAMED", ignoreUnrecognized=True, classpath=[str(one) for one in class_path()])


def java() -> Any:
    """The entry points of wbv's Java, started if need be.

    :raises Fault: if there is no Java, it is too old, or no jar
    """
    if not jpype.isJVMStarted():
        _start()
    version = str(jpype.java.lang.System.getProperty("java.specification.version"))
    if float(version) < OLDEST_JAVA:
        raise Fault(f"this is Java {version}; wbv needs {OLDEST_JAVA} or newer: set JAVA_HOME")
    try:
        jpype.JClass("wbv.cli.Main")
    except TypeError:
        raise Fault("Java was started without wbv: import wbv before CapyMOA, or whatever else starts Java in this process") from None
    return jpype


def prepare() -> None:
    """Tells JPype where wbv is, for whoever starts Java first. Without a jar that is left to the first call, which says what is missing."""
    if not jpype.isJVMStarted():
        with contextlib.suppress(Fault):
            for one in class_path():
                jpype.addClassPath(str(one))


@contextlib.contextmanager
def faults(about: str) -> Iterator[None]:
    """Turns what Java throws because of data into :class:`DataFault`. ``about``: the file, where the fault names none."""
    try:
        yield
    except jpype.JException as thrown:
        name = str(thrown.getClass().getName())
        if name == "wbv.recording.DataFault":
            raise DataFault(str(getattr(thrown, "of")(about).getMessage())) from None
        if name == "java.nio.file.NoSuchFileException":
            raise DataFault(f"{thrown.getMessage()}: there is no such file or folder") from None
        if name in ("java.io.IOException", "java.nio.file.AccessDeniedException"):
            raise DataFault(f"{about}: {thrown.getMessage()}") from None
        raise


def command(words: list[str]) -> str:
    """Runs one command line of wbv and returns what it printed.

    :raises DataFault: if the data or the model is at fault
    :raises UsageError: if an argument is wrong
    :raises Fault: if wbv is at fault, with Java's lines
    """
    vm = java()
    io = vm.JPackage("java").io
    out, err = io.StringWriter(), io.StringWriter()
    code = int(vm.JClass("wbv.cli.Main").run(io.PrintWriter(out), io.PrintWriter(err), words))
    if code == 0:
        return str(out)
    said = str(err).strip()
    lines = [line.removeprefix("wbv: ") for line in said.splitlines()]
    if code == 1:
        raise DataFault(lines[-1])
    if code == 2:
        raise UsageError(lines[0])
    raise Fault(said)


prepare()
