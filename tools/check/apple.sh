#!/usr/bin/env bash
# Makes the package for iOS by tools/apple.sh and looks at every slice: formats, processors, systems, symbols, module,
# what it links to and how large. Code of the slices then runs here, and its vertices are compared with those of
# `marrow pose`; where there is a Swift compiler ($SWIFTC, or swiftc), so are those of the Swift example. Exit 1 if
# something differs, 3 if a tool cannot be had. Builds below build/apple; the commands of docs/platforms/ios.md write to
# out/apple.
# usage: tools/check/apple.sh MARROW      (the program)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$(realpath "$1")
work=$here/build/apple/check
tests=$here/tests/platform/apple
package=$here/out/apple
page=$here/docs/platforms/ios.md
skipped=0
fail() { echo "check/apple: $*" >&2; exit 1; }
skip() { echo "SKIPPED: $*" >&2; skipped=3; }
has() { for name in "$@"; do command -v "$name" >/dev/null || return 1; done; }
quietly() { "$@" >"$work/log.txt" 2>&1 || { cat "$work/log.txt" >&2; exit 1; }; }

"$here/tools/install.sh" "$here"/tools/packages/apple{,-check}.txt || true
for tool in clang-19 clang++-19 ld64.lld-19 llvm-objdump-19 llvm-otool-19 llvm-libtool-darwin-19 python3; do
  has $tool || { echo "SKIPPED: the package for iOS: there is no $tool" >&2; exit 3; }
done
rm -rf "$work" && mkdir -p "$work"

# The page's commands for this machine, in the order in which they stand there.
run_page() {
  awk '/^```sh$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$page" >"$work/page.sh"
  [ -s "$work/page.sh" ] || fail "docs/platforms/ios.md has no commands"
  mkdir -p "$work/bin" && ln -sf "$marrow" "$work/bin/marrow"
  (cd "$here" && PATH=$work/bin:$PATH quietly bash -euo pipefail "$work/page.sh")
  # What it shows of Swift is what is compiled.
  if awk '/^```swift$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$page" |
    grep -vxF -f <(cat "$here"/platform/apple/Example/*.swift "$here"/platform/apple/Example/gpu/*.swift) >&2; then
    fail "docs/platforms/ios.md: these lines of Swift are in no file of platform/apple/Example"
  fi
}

look() { python3 "$tests/xcframework.py" "$here" "$1"; }

# A damaged package is refused, with the file's name and what is wrong.
plant() {  # WHAT THE MESSAGE HAS, COMMAND ... (in a copy of the package)
  local wanted=$1 said
  shift
  rm -rf "$work/damaged" && cp -r "$package" "$work/damaged"
  (cd "$work/damaged/Marrow.xcframework" && quietly "$@")
  if said=$(look "$work/damaged" 2>&1 >/dev/null); then fail "takes a package after: $*"; fi
  [[ $said == "xcframework: $work/damaged/"*"$wanted"*": make the package anew by tools/apple.sh" ]] ||
    fail "after $* says: $said"
}
bad_packages() {
  local device=ios-arm64 simulator=ios-arm64_x86_64-simulator
  plant "is no property list" truncate -s -20 Info.plist
  plant "is no property list" truncate -s 100 ../Sources/MarrowKit/PrivacyInfo.xcprivacy
  plant "says other than that nothing" sed -i '0,/<false\/>/s//<true\/>/' ../Sources/MarrowKit/PrivacyInfo.xcprivacy
  plant "No such file" rm Info.plist
  plant "and there are" rm -r $device
  plant "there is no libMarrow.a" rm $device/libMarrow.a
  plant "what it says of itself is" sed -i '0,/<string>x86_64</s//<string>i386</' Info.plist
  plant "is for" cp $device/libMarrow.a $simulator/libMarrow.a
  plant "is for ios-simulator, and not for ios" \
    llvm-lipo-19 $simulator/libMarrow.a -thin arm64 -output $device/libMarrow.a
  plant "ends at byte" truncate -s -1000 $device/libMarrow.a
  plant "the file at" truncate -s -1000 $simulator/libMarrow.a
  plant "is no archive" cp Info.plist $device/libMarrow.a
  plant "is another's" sed -i '1s/.*//' $device/Headers/marrow/c.h
  plant "names" sed -i '/c_gles3/d' $device/Headers/marrow/module.modulemap
  # An object that is for the right system, but calls what it may not, and a library without an object.
  echo 'extern int stat(void); int mrw_more(void) { return stat(); }' >"$work/more.c"
  clang-19 -target arm64-apple-ios14.0 -c "$work/more.c" -o "$work/more.o"
  plant "wants of the system what it should not: ['_stat']" \
    llvm-libtool-darwin-19 -static -o $device/libMarrow.a $device/libMarrow.a "$work/more.o"
  clang-19 -target arm64-apple-ios15.0 -c "$work/more.c" -o "$work/more.o"
  plant "needs 15.0, and not 14.0" \
    llvm-libtool-darwin-19 -static -o $device/libMarrow.a "$work/more.o" $device/libMarrow.a
  plant "functions are missing" llvm-libtool-darwin-19 -static -o $device/libMarrow.a \
    "$here"/build/apple/$device/arm64/runtime/libmarrow_{runtime,unpack}.a
  echo "damaged packages: refused, each with its file and what is wrong"
}

# The same bits need multiplications and additions apart.
no_fused_arithmetic() {
  local library
  for library in "$here"/build/apple/*/arm64/libMarrow.a; do
    llvm-objdump-19 -d --no-show-raw-insn "$library" | awk -F '\t' '
      { ++count } $2 ~ /^f(n?madd|n?msub|mla|mls)/ { print; bad = 1 } END { exit bad || count < 10000 }' >&2 ||
      fail "$library: multiplies and adds in one instruction, or has next to none"
  done
}

targets="ios-arm64/arm64-apple-ios14.0 ios-arm64_x86_64-simulator/arm64-apple-ios14.0-simulator
  ios-arm64_x86_64-simulator/x86_64-apple-ios14.0-simulator"
xcframework=$package/Marrow.xcframework
headers=(-nostdlibinc -isystem "$tests/headers/c")

module() {
  local target slice
  for target in $targets; do
    slice=$xcframework/${target%%/*}
    target=${target##*/}
    quietly clang-19 -target "$target" "${headers[@]}" -fmodules -fmodules-cache-path="$work/modules" -Wall -Werror \
      -I"$slice/Headers" -fsyntax-only "$tests/import.m"
    quietly clang++-19 -target "$target" -std=c++20 -nostdinc++ -nostdlibinc -isystem "$tests/headers/libc++" \
      -isystem /usr/lib/llvm-19/include/c++/v1 -isystem "$tests/headers/c" -Wall -Werror -I"$slice/Headers" \
      -fsyntax-only "$tests/import.mm"
  done
  echo "the module: imported by Objective-C; the C++ headers: included by Objective-C++"
}

