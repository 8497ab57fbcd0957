"""Exact geometry and surgery on net documents, in fractions: the tools with which forgeries.py makes false nets.

A document is what json.load gives for a net file (docs/format.md) on rational tiles. Nothing here is rounded.
"""
from fractions import Fraction


class Gaussian:
    """A complex number with rational parts."""

    __slots__ = ("re", "im")

    def __init__(self, re, im=0):
        self.re, self.im = Fraction(re), Fraction(im)

    def __add__(self, other):
        return Gaussian(self.re + other.re, self.im + other.im)

    def __sub__(self, other):
        return Gaussian(self.re - other.re, self.im - other.im)

    def __neg__(self):
        return Gaussian(-self.re, -self.im)

    def __mul__(self, other):
        return Gaussian(self.re * other.re - self.im * other.im, self.re * other.im + self.im * other.re)

    def __truediv__(self, other):
        n = other.norm()
        return self * Gaussian(other.re / n, -other.im / n)

    def __eq__(self, other):
        return self.re == other.re and self.im == other.im

    def conjugate(self):
        return Gaussian(self.re, -self.im)

    def norm(self):
        return self.re * self.re + self.im * self.im


ZERO, ONE = Gaussian(0), Gaussian(1)


class Isometry:
    """z ↦ (az + b)/(cz + 1)."""

    def __init__(self, a, b, c, d=ONE):
        self.a, self.b, self.c = a / d, b / d, c / d

    def __call__(self, z):
        return (self.a * z + self.b) / (self.c * z + ONE)

    def after(self, other):
        """Returns the composition: first the other map, then this one."""
        return Isometry(self.a * other.a + self.b * other.c, self.a * other.b + self.b,
                        self.c * other.a + other.c, self.c * other.b + ONE)

    def inverse(self):
        return Isometry(ONE, -self.b, -self.c, self.a)

    def is_identity(self):
        return self.a == ONE and self.b == ZERO and self.c == ZERO


IDENTITY = Isometry(ONE, ZERO, ZERO)


def translation_to(c):
    """Returns z ↦ (z + c)/(1 + c̄z), the map F of docs/format.md."""
    return Isometry(ONE, c, c.conjugate())


def crossing(p, q, p_other, q_other):
    """The isometry p ↦ q′, q ↦ p′."""
    first, last = translation_to(-p), translation_to(q_other)
    turn = last.inverse()(p_other) / first(q)
    return last.after(Isometry(turn, ZERO, ZERO)).after(first)


def gap(z):
    return 1 - z.norm()


def sinh2_half(z, w):
    """sinh² of half of the distance."""
    return (z - w).norm() / (gap(z) * gap(w))


def orientation(u, v, w):
    """Positive if counterclockwise: det of (2x, 2y, 1 + |z|²)."""
    u, v, w = [(z.re, z.im, 1 + z.norm()) for z in (u, v, w)]
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
            u[2] * (v[0] * w[1] - v[1] * w[0]))


