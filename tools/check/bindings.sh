#!/usr/bin/env bash
# Takes the sample character down the same road in C, Rust, C# and JavaScript, and compares what they print: what is
# refused, and a hash of poses and vertices. Then all but JavaScript, which has no driver of OpenGL ES, let the self-test
# draw. Exit 1 if they differ, 3 if a language cannot be had. Builds below
# build/bindings.
# usage: tools/check/bindings.sh MARROW      (the program)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$(realpath "$1")
work="$here/build/bindings"
mkdir -p "$work"
skipped=0
skip() { echo "SKIPPED: $1" >&2; skipped=3; }
has() { for name in "$@"; do command -v "$name" >/dev/null || return 1; done; }

has rustc mcs mono clang++-19 wasm-ld-19 node || "$here/tools/install.sh" "$here/tools/packages/bindings.txt" || true

quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >"$work/log.txt" 2>&1 || { cat "$work/log.txt" >&2; exit 1; }
}
# The programs beside the bindings that they call by.
programs="$work/programs"
quietly python3 "$here/tools/c_api" --bindings "$programs"
cp "$here"/tests/bindings/*.{rs,cs,mjs} "$programs"
runtime_alone=(-DCMAKE_BUILD_TYPE=Release -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF -DMARROW_WERROR=OFF \
  -DMARROW_GLES=ON -C "$here/cmake/quick.cmake")
quietly cmake -S "$here" -B "$work/shared" -G Ninja "${runtime_alone[@]}" -DMARROW_DRACO=ON -DMARROW_MESHOPT=ON
quietly cmake --build "$work/shared" --target marrow_c_shared
export LD_LIBRARY_PATH="$work/shared/runtime/c"
for codec in none draco; do
  "$marrow" cook "$here/tools/sample/newt.glb" --mesh-codec $codec --clip-codec raw -o "$work/newt_$codec.mrw" >/dev/null
done

# What C says of each file; the others must say the same.
quietly gcc -std=c99 -pedantic -Wall -Wextra -Werror -I"$here/runtime/include" "$here/tests/c/road.c" \
  -o "$work/road_c" -L"$LD_LIBRARY_PATH" -lmarrow_c
quietly gcc -std=c99 -pedantic -Wall -Wextra -Werror -I"$here/runtime/include" "$here/tests/bindings/gles3.c" \
  -o "$work/gles3_c" -L"$LD_LIBRARY_PATH" -lmarrow_c -lEGL
"$work/gles3_c" >"$work/gles3.txt" || { echo "check/bindings: the self-test does not draw in C" >&2; exit 1; }
draw() {  # LANGUAGE COMMAND ...
  local language=$1
  shift
  "$@" >"$work/drawn.txt" || true
  diff "$work/drawn.txt" "$work/gles3.txt" >&2 ||
    { echo "check/bindings: $language: the self-test says other than in C" >&2; exit 1; }
  echo "$language, OpenGL ES: the self-test chooses $(tail -1 "$work/drawn.txt")"
}
compare() {  # LANGUAGE CODEC COMMAND ...
  local language=$1 codec=$2 wanted got
  shift 2
  wanted=$("$work/road_c" "$work/newt_$codec.mrw")
  got=$("$@" "$work/newt_$codec.mrw") || true
  if [ "$got" != "$wanted" ]; then
    printf 'check/bindings: %s, %s: says\n%s\nand C\n%s\n' "$language" "$codec" "$got" "$wanted" >&2
    exit 1
  fi
  echo "$language, $codec: "${got//$'\n'/, }
}

if has rustc; then
  quietly rustc --edition 2021 -O -D warnings -o "$work/road_rust" "$programs/road.rs" -L "$LD_LIBRARY_PATH" \
    -l marrow_c
  for codec in none draco; do compare Rust $codec "$work/road_rust"; done
  quietly rustc --edition 2021 -O -D warnings -o "$work/gles3_rust" "$programs/gles3.rs" \
    -L "$LD_LIBRARY_PATH" -l marrow_c
  draw Rust "$work/gles3_rust"
else
  skip "Rust: there is no rustc"
fi
if has mcs mono; then
  quietly mcs -unsafe -warnaserror -out:"$work/Road.exe" "$programs/Road.cs" "$programs/Marrow.cs"
  for codec in none draco; do compare 'C#' $codec mono "$work/Road.exe"; done
  quietly mcs -unsafe -warnaserror -out:"$work/Gles3.exe" "$programs/Gles3.cs" "$programs/Marrow.cs"
  draw 'C#' mono "$work/Gles3.exe"
else
  skip "C#: there is no mcs or mono"
fi
if has clang++-19 wasm-ld-19 node; then
  quietly cmake -S "$here" -B "$work/wasm" -G Ninja --toolchain "$here/cmake/wasm32.cmake" "${runtime_alone[@]}"
  quietly cmake --build "$work/wasm" --target marrow-all
  wasm="$work/wasm/platform/web/marrow-all.wasm"
  compare JavaScript none node "$programs/road.mjs" "$wasm"
  node "$programs/gles3.mjs" "$wasm" "$work/newt_none.mrw"
  # A library of another release is refused, and says so.
  cp "$programs"/{marrow,tables,gl}.mjs "$work"
  sed -i 's/^export const ABI = .*/export const ABI = 1;/' "$work/tables.mjs"
  said=$(node -e 'import(process.argv[1]).then((b) => b.Marrow.load(require("fs").readFileSync(process.argv[2])))' \
    "$work/marrow.mjs" "$wasm" 2>&1) && said=nothing
  [[ $said == *"Error: marrow: the library has ABI"* ]] ||
    { printf 'check/bindings: JavaScript takes a library of another ABI, and says\n%s\n' "$said" >&2; exit 1; }
else
  skip "JavaScript: there is no clang++-19, wasm-ld-19 or node"
fi
exit $skipped
