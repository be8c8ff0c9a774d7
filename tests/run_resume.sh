#!/usr/bin/env bash
# A run that is stopped and resumed gives the results of one that is not, bit
# for bit: run_resume.sh PROGRAM FILE.prm SCENARIO SCRATCH
#
#   steps       stopped twice by --steps
#   signal      stopped by SIGTERM, resumed by the command line it prints
#   meshes      the same, while meshes are being found
#   kill        killed at random moments until it is done
#   full_disk   stopped by a disk without room
#   damaged     the last checkpoint is cut short: the one before is taken
#   no_room     checkpoints cannot be written, which stops nothing
set -u
program=$1
prm=$2
scenario=$3
scratch=$4
name=$(basename "$prm" .prm)
whole=$scratch/whole/$name
stopped=$scratch/stopped/$name
output=$scratch/output

fail() {
  echo "$prm, $scenario: $1"
  if [ -s "$output" ]; then printf 'The output was:\n%s\n' "$(<"$output")"; fi
  exit 1
}

# The run, with these options, into the folder `stopped'.
run() {
  "$program" "$prm" --threads 1 --output-directory "$scratch/stopped" "$@" >"$output" 2>&1
}

expect_exit() {
  [ "$1" = "$2" ] || fail "exit code $1, expected $2."
}

expect_output() {
  grep -qF -- "$1" "$output" || fail "the output lacks: $1"
}

# A table ends with a whole row, and every row has all columns.
expect_readable() {
  awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' "$stopped/history.csv" &&
    [ -z "$(tail -c 1 "$stopped/history.csv")" ] || fail "history.csv cannot be read."
  local file
  for file in $(sed -n 's/.* file="\([^"]*\)".*/\1/p' "$stopped"/*.pvd); do
    tail -c 20 "$stopped/$file" | grep -q '</VTKFile>' || fail "$file is not whole."
  done
}

# Everything but the log with its seconds, and the list of the files with those that went.
expect_equal() {
  diff -r -q -x run.log -x '*.checkpoint' -x .signorini-files "$whole" "$stopped" >"$output" || fail "the results differ."
}

# Ends the run when this file of its results is there.
stop_by_signal() {
  local pid code=0
  # Once more if the run was over before the signal came.
  for _ in {1..10}; do
    rm -rf "$scratch/stopped"
    "$program" "$prm" --threads 1 --output-directory "$scratch/stopped" >"$output" 2>&1 &
    pid=$!
    while [ ! -e "$stopped/$1" ] && kill -0 $pid 2>/dev/null; do sleep 0.01; done
    kill -TERM $pid 2>/dev/null
    wait $pid
    code=$?
    [ $code = 0 ] || break
  done
  expect_exit $code 130
}

# As the program says that the run can go on.
go_on() {
  local command
  command=$(sed -n 's/^Stopped as asked\..* To go on: //p' "$output")
  [ -n "$command" ] || fail "no command to go on."
  bash -c "$command" >"$output" 2>&1
  expect_exit $? 0
}

# Milliseconds.
now() { date +%s%3N; }
pause() { sleep "$(printf '%d.%03d' $(($1 / 1000)) $(($1 % 1000)))"; }

rm -rf "$scratch"
mkdir -p "$scratch"
begin=$(now)
"$program" "$prm" --threads 1 --output-directory "$scratch/whole" >"$output" 2>&1 ||
  fail "the run itself failed."
duration=$(($(now) - begin))

case $scenario in
  steps)
    run --steps 5
    expect_exit $? 0
    expect_output "to go on: $program $prm --threads 1 --resume-from $stopped"
    expect_readable
    run --resume --steps 7
    expect_exit $? 0
    run --resume
    expect_exit $? 0
    expect_equal
    # Nothing is left to do: the checks are made once more.
    run --resume
    expect_exit $? 0
    ;;
  signal)
    stop_by_signal last.checkpoint
    expect_readable
    go_on
    expect_equal
    ;;
  meshes)
    stop_by_signal meshes.csv
    expect_output "The meshes found so far are kept."
    n_meshes=$(grep -c "mesh [0-9]*:" "$stopped/run.log")
    go_on
    expect_output "resumed at mesh $((n_meshes + 1))"
    expect_equal
    ;;
  kill)
    n_kills=0
    options=()
    code=1
    while [ $code != 0 ]; do
      "$program" "$prm" --threads 1 --output-directory "$scratch/stopped" "${options[@]}" >"$output" 2>&1 &
      pid=$!
      # Until the end once it was killed often enough.
      if [ $n_kills -lt 6 ]; then
        pause $((duration / 4 + RANDOM % (duration / 2)))
        if kill -KILL $pid 2>/dev/null; then n_kills=$((n_kills + 1)); fi
      fi
      wait $pid 2>/dev/null
      code=$?
      [ $code = 0 ] || [ $code = 137 ] || fail "exit code $code."
      # Too early an end, if the whole run was made on a busier machine: anew.
      if [ $code = 0 ] && [ $n_kills -lt 2 ] && [ $duration -gt 50 ]; then
        duration=$((duration / 2))
        n_kills=0
        code=1
        options=(--overwrite)
        continue
      fi
      if ls "$stopped"/*.checkpoint >/dev/null 2>&1; then
        options=(--resume)
      else
        options=(--overwrite)
      fi
    done
    echo "killed $n_kills times"
    [ $n_kills -gt 1 ] || fail "killed $n_kills times only."
    expect_equal
    ;;
  full_disk)
    # Room for four fifths of the table. MPI wants files, too, unless told not to.
    blocks=$(($(stat -c %s "$whole/history.csv") * 4 / 5 / 1024))
    (
      ulimit -f $blocks
      export PMIX_MCA_gds=hash
      run
    )
    expect_exit $? 3
    expect_output "cannot be written any more: File too large"
    expect_output "to go on from the last checkpoint: $program $prm --threads 1 --resume-from $stopped"
    expect_readable
    run --resume
    expect_exit $? 0
    expect_equal
    ;;
  damaged)
    run --steps 12 --set "Output/Steps between checkpoints=5"
    [ -e "$stopped/previous.checkpoint" ] || fail "there is one checkpoint only."
    truncate --size=-1 "$stopped/last.checkpoint"
    run --resume
    expect_exit $? 0
    expect_output "last.checkpoint' is damaged: it is cut short. An older one is taken."
    expect_equal
    ;;
  no_room)
    mkdir -p "$stopped"
    ln -s /dev/full "$stopped/new.checkpoint"
    run --overwrite
    expect_exit $? 0
    expect_output "last.checkpoint' cannot be written: No space left on device."
    expect_equal
    ;;
  *)
    fail "unknown scenario."
    ;;
esac