# An executable of a file here, of a slice, and of what is known of the system's library.
link() {  # SLICE TARGET SOURCE FLAG ...
  local slice=$xcframework/$1 target=$2 source=$3 platform=ios
  shift 3
  [[ $target != *-simulator ]] || platform=ios-simulator
  quietly clang-19 -target "$target" -Os -ffp-contract=off "${headers[@]}" -I"$slice/Headers" -Wall -Werror \
    -c "$tests/$source.c" -o "$work/$source.o"
  quietly ld64.lld-19 -arch "${target%%-*}" -platform_version $platform 14.0 14.0 -fixup_chains -e _road \
    -fatal_warnings "$@" -o "$work/$source-$target" "$work/$source.o" "$slice/libMarrow.a" "$work/libSystem.tbd"
}
code_and_data() {  # EXECUTABLE: without what pads its segments
  llvm-size-19 -m "$1" | awk '/^\tSection/ && $2 !~ /__bss/ { sum += $3 } END { print sum }'
}
link_all() {
  local target slice said with with_gpu without
  python3 "$tests/xcframework.py" --stub >"$work/libSystem.tbd"
  for target in $targets; do
    slice=${target%%/*}
    target=${target##*/}
    link "$slice" "$target" empty -all_load  # all that is wanted is there
    link "$slice" "$target" empty -dead_strip
    link "$slice" "$target" gpu -dead_strip
    link "$slice" "$target" road -dead_strip
    said=$(llvm-otool-19 -l "$work/road-$target" | awk '
      $1 == "cmd" { command = $2 }
      command == "LC_BUILD_VERSION" && /platform|minos/ { printf "%s ", $2 }
      command == "LC_LOAD_DYLIB" && $1 == "name" { printf "%s", $2 }')
    case $target in
      *-simulator) [ "$said" = "7 14.0 /usr/lib/libSystem.B.dylib" ] || fail "$target: is linked for $said" ;;
      *) [ "$said" = "2 14.0 /usr/lib/libSystem.B.dylib" ] || fail "$target: is linked for $said" ;;
    esac
    if llvm-otool-19 -l "$work/gpu-$target" | grep -E '__init_offsets|__mod_init_func' >&2; then
      fail "$target: something would run before main(), which nothing here runs"
    fi
    without=$(code_and_data "$work/empty-$target")
    with=$(code_and_data "$work/road-$target") with_gpu=$(code_and_data "$work/gpu-$target")
    echo "$target: the road adds $((with - without)) B to an executable; with the GPU it is $((with_gpu - without)) B"
  done
}

