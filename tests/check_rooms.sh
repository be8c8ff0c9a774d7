#!/usr/bin/env bash
# Which room may know which: the rules of doc/architecture.md, checked by the
# includes of every file. Also: every source is listed in its CMakeLists.txt.
set -u
cd "$(dirname "$0")/.."
failed=0

fail() {
  echo "$1"
  failed=1
}

elements='deal\.II/(dofs|fe|grid|hp|matrix_free|meshworker|numerics)/'
solvers='cholmod|umfpack|deal\.II/lac/(sparse_direct|solver_|precondition|trilinos)|Epetra|[</"]ml_'

# room, what it may include of other rooms, library headers it must not include
check() {
  local room=$1 rooms=$2 forbidden=$3 file line
  [ -d "source/$room" ] || fail "source/$room: the room is missing."
  while IFS= read -r line; do
    file=${line%%:*}
    case $line in
      *[\<\"]signorini/"$room"/*) ;;
      *[\<\"]signorini/*/*)
        grep -qE "[<\"]signorini/($rooms)" <<<"$line" ||
          fail "$file: ${line#*:} is not for $room/."
        ;;
      *)
        ! grep -qE "$forbidden" <<<"${line#*:}" ||
          fail "$file: ${line#*:} is not for $room/."
        ;;
    esac
  done < <(grep -rE '^ *# *include' "source/$room" "include/signorini/$room")
}

check input '-' "$elements|$solvers"
check time 'input/' "$elements"
check curves 'input/' "$elements|$solvers|deal\.II/grid/"
check geometry 'input/' 'deal\.II/(dofs|lac|matrix_free|meshworker)/'
check material 'input/' "$elements|$solvers"
check variational_inequality 'input/' "$elements|$solvers"
check linear_algebra 'input/|variational_inequality/interface_(stiffness|types)\.h' 'deal\.II/(fe|grid|hp|meshworker)/'
check solid '(input|geometry|material|time|linear_algebra)/' 'cholmod'
check contact '(input|curves|geometry|solid)/|variational_inequality/interface_(problem|types)\.h|linear_algebra/types\.h' "$solvers"
check output '(input|geometry|solid|contact|time)/|linear_algebra/types\.h' "$solvers"
check dynamics '(input|time|linear_algebra|variational_inequality|solid|contact|output)/' "$solvers|deal\.II/(fe|meshworker|matrix_free)/"
check run '[a-z_]+/|version\.h' "$solvers|deal\.II/(fe|meshworker|matrix_free)/"

while IFS= read -r line; do
  grep -qE '<(signorini/(run/|input/input_error\.h)|deal\.II/base/|[a-z_]+>)' <<<"$line" ||
    fail "source/main.cc: $line is not for the top floor."
done < <(grep -E '^ *# *include' source/main.cc)

# A file that no list names would be neither compiled nor tested.
for file in source/*/*.cc source/*/*/*.cc source/*.cc; do
  name=$(basename "$file")
  [ "$file" = source/main.cc ] || grep -qrE "(^|[ /])$name( |\$|\))" source --include=CMakeLists.txt ||
    fail "$file: is in no CMakeLists.txt."
done
for file in tests/unit/*.cc; do
  name=$(basename "$file" .cc)
  grep -qE "^ *$name\$|[( ]$name\.cc" tests/unit/CMakeLists.txt ||
    fail "$file: is not in tests/unit/CMakeLists.txt."
done
exit "$failed"
