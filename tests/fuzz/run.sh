#!/bin/sh
# Runs one fuzzer for LIMES_FUZZ_SECONDS (default 60) from the small hostile files of its format.
# Usage: run.sh FUZZER FORMAT FUZZ_DIR HOSTILE_DIR
# Each input may take two seconds and 1 GiB. A finding stays in ./fuzz-FORMAT/findings.
# LIMES_FUZZ_SEED (default 1) chooses the sequence of inputs: the same one in every test run; others to search.
set -eu
fuzzer=$1 format=$2 here=$3 hostile=$4
work=fuzz-$format
mkdir -p "$work/corpus" "$work/seeds" "$work/findings"
find "$hostile" -name "*.$format" -size -9k -exec cp {} "$work/seeds/" \;
exec "$fuzzer" "$work/corpus" "$work/seeds" -dict="$here/$format.dict" \
  -seed="${LIMES_FUZZ_SEED:-1}" -max_total_time="${LIMES_FUZZ_SECONDS:-60}" -max_len=16384 \
  -rss_limit_mb=1024 -timeout=2 \
  -artifact_prefix="$work/findings/" -print_final_stats=1
