#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# fit_targets.sh DATA: fits to real targets, and prints a row of docs/performance.md for each. DATA has those that the
# repository does not carry, under committable/ and local/; what is not there is left out, with a word.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
program=$here/../../build/release/bin/solidsubdiv
[[ $# -eq 1 && -x $program ]] || { sed -n '3,4s/^# //p' "$0" >&2; exit 2; }
data=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# row NAME TARGET ARGUMENT...
row() {
    local name=$1 target=$2
    shift 2
    [[ -e $target ]] || { echo "$name: $target is not there" >&2; return; }
    "$program" fit "$target" -o "$work/out" --no-pictures --quiet "$@" || { echo "| $name | failed |"; return; }
    python3 - "$name" "$work/out/fit.json" <<'P'
import json, sys
d = json.load(open(sys.argv[2]))
there, back = d["fit"]["surface_to_target"], d["fit"]["target_to_surface"]
pair = lambda key: "%.3g, %.3g" % (there[key + "_percent"], back[key + "_percent"])
folded = str(d["solid"]["folded"]) if "solid" in d else ""
model = {"solid": "solid", "surface": "cage"}[d["settings"]["model"]]
print("| %s | %s, %d | %s | %s | %s | %s | %.1f s |" % (sys.argv[1], model, d["control"]["points"], pair("rms"),
      pair("p99"), pair("max"), folded, d["seconds"]["sum"]), flush=True)
P
    rm -rf "$work/out"
}

echo "| target | control points | RMS, % | 99 % below, % | largest, % | folded cells | time |"
echo "|---|---|---|---|---|---|---|"
row "bunny" "$here/../shapes/demo/bunny.obj" --control 400
row "bunny" "$here/../shapes/demo/bunny.obj" --control 450
row "bunny, Loop" "$here/../shapes/demo/bunny.obj" --model surface --control 400
row "bunny, Catmull-Clark" "$here/../shapes/demo/bunny.obj" --model surface --scheme catmull-clark --control 400
row "bunny, modified butterfly" "$here/../shapes/demo/bunny.obj" --model surface --scheme modified-butterfly --control 400
row "bunny, tets" "$here/../shapes/demo/bunny.obj" --scheme box-spline --control 400
row "part (genus 1), creases" "$data/committable/netgen_part1.stl" --model surface --control 400
row "hinge (genus 5), creases" "$data/committable/netgen_hinge.stl" --model surface --control 400
row "bracket (genus 2), creases" "$data/committable/occt_sh1.stl" --model surface --control 400
row "mechpart (genus 3), creases" "$data/local/surfaces/hoppe_mechpart.recon.obj" --model surface --control 400
row "part, creases" "$data/committable/netgen_part1.stl" --control 400
row "hinge, creases" "$data/committable/netgen_hinge.stl" --control 400
row "mechpart, creases" "$data/local/surfaces/hoppe_mechpart.recon.obj" --control 400
row "caudate nucleus, label 1" "$data/committable/derived_aal_caudate_crop.nii.gz" --label 1 --control 200
if [[ -e $data/local/surfaces/ode_human_woman.obj ]]; then
    python3 "$here/cut_head.py" "$data/local/surfaces/ode_human_woman.obj" "$work/head.obj"
fi
row "head with four holes" "$work/head.obj" --model solid --control 450
row "head with four holes" "$work/head.obj" --control 400
row "cactus, 3,320 points" "$data/local/points/hoppe_cactus.pts" --control 400
row "koala, 50,000 vertices" "$data/local/surfaces/ode_koala.obj" --control 450
if [[ -e $data/local/surfaces/cino_blub_triangulated.obj ]]; then
    "$program" refine "$data/local/surfaces/cino_blub_triangulated.obj" -o "$work/blub.obj" --scheme linear-surface \
        --levels 2 --quiet
fi
row "blub, 113,666 vertices" "$work/blub.obj" --control 450
