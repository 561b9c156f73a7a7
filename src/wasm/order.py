"""Puts functions of a WebAssembly module that are alike side by side, where a deflater finds that, and drops their names.

What is compiled from one generic function for several types is nearly the same. The functions that are called most come
first, since the first 128 take one byte to call; each further one is that whose opcodes are most like those just before it,
since opcodes travel by themselves (`streams.py`) and are the longest stream. The memory, which wasm-opt cuts at each run of
zeros, becomes one piece again.

    order.py MODULE OUT
"""

import collections
import sys

from module import Reader, calls, number, operands, section, sections, segments

# A deflater looks back over 32 kB.
WINDOW = 30_000
# Pieces of so many opcodes are looked for: eight leave the module as small.
PIECE = 12
# What more functions share than this is near at hand anywhere.
COMMON = 400


def opcodes(data, begin, end):
    """The opcodes of a function."""
    reader, found = Reader(data, begin), bytearray()
    for _ in range(reader.number()):
        reader.number()
        reader.byte()
    while reader.at < end:
        found.append(reader.byte())
        operands(reader, found[-1])
    return bytes(found)


def pieces(codes):
    """For each function the pieces that it shares with others, and for each piece its functions."""
    holders = collections.defaultdict(list)
    for index, code in enumerate(codes):
        for piece in {code[at : at + PIECE] for at in range(len(code) - PIECE + 1)}:
            holders[piece].append(index)
    shared, of = [], [[] for _ in codes]
    for functions in holders.values():
        if 1 < len(functions) <= COMMON:
            for index in functions:
                of[index].append(len(shared))
            shared.append(functions)
    return of, shared


def alike(codes, first):
    """All functions, those of `first` first, each next to what it is like."""
    of, shared = pieces(codes)
    sizes = [len(code) for code in codes]
    # Between the share of a function that is known and the number of its pieces that are.
    weights = [(size + 8) ** -0.75 for size in sizes]
    known, seen = [0] * len(codes), [0] * len(shared)
    window, order, left = collections.deque(), [], set(range(len(codes)))

    def note(index, by):
        """Lets a function into the window, or out of it."""
        for piece in of[index]:
            was = seen[piece]
            seen[piece] += by
            if was == 0 or seen[piece] == 0:
                for holder in shared[piece]:
                    known[holder] += by

    room = WINDOW
    while left:
        index = first[len(order)] if len(order) < len(first) else max(left, key=lambda index: (known[index] * weights[index], -index))
        order.append(index)
        left.remove(index)
        note(index, 1)
        window.append(index)
        room -= sizes[index]
        while room < 0 and len(window) > 1:
            gone = window.popleft()
            room += sizes[gone]
            note(gone, -1)
    return order


def renumbered(data, begin, end, places, new):
    """Bytes of a module in which the functions at these places have their new numbers."""
    out, at = bytearray(), begin
    for start, stop, index in places:
        out += data[at:start] + number(new[index])
        at = stop
    return bytes(out + data[at:end])


def functions(data, begin):
    """The functions as (begin, end, the places of calls)."""
    reader, found = Reader(data, begin), []
    for _ in range(reader.number()):
        size = reader.number()
        start = reader.at
        for _ in range(reader.number()):
            reader.number()
            reader.byte()
        found.append((start, start + size, calls(reader, start + size)))
    return found


def references(reader, kind, end):
    """The places of functions in a section that has no code."""
    places = []
    for _ in range(reader.number()):
        if kind == 6:
            reader.bytes(2)
            places += calls(reader, end, is_expression=True)
            continue
        if kind == 7:
            reader.bytes(reader.number())
            is_function, begin = reader.byte() == 0, reader.at
            index = reader.number()
            places += [(begin, reader.at, index)] if is_function else []
            continue
        if reader.number() != 0:
            sys.exit("order.py expects plain tables of functions")
        places += calls(reader, end, is_expression=True)
        for _ in range(reader.number()):
            begin = reader.at
            index = reader.number()
            places.append((begin, reader.at, index))
    return places


def memory(data, begin):
    """The memory as one piece: zeros between pieces deflate to less than the addresses and lengths of the pieces."""
    pieces = segments(data, begin)
    first, at, length = pieces[0]
    whole = bytearray(pieces[-1][0] + pieces[-1][2] - first)
    for address, place, size in pieces:
        whole[address - first : address - first + size] = data[place : place + size]
    head = data[begin + len(number(len(pieces))) : at - len(number(length))]
    return number(1) + head + number(len(whole)) + whole


def main():
    data = open(sys.argv[1], "rb").read()
    found, _ = sections(data)
    bodies = functions(data, next(begin for kind, begin, _ in found if kind == 10))
    called = collections.Counter(index for _, _, places in bodies for _, _, index in places)
    codes = [opcodes(data, begin, end) for begin, end, _ in bodies]
    order = alike(codes, [index for index, _ in called.most_common(128)])
    new = {old: at for at, old in enumerate(order)}

    out = bytearray(data[:8])
    for kind, begin, end in found:
        reader = Reader(data, begin)
        if kind == 3:
            types = [reader.number() for _ in range(reader.number())]
            content = number(len(types)) + b"".join(number(types[old]) for old in order)
        elif kind in (6, 7, 9):
            content = renumbered(data, begin, end, references(reader, kind, end), new)
        elif kind == 8:
            content = number(new[reader.number()])
        elif kind == 11:
            content = memory(data, begin)
        elif kind == 12:
            content = number(1)
        elif kind == 10:
            content = number(len(bodies))
            for old in order:
                body = renumbered(data, *bodies[old], new)
                content += number(len(body)) + body
        else:
            content = data[begin:end]
        out += section(kind, content)
    open(sys.argv[2], "wb").write(out)


main()
