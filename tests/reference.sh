#!/usr/bin/env bash
# doc/reference is what the program writes, and the links of its page lead
# somewhere: reference.sh PROGRAM SCRATCH. Runs in the root of the project.
set -u
program=$1
scratch=$2
kept=doc/reference
rm -rf "$scratch"
"$program" --write-reference "$scratch" || exit 1
diff -r "$kept" "$scratch" >"$scratch.diff" || {
  head -n 20 "$scratch.diff" | cut -c 1-300
  echo "$kept is not what the program writes: an entry, its text, or a mesh has changed."
  echo "Write it again, and commit it: rm -r $kept && scripts/run --write-reference $kept"
  exit 1
}

failed=0
"$program" --write-reference "$scratch.diff" 2>&1 | grep -q 'cannot be written to: Not a directory' || {
  echo "--write-reference of what is a file: another message is expected."
  failed=1
}
page=$kept/reference.html
while IFS= read -r link; do
  case $link in
    \#*) grep -q "id=\"${link#\#}\"" "$page" ;;
    *) [ -e "$kept/${link%%#*}" ] ;;
  esac || {
    echo "$page: the link $link leads nowhere."
    failed=1
  }
done < <(grep -oE '(href|src)="[^"]*"' "$page" | sed -E 's/^[a-z]+="//; s/"$//' | sort -u)
exit $failed
