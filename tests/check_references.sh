#!/usr/bin/env bash
# Citations and links resolve: every [Key, eq. n] in sources and documents is an
# entry of doc/references.bib, each entry is cited, and each relative link of a
# document leads to a file and, where it names one, to a heading in it.
set -u
cd "$(dirname "$0")/.."
failed=0

fail() {
  echo "$1"
  failed=1
}

bibliography=doc/references.bib
key='MC|[A-Z][A-Za-z]+(19|20)[0-9]{2}[a-z]?'
entries=$(sed -nE 's/^@[a-z]+\{([^,]+),$/\1/p' "$bibliography" | sort)
[ -z "$(uniq -d <<<"$entries")" ] || fail "$bibliography: doubled: $(uniq -d <<<"$entries" | xargs)"
while IFS= read -r entry; do
  grep -qxE "$key" <<<"$entry" || fail "$bibliography: $entry is no key: AuthorAuthorYear, or MC."
done <<<"$entries"

# A citation may go over the end of a line, and there may be several in a bracket.
text() {
  sed -E 's/^ *(\*|\/\/|#) ?//' "$1" | tr '\n' ' '
}

mapfile -t files < <(grep -rlE "$key" include source doc prm tests README.md CONTRIBUTING.md \
  --include='*.h' --include='*.cc' --include='*.md' --include='*.prm' --include='*.py' | sort)
used=''
for file in "${files[@]}"; do
  while IFS= read -r found; do
    used+="$found"$'\n'
    grep -qx "$found" <<<"$entries" || fail "$file: [$found] is not in $bibliography."
  done < <(text "$file" | grep -oE '\[[^][]*\]' |
    grep -oE "(^\[|; *|[Cc]f\. *)($key)" | grep -oE "($key)\$" | sort -u)
done
while IFS= read -r entry; do
  grep -qx "$entry" <<<"$used" || fail "$bibliography: $entry is cited nowhere."
done <<<"$entries"

# Sources and years in other words would escape.
while IFS= read -r line; do
  fail "$line: cite as [Key, eq. n]."
done < <(grep -rnoE '[A-Z][a-z]+,? \(?(19|20)[0-9]{2}[],;.)]' include source --include='*.h' --include='*.cc')

# The anchors of a document, as GitHub makes them of its headings.
anchors() {
  sed -nE '/^ *```/,/^ *```/d; s/^#+ +//p' "$1" | tr '[:upper:]' '[:lower:]' |
    sed -E 's/[^a-z0-9 _-]//g; s/ /-/g'
}

# What runs have left below output/ is theirs.
mapfile -t documents < <(find . -path ./output -prune -o -path './build*' -prune -o -path './.git' -prune -o \
  -name '*.md' -printf '%P\n' | sort)
for file in "${documents[@]}" output/README.md; do
  while IFS= read -r link; do
    case $link in *://* | mailto:*) continue ;; esac
    path=${link%%#*}
    target=$file
    [ -z "$path" ] || target=$(dirname "$file")/$path
    if [ ! -e "$target" ]; then
      fail "$file: the link $link leads nowhere."
    elif [ "$path" != "$link" ]; then
      anchors "$target" | grep -qx -- "${link#*#}" || fail "$file: no heading for the link $link."
    fi
  done < <(grep -oE '\]\([^) ]+\)' "$file" | sed -E 's/^\]\(//; s/\)$//')
done
exit "$failed"
