# SPDX-License-Identifier: Apache-2.0
"""What an SVG by gnuplot shows: texts, lines, dots and boxes with their places [points of the page]."""
import re
import xml.etree.ElementTree as ElementTree

SVG = "{http://www.w3.org/2000/svg}"
LINK = "{http://www.w3.org/1999/xlink}href"
BLUE, GREEN, VERMILION = "rgb(  0, 114, 178)", "rgb(  0, 158, 115)", "rgb(213,  94,   0)"


class Picture:
    """An SVG by gnuplot: its texts with their places, its lines by colour, in order."""

    def __init__(self, path):
        root = ElementTree.parse(path).getroot()
        self.size = (int(root.get("width")), int(root.get("height")))
        self.texts = []
        for group in root.iter(SVG + "g"):
            place = re.match(r"translate\(([\d.]+),([\d.]+)\)", group.get("transform") or "")
            for text in group.findall(SVG + "text"):
                if place:
                    self.texts.append(("".join(text.itertext()).strip(), float(place[1]), float(place[2])))
        self.lines = {}
        self.pieces = {}  # of the same lines and of shorter ones, from gap to gap
        for element in root.iter(SVG + "path"):
            pieces = [[tuple(map(float, p)) for p in re.findall(r"(-?[\d.]+),(-?[\d.]+)", piece)] for piece in element.get("d").split("M")[1:]]
            points = [point for piece in pieces for point in piece]
            if len(points) > 50:
                self.lines.setdefault(element.get("stroke"), []).append(points)
            self.pieces.setdefault(element.get("stroke"), []).extend(pieces)

        self.dots, self.rises = {}, []  # triangles that point up
        for element in root.iter(SVG + "use"):
            place = re.match(r"translate\((-?[\d.]+),(-?[\d.]+)\)", element.get("transform") or "")
            if place and element.get(LINK) == "#gpPt8":
                self.rises.append((float(place[1]), float(place[2])))
            elif place:
                self.dots.setdefault(element.get("color"), []).append((float(place[1]), float(place[2])))
        for colour, places in self.dots.items():
            self.dots[colour] = [place for place in places if not self.in_key(*place)]
        self.rises = [place for place in self.rises if not self.in_key(*place)]
        self.boxes = {}
        for element in root.iter(SVG + "polygon"):
            points = [tuple(map(float, p)) for p in re.findall(r"(-?[\d.]+),(-?[\d.]+)", element.get("points"))]
            if len(points) == 4:
                xs, ys = zip(*points)
                box = (min(xs), max(xs), min(ys), max(ys))
                if not self.in_key(box[0], (box[2] + box[3]) / 2):
                    self.boxes.setdefault(element.get("fill"), []).append(box)

    def in_key(self, x, y):
        """Whether a place is that of a sample in a key, which stands before its text above the first panel."""
        return y < 120 and any(abs(height - 4 - y) < 6 and 0 < left - x < 60 for _, left, height in self.texts)

    def words(self):
        return [text for text, _, _ in self.texts]

    def numbers(self, along, least, most):
        """{tic label: coordinate} of those whose other coordinate is within the limits."""
        found = {}
        for text, *place in self.texts:
            if re.fullmatch(r"-?[\d.]+", text) and least <= place[1 - along] <= most:
                found[float(text)] = place[along]
        return found


def scale(tics):
    """Pixels for each unit of an axis, and the pixel of its zero."""
    (low, at_low), (high, at_high) = min(tics.items()), max(tics.items())
    per_unit = (at_high - at_low) / (high - low)
    return per_unit, at_low - per_unit * low
