# SPDX-License-Identifier: GPL-3.0-or-later
"""An animation of pictures: mp4 where ffmpeg is there, else gif."""

from __future__ import annotations

import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Iterable, Iterator

import numpy as np

from plunge.results import CaseError

SECONDS = 6.0           # that a movie lasts, within these rates
RATES = (2.0, 25.0)     # [frames per second]
HEIGHT = 640            # of a frame [pixels]
QUIET = 30.0            # between two lines of progress where they do not replace each other [s]


def progress(pictures: Iterable[np.ndarray], count: int) -> Iterator[np.ndarray]:
    """The pictures; says on stderr how many of them are done and how long the others take: on a terminal in place."""
    start, said = time.monotonic(), -QUIET
    terminal = sys.stderr.isatty()
    for number, picture in enumerate(pictures, start=1):
        yield picture
        now = time.monotonic() - start
        left = round(now / number * (count - number))
        if not terminal and now - said < QUIET and number < count:
            continue
        said = now
        line = f"movie: {number} of {count} frames, left {left // 60}:{left % 60:02d}"
        print(f"\r{line}\033[K" if terminal else line, end="" if terminal else "\n", file=sys.stderr, flush=True)
    if terminal:
        print("\r\033[K", end="", file=sys.stderr, flush=True)


def write(pictures: Iterable[np.ndarray], count: int, stem: Path) -> Path:
    """Write so many pictures (rows, columns, rgb) of one size as <stem>.mp4 or <stem>.gif; return the file."""
    stem.parent.mkdir(parents=True, exist_ok=True)
    rate = float(np.clip(count / SECONDS, *RATES))
    ffmpeg = shutil.which("ffmpeg")
    path, other = (stem.with_suffix(end) for end in ((".mp4", ".gif") if ffmpeg else (".gif", ".mp4")))
    pictures = progress(pictures, count)
    if ffmpeg:
        _write_mp4(ffmpeg, pictures, rate, path)
    else:
        _write_gif(pictures, rate, path)
    other.unlink(missing_ok=True)  # of an earlier call
    return path


def _write_mp4(ffmpeg: str, pictures: Iterator[np.ndarray], rate: float, path: Path) -> None:
    """The common kind of H.264, which takes even numbers of rows and columns."""
    process = None
    for picture in pictures:
        rows, columns = (n - n % 2 for n in picture.shape[:2])
        if process is None:
            process = subprocess.Popen(
                [ffmpeg, "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{columns}x{rows}", "-r", f"{rate:g}",
                 "-i", "-", "-pix_fmt", "yuv420p", "-crf", "20", "-movflags", "+faststart", str(path)], stdin=subprocess.PIPE)
        try:
            process.stdin.write(np.ascontiguousarray(picture[:rows, :columns]).tobytes())
        except BrokenPipeError:
            break
    if process is not None:
        process.stdin.close()
        if process.wait():
            raise CaseError(f"{path}: ffmpeg failed (see above)")


def _write_gif(pictures: Iterator[np.ndarray], rate: float, path: Path) -> None:
    from PIL import Image

    images = [Image.fromarray(picture).quantize(256, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE) for picture in pictures]
    pause = [round(1000 / rate)] * (len(images) - 1) + [1500]  # the end can be looked at
    images[0].save(path, save_all=True, append_images=images[1:], duration=pause, loop=0)
