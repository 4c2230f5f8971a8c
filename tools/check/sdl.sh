#!/usr/bin/env bash
# Builds the game of platform/sdl by the commands of docs/platforms/sdl.md, inside Marrow's sources and with Marrow
# installed, runs it under Xvfb, and asks what that page says under "What was run where". Exit 1 if something is other
# than said, 3 if SDL or a screen cannot be had. Builds and writes pictures in build/sdl.
# usage: tools/check/sdl.sh MARROW      (the program)
set -euo pipefail
MARROW=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
PATH=$(dirname "$(realpath "$1")"):$PATH
page=$MARROW/docs/platforms/sdl.md tests=$MARROW/tests/platform/sdl work=$MARROW/build/sdl
PREFIX=$work/prefix
export CMAKE_TOOLCHAIN_FILE=$MARROW/cmake/quick.cmake
export MARROW PREFIX PATH LIBGL_ALWAYS_SOFTWARE=1 XDG_RUNTIME_DIR=$work
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
if command -v ninja >/dev/null; then export CMAKE_GENERATOR=${CMAKE_GENERATOR:-Ninja}; fi
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}; fi

fail() { echo "check/sdl: $*" >&2; exit 1; }
has_all() { command -v Xvfb sdl2-config >/dev/null && [ "$(command -v Xvfb sdl2-config | wc -l)" = 2 ]; }
has_all || "$MARROW/tools/install.sh" "$MARROW/tools/packages/sdl.txt" || true
has_all || { echo "SKIPPED: SDL: there is no libsdl2-dev, or no Xvfb" >&2; exit 3; }
mkdir -p "$work" && cd "$work"
rm -rf ./*.bmp ./*.txt mygame

block() {  # NUMBER: that block of commands of the page
  awk -v wanted="$1" '/^```/ { inside = /^```sh$/ && ++n == wanted; next } inside' "$page" | grep . ||
    fail "$page has no block $1 of commands"
}
commands() {  # NUMBER
  block "$1" >commands.sh
  bash -euo pipefail commands.sh >log.txt 2>&1 || { tail -30 log.txt >&2; fail "the commands of block $1 fail"; }
}

python3 "$tests/snippets.py" "$MARROW"
[ "$(wc -l <"$MARROW/platform/sdl/game.cpp")" -le 200 ] || fail "game.cpp has more than 200 lines"
commands 1
echo "built: $(stat -c %s game/game) B, newt.mrw $(stat -c %s newt.mrw) B"

# Elsewhere, with Marrow installed.
install() {
  cmake -S "$MARROW" -B marrow -DCMAKE_BUILD_TYPE=Release -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF -DMARROW_DRACO=ON \
    -DMARROW_WERROR=OFF
  cmake --build marrow --target marrow_runtime marrow_unpack marrow_draco marrow_gles3
  for name in runtime unpack draco gles3; do cmake --install marrow --prefix "$PREFIX" --component marrow_$name; done
}
install >log.txt 2>&1 || { tail -30 log.txt >&2; fail "Marrow cannot be installed"; }
cp -r "$MARROW/platform/sdl" mygame
commands 4
libraries=$PREFIX/lib
read -ra sdl_flags < <(sdl2-config --cflags)
g++ -std=c++20 -O1 -Wall -Wextra -Werror -I"$PREFIX/include" "${sdl_flags[@]}" "$tests/soles.cpp" -o soles \
  "$libraries/libmarrow_gles3.a" "$libraries/libmarrow_draco.a" "$libraries/libmarrow_unpack.a" \
  "$libraries/libmarrow_runtime.a" -ldraco -lmeshoptimizer -lSDL2
g++ -std=c++20 -O1 -Wall -Wextra -Werror -shared -fPIC "${sdl_flags[@]}" "$tests/shim.cpp" -ldl -o shim.so
./soles newt.mrw || fail "soles sink or hover"

exec 9< <(exec Xvfb -displayfd 1 -screen 0 1280x800x24 -nolisten tcp 2>xvfb.txt)
screen=$!
trap 'kill $screen' EXIT
read -r number <&9
export DISPLAY=:$number

play() {  # NAME [ARGUMENT ...]: what it prints goes to NAME.txt
  local name=$1
  shift
  mybuild/game newt.mrw --size 480x270 "$@" >"$name.txt" 2>&1 || { cat "$name.txt" >&2; return 1; }
}
same() { cmp "$1.bmp" "$2.bmp" || fail "$3"; }
block 3 | sed 's/--shot newt.bmp/--size 480x270 --watch &/' >lost.sh  # the page's own, but for the size
bash -euo pipefail lost.sh >lost.txt 2>&1 &
lost=$!
play whole --frames 120 --step 1/60 --shot whole.bmp
wait $lost || { cat lost.txt >&2; fail "the game with a lost context fails"; }
play brief --frames 20 --step 1/60 --shot brief.bmp &
brief=$!
LD_PRELOAD=./shim.so MARROW_EVENTS=reset:10 play reset --frames 20 --step 1/60 --watch --shot reset.bmp
wait $brief || fail "the game fails"
same whole newt "another picture after the context was lost"
same brief reset "another picture after SDL had made another context"
if cmp -s whole.bmp brief.bmp; then fail "nothing moves"; fi
for name in whole brief; do python3 "$tests/picture.py" $name.bmp 480x270 1.5 5 1.5; done
in_report() { grep -q "$2" "$1.txt" || { cat "$1.txt" >&2; fail "$1: $3"; }; }  # NAME PATTERN WHAT IF NOT
for name in lost reset; do in_report $name '; 0 GL errors$' "errors of GL"; done
cat whole.txt

# As somebody plays it: frames of any length, a pause, another size.
LD_PRELOAD=./shim.so MARROW_EVENTS=pause:10,quit:20 play paused --watch
LD_PRELOAD=./shim.so MARROW_EVENTS=resize:3,space:3 play resized --frames 6 --shot resized.bmp
python3 "$tests/picture.py" resized.bmp 200x300 0 0 0
within() {  # LEAST MOST NAME PATTERN WHAT: a number in what a run prints
  local value
  value=$(sed -n "s/$4.*/\1/p" "$3.txt")
  awk -v least="$1" -v most="$2" -v value="${value:--1}" 'BEGIN { exit !(least <= value && value + 0 <= most) }' ||
    { cat "$3.txt" >&2; fail "$3: $5"; }
}
within 1400 9999 paused '.*the longest took \([0-9]*\) ms' "there is no pause"
within 0.01 2.01 paused '^\([0-9.]*\) s played' "the pause is played"
within 0.001 0.31 resized '^\([0-9.]*\) s played' "the space bar does not pause"
for name in paused reset; do within 0 10 $name '.*at most \([0-9.]*\) mm' "feet float"; done
for name in paused resized; do in_report $name ' 0 allocations' "a frame allocates"; done
tail -1 paused.txt

