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
# run_file NAME COPY: a run file of demos/runs, copied beside the database that it is to read.
run_file() {
  sed 's|^database = .*|database = "frigate.h5"|' "$root/demos/runs/$1.toml" >"$out/$2.toml"
  printf '%s' "$out/$2.toml"
}

ship=$root/meshes/frigate/ship.toml
if [ -e "$database" ] && [ "$database" -nt "$cutwater" ] && [ "$database" -nt "$ship" ]; then
  say "database is there: $database"
else
  say "solve: frigate, 433 panels a side, 60 frequencies, 13 headings"
  "$cutwater" solve "$ship" -o "$database"
fi
"$cutwater" info "$database" | head -n 12

say "simulate: irregular sea from 150 deg, ten minutes in Bullet"
"$cutwater" simulate "$(run_file irregular_150 run)" --forces -o "$out/run.csv"
gnuplot -e "in='$out/run.csv'; out='$out/run.png'" "$root/demos/plot_run.gp"

say "simulate: a rough sea at 7 m/s, five minutes in Bullet"
"$cutwater" simulate "$(run_file storm_160 storm)" --forces -o "$out/storm.csv"

# sweep_and_plot NAME BETA SPEED TITLE: Bullet's points and the frequency domain's lines.
sweep_and_plot() {
  local name=$1 beta=$2 speed=$3 title=$4
  "$cutwater" sweep "$(run_file "sweep_$name" "sweep_$name")" -o "$out/sweep_$name.csv"
  "$cutwater" rao "$database" --speed "$speed" --heading "$beta" --omega 0.2:2:361 \
    -o "$out/rao_$name.csv"
  gnuplot -e "in='$out/sweep_$name.csv'; rao='$out/rao_$name.csv'; out='$out/sweep_$name.png'" \
    -e "name='$title'" "$root/demos/plot_sweep.gp"
}
for beta in 030 090 150 180; do
  say "sweep: regular waves, heading ${beta#0} deg, Bullet beside the frequency domain"
  sweep_and_plot "$beta" "${beta#0}" 0 "${beta#0} deg"
done
for beta in 030 150; do
  say "sweep: regular waves at 20 knots, heading ${beta#0} deg"
  sweep_and_plot "20kn_$beta" "${beta#0}" 10.2889 "${beta#0} deg, 20 knots"
done
cp "$out/sweep_150.csv" "$out/sweep.csv"
cp "$out/sweep_150.png" "$out/sweep.png"

say "report: all of it in one page"
runs=("$out/run.toml" "$out/storm.toml")
for name in 030 090 150 180 20kn_030 20kn_150; do
  runs+=("$out/sweep_$name.toml")
done
page=$out/report.html
rm -f "$page"
if ! said=$("$cutwater" report "$database" "${runs[@]}" -o "$page" 2>&1); then
  case $said in
    *"built without the page"*) page=; echo "no page: ${said##*cutwater: report: }" ;;
    *) printf '%s\n' "$said" >&2; exit 1 ;;
  esac
fi

say "done; what to look at:"
if [ -n "$page" ]; then echo "  $page     all of it in one page: open it in a browser"; fi
echo "  $out/run.png         motions in the irregular sea (run.csv)"
echo "  $out/sweep_*.png     Bullet's points lie on the frequency domain's lines (sweep_*.csv)"
