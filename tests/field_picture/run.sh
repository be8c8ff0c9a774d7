#!/usr/bin/env bash
# scripts/field_picture draws what was computed, where it is, and refuses what is wrong:
# run.sh PROGRAM SCRATCH.
set -u
program=$1
scratch=$2
failed=0

fail() {
  echo "$1"
  failed=1
}

# refused CODE TEXT OPTIONS...: the message has the text, and there is no picture.
refused() {
  local code=$1 text=$2 output found
  shift 2
  output=$(scripts/field_picture "$@" 2>&1)
  found=$?
  [ "$found" = "$code" ] || fail "exit code $found, expected $code: $*"
  [[ $output == *"$text"* ]] || fail "'$text' is not in '$output'."
}

rm -rf "$scratch"
mkdir -p "$scratch"
"$program" --threads 1 --output-directory "$scratch" tests/field_picture/square.prm >/dev/null ||
  exit 1
run=$scratch/square
picture=$scratch/square.png

# Ten bands of the displacement; half of it after half of the time.
scripts/field_picture "$run" displacement_x "$picture" --range 0,0.1 --window 0,0,1.1,1 ||
  fail "the picture failed."
scripts/field_picture "$run/results.pvd" displacement_x "$scratch/half.png" --range 0,0.1 \
  --window 0,0,1.05,1 --time 0.6 || fail "the picture at 0.5 s failed."
scripts/field_picture "$run" displacement_x "$scratch/mean.png" --range 0,0.1 \
  --window 0,0,1.1,1 --after 0.5 --mesh --contour 0.01 --mirror || fail "the mean failed."

# Fringes: N = 5 at the right end, and the intensity is sin^2(pi N).
scripts/field_picture "$run" displacement_x "$scratch/fringes.png" --fringes 0.02 \
  --window 0,0,1.1,1 || fail "the fringes failed."

/usr/bin/python3 - "$scratch" <<'END' || fail "the colours are not as computed."
import math
import sys
from vtkmodules.vtkIOImage import vtkPNGReader


def colours(name, n, left=78, right=140):
    """Colours in the middle of n equal parts of the line at half height."""
    reader = vtkPNGReader()
    reader.SetFileName(f"{sys.argv[1]}/{name}.png")
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    place = [left + (width - left - right) * (i + 0.5) / n for i in range(n)]
    return [tuple(int(image.GetScalarComponentAsDouble(round(x), height // 2, 0, c))
                  for c in range(3)) for x in place]


full, half = colours("square", 10), colours("half", 5)
brightness = [sum(colour) for colour in full]
grey = colours("fringes", 40)
sines = [255 * math.sin(math.pi * 5 * (i + 0.5) / 40) ** 2 for i in range(40)]
off = max(abs(c - s) for colour, s in zip(grey, sines) for c in colour)
print(full, half, "fringes off by", off, "of 255")
fringes = off < 12
good = len(set(full)) == 10 and brightness == sorted(brightness, reverse=True)
sys.exit(not (good and half == full[:5] and fringes))
END

refused 1 "has no field 'stress', but: displacement" "$run" stress "$scratch/no.png"
refused 1 "There is no body 'sphere', but: square" "$run" stress_xx "$scratch/no.png" --body sphere
refused 1 "No node lies in the window" "$run" stress_xx "$scratch/no.png" --window 5,5,6,6
refused 1 "No fields were written after 2 s" "$run" stress_xx "$scratch/no.png" --after 2
refused 1 "cannot be written" "$run" stress_xx "$scratch/none/no.png"
refused 1 "cannot be read" "$scratch/none" stress_xx "$scratch/no.png"
refused 2 "X0 must be less than X1" "$run" stress_xx "$scratch/no.png" --window 1,0,0,1
refused 2 "'1,2,3' was found" "$run" stress_xx "$scratch/no.png" --range 1,2,3
refused 2 "'0' was found" "$run" displacement_x "$scratch/no.png" --fringes 0
refused 2 "without --range" "$run" displacement_x "$scratch/no.png" --fringes --range 0,1
refused 2 "the picture is a PNG" "$run" stress_xx "$scratch/no.svg"
head -c 2000 "$run/square_00002.vtu" >"$scratch/part" && mv "$scratch/part" "$run/square_00002.vtu"
refused 1 "square_00002.vtu cannot be read" "$run" stress_xx "$scratch/no.png"
[ ! -e "$scratch/no.png" ] || fail "a picture was written after an error."

exit "$failed"