def in_circle(p, q, r, far):
    """Positive if far is inside the circle through the counterclockwise p, q, r."""
    rows = [(z - far).re for z in (p, q, r)], [(z - far).im for z in (p, q, r)], [(z - far).norm() for z in (p, q, r)]
    (a, d, g), (b, e, h), (c, f, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def sinh2_circumradius(p, q, r):
    """sinh² of the circumradius, or None if there is no circumcircle."""
    a, b, c = sinh2_half(p, q), sinh2_half(q, r), sinh2_half(r, p)
    k = 2 * (a * b + b * c + c * a) - a * a - b * b - c * c
    return 4 * a * b * c / k if k > 0 else None


def arsinh_sqrt(x, digits=100):
    """Returns arsinh √x as a decimal with the given number of digits."""
    from decimal import Decimal, localcontext
    with localcontext() as context:
        context.prec = digits
        x = Decimal(x.numerator) / Decimal(x.denominator)
        return (x.sqrt() + (x + 1).sqrt()).ln()


def rational(x):
    return str(x.numerator) if x.denominator == 1 else f"{x.numerator}/{x.denominator}"


def point(x, y):
    return Gaussian(Fraction(x), Fraction(y))


def written_point(z):
    return [rational(z.re), rational(z.im)]


class Surface:
    """The sides of a surface made of tiles, numbered through, and their crossings."""

    def __init__(self, document):
        self.tiles = [[point(x, y) for x, y in tile] for tile in document["tiles"]]
        self.first, self.tile_of = [], []
        for t, tile in enumerate(self.tiles):
            self.first.append(len(self.tile_of))
            self.tile_of += [t] * len(tile)
        self.partner = [None] * len(self.tile_of)
        for t, k, u, j in document["gluing"]:
            self.partner[self.first[t] + k], self.partner[self.first[u] + j] = self.first[u] + j, self.first[t] + k
        self.known = {}

    def ends(self, side):
        tile = self.tiles[self.tile_of[side]]
        k = side - self.first[self.tile_of[side]]
        return tile[k], tile[(k + 1) % len(tile)]

    def crossing(self, side):
        if side not in self.known:
            self.known[side] = crossing(*self.ends(side), *self.ends(self.partner[side]))
        return self.known[side]

    def value(self, word):
        result = IDENTITY
        for side in word:
            result = self.crossing(side).after(result)
        return result

    def inverse_word(self, word):
        return [self.partner[side] for side in reversed(word)]

    def reduced(self, word):
        result = []
        for side in word:
            if result and self.partner[side] == result[-1]:
                result.pop()
            else:
                result.append(side)
        return result


def following(dart):
    return dart - 2 if dart % 3 == 2 else dart + 1


def preceding(dart):
    return dart + 2 if dart % 3 == 0 else dart - 1


class Mesh:
    """A net taken apart: every vertex is a point of a tile, the centre of a chart of its own; corner i of a triangle
    has a word that leads from the tile of its vertex to the tile of the triangle's corner 0; that of corner 0 is empty.
    """

    def __init__(self, document):
        self.document = document
        self.surface = Surface(document["surface"])
        charts = [(t, point(x, y)) for t, x, y in document["charts"]]
        self.points = []
        for c, x, y in document["vertices"]:
            tile, centre = charts[c]
            self.points.append((tile, translation_to(centre)(point(x, y))))
        self.vertex, self.words, self.opposite = [], [], []
        for row in document["triangles"]:
            self.vertex.append(row[:3])
            self.opposite += row[3:6]
            self.words.append([[]] + [document["labels"][n - 1][2] if n else [] for n in row[6:]])

    def start(self, dart):
        return self.vertex[dart // 3][dart % 3]

    def word(self, dart):
        return self.words[dart // 3][dart % 3]

    def corner(self, dart):
        """In the tile of the triangle's corner 0."""
        return self.surface.value(self.word(dart))(self.points[self.start(dart)][1])

    def corners(self, t):
        return [self.corner(3 * t + i) for i in range(3)]

    def far_word(self, dart):
        """Returns the word of the neighbour's far corner, leading to the tile of this triangle."""
        other = self.opposite[dart]
        return (self.word(preceding(other)) + self.surface.inverse_word(self.word(following(other))) +
                self.word(dart))

    def far_corner(self, dart):
        return self.surface.value(self.far_word(dart))(self.points[self.start(preceding(self.opposite[dart]))][1])

    def excess(self, dart):
        """Positive if the edge is not Delaunay, 0 for a tie."""
        return in_circle(self.corner(dart), self.corner(following(dart)), self.corner(preceding(dart)),
                         self.far_corner(dart))

    def length(self, dart):
        """Returns sinh² of half of its length."""
        return sinh2_half(self.corner(dart), self.corner(following(dart)))

    def is_flippable(self, dart):
        """Whether the two triangles make a strictly convex quadrilateral."""
        if dart // 3 == self.opposite[dart] // 3:
            return False
        a, b, c = self.corner(dart), self.corner(following(dart)), self.corner(preceding(dart))
        d = self.far_corner(dart)
        return orientation(a, d, c) > 0 and orientation(d, b, c) > 0

    def set_triangle(self, t, vertices, words, opposite):
        """Sets a triangle, with words that lead to any one tile; links its darts and their opposites to each other."""
        back = self.surface.inverse_word(words[0])
        self.vertex[t] = list(vertices)
        self.words[t] = [self.surface.reduced(word + back) for word in words]
        for i, other in enumerate(opposite):
            self.opposite[3 * t + i] = other
            self.opposite[other] = 3 * t + i

    def flip(self, dart):
        """Dart a → b of the triangle abc becomes d → c of dbc; far corner d. Returns it."""
        other = self.opposite[dart]
        t, u = dart // 3, other // 3
        bc, ca, ad, db = following(dart), preceding(dart), following(other), preceding(other)
        a, b, c, d = self.start(dart), self.start(bc), self.start(ca), self.start(db)
        wa, wb, wc, wd = self.word(dart), self.word(bc), self.word(ca), self.far_word(dart)
        outer = {x: self.opposite[x] for x in (bc, ca, ad, db)}
        # Two of the four outer edges may be the same one.
        moved = {bc: 3 * u + 1, ca: 3 * t + 2, ad: 3 * t, db: 3 * u}
        over = {x: moved.get(y, y) for x, y in outer.items()}
        self.set_triangle(t, (a, d, c), (wa, wd, wc), (over[ad], 3 * u + 2, over[ca]))
        self.set_triangle(u, (d, b, c), (wd, wb, wc), (over[db], over[bc], 3 * t + 1))
        return 3 * u + 2

    def make_delaunay(self):
        changed = True
        while changed:
            changed = False
            for dart in range(len(self.opposite)):
                if self.opposite[dart] > dart and self.excess(dart) > 0:
                    self.flip(dart)
                    changed = True

    def insert(self, t, z):
        """Inserts a vertex at z, inside triangle t, in the tile of its corner 0."""
        v, n = len(self.points), len(self.vertex)
        tile = self.points[self.vertex[t][0]][0]
        self.points.append((tile, z))
        corners, words = self.vertex[t], self.words[t]
        outer = self.opposite[3 * t:3 * t + 3]
        names = [t, n, n + 1]
        moved = {3 * t + i: 3 * names[i] for i in range(3)}
        self.vertex += [None, None]
        self.words += [None, None]
        self.opposite += [0] * 6
        for i in range(3):
            j = (i + 1) % 3
            self.set_triangle(names[i], (corners[i], corners[j], v), (words[i], words[j], []),
                              (moved.get(outer[i], outer[i]), 3 * names[j] + 2, 3 * names[i - 1] + 1))
        return v

    def star(self, v):
        """The darts that leave a vertex."""
        first = dart = next(d for d in range(len(self.opposite)) if self.start(d) == v)
        result = []
        while not result or dart != first:
            result.append(dart)
            dart = self.opposite[preceding(dart)]
        return result

    def remove(self, v):
        """Removes a vertex: flips edges at it until three are left, and replaces its three triangles by one."""
        while len(self.star(v)) > 3:
            self.flip(next(d for d in self.star(v) if self.start(following(d)) != v and self.is_flippable(d)))
        darts = self.star(v)
        first = darts[0]
        # The neighbours' corners in the tile of the first triangle; the third one across an edge.
        a, b = following(first), preceding(first)
        words = [self.word(a), self.word(b), self.far_word(b)]
        vertices = [self.start(a), self.start(b), self.start(preceding(darts[1]))]
        outer = [self.opposite[following(d)] for d in darts]
        t = darts[0] // 3
        moved = {following(d): 3 * t + i for i, d in enumerate(darts)}
        self.set_triangle(t, vertices, words, [moved.get(x, x) for x in outer])
        self.drop_triangles({d // 3 for d in darts[1:]})
        del self.points[v]
        self.vertex = [[w - (w > v) for w in row] for row in self.vertex]

    def drop_triangles(self, gone):
        kept = [t for t in range(len(self.vertex)) if t not in gone]
        names = {t: k for k, t in enumerate(kept)}
        self.vertex = [self.vertex[t] for t in kept]
        self.words = [self.words[t] for t in kept]
        self.opposite = [3 * names[d // 3] + d % 3 for t in kept for d in self.opposite[3 * t:3 * t + 3]]

    def write(self, epsilon=None):
        """Returns the document, in which every vertex is the centre of a chart of its own."""
        labels, numbers, rows = [], {}, []
        for t, vertices in enumerate(self.vertex):
            row = list(vertices) + self.opposite[3 * t:3 * t + 3]
            for i in (1, 2):
                key = (vertices[i], vertices[0], tuple(self.words[t][i]))
                if key[0] == key[1] and not key[2]:
                    row.append(0)
                    continue
                if key not in numbers:
                    labels.append([key[0], key[1], list(key[2])])
                    numbers[key] = len(labels)
                row.append(numbers[key])
            rows.append(row)
        return {"format": "epsnet-net", "version": 1, "surface": self.document["surface"],
                "epsilon": epsilon or self.document["epsilon"],
                "charts": [[tile] + written_point(z) for tile, z in self.points], "labels": labels,
                "vertices": [[v, 0, 0] for v in range(len(self.points))], "triangles": rows}

    # Bounds.

    def sheets(self, dart, shift):
        """Returns the number of sheets by which the dart leads on; shift(side) is that of a crossing."""
        other = self.opposite[dart]
        path = self.word(dart), self.word(following(other))
        return sum(map(shift, path[0])) - sum(map(shift, path[1]))

    def cover(self, degree, shift):
        """Returns the triangles and darts of the cyclic cover: for each copy (sheet, triangle) the opposite darts."""
        n = len(self.opposite)
        opposite = []
        for sheet in range(degree):
            for dart in range(n):
                # (sheet) is that of the triangle's corner 0.
                opposite.append((sheet - self.sheets(dart, shift)) % degree * n + self.opposite[dart])
        return opposite


def cycles_of(opposite):
    """Returns, by dart, the number of the cycle of darts around its start; and the number of cycles."""
    number, count = [None] * len(opposite), 0
    for first in range(len(opposite)):
        if number[first] is not None:
            continue
        dart = first
        while number[dart] is None:
            number[dart] = count
            dart = opposite[preceding(dart)]
        count += 1
    return number, count


def net_of_tiles(tiles, opposite, epsilon):
    """The surface of triangular tiles, side k of tile t being dart 3t + k, and the net whose triangles are the tiles.
    """
    cycle, count = cycles_of(opposite)
    # The words from the tile of a vertex' first dart to the tile of each dart that leaves it, going around.
    word, first_dart = [None] * len(opposite), [None] * count
    for first in range(len(opposite)):
        if first_dart[cycle[first]] is not None:
            continue
        first_dart[cycle[first]] = first
        dart, path = first, []
        while word[dart] is None:
            word[dart] = path
            path = path + [preceding(dart)]
            dart = opposite[preceding(dart)]
    document = {"format": "epsnet-net", "version": 1,
                "surface": {"kind": "tiles", "tiles": [[written_point(z) for z in tile] for tile in tiles],
                            "gluing": [[d // 3, d % 3, o // 3, o % 3] for d, o in enumerate(opposite) if d < o]},
                "epsilon": epsilon, "charts": [], "labels": [], "vertices": [], "triangles": []}
    mesh = Mesh(document)
    mesh.points = [(d // 3, tiles[d // 3][d % 3]) for d in first_dart]
    mesh.opposite = list(opposite)
    for t in range(len(tiles)):
        mesh.vertex.append([cycle[3 * t + i] for i in range(3)])
        back = mesh.surface.inverse_word(word[3 * t])
        mesh.words.append([mesh.surface.reduced(word[3 * t + i] + back) for i in range(3)])
    return mesh.write()
