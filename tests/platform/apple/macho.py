"""Reads Mach-O objects, archives of them and fat files, as far as tests/platform/apple/xcframework.py asks."""

import dataclasses
import struct

PROCESSORS = {0x0100000C: "arm64", 0x01000007: "x86_64"}
PLATFORMS = {1: "macos", 2: "ios", 7: "ios-simulator"}
BUILD_VERSION, SYMTAB = 0x32, 0x2
OBJECT = 1


class Damaged(Exception):
    """What is wrong with the bytes."""


@dataclasses.dataclass
class Object:
    """What an object says of itself."""

    name: str
    processor: str
    platform: str
    minimum: str  # of the system's versions
    defined: set
    undefined: set


def unpack(form, data, offset):
    """struct.unpack_from that says when data end."""
    try:
        return struct.unpack_from(form, data, offset)
    except struct.error:
        raise Damaged(f"ends at byte {len(data)}, within what begins at byte {offset}") from None


def fat_parts(data):
    """The parts of a fat file, or the whole of another, by processor (None: another)."""
    if data[:4] != b"\xca\xfe\xba\xbe":
        return {None: data}
    (count,) = unpack(">I", data, 4)
    parts = {}
    for index in range(count):
        processor, _, offset, size, _ = unpack(">5I", data, 8 + 20 * index)
        if offset + size > len(data):
            raise Damaged(f"part {index} ends at byte {offset + size}, the file at {len(data)}")
        name = PROCESSORS.get(processor)
        if name is None or name in parts:
            raise Damaged(f"part {index} is for processor {processor:#x}, which is unknown or there twice")
        parts[name] = data[offset : offset + size]
    return parts


def members(data):
    """Name and bytes of each member of an archive, but for its table of contents."""
    if data[:8] != b"!<arch>\n":
        raise Damaged("is no archive")
    offset = 8
    while offset < len(data):
        header = data[offset : offset + 60]
        if len(header) < 60 or header[58:] != b"`\n" or not header[48:58].strip().isdigit():
            raise Damaged(f"has no header of a member at byte {offset}")
        size = int(header[48:58])
        begin, end = offset + 60, offset + 60 + size
        if end > len(data):
            raise Damaged(f"ends at byte {len(data)}, within the member at byte {offset}")
        name = header[:16].decode("latin1").strip()
        if name.startswith("#1/"):
            length = int(name[3:])
            name = data[begin : begin + length].rstrip(b"\0").decode("latin1")
            begin += length
        if not name.startswith("__.SYMDEF"):
            yield name, data[begin:end]
        offset = end + end % 2


def symbols(data, offset, count, texts):
    """Names that an object defines for others, and that it wants of others."""
    defined, undefined = set(), set()
    for index in range(count):
        text, kind, _, _, _ = unpack("<IBBHQ", data, offset + 16 * index)
        begin = texts + text
        name = data[begin : data.index(b"\0", begin)].decode()
        if kind & 0xE0 or not kind & 1:  # for debuggers, or the object's own
            continue
        (undefined if kind & 0x0E == 0 else defined).add(name)
    return defined, undefined


def read_object(name, data):
    """The header and the load commands of one object."""
    magic, processor, _, kind, commands = unpack("<5I", data, 0)
    if magic != 0xFEEDFACF or kind != OBJECT or processor not in PROCESSORS:
        raise Damaged(f"{name} is no object of 64 bits")
    out = Object(name, PROCESSORS[processor], None, None, set(), set())
    offset = 32
    for _ in range(commands):
        command, size = unpack("<2I", data, offset)
        if command == BUILD_VERSION:
            platform, minimum = unpack("<2I", data, offset + 8)
            out.platform = PLATFORMS.get(platform, str(platform))
            out.minimum = f"{minimum >> 16}.{minimum >> 8 & 255}"
        elif command == SYMTAB:
            at, count, texts, _ = unpack("<4I", data, offset + 8)
            out.defined, out.undefined = symbols(data, at, count, texts)
        offset += size
    return out
