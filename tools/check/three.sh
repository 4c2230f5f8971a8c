#!/usr/bin/env bash
# Draws models and their exports with three.js in a headless Chromium and compares the pictures; exit 1 if they differ, 3
# if there are no models or npm or Chromium cannot be had. Packages stay under build/three, pictures under
# build/three/pictures.
# usage: tools/check/three.sh MARROW [MODEL ...]      (the program; without models, a handful of MARROW_ASSETS)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$1
shift
modules="$here/build/three"
assets="${MARROW_ASSETS:-$here/../shared/assets}"
if [ $# -eq 0 ]; then
  for name in CesiumMan Fox RiggedFigure greenman mannequiny; do
    [ ! -e "$assets/$name.glb" ] || set -- "$@" "$assets/$name.glb"
  done
fi
[ $# -gt 0 ] || { echo "check/three: no models at $assets" >&2; exit 3; }
if [ ! -d "$modules/node_modules/@sparticuz/chromium" ] || [ ! -d "$modules/node_modules/three" ]; then
  command -v npm >/dev/null || { echo "check/three: npm is not installed" >&2; exit 3; }
  mkdir -p "$modules"
  npm install --silent --no-audit --no-fund --prefix "$modules" three@0.187.0 puppeteer-core@25.16.0 \
    @sparticuz/chromium@138.0.2 >/dev/null 2>&1 || { echo "check/three: npm cannot be reached" >&2; exit 3; }
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
pairs=()
for model in "$@"; do
  name=$(basename "${model%.*}")
  "$marrow" cook "$model" -o "$work/$name.mrw" >/dev/null 2>&1
  "$marrow" export "$work/$name.mrw" -o "$work/$name.glb"
  pairs+=("$model" "$work/$name.glb")
done
node "$here/tools/three/compare.mjs" "$modules" "$modules/pictures" "${pairs[@]}"
