# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenFOAM's tutorials as test cases, with coarse meshes, and their comparison (plunge.studies.tutorials)."""
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Iterable, List

from plunge.studies import tutorials as compare  # noqa: F401: for tests
from plunge.studies.particleRuns import converge, setEntry  # noqa: F401: for tests


def foam(*command: object, case: Path, log: str = "log.foam") -> str:
    """Runs a program in the case directory and returns its output; fails the test with its last lines."""
    done = run(*command, case=case, log=log)
    if done.returncode:
        raise AssertionError(f"{' '.join(map(str, command))} in {case}: exit status {done.returncode}\n{done.stdout[-3000:]}")
    return done.stdout


def runScene(scene: Path, directory: Path, *options: object) -> str:
    """Makes the case of a scene, unless it is there, and runs it; the output of its Allrun."""
    foam("plungeCase", scene, "-run", directory, *options, case=directory.parent, log="log.plungeCase")
    return foam(directory / "Allrun", case=directory.parent, log="log.Allrun")


def run(*command: object, case: Path, log: str = "log.foam") -> subprocess.CompletedProcess:
    """Runs a program in the case directory; its output goes into a log there, too."""
    # OpenFOAM takes a PWD that is not the working directory for a mistake.
    done = subprocess.run([str(word) for word in command], cwd=case, env={**os.environ, "PWD": str(case)}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    (case / log).write_text(done.stdout)
    return done


def checkRefused(solver: str, case: Path, named: Iterable[str]) -> None:
    """A case that is wrong: the solver stops before the first time step with a message that holds these words."""
    done = run(solver, case=case, log="log.solver")
    assert done.returncode != 0, f"{case.name}: {solver} ran"
    assert not steps(done.stdout), f"{case.name}: stopped after a time step\n{done.stdout[-2000:]}"
    assert "FOAM FATAL" in done.stdout, f"{case.name}: crashed without a message\n{done.stdout[-2000:]}"
    message = done.stdout[done.stdout.index("FOAM FATAL"):]
    missing = [word for word in named if word not in message]
    assert not missing, f"{case.name}: {missing} not in\n{message[:3000]}"


def setUp(tutorial: str, directory: Path, *options: object) -> Path:
    """The case directory of a tutorial, meshed and with its initial fields; options: -<what compare.setUp takes> value."""
    return compare.setUp(tutorial, directory, **{str(name)[1:]: value for name, value in zip(options[::2], options[1::2])})


def copy(case: Path, name: str) -> Path:
    """A copy of a case that has been set up, beside it."""
    target = case.parent / name
    shutil.copytree(case, target)
    return target


def solve(case: Path, solver: str, ranks: int = 1) -> str:
    """Runs a solver to the end, parallel runs with reconstruction, and returns its output."""
    if ranks == 1:
        return foam(solver, case=case, log="log.solver")
    (case / "system/decomposeParDict").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }\n"
        f"numberOfSubdomains {ranks}; method simple; simpleCoeffs {{ n ({ranks} 1 1); delta 0.001; }}\n")
    foam("decomposePar", case=case)
    output = foam("mpirun", "-np", ranks, solver, "-parallel", case=case, log="log.solver")
    foam("reconstructPar", case=case)
    return output


def cellVolumes(case: Path) -> None:
    """Writes the field V at each time, from which differences are weighted."""
    foam("postProcess", "-func", "writeCellVolumes", case=case)


def steps(output: str) -> List[str]:
    """Names of the times that a solver has started."""
    return re.findall(r"^Time = (\S+)", output, re.MULTILINE)
