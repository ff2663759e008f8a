"""Makes notes/fonts/notes-math.woff2 from Latin Modern Math.

    pip install fonttools==4.68.0 brotli==1.2.1
    cargo info pulldown-latex@0.8.0   # downloads the package, which holds the font
    python3 subset_font.py ~/.cargo/registry/src/*/pulldown-latex-0.8.0/font/latinmodern-math.woff2

Kept are the letters and signs that a formula of these notes may need, with their
small forms for exponents and their large forms for roots and brackets.
"""

import sys
from pathlib import Path

from fontTools import subset

FAMILY = "Notes Math"
KEPT = [
    range(0x20, 0x7F),  # Latin
    [0xA0, 0xAC, 0xD7, 0xF7, 0x131, 0x237, 0x2C6, 0x2DC, 0x2057, 0x20D7],
    range(0xB0, 0xB8),
    range(0x300, 0x30D),  # accents
    range(0x391, 0x3F7),  # Greek
    range(0x2016, 0x2045),  # dashes, dots, primes
    range(0x2102, 0x214C),  # letter-like signs
    range(0x2190, 0x219A),  # arrows
    range(0x21D0, 0x21D6),
    range(0x2200, 0x22A6),  # operators and relations
    range(0x22C0, 0x22C6),
    range(0x22EE, 0x22F2),
    range(0x2308, 0x230C),  # floor and ceiling
    range(0x27E8, 0x27EA),  # angle brackets
    range(0x1D400, 0x1D468),  # bold and italic Latin
    range(0x1D49C, 0x1D4D0),  # script
    range(0x1D538, 0x1D56C),  # double-struck
    range(0x1D6A4, 0x1D71C),  # bold and italic Greek
    range(0x1D7CE, 0x1D7D8),  # bold digits
]


def main(source):
    options = subset.Options(flavor="woff2", layout_features=["ssty", "dtls"], drop_tables=["FFTM"])
    font = subset.load_font(source, options)
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=[letter for part in KEPT for letter in part])
    subsetter.subset(font)
    for record in font["name"].names:
        if record.nameID in (1, 4, 6, 16):
            record.string = FAMILY.replace(" ", "") if record.nameID == 6 else FAMILY
    top = font["CFF "].cff
    top.fontNames = [FAMILY.replace(" ", "")]
    top.topDictIndex[0].FamilyName = top.topDictIndex[0].FullName = FAMILY
    subset.save_font(font, str(Path(__file__).parents[1] / "notes" / "fonts" / "notes-math.woff2"), options)


if __name__ == "__main__":
    main(sys.argv[1])
