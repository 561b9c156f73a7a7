"""Takes out of a WebAssembly module what only a panic would say: it has no way to say it, since it imports nothing.

A function that panics stops at once, and so does what prints values for it (`Debug`, in which nothing is printed that a
student reads; `nothing_is_printed_for_programmers` in tests/suite/page.rs holds that). The places in sources and the names of
files become zeros. What has no more use by that, wasm-opt finds.

    snip.py MODULE OUT
"""

import re
import struct
import sys

from module import Reader, number, section, sections, segments

# By mangled names of version 0.
PANICS = re.compile(
    rb"(core9panicking|std9panicking)|"
    rb"(13unwrap_failed|13expect_failed|13assert_failed|16slice_error_fail|16slice_index_fail|17len_mismatch_fail)|"
    rb"(18panic_access_error|14panic_poisoned|22panic_on_ord_violation|22panic_already_borrowed|30panic_already_mutably_borrowed)|"
    rb"(7raw_vec12handle_error|17capacity_overflow|18handle_alloc_error|8rust_oom|10rust_panic|17rust_begin_unwind)|"
    rb"5Debug3fmt"
)
# No locals; `unreachable`; the end.
STOP = b"\x00\x00\x0b"


def without_panics(data, begin, names):
    if not any(PANICS.search(name) for name in names.values()):
        sys.exit("snip.py finds nothing that panics: are the names of functions mangled in another way?")
    reader, out = Reader(data, begin), bytearray()
    count = reader.number()
    for index in range(count):
        body = reader.bytes(reader.number())
        if PANICS.search(names.get(index, b"")):
            body = STOP
        out += number(len(body)) + body
    return number(count) + out


def without_places(data, begin, end):
    """The memory without `core::panic::Location`s: the address and length of a name that ends in `.rs`, a line, a column."""
    pieces, out = segments(data, begin), bytearray(data[begin:end])

    def place(address, length):
        for start, at, size in pieces:
            if start <= address and address + length <= start + size:
                return at + address - start
        return None

    for start, at, size in pieces:
        for offset in range(-start % 4, size - 15, 4):
            address, length, line, column = struct.unpack_from("<4I", data, at + offset)
            name = place(address, length)
            if name is None or not (0 < line < 1 << 16 and 0 < column < 1 << 10 and data[name : name + length].endswith(b".rs")):
                continue
            out[at + offset - begin : at + offset - begin + 16] = bytes(16)
            out[name - begin : name - begin + length] = bytes(length)
    return bytes(out)


def main():
    data = open(sys.argv[1], "rb").read()
    found, names = sections(data)
    out = bytearray(data[:8])
    for kind, begin, end in found:
        if kind == 10:
            content = without_panics(data, begin, names)
        elif kind == 11:
            content = without_places(data, begin, end)
        else:
            content = data[begin:end]
        out += section(kind, content)
    open(sys.argv[2], "wb").write(out)


main()
