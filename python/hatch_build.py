"""Puts wbv's jar and its libraries into the wheel, where they are built beside it."""

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

# PyTorch's library serves 'wbv net' alone, which the package does not offer; it is three quarters of all bytes.
LEFT_OUT = ("pytorch-native-", "pytorch-jni-")


class Jars(BuildHookInterface):  # type: ignore[misc]
    """The build of the repository in which this folder lies."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        target = Path(self.root).parent / "target"
        jar = target / "wbv.jar"
        if version == "editable" or not jar.is_file():
            return
        build_data["force_include"][str(jar)] = "wbv/jars/wbv.jar"
        for library in sorted((target / "lib").glob("*.jar")):
            if not library.name.startswith(LEFT_OUT):
                build_data["force_include"][str(library)] = f"wbv/jars/lib/{library.name}"
