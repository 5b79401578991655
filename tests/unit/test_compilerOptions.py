# SPDX-License-Identifier: GPL-3.0-or-later
"""src/compilerOptions: what keeps OpenFOAM v1912's products of fields right, in shared libraries, where it matters."""
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

# The result takes the storage of the temporary. Where there are several such products, as in a library, the loop is a function by
# itself, in which the compiler does not see that two of its operands are one.
SOURCE = """
#include "tensorField.H"

using namespace Foam;

tmp<vectorField> product(const tensorField& T, const tmp<vectorField>& v)
{
    return T & v;
}

tmp<vectorField> productOfTemporaries(const tmp<tensorField>& T, const tmp<vectorField>& v)
{
    return T & v;
}

extern "C" int wrongProducts(const int n)
{
    tensorField T(n);
    tmp<vectorField> v(new vectorField(n)), w(new vectorField(n));
    vectorField expected(n);
    forAll(T, i)
    {
        T[i] = tensor(i, 1, 2, 3, i, 4, 5, 6, i);
        v.ref()[i] = w.ref()[i] = vector(1, i, 2);
        expected[i] = vector(2*i + 4, i*i + 11, 8*i + 5);
    }
    const vectorField one(product(T, v));
    const vectorField other(productOfTemporaries(tmp<tensorField>(new tensorField(T)), w));
    int wrong = 0;
    forAll(T, i)
    {
        wrong += one[i] != expected[i] || other[i] != expected[i];
    }
    return wrong;
}
"""
CELLS = 1000
CALL = "import ctypes, sys; print(ctypes.CDLL(sys.argv[1]).wrongProducts(int(sys.argv[2])))"


def wrongProducts(directory: Path, options: str) -> int:
    """In how many cells a library that wmake builds with these Make/options gets the product wrong."""
    (directory / "Make").mkdir(parents=True)
    (directory / "products.C").write_text(SOURCE)
    (directory / "Make/files").write_text(f"products.C\n\nLIB = {directory}/libproducts\n")
    (directory / "Make/options").write_text(f"{options}\nLIB_LIBS = -L$(FOAM_LIBBIN) -lOpenFOAM\n")
    built = subprocess.run(["wmake", "-s", "libso", directory], capture_output=True, text=True)
    assert built.returncode == 0, built.stdout + built.stderr
    called = subprocess.run([sys.executable, "-c", CALL, directory / "libproducts.so", str(CELLS)], capture_output=True, text=True)
    assert called.returncode == 0, called.stderr
    return int(called.stdout.split()[-1])


def isVersion12() -> bool:
    return bool(shutil.which("g++")) and subprocess.run(["g++", "-dumpversion"], capture_output=True, text=True).stdout.startswith("12")


def test_products_with_a_temporary_field_are_right(tmp_path: Path) -> None:
    assert wrongProducts(tmp_path / "with", "include $(PLUNGE_DIR)/src/compilerOptions\nEXE_INC = $(PLUNGE_INC)\n") == 0


@pytest.mark.skipif(os.environ.get("WM_PROJECT_VERSION") != "v1912" or os.environ.get("WM_COMPILE_OPTION") != "Opt"
                    or not isVersion12(),
                    reason="what is known of v1912 with g++ 12 at -O3")
def test_without_the_option_they_are_wrong(tmp_path: Path) -> None:
    """So the test above can fail."""
    assert wrongProducts(tmp_path / "without", "EXE_INC =\n") == CELLS


def test_everything_is_built_with_the_options(repository: Path) -> None:
    options = [path for folder in ("src", "applications") for path in (repository / folder).glob("**/Make/options")]
    assert len(options) > 10
    for path in options:
        text = path.read_text()
        assert "include $(PLUNGE_DIR)/src/compilerOptions" in text and "$(PLUNGE_INC)" in text, path
