#!/usr/bin/env bash
# The main job, from a built tree: hull mesh -> database -> Bullet in a seaway -> CSV and pictures.
# usage: demos/run_demo.sh BUILD_DIR [OUT_DIR]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
out=${2:-$root/out/demo}
mkdir -p "$out"
cutwater=$build/cutwater
database=$out/frigate.h5
say() { printf '\n== %s\n' "$*"; }

if [ -e "$database" ] && [ "$database" -nt "$cutwater" ] && [ "$database" -nt "$root/meshes/frigate/ship.toml" ]; then
  say "database is there: $database"
else
  say "solve: frigate, 433 panels a side, 60 frequencies, 13 headings"
  "$cutwater" solve "$root/meshes/frigate/ship.toml" -o "$database"
fi
"$cutwater" info "$database" | head -n 12

say "simulate: irregular sea from 150 deg, ten minutes in Bullet"
"$cutwater" simulate "$root/demos/runs/irregular_150.toml" -o "$out/run.csv"
gnuplot -e "in='$out/run.csv'; out='$out/run.png'" "$root/demos/plot_run.gp"

for beta in 030 090 150 180; do
  say "sweep: regular waves, heading ${beta#0} deg, Bullet beside the frequency domain"
  "$cutwater" sweep "$root/demos/runs/sweep_$beta.toml" -o "$out/sweep_$beta.csv"
  "$cutwater" rao "$database" --heading "${beta#0}" --omega 0.2:2:361 -o "$out/rao_$beta.csv"
  gnuplot -e "in='$out/sweep_$beta.csv'; rao='$out/rao_$beta.csv'; out='$out/sweep_$beta.png'; name='${beta#0} deg'" "$root/demos/plot_sweep.gp"
done
for beta in 030 150; do
  say "sweep: regular waves at 20 knots, heading ${beta#0} deg"
  "$cutwater" sweep "$root/demos/runs/sweep_20kn_$beta.toml" -o "$out/sweep_20kn_$beta.csv"
  "$cutwater" rao "$database" --speed 10.2889 --heading "${beta#0}" --omega 0.2:2:361 -o "$out/rao_20kn_$beta.csv"
  gnuplot -e "in='$out/sweep_20kn_$beta.csv'; rao='$out/rao_20kn_$beta.csv'; out='$out/sweep_20kn_$beta.png'; name='${beta#0} deg, 20 knots'" "$root/demos/plot_sweep.gp"
done
cp "$out/sweep_150.csv" "$out/sweep.csv"
cp "$out/sweep_150.png" "$out/sweep.png"

say "done; what to look at:"
echo "  $out/run.png         motions in the irregular sea (run.csv)"
echo "  $out/sweep_*.png     Bullet's points lie on the frequency domain's lines (sweep_*.csv)"
