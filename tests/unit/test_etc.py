# SPDX-License-Identifier: GPL-3.0-or-later
"""The set-up: apt sources, package list, environment."""
import importlib.machinery
import importlib.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

from conftest import sourcedEnvironment


@pytest.fixture(scope="module")
def aptSourceList(repository: Path) -> ModuleType:
    """etc/aptSourceList as a module."""
    loader = importlib.machinery.SourceFileLoader("aptSourceList", str(repository / "etc/aptSourceList"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("aptSourceList", loader))
    # No __pycache__ in etc/.
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    sys.dont_write_bytecode = False
    return module


ONE_LINE = """\
# deb http://mirror.example/commented bookworm main
deb http://mirror.example/debian bookworm main contrib  # the usual one
deb [arch=amd64 signed-by=/usr/share/keyrings/some.gpg] https://other.example/deb/ stable main

deb-src http://mirror.example/debian bookworm main contrib
   deb http://flat.example/packages ./
debug http://mirror.example/nonsense bookworm main
"""

DEB822 = """\
# a comment
Types: deb
# URIs: http://snapshot.example/
URIs: http://mirror.example/debian/
Suites: bookworm bookworm-updates
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg

Types: deb deb-src
URIs: http://off.example/debian
Suites: bookworm
Components: main
Enabled: no


types: deb
URIs: https://keyed.example/debian
  https://second.example/debian
Suites: bookworm
Components: main
Architectures: amd64
Signed-By:
 -----BEGIN PGP PUBLIC KEY BLOCK-----
 .
 mQINBFit2ioBEADhWpZ8/wvZ6hUTiXOwQHXMAlaFHcPH9hAtr4F1y2+OYdbtMuth
 -----END PGP PUBLIC KEY BLOCK-----
"""

POLICY = """\
libopenfoam:
  Installed: 1912.200626-1+b1
  Candidate: 1912.200626-2
  Version table:
     1912.200626-2 500
        500 http://new.example/debian trixie/main amd64 Packages
 *** 1912.200626-1+b1 500
        500 http://mirror.example/debian bookworm/main amd64 Packages
        -1 https://keyed.example/debian stable/updates/main amd64 Packages
        100 /var/lib/dpkg/status
"""


def test_oneLineSources(aptSourceList: ModuleType) -> None:
    entries = list(aptSourceList.oneLineEntries(ONE_LINE))
    assert [entry.text for entry in entries] == [
        "deb-src http://mirror.example/debian bookworm main contrib",
        "deb-src [arch=amd64 signed-by=/usr/share/keyrings/some.gpg] https://other.example/deb/ stable main",
        "deb-src http://mirror.example/debian bookworm main contrib",
        "deb-src http://flat.example/packages ./",
    ]
    assert entries[1].places == {("https://other.example/deb", "stable")}


def test_deb822Sources(aptSourceList: ModuleType) -> None:
    first, keyed = aptSourceList.deb822Entries(DEB822)
    assert first.text.splitlines() == [
        "Types: deb-src",
        "URIs: http://mirror.example/debian/",
        "Suites: bookworm bookworm-updates",
        "Components: main",
        "Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg",
    ]
    assert first.places == {("http://mirror.example/debian", "bookworm"), ("http://mirror.example/debian", "bookworm-updates")}
    # The key block, its line for an empty line included, has to arrive as it was.
    assert keyed.text == DEB822[DEB822.index("types: deb"):].rstrip("\n").replace("types: deb", "Types: deb-src")
    assert ("https://second.example/debian", "bookworm") in keyed.places


def test_sourcesAreReadOnceAndInOrder(aptSourceList: ModuleType, tmp_path: Path) -> None:
    parts = tmp_path / "sources.list.d"
    parts.mkdir()
    (tmp_path / "sources.list").write_text(ONE_LINE)
    (parts / "a.sources").write_text(DEB822)
    (parts / "b.list").write_text("deb http://b.example/debian bookworm main\n")
    (parts / "c.save").write_text("deb http://saved.example/debian bookworm main\n")
    entries = aptSourceList.readEntries(tmp_path / "sources.list", parts)
    texts = " ".join(entry.text for entry in entries)
    # deb and deb-src of one place are one source of sources.
    assert len(entries) == 6 and texts.count("http://mirror.example/debian bookworm") == 1
    assert "saved" not in texts and "off.example" not in texts and texts.index("flat") < texts.index("keyed") < texts.index("//b.")

    aptSourceList.writeEntries(entries, tmp_path / "out")
    written = list(aptSourceList.readEntries(tmp_path / "none", tmp_path / "out"))
    assert sorted(entry.text for entry in written) == sorted(entry.text for entry in entries)


def test_sourceOfTheInstalledVersion(aptSourceList: ModuleType) -> None:
    places = aptSourceList.policyPlaces(POLICY, "1912.200626-1+b1")
    assert places == {("http://mirror.example/debian", "bookworm"), ("https://keyed.example/debian", "stable/updates")}
    entries = list(aptSourceList.oneLineEntries(ONE_LINE)) + list(aptSourceList.deb822Entries(DEB822))
    assert {entry.form for entry in aptSourceList.offering(entries, places)} == {"list", "sources"}
    assert not aptSourceList.offering(entries, aptSourceList.policyPlaces(POLICY, "1912.200626-2"))


@pytest.mark.skipif(not shutil.which("apt-get"), reason="no apt on this machine")
def test_aptReadsTheSourceList(repository: Path, tmp_path: Path) -> None:
    """What is derived from this machine's own sources is valid for apt, and names source packages only."""
    written = subprocess.run([repository / "etc/aptSourceList", tmp_path / "sources"])
    assert written.returncode == 0
    (tmp_path / "lists/partial").mkdir(parents=True)
    (tmp_path / "empty").mkdir()

    def uris(directory: str) -> str:
        done = subprocess.run(
            ["apt-get", "-o", "Dir::Etc::sourcelist=/dev/null", "-o", f"Dir::Etc::sourceparts={tmp_path}/{directory}",
             "-o", f"Dir::State::Lists={tmp_path}/lists", "update", "--print-uris"], capture_output=True, text=True)
        assert done.returncode == 0 and not done.stderr, done.stderr
        return done.stdout

    assert "InRelease" in uris("sources") and not uris("empty")
    for path in (tmp_path / "sources").iterdir():
        assert not re.search(r"^(Types:.*\bdeb(?!-src)|deb )", path.read_text(), re.MULTILINE)


def test_packageList(repository: Path) -> None:
    lines = [line.split("#")[0].split() for line in (repository / "etc/packages").read_text().splitlines()]
    rows = [line for line in lines if line]
    assert all(len(row) == 2 and row[1] in {"foam", "build", "python", "view"} for row in rows)
    names = [row[0] for row in rows]
    assert len(names) == len(set(names))
    assert all(re.fullmatch(r"[a-z0-9][a-z0-9+.-]+", name) for name in names)


def test_noHostIsNamed(repository: Path) -> None:
    """The mirrors are the machine's own."""
    for path in (path for path in (repository / "etc").iterdir() if path.is_file()):
        assert not re.search(r"https?://|\bdebian\.org\b", path.read_text()), path


def test_bashrcIsIdempotent() -> None:
    once = sourcedEnvironment()
    twice = sourcedEnvironment(**once)
    for variable in ("PATH", "LD_LIBRARY_PATH", "PYTHONPATH", "WM_PROJECT_DIR", "WM_OPTIONS"):
        assert once[variable] == twice[variable]
    assert once["PATH"].split(":").count(once["PLUNGE_APPBIN"]) == 1
    assert once["PATH"].split(":")[0] == once["PLUNGE_APPBIN"]
    assert once["LD_LIBRARY_PATH"].split(":")[0] == once["PLUNGE_LIBBIN"]


def test_bashrcKeepsTheListsOfTheUser() -> None:
    environment = sourcedEnvironment(LD_LIBRARY_PATH="/opt/a:/opt/b")
    assert environment["LD_LIBRARY_PATH"] == environment["PLUNGE_LIBBIN"] + ":/opt/a:/opt/b"


def test_bashrcFindsThePackage(repository: Path, tmp_path: Path) -> None:
    """From any directory: that of the checkout which was sourced last, before what the user has of his own."""
    package = repository / "applications/utilities"
    other = tmp_path / "another checkout"
    shutil.copytree(repository / "etc", other / "etc")
    (other / "applications/utilities/plunge").mkdir(parents=True)
    (other / "applications/utilities/plunge/__init__.py").touch()
    theirs = other / "applications/utilities"
    show = "echo $PYTHONPATH; cd /; /usr/bin/python3 -c 'import plunge; print(plunge.__file__)'"
    for own, sourced, path in (
            (None, (repository,), [package]), ("", (repository,), [package]), ("/opt/a:/opt/b", (repository,), [package, "/opt/a", "/opt/b"]),
            ("/opt/a", (other, repository, repository), [package, theirs, "/opt/a"]),
            ("/opt/a", (repository, other, repository, other), [theirs, package, "/opt/a"])):
        environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
        commands = "; ".join(f'. "{checkout}/etc/bashrc"' for checkout in sourced)
        done = subprocess.run(["bash", "-euc", f"{commands}; {show}"], capture_output=True, text=True, cwd=tmp_path,
                              env=environment if own is None else {**environment, "PYTHONPATH": own})
        assert done.stdout.splitlines() == [":".join(map(str, path)), f"{path[0]}/plunge/__init__.py"], done.stderr


def test_bashrcFromAnyDirectory(repository: Path, tmp_path: Path) -> None:
    link = tmp_path / "a link"
    link.symlink_to(repository)
    done = subprocess.run(["bash", "-euc", f'cd "{tmp_path}"; . "a link/etc/bashrc"; echo "$PLUNGE_DIR"'],
                          capture_output=True, text=True)
    assert done.stdout.strip() == str(repository), done.stderr


@pytest.mark.parametrize("shell", ["bash", "zsh"])
def test_bashrcThroughALinkToIt(repository: Path, tmp_path: Path, shell: str) -> None:
    if not shutil.which(shell):
        pytest.skip(f"no {shell} on this machine")
    (tmp_path / "plungerc").symlink_to(repository / "etc/bashrc")
    (tmp_path / "second").symlink_to(tmp_path / "plungerc")
    done = subprocess.run([shell, "-ec", f'. "{tmp_path}/second"; echo "$PLUNGE_DIR"'], capture_output=True, text=True)
    assert done.stdout.strip() == str(repository), done.stderr


@pytest.mark.parametrize("script", ["Allwmake", "Alltest", "Allrun", "Allclean", "etc/prepare"])
def test_scriptsThroughALink(repository: Path, tmp_path: Path, script: str) -> None:
    """They find what they are part of; none of these does more than to say its usage."""
    (tmp_path / "link").symlink_to(repository / script)
    done = subprocess.run([tmp_path / "link", "-h"], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.startswith("Usage: "), done.stderr
    assert "dirname \"${BASH_SOURCE" not in (repository / script).read_text()


def runFunction(repository: Path, command: str, **variables: str) -> str:
    """Output of a command in a shell that has etc/runFunctions."""
    done = subprocess.run(["bash", "-euc", f'. "{repository}/etc/runFunctions"; {command}'], capture_output=True, text=True,
                          env={**os.environ, **variables})
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_latestTimeInAnyLocale(repository: Path, tmp_path: Path) -> None:
    """Where numbers have commas, sort -g takes 5e-05 for 5 and 0.0105 for 0."""
    for name in ("0", "5e-05", "0.0105", "constant"):
        (tmp_path / name).mkdir()
    tools = tmp_path / "bin"
    tools.mkdir()
    # A machine need not have such a locale: this sort knows one
    (tools / "sort").write_text('#!/bin/bash\n[ "${LC_ALL:-}" = C ] && exec /usr/bin/sort "$@"\n/usr/bin/sort -t. -k1,1g\n')
    (tools / "sort").chmod(0o755)
    path = f"{tools}:{os.environ['PATH']}"
    assert subprocess.run(["sort", "-g"], input="0.0105\n5e-05\n0\n", capture_output=True, text=True,
                          env={**os.environ, "PATH": path, "LC_ALL": "de_DE.UTF-8"}).stdout.split()[-1] == "5e-05"
    assert runFunction(repository, f'latestTime "{tmp_path}"', PATH=path, LC_ALL="de_DE.UTF-8") == "0.0105"


@pytest.mark.parametrize("lines, cause", [
    (["a.C:1:1: error: 'x' was not declared"]*20000, "an error in the source:"),
    (["make: *** [a.o] Killed signal terminated program cc1plus"] + ["In file included from"]*20000, "out of memory"),
    (["nothing that is known"]*20000, "not recognised"),
])
def test_causeOfALongFailure(repository: Path, tmp_path: Path, lines: list, cause: str) -> None:
    """However much the compiler says, and whether it is English or not."""
    log = tmp_path / "log"
    log.write_text("\n".join(lines) + "\n")
    done = subprocess.run(["bash", "-c", f'set -euo pipefail; . "{repository}/etc/buildDiagnosis"; showOutput "{log}" >&2; '
                           f'explainFailure "{log}" wmake >&2'], capture_output=True, text=True)
    assert done.returncode == 0 and "Likely cause:" in done.stderr and cause in done.stderr, done.stderr[-500:]
    assert len(done.stderr.splitlines()) < 100
    assert "export LC_ALL=C" in (repository / "Allwmake").read_text()


def bareEnvironment(**variables: str) -> dict:
    """No OpenFOAM is sourced."""
    kept = {key: value for key, value in os.environ.items() if not key.startswith(("WM_", "FOAM_", "PLUNGE_"))}
    return {**kept, **variables}


def test_bashrcWithoutPreparation(repository: Path, tmp_path: Path) -> None:
    command = f'. "{repository}/etc/bashrc" || echo "status $?"; echo "dir ${{WM_PROJECT_DIR:-none}}"'
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True,
                          env=bareEnvironment(XDG_CACHE_HOME=str(tmp_path)))
    assert "etc/prepare first" in done.stderr
    assert done.stdout.split("\n")[:2] == ["status 1", "dir none"]


def sourcedTree(directory: Path) -> dict:
    """A directory that looks like an OpenFOAM of the user's own, and its environment."""
    for sub in ("wmake", "src/finiteVolume/lnInclude", "META-INFO"):
        (directory / sub).mkdir(parents=True)
    (directory / "META-INFO/api-info").write_text("api=2306\n")
    wmake = directory / "wmake/wmake"
    wmake.write_text("#!/bin/sh\n")
    wmake.chmod(0o755)
    return {"WM_PROJECT_DIR": str(directory), "WM_OPTIONS": "linux64ClangSPInt64Opt", "WM_DIR": str(directory / "wmake"),
            "WM_PROJECT_VERSION": "v2306"}


def test_sourcedOpenFOAMIsKept(repository: Path, tmp_path: Path) -> None:
    environment = sourcedEnvironment(**sourcedTree(tmp_path / "foam"))
    assert environment["WM_PROJECT_DIR"] == str(tmp_path / "foam")
    assert environment["PLUNGE_LIBBIN"] == f"{repository}/platforms/linux64ClangSPInt64Opt/lib"


def test_sourcedOpenFOAMOfAnotherKind(repository: Path, tmp_path: Path) -> None:
    variables = sourcedTree(tmp_path / "foam")
    (tmp_path / "foam/META-INFO/api-info").unlink()
    with pytest.raises(RuntimeError, match="expected a release of openfoam.com, v1912 v2006"):
        sourcedEnvironment(**variables)


@pytest.mark.parametrize("version, api, headers", [
    ("11", None, True), ("dev", None, True), ("11", None, False), ("9", None, False),    # the Foundation's
    ("5.0-extend", None, True), ("v1906", "1906", True), ("v1806", "1806", False), ("v2606", "2606", True),
    ("v2306", None, True)])
def test_unsupportedOpenFOAMIsRefusedAtOnce(repository: Path, tmp_path: Path, version: str, api: str, headers: bool) -> None:
    """By each program that meets it first, with the list of those that are supported, and before apt is asked for anything."""
    variables = {**sourcedTree(tmp_path / "foam"), "WM_PROJECT_VERSION": version}
    (tmp_path / "foam/META-INFO/api-info").unlink()
    if api:
        (tmp_path / "foam/META-INFO/api-info").write_text(f"api={api}\npatch=0\n")
    if not headers:
        shutil.rmtree(tmp_path / "foam/src")
    tools = tmp_path / "bin"
    tools.mkdir()
    for name in ("apt-get", "dpkg-query", "sudo", "wmake"):
        (tools / name).write_text(f"#!/bin/sh\ntouch '{tmp_path}/called'\nexit 1\n")
        (tools / name).chmod(0o755)
    environment = bareEnvironment(PATH=f"{tools}:/usr/bin:/bin", HOME=str(tmp_path), XDG_CACHE_HOME=str(tmp_path / "cache"), **variables)
    for command in (["etc/prepare"], ["./Allwmake"], ["./Allrun"], ["./Alltest", "unit"], ["bash", "-c", ". etc/bashrc"]):
        done = subprocess.run(command, env=environment, cwd=repository, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        assert done.returncode == 1, command
        assert f"the sourced OpenFOAM {version} in {tmp_path}/foam is not supported" in done.stderr, command
        assert "v1912 v2006 v2012 v2106 v2112 v2206 v2212 v2306 v2312 v2406 v2412 v2506 v2512" in done.stderr, command
    assert not (tmp_path / "called").exists() and not (tmp_path / "cache").exists()


@pytest.mark.parametrize("api", ["1912", "2006", "2212", "2506", "2512"])
def test_supportedOpenFOAMIsTaken(tmp_path: Path, api: str) -> None:
    variables = sourcedTree(tmp_path / "foam")
    (tmp_path / "foam/META-INFO/api-info").write_text(f"api={api}\npatch=0\n")
    assert sourcedEnvironment(**{**variables, "WM_PROJECT_VERSION": f"v{api}"})["WM_PROJECT_DIR"] == str(tmp_path / "foam")


def test_releasesAreThoseOfTheReadme(repository: Path) -> None:
    releases = re.search(r'plungeFoamReleases="([\d ]+)"', (repository / "etc/foamLocation").read_text()).group(1).split()
    text = (repository / "README.md").read_text()
    assert all(f"v{release}" in text for release in releases)


@pytest.mark.parametrize("api, standard, library", [("1912", "c++14", ""), ("2006", "c++14", "-lgeometricVoF"),
                                                    ("2406", "c++14", "-lgeometricVoF"), ("2412", "c++17", "-lgeometricVoF")])
def test_compilerOptionsFollowTheRelease(repository: Path, tmp_path: Path, api: str, standard: str, library: str) -> None:
    sourcedTree(tmp_path / "foam")
    (tmp_path / "foam/META-INFO/api-info").write_text(f"api={api}\npatch=0\n")
    (tmp_path / "makefile").write_text("include $(PLUNGE_DIR)/src/compilerOptions\n"
                                       "all:\n\t@echo '$(PLUNGE_INC)'\n\t@echo '$(GEOMETRIC_VOF_LIBS)'\n")
    done = subprocess.run(["make", "-f", tmp_path / "makefile"], capture_output=True, text=True,
                          env={**os.environ, "WM_PROJECT_DIR": str(tmp_path / "foam"), "PLUNGE_DIR": str(repository)})
    options, libraries = done.stdout.splitlines()
    assert f"-std={standard}" in options.split() and libraries.strip() == library


def test_administratorsLine(repository: Path, tmp_path: Path) -> None:
    """Without rights: the missing packages, and only those, in one line to hand on. With an OpenFOAM sourced, not Debian's."""
    tools = tmp_path / "bin"
    tools.mkdir()
    # An ordinary user, no sudo, and numpy and OpenFOAM not installed.
    for name, script in {
        "id": "echo 1000",
        "dpkg-query": 'case "$*" in *python3-numpy*|*openfoam*) exit 1;; *) echo "ii ";; esac',
        "sudo": "exit 1",
    }.items():
        (tools / name).write_text(f"#!/bin/sh\n{script}\n")
        (tools / name).chmod(0o755)

    path = f"{tools}:/usr/bin:/bin"
    sourced = sourcedTree(tmp_path / "foam")
    # The tree that etc/prepare made stands for Debian's OpenFOAM, also once etc/bashrc has been sourced.
    prepared = sourcedTree(tmp_path / "cache")
    (tmp_path / "cache/.plungeFoam").touch()
    withFoam = "openfoam libopenfoam python3-numpy"
    for variables, packages in (({}, withFoam), (sourced, "python3-numpy"), (prepared, withFoam)):
        done = subprocess.run([repository / "etc/prepare"], env=bareEnvironment(PATH=path, **variables),
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
        assert done.returncode == 1
        assert f"    apt-get update && apt-get install --no-install-recommends -y {packages}\n" in done.stderr
