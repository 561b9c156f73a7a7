"""The parts of a WebAssembly module: what `snip.py`, `order.py` and `streams.py` read and write."""

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

    def signed(self):
        begin = self.at
        value = self.number()
        bits = 7 * (self.at - begin)
        return value - (1 << bits) if value >> (bits - 1) else value

    def skip_numbers(self, count=1):
        for _ in range(count):
            while self.byte() >= 0x80:
                pass


def number(value):
    """A number as a module has it, seven bits a byte."""
    out = bytearray()
    while True:
        byte, value = value & 0x7F, value >> 7
        if value == 0:
            return bytes(out) + bytes([byte])
        out.append(byte | 0x80)


def operands(reader, op):
    """Reads over what an instruction has beside its opcode: the places of its numbers, or one of all its bytes."""
    if op in (0x00, 0x01, 0x05, 0x0B, 0x0F, 0x1A, 0x1B, 0xD1) or 0x45 <= op <= 0xC4:
        return ()
    begin = reader.at
    if op == 0x0E:
        reader.skip_numbers(reader.number() + 1)
    elif op == 0x1C:
        reader.bytes(reader.number())
    elif op == 0x43:
        reader.bytes(4)
    elif op == 0x44:
        reader.bytes(8)
    elif op == 0xFC:
        further = reader.number()
        reader.skip_numbers({8: 2, 9: 1, 10: 2, 11: 1, 12: 2, 13: 1, 14: 2, 15: 1, 16: 1, 17: 1}[further] if further > 7 else 0)
    elif op in (0x02, 0x03, 0x04, 0x0C, 0x0D, 0x10, 0x12, 0xD0, 0xD2) or 0x20 <= op <= 0x26 or 0x3F <= op <= 0x42:
        reader.skip_numbers()
    elif op in (0x11, 0x13) or 0x28 <= op <= 0x3E:
        reader.skip_numbers()
        middle = reader.at
        reader.skip_numbers()
        return ((begin, middle), (middle, reader.at))
    else:
        sys.exit(f"this instruction is not known: {op:#04x}")
    return ((begin, reader.at),)


def calls(reader, end, is_expression=False):
    """The places of function indices in code, as (start, stop, index)."""
    found, depth = [], 0
    while reader.at < end:
        op = reader.byte()
        if op in (0x02, 0x03, 0x04):
            depth += 1
        elif op == 0x0B:
            if is_expression and depth == 0:
                return found
            depth -= 1
        places = operands(reader, op)
        if op in (0x10, 0x12, 0xD2):
            start, stop = places[0]
            found.append((start, stop, Reader(reader.data, start).number()))
    return found


def segments(data, begin):
    """The pieces of memory that a module fills, as (address, place in the module, length)."""
    reader, found = Reader(data, begin), []
    for _ in range(reader.number()):
        if reader.number() != 0 or reader.byte() != 0x41:
            sys.exit("memory at fixed addresses is expected")
        address = reader.signed()
        reader.byte()
        length = reader.number()
        found.append((address, reader.at, length))
        reader.bytes(length)
    return found


def section(kind, content):
    return bytes([kind]) + number(len(content)) + content


def sections(data):
    """The sections of a module as (kind, begin, end), and those with names, as (begin, end) by these."""
    reader, found, named = Reader(data, 8), [], {}
    while reader.at < len(data):
        kind, size = reader.byte(), reader.number()
        end = reader.at + size
        if kind == 0:
            name = bytes(reader.bytes(reader.number()))
            named[name] = (reader.at, end)
        else:
            found.append((kind, reader.at, end))
        reader.at = end
    if any(kind == 2 for kind, _, _ in found):
        sys.exit("a module that imports nothing is expected")
    return found, named
