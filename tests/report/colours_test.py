# SPDX-License-Identifier: Apache-2.0
"""Colours of the report: contrast as the W3C defines it, and apart for every colour vision."""
import itertools
import pathlib
import re
import unittest

STYLE = (pathlib.Path(__file__).resolve().parents[2] / "studies/page/style.css").read_text()

# Machado, Oliveira and Fernandes (2009), complete loss of one kind of cone; linear RGB.
VISIONS = {
    "all cones": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "no long": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "no middle": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    "no short": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
}
XYZ = ((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505))
WHITE = (0.9505, 1.0, 1.089)


def themes():
    """Light is what stands first, dark what a dark screen replaces."""
    light, dark = STYLE.split("@media (prefers-color-scheme: dark)")[:2]
    found = [dict(re.findall(r"--([\w-]+): (#[0-9a-f]+);", part.split("* { box-sizing")[0])) for part in (light, dark)]
    return {"light": found[0], "dark": {**found[0], **found[1]}}


def times(matrix, v):
    return [sum(a * b for a, b in zip(row, v)) for row in matrix]


def linear(colour):
    digits = colour[1:] if len(colour) == 7 else "".join(2 * c for c in colour[1:])
    shares = [int(digits[i:i + 2], 16) / 255 for i in (0, 2, 4)]
    return [s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4 for s in shares]


def contrast(a, b):
    low, high = sorted(times(XYZ, linear(c))[1] for c in (a, b))
    return (high + 0.05) / (low + 0.05)


def lab(rgb):
    f = [t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116 for t in (x / w for x, w in zip(times(XYZ, [min(max(v, 0), 1) for v in rgb]), WHITE))]
    return (116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2]))


def least_difference(colours, vision):
    places = [lab(times(vision, linear(c))) for c in colours]
    return min(sum((x - y) ** 2 for x, y in zip(a, b)) ** 0.5 for a, b in itertools.combinations(places, 2))


class Colours(unittest.TestCase):
    def test_words_and_lines_stand_out(self):
        for name, theme in themes().items():
            for word in ("ink", "soft", "good", "bad"):  # 4.5: WCAG 2.1, 1.4.3
                self.assertGreaterEqual(contrast(theme[word], theme["card"]), 4.5, (name, word))
            for line in ("c0", "c1", "c2", "c3", "c4", "c5", "c6", "accent"):  # 3: WCAG 2.1, 1.4.11
                self.assertGreaterEqual(contrast(theme[line], theme["card"]), 3, (name, line))
            for zone in ("slip-plus", "stick", "slip-minus"):
                self.assertGreaterEqual(contrast(theme["ink"], theme[zone]), 4.5, (name, zone))

    def test_series_and_zones_are_apart_for_every_colour_vision(self):
        # A difference of 2.3 in CIELAB is the least that is seen side by side; lines and areas apart
        # from each other take several of these.
        for name, theme in themes().items():
            for vision, matrix in VISIONS.items():
                self.assertGreaterEqual(least_difference([theme[f"c{i}"] for i in range(5)], matrix), 10, (name, vision))
                self.assertGreaterEqual(least_difference([theme[z] for z in ("slip-plus", "stick", "slip-minus")], matrix), 10, (name, vision))


if __name__ == "__main__":
    unittest.main(verbosity=1)
