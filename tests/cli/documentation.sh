#!/usr/bin/env bash
# Runs every ```sh block of a Markdown file: documentation.sh PROGRAM ROOT FILE.md
# Every line must succeed; `limes` is PROGRAM, the folder is ROOT, $OUT a temporary folder.
set -euo pipefail
program=$1 root=$2 page=$3
OUT=$(mktemp -d)
trap 'rm -rf "$OUT"' EXIT
limes() { "$program" "$@"; }
cd "$root"
script=$(awk '/^```sh$/ {on = 1; next} /^```$/ {on = 0} on' "$page")
[ -n "$script" ] || { echo "$page: no sh block"; exit 1; }
while IFS= read -r line; do
  [ -n "$line" ] || continue
  echo "\$ $line"
  eval "$line" || { echo "$page: failed: $line"; exit 1; }
done <<<"$script"
