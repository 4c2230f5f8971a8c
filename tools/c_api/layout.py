"""Where the members of structs lie, with pointers of 4 or 8 bytes."""
from description import SCALARS


class Layout:
    def __init__(self, rows, pointer_bytes):
        self.pointer = pointer_bytes
        self.enums = {r.name: r for r in rows if r.kind == 'enum'}
        self.structs = {r.name: r for r in rows if r.kind == 'struct'}
        self.made = {}

    def of_type(self, t):
        """Size and alignment of a member without its count."""
        if t.form in ('*', '[]') or t.name in ('text', 'code') or t.is_callback:
            return self.pointer, self.pointer
        if t.name in SCALARS:
            size = SCALARS[t.name][0] or self.pointer
            one = (size, size)
        elif t.name in self.enums:
            one = self.of_type(self.enums[t.name].type)
        else:
            one = self.of(t.name)[:2]
        count = 1
        for n in t.dims:
            count *= n
        return one[0] * count, one[1]

    def of(self, struct):
        """Size, alignment, and the place of each member; of T[] the place of the pointer."""
        if struct not in self.made:
            row, end, places = self.structs[struct], 0, []
            boundary = row.boundary()
            for _, t in row.fields:
                size, align = self.of_type(t)
                end += -end % align
                places.append(end)
                end += size + (self.pointer if t.form == '[]' else 0)
                boundary = max(boundary, align)
            self.made[struct] = (end + -end % boundary, boundary, places)
        return self.made[struct]
