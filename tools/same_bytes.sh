#!/usr/bin/env bash
# Cooks by programs of another compiler, under sanitizers, and for another processor; all must write the same bytes.
# Builds them and prints a table: a cooking a line, of what it is the same or not.
# usage: tools/same_bytes.sh [VARIANT ...]   of: asan aarch64; both without arguments. Real models: MARROW_ASSETS
# Exit code: 0 the same, 1 not, 2 no build, 3 what was cooked is the same, but a variant cannot be had here.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$here"
[ $# -gt 0 ] || set -- asan aarch64
for variant in "$@"; do
  [[ " asan aarch64 " == *" $variant "* ]] || { sed -n '4s/^# //p' "$0" >&2; exit 1; }
done
arm64="$here/build/same/arm64-packages"
assets=${MARROW_ASSETS:-$here/../shared/assets}
out="$here/build/same/out"

tools/install.sh tools/packages/build.txt tools/packages/same.txt || echo "same_bytes: some packages cannot be installed" >&2

# Says what a command said only where it fails.
quiet() {
  local said
  said=$("$@") || { tail -n 40 <<<"$said" >&2; exit 2; }
}

# Says why where a variant cannot be had.
skipped=0
make_variant() {
  local missing=""
  case $1 in
    # Clang's, by its preset: the sanitizers find what else the cookings do.
    asan)
      if ! command -v clang++ >/dev/null; then
        missing="clang++ is not installed"
      else
        quiet cmake --preset asan
        quiet cmake --build --preset asan --target marrow
      fi
      ;;
    aarch64)
      if ! command -v aarch64-linux-gnu-g++ >/dev/null || ! command -v qemu-aarch64 >/dev/null; then
        missing="no compiler or emulator for it"
      elif ! tools/get_arm64.sh "$arm64" tools/packages/arm64-cook.txt; then
        missing="no packages for it"
      else
        # What the cooker needs and no more.
        quiet cmake -G Ninja -S . -B build/same/aarch64 --toolchain cmake/aarch64.cmake -DCMAKE_SYSROOT="$arm64" \
          -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O3 -DNDEBUG" -DMARROW_TOOLS_FLAGS=-O1 -DMARROW_TESTS=OFF \
          -DMARROW_GLES=OFF -DMARROW_ALL_COMMANDS=OFF --no-warn-unused-cli
        quiet cmake --build build/same/aarch64 --target marrow
      fi
      ;;
  esac
  [ -n "$missing" ] || return 0
  echo "SKIPPED: $1: $missing" >&2
  skipped=3
  return 1
}

run_variant() {  # NAME ARGUMENT ...
  local name=$1
  shift
  case $name in
    aarch64) qemu-aarch64 -L "$arm64" build/same/aarch64/tools/marrow "$@" ;;
    *) "build/$name/tools/marrow" "$@" ;;
  esac
}

# The ways to cook, a line each: name, source, options.
cookings() {
  local golden=tests/golden newt=tools/sample/newt.glb
  sed 's/, "JOINTS_0": 1, "WEIGHTS_0": 2//' $golden/elbow.gltf >"$out/bare.gltf"
  cat <<END
newt $newt
newt-lod $newt --mesh-codec meshopt --clip-codec raw --lod 0.5,0.25:2
newt-raw $newt --mesh-codec none --clip-codec raw
dance $golden/dance.gltf --mesh-codec none
face $golden/face.gltf --mesh-codec none --additive speak
looks $golden/looks.gltf --images embed --keep *
stride $golden/stride.gltf
limits $golden/limits.gltf --mesh-codec none
fit-helpers $golden/elbow.gltf --as fit --truth dqs --helpers 2
fit-all $golden/elbow.gltf --as fit --mwe --psd 4 --mesh-codec none
smooth $golden/elbow.gltf --as smooth --delta-mush 5,0.25,cotangent --subdivide 1
geodesic $out/bare.gltf --auto-weights geodesic --smooth-weights 2 --mesh-codec none
rigged $newt --auto-skeleton humanoid --mesh-codec none
glow $out/bare.gltf --auto-weights glow --mesh-codec none
gaussian $out/bare.gltf --auto-weights gaussian --mesh-codec none
END
  asset() { [ ! -e "$assets/$2" ] || echo "$1 $assets/${*:2}"; }
  asset fox Fox.glb
  asset cesium-fit CesiumMan.glb --as fit --mesh-codec none --clip-codec raw
  asset cesium-u8 CesiumMan_u8.glb --clip-codec raw --mesh-codec meshopt
  asset cesium-draco CesiumMan_draco_in/CesiumMan.gltf --clip-codec raw
  asset cesium-draco-raw CesiumMan_draco_in/CesiumMan.gltf --clip-codec raw --mesh-codec none
  asset figure RiggedFigure.glb --truth cor --psd 4 --lod 0.5 --mesh-codec none
  asset robot raylib_robot.glb --mesh-codec none --clip-codec raw
}

# Cooks one way by one variant. Says "same", "DIFFERS" or "FAILED"; of the first, by which others go, the hash.
compare() {  # VARIANT NAME SOURCE OPTION ...
  local variant=$1 name=$2
  local file="$out/$variant/$name.mrw" first="$out/release/$name.mrw"
  shift 2
  if ! run_variant "$variant" cook "$@" -o "$file" >/dev/null 2>"$out/$variant/$name.txt"; then
    echo FAILED
  elif [ "$variant" = release ]; then
    sha256sum "$file" | cut -c1-12
  elif cmp -s "$file" "$first"; then
    echo same
  else
    echo DIFFERS
  fi
}

quiet cmake --preset release
quiet cmake --build --preset release --target marrow
variants=(release)
for variant in "$@"; do make_variant "$variant" && variants+=("$variant"); done
rm -rf "$out"
for variant in "${variants[@]}"; do mkdir -p "$out/$variant"; done

[ -d "$assets" ] || echo "SKIPPED: real models: no folder $assets" >&2
failed=0 compared=0
set -f  # a * among the options is for the cooker
printf '%-14s' cooking; printf ' %-12s' "${variants[@]}"; echo
while read -r name options; do
  printf '%-14s' "$name"
  for variant in "${variants[@]}"; do
    # shellcheck disable=SC2086
    word=$(compare "$variant" "$name" $options </dev/null)
    printf ' %-12s' "$word"
    case $word in
      FAILED | DIFFERS) failed=1 ;;
      same) compared=$((compared + 1)) ;;
    esac
  done
  echo
done < <(cookings)
echo "same_bytes: $compared files are the same by other programs"
[ $failed -eq 0 ] && [ $compared -gt 0 ] || exit 1
exit $skipped
