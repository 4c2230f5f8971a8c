#!/usr/bin/env bash
# Puts the Unity package together and tests it without Unity: its C# by Mono, over stand-ins of UnityEngine's types, and
# its native plugin by a program that plays Unity's side on Mesa. Runs the commands and compiles the C# of
# docs/platforms/unity.md, and compiles platform/unreal likewise. Exit 1 if something is wrong, 3 if there is no Mono or
# no OpenGL ES. Builds below build/unity.
# usage: tools/check/unity.sh MARROW      (the program)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
marrow=$(realpath "$1")
work="$here/build/unity"
tests="$here/tests/platform/unity"
page="$here/docs/platforms/unity.md"
skipped=0
export CMAKE_TOOLCHAIN_FILE=$here/cmake/quick.cmake
mkdir -p "$work"
if command -v ccache >/dev/null; then
  export CMAKE_C_COMPILER_LAUNCHER=${CMAKE_C_COMPILER_LAUNCHER:-ccache}
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}
fi

missing() { for name in mcs mono; do command -v "$name" >/dev/null || echo "$name"; done; }
[ -z "$(missing)" ] || "$here/tools/install.sh" "$here/tools/packages/unity.txt" || true
[ -z "$(missing)" ] || { echo "SKIPPED: Unity: there is no $(missing | paste -sd ' ')" >&2; exit 3; }

fail() { echo "check/unity: $*" >&2; exit 1; }
quietly() {  # COMMAND ...: what it says is shown if it fails
  "$@" >"$work/log.txt" 2>&1 || { cat "$work/log.txt" >&2; fail "$1 fails"; }
}
says() {  # EXIT-CODE WORDS COMMAND ...: it fails so, and says these words
  local code=$1 words=$2 said=0
  shift 2
  "$@" >"$work/said.txt" 2>&1 || said=$?
  if [ $said != "$code" ] || ! grep -qF -- "$words" "$work/said.txt"; then
    cat "$work/said.txt" >&2
    fail "exit code $said and not $code, or it does not say \"$words\""
  fi
}
run() { (cd "$work" && mono "$@"); }  # ASSEMBLY ARGUMENTS: what crashes leaves its report there
has() { grep -q -- "$1" "$2" || fail "$2 has no \"$1\""; }  # WORDS FILE
blocks() {  # LANGUAGE FOLDER [PAGE]: the page's blocks of code, a file each; how many there are
  rm -rf "$2" && mkdir -p "$2"
  awk -v fence="\`\`\`$1" -v to="$2/block" '
    inside && $0 == "```" { inside = 0; close(name) }
    inside { print > name }
    $0 == fence { inside = 1; name = to sprintf("%02d", ++count) ".txt" }
    END { print count + 0 }
  ' "${3:-$page}"
}

# The page's first commands, from the sample to the package, as they stand there.
count=$(blocks sh "$work/commands")
[ "$count" -ge 2 ] || fail "$page has lost its commands"
mkdir -p "$work/bin"
ln -sf "$marrow" "$work/bin/marrow"
mkdir -p "$work/walk"
sed -i "s|out/|$work/walk/|g" "$work/commands/block01.txt"
(cd "$here" && PATH="$work/bin:$PATH" quietly bash -euo pipefail "$work/commands/block01.txt")
package="$work/walk/com.marrow.animation"
newt="$work/walk/newt.mrw"
python3 "$here/tools/unity/metas.py" check "$here/platform/unity" >/dev/null
python3 "$here/tools/unity/metas.py" check "$package"
says 1 "is there and no package" "$here/tools/unity.sh" --no-host --out "$here/docs"
says 1 "has no marrow_c" "$here/tools/unity.sh" --no-host --out "$work/given" --ios "$here/docs"
says 1 "arm64-v8a=DIR" "$here/tools/unity.sh" --no-host --out "$work/given" --android "mips=$here"
says 2 "tools/unity.sh" "$here/tools/unity.sh" --out

# Libraries that others built: copies of this machine's stand for them.
plugins="$package/Plugins/Linux/x86_64"
mkdir -p "$work/ios"
: >"$work/ios/libmarrow_c.a"
quietly "$here/tools/unity.sh" --no-host --out "$work/given" --android "arm64-v8a=$plugins" --ios "$work/ios"
has 'CPU: ARM64' "$work/given/Plugins/Android/arm64-v8a/libmarrow_unity.so.meta"
has 'isPreloaded: 1' "$work/given/Plugins/Android/arm64-v8a/libmarrow_unity.so.meta"
has 'iPhone: iOS' "$work/given/Plugins/iOS/libmarrow_c.a.meta"
for file in Runtime/Core/MarrowFile.cs.meta Plugins.meta package.json.meta; do
  cmp -s "$package/$file" "$work/given/$file" || fail "$file: another GUID than in the other package"
