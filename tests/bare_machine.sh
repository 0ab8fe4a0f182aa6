#!/usr/bin/env bash
# What a newcomer gets: the commands of the README in a fresh clone on a bare Debian, and one
# summary of it. The bare system is made by debootstrap from this machine's own package sources; the
# commands run in it by chroot. Everything is mounted in a mount namespace of the run's own: nothing
# is mounted afterwards, however the run ends.
set -euo pipefail

usage() {
  cat <<'TEXT'
usage: tests/bare_machine.sh [OPTION...] [COMMAND...]

  COMMAND      what ./run is called with, each on a bare system; "demo" "test" if none is given
  --base DIR   the bare system: made there if it is not, and used again (a run works on a copy)
  --commit ID  what is cloned (HEAD)
  --keep       leaves the copies, with their logs, and says where they are

As root, on Debian with debootstrap. Needs 4 GB in $TMPDIR or /tmp.
Example: tests/bare_machine.sh --base /tmp/bare "test --full"
TEXT
}

say() { printf '\n### %s\n' "$*"; }
die() { printf 'bare_machine: %s\n' "$*" >&2; exit 1; }

# Debian's archives among this machine's package sources: "URI suite component", one a line.
debian_sources() {
  # shellcheck disable=SC2016  # the dollars are apt's
  apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT) $(ORIGIN)' \
    'Created-By: Packages' |
    sed -n 's/ Debian$//p' | grep " $codename" | sort -u
}

# make_base DIR: a minimal system with nothing of this machine but where packages come from.
make_base() {
  local sources mirror
  sources=$(debian_sources) ||
    die "no package source of Debian $codename is known here: apt-get update"
  mirror=$(awk -v suite="$codename" '$2 == suite { print $1; exit }' <<<"$sources")
  [[ -n $mirror ]] || die "no package source here is of the suite $codename"
  say "debootstrap --variant=minbase $codename"
  local include=()
  [[ $sources != *https://* ]] || include=(--include=ca-certificates)
  debootstrap --variant=minbase "${include[@]}" "$codename" "$1.part" "$mirror" >"$1.log" ||
    die "see $1.log"
  awk '{ print "deb", $0 }' <<<"$sources" >"$1.part/etc/apt/sources.list"
  # How packages are reached: proxies, and clocks that are not believed.
  apt-config dump | grep -E '^Acquire::(https?|Check-[A-Za-z-]*)(::[A-Za-z-]+)* ' \
    >"$1.part/etc/apt/apt.conf.d/90reach" || true
  rm -rf "$1.part/var/cache/apt/archives" "$1.part/var/lib/apt/lists"
  mkdir -p "$1.part/var/cache/apt/archives/partial" "$1.part/var/lib/apt/lists/partial"
  mv "$1.part" "$1"
  rm -f "$1.log"
}

# in_bare ROOT PROGRAM ARG...: in the bare system, with its devices, as root, in the clone. Replaces
# this shell.
in_bare() {
  local bare=$1
  shift
  # shellcheck disable=SC2016  # expanded inside
  exec unshare --mount --pid --fork --kill-child --propagation private bash -euc '
    bare=$1
    shift
    mount -t tmpfs -o mode=755 tmpfs "$bare/dev"
    for device in null zero full random urandom tty; do
      touch "$bare/dev/$device"
      mount --bind "/dev/$device" "$bare/dev/$device"
    done
    ln -s /proc/self/fd "$bare/dev/fd"
    mkdir -m 1777 "$bare/dev/shm"
    mount -t proc proc "$bare/proc"
    exec chroot "$bare" env -C /root/cutwater "$@"' bash "$bare" \
    env -i HOME=/root TERM=dumb LANG=C.UTF-8 \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    "${reach[@]}" "$@"
}

packages() { chroot "$1" dpkg-query -W | wc -l; }

# fresh_system DIR: a copy of the bare system with a fresh clone.
fresh_system() {
  cp -a --reflink=auto "$base" "$1"
  cat /etc/resolv.conf >"$1/etc/resolv.conf"
  cat /etc/hosts >"$1/etc/hosts"
  git clone --quiet --no-local "$root" "$1/root/cutwater"
  git -C "$1/root/cutwater" -c advice.detachedHead=false checkout --quiet "$commit"
}

# run_command ARGUMENTS: one call of ./run on a system of its own; appends to the summary.
run_command() {
  local arguments=$1 bare log before times after result=passed TIMEFORMAT='%0R %0U %0S'
  bare=$work/$(tr -c 'a-z0-9\n' _ <<<"$arguments")
  log=$bare/root/log
  fresh_system "$bare"
  before=$(packages "$bare")
  say "./run $arguments"
  # shellcheck disable=SC2086  # several words
  in_bare "$bare" ./run $arguments >"$log" 2>&1 &
  running=$!
  { time wait $running || result=FAILED; } 2>"$bare/root/times"
  running=""
  read -r -a times <"$bare/root/times"
  after=$(packages "$bare")
  [[ $result == passed ]] || { tail -n 60 "$log"; failed=yes; }
  grep '^==> ' "$log" || true
  summary+=$(printf '%-20s %s: %d s, %d CPU s, %d packages installed' "./run $arguments" "$result" \
    "${times[0]}" $((times[1] + times[2])) $((after - before)))$'\n'
  # ctest's closing lines: "100% tests passed, 0 tests failed out of 537".
  summary+=$(sed -nE \
    's/^[0-9]+% tests passed, ([0-9]+) tests failed out of ([0-9]+).*/\1 \2/p' "$log" |
    awk '{ printf "%20s tests: %d passed, %d failed\n", "", $2 - $1, $1 }')$'\n'
  [[ $keep == yes ]] || rm -rf --one-file-system "$bare"
}

base="" commit=HEAD keep=no commands=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --base) base=$(realpath -m "${2:?--base DIR}"); shift ;;
    --commit) commit=${2:?--commit ID}; shift ;;
    --keep) keep=yes ;;
    -h | --help) usage; exit ;;
    -*) usage >&2; exit 2 ;;
    *) commands+=("$1") ;;
  esac
  shift
done
[[ ${#commands[@]} -gt 0 ]] || commands=(demo test)
[[ $EUID -eq 0 ]] || die "must be root, for chroot"
for program in debootstrap unshare chroot apt-get git; do
  command -v $program >/dev/null || die "$program is missing"
done
codename=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
[[ -n $codename ]] || die "not a release of Debian"
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
commit=$(git -C "$root" rev-parse --verify "$commit^{commit}")
[[ -z $(git -C "$root" status --porcelain) ]] || say "what is not committed is not in the clone"

# Of the environment only what reaches packages, and OpenBLAS's choice of kernels for this
# processor.
reach=()
for name in http_proxy https_proxy no_proxy OPENBLAS_CORETYPE OPENBLAS_L2_SIZE; do
  [[ -z ${!name-} ]] || reach+=("$name=${!name}")
done

work=$(mktemp -d "${TMPDIR:-/tmp}/bare.XXXXXX")
running=""
clean() {
  [[ -z $running ]] || kill -KILL "$running"
  if [[ $keep == yes ]]; then
    say "the bare systems, each with its root/log: $work"
  else
    rm -rf --one-file-system "$work"
  fi
}
trap clean EXIT
trap 'exit 130' INT TERM HUP
base=${base:-$work/base}
[[ -d $base ]] || make_base "$base"

summary="" failed=no
for arguments in "${commands[@]}"; do
  run_command "$arguments"
done
say "bare Debian $codename, $(nproc) cores, commit ${commit:0:12}"
printf '%s' "$summary" | grep -v '^$'
[[ $failed == no ]]
