#!/usr/bin/env python3
"""Says what Android 15 and newer, or the example, would complain of in an APK or an AAR, and what to do about it.

usage: check_apk.py FILE [EXPORTS]
Libraries: of the processor that their folder names, on pages of 16 KB in themselves and in the APK, found by devices of
Android 21, stored without compression. Cooked files: stored, on a boundary of 16 bytes.
EXPORTS: a list as tools/packaging/android/stubs.txt; libraries may import no other functions. Exit code: 0 good, 1 not.
"""
import os
import re
import struct
import sys
import zipfile

PAGE = 16384
MACHINES = {"arm64-v8a": 183, "armeabi-v7a": 40, "x86_64": 62, "x86": 3}
NAMES = {machine: abi for abi, machine in MACHINES.items()}
LOAD, DYNAMIC = 1, 2
NEEDED, HASH, STRTAB, SYMTAB, SONAME = 1, 4, 5, 6, 14


class Elf:
    """Of a library's bytes what is asked here. struct.error or IndexError where they are cut off."""

    def __init__(self, data):
        if data[:4] != b"\x7fELF":
            raise ValueError("is no library of Android's: it does not begin with ELF")
        self.data, self.wide = data, data[4] == 2
        self.machine = struct.unpack_from("<H", data, 18)[0]
        table, = struct.unpack_from("<Q" if self.wide else "<I", data, 32 if self.wide else 28)
        size, count = struct.unpack_from("<HH", data, 54 if self.wide else 42)
        self.segments = [self.segment(table + i * size) for i in range(count)]
        self.dynamic = self.read_dynamic()

    def segment(self, at):  # type, offset, address, bytes, alignment
        if self.wide:
            kind, _, offset, address, _, size, _, align = struct.unpack_from("<IIQQQQQQ", self.data, at)
        else:
            kind, offset, address, _, size, _, _, align = struct.unpack_from("<IIIIIIII", self.data, at)
        return kind, offset, address, size, align

    def offset(self, address):
        for kind, offset, start, size, _ in self.segments:
            if kind == LOAD and start <= address < start + size:
                return offset + address - start
        raise ValueError("is damaged: what it says of itself lies outside of it")

    def read_dynamic(self):
        out = []
        form, step = ("<qQ", 16) if self.wide else ("<iI", 8)
        for kind, offset, _, size, _ in self.segments:
            if kind == DYNAMIC:
                out += [struct.unpack_from(form, self.data, at) for at in range(offset, offset + size, step)]
        return out

    def value(self, tag):
        return next((v for t, v in self.dynamic if t == tag), None)

    def text(self, at):
        begin = self.offset(self.value(STRTAB)) + at
        return self.data[begin:self.data.index(b"\0", begin)].decode()

    def texts(self, tag):
        return [self.text(v) for t, v in self.dynamic if t == tag]

    def imports(self):
        """Names that others are to define. The table of hashes says how many symbols there are."""
        count = struct.unpack_from("<I", self.data, self.offset(self.value(HASH)) + 4)[0]
        table, out = self.offset(self.value(SYMTAB)), []
        for i in range(1, count):
            if self.wide:
                name, info, _, section = struct.unpack_from("<IBBH", self.data, table + 24 * i)
            else:
                name, _, _, info, _, section = struct.unpack_from("<IIIBBH", self.data, table + 16 * i)
            if section == 0 and info >> 4 == 1:  # undefined and not weak
                out.append(self.text(name))
        return out


def read_exports(path, abi):
    out = {}
    with open(path, encoding="utf-8") as lines:
        for words in (line.split("#")[0].split() for line in lines):
            if words and words[0] in MACHINES:
                if words[0] != abi:
                    continue
                words = words[1:]
            if words:
                out.setdefault(words[0], set()).update(words[1:])
    return out


def check_library(abi, data, exports):
    elf = Elf(data)
    if elf.machine != MACHINES[abi]:
        yield f"is for {NAMES.get(elf.machine, f'machine {elf.machine}')}; put one for {abi} there"
        return
    for kind, offset, address, _, align in elf.segments:
        if kind == LOAD and (align < PAGE or align % PAGE or (address - offset) % PAGE):
            yield "does not fit pages of 16 KB; link it with -Wl,-z,max-page-size=16384"
            break
    if elf.value(HASH) is None:
        yield "Android 21 does not find its functions; link it with -Wl,--hash-style=both"
        return
    if exports:
        known = read_exports(exports, abi)
        for library in elf.texts(NEEDED):
            if library not in known:
                yield f"needs {library}, which may not be there on Android 21"
        names = set().union(*known.values())
        for name in elf.imports():
            if name not in names:
                yield f"imports {name}, which Android 21 may not export"


def check_place(entry, begin, is_apk):
    if not is_apk:
        return
    boundary = PAGE if entry.filename.endswith(".so") else 16
    if entry.compress_type != zipfile.ZIP_STORED:
        if boundary == PAGE:
            yield "is compressed; set packaging { jniLibs { useLegacyPackaging = false } }"
        else:
            yield 'is compressed, so it is copied each time; set androidResources { noCompress += "mrw" }'
    elif begin % boundary:
        yield f"begins {begin % boundary} bytes behind a multiple of {boundary}; run align_apk.py before you sign the APK"


def data_of(archive, entry):
    with archive.open(entry):  # compares the name and the bounds
        archive.fp.seek(entry.header_offset + 26)
        name, extra = struct.unpack("<HH", archive.fp.read(4))
        return entry.header_offset + 30 + name + extra


def check(path, exports):
    is_apk = path.endswith(".apk")
    with zipfile.ZipFile(path) as archive:
        for entry in archive.infolist():
            abi = re.search(r"(?:^lib/|/android\.)([a-z0-9_-]+)/[^/]*\.so$", entry.filename)
            if not abi and not entry.filename.endswith(".mrw"):
                continue
            try:
                for what in check_place(entry, data_of(archive, entry), is_apk):
                    yield f"{entry.filename}: {what}"
                if abi and abi[1] not in MACHINES:
                    yield f"{entry.filename}: {abi[1]} is no ABI of Android's"
                elif abi:
                    for what in check_library(abi[1], archive.read(entry), exports):
                        yield f"{entry.filename}: {what}"
            except ValueError as error:
                yield f"{entry.filename}: {error}"
            except (struct.error, IndexError, TypeError):
                yield f"{entry.filename}: is damaged: it is cut off"


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    path, exports = sys.argv[1], sys.argv[2] if len(sys.argv) == 3 else None
    try:
        wrong = list(check(path, exports))
    except (OSError, zipfile.BadZipFile) as error:
        wrong = [str(error)]
    for what in wrong:
        print(f"{os.path.basename(path)}: {what}", file=sys.stderr)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