done

# The package's assemblies, as its .asmdef files have them.
binding="$work/Marrow.Core.dll"
compile() { quietly mcs -unsafe -warnaserror "$@"; }  # CORE AND OTHERS BY -r ARGUMENTS
compile -target:library "-out:$binding" "$package"/Runtime/Core/{,Graphs/}*.cs
compile -target:library -define:UNITY_IOS "-out:$work/Ios.dll" "$package"/Runtime/Core/{,Graphs/}*.cs
quietly mcs -unsafe -target:library "-out:$work/UnityEngine.dll" "$tests"/StandIn*.cs
references="-r:$binding,$work/UnityEngine.dll"
compile -target:library "$references" "-out:$work/Marrow.Unity.dll" "$package"/Runtime/Unity/*.cs
compile -target:library -define:UNITY_IOS "$references" "-out:$work/UnityIos.dll" "$package"/Runtime/Unity/*.cs
references="$references,$work/Marrow.Unity.dll"
compile -target:library "$references" "-out:$work/Marrow.Editor.dll" "$package"/Editor/*.cs
compile "$references,$work/Marrow.Editor.dll" "-out:$work/Player.exe" "$tests"/Player{,Graph}.cs
compile "-r:$binding" "-out:$work/Core.exe" "$tests/Core.cs"
compile "-r:$binding" "-out:$work/Graphs.exe" "$tests/Graphs.cs"
for source in "$package"/Samples~/*/*.cs; do
  compile -target:library "$references" "-out:$work/Sample.dll" "$source"
