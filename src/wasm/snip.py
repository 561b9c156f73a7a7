"""Takes out of a WebAssembly module what only a panic would say: it has no way to say it, since it imports nothing.

A function that panics stops at once, and so does what prints values for it (`Debug`, in which nothing is printed that a
student reads; `nothing_is_printed_for_programmers` in tests/suite/page.rs holds that). What nothing else reaches stops too, and
memory that nothing else names becomes zeros: texts, places in sources, tables of the alphabet. What reaches what is known
from the relocations that the linker leaves (`--emit-relocs`). What has no more use by that, wasm-opt finds.

    snip.py MODULE OUT
"""

import re
import sys

from module import Reader, number, operands, section, sections, segments

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
# Instructions that end a stretch of code in which each is followed by the next.
BRANCHES = {0x00, 0x02, 0x03, 0x04, 0x05, 0x0B, 0x0C, 0x0D, 0x0E, 0x0F}
CALL = 0x10
# Kinds of symbols, and the flag of one that is defined elsewhere.
FUNCTION, MEMORY, SECTION, ELSEWHERE = 0, 1, 3, 0x10
# Kinds of relocations: of the number of a type, and those with a distance from the symbol.
TYPE, DISTANT = 6, {3, 4, 5, 8, 9, 11}


def symbols(data, begin, end, pieces):
    """The symbols of a linked module: the number of a function, the begin and end of a piece of memory; names of functions."""
    reader, found, names = Reader(data, begin), [], {}
    reader.number()
    while reader.at < end:
        table, size = reader.byte(), reader.number()
        stop = reader.at + size
        for _ in range(reader.number() if table == 8 else 0):
            kind, flags = reader.byte(), reader.number()
            if kind == MEMORY:
                reader.bytes(reader.number())
                start, length = 0, 0
                if not flags & ELSEWHERE:
                    start, length = pieces[reader.number()][1] + reader.number(), reader.number()
                found.append((start, start + length))
                continue
            index = reader.number()
            if kind != SECTION:
                name = bytes(reader.bytes(reader.number()))
                if kind == FUNCTION:
                    names[index] = name
            found.append(index if kind == FUNCTION else None)
        reader.at = stop
    return found, names


def relocations(data, place, start, of):
    """The symbols that stand in a section which starts here, by their places."""
    reader, found = Reader(data, place[0]), {}
    reader.number()
    for _ in range(reader.number()):
        kind, offset, index = reader.number(), reader.number(), reader.number()
        if kind in DISTANT:
            reader.skip_numbers()
        if kind != TYPE and of[index] is not None:
            found[start + offset] = of[index]
    return found


def bodies(data, begin):
    """The begin and end of each function."""
    reader, found = Reader(data, begin), []
    for _ in range(reader.number()):
        size = reader.number()
        found.append((reader.at, reader.at + size))
        reader.at += size
    return found


def uses(data, begin, end, symbol_at, stopped):
    """What a function names, but for what it only names on its way to a function that stops."""
    reader, found, stretch = Reader(data, begin), set(), set()
    for _ in range(reader.number()):
        reader.number()
        reader.byte()
    while reader.at < end:
        start = reader.at
        op = reader.byte()
        operands(reader, op)
        stretch |= {symbol_at[at] for at in range(start, reader.at) if at in symbol_at}
        if op == CALL and Reader(data, start + 1).number() in stopped:
            stretch.clear()
        elif op in BRANCHES:
            found |= stretch
            stretch.clear()
    return found


def is_place(data, own, symbol_at):
    """Whether memory is a `core::panic::Location`: the address of the name of a source, its length, a line, a column."""
    name = symbol_at.get(own[0])
    return own[1] - own[0] == 16 and isinstance(name, tuple) and data[slice(*name)].rstrip(b"\0").endswith(b".rs")


def exported(data, begin):
    """The functions that a module exports."""
    reader, found = Reader(data, begin), set()
    for _ in range(reader.number()):
        reader.bytes(reader.number())
        kind, index = reader.byte(), reader.number()
        if kind == FUNCTION:
            found.add(index)
    return found


def reached(todo, follow):
    """All that follows from these, one from the other."""
    found = set(todo)
    while todo:
        new = set(follow(todo.pop())) - found
        found |= new
        todo |= new
    return found


def main():
    data = open(sys.argv[1], "rb").read()
    found, named = sections(data)
    begins = {kind: begin for kind, begin, _ in found}
    code, pieces = bodies(data, begins[10]), segments(data, begins[11])
    of, names = symbols(data, *named[b"linking"], pieces)
    symbol_at = relocations(data, named[b"reloc.CODE"], begins[10], of)
    symbol_at |= relocations(data, named[b"reloc.DATA"], begins[11], of)
    stopped = {index for index, name in names.items() if PANICS.search(name)}
    if not stopped:
        sys.exit("snip.py finds nothing that panics: are the names of functions mangled in another way?")

    memory = {own for own in of if isinstance(own, tuple)}
    stopped |= {own for own in memory if is_place(data, own, symbol_at)}

    def follow(own):
        if own in stopped:
            return ()
        if isinstance(own, int):
            return uses(data, *code[own], symbol_at, stopped)
        return (symbol_at[at] for at in range(*own) if at in symbol_at)

    live = reached(exported(data, begins[7]), follow) - stopped
    out = bytearray(data)
    for begin, end in memory:
        out[begin:end] = bytes(end - begin)
    for begin, end in live & memory:
        out[begin:end] = data[begin:end]
    module = bytearray(data[:8])
    for kind, begin, end in found:
        content = out[begin:end]
        if kind == 10:
            content = number(len(code))
            for index, (begin, end) in enumerate(code):
                body = data[begin:end] if index in live else STOP
                content += number(len(body)) + body
        module += section(kind, content)
    open(sys.argv[2], "wb").write(module)


main()
