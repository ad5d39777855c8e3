#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs every fuzz target in build/fuzz/bin for SECONDS on a copy of its seeds: one line a target, failure if any crashes.
# Seeds: regression/shapes/io_corpus by extension, and corpus/TARGET/ here (inputs that once failed). Builds nothing:
#   cmake --preset fuzz && cmake --build --preset fuzz && regression/fuzz/run.sh 30
set -u
here=$(cd "$(dirname "$0")" && pwd)
bin=${FUZZ_BIN:-$here/../../build/fuzz/bin}
crashes=$(dirname "$bin")/crashes

copy_seeds() { # TARGET FOLDER
    local shapes=$here/../shapes/io_corpus kind=${1#fuzz_}
    if [ "$kind" = tetgen ]; then
        for nodes in "$shapes"/*.node; do
            { cat "$nodes"; printf '\0'; cat "${nodes%.node}.ele"; } > "$2/$(basename "$nodes")"
        done
    else
        find "$shapes" -name "*.$kind" -exec cp {} "$2" \;
    fi
    if [ -d "$here/corpus/$1" ]; then cp "$here/corpus/$1"/* "$2"; fi
}

run_one() { # TARGET SECONDS
    local folder options=() status=0
    folder=$(mktemp -d)
    mkdir "$folder/seeds"
    copy_seeds "$1" "$folder/seeds"
    if [ -f "$here/dictionaries/${1#fuzz_}.dict" ]; then options+=("-dict=$here/dictionaries/${1#fuzz_}.dict"); fi
    "$bin/$1" "$folder/seeds" -max_total_time="$2" -rss_limit_mb=2048 -timeout=25 -print_final_stats=1 -use_value_profile=1 \
        -artifact_prefix="$folder/" "${options[@]}" > "$folder/log" 2>&1 || status=$?
    local executions coverage
    executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/log")
    coverage=$(grep -o 'cov: [0-9]*' "$folder/log" | tail -1 | cut -d' ' -f2)
    if [ "$status" -eq 0 ]; then
        echo "$1: ${executions:-0} executions in $2 s, coverage ${coverage:-0}, no failure"
    else
        mkdir -p "$crashes"
        for input in "$folder"/{crash,oom,timeout,leak,slow-unit}-*; do
            if [ -f "$input" ]; then cp "$input" "$crashes/$1-$(basename "$input")"; fi
        done
        cp "$folder/log" "$crashes/$1.log"
        echo "$1: FAILED after ${executions:-0} executions, coverage ${coverage:-0}; inputs and log in $crashes"
        grep -E '^==|SUMMARY|runtime error|^    #[0-9] ' "$folder/log" | head -12
    fi
    rm -rf "$folder"
    return "$status"
}

if [ "${1:-}" = --one ]; then
    run_one "$2" "$3"
    exit
fi
if ! [[ ${1:-} =~ ^[1-9][0-9]*$ ]]; then
    echo "usage: regression/fuzz/run.sh SECONDS" >&2
    exit 2
fi
targets=$(cd "$bin" 2> /dev/null && ls fuzz_* 2> /dev/null)
if [ -z "$targets" ]; then
    echo "run.sh: no fuzz targets in $bin; build them: cmake --preset fuzz && cmake --build --preset fuzz" >&2
    exit 1
fi
# xargs returns 123 if a target failed.
echo "$targets" | xargs -P "${FUZZ_JOBS:-$(nproc)}" -I{} "$0" --one {} "$1"
