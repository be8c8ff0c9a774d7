#!/usr/bin/env python3
"""Designs drawn at random go the whole way: run.py PROGRAM SCRATCH [N].

For N gear pairs and N fir-tree joints with random measures the program either refuses the
input and names the body and the entry, or it computes the contact: exit code 0, with the
load in balance with the contact forces. It has to do so for N of each kind.
"""

import random
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


def gear_pair(draw):
    """Entries of prm/rack_and_pinion.prm, all pairs of teeth in contact."""
    module = 10**draw.uniform(-3.5, -1.5)
    teeth = draw.randint(14, 60)
    both = {
        "Module": module,
        "Pressure angle": draw.uniform(16, 28),
        "Addendum": draw.uniform(0.8, 1.05),
        "Dedendum": draw.uniform(1.15, 1.35),
        "Fillet radius": draw.uniform(0.2, 0.4),
        "Profile shift": draw.uniform(-0.1, 0.5),
        "Tooth thinning": 0.02 * module,
        "Tip relief": draw.choice([0, 1e-3 * module]),
        "Roll angle": draw.uniform(-180, 180) / teeth,
        "Cells along a flank": 8,
    }
    both["Tip relief length"] = 0.5 * module if both["Tip relief"] else 0
    entries = {
        "Body pinion/Pinion/Teeth": teeth,
        "Body pinion/Pinion/Bore radius": module * (teeth / 2 - 4),
        "Body rack/Rack/Teeth of the pinion": teeth,
        "Body rack/Rack/Back thickness": 2 * module,
        "Body pinion/Refinements towards": "right_1 : 2 ; right_2 : 2 ; right_3 : 2",
        "Body rack/Refinements towards": "right_1 : 2 ; right_2 : 2 ; right_3 : 2",
        "Body pinion/Element degree": 1,
        "Body rack/Element degree": 1,
        "Adaptivity/Maximal meshes": 1,
        "Body rack/Loads/Traction": "back: 1e6*t ; 0",
        "Contact/Pairs": ", ".join(f"pinion.right_{k} on rack.right_{k}" for k in (1, 2, 3)),
        "Time/Step size": 0.5,
        # The back is three pitches long.
        "Expected results/Checks":
            "(" + " + ".join(f"final(rack.right_{k}.force_x)" for k in (1, 2, 3)) +
            f")/(1e6*3*pi*{module!r}) = 1 +- 1e-6",
    }
    for name, value in both.items():
        entries[f"Body pinion/Pinion/{name}"] = value
        entries[f"Body rack/Rack/{name}"] = value
    return "prm/rack_and_pinion.prm", entries


def joint(draw):
    """Entries of prm/fir_tree.prm."""
    size = 10**draw.uniform(-1, 1)
    teeth = draw.randint(1, 6)
    measures = {
        "Teeth": teeth,
        "Flank length": size * draw.uniform(1e-3, 5e-3),
        "Contact angle": draw.uniform(10, 55),
        "Back flank angle": draw.uniform(10, 60),
        "Taper angle": draw.uniform(0, 20),
        "Root radius": size * draw.uniform(0.5e-3, 2e-3),
        "Tip radius": size * draw.uniform(0.4e-3, 2e-3),
        "Bottom radius": size * draw.uniform(3e-3, 20e-3),
        "Bottom neck width": size * draw.uniform(6e-3, 20e-3),
        "Clearance": size * draw.uniform(0, 0.2e-3),
        "Mouth depth": size * draw.uniform(1.5e-3, 6e-3),
        "Rim radius": size * draw.uniform(0.25, 0.4),
        "Blades": draw.randint(20, 70),
    }
    flanks = [f"contact_{k + 1}" for k in range(teeth)]
    entries = {
        # The pull at the top of the blade alone, with the same stress for all sizes.
        "Body blade/Blade root/Shank height": size * 12e-3,
        "Body blade/Loads/Angular velocity": 0,
        "Body disc/Loads/Angular velocity": 0,
        "Body blade/Loads/Traction": "top: 0 ; 20e6*t",
        "Contact/Pairs": ", ".join(f"blade.{f} on disc.{f}" for f in flanks),
        "Contact/Friction coefficient": draw.choice([0, 0.1, 0.5]),
        "Output/Monitor": "",
        "Output/Time between fields": 0,
        "Time/End time": 1,
        "Time/Step size": 0.5,
        "Expected results/Checks":
            " + ".join(f"final(disc.{f}.force_y)" for f in flanks) + " < 0 | " +
            " | ".join(f"max(disc.{f}.penetration) < {1e-9 * size!r}" for f in flanks),
    }
    for body, section in (("blade", "Blade root"), ("disc", "Disc sector")):
        for name, value in measures.items():
            entries[f"Body {body}/{section}/{name}"] = value
    return "prm/fir_tree.prm", entries


def is_refusal(output):
    """A message about a measure, and not about a misspelt entry."""
    return "Body " in output and " / " in output and "unknown entry" not in output


def main():
    program, scratch = sys.argv[1:3]
    n_wanted = int(sys.argv[3]) if len(sys.argv) > 3 else 20
    n_failed = 0
    for kind in (gear_pair, joint):
        draw = random.Random(1)
        n_valid = n_refused = 0
        while n_valid < n_wanted:
            prm, entries = kind(draw)
            command = [program, prm, "--threads", "1", "--overwrite", "--output-directory", scratch]
            for path, value in entries.items():
                command += ["--set", f"{path}={value}"]
            run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
            output = run.stdout + run.stderr
            if run.returncode == 1 and is_refusal(output):
                n_refused += 1
                if n_refused > 20 * n_wanted:
                    sys.exit(f"{kind.__name__}: {n_refused} designs were refused, the last one by\n{output}")
                continue
            n_valid += 1
            if run.returncode != 0:
                n_failed += 1
                print(f"{kind.__name__} {n_valid}, exit code {run.returncode}: {entries}\n{output}")
        print(f"{kind.__name__}: {n_valid} computed, {n_refused} refused")
    sys.exit(1 if n_failed else 0)


main()