# What is wrong, and what is said of it.
head -c 60000 newt.mrw >cut.mrw
{ head -c 70000 newt.mrw; printf X; tail -c +70002 newt.mrw; } >bit.mrw
cp "$page" text.mrw
: >empty.mrw
mkdir -p folder.mrw
marrow cook newt.glb --mesh-codec meshopt -o meshopt.mrw >log.txt
cp "$MARROW/tests/golden/dance_v1.mrw" dance.mrw
refused() {  # WHAT IT SAYS ARGUMENT ...
  local said status=0
  said=$(mybuild/game --frames 1 "${@:2}" 2>&1 >/dev/null) || status=$?
  [ $status = 1 ] || fail "exit code $status of: game ${*:2}"
  [[ $said == "game: "*$1* ]] || fail "game ${*:2} says: $said"
}
cook="Cook it: marrow sample -o newt.glb; marrow cook newt.glb --lod 0.12 -o newt.mrw"
refused "none.mrw: cannot be opened: *$cook" none.mrw
refused "cut.mrw: byte 8: truncated, the file ends before packed_bytes. $cook" cut.mrw
refused "bit.mrw: byte 24: damaged, checksum of everything behind the header. $cook" bit.mrw
refused "text.mrw: byte 0: not a cooked file, *. $cook" text.mrw
refused "newt.glb: byte 0: not a cooked file, *. $cook" newt.glb
refused "empty.mrw: is empty, too large, or no file. $cook" empty.mrw
refused "folder.mrw: is empty, too large, or no file. $cook" folder.mrw
refused "meshopt.mrw: *meshes are compressed with meshoptimizer*$cook" meshopt.mrw
refused "dance.mrw: has no animation \"walk\". $cook" dance.mrw
refused "nowhere/a.bmp: *Is the folder there?" newt.mrw --shot nowhere/a.bmp
refused "--frames x: no number; usage" --frames x
refused "--size: a value is missing; usage" --size
refused "--loose: no such option; usage" --loose 1
SDL_VIDEODRIVER=dummy refused "no window with OpenGL ES 3.0: *Update the graphics driver" newt.mrw
SDL_VIDEODRIVER=none refused "there is no screen: " newt.mrw
MESA_GLES_VERSION_OVERRIDE=2.0 refused "no window with OpenGL ES 3.0: *Update the graphics driver" newt.mrw
echo "16 times what is wrong is refused, and said"
