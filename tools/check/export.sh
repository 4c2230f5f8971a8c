#!/usr/bin/env bash
# Cooks and exports every model of MARROW_ASSETS and the project's own, compressed with images inside and raw with images
# beside, and runs the Khronos glTF validator over what comes out; exit 1 if it finds errors, 3 without npm or network.
# usage: tools/check/export.sh MARROW      (the program; the folder of models is $MARROW_ASSETS or shared/assets beside)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$1
assets="${MARROW_ASSETS:-$here/../shared/assets}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
models=("$here"/tools/sample/newt.glb "$here"/tests/golden/*.gltf)
if [ -d "$assets" ]; then
  # In the short form of the tests as many as tests/support/places.h says.
  largest=$([ "${MARROW_TESTS:-}" = all ] && echo 4G || echo 800k)
  while IFS= read -r -d '' model; do models+=("$model"); done < <(find "$assets" -name '*.gl[bt]*' -size "-$largest" -print0 | sort -z)
else
  echo "check/export: NO MODELS at $assets: only the project's own are tried" >&2
fi
count=0
for model in "${models[@]}"; do
  for options in "--images embed" "--images reference --keep-vertex-order --clip-codec raw"; do
    folder="$work/$count"
    mkdir "$folder"
    # shellcheck disable=SC2086  # several words
    "$marrow" cook "$model" -o "$folder/cooked.mrw" $options >/dev/null 2>&1 ||
      { echo "check/export: $model cannot be cooked" >&2; exit 1; }
    "$marrow" export "$folder/cooked.mrw" -o "$folder/$(basename "${model%.*}").glb" ||
      { echo "check/export: $model" >&2; exit 1; }
    # What the model names by reference lies beside it.
    find "$(dirname "$model")" -mindepth 1 -maxdepth 1 ! -name '*.gl[bt]*' -exec ln -s {} "$folder" \;
    count=$((count + 1))
  done
done
"$here/tools/validate_gltf.sh" "$work"/*/*.glb
