#!/usr/bin/env bash
# Installs Marrow, static and shared, and builds a game with it in each of the ways of docs/install.md, whose programs,
# CMake files and commands it runs as they stand there. All games must print the same. Also: what shared libraries
# export, that the installation can be moved, that a version that does not fit is refused. Marrow is built three times, of an
# archive, static and shared, and compiled as one source. Writes to a temporary folder.
# usage: tools/check/install.sh
set -euo pipefail
MARROW=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export MARROW CMAKE_TOOLCHAIN_FILE=$MARROW/cmake/quick.cmake
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
export CMAKE_GENERATOR=Ninja  # which says what it would do
if command -v ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}; fi
character=$MARROW/tests/golden/dance_v1.mrw
packed=$MARROW/tests/fuzz/seeds/dance-draco.mrw

fail() { echo "check/install: $*" >&2; exit 1; }

# The first block of code of a language under a heading of docs/install.md.
block() {  # HEADING LANGUAGE
  awk -v heading="## $1" -v fence="\`\`\`$2" '
    /^## / { here = $0 == heading }
    inside && $0 == "```" { exit }
    inside { print }
    here && $0 == fence { inside = 1 }
  ' "$MARROW/docs/install.md" | grep . || fail "docs/install.md has no $2 under \"$1\""
}

# Runs a heading's commands in the folder that is current.
commands() {
  block "$1" sh >commands.sh
  bash -euo pipefail commands.sh >log 2>&1 || { tail -30 log >&2; fail "$1"; }
}

folder() { mkdir -p "$work/$1" && cd "$work/$1" && block "The program" cpp >game.cpp; }

# Whether the game in the folder that is current prints what the first one did.
same() {  # WHAT [FOLDER OF LIBRARIES]
  LD_LIBRARY_PATH=${2:-} build/game "$character" >printed || fail "$1: the game fails"
  [ -e "$work/numbers" ] || cp printed "$work/numbers"
  [ "$(wc -l <printed)" -gt 1 ] || fail "$1: the game prints next to nothing"
  cmp -s printed "$work/numbers" || { diff printed "$work/numbers" >&2; fail "$1: other numbers"; }
  echo "$1: the same $(wc -l <printed) lines"
}

consumer() {  # NAME HEADING
  folder "$1"
  block "$2" cmake >CMakeLists.txt
}

# Of a heading's commands those that configure, in the folder that is current.
configure() {
  block "$1" sh | sed '/--build/d' >configure.sh
  bash -euo pipefail configure.sh >log 2>&1 || { tail -30 log >&2; fail "$1"; }
}

# What of Marrow would be made in the folder that is current, for a target or for all, wherever the sources lie.
parts() { ninja -C build -t commands "$@" | grep -oE '(runtime|platform)/[^ ]*\.[oa]( |$)' | tr -d ' ' | sort -u; }

# An archive of what a game's build reads is built.
fetch_content() {
  consumer fetch_content FetchContent
  tar -czf marrow.tar.gz -C "$MARROW" --transform 's|^|marrow/|' CMakeLists.txt cmake runtime shaders \
    platform/CMakeLists.txt platform/egl
  commands FetchContent
  same FetchContent
  [ "$(find build -name 'libmarrow_*')" = build/_deps/marrow-build/runtime/libmarrow_runtime.a ] ||
    fail "FetchContent builds other than it links"
}

# It would build the same, and nothing that nobody links.
add_subdirectory() {
  consumer add_subdirectory add_subdirectory
  ln -s "$MARROW" marrow
  configure add_subdirectory
  (cd ../fetch_content && parts) >wanted
  [ "$(wc -l <wanted)" -gt 5 ] || fail "FetchContent makes next to nothing"
  [ "$(block add_subdirectory sh | tail -1)" = "cmake --build build --target game" ] || fail "another target than game"
  for target in game all; do
    parts $target | diff - wanted >&2 || fail "add_subdirectory, $target: builds other than FetchContent does"
  done
  echo "add_subdirectory: the same $(wc -l <wanted) parts as by FetchContent"
}

