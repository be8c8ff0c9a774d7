#!/usr/bin/env python3
"""Spoilt study files end in words: studies.py SCRATCH N

N study files of the checkout are spoilt, with the same seed each time, and read as
scripts/study does before it runs anything. Each is read, or refused with a StudyError.
"""

import random
import shutil
import sys
import traceback
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PARTS = ["|", "||", "=", "set ", "runs", "collect", "base = ", "base = ../bar.prm", "#",
         '"', '"|', "name", "name | A/B", "a | 1", "..", "/", "a/b/c", "\t", "\0", "\xff",
         "\ud800", "x" * 300, "1e999", "nan", "set = ", "set a", "= 3", "\n\n", "\r",
         "base = /dev/zero", "base = /", "base = .", "base = \0", "name | | x"]


def load_study():
    loader = SourceFileLoader("study", str(ROOT / "scripts" / "study"))
    module = module_from_spec(spec_from_loader("study", loader))
    sys.modules["study"] = module  # dataclasses look for it there
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


def spoil(text, draw):
    for _ in range(draw.randint(1, 3)):
        lines = text.split(b"\n")
        i = draw.randrange(len(lines))
        at = draw.randrange(len(text) + 1)
        part = draw.choice(PARTS).encode("utf-8", "surrogatepass")
        text = draw.choice([
            lambda: text[:at] + part + text[at:],
            lambda: text[:at] + bytes([draw.randrange(256)]) + text[at + 1:],
            lambda: text[:at] + text[at + draw.randrange(20):],
            lambda: text[:at],
            lambda: b"\n".join(lines[:i] + lines[i + 1:]),
            lambda: b"\n".join(lines[:i] + [lines[i]] + lines[i:]),
            lambda: b"\n".join(lines[:i] + [part] + lines[i + 1:]),
            lambda: b"\n".join(draw.sample(lines, len(lines))),
        ])()
    return text


def main():
    scratch, count = Path(sys.argv[1]), int(sys.argv[2])
    study = load_study()
    draw = random.Random(1)
    shutil.rmtree(scratch, ignore_errors=True)
    for folder in ("prm", "tests/study", "tests/fir_tree"):
        shutil.copytree(ROOT / folder, scratch / folder)
    files = sorted(file for file in scratch.rglob("*.study")
                   if file.stat().st_size < 5000)
    failed = refused = 0
    for number in range(count):
        source = draw.choice(files)
        text = spoil(source.read_bytes(), draw)
        file = source.with_name("mutant.study")
        file.write_bytes(text)
        try:
            study.prepare_runs(study.read_study(file), scratch / "runs")
            shutil.rmtree(scratch / "runs")
        except study.StudyError:
            refused += 1
        except Exception:
            failed += 1
            (scratch / f"failed_{number}.study").write_bytes(text)
            print(f"{number}:")
            traceback.print_exc(file=sys.stdout)
    print(f"{refused} of {count} refused, {failed} ended wrongly")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
