"""Puts the functions of a WebAssembly module in the order of their names, and drops the names.

What is compiled from one generic function for several types is nearly the same; side by side, a deflater finds that. The
functions that are called most come first, since the first 128 take one byte to call.

    order.py MODULE OUT
"""

import collections
import sys


class Reader:
    """Takes numbers and bytes out of a module, one after the other."""

    def __init__(self, data, at=0):
        self.data, self.at = data, at

    def byte(self):
        self.at += 1
        return self.data[self.at - 1]

    def bytes(self, count):
        self.at += count
        return self.data[self.at - count : self.at]

    def number(self):
        value = shift = 0
        while True:
            byte = self.byte()
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    def skip_numbers(self, count=1):
        for _ in range(count):
            while self.byte() >= 0x80:
                pass


def number(value):
    out = bytearray()
    while True:
        byte, value = value & 0x7F, value >> 7
        if value == 0:
            return bytes(out) + bytes([byte])
        out.append(byte | 0x80)


def calls(reader, end, is_expression=False):
    """The places of function indices in code, as (start, stop, index)."""
    found, depth = [], 0
    while reader.at < end:
        op = reader.byte()
        if op in (0x02, 0x03, 0x04):
            depth += 1
            reader.skip_numbers()
        elif op == 0x0B:
            if is_expression and depth == 0:
                return found
            depth -= 1
        elif op in (0x10, 0x12, 0xD2):
            start = reader.at
            index = reader.number()
            found.append((start, reader.at, index))
        elif op in (0x11, 0x13):
            reader.skip_numbers(2)
        elif op == 0x0E:
            reader.skip_numbers(reader.number() + 1)
        elif op == 0x1C:
            reader.bytes(reader.number())
        elif op in (0x0C, 0x0D, 0x41, 0x42, 0xD0) or 0x20 <= op <= 0x26:
            reader.skip_numbers()
        elif 0x28 <= op <= 0x3E:
            reader.skip_numbers(2)
        elif op in (0x3F, 0x40):
            reader.byte()
        elif op == 0x43:
            reader.bytes(4)
        elif op == 0x44:
            reader.bytes(8)
        elif op == 0xFC:
            further = reader.number()
            reader.skip_numbers({8: 2, 9: 1, 10: 2, 11: 1, 12: 2, 13: 1, 14: 2, 15: 1, 16: 1, 17: 1}[further] if further > 7 else 0)
        elif op in (0x00, 0x01, 0x05, 0x0F, 0x1A, 0x1B, 0xD1) or 0x45 <= op <= 0xC4:
            pass
        else:
            sys.exit(f"order.py does not know the instruction {op:#04x}")
    return found


def renumbered(data, start, stop, places, new):
    out, at = bytearray(), start
    for begin, end, index in places:
        out += data[at:begin] + number(new[index])
        at = end
    return bytes(out + data[at:stop])


def names(reader, end):
    found = {}
    while reader.at < end:
        kind, size = reader.byte(), reader.number()
        stop = reader.at + size
        if kind == 1:
            for _ in range(reader.number()):
                index = reader.number()
                found[index] = bytes(reader.bytes(reader.number()))
        reader.at = stop
    return found


def main():
    data = open(sys.argv[1], "rb").read()
    reader, sections, named = Reader(data, 8), [], {}
    while reader.at < len(data):
        kind, size = reader.byte(), reader.number()
        start = reader.at
        if kind == 0:
            name = reader.bytes(reader.number())
            if name == b"name":
                named = names(reader, start + size)
        else:
            sections.append((kind, start, start + size))
        reader.at = start + size
    if any(kind == 2 for kind, _, _ in sections):
        sys.exit("order.py expects a module that imports nothing")

    # The bodies, and how often each function is called.
    bodies, called = [], collections.Counter()
    for kind, start, stop in sections:
        if kind == 10:
            reader.at = start
            for _ in range(reader.number()):
                size = reader.number()
                begin = reader.at
                for _ in range(reader.number()):
                    reader.number()
                    reader.byte()
                places = calls(reader, begin + size)
                called.update(index for _, _, index in places)
                bodies.append((begin, begin + size, places))
                reader.at = begin + size
    often = [index for index, _ in called.most_common(128)]
    # The first letters of a name say what it is made from; of these, what is as long is alike.
    key = lambda index: (named.get(index, b"")[:60], bodies[index][1] - bodies[index][0])
    rest = sorted(set(range(len(bodies))) - set(often), key=key)
    order = often + rest
    new = {old: at for at, old in enumerate(order)}

    out = bytearray(data[:8])
    for kind, start, stop in sections:
        reader.at = start
        if kind == 3:
            types = [reader.number() for _ in range(reader.number())]
            content = number(len(types)) + b"".join(number(types[old]) for old in order)
        elif kind == 6:
            places = []
            for _ in range(reader.number()):
                reader.bytes(2)
                places += calls(reader, stop, is_expression=True)
            content = renumbered(data, start, stop, places, new)
        elif kind == 7:
            places = []
            for _ in range(reader.number()):
                reader.bytes(reader.number())
                exported, begin = reader.byte(), reader.at
                index = reader.number()
                if exported == 0:
                    places.append((begin, reader.at, index))
            content = renumbered(data, start, stop, places, new)
        elif kind == 8:
            content = number(new[reader.number()])
        elif kind == 9:
            places = []
            for _ in range(reader.number()):
                if reader.number() != 0:
                    sys.exit("order.py expects plain tables of functions")
                places += calls(reader, stop, is_expression=True)
                for _ in range(reader.number()):
                    begin = reader.at
                    index = reader.number()
                    places.append((begin, reader.at, index))
            content = renumbered(data, start, stop, places, new)
        elif kind == 10:
            content = number(len(bodies))
            for old in order:
                begin, end, places = bodies[old]
                body = renumbered(data, begin, end, places, new)
                content += number(len(body)) + body
        else:
            content = data[start:stop]
        out += bytes([kind]) + number(len(content)) + content
    open(sys.argv[2], "wb").write(out)


main()
