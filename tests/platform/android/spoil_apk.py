"""Spoils an APK in one way, for tools/check/android.sh.

usage: spoil_apk.py STORY IN.apk OUT.apk
"""
import struct
import sys
import zipfile

ASSET, RAMP, LIBRARY, HERE = "assets/newt.mrw", "assets/ramp.rgb", "lib/arm64-v8a/libnewt.so", "lib/x86_64/libnewt.so"
CUT = {"cut-asset": (ASSET, 1000), "empty-asset": (ASSET, 0), "cut-texture": (RAMP, 100), "cut-library": (LIBRARY, 70)}


def small_pages(data):
    """Says of each segment that is loaded that 4 KB are enough."""
    out = bytearray(data)
    table, = struct.unpack_from("<Q", data, 32)
    size, count = struct.unpack_from("<HH", data, 54)
    for at in range(table, table + size * count, size):
        if struct.unpack_from("<I", data, at)[0] == 1:
            struct.pack_into("<Q", out, at + 48, 4096)
    return bytes(out)


def contents(story, name, data, archive):
    if CUT.get(story, ("",))[0] == name:
        return data[:CUT[story][1]]
    if story == "damaged-asset" and name == ASSET:
        return data[:5000] + bytes([data[5000] ^ 1]) + data[5001:]
    if story == "other-abi" and name == LIBRARY:
        return archive.read(HERE)
    if story == "small-pages" and name == LIBRARY:
        return small_pages(data)
    if story == "new-import" and name == HERE:
        return data.replace(b"timerfd_create", b"timerfd_invent")
    if story == "no-library" and name == LIBRARY:
        return b"What this is, a linker would not say."
    return data


def padding(begin, name, story):
    """Bytes of an extra field, so that what begins behind it lies where a good APK has it, or 4 bytes behind."""
    boundary = 16384 if name.startswith("lib/") else 16 if name == ASSET else 4
    out = -begin % boundary
    if (story, name) in (("unaligned-asset", ASSET), ("unaligned-library", LIBRARY)):
        out += 4
    return out + boundary if 0 < out < 4 else out


def main():
    story, source, target = sys.argv[1:]
    gone = {"no-asset": ASSET, "no-texture": RAMP}.get(story)
    compressed = {"compressed-asset": ASSET, "compressed-library": LIBRARY}.get(story)
    with zipfile.ZipFile(source) as old, open(target, "wb") as file, zipfile.ZipFile(file, "w") as new:
        for entry in old.infolist():
            name = entry.filename
            if name == gone:
                continue
            out = zipfile.ZipInfo(name)
            out.compress_type = zipfile.ZIP_DEFLATED if name == compressed else entry.compress_type
            size = padding(file.tell() + 30 + len(name), name, story)
            if out.compress_type == zipfile.ZIP_STORED and size:
                out.extra = struct.pack("<HH", 0xD935, size - 4) + bytes(size - 4)
            new.writestr(out, contents(story, name, old.read(name), old))


if __name__ == "__main__":
    main()
