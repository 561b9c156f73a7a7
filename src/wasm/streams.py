"""Takes the code of a WebAssembly module apart into streams that deflate better each by itself than mixed.

A deflater has one alphabet for all bytes of a block, and finds nothing again where a number between two instructions is another.
So there is one stream of opcodes, one of the variables that functions declare, and for each opcode one of its first numbers and
one of its second. `joined` in templates/page/common.js puts them together, and in the suite `joined` of tests/suite/page.rs.

    streams.py MODULE OUT

OUT begins with numbers of seven bits a byte: of functions, and of forms, each form, and the length of each stream. The streams
are what stands before the code, what stands after it, the opcodes, and two for each form. The forms are those of what follows
the opcodes 0 to 255, and of the variables that a function declares: numbers, of which the second stream has the second; or bytes,
of which the second stream has the counts.
"""

import sys

from module import Reader, number, operands, section, sections

BEFORE, AFTER, OPCODES, OPERANDS = range(4)
VARIABLES = 256
BYTES = 3
# Followed by more than a number or two.
LONG = {0x0E, 0x1C, 0x43, 0x44, 0xFC, VARIABLES}


def apart(reader, forms, streams):
    """Takes the content of the section of code apart; gives the number of functions."""

    def follow(op, places):
        first, second = OPERANDS + 2 * op, OPERANDS + 2 * op + 1
        forms[op] = BYTES if op in LONG else len(places)
        for stream, (begin, end) in zip((first, second), places):
            streams[stream] += reader.data[begin:end]
        if op in LONG:
            streams[second] += number(places[0][1] - places[0][0])

    count = reader.number()
    for _ in range(count):
        stop = reader.number() + reader.at
        begin = reader.at
        for _ in range(reader.number()):
            reader.number()
            reader.byte()
        follow(VARIABLES, ((begin, reader.at),))
        depth = 1
        while depth > 0:
            op = reader.byte()
            depth += {0x02: 1, 0x03: 1, 0x04: 1, 0x0B: -1}.get(op, 0)
            streams[OPCODES].append(op)
            follow(op, operands(reader, op))
        if reader.at != stop:
            sys.exit("a function does not end where its last block ends")
    return count


def main():
    data = open(sys.argv[1], "rb").read()
    found, _ = sections(data)
    forms, count = [0] * (VARIABLES + 1), 0
    streams = [bytearray() for _ in range(OPERANDS + 2 * len(forms))]
    streams[BEFORE] += data[:8]
    for kind, begin, end in found:
        if kind == 10:
            count = apart(Reader(data, begin), forms, streams)
        else:
            streams[AFTER if count else BEFORE] += section(kind, data[begin:end])
    head = [count, len(forms), *forms, *map(len, streams)]
    open(sys.argv[2], "wb").write(b"".join([*map(number, head), *streams]))


main()
