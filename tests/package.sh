#!/usr/bin/env bash
# The Debian package holds a program that runs, with its examples, from wherever
# it is unpacked: package.sh BUILD_FOLDER SCRATCH
set -eu
build=$1
scratch=$2
rm -rf "$scratch"
mkdir -p "$scratch"
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$scratch" >"$scratch/log" 2>&1 || {
  cat "$scratch/log"
  exit 1
}
package=$(find "$scratch" -maxdepth 1 -name 'signorini_*.deb')
dpkg-deb --field "$package" Depends | grep -q 'libdeal.ii-9' || {
  echo "$package does not depend on deal.II."
  exit 1
}
dpkg-deb --extract "$package" "$scratch/root"
"$scratch/root/usr/bin/signorini" "$scratch/root/usr/share/signorini/prm/tutorial/seal.prm" \
  --threads 1 --output-directory "$scratch/results"
