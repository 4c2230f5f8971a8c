#!/usr/bin/env python3
"""Puts an APK's stored entries where they can be used in place: libraries on pages of 16 KB, cooked files on 16 bytes.

usage: align_apk.py IN.apk OUT.apk [STORED ...]
STORED: patterns of further names that are stored without compression, as assets/*.bin. Libraries (lib/*.so) and cooked
files (*.mrw) always are. Sign the APK afterwards: apksigner keeps the places, by the extra field that is written here.
"""
import fnmatch
import struct
import sys
import zipfile

ALIGNMENT_FIELD = 0xD935  # of Android's own tools: the boundary, then the padding
LOCAL_HEADER = 30  # bytes before an entry's name


def boundary_of(name):
    if name.startswith("lib/") and name.endswith(".so"):
        return 16384
    return 16 if name.endswith(".mrw") else 4


def is_stored(name, patterns):
    return boundary_of(name) > 4 or any(fnmatch.fnmatch(name, p) for p in patterns)


def align(source, target, patterns):
    with zipfile.ZipFile(source) as old, open(target, "wb") as file, zipfile.ZipFile(file, "w") as new:
        for entry in old.infolist():
            name = entry.filename
            if name.startswith("META-INF/") and name.rsplit(".", 1)[-1] in ("SF", "RSA", "DSA", "EC", "MF"):
                continue  # a signature of what was before
            out = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            out.external_attr = 0o644 << 16
            stored = entry.compress_type == zipfile.ZIP_STORED or is_stored(name, patterns)
            out.compress_type = zipfile.ZIP_STORED if stored else zipfile.ZIP_DEFLATED
            if stored:
                boundary = boundary_of(name)
                begin = file.tell() + LOCAL_HEADER + len(name.encode()) + 6
                padding = -begin % boundary
                out.extra = struct.pack("<HHH", ALIGNMENT_FIELD, 2 + padding, boundary) + bytes(padding)
            new.writestr(out, old.read(entry))


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    try:
        align(sys.argv[1], sys.argv[2], sys.argv[3:])
    except (OSError, zipfile.BadZipFile) as error:
        sys.exit(f"align_apk: {sys.argv[1]}: {error}")


if __name__ == "__main__":
    main()
