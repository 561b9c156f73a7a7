"""Prints `crates/dynamics/src/numerics/double/constants.rs`: the constants of double-double arithmetic, from mpmath.

    python3 tests/references/double_constants.py > crates/dynamics/src/numerics/double/constants.rs
"""

import struct

from mpmath import e, expm1, factorial, floor, log, mp, mpf, pi, sqrt

mp.prec = 2000


def bits(x):
    text = f"{struct.unpack('<Q', struct.pack('<d', x))[0]:016x}"
    return "0x" + "_".join(text[i : i + 4] for i in range(0, 16, 4))


def word(x):
    text = f"{x:016x}"
    return "0x" + "_".join(text[i : i + 4] for i in range(0, 16, 4))


def pair(x):
    hi = float(x)
    lo = float(x - mpf(hi))
    return f"Dd::from_bits({bits(hi)}, {bits(lo)})"


def constant(name, x):
    print(f"pub(crate) const {name}: Dd = {pair(x)};")


def split(x, widths):
    """Leading parts of x with the given numbers of bits; the rest as a pair."""
    parts = []
    for width in widths:
        scale = mpf(2) ** (width - 1 - int(floor(log(x, 2))))
        part = floor(x * scale) / scale
        parts.append(float(part))
        x -= part
    return parts, x


print("//! Constants of double-double arithmetic, printed by `tests/references/double_constants.py`.")
print()
print("use super::Dd;")
print()
constant("PI", pi)
constant("TAU", 2 * pi)
constant("FRAC_PI_2", pi / 2)
constant("FRAC_PI_4", pi / 4)
constant("E", e)
constant("LN_2", log(2))
constant("LN_10", log(10))
constant("SQRT_2", sqrt(2))
print()
parts, rest = split(log(2), [40, 40])
print("/// The two leading parts of ln 2 with 40 bits each: their products with an exponent are exact.")
print("pub(crate) const LN_2_PARTS: [f64; 2] = [")
for part in parts:
    print(f"    f64::from_bits({bits(part)}),")
print("];")
print()
print("/// What the two parts leave of ln 2.")
print(f"pub(crate) const LN_2_REST: Dd = {pair(rest)};")
print()
print("/// The reciprocals of the factorials, 1/n! for n = 0, 1, ..., 30.")
print("pub(crate) const INVERSE_FACTORIALS: [Dd; 31] = [")
for n in range(31):
    print(f"    {pair(1 / factorial(n))},")
print("];")
print()
print("/// Where zero stands in the table of exponentials.")
print("pub(crate) const EXPM1_OF_32NDS_CENTRE: f64 = 12.0;")
print()
print("/// e^(j/32) - 1 for j = -12, -11, ..., 12.")
print("pub(crate) const EXPM1_OF_32NDS: [Dd; 25] = [")
for j in range(-12, 13):
    print(f"    {pair(expm1(mpf(j) / 32))},")
print("];")
print()
words = 23
scaled = int(floor(2 / pi * mpf(2) ** (64 * words)))
print("/// The binary fraction of 2/π, 64 bits a word, the leading word first.")
print(f"pub(crate) const TWO_OVER_PI: [u64; {words}] = [")
for i in range(words):
    print(f"    {word((scaled >> (64 * (words - 1 - i))) & (2**64 - 1))},")
print("];")