install_static() {
  mkdir -p "$work/install" && cd "$work/install"
  PREFIX=$work/first commands Install
  mv "$work/first" "$work/static"
  diff <(ls "$MARROW/runtime/include/marrow" "$MARROW/platform/egl/include/marrow" | grep '\.h$' | sort) \
    <(ls "$work/static/include/marrow" | sort) >&2 || fail "other headers are installed than there are"
  if grep -rlE "$work|$MARROW|/usr/lib" "$work/static" --include='*.cmake' --include='*.pc'; then
    fail "the installation names a folder"
  fi
}

find_package() {  # static or shared
  consumer "find_package_$1" find_package
  PREFIX=$work/$1 commands find_package
  same "find_package, $1"
}

every_component() {  # static or shared
  folder "components_$1"
  cat >CMakeLists.txt <<'EOF'
cmake_minimum_required(VERSION 3.24)
project(game LANGUAGES CXX)
find_package(marrow REQUIRED)
add_executable(game game.cpp)
target_link_libraries(game PRIVATE marrow::draco marrow::meshopt marrow::gles3 marrow::egl marrow::c marrow::c_gles3)
EOF
  cat >game.cpp <<'EOF'
#include <marrow/c.h>
#include <marrow/c_gles3.h>
#include <marrow/draco.h>
#include <marrow/egl.h>
#include <marrow/gles3.h>
#include <marrow/marrow.h>
#include <marrow/meshopt.h>
int main() {
  marrow::gles3::Api api;
  return marrow::draco_decoder().decode != nullptr && marrow::meshopt_decoder().decode != nullptr &&
                 load_api(api, marrow::egl::load_proc) != marrow::Status::bad_argument && mrw_abi() == MRW_ABI &&
                 mrw_gles3_abi() == MRW_GLES3_ABI
             ? 0
             : 1;
}
EOF
  PREFIX=$work/$1 commands find_package
  build/game || fail "every component, $1"
  echo "every component, $1: linked and run"
}

other_version() {
  consumer other_version find_package
  sed -i 's/marrow 0\.1/marrow 0.0.1/' CMakeLists.txt
  if cmake -B build -DCMAKE_PREFIX_PATH="$work/static" >log 2>&1; then fail "another minor version is found"; fi
  grep -q 'not accepted' log || { cat log >&2; fail "another version fails in another way"; }
  sed -i 's/marrow 0\.0\.1 REQUIRED COMPONENTS runtime/marrow REQUIRED COMPONENTS teeth/' CMakeLists.txt
  if cmake -B build -DCMAKE_PREFIX_PATH="$work/static" >log 2>&1; then fail "a component that is none is found"; fi
  grep -q 'there is no marrow::teeth' log || fail "who misses a component is not told which"
}

pkg_config() {  # static or shared
  folder "pkg_config_$1"
  PREFIX=$work/$1 commands pkg-config
  same "pkg-config, $1" "$work/$1/lib"
}

install_shared() {
  mkdir -p "$work/install_shared" && cd "$work/install_shared"
  PREFIX=$work/shared commands "Shared libraries"
  "$MARROW/tests/install/exports.sh" "$work/shared"
  for library in "$work"/shared/lib/libmarrow_*.so; do
    readelf -d "$library" | grep -q "SONAME.*$(basename "$library")\.[0-9]" || fail "$library has no SONAME"
  done
}

in_a_shared_library() {
  consumer engine "In a shared library of the game"
  sed 's/^int main(/int play(/' game.cpp >engine.cpp
  block "In a shared library of the game" cpp >game.cpp
  PREFIX=$work/static commands "In a shared library of the game"
  same "in a game's shared library"
  if nm -D --defined-only -C build/libengine.so | grep ' T marrow::'; then fail "the engine exports Marrow"; fi
}

