#!/usr/bin/env bash
# Kills runs of wbv with -9 at random moments and looks at what they leave: src/test/sh/kills.sh [KILLS] [FOLDER]
# A kill may leave hidden .wbv-* names, which the next run in the folder removes, and nothing else: what has its final name is
# whole, and equals what a run that nobody killed writes. Where a small disk may be mounted (Linux, root), full disks follow. Needs a built target/; FOLDER (a new one under the system's temporary
# folder) is emptied. 20 kills of each of the five commands take about twelve minutes.
set -uo pipefail
home=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../../.." && pwd -P)
kills=${1:-20}
room=${2:-$(mktemp -d)}
mkdir -p "$room"; cd "$room" || exit 2
[ -z "$(ls -A)" ] || [ -f .kills ] || { echo "$room is not empty" >&2; exit 2; }
touch .kills; rm -rf ./*; rm -rf .wbv-*
RANDOM=${SEED:-$$}
wrong=0

wbv() { java -Xmx1g -jar "$home/target/wbv.jar" "$@"; }
wrong() { echo "WRONG $1"; wrong=$((wrong + 1)); }
left() { find . "$@" -name '.wbv-*' ! -name .kills | wc -l; }

# once NAME OUT COMMAND...: what it writes when nobody kills it, and how long that takes
once() {
  local name=$1 out=$2; shift 2
  local begun; begun=$(date +%s%N)
  wbv "$@" >"$name.log" 2>&1 || { wrong "$name fails by itself: $(head -c 200 "$name.log")"; return 1; }
  took=$(( ($(date +%s%N) - begun) / 1000000 ))
  rm -rf "whole-$name"; mkdir "whole-$name"; mv $out "whole-$name/"
}

# killed NAME OUT COMMAND...: the same, killed again and again; files under a final name must equal the whole ones
killed() {
  local name=$1 out=$2; shift 2
  once "$name" "$out" "$@" || return
  local early=0 partial=0 stale=0
  for ((i = 0; i < kills; i++)); do
    wbv "$@" >/dev/null 2>&1 & local p=$!
    sleep "$(awk "BEGIN{print $took * (0.15 + 0.9 * $RANDOM / 32768) / 1000}")"
    local alive=; kill -9 $p 2>/dev/null && alive=1 && early=$((early + 1)); wait $p 2>/dev/null
    [ "$(left)" -gt 0 ] && partial=$((partial + 1))
    for at in $out; do [ -e "$at" ] && differs "whole-$name/$at" "$at" && stale=$((stale + 1)) && wrong "$name: $at is neither whole nor absent after kill $i"; done
    [ "${KEEP:-}" ] && [ "$alive" ] || rm -rf $out
  done
  wbv "$@" >"$name.log" 2>&1 || wrong "$name: the run after the kills fails: $(head -c 200 "$name.log")"
  for at in $out; do differs "whole-$name/$at" "$at" && wrong "$name: $at of the run after the kills differs"; done
  [ "$(left)" = 0 ] || wrong "$name: $(left) hidden names are left after the next run"
  echo "$name: $early of $kills killed before their end (a run takes $took ms), $partial of them left hidden names, $stale something half-written"
  rm -rf $out
}

# Whether a file or folder differs from the whole one: every file of it that is there must be the same, to the byte but for times.
differs() {
  [ -e "$2" ] || return 0
  if [ -d "$2" ]; then
    local f
    while IFS= read -r f; do same "$1/$f" "$2/$f" || return 0; done < <(cd "$2" && find . -type f ! -path '*/.wbv-*' ! -name worker.log)
    return 1
  fi
  ! same "$1" "$2"
}
same() {
  case $1 in
    */answer.json | */proof.md | */proof.json) cmp -s <(sed -E 's/("?seconds"? ?: ?)[0-9.eE-]+//' "$1" | grep -vi 'median\|second') <(sed -E 's/("?seconds"? ?: ?)[0-9.eE-]+//' "$2" | grep -vi 'median\|second') ;;
    *) cmp -s "$1" "$2" ;;
  esac
}

arff=$home/data/arff
killed analyze out analyze "$arff/one-dof-linear.arff" --out out
killed convert 'ride.csv ride.json' convert "$arff/ride-subject1.arff" --out ride.csv
killed task tracks.csv task "wbv.task.TrackBody -s (wbv.stream.RecordingStream -f $arff/one-dof-linear.arff -i platform.acc.z -o head.acc.z) -t tracks.csv -e 30"
# What goes on where it stopped is not cleared between the kills.
KEEP=1
killed train model net train --images 120 --epochs 12 --members 2 --checkpoint state --out model
[ -e state ] && wrong "train: the checkpoint is left beside the model"
killed prove proof prove --quick --cases 2 --out proof

# full NAME COMMAND...: a disk of 100 kB is one line, exit code 1, and nothing left
full() {
  local name=$1; shift
  wbv "$@" >/dev/null 2>full.log; local code=$?
  [ "$code" = 1 ] && [ "$(wc -l <full.log)" = 1 ] || wrong "full disk, $name: exit $code: $(head -c 200 full.log)"
  [ -z "$(ls -A small)" ] || wrong "full disk, $name: left $(ls -A small)"
}
mkdir -p small
if mount -t tmpfs -o size=100k tmpfs small 2>/dev/null; then
  linear=$arff/one-dof-linear.arff
  full analyze analyze "$linear" --out small/o
  full track track "$linear" --out small/o
  full frf frf "$linear" --out small/o
  full exposure exposure "$arff/ride-subject1.arff" --out small/o
  full convert convert "$arff/two-dof.arff" --out small/x.csv
  full 'convert, packed' convert "$arff/ride-subject1.arff" --out small/x.csv.gz
  full simulate simulate seconds=20 --out small/r.csv
  full export net export --out small/m.onnx
  full predict net predict "$linear" --input platform.acc.z --output head.acc.z --out small/o
  full states states train "$arff/states-train.arff" --out small/o
  full diagnose diagnose "$arff/concealed/001/recording.csv.gz" --model "$arff/concealed/001/model.json" --out small/o
  full task task "wbv.task.TrackBody -s (wbv.stream.RecordingStream -f $linear -i platform.acc.z -o head.acc.z) -t small/t.csv -e 30"
  wbv net train --images 60 --epochs 2 --checkpoint state --out small/o >/dev/null 2>full.log
  [ -f state ] && [ -z "$(ls -A small)" ] || wrong "full disk, train: the checkpoint is gone, or something is left: $(ls -A small)"
  umount small
  echo "full disk: 13 commands"
fi
echo "$wrong wrong"
[ "$wrong" = 0 ]