# Code for iOS, here: what an executable imports is the C library's, as there.
run_road() {  # TARGET COMPILER [EMULATOR]
  local target=$1 compiler=$2 emulator=${3:-} said
  $compiler -O2 -Wall -Wextra -Werror "$tests/run_macho.c" -o "$work/run-$target" -lm
  $emulator "$work/run-$target" "$work/road-$target" "$package/newt.mrw" walk 0.4 "$work/$target.bin" ||
    fail "$target: stops"
  python3 "$tests/same_vertices.py" "$work/pose.bin" "$work/$target.bin" || fail "$target: other vertices"
  for bad in packed cut; do
    if said=$($emulator "$work/run-$target" "$work/road-$target" "$work/$bad.mrw" walk 0.4 "$work/bad.bin" 2>&1); then
      fail "$target: takes $bad.mrw"
    fi
    [[ $said == "run_macho: road.c stops at line "* ]] || fail "$target: of $bad.mrw says: $said"
  done
  echo "$target: runs here; its vertices are those of marrow pose, bit for bit"
}
run_all() {
  quietly "$marrow" pose "$package/newt.mrw" --clip walk --time 0.4 -o "$work/pose.bin"
  quietly "$marrow" cook "$here/tools/sample/newt.glb" --mesh-codec meshopt -o "$work/packed.mrw"
  head -c 100000 "$package/newt.mrw" >"$work/cut.mrw"
  if [ "$(uname -m)" = x86_64 ]; then
    run_road x86_64-apple-ios14.0-simulator gcc
    if has aarch64-linux-gnu-gcc qemu-aarch64; then
      run_road arm64-apple-ios14.0 "aarch64-linux-gnu-gcc -static" qemu-aarch64
    else
      skip "iOS code for arm64 does not run: there is no aarch64-linux-gnu-gcc or qemu-aarch64"
    fi
  else
    run_road arm64-apple-ios14.0 gcc
  fi
}

names() {
  python3 "$tests/swift_names.py" "$here/runtime/include/marrow" "$page" "$here"/platform/apple/Example/*.swift \
    "$here"/platform/apple/Example/gpu/*.swift "$here"/platform/apple/Sources/MarrowKit/*.swift || fail "names"
  echo 'mrw_no_such_function()' >"$work/wrong.swift"
  if python3 "$tests/swift_names.py" "$here/runtime/include/marrow" "$work/wrong.swift" >/dev/null 2>&1; then
    fail "takes a name that is none"
  fi
}

# Debian 12 has no Swift. Where there is one, the example is compiled, with Apple's modules declared by hand, and its
# road runs.
swift() {
  local compiler=${SWIFTC:-swiftc} modules=$work/swift name
  has "$compiler" || { echo "Swift: not compiled, as there is no swiftc; its names were looked up" >&2; return; }
  mkdir -p "$modules" && cd "$modules"
  for name in SwiftUI MetalKit; do
    quietly "$compiler" -parse-as-library -emit-module -module-name $name "$tests/stand_in/$name.swift"
  done
  quietly "$compiler" -O -parse-as-library -emit-module -module-name MarrowKit -emit-library -static \
    -I "$xcframework/ios-arm64/Headers" "$here/platform/apple/Sources/MarrowKit/MarrowKit.swift"
  quietly "$compiler" -typecheck -warnings-as-errors -parse-as-library -I . -I "$xcframework/ios-arm64/Headers" \
    -import-objc-header "$tests/stand_in/egl.h" "$here"/platform/apple/Example/{,gpu/}*.swift
  quietly cmake -G Ninja -S "$here" -B native -DCMAKE_BUILD_TYPE=Release -DMARROW_TOOLS=OFF -DMARROW_TESTS=OFF
  quietly cmake --build native --target marrow_c
  quietly "$compiler" -O -parse-as-library -static-stdlib -I . -I "$xcframework/ios-arm64/Headers" -module-name road \
    -wmo "$here/platform/apple/Example/Puppet.swift" "$tests/road.swift" -o road -L . -lMarrowKit \
    native/runtime/c/libmarrow_c.a native/runtime/libmarrow_unpack.a native/runtime/libmarrow_runtime.a
  quietly ./road "$package/newt.mrw" walk 0.4 swift.bin
  python3 "$tests/same_vertices.py" "$work/pose.bin" swift.bin || fail "Swift: other vertices"
  for name in packed cut; do
    if ./road "$work/$name.mrw" walk 0.4 bad.bin >said.txt; then fail "Swift: takes $name.mrw"; fi
    grep -qF "$name.mrw" said.txt || fail "Swift: of $name.mrw says: $(cat said.txt)"
    cat said.txt
  done
  echo "Swift: the example's types fit; its road gives the vertices of marrow pose, bit for bit"
}

run_page
look "$package" || exit 1
bad_packages
no_fused_arithmetic
module
link_all
run_all
names
swift
exit $skipped
