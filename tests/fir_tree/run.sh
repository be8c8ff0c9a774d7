#!/usr/bin/env bash
# What the measures of a fir-tree joint do to it (prm/fir_tree/README.md), on a coarse mesh:
# run.sh PROGRAM SCRATCH
set -u
program=$1
scratch=$2
summary=$scratch/joint/summary.csv

rm -rf "$scratch"
mkdir -p "$scratch"
scripts/study tests/fir_tree/joint.study --jobs 1 --threads 1 --program "$program" \
  --output-directory "$scratch" || exit 1

# Constants hold commas, in quotes; they are left out.
sed 's/"[^"]*"//' "$summary" | awk -F, '
  NR == 1 { for (i = 1; i <= NF; ++i) name[i] = $i; next }
  { for (i = 1; i <= NF; ++i) v[$1, name[i]] = $i }

  function check(is_true, text) { if (!is_true) { print "wrong: " text; failed = 1 } }
  function of(run, column) { return v[run, column " [" unit[column] "]"] }
  function ratio(run, column) { return of(run, column)/of("base", column) }
  # The pull, and omega^2 times density and first moment of the root, from its outline.
  function balance(run, exact) {
    check((of(run, "force")/exact - 1)^2 < (1e-4)^2, run " carries " of(run, "force") " kN, not " exact)
  }
  function between(run, column, low, high) {
    check(ratio(run, column) > low && ratio(run, column) < high,
          column " of " run ": " ratio(run, column) " times that of base")
  }

  END {
    unit["force"] = "kN"; unit["share 3"] = "%"; unit["disc"] = unit["blade"] = "MPa"
    unit["mean pressure 3"] = "MPa"; unit["slip 3"] = "um"
    unit["disc x"] = unit["disc y"] = "mm"
    balance("base", 1796.049)
    balance("l_4", 1914.039)
    balance("alpha_40", 1760.204)
    balance("beta_45", 1930.360)
    balance("gamma_0", 1601.375)
    balance("mu_0.5", 1796.049)
    # Just below the lower end of the lowest flank.
    check((of("base", "disc x") - 10.41)^2 + (of("base", "disc y") - 258.39)^2 < 1.3^2 &&
          of("base", "disc y") < 258.4, "the disc has its peak elsewhere")
    # In brackets: with the biquadratic elements of the studies.
    between("l_4", "share 3", 1.07, 1.11) # (1.093)
    between("l_4", "disc", 1.12, 1.19) # (1.156)
    between("l_4", "mean pressure 3", 0.84, 0.92) # (0.880)
    between("alpha_40", "blade", 0.80, 0.89) # (0.849)
    between("alpha_40", "slip 3", 1.45, 1.58) # (1.513)
    between("beta_45", "share 3", 1.08, 1.12) # (1.098)
    between("beta_45", "disc", 1.06, 1.12) # (1.087)
    between("gamma_0", "disc", 0.90, 0.96) # (0.933)
    between("gamma_0", "blade", 0.82, 0.90) # (0.857)
    between("mu_0.5", "blade", 1.20, 1.45) # (1.358)
    between("mu_0.5", "mean pressure 3", 0.80, 0.88) # (0.839)
    between("mu_0.5", "slip 3", 0.64, 0.74) # (0.688)
    exit failed
  }'