one_source() {
  local warnings="-Werror -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wundef
    -Wcast-align -Wdouble-promotion"
  folder one_source
  # The page's commands, but that warnings are errors, and with less optimisation, which finds them in half the time.
  block "One source file" sh | sed "s/ -O2 / -O1 /; s| -c marrow/| ${warnings//[[:space:]]/ }&|" >commands.sh
  bash -euo pipefail commands.sh >log 2>&1 || { tail -30 log >&2; fail "one source file"; }
  same "one source file"
  for_c_program | sed 's|<marrow/c_gles3.h>|"marrow/marrow_c_gles3.h"|' >c.c
  # shellcheck disable=SC2086  # several words
  printf '%s\n' marrow_gles3 marrow_c marrow_c_gles3 |
    xargs -P "$CMAKE_BUILD_PARALLEL_LEVEL" -I NAME g++ -std=c++20 -O1 -ffp-contract=off -fno-exceptions -fno-rtti $warnings \
      -c marrow/NAME.cpp -o build/NAME.o || fail "one source file: marrow_gles3, marrow_c or marrow_c_gles3"
  gcc "${c99[@]}" c.c build/marrow*.o -lm -o build/c
  build/c || fail "one source file: the C program fails"
}

# A program in C that links marrow::c_gles3 alone.
c99=(-std=c99 -pedantic -Wall -Wextra -Werror)
for_c_program() {
  cat <<'EOF'
#include <marrow/c_gles3.h>
static void* no_driver(const char* name) {
  return (void)name, (void*)0;
}
static void on_call_error(const char* function, const char* condition) {
  (void)function, (void)condition;
}
int main(void) {
  static mrw_gles3_api api;
  const char* missing = "";
  mrw_gles3_caps caps;
  mrw_gles3_caps_init(&caps);
  mrw_set_call_error_handler(on_call_error);
  return mrw_abi() == MRW_ABI && mrw_gles3_abi() == MRW_GLES3_ABI && caps.vertex_attributes == 16 &&
                 mrw_gles3_load_api(&api, no_driver, &missing) == MRW_UNSUPPORTED && missing[0] == 'g' &&
                 mrw_gles3_query_caps(&api, &caps) == MRW_BAD_ARGUMENT
             ? 0
             : 1;
}
EOF
}

a_c_program() {  # static or shared
  mkdir -p "$work/c_$1" && cd "$work/c_$1"
  for_c_program >game.c
  cat >CMakeLists.txt <<'EOF'
cmake_minimum_required(VERSION 3.24)
project(game LANGUAGES C CXX)
find_package(marrow REQUIRED COMPONENTS c_gles3)
add_executable(game game.c)
target_link_libraries(game PRIVATE marrow::c_gles3)
EOF
  PREFIX=$work/$1 commands find_package
  build/game || fail "a C program, $1"
  PKG_CONFIG_PATH=$work/$1/lib/pkgconfig
  export PKG_CONFIG_PATH
  gcc "${c99[@]}" game.c $(pkg-config --cflags --libs marrow-c_gles3) -o game
  LD_LIBRARY_PATH=$work/$1/lib ./game || fail "a C program by pkg-config, $1"
  echo "a C program, $1: by find_package and by pkg-config"
}

a_packed_file() {
  consumer packed "A packed file"
  block "A packed file" cpp >game.cpp
  PREFIX=$work/static commands find_package
  build/game "$packed" >printed
  grep -E '^.+: [1-9][0-9]* vertices$' printed || fail "the packed file is not unpacked"
  PKG_CONFIG_PATH=$work/static/lib/pkgconfig
  export PKG_CONFIG_PATH
  g++ -std=c++20 game.cpp $(pkg-config --cflags --libs marrow-draco) -o game
  ./game "$packed" | cmp - printed || fail "the packed file, by pkg-config: other numbers"
}

fetch_content
add_subdirectory
install_static
find_package static
every_component static
a_c_program static
other_version
pkg_config static
in_a_shared_library
a_packed_file
install_shared
find_package shared
every_component shared
a_c_program shared
pkg_config shared
one_source
