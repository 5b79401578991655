# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs that may end in any way, told apart by a rule: finished, refused, crash or hang; and one that has finished: right, degraded or silent."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
from pathlib import Path
from typing import Any, Callable

from plunge.results import read_scene, solver_log
from plunge.studies.study import Done

FINISHED, REFUSED, CRASH, HANG = "finished", "refused", "crash", "hang"
LIMIT = 900     # [s] of waiting for a command: far more than any of these runs takes on a busy machine

# What a command says that has come down instead of refusing
_DOWN = re.compile(r"Traceback \(most recent call|Segmentation fault|Floating point exception(?! trapping)|Aborted|core dumped|printStack|sigFpe::|sigSegv::|"
                   r"terminate called")
ERROR = r"\b[Ee]xpected\b"  # what this repository's errors say


def end_of(status: int | None, said: str, error: str = ERROR) -> str:
    """How a command has ended, by its exit status (none: it had to be stopped) and what it has said: refused with the error that was due."""
    if status is None:
        return HANG
    if status == 0:
        return FINISHED
    # From 126 on it was not started, or ended by a signal
    return REFUSED if 0 < status < 126 and re.search(error, said) and not _DOWN.search(said) else CRASH


def command(*words: str | Path, limit: float = LIMIT) -> tuple[int | None, str]:
    """Exit status of a command, none where it had to be stopped, and what it has said."""
    with subprocess.Popen([*map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True) as process:
        try:
            said = process.communicate(timeout=limit)[0]
            return process.returncode, said
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            return None, process.communicate()[0]


def keep(path: Path, status: int | None, said: str, error: str = ERROR) -> str:
    """Leaves how a run has ended beside its directory."""
    end = end_of(status, said, error)
    path.with_name(f"{path.name}.ended").write_text(json.dumps({"status": status, "end": end, "said": said[-4000:]}))
    return end


def ended(done: Done) -> dict[str, Any]:
    return json.loads(done.path.with_name(f"{done.path.name}.ended").read_text())


def told(path: Path) -> str:
    """What a finished run says of its own doubts: the notes that go from its log into its summary, and warnings."""
    return "\n".join([*read_scene(path).notes, *re.findall(r"Warning: .*|FOAM Warning[\s\S]{0,400}", solver_log(path))])


def word(done: Done, verdict: str) -> str:
    """The verdict of a figure: right where it holds; degraded where it does not and the run itself says so, by the words (a regular
    expression) that it declares as `says`; else silent."""
    says = done.run.given.get("says")
    return "right" if verdict == "yes" else "degraded" if says and re.search(says, told(done.path)) else "silent"


def ending(done: Done, _: str) -> str:
    """The verdict of a run that has not finished; of one that has, and should have been refused, as by word()."""
    end = ended(done)["end"]
    return word(done, "") if end == FINISHED else end


def exit_status(done: Done) -> float | None:
    """Of a run that has not finished; -1 where it had to be stopped."""
    end = ended(done)
    return None if end["end"] == FINISHED else -1.0 if end["status"] is None else float(end["status"])


def of_finished(value: Callable[[Done], Any], figure: str) -> Callable[[Done], Any]:
    """A figure of the runs that declare it, where they have finished."""
    return lambda done: value(done) if done.run.given.get("figure") == figure and ended(done)["end"] == FINISHED else None
