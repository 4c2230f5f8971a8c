#!/usr/bin/env bash
# Walks the tutorial as a reader does: from an empty folder, by the CMake files and the commands of its pages. Each
# program must draw, without a warning of the compiler. Exit 1 if something is other than said, 3 without a screen.
# usage: tools/check/tutorial.sh MARROW [FOLDER]      (the program; where to work, which is emptied)
set -euo pipefail
MARROW=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
PATH=$(dirname "$(realpath "$1")"):$PATH
programs=$MARROW/tests/examples/tutorial work=${2:-$MARROW/build}/tutorial
pages="docs/tutorial/hello.md docs/tutorial/window.md docs/tutorial/gpu.md docs/tutorial/feet.md docs/tutorial/look.md
  docs/tutorial/behaviour.md docs/tutorial/crowd.md docs/tutorial/lost.md docs/tutorial/shipping.md"
export CMAKE_TOOLCHAIN_FILE=$MARROW/cmake/quick.cmake
export MARROW PATH LIBGL_ALWAYS_SOFTWARE=1 XDG_RUNTIME_DIR=$work CXXFLAGS="-Wall -Wextra -Wconversion -Wsign-conversion"
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
if command -v ninja >/dev/null; then export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}; fi
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}; fi

fail() { echo "tutorial: $*" >&2; exit 1; }
command -v Xvfb >/dev/null || { echo "SKIPPED: there is no Xvfb (Debian: xvfb)" >&2; exit 3; }
rm -rf "$work"
mkdir -p "$work"
cd "$work"
exec 9< <(exec Xvfb -displayfd 1 -noreset -screen 0 1280x800x24 -nolisten tcp 2>"$work/xvfb.txt")
screen=$!
trap 'kill $screen' EXIT
read -r number <&9
export DISPLAY=:$number

# blocks LANGUAGE PAGE: all of them, but those that a comment says are not run.
blocks() {
  awk -v language="$1" '/^```/ { inside = !inside && $0 == "```" language && !skip; open = !open; skip = 0; next }
    inside { print } !open && NF { skip = /^<!-- not run: / }' "$2"
}
# covered PICTURE: how many pixels of 1000 are newt's green.
covered() {
  od -An -v -tu1 -w3 -j 15 "$1" |
    awk '{ all++; if ($2 > 1.4 * $1 && $3 > 1.2 * $1) green++ } END { printf "%d", 1000 * green / all }'
}
# drawn PICTURE LEAST MOST
drawn() {
  local share
  [ -s "$1" ] || fail "$1 is not there"
  share=$(covered "$1")
  [ "$2" -le "$share" ] && [ "$share" -le "$3" ] || fail "$1: $share of 1000 pixels are a newt, not $2 to $3"
  echo "$1: $share of 1000 pixels are a newt"
}

# Programs that pages show.
shown() {
  (cd "$MARROW" && PYTHONPATH=tools/docs python3 -c "import sys, blocks, snippets
blocks.run_by = lambda page: None
snippets.FOLDERS = ['tests/examples/tutorial']
sys.exit(snippets.main())" $pages)
}
shown || fail "a page shows what is in no program"

: >CMakeLists.txt
for page in $pages; do
  blocks cmake "$MARROW/$page" >>CMakeLists.txt
  # What stays until its window is closed plays three frames here.
  blocks sh "$MARROW/$page" | sed -E '/ --frames /!s|^build/[a-z]+ [^ ]+$|& --frames 3|' >commands.sh
  [ -s commands.sh ] || fail "$page has no commands"
  bash -euo pipefail commands.sh >log.txt 2>&1 || { tail -30 log.txt >&2; fail "the commands of $page fail"; }
  if grep -A 5 "warning:" log.txt >&2; then fail "$page: the compiler warns"; fi
  [[ $page != */hello.md ]] || grep -q '^0.27 s: head at .* vertex 0 of body at ' log.txt || fail "hello prints something else"
  [[ $page != */behaviour.md ]] || grep -q '^1.72 s: right_foot at 0.69 m' log.txt || fail "other steps are heard"
  [[ $page != */shipping.md ]] || cp log.txt shipping.txt
done
diff -u CMakeLists.txt "$programs/CMakeLists.txt" || fail "the pages' CMakeLists.txt is another"
for file in "$programs"/*.cpp "$programs"/*.h; do cmp "$file" "$(basename "$file")"; done
for name in walk gpu feet look lost behaviour; do drawn $name.ppm 35 65; done
drawn crowd.ppm 120 190
drawn ship.ppm 65 100
cmp lost.ppm whole.ppm || fail "another picture after the context was lost"
if cmp -s walk.ppm gpu.ppm; then fail "walk and gpu give the same bits: is one the other?"; fi
grep -q '^ubo: usable' shipping.txt || fail "the self-test does not find ubo usable"
build/feet hero.mrw --frames 3 --picture nowhere/feet.ppm >/dev/null 2>&1 && fail "a picture that cannot be written is no error"
echo "walked"
