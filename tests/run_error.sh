#!/usr/bin/env bash
# A wrong input is refused in words: run_error.sh PROGRAM FILE.prm SCRATCH
#
# Comment lines at the beginning of the file say what has to happen:
#   # expect: TEXT    must occur in the output; as many lines as needed
#   # exit: 3         the exit code; without this line 1, and found by --check
#   # run: yes        run, do not check
#   # output: DIR     run, do not check, with the results in DIR
#   # full: FILE      no byte can be written to this file of the results
#   # first: OPTIONS  a run with these options comes first; the test resumes it
#   # spoil: COMMAND  what happens in the folder of its results in between
#   # options: TEXT   further options of the run that is refused
set -u
program=$1
prm=$2
scratch=$3
failed=0

fail() {
  echo "$prm: $1"
  failed=1
}

header() {
  sed -n "s/^# *$1: *//p" "$prm"
}

code=$(header exit | head -n 1)
folder=$(header output | head -n 1)
full=$(header full | head -n 1)
first=$(header first | head -n 1)
run=$(header run | head -n 1)
results=$scratch/$(basename "$prm" .prm)
options=(--threads 1 --output-directory "${folder:-$scratch}")
# A wrong input has to be found before anything is computed.
if [ "${code:-1}" = 1 ] && [ -z "$folder$first$run" ]; then options+=(--check); fi
# An entry may have blanks, so that quotes in the header count.
eval "options+=($(header options | head -n 1))"

# What stands in the folder of a run, but for its name.
contents() {
  (cd "$results" && sha256sum -- *)
}

rm -rf "$scratch"
if [ -n "$first" ]; then
  eval "\"$program\" \"$prm\" --threads 1 --output-directory \"$scratch\" $first" >"$scratch.log" 2>&1 ||
    fail "the first run failed: $(<"$scratch.log")"
  rm -f "$scratch.log"
  spoil=$(header spoil)
  (cd "$results" && eval "$spoil")
  options+=(--resume)
  before=$(contents)
fi
if [ -n "$full" ]; then
  mkdir -p "$results"
  ln -s /dev/full "$results/$full"
  options+=(--overwrite)
fi
output=$("$program" "$prm" "${options[@]}" 2>&1)
found=$?
[ "$found" = "${code:-1}" ] || fail "exit code $found, expected ${code:-1}."

expected=$(header expect)
[ -n "$expected" ] || fail "has no line \"# expect: TEXT\"."
while IFS= read -r text; do
  grep -qF -- "$text" <<<"$output" || fail "the output lacks: $text"
done <<<"$expected"

if grep -qE 'dealii::|std::|terminate called|An error occurred in line|Stacktrace' <<<"$output"; then
  fail "the message speaks C++."
fi
if [ -n "$first" ]; then
  [ "$before" = "$(contents)" ] || fail "a refused input has changed files in $results."
elif [ "${code:-1}" = 1 ] && [ -z "$run" ] && [ -e "$scratch" ]; then
  fail "a refused input has left files in $scratch."
fi

if [ "$failed" = 1 ]; then printf 'The output was:\n%s\n' "$output"; fi
exit "$failed"
