#!/usr/bin/env bash
# The list of entries is that of the problem asked for, with its values:
# print_parameters.sh PROGRAM. Runs in the root of the project.
set -u
program=$1
failed=0

expect() { # what the list of these options has to contain
  local text=$1
  shift
  "$program" --print-parameters "$@" 2>&1 | grep -qE -- "$text" || {
    echo "--print-parameters $*: the list lacks: $text"
    failed=1
  }
}

expect 'set Formulation +=' # plane strain by default
expect 'subsection Rectangle'
expect 'set Formulation += three dimensional' --set 'Formulation=three dimensional'
expect 'subsection Half ball' --set 'Formulation=three dimensional'
expect 'allowed are plane strain' --set 'Formulation=flat'
file=tests/verification/flush_edges_3d.prm
expect 'subsection Body foot' $file
expect 'set Corners = 0, -3e-3, 0 ; 4e-3, 0, 0.6e-3' $file
expect 'set Step size += 0.125' $file --set 'Time/Step size=0.125'
expect 'subsection Pair foot.foot on base.top' $file

well_formed() { # the format, and the module of Python that reads it
  "$program" --print-parameters --format "$1" $file | python3 -c "import sys, $2" || {
    echo "--print-parameters --format $1 $file: not well-formed"
    failed=1
  }
}
well_formed xml 'xml.etree.ElementTree as x; x.parse(sys.stdin)'
well_formed json 'json; json.load(sys.stdin)["Contact"]["Pair foot.foot on base.top"]["Surface"]'

# What it lists is a .prm again.
listed=$(mktemp --suffix=.prm)
"$program" --print-parameters prm/cantilever_beam.prm >"$listed"
"$program" --check "$listed" >/dev/null || {
  echo "--print-parameters prm/cantilever_beam.prm: --check refuses the list."
  failed=1
}
rm -f "$listed"
exit $failed
