#!/usr/bin/env python3
"""True nets on surfaces over a number field (docs/format.md), made exactly from the true ones on other surfaces.

field_surfaces.py write FOLDER: writes field-octagon.json, field-reducible.json and field-bolza.json, which are in
    tests/data/forgeries.

A number of the field is a list of fractions, the coefficients of 1, x, x², …; nothing is rounded.
"""
import json
import math
import os
import sys
from fractions import Fraction

sys.dont_write_bytecode = True  # Nothing is written beside the sources.

from forgeries_plane import ONE, Gaussian, Surface

SEEDS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "data", "forgeries")


class Field:
    """ℚ[x] modulo a monic polynomial, whose root between two rationals is meant."""

    def __init__(self, polynomial, root):
        self.polynomial, self.root = polynomial, root

    def number(self, *coefficients):
        return self.reduced([Fraction(c) for c in coefficients])

    def reduced(self, x):
        degree = len(self.polynomial) - 1
        x = list(x)
        while len(x) > degree:
            top = x.pop()
            for i in range(degree):
                x[len(x) - degree + i] -= top * self.polynomial[i]
        return x + [Fraction(0)] * (degree - len(x))

    def times(self, x, y):
        result = [Fraction(0)] * (len(x) + len(y) - 1)
        for i, a in enumerate(x):
            for j, b in enumerate(y):
                result[i + j] += a * b
        return self.reduced(result)

    def changes_of_sign(self):
        """Of (1 + x)^d f((L + Ux)/(1 + x))."""
        degree = len(self.polynomial) - 1
        low, high = map(Fraction, self.root)
        total = [Fraction(0)] * (degree + 1)
        for k, c in enumerate(self.polynomial):
            term = [Fraction(c)]
            for u, v in [(low, high)] * k + [(Fraction(1), Fraction(1))] * (degree - k):
                term = [u * a + v * b for a, b in zip(term + [0], [0] + term)]
            total = [a + b for a, b in zip(total, term)]
        signs = [c > 0 for c in total if c]
        return sum(a != b for a, b in zip(signs, signs[1:]))

    def written(self, numbers):
        """A row of numbers up to a positive factor: integers without a common factor, as short as they can be."""
        scale = math.lcm(*(c.denominator for x in numbers for c in x))
        common = math.gcd(*(int(c * scale) for x in numbers for c in x))
        rows = [[int(c * scale) // common for c in x] for x in numbers]
        for row in rows:
            while len(row) > 1 and row[-1] == 0:
                row.pop()
        return [[str(c) for c in row] for row in rows]

    def surface(self, tiles, gluing, crossings):
        assert self.changes_of_sign() == 1
        return {"kind": "field", "polynomial": [str(c) for c in self.polynomial], "root": self.root,
                "polygons": [[self.written(vertex) for vertex in tile] for tile in tiles], "gluing": gluing,
                "crossings": [self.written(crossing) for crossing in crossings]}


def vector(z):
    return [2 * z.re, 2 * z.im, 1 + z.norm()]


def rows_of_crossing(g):
    """(Re A, Im A, Re B, Im B) of z ↦ (Az + B)/(B̄z + Ā), which is z ↦ (az + b)/(cz + 1): A/Ā = a, B = Āb."""
    a = ONE + g.a
    if a == Gaussian(0):
        a = Gaussian(0, 1)
    b = a.conjugate() * g.b
    return [a.re, a.im, b.re, b.im]


def written_crossing(g):
    """The row of a rational isometry, whatever the field is."""
    return Field([0, 1], ["-1", "1"]).written([[x] for x in rows_of_crossing(g)])


def over(field, document, factor, zero):
    """The same rational surface: numbers times a positive number of the field, and plus multiples of one that is 0."""
    surface = Surface(document["surface"])
    count = 0

    def numbers(row):
        nonlocal count
        count += 1
        row = [[x] for x in row]
        if count % 2 == 0:
            row = [field.times(factor, x) for x in row]
        return [field.reduced([a + (count + i) * b for a, b in zip(field.reduced(x), zero)]) for i, x in enumerate(row)]

    gluing = document["surface"]["gluing"]
    return dict(document, surface=field.surface(
        [[numbers(vector(z)) for z in tile] for tile in surface.tiles], gluing,
        [numbers(rows_of_crossing(surface.crossing(surface.first[t] + k))) for t, k, _, _ in gluing]))


def seed(name):
    with open(os.path.join(SEEDS, name + ".json"), encoding="utf-8") as file:
        return json.load(file)


def field_octagon():
    field = Field([-2, 0, 1], ["1", "2"])
    return over(field, seed("octagon"), field.number(3, 2), field.number(0))


def field_reducible():
    """√2 as a root of (x² − 2)(x² − 3): x² − 2 is 0."""
    field = Field([6, 0, -5, 0, 1], ["1", "3/2"])
    return over(field, seed("octagon"), field.number(3, 2), field.number(-2, 0, 1))


def octagon(field, x, y, t):
    """The octagon with the vertices (x, −y, t), (x, y, t) and so on, with the symmetries of a square, opposite sides
    glued: a crossing is the turn by π about the side's midpoint (X, Y, T) and then that about 0, (T, −X − iY)."""
    def minus(row):
        return [-c for c in row]

    def plus(first, second):
        return [a + b for a, b in zip(first, second)]

    first, second = [x, minus(y)], [x, y]
    tile = []
    for _ in range(4):
        tile += [[*first, t], [*second, t]]
        first, second = [[minus(row[1]), row[0]] for row in (first, second)]
    middles = [[plus(a, b) for a, b in zip(tile[k], tile[k + 1])] for k in range(4)]
    return field.surface([tile], [[0, k, 0, k + 4] for k in range(4)],
                         [[middle[2], field.number(0), minus(middle[0]), minus(middle[1])] for middle in middles])


def field_bolza():
    """The regular octagon with the angles π/4. α² = 2 + 2√2: of a side cosh ρ = 1 + √2 and sinh ρ = α, and the vertex
    at π/8 is tanh ρ (1, tan(π/8)) in the projective disk, tan(π/8) = √2 − 1 = 1/(1 + √2)."""
    field = Field([-4, 0, -4, 0, 1], ["2", "3"])
    tangent = field.number(-2, 0, Fraction(1, 2))
    x = field.times(field.number(0, 1), tangent)
    return dict(seed("regular"), surface=octagon(field, x, field.times(x, tangent), field.number(1)))


def right_angled_octagon():
    """The regular octagon with right angles, α⁴ = 2: tanh ρ = 1/α, and √2 = α²."""
    field = Field([-2, 0, 0, 0, 1], ["1", "2"])
    x = field.number(0, 0, 0, Fraction(1, 2))
    return octagon(field, x, field.times(x, field.number(-1, 0, 1)), field.number(1))


def lines(value, depth):
    """One element of an array a line, in so many arrays one in another."""
    if depth == 0:
        return json.dumps(value, separators=(",", ":"))
    return "[\n" + ",\n".join(lines(x, depth - 1) for x in value) + "\n]"


def text(document):
    def members(value):
        depths = {"polygons": 2, "gluing": 1, "crossings": 1, "charts": 1, "labels": 1, "vertices": 1, "triangles": 1}
        return "{" + ",\n".join(json.dumps(k) + ":" + (members(v) if isinstance(v, dict) else lines(v, depths.get(k, 0)))
                                for k, v in value.items()) + "}"
    return members(document) + "\n"


def main():
    if len(sys.argv) != 3 or sys.argv[1] != "write":
        sys.exit(__doc__)
    for make in (field_octagon, field_reducible, field_bolza):
        name = make.__name__.replace("_", "-") + ".json"
        with open(os.path.join(sys.argv[2], name), "w", encoding="utf-8") as file:
            file.write(text(make()))


if __name__ == "__main__":
    main()
