#!/bin/bash
# Runs libFuzzer targets one after the other, each for so many seconds, from the seeds of tests/fuzz/corpus.
#   tests/fuzz/run.sh SECONDS [NAME...]     names as in tests/fuzz/CMakeLists.txt; none: all that are built
# What is found new is kept in build/fuzz/found/NAME; an input that breaks a target is left there as crash-*, timeout-*.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
seconds=${1:?use: tests/fuzz/run.sh SECONDS [NAME...]}
shift
names=("$@")
if ((${#names[@]} == 0)); then
  for binary in "$root"/build/fuzz/fuzz_*; do
    [[ -x $binary && -f $binary ]] && names+=("${binary##*/fuzz_}")
  done
fi
failed=0
for name in "${names[@]}"; do
  case $name in
    read_*) seeds=("$root/tests/fuzz/corpus/${name#read_}") ;;
    run | convert) seeds=("$root"/tests/fuzz/corpus/{fanuc,sinumerik}) ;;
    *) seeds=("$root/tests/fuzz/corpus/$name") ;;
  esac
  found=$root/build/fuzz/found/$name
  mkdir -p "$found"
  echo "== $name"
  nice -n 19 "$root/build/fuzz/fuzz_$name" -max_total_time="$seconds" -rss_limit_mb=2048 -timeout=10 -max_len=4096 \
    -print_final_stats=1 -artifact_prefix="$found/" "$found" "${seeds[@]}" >"$found.log" 2>&1 || failed=1
  grep -E 'broken property|ERROR|SUMMARY|Test unit written|stat::number_of_executed_units' "$found.log" || true
done
exit "$failed"
