#!/usr/bin/env bash
# scripts/study runs, marks what fails, and repeats only what has to be repeated;
# scripts/profile reads what was written:
# run.sh PROGRAM SCRATCH
set -u
program=$1
scratch=$2
failed=0
summary=$scratch/bar/summary.csv

fail() {
  echo "$1"
  failed=1
}

# study CODE FILE: run it; its output goes to $output.
study() {
  output=$(scripts/study "$2" --jobs 2 --program "$program" --output-directory "$scratch" 2>&1)
  local found=$?
  [ "$found" = "$1" ] || fail "exit code $found, expected $1: $output"
}

# cell RUN COLUMN, of a row without quoted commas
cell() {
  awk -F, -v run="$1" -v column="$2" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == column) c = i }
    $1 == run { print $c }' "$summary"
}

rm -rf "$scratch"
mkdir -p "$scratch"
study 3 tests/study/bar.study
[[ $output == *"3 runs, 0 of them finished before"* ]] || fail "first call: $output"
[ "$(cell base state)" = done ] || fail "base is '$(cell base state)'."
[ "$(cell held state)" = done ] || fail "held is '$(cell held state)'."
[[ $(cell wrong state) == *"failed (1): "* ]] || fail "wrong is '$(cell wrong state)'."
[ -z "$(cell wrong 'touch [s]')" ] || fail "a failed run has a value."
[ -z "$(cell base 'never [s]')" ] || fail "a time that never comes has a value."
# Truth: 5 m at 10 m/s; rho c v = 30 Pa s/m times 10 m/s.
awk -v t="$(cell base 'touch [s]')" -v p="$(cell base 'pressure [Pa]')" \
  'BEGIN { exit !((t - 0.5)^2 < 0.007^2 && (p - 300)^2 < 3^2) }' || fail "wrong values."
# 12 m/s: 360 Pa.
awk -v p="$(cell held 'pressure [Pa]')" 'BEGIN { exit !((p - 360)^2 < 5^2) }' ||
  fail "held has the pressure $(cell held 'pressure [Pa]'), expected 360 Pa."
grep -q 'top: y | bottom: y' "$scratch/bar/held.prm" || fail "a quoted cell was lost."

# A profile has what the program itself finds at a node at the end.
scripts/profile "$scratch/bar/base/results.pvd" bar stress_xx --from 1,0 --to 10,0 --after 1.5 |
  awk -F, -v s="$(cell base 'stress [Pa]')" '
    $1 == 3 { found = 1; good = ($3 - s)^2 <= (1e-5*s)^2 && s != 0 }
    END { exit !(found && good && NR == 47) }' || fail "the profile differs from the stress."

# Only what failed, and what has no mark, is repeated.
rm "$scratch/bar/held/finished"
study 3 tests/study/bar.study
[[ $output == *"3 runs, 1 of them finished before"* && $output != *"base: done"* ]] ||
  fail "second call: $output"

# A changed row is repeated, and a mended one comes right.
mkdir "$scratch/changed" "$scratch/verification"
cp prm/verification/bar_meets_wall.prm "$scratch/verification"
sed -e 's/| -1 /| 1e-2 /' -e "s|^base = .*|base = $PWD/tests/verification/bar_meets_wall.prm|" \
  tests/study/bar.study >"$scratch/changed/bar.study"
study 0 "$scratch/changed/bar.study"
[[ $output == *"3 runs, 2 of them finished before"* && $output == *"wrong: done"* ]] ||
  fail "third call: $output"

# So is everything when the base changes: here one that it includes.
cp tests/verification/bar_meets_wall.prm "$scratch/changed/base.prm"
sed -i "s|^include .*|include ../verification/bar_meets_wall.prm|" "$scratch/changed/base.prm"
sed -i 's/^base = .*/base = base.prm/' "$scratch/changed/bar.study"
study 0 "$scratch/changed/bar.study"
study 0 "$scratch/changed/bar.study"
[[ $output == *"3 of them finished before"* ]] || fail "unchanged base: $output"
echo "# a comment changes nothing" >>"$scratch/verification/bar_meets_wall.prm"
study 0 "$scratch/changed/bar.study"
[[ $output == *"3 of them finished before"* ]] || fail "a comment: $output"
echo "set Title = another" >>"$scratch/verification/bar_meets_wall.prm"
study 0 "$scratch/changed/bar.study"
[[ $output == *"0 of them finished before"* ]] || fail "changed base: $output"

# An interrupted run is marked as such, and repeated.
sed -i 's/^base  .*/base  | | 1e-5 |/' "$scratch/changed/bar.study"
scripts/study "$scratch/changed/bar.study" --program "$program" --output-directory "$scratch" \
  >/dev/null 2>&1 &
sleep 3
kill -TERM $!
wait $!
found=$?
[ "$found" = 130 ] || fail "interrupted: exit code $found, expected 130."
[ "$(cell base state)" = interrupted ] || fail "the interrupted run is '$(cell base state)'."

# What cannot be read is refused.
sed 's/^held .*/held | 1/' tests/study/bar.study >"$scratch/changed/short.study"
study 1 "$scratch/changed/short.study"
[[ $output == *"line 10: Run 'held' has 1 values"* ]] || fail "short row: $output"

exit "$failed"