done
[ "$(blocks csharp "$work/snippets")" -ge 4 ] || fail "$page has lost its C#"
for snippet in "$work"/snippets/*.txt; do
  compile -target:library "$references" "-out:$work/Snippet.dll" "$snippet"
done
has __Internal "$work/Ios.dll"
if grep -q __Internal "$binding"; then fail "all systems import from the program itself"; fi

# Without UnityEngine: the same as C, numbers by hand, bad files and bad calls.
export LD_LIBRARY_PATH="$plugins"
"$marrow" cook "$here/tools/sample/newt.glb" --mesh-codec none -o "$work/newt_none.mrw" >/dev/null
python3 "$tests/corner.py" "$work/corner.gltf"
"$marrow" cook "$work/corner.gltf" --mesh-codec none --clip-codec raw -o "$work/corner.mrw" >/dev/null
"$marrow" cook "$here/tools/sample/newt.glb" --clips-only --skeleton "$newt" -o "$work/pack.mrw" >/dev/null
graph=(--root '*=ground' --graph "$here/tests/examples/stages/animator.anim.toml")
"$marrow" cook "$here/tools/sample/newt.glb" "${graph[@]}" -o "$work/behaving.mrw" >/dev/null
"$marrow" cook "$here/tools/sample/newt.glb" --clips-only --skeleton "$newt" "${graph[@]}" -o "$work/graph_pack.mrw" \
  >/dev/null
"$marrow" cook "$work/corner.gltf" --mesh-codec none --clip-codec raw --root '*=full' --event turn=mark@0.25:7 \
  --graph "$tests/corner.anim.toml" -o "$work/corner_graph.mrw" >/dev/null
quietly gcc -std=c99 -pedantic -Wall -Wextra -Werror -I"$here/runtime/include" "$tests/poses.c" -o "$work/poses" \
  -L"$plugins" -lmarrow_c
for file in "$newt" "$work/newt_none.mrw"; do
  wanted=$("$work/poses" "$file")
  got=$(run "$work/Core.exe" poses "$file") || true
  [ "$got" = "$wanted" ] || fail "C# says $got of $file, and C $wanted"
  echo "poses and vertices of $(basename "$file"): $got, as C"
done
wanted=$("$work/poses" "$work/behaving.mrw" graph)
got=$(run "$work/Graphs.exe" poses "$work/behaving.mrw") || true
[ "$got" = "$wanted" ] || fail "C# says $got of a graph, and C $wanted"
echo "a graph's poses, steps and events: $got, as C"
run "$work/Graphs.exe" tests "$work"/{behaving,corner_graph,graph_pack,newt_none}.mrw || fail "graphs"
run "$work/Core.exe" hand "$work/corner.mrw" || fail "numbers by hand"
run "$work/Core.exe" tests "$newt" "$work/corner.mrw" "$work/pack.mrw" "$work" | sed "s|$work/||" ||
  fail "the part without UnityEngine"

# Libraries that are missing, of another release, of another kind, without codecs.
mkdir -p "$work"/{none,other,foreign,plain}
echo 'unsigned mrw_abi(void) { return 1; }' | gcc -shared -fPIC -x c - -o "$work/other/libmarrow_c.so"
echo 'int nothing;' | gcc -shared -fPIC -x c - -o "$work/foreign/libmarrow_c.so"
sed 's/mrw_draco_decoder/mrw_dracx_decoder/g; s/mrw_meshopt_decoder/mrw_meshopx_decoder/g' "$plugins/libmarrow_c.so" \
  >"$work/plain/libmarrow_c.so"
LD_LIBRARY_PATH="$work/none" says 2 "marrow_c: the library is not found" mono "$work/Core.exe" says "$newt"
LD_LIBRARY_PATH="$work/other" says 2 "has the ABI 00000001" mono "$work/Core.exe" says "$newt"
LD_LIBRARY_PATH="$work/foreign" says 2 "has no mrw_abi" mono "$work/Core.exe" says "$newt"
LD_LIBRARY_PATH="$work/plain" says 2 "MARROW_DRACO" mono "$work/Core.exe" says "$newt"

# With stand-ins of UnityEngine, and the render event with a stand-in of Unity.
run "$work/Player.exe" "$newt" "$work/corner.mrw" "$work/pack.mrw" "$work" \
  "$work"/{behaving,corner_graph,graph_pack}.mrw || fail "the player"
quietly gcc -std=c11 -D_GNU_SOURCE -Wall -Wextra -Werror -I"$here/runtime/include" "$tests/engine.c" -o "$work/engine" \
  -L"$plugins" -lmarrow_c -lEGL -lGLESv2 -lm -lpthread -ldl
"$marrow" cook "$here/tools/sample/newt.glb" --eigenskin 4 --effort fast --mesh-codec none -o "$work/newt_morphs.mrw" \
  >/dev/null 2>&1
drawn=0
for file in newt_none newt_morphs; do
  "$work/engine" "$plugins/libmarrow_unity.so" "$work/$file.mrw" || drawn=$?
done
case $drawn in
  0) ;;
  77) echo "SKIPPED: Unity's render event: there is no OpenGL ES 3 here" >&2; skipped=3 ;;
  *) fail "the render event" ;;
esac

# Unreal's module: what cmake installs is what it names, and a program links with that.
page="$here/docs/platforms/unreal.md"
game="$work/unreal"
module="$game/Source/ThirdParty/Marrow"
rm -rf "$game"
mkdir -p "$game"
compile "-out:$work/BuildTool.exe" "$here/tests/platform/unreal/BuildTool.cs" \
  "$here/platform/unreal/ThirdParty/Marrow/Marrow.Build.cs"
says 6 "lib/Linux/libmarrow_c.a is not there: build and install" mono "$work/BuildTool.exe" Linux "$module"
says 6 "lib/Win64/marrow_c.lib is not there" mono "$work/BuildTool.exe" Win64 "$module"
says 6 "lib/Android/arm64-v8a/libmarrow_c.a is not there" mono "$work/BuildTool.exe" Android "$module"
[ "$(blocks sh "$work/commands")" = 1 ] || fail "$page: other commands than those that are run"
(cd "$here" && GAME="$game" CMAKE_GENERATOR=Ninja quietly bash -euo pipefail "$work/commands/block01.txt")
mono "$work/BuildTool.exe" Linux "$module" >"$work/unreal.txt" || fail "Marrow.Build.cs: $(cat "$work/unreal.txt")"
cmp -s "$module/Marrow.Build.cs" "$here/platform/unreal/ThirdParty/Marrow/Marrow.Build.cs" || fail "no Marrow.Build.cs"
[ "$(blocks cpp "$work/snippets")" = 1 ] || fail "$page: other C++ than what is compiled"
cat "$work/snippets/block01.txt" "$here/tests/platform/unreal/pose.cpp" >"$work/unreal.cpp"
readarray -t named <"$work/unreal.txt"
quietly g++ -std=c++11 -Wall -Wextra -Werror "${named[0]}" "$work/unreal.cpp" "${named[@]:1}" -o "$work/unreal_pose"
"$work/unreal_pose" "$work/corner.mrw" || fail "the C++ of $page says otherwise"
exit $skipped
