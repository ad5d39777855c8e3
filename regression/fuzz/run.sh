#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs every fuzz target in build/fuzz/bin for SECONDS on a copy of its seeds: one line a target, failure if any crashes.
# Seeds: regression/shapes/io_corpus by extension, corpus/TARGET/ here (inputs that once failed) and corpus/TARGET.tar.gz
# (the smallest set that covers what long runs found). Builds nothing:
#   cmake --preset fuzz && cmake --build --preset fuzz && regression/fuzz/run.sh 30
# FUZZ_KEEP=FOLDER keeps what was found in FOLDER/TARGET for the next run, and adds up: SECONDS are then those of the
# processor, and each target runs until it has had as many in all, ten minutes at a time: what is cut off loses no more.
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
    elif [ "$kind" = points ]; then
        cp "$shapes"/points_* "$2"
    elif [ "$kind" = volumes ]; then
        cp "$shapes"/volume_* "$2"
    else
        find "$shapes" -name "*.$kind" -exec cp {} "$2" \;
    fi
    if [ -d "$here/corpus/$1" ]; then cp "$here/corpus/$1"/* "$2"; fi
    if [ -f "$here/corpus/$1.tar.gz" ]; then tar -xzf "$here/corpus/$1.tar.gz" -C "$2"; fi
}

# Sums of what runs wrote down: seconds of the processor, executions.
totals() { # FOLDER
    if [ -f "$1/runs" ]; then awk '{seconds += $1 + $2; executions += $3} END {printf "%d %d", seconds, executions}' "$1/runs"
    else echo "0 0"; fi
}

run_one() { # TARGET SECONDS
    local folder options=() status=0 executions coverage seconds=$2 slice=$2 timeout=25 had=0 used
    if [ -n "${FUZZ_KEEP:-}" ]; then
        folder=$FUZZ_KEEP/$1
        timeout=300  # of the clock, which runs on where others have the processor
        read -r had _ <<< "$(totals "$folder")"
        seconds=$(($2 - had))
    else
        folder=$(mktemp -d)
    fi
    if [ ! -d "$folder/seeds" ]; then
        mkdir -p "$folder/seeds"
        copy_seeds "$1" "$folder/seeds"
    fi
    if [ -f "$here/dictionaries/${1#fuzz_}.dict" ]; then options+=("-dict=$here/dictionaries/${1#fuzz_}.dict"); fi
    while [ "$seconds" -gt 0 ] && [ "$status" -eq 0 ]; do
        TIMEFORMAT='%U %S'
        if [ -n "${FUZZ_KEEP:-}" ]; then slice=$((seconds < 600 ? seconds : 600)); fi
        used=$({ time "$bin/$1" "$folder/seeds" -max_total_time="$slice" -rss_limit_mb=2048 -timeout="$timeout" \
            -print_final_stats=1 -use_value_profile=1 -artifact_prefix="$folder/" "${options[@]}" > "$folder/log" 2>&1; } 2>&1) \
            || status=$?
        executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/log")
        coverage=$(grep -o 'cov: [0-9]*' "$folder/log" | tail -1 | cut -d' ' -f2)
        echo "$used ${executions:-0} ${coverage:-0}" >> "$folder/runs"
        if [ -z "${FUZZ_KEEP:-}" ]; then break; fi
        read -r had _ <<< "$(totals "$folder")"
        seconds=$(($2 - had))
    done
    read -r had executions <<< "$(totals "$folder")"
    coverage=$(tail -1 "$folder/runs" | cut -d' ' -f4)
    if [ "$status" -eq 0 ]; then
        echo "$1: $executions executions in $had s of the processor, coverage $coverage, no failure"
    else
        mkdir -p "$crashes"
        for input in "$folder"/{crash,oom,timeout,leak,slow-unit}-*; do
            if [ -f "$input" ]; then cp "$input" "$crashes/$1-$(basename "$input")"; fi
        done
        cp "$folder/log" "$crashes/$1.log"
        echo "$1: FAILED after $executions executions, coverage $coverage; inputs and log in $crashes"
        grep -E '^==|SUMMARY|runtime error|^    #[0-9] ' "$folder/log" | head -12
    fi
    if [ -z "${FUZZ_KEEP:-}" ]; then rm -rf "$folder"; fi
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
