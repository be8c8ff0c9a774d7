#!/usr/bin/env bash
# Newton's method converges quadratically: run.sh PROGRAM FILE.prm SCRATCH [OPTIONS...].
# Each residual between 1e-3 and 1e-7 is followed by one that is less than its square times
# a constant, down to what rounding leaves.
set -eu -o pipefail
program=$1
prm=$2
scratch=$3
shift 3
rm -rf "$scratch"
mkdir -p "$scratch"
"$program" "$prm" --threads 1 --output-directory "$scratch" \
  --set "Output/Residuals in log=true" --set "Expected results/Checks=" "$@" >/dev/null

awk '
  / residuals / {
    n_values = 0
    for (i = 1; i <= NF; ++i) if ($i ~ /residuals/) first = i + 1
    for (i = first; i < NF; ++i) {
      if ($i > 1e-3 || $i < 1e-7 || $(i + 1) < 1e-13) continue
      ++n
      constant = $(i + 1) / $i ^ 2
      if (constant > largest) { largest = constant; worst = $0 }
    }
  }
  END {
    printf "%d pairs of residuals, r_new/r^2 at most %.3g\n%s\n", n, largest, worst
    exit !(n >= 5 && largest < 1e3)
  }' "$scratch"/*/*.log
