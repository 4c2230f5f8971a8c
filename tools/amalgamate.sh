#!/usr/bin/env bash
# Writes the runtime, packed files included, as one header and one source: marrow.h and marrow.cpp; skinning on the GPU as
# marrow_gles3.h and marrow_gles3.cpp; both for C as marrow_c and marrow_c_gles3. Without what needs a codec or EGL.
# usage: tools/amalgamate.sh OUTDIR
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[ $# -eq 1 ] || { sed -n '4s/^# //p' "$0" >&2; exit 1; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$here/runtime"

version() {  # MAJOR, MINOR, PATCH of version.h
  awk '/^#define MARROW_VERSION_/ { printf "%s%s", dot, $3; dot = "." }' include/marrow/version.h
}

# Files with what they include by quotes in place, each once. `seen`: those that count as included, a file each line.
expand() {  # SEEN FILE…
  awk '
    function place(name) {
      return (getline line < ("include/" name)) >= 0 ? "include/" name : name
    }
    function emit(file,   text, name) {
      if (file in seen) return
      seen[file] = 1
      emitted[++count] = file
      printf "\n// ---- %s\n", file
      while ((getline text < file) > 0) {
        if (text ~ /^#include "/) {
          split(text, parts, "\"")
          name = place(parts[2])
          close(name)
          emit(name)
        } else if (text !~ /^#pragma once/) {
          print text
        }
      }
      close(file)
    }
    BEGIN {
      list = ARGV[1]
      while ((getline file < list) > 0) seen[file] = 1
      for (i = 2; i < ARGC; ++i) emit(ARGV[i])
      for (i = 1; i <= count; ++i) print emitted[i] >> list
    }' "$@"
}

title() {  # NAME WHAT
  cat <<EOF
// Marrow $(version): $2, made one file by tools/amalgamate.sh. Compile as C++20, without -ffast-math; with
// -ffp-contract=off poses are the same bits on every processor. MIT licence, below.
//
$(sed 's|^|// |; s| *$||' "$here/LICENSE")
EOF
}

sources() {  # CMAKELISTS
  sed -nE 's/^  ([a-z0-9_/]+\.cpp)$/\1/p' "$1"
}

seen=$(mktemp)
trap 'rm -f "$seen"' EXIT
{ title marrow.h "the runtime's header"; echo '#pragma once'; expand "$seen" include/marrow/marrow.h; } >"$out/marrow.h"
{
  title marrow.cpp "the runtime"
  printf '#include "marrow.h"\n'
  expand "$seen" $(sources CMakeLists.txt)
} >"$out/marrow.cpp"
: >"$seen"
grep -h '^// ---- ' "$out/marrow.h" | cut -c9- >"$seen"
{
  title marrow_gles3.h "the header of skinning by OpenGL ES 3.0"
  printf '#pragma once\n\n#include "marrow.h"\n'
  expand "$seen" include/marrow/gles3*.h
} >"$out/marrow_gles3.h"
{
  title marrow_gles3.cpp "skinning by OpenGL ES 3.0"
  printf '#include "marrow_gles3.h"\n'
  expand "$seen" $(sources gles3/CMakeLists.txt | sed 's|^|gles3/|')
  sed -nE 's/^marrow_embed\(marrow_gles3 ([a-z_]+) \$\{shaders\}\/([a-z_.]+)\)$/\1 \2/p' gles3/CMakeLists.txt |
    while read -r name file; do
      cmake -DIN="$here/shaders/$file" -DOUT="$seen.shader" -DNAME="$name" -P "$here/cmake/embed.cmake"
      printf '\n// ---- shaders/%s\n' "$file"
      cat "$seen.shader"
      rm -f "$seen.shader"
    done
} >"$out/marrow_gles3.cpp"
# For C: the headers stand alone, the sources are C++.
for_c() {  # PART WHAT
  local name=marrow_c${1:+_$1} cpp=marrow${1:+_$1}.h
  : >"$seen"
  [ -z "$1" ] || echo include/marrow/c.h >"$seen"
  {
    title "$name.h" "the header of $2 for C99"
    [ -z "$1" ] || printf '\n#include "marrow_c.h"\n'
    expand "$seen" "include/marrow/c${1:+_$1}.h"
  } >"$out/$name.h"
  grep -h '^// ---- ' "$out/marrow.h" "$out/$cpp" "$out/marrow_c.h" "$out/$name.h" | cut -c9- >"$seen"
  {
    title "$name.cpp" "$2 for C"
    printf '#include "%s"\n#include "%s"\n' "$cpp" "$name.h"
    expand "$seen" "c/${1:+$1_}wrappers.cpp"
  } >"$out/$name.cpp"
}
for_c "" "the runtime"
for_c gles3 "skinning by OpenGL ES 3.0"
wc -l "$out"/marrow*.h "$out"/marrow*.cpp | awk '{ print $2 ": " $1 " lines" }' | grep -v total
