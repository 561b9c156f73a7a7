#!/usr/bin/env python3
"""Makes vibank-math.woff2, a subset of New Computer Modern Math under a name of its own.

    pip install fonttools brotli
    python3 make.py NewCMMath-Regular.otf
"""

import sys

from fontTools.misc.transform import Transform
from fontTools.pens.boundsPen import BoundsPen
from fontTools.pens.t2CharStringPen import T2CharStringPen
from fontTools.pens.transformPen import TransformPen
from fontTools.subset import Options, Subsetter, load_font, save_font

FAMILY = "Vibank Math"

# Latin and Greek, upright, italic, bold and bold italic; capital script and double-struck letters;
# digits; accents; operators, relations, arrows, delimiters.
CHARACTERS = """
    U+0020-007E U+00A0 U+00A8 U+00AC U+00AF U+00B0 U+00B1 U+00B4 U+00B5 U+00B7 U+00D7 U+00DF U+00E4
    U+00F6 U+00FC U+00C4 U+00D6 U+00DC U+00E9 U+00F7 U+0131 U+0237 U+02C6 U+02C7 U+02D8-02DD
    U+0300-0304 U+0307 U+0308 U+030A U+030C U+0338 U+0391-03A1 U+03A3-03A9 U+03B1-03C9 U+03D1
    U+03D5 U+03D6 U+03F0 U+03F1 U+03F5 U+2013 U+2014 U+2016 U+2018 U+2019 U+201C U+201D U+2020
    U+2022 U+2026 U+2032-2034 U+203E U+2044 U+20D7 U+20DB U+2102 U+210A-210E U+2110-2113 U+2115
    U+2118-211D U+2124 U+2126 U+2128 U+212C U+2130 U+2131 U+2133 U+2134 U+210F U+211C U+2111
    U+2190-2199 U+21A6 U+21BA U+21BB U+21CC U+21D0-21D5 U+2200 U+2202 U+2203 U+2205 U+2207-2209
    U+220B U+220F U+2211-2213 U+2215-221E U+2220 U+2223 U+2225-222E U+2234 U+2235 U+223C U+2243
    U+2245 U+2248 U+2250 U+2254 U+2260 U+2261 U+2264 U+2265 U+226A U+226B U+2272 U+2273 U+2282
    U+2286 U+2295 U+2297 U+22A4 U+22A5 U+22C2 U+22C3 U+22C5 U+22C6 U+22EE-22F1 U+2308-230B U+23DE
    U+23DF U+25A1 U+25B3 U+27C2 U+27E8 U+27E9 U+27F5-27FA U+1D400-1D433 U+1D434-1D454 U+1D456-1D467
    U+1D468-1D49B U+1D49C U+1D49E U+1D49F U+1D4A2 U+1D4A5 U+1D4A6 U+1D4A9-1D4AC U+1D4AE-1D4B5
    U+1D538 U+1D539 U+1D53B-1D53E U+1D540-1D544 U+1D546 U+1D54A-1D550 U+1D6A4 U+1D6A5 U+1D6A8-1D6C0
    U+1D6C2-1D6DA U+1D6DC-1D6E1 U+1D6E2-1D6FA U+1D6FC-1D714 U+1D715-1D71B U+1D71C-1D734
    U+1D736-1D74E U+1D750-1D755 U+1D7CE-1D7D7 U+1D7D8-1D7E1
"""


def characters():
    for entry in CHARACTERS.split():
        first, _, last = entry.removeprefix("U+").partition("-")
        yield from range(int(first, 16), int(last or first, 16) + 1)


# Browsers give a delimiter that grows the width of its widest form, whichever they draw. So the
# large forms are made narrower and lose most of the blank at their sides.
NARROW = 0.75
BLANK = 45


def narrow_delimiters(font):
    variants = font["MATH"].table.MathVariants
    for base, construction in zip(variants.VertGlyphCoverage.glyphs, variants.VertGlyphConstruction):
        if base not in DELIMITERS:
            continue
        larger = [record.VariantGlyph for record in construction.MathGlyphVariantRecord][1:]
        for glyph in larger[:-2]:
            refit(font, [glyph], 1.0)
        for glyph in larger[-2:]:
            refit(font, [glyph], NARROW)
        if construction.GlyphAssembly:
            parts = {record.glyph for record in construction.GlyphAssembly.PartRecords}
            refit(font, sorted(parts), NARROW)


DELIMITERS = {"parenleft", "parenright", "bracketleft", "bracketright", "braceleft", "braceright", "bar"}


def refit(font, glyphs, scale):
    """Scales the width of glyphs that stand in one column, and sets the blank at its sides."""
    outlines = font.getGlyphSet()
    bounds = []
    for glyph in glyphs:
        pen = BoundsPen(outlines)
        outlines[glyph].draw(pen)
        bounds.append(pen.bounds)
    left, right = min(b[0] for b in bounds), max(b[2] for b in bounds)
    if right - left < 100:
        scale = 1.0
    width = round((right - left) * scale) + 2 * BLANK
    place = Transform(scale, 0, 0, 1, BLANK - left * scale, 0)
    top = font["CFF "].cff.topDictIndex[0]
    drawn = {}
    for glyph in glyphs:
        pen = T2CharStringPen(width, None)
        outlines[glyph].draw(TransformPen(pen, place))
        drawn[glyph] = pen.getCharString(top.Private, top.GlobalSubrs)
    for glyph, outline in drawn.items():
        top.CharStrings[glyph] = outline
        font["hmtx"][glyph] = (width, BLANK)


def raise_primes(font):
    """Maps primes to their form for superscripts, where formulas have them: browsers do not."""
    for table in font["cmap"].tables:
        for prime in (0x2032, 0x2033, 0x2034):
            if prime in table.cmap:
                table.cmap[prime] = table.cmap[prime].removesuffix(".st") + ".st"


def main():
    options = Options()
    options.flavor = "woff2"
    options.layout_features = ["math", "ssty", "dtls", "flac", "kern"]
    options.hinting = False
    options.name_IDs = ["*"]
    options.drop_tables += ["FFTM", "PfEd"]
    options.recalc_timestamp = False
    font = load_font(sys.argv[1], options)
    missing = sorted(set(characters()) - set(font.getBestCmap()))
    print("not in the font:", *(f"U+{c:04X}" for c in missing))
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=characters())
    subsetter.subset(font)
    narrow_delimiters(font)
    raise_primes(font)
    names = {1: FAMILY, 4: FAMILY, 6: FAMILY.replace(" ", ""), 16: FAMILY}
    for name in font["name"].names:
        if name.nameID in names:
            name.string = names[name.nameID]
    # The name inside the outlines.
    outlines = font["CFF "].cff
    outlines.fontNames = [FAMILY.replace(" ", "")]
    top = outlines.topDictIndex[0]
    top.FullName = top.FamilyName = FAMILY
    save_font(font, "vibank-math.woff2", options)


main()
