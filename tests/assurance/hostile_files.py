#!/usr/bin/env python3
"""hostile_files.py DATA EPSNET DIRECTORY [KIND...]: writes files below 1 MB that demand much time or memory.

Each kind is one file, DIRECTORY/KIND.json. DATA is tests/data, EPSNET the program. docs/format.md has the limits of time
and memory for a file ("Limits"). Without kinds, all are written; if DIRECTORY is "-", prints their names.
"""
import cmath
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from decimal import Decimal, getcontext
from fractions import Fraction

sys.dont_write_bytecode = True  # Nothing is written beside the sources.

from field_surfaces import Field, over

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)
SIZE = 950_000
data = epsnet_program = None
kinds = {}


def kind(function):
    kinds[function.__name__.replace("_", "-")] = function
    return function


def net(name):
    with open(os.path.join(data, "certify", "verified", name + ".json")) as file:
        return json.load(file)


def geodesics(name):
    with open(os.path.join(data, "geodesics", name + ".json")) as file:
        return json.load(file)


def epsnet(*command, surface):
    """Returns the output of `epsnet COMMAND` for the surface of `epsnet surface SURFACE`."""
    with tempfile.TemporaryDirectory() as folder:
        made, result = os.path.join(folder, "s.json"), os.path.join(folder, "r.json")
        subprocess.run([epsnet_program, "surface", *surface, "-o", made], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([epsnet_program, command[0], made, *command[1:], "-o", result], check=True,
                       stdout=subprocess.DEVNULL)
        with open(result) as file:
            return json.load(file)


def digits(count, seed=1):
    """Returns an odd number of `count` digits, between 10^(count - 1) and 2 10^(count - 1)."""
    return 10 ** (count - 1) + random.Random(seed).randrange(10 ** (count - 1)) | 1


def rational(x):
    return f"{x.numerator}/{x.denominator}"


def near(x, count, seed=1):
    """Returns a rational near the number x with the given number of digits in total."""
    denominator = digits(count // 2, seed)
    return rational(Fraction(round(Fraction(x) * denominator) | 1, denominator))


def turns_left(points):
    """Whether three points are counterclockwise in the hyperbolic plane, by a clear margin."""
    u, v, w = [(2 * x, 2 * y, 1 + x * x + y * y) for x, y in ((float(x), float(y)) for x, y in points)]
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
            u[2] * (v[0] * w[1] - v[1] * w[0])) > 1e-6


def relator(sides):
    """A word of a 2n-gon with opposite sides glued that turns once around the corner where all corners meet."""
    word, side = [], 0
    for _ in range(sides):
        word.append(side)
        side = ((side + sides // 2) + 1) % sides
    return word


def reduced_word(sides, letters, seed=1):
    """A random word without backtracking on a polygon with opposite sides glued."""
    choose, word = random.Random(seed), []
    while len(word) < letters:
        side = choose.randrange(sides)
        if not word or (side + sides // 2) % sides != word[-1]:
            word.append(side)
    return word


def regular_net(genus, digits_of_epsilon=12):
    """Returns the net of one vertex, the centre of the regular polygon. All circumradii are equal, and epsilon is slightly
    larger."""
    document = epsnet("net", "--epsilon", "25", surface=["regular", "--genus", str(genus)])
    getcontext().prec = digits_of_epsilon + 30
    # cosh R = cot²(π/4g), R = ln(cosh R + √(cosh² R − 1)).
    angle = decimal_pi() / (4 * genus)
    sine, term, k = angle, angle, 1
    while abs(term) > Decimal(10) ** -getcontext().prec:
        term *= -angle * angle / ((k + 1) * (k + 2))
        sine += term
        k += 2
    cosh = (1 - sine * sine) / (sine * sine)
    radius = (cosh + (cosh * cosh - 1).sqrt()).ln()
    document["epsilon"] = str(radius.quantize(Decimal(10) ** -digits_of_epsilon) + Decimal(10) ** -digits_of_epsilon)
    return document


def decimal_pi():
    """Machin's formula."""
    unit = 10 ** (getcontext().prec + 10)

    def arctan_inverse(x):
        total = term = unit // x
        k = 1
        while term:
            term //= -x * x
            k += 2
            total += term // k
        return total
    return Decimal(4 * (4 * arctan_inverse(5) - arctan_inverse(239))) / unit


def filled(word, unit, document, rest=0):
    """word + unit + unit + …, as long as the document stays below the size."""
    each = len(json.dumps(unit, separators=(",", ":")))
    room = SIZE - rest - len(json.dumps(document, separators=(",", ":")))
    return word + unit * max(0, min(room // each, (10**6 - len(word)) // len(unit)))


# Labels.

@kind
def label_of_a_power():
    document = net("octagon-1-vertex")
    document["labels"][0][2] = filled(document["labels"][0][2], [3, 3], document)
    return document


@kind
def label_with_relators():
    document = net("octagon-1-vertex")
    document["labels"][0][2] = filled(document["labels"][0][2], relator(8), document)
    return document


@kind
def labels_all_with_relators():
    document = net("octagon-1-vertex")
    for label in document["labels"]:
        label[2] = label[2] + relator(8) * 4500
    return document


@kind
def label_that_cancels():
    document = net("octagon-1-vertex")
    document["labels"][0][2] = filled(document["labels"][0][2], [3, 7], document)
    return document


@kind
def label_random():
    document = net("octagon-1-vertex")
    document["labels"][0][2] = reduced_word(8, 400_000)
    return document


@kind
def labels_unused():
    document = net("octagon-1-vertex")
    document["labels"] += [[0, 0, []]] * 90_000
    return document


@kind
def labels_unused_of_a_regular_surface():
    document = regular_net(997)
    document["labels"] += [[0, 0, reduced_word(4 * 997, 100, k)] for k in range(800)]
    return document


# Charts.

@kind
def chart_of_50000_digits_and_collinear_vertices():
    document = net("octagon-9-vertices")
    document["charts"] = [[chart[0], near(0.1, 50_000), near(0.2, 50_000)] for chart in document["charts"]]
    document["vertices"] = [[0, k / 16, 0.0] for k in range(9)]
    return document


@kind
def chart_of_200000_digits():
    document = net("octagon-1-vertex")
    document["charts"] = [[0, near(0.93729, 450_000, 3), near(0.00001, 450_000, 4)]]
    document["vertices"] = [[0, 0.0, 0.0]]
    return document


@kind
def charts_of_their_own_for_all_vertices():
    document = net("octagon-33-vertices")
    centres = [document["charts"][c][1:] for c, _, _ in document["vertices"]]
    assert all(centre == ["0", "0"] for centre in centres)
    old_labels, labels, numbers = document["labels"], [], {}
    for triangle in document["triangles"]:
        for i in (1, 2):
            key = (triangle[i], triangle[0], triangle[5 + i])
            if key not in numbers:
                labels.append([key[0], key[1], old_labels[key[2] - 1][2] if key[2] else []])
                numbers[key] = len(labels)
            triangle[5 + i] = numbers[key]
    document["labels"] = labels
    document["charts"] = [[0, near(x, 13_000, 2 * v), near(y, 13_000, 2 * v + 1)]
                          for v, (_, x, y) in enumerate(document["vertices"])]
    document["vertices"] = [[v, 0.0, 0.0] for v in range(len(document["vertices"]))]
    return document


@kind
def chart_near_the_circle():
    document = net("octagon-1-vertex")
    document["charts"] = [[0, rational(1 - Fraction(1, 10**100_000)), "0"]]
    return document


@kind
def chart_rather_near_the_circle():
    document = net("octagon-1-vertex")
    document["charts"] = [[0, rational(1 - Fraction(1, 10**1_000)), "0"]]
    return document


@kind
def charts_of_a_regular_surface():
    document = regular_net(100)
    document["charts"] = [[0, near(1e-9, 20_000), near(1e-9, 20_000, 2)]]
    return document


# Surfaces.

@kind
def tile_of_long_coordinates():
    document = net("octagon-1-vertex")
    centre = (Fraction(near(0.1, 3_500, 5)), Fraction(near(0.05, 3_500, 6)))

    def moved(x, y):
        # (z + c)/(1 + c̄ z).
        c, d = centre
        real, imaginary = 1 + c * x + d * y, c * y - d * x
        square = real * real + imaginary * imaginary
        return (((x + c) * real + (y + d) * imaginary) / square, ((y + d) * real - (x + c) * imaginary) / square)
    tile = document["surface"]["tiles"][0]
    document["surface"]["tiles"] = [[[rational(z) for z in moved(Fraction(x), Fraction(y))] for x, y in tile]]
    return document


@kind
def tile_of_random_long_coordinates():
    document = net("octagon-1-vertex")
    tile = document["surface"]["tiles"][0]
    document["surface"]["tiles"] = [[[near(Fraction(z), 58_000, 16 * k + i) for i, z in enumerate(vertex)]
                                     for k, vertex in enumerate(tile)]]
    return document


def over_large_field(document, power):
    """The same rational surface, numbers times α^power, over a field of degree 64 with products that are much larger than
    their factors: f = x⁶⁴ − c_31 x³¹ − … − c_0, each c of a hundred bits."""
    choose = random.Random(7)
    field = Field([-choose.getrandbits(100) for _ in range(32)] + [0] * 32 + [1], ["0", "1024"])
    return over(field, document, field.number(*[0] * power, 1), field.number(0))


@kind
def field_of_large_products():
    return over_large_field(net("octagon-33-vertices"), 9)


@kind
def field_of_larger_products():
    return over_large_field(net("octagon-33-vertices"), 15)


@kind
def field_of_large_coefficients():
    """Remainders of products by f, of 64 coefficients of 2,000 bits each, have 64 times as many bits as these."""
    choose = random.Random(2)
    polynomial = [str(-choose.getrandbits(2000))] + [str(choose.getrandbits(2000)) for _ in range(63)] + ["1"]
    zero, one = ["0"], ["1"]
    polygons = [[[[str(choose.randint(1, 9)) for _ in range(64)] for _ in range(3)], [zero, zero, one], [zero, zero, one]]
                for _ in range(1000)]
    sides = [(tile, side) for tile in range(1000) for side in range(3)]
    gluing = [[*first, *second] for first, second in zip(sides[::2], sides[1::2])]
    return {"format": "epsnet-net", "version": 1,
            "surface": {"kind": "field", "polynomial": polynomial, "root": ["0", "2"], "polygons": polygons,
                        "gluing": gluing, "crossings": [[one, zero, zero, zero] for _ in gluing]},
            "epsilon": "1", "charts": [[0, "0", "0"]], "labels": [], "vertices": [[0, 0, 0]],
            "triangles": [[0, 0, 0, 0, 1, 2, 0, 0]]}


@kind
def field_of_nearly_equal_roots():
    """Those of x⁶⁴ = 2(2^100 x − 1)², near 2^−100, whose distance is 2^−3300."""
    document = net("octagon-33-vertices")
    large = 2**100
    field = Field([-2, 4 * large, -2 * large**2] + [0] * 61 + [1], [f"1/{large}", "1"])
    return over(field, document, field.number(-1, large), field.number(0))


@kind
def field_of_many_factors():
    """√2 as a root of (x² − 2)(x² − 5)(x² − 7) …, of degree 64: x² − 2 is 0, and what other factors divide is not."""
    document = net("octagon-33-vertices")
    factors = [[-n, 0, 1] for n in range(2, 46) if all(n % k for k in (4, 9, 25)) and n != 3][:32]
    polynomial = [1]
    for factor in factors:
        polynomial = [a + b for a, b in zip([factor[0] * c for c in polynomial] + [0, 0], [0, 0] + polynomial)]
    field = Field(polynomial, ["7/5", "3/2"])
    zero = field.number(*[0] * 20, -2, 0, 1)
    return over(field, document, field.number(5, 0, -1), zero)


@kind
def tile_of_many_sides():
    """Points of a circle, symmetric, opposite sides glued: a surface that does not close up."""
    half = 4_000
    points = []
    for k in range(half):
        t = Fraction(round(10**6 * math.tan(math.pi * (k + 0.5) / half / 2)), 10**6)
        points.append((Fraction(99, 100) * (1 - t * t) / (1 + t * t), Fraction(99, 100) * 2 * t / (1 + t * t)))
    points += [(-x, -y) for x, y in points]
    document = net("octagon-1-vertex")
    document["surface"] = {"kind": "tiles", "tiles": [[[rational(z) for z in point] for point in points]],
                           "gluing": [[0, k, 0, k + half] for k in range(half)]}
    return document


@kind
def tiles_cut_into_many():
    """The octagon cut into triangles by rational points, three for one again and again."""
    choose = random.Random(1)
    document = net("octagon-1-vertex")
    octagon = [(Fraction(x), Fraction(y)) for x, y in document["surface"]["tiles"][0]]
    centre = (Fraction(0), Fraction(0))
    tiles = [[centre, octagon[k], octagon[(k + 1) % 8]] for k in range(8)]
    while len(tiles) < 1_700:
        k = choose.randrange(len(tiles))
        a, b, c = tiles[k]
        x = Fraction(round(10**7 * float(a[0] + b[0] + c[0]) / 3), 10**7)
        y = Fraction(round(10**7 * float(a[1] + b[1] + c[1]) / 3), 10**7)
        parts = [[a, b, (x, y)], [b, c, (x, y)], [c, a, (x, y)]]
        if all(turns_left(part) for part in parts):
            tiles[k:k + 1] = parts
    sides = {}
    for t, tile in enumerate(tiles):
        for k in range(3):
            sides[tile[k], tile[(k + 1) % 3]] = (t, k)
    gluing = []
    for (p, q), (t, k) in sides.items():
        other = sides.get((q, p))
        if other is None:
            i = octagon.index(p)
            other = sides[octagon[(i + 4) % 8], octagon[(i + 5) % 8]]
        if (t, k) < other:
            gluing.append([t, k, *other])
    document["surface"] = {"kind": "tiles", "gluing": gluing,
                           "tiles": [[[rational(z) for z in point] for point in tile] for tile in tiles]}
    document["charts"] = [[0, "0", "0"]]
    document["labels"] = []
    for triangle in document["triangles"]:
        triangle[6:] = [0, 0]
    return document


@kind
def high_genus_of_many_tiles():
    return epsnet("net", "--epsilon", "20", surface=["fenchel-nielsen", "--genus", "90", "--seed", "1"])


# Triangles.

@kind
def triangles_all_collinear():
    document = epsnet("net", "--epsilon", "0.04", surface=["octagon", "--seed", "5"])
    document["vertices"] = [[c, (k - 2_000) / 4_096, 0.0] for k, (c, _, _) in enumerate(document["vertices"])]
    return document


@kind
def triangles_nearly_collinear():
    document = epsnet("net", "--epsilon", "0.04", surface=["octagon", "--seed", "5"])
    document["vertices"] = [[c, x, y * 1e-300] for c, x, y in document["vertices"]]
    return document


@kind
def vertices_at_the_circle():
    document = epsnet("net", "--epsilon", "0.05", surface=["octagon", "--seed", "5"])
    for vertex in document["vertices"]:
        angle = cmath.phase(complex(vertex[1], vertex[2]))
        vertex[1:] = [math.cos(angle) * (1 - 2e-16), math.sin(angle) * (1 - 2e-16)]
    return document


@kind
def circumradii_all_epsilon():
    return regular_net(997, 3_000)


@kind
def circumradii_all_epsilon_in_a_chart_of_many_digits():
    document = regular_net(300, 3_000)
    document["charts"] = [[0, near(1e-9, 200_000), near(1e-9, 200_000, 2)]]
    document["vertices"] = [[0, -1e-9, -1e-9]]
    return document


@kind
def epsilon_of_900000_digits():
    document = net("octagon-1-vertex")
    document["epsilon"] = f"4.{digits(900_000)}"
    return document


@kind
def epsilon_rational_of_900000_digits():
    document = net("octagon-1-vertex")
    document["epsilon"] = near(4, 900_000)
    return document


# Regular surfaces.

@kind
def regular_genus_997():
    return regular_net(997)


@kind
def regular_genus_997_in_another_chart():
    document = regular_net(997)
    document["charts"] = [[0, near(0.3, 1_000), near(-0.2, 1_000, 2)]]
    document["vertices"] = [[0, -0.25, 0.125]]
    return document


@kind
def regular_with_relators():
    document = regular_net(100)
    for label in document["labels"]:
        label[2] = label[2] + relator(400)
    return document


@kind
def regular_with_one_long_word():
    document = regular_net(2)
    document["labels"][0][2] = document["labels"][0][2] + relator(8) * 50_000
    return document


@kind
def regular_with_one_random_word():
    document = regular_net(20)
    document["labels"][0][2] = reduced_word(80, 250_000)
    return document


@kind
def regular_with_words_of_2000_turns():
    document = regular_net(2)
    for k, label in enumerate(document["labels"]):
        path = reduced_word(8, 2_000, k)
        label[2] = label[2] + path + [(s + 4) % 8 for s in reversed(path)][1:] + [(path[0] + 4) % 8]
        label[2] = path + relator(8) + [(s + 4) % 8 for s in reversed(path)] + label[2]
    return document


# Collars.

def pseudo_net(genus=2, length="0.01"):
    if genus == 2:
        return epsnet("net", "--epsilon", "0.3", "--pseudo",
                      surface=["fenchel-nielsen", "--pants-graph", "0-0 0-1 1-1", "--lengths", f"1.3,{length},2",
                               "--seed", "1"])
    return epsnet("net", "--epsilon", "0.3", "--pseudo",
                  surface=["fenchel-nielsen", "--genus", str(genus), "--seed", "1", "--lengths",
                           ",".join([length] * (3 * genus - 3))])


def there_and_back(document, core):
    """A letter that may follow the word, and the one that takes it back."""
    sizes = [len(tile) for tile in document["surface"]["tiles"]]
    first = [sum(sizes[:t]) for t in range(len(sizes))]
    partner = {}
    for t, k, u, j in document["surface"]["gluing"]:
        partner[first[t] + k], partner[first[u] + j] = first[u] + j, first[t] + k
    return [core[0], partner[core[0]]], partner


@kind
def collar_core_that_cancels():
    document = pseudo_net()
    core = document["collars"][0]["core"]
    pair, _ = there_and_back(document, core)
    document["collars"][0]["core"] = pair * 5_000 + core
    return document


@kind
def collar_core_that_cancels_in_450000_letters():
    document = pseudo_net()
    core = document["collars"][0]["core"]
    pair, _ = there_and_back(document, core)
    document["collars"][0]["core"] = filled([], pair, document) + core
    return document


@kind
def collar_core_of_a_power():
    document = pseudo_net()
    core = document["collars"][0]["core"]
    document["collars"][0]["core"] = filled(core, core, document)
    return document


@kind
def collar_in_a_tile_of_long_coordinates():
    document = pseudo_net(length="1e-12")
    chart = document["vertices"][document["collars"][0]["vertices"][0]][0]
    document["charts"] = [[t, x, y] if c != chart else [t, near(Fraction(x), 50_000), near(Fraction(y), 50_000, 2)]
                          for c, (t, x, y) in enumerate(document["charts"])]
    core = document["collars"][0]["core"]
    document["collars"][0]["core"] = filled(core, core, document)
    return document


@kind
def collars_many():
    return pseudo_net(12)


# Closed geodesics.

def floating_crossings(sides):
    """Crossings of the polygon with opposite sides glued as pairs (a, b)."""
    n = len(sides)
    result = []
    for k in range(n):
        p, q = sides[k], sides[(k + 1) % n]
        p2, q2 = sides[(k + n // 2) % n], sides[(k + n // 2 + 1) % n]
        w = (q - p) / (1 - p.conjugate() * q)
        w2 = (p2 - q2) / (1 - q2.conjugate() * p2)
        turn = cmath.exp(0.5j * cmath.phase(w2 / w))
        result.append(compose((1, q2), compose((turn, 0), (1, -p))))
    return [normalized(f) for f in result]


def compose(f, g):
    return (f[0] * g[0] + f[1] * complex(g[1]).conjugate(), f[0] * g[1] + f[1] * complex(g[0]).conjugate())


def normalized(f):
    scale = math.sqrt(abs(f[0]) ** 2 - abs(f[1]) ** 2)
    return (f[0] / scale, f[1] / scale)


def length_of(word, crossings):
    """The translation length of a word, from a product that is scaled down now and then."""
    f, log = (1.0, 0.0), 0.0
    for k, side in enumerate(word):
        f = compose(crossings[side], f)
        if k % 50 == 49:
            size = abs(f[0])
            f, log = (f[0] / size, f[1] / size), log + math.log(size)
    trace = abs(2 * complex(f[0]).real)
    if log < 20:
        trace *= math.exp(log)
        return 2 * math.acosh(max(trace / 2, 1))
    return 2 * (log + math.log(trace))


def list_of(document, words, claim="spectrum", up_to=None, equal=False, slack=1e-6):
    """A geodesics file of one net with opposite sides of one octagon glued."""
    octagon = [complex(float(Fraction(x)), float(Fraction(y))) for x, y in document["surface"]["tiles"][0]]
    crossings = floating_crossings(octagon)
    rows = []
    for word in words:
        length = length_of(word, crossings)
        if length < 0.1:
            continue
        rows.append({"vertex": 0, "word": word, "length": [length * (1 - slack), length * (1 + slack)],
                     "simple": False})
    rows.sort(key=lambda row: row["length"][0])
    result = {"format": "epsnet-geodesics", "version": 1, "claim": claim, "net": document, "geodesics": rows}
    if claim == "spectrum":
        result["up_to"] = up_to or str(math.ceil(rows[-1]["length"][1]) + 1)
    if claim != "systole":
        clusters, end = [], 0
        for i, row in enumerate(rows):
            if not clusters or row["length"][0] > end:
                clusters.append({"first": i, "count": 0, "equal": equal})
            clusters[-1]["count"] += 1
            end = max(end, row["length"][1])
        result["clusters"] = clusters
    if claim == "thick-thin":
        result["pieces"] = []
    return result


@kind
def geodesics_300_of_250_letters():
    return list_of(net("octagon-1-vertex"), [reduced_word(8, 250, k) for k in range(300)])


@kind
def geodesics_1200_of_300_letters():
    return list_of(net("octagon-1-vertex"), [reduced_word(8, 300, k) for k in range(1_200)])


@kind
def geodesics_5000_of_30_letters():
    return list_of(net("octagon-1-vertex"), [reduced_word(8, 30, k) for k in range(5_000)])


@kind
def geodesics_permuted():
    """Words of nearly equal lengths: every pair has to be told apart."""
    words = []
    for k in range(2_500):
        blocks = [[0], [1, 1], [2, 2, 2], [3], [0, 0, 1], [1, 2], [3, 3, 2], [0, 3]] * 4
        random.Random(k).shuffle(blocks)
        words.append(sum(blocks, []))
    return list_of(net("octagon-1-vertex"), words, slack=0.3)


@kind
def geodesics_of_one_random_word():
    return list_of(net("octagon-1-vertex"), [reduced_word(8, 400_000)])


@kind
def geodesics_of_one_long_twist():
    return list_of(net("octagon-1-vertex"), [[0] * 400_000 + [1]])


@kind
def geodesics_of_twists():
    return list_of(net("octagon-1-vertex"), [[0] * k + [1] for k in range(1, 800)])


@kind
def geodesics_in_clusters_said_to_be_equal():
    word = reduced_word(8, 60)
    words = [word[k % 60:] + word[:k % 60] for k in range(3_000)]
    return list_of(net("octagon-1-vertex"), words, equal=True)


@kind
def geodesics_equal_and_long():
    word = reduced_word(8, 60_000)
    return list_of(net("octagon-1-vertex"), [word[k:] + word[:k] for k in range(7)], equal=True)


@kind
def geodesics_on_a_fine_net():
    document = epsnet("net", "--epsilon", "0.12", surface=["octagon", "--seed", "5"])
    return list_of(document, [reduced_word(8, 300, k) for k in range(500)])


@kind
def geodesics_of_a_regular_surface():
    document = regular_net(20)
    words = [reduced_word(80, 200, k) for k in range(800)]
    cosh = 1 / math.tan(math.pi / 80)
    sinh = math.sqrt(cosh * cosh - 1)
    crossings = [(cosh, -sinh * cmath.exp(1j * math.pi * k / 40)) for k in range(80)]
    rows = []
    for word in words:
        length = length_of(word, crossings)
        rows.append({"vertex": 0, "word": word, "length": [length * (1 - 1e-6), length * (1 + 1e-6)], "simple": False})
    rows.sort(key=lambda row: row["length"][0])
    result = list_of(net("octagon-1-vertex"), [[0]])
    result.update(net=document, geodesics=rows, up_to="10000")
    end, clusters = 0, []
    for i, row in enumerate(rows):
        if row["length"][0] > end:
            clusters.append({"first": i, "count": 0, "equal": True})
        clusters[-1]["count"] += 1
        end = max(end, row["length"][1])
    result["clusters"] = clusters
    return result


@kind
def spectrum_up_to_9999_digits():
    return list_of(net("octagon-1-vertex"), [[0]], up_to="1e9999")


@kind
def spectrum_up_to_a_number_of_500000_digits():
    words = [reduced_word(8, 12, k) for k in range(2_500)]
    return list_of(net("octagon-1-vertex"), words, up_to=f"200.{digits(500_000)}")


@kind
def spectrum_up_to_14_of_few():
    return list_of(net("octagon-1-vertex"), [[0], [1], [2], [3]], up_to="14")


def eigenvalues_file(name="octagon-5"):
    with open(os.path.join(data, "eigenvalues", name + ".json")) as file:
        return json.load(file)


def with_rows(result, key, row):
    """With so many rows that the file is nearly as large as it may be."""
    result[key] = result[key] + [row] * ((SIZE - 40_000) // len(json.dumps(row) + ", "))
    return result


@kind
def eigenvalues_of_many_counts():
    result = eigenvalues_file()
    return with_rows(result, "at_most", result["at_most"][1])


@kind
def eigenvalues_of_many_counts_by_vertices():
    result = eigenvalues_file()
    return with_rows(result, "at_least", result["at_least"][1])


@kind
def eigenvalues_of_many_intervals():
    result = eigenvalues_file()
    return with_rows(result, "eigenvalues", {"in": [0, 1e308], "count": 4294967295})


def divided(halvings, order_of):
    """An octagon of six triangles with a count for a matrix of many sides, which are eliminated in an order."""
    result = eigenvalues_file("octagon-5-of-one-vertex")
    return {**result, "halvings": halvings, "side_order": order_of(9 * 4**halvings), "at_most": result["at_most"][:1],
            "at_least": [], "vertex_order": []}


@kind
def eigenvalues_of_a_matrix_that_an_order_fills():
    def order(size):
        result = list(range(size))
        random.Random(1).shuffle(result)
        return result
    return divided(7, order)


@kind
def eigenvalues_of_a_matrix_in_the_order_of_its_sides():
    return divided(7, lambda size: list(range(size)))


def sections_of(phases, halvings=5):
    """Of an octagon of six triangles, with a count for a matrix of two rows for each side."""
    result = divided(halvings, lambda size: list(range(size)))
    return {**result, "phases": phases}


@kind
def sections_of_a_matrix_in_the_order_of_its_sides():
    return sections_of(["0.12345678901234567", "1/3", "0", "0", "-0.12345678901234567", "-1/3", "0", "0"], 6)


@kind
def sections_with_a_phase_for_each_byte():
    return sections_of(["0"] * 180_000, 0)


@kind
def sections_with_phases_of_huge_denominators():
    return sections_of([f"1/{10**36 + k}" for k in range(20_000)], 0)


@kind
def sections_with_a_phase_of_500000_digits():
    return sections_of([f"0.{digits(500_000)}"] + ["0"] * 7, 0)


@kind
def sections_along_long_words():
    result = sections_of(["1/999999999999999989", "0", "0", "0", "-1/999999999999999989", "0", "0", "0"], 0)
    labels = result["net"]["labels"]
    word = labels[0][2]
    labels[0] = [*labels[0][:2], word + [0, 4] * ((SIZE - 40_000) // 12)]
    return result


@kind
def eigenvalues_of_many_functions():
    result = eigenvalues_file("octagon-5-with-a-function")
    row = {"in": [2.7, 2.9], "lambda": 2.8, "radius": 1.9, "functions": []}
    function = [1] * (9 * 401)
    row["functions"] = [function] * ((SIZE - 40_000) // len(json.dumps(function)))
    result["eigenfunctions"] = [row]
    return result


@kind
def eigenvalues_of_a_thousand_functions_of_order_1():
    result = eigenvalues_file("octagon-5-with-a-function")
    result["eigenfunctions"] = [{"in": [1e-300, 1e300], "lambda": 1e-300, "radius": 0.90625,
                                 "functions": [[1] * (9 * 3)] * 1000}]
    return result


@kind
def eigenvalues_of_many_rows_of_functions():
    result = eigenvalues_file("octagon-5-with-a-function")
    rows = [{"in": [k, k + 0.5], "lambda": k, "radius": 0.90625, "functions": [[1] * (9 * 3)]}
            for k in range(1, (SIZE - 40_000) // 170)]
    result["eigenfunctions"] = rows
    return result


@kind
def systole_on_a_fine_net():
    result = epsnet("systole", surface=["octagon", "--seed", "5"])
    document = epsnet("net", "--epsilon", "0.045", surface=["octagon", "--seed", "5"])
    row = dict(result["geodesics"][0])
    octagon = list_of(document, [row["word"]], claim="systole", slack=1e-9)
    octagon["geodesics"][0]["simple"] = row["simple"]
    return octagon


@kind
def systole_of_a_long_word():
    return list_of(net("octagon-1-vertex"), [reduced_word(8, 300_000)], claim="systole")


@kind
def systole_of_genus_300():
    # The translation along side 0 is 2 arcosh(cot(π/1200)) long, 13.2; nothing is known to be shorter.
    document = regular_net(300)
    result = list_of(net("octagon-1-vertex"), [[0]], claim="systole")
    result["net"] = document
    length = 2 * math.acosh(1 / math.tan(math.pi / 1200))
    result["geodesics"] = [{"vertex": 0, "word": [0], "length": [length - 1e-9, length + 1e-9], "simple": True}]
    return result


@kind
def thick_thin_of_long_words():
    result = geodesics("three-cuffs")
    pair, partner = there_and_back(result["net"], result["geodesics"][0]["word"])
    result["geodesics"][0]["word"] = filled([], pair, result) + result["geodesics"][0]["word"]
    return result


@kind
def thick_thin_of_a_long_conjugate():
    """A word that goes around the second cuff a hundred thousand times, then the geodesic, then back."""
    result = geodesics("three-cuffs")
    _, partner = there_and_back(result["net"], result["geodesics"][0]["word"])
    around = result["geodesics"][1]["word"]
    count = 30_000
    back = [partner[s] for s in reversed(around)]
    result["geodesics"][0]["word"] = around * count + result["geodesics"][0]["word"] + back * count
    return result


@kind
def pieces_many():
    result = geodesics("three-cuffs")
    result["pieces"] = result["pieces"] + [{"genus": 0, "boundaries": []}] * 25_000
    return result


# What a reader keeps of each byte.

@kind
def empty_arrays_many():
    document = net("octagon-1-vertex")
    document["triangles"] = filled([], [[]], document)
    return document


def isometries_file():
    with open(os.path.join(data, "isometries", "octagon-5.json")) as file:
        return json.load(file)


@kind
def isometries_of_many_rows():
    result = isometries_file()
    row = result["isometries"][0]
    result["isometries"] = [row] * ((SIZE - 60_000) // len(json.dumps(row)))
    return result


@kind
def isometries_of_long_words():
    result = isometries_file()
    word = result["pair"][0]
    result["isometries"][0]["images"][0] = word * ((SIZE - 60_000) // (2 * len(word)))
    return result


@kind
def isometries_of_long_paths():
    """A path of hundreds of thousands of letters, on both sides of each of 120 generators."""
    result = {"format": "epsnet-isometries", "version": 1, "net": regular_net(60), "up_to": "0.001", "geodesics": [],
              "clusters": [], "order": 1, "isometries": [], "pair": [[0], [1]], "cocycle": [0] * 120}
    return {**result, "paths": [filled([], [0], result)]}


@kind
def isometries_of_many_geodesics():
    """A spectrum with thousands of crossing points, none of which tells that there are no more isometries."""
    bolza = ["regular", "--genus", "2"]
    result = epsnet("isometries", surface=bolza)
    spectrum = epsnet("spectrum", "--up-to", "8", surface=bolza)
    result.update({key: spectrum[key] for key in ("net", "geodesics", "clusters", "up_to")}, isometries=[], order=1)
    return result


@kind
def isometries_of_powers():
    """Of a surface with a very short geodesic that crosses no other one of its spectrum: loops are powers of it."""
    def surface(cuff):
        return ["fenchel-nielsen", "--pants-graph", "0-0 0-1 1-1", "--lengths", f"{cuff},2,3", "--seed", "1"]
    result = epsnet("isometries", surface=surface("0.011"))
    spectrum = epsnet("spectrum", "--up-to", "1", surface=surface("0.0005"))
    result.update({key: spectrum[key] for key in ("net", "geodesics", "clusters", "up_to")}, isometries=[], order=1)
    return result


def comparison_file(name):
    with open(os.path.join(data, "comparisons", name + ".json")) as file:
        return json.load(file)


@kind
def comparison_of_long_words():
    """Numbers of two rings that are compared to millions of bits."""
    result = comparison_file("bolza-octagons-8-3")
    word = result["images"][0]
    result["images"][0] = word * ((SIZE - 60_000) // (4 * len(word)))
    return result


@kind
def comparison_by_a_far_lift():
    """A true one, of which all images are conjugated by a word of some hundred letters: numbers of hundreds of bits."""
    result = comparison_file("bolza-octagons-8-3")
    partner = {}
    for t, k, u, l in result["other_net"]["surface"]["gluing"]:
        partner[8 * t + k], partner[8 * u + l] = 8 * u + l, 8 * t + k
    word = (result["images"][0] + result["images"][1]) * 20
    back = [partner[s] for s in reversed(word)]
    result["images"] = [word + image + back for image in result["images"]]
    return result


@kind
def comparison_of_long_paths():
    """A path of a hundred thousand letters, on both sides of each of a thousand generators."""
    net = regular_net(500)
    result = {"format": "epsnet-comparison", "version": 1, "claim": "isometric", "net": net, "other_net": net,
              "preserves_orientation": True, "pair": [[0], [1]], "images": [[0], [1]] + [[s] for s in range(1000)]}
    return {**result, "paths": [filled([], [0], result)]}


@kind
def comparison_of_many_geodesics():
    """A surface and itself, with thousands of points where closed geodesics cross, which are alike."""
    bolza = ["regular", "--genus", "2"]
    spectrum = epsnet("spectrum", "--up-to", "7", surface=bolza)
    first = {key: spectrum[key] for key in ("net", "geodesics", "clusters", "up_to")}
    return {"format": "epsnet-comparison", "version": 1, "claim": "different", **first, "other_spectrum": spectrum}


def pants_file(name="octagon-5"):
    with open(os.path.join(data, "pants", name + ".json")) as file:
        return json.load(file)


def pants_of(net, paths, count):
    """As many pairs of pants with the same paths α and α⁻¹; cuff 2, which is null-homotopic, is glued to that of the next."""
    cuff = {"across": [], "length": [1, 2], "twist": [0, 1], "exp_half_length": "0"}
    ends = [[[p, 0], [p, 1]] for p in range(count)] + [[[p, 2], [p + 1, 2]] for p in range(0, count, 2)]
    return {"format": "epsnet-pants", "version": 1, "net": net, "pants": [paths] * count,
            "cuffs": [{"ends": row, **cuff} for row in ends]}


@kind
def pants_of_a_random_path():
    result = pants_file()
    result["pants"][0][0] = reduced_word(8, 300_000)
    return result


@kind
def pants_of_a_path_that_cancels():
    result = pants_file()
    result["pants"][0][0] = [3, 7] * 150_000 + result["pants"][0][0]
    return result


@kind
def pants_of_a_path_that_cancels_to_nothing():
    """Not letter by letter: forwards and backwards."""
    result = pants_file()
    word = reduced_word(8, 150_000)
    result["pants"][0][0] = word + [(side + 4) % 8 for side in reversed(word)]
    return result


@kind
def pants_around_a_cuff():
    result = pants_file()
    row = result["cuffs"][0]
    row["across"] = result["pants"][0][0] * 100_000
    return result


@kind
def pants_around_a_cuff_of_1e_12():
    result = pants_file("cuff-1e-12")
    row = result["cuffs"][0]
    row["across"] = result["pants"][0][0] * 100_000 + row["across"]
    return result


@kind
def pants_many():
    return pants_of(pants_file()["net"], [[0], [4]], 6_000)


@kind
def pants_of_genus_100():
    """The paths of 198 pairs of pants are words of hundreds of letters, that of each cuff and back is null-homotopic."""
    word = reduced_word(400, 450)
    return pants_of(regular_net(100), [word, [(side + 200) % 400 for side in reversed(word)]], 198)


@kind
def pants_of_an_exact_length_of_400000_digits():
    result = pants_file("fenchel-nielsen-2")
    result["cuffs"][0]["exp_half_length"] = f"{digits(400_000)}/{digits(399_999, 2)}"
    return result


@kind
def pants_in_a_tile_of_long_coordinates():
    result = pants_file()
    tile = result["net"]["surface"]["tiles"][0]
    half = [[near(Fraction(z), 50_000, 16 * k + i) for i, z in enumerate(vertex)] for k, vertex in enumerate(tile[:4])]
    result["net"]["surface"]["tiles"] = [half + [["-" + z if z[0] != "-" else z[1:] for z in v] for v in half]]
    return result


def curves_file(name="octagon-5"):
    with open(os.path.join(data, "curves", name + ".json")) as file:
        return json.load(file)


def curves_with_the_word(word):
    result = curves_file()
    result["curves"][5].update(word=word, length=[0.001, 1e6])
    return result


def curves_of(net, words, homology=None):
    """Of these words, with numbers that are wrong, for a basis of the first ones."""
    size = len(homology[0]) if homology else 0
    curves = [{"vertex": 0, "word": word, "length": [0.001, 1e6], "power": 1, "self_intersections": 0,
               "homology": homology[i] if homology else []} for i, word in enumerate(words)]
    pairs = [{"first": i, "second": j, "intersections": 1, "algebraic": 1}
             for i in range(len(words)) for j in range(i + 1, len(words))]
    return {"format": "epsnet-curves", "version": 1, "net": net, "curves": curves, "pairs": pairs,
            "basis": list(range(size)), "filling": []}


@kind
def curves_of_long_words():
    return curves_with_the_word(reduced_word(8, 400_000))


@kind
def curves_of_many_letters():
    """Words of a few thousand letters, which cross each other and themselves in many points."""
    result = curves_file()
    for row in result["curves"]:
        row.update(word=reduced_word(8, 4_000), length=[0.001, 1e6], power=1)
    return result


@kind
def curves_of_large_powers():
    return curves_with_the_word(curves_file()["curves"][5]["word"] * 100_000)


@kind
def curves_that_cancel_to_nothing():
    """Not letter by letter: forwards and backwards."""
    word = reduced_word(8, 150_000)
    return curves_with_the_word(word + [(side + 4) % 8 for side in reversed(word)])


@kind
def curves_around_a_vertex():
    """Around the vertex of the octagon, a hundred thousand times: null-homotopic, and no letter cancels."""
    around, side = [], 0
    while not around or side != 0:
        around.append(side)
        side = ((side + 4) % 8 + 1) % 8
    return curves_with_the_word(around * 20_000)


@kind
def curves_many():
    """A hundred and fifty random words, each two of which are a pair."""
    return curves_of(regular_net(2), [reduced_word(8, 12) for _ in range(150)])


@kind
def curves_of_genus_80():
    """A basis, true but for the lengths, which are not said exactly: a matrix of 160 rows."""
    return curves_of(regular_net(80), [[k] for k in range(160)],
                     [[int(k == j) for k in range(160)] for j in range(160)])


@kind
def curves_of_many_sets():
    result = curves_file("bolza")
    room = SIZE - len(json.dumps(result))
    row = result["filling"][0]
    result["filling"] = [row] * (room // (len(json.dumps(row)) + 2))
    return result


@kind
def pants_nested_deeply():
    result = pants_file()
    word = []
    for _ in range(900):
        word = [word]
    result["pants"][0][0] = word
    return result


@kind
def distance_of_many_paths():
    with open(os.path.join(data, "distances", "four-equal.json")) as file:
        result = json.load(file)
    words = [[]]
    while len(words) < 45_000:
        words += [[*word, side] for word in words[len(words) // 4:] for side in range(4)]
    result.update(distance=[0.001, 300], equal=False, paths=words[1:45_000])
    return result


@kind
def distance_to_a_point_of_many_digits():
    """On a surface of genus 20: the digits are multiplied by numbers of a large degree."""
    result = epsnet("distance", "0,0.1,-1/3", "0,0,0", surface=["regular", "--genus", "20"])
    result.update(point=[0, rational(Fraction(digits(200_000), digits(200_000, 2) * 2)), "0"], distance=[0, 1000])
    letters = random.Random(1)
    result["paths"] = [[letters.randrange(80) for _ in range(30)] for _ in range(2)]
    return result


@kind
def bound_of_many_triangulations():
    document = regular_net(20)
    triangles = len(document["triangles"])
    result = {"format": "epsnet-cover", "version": 1, "claim": "diameter", "net": document, "value": [0.1, 100],
              "cells": [[3]] * triangles, "triangulations": []}
    result["triangulations"] = [[0]] * ((SIZE - len(json.dumps(result))) // 4)
    return result


@kind
def bound_of_far_elements():
    """Rows of random flips, each from the first triangulation, lead to long edges, of different elements."""
    with open(os.path.join(data, "bounds", "octagon-diameter.json")) as file:
        result = json.load(file)
    first = [dart for triangle in result["net"]["triangles"] for dart in triangle[3:6]]
    choose = random.Random(1)

    def following(dart):
        return dart - 2 if dart % 3 == 2 else dart + 1

    def flip(opposite, d):
        e = opposite[d]
        c, b = following(following(d)), following(d)
        x, a = following(following(e)), following(e)
        new = {c: b, a: c, x: a, b: x}  # Where the sides of the quadrilateral go.
        across = {new[side]: new.get(opposite[side], opposite[side]) for side in new}
        for side, other in across.items():
            opposite[side], opposite[other] = other, side

    rows, size = [], 0
    while size < SIZE - 10_000:
        opposite, row = first.copy(), [0]
        while len(row) < 20:
            dart = choose.randrange(len(opposite))
            if dart // 3 != opposite[dart] // 3:
                flip(opposite, dart)
                row.append(dart)
        rows.append(row)
        size += len(json.dumps(row, separators=(",", ":"))) + 1
    result["triangulations"] = rows
    result["cells"] = [[3]] * len(result["cells"])
    return result


def bound_in_a_domain():
    with open(os.path.join(data, "bounds", "octagon-diameter-domain.json")) as file:
        return json.load(file)


@kind
def bound_of_a_domain_of_many_sides():
    """The sides of a domain again and again: the corners go around the centre many times."""
    result = bound_in_a_domain()
    rows, cells = result["symmetry"]["isometries"], result["cells"]
    times = (SIZE - 10_000) // (len(json.dumps(rows, separators=(",", ":"))) + len(json.dumps(cells)))
    result["symmetry"]["isometries"], result["cells"] = rows * times, cells * times
    return result


@kind
def bound_of_a_domain_along_a_long_path():
    """A path of hundreds of thousands of letters, on both sides of the words of each row."""
    result = bound_in_a_domain()
    result["symmetry"]["isometries"] *= 40
    result["cells"] *= 40
    result["symmetry"]["paths"] = [filled([], [0], result)]
    return result


@kind
def bound_of_many_cells():
    """A diameter with cells that are cut again and again; what bounds a cell bounds its parts."""
    with open(os.path.join(data, "bounds", "octagon-diameter.json")) as file:
        result = json.load(file)

    def cut(entry, depth):
        return [entry] if depth == 0 else [depth % 3, *cut(entry, depth - 1), *cut(entry, depth - 1)]
    cells, many = result["cells"], result["cells"]
    depth = 0
    while len(json.dumps(many, separators=(",", ":"))) < SIZE - 20_000:
        result["cells"], depth = many, depth + 1
        many = [[part for entry in row for part in ([entry] if entry < 3 else cut(entry, depth))] for row in cells]
    return result


@kind
def bound_of_many_splits():
    """A base of 90,000 splits, one side again and again, so that its triangles get ever smaller; all are bounded."""
    with open(os.path.join(data, "bounds", "octagon-diameter-base.json")) as file:
        result = json.load(file)
    splits = 90_000
    result["base"] = [1] * splits
    result["cells"] = [[3]] * (len(result["net"]["triangles"]) + 2 * splits)
    result["value"][1] = 900.0
    return result


@kind
def thick_thin_without_its_shortest_geodesic():
    """Of length 10⁻²⁵: its powers take a vertex to lifts that are all in one place."""
    result = geodesics("one-cuff-of-1e-25")
    del result["geodesics"][0]
    result["pieces"] = [{**piece, "boundaries": [[i - 1, side] for i, side in piece["boundaries"] if i > 0]}
                        for piece in result["pieces"]]
    result["clusters"] = [{"first": i, "count": 1, "equal": True} for i in range(len(result["geodesics"]))]
    return result


@kind
def spectrum_at_a_vertex_of_many_edges():
    """No closed geodesic is as short. From the only vertex 282 darts lead on, so each lift has hundreds of neighbours."""
    surface = ["named", "wiman-24"]
    result = epsnet("spectrum", "--up-to", "1", surface=surface)
    result.update(net=epsnet("eccentricity", "0", surface=surface), up_to="2")
    return result


@kind
def thick_thin_of_powers():
    """A true one of three geodesics so short that ten thousands of their powers are loops at one vertex."""
    return epsnet("thick-thin", surface=["fenchel-nielsen", "--pants-graph", "0-0 0-1 1-1", "--lengths", "1e-4,1e-4,1e-4",
                                         "--seed", "1"])


@kind
def isometries_of_one_cycle_of_corners():
    """The sides of one tile, all corners of which are one vertex: their sum is that of the whole cycle for each of them."""
    sides = 46_000
    document = {"format": "epsnet-isometries", "version": 1, "net": None, "up_to": "1", "geodesics": [], "clusters": [],
                "order": 1, "isometries": [], "paths": [[]], "pair": [[], []], "cocycle": [0] * (sides // 2)}
    document["net"] = {"format": "epsnet-net", "version": 1,
                       "surface": {"kind": "tiles", "tiles": [[["0", "0"]] * sides],
                                   "gluing": [[0, k, 0, k + sides // 2] for k in range(sides // 2)]},
                       "epsilon": "1", "charts": [], "labels": [], "vertices": [], "triangles": []}
    return document


@kind
def spectrum_up_to_a_number_of_many_digits():
    """The same geodesic 2,000 times; the number is read for each of them."""
    result = geodesics("bolza-to-6.2")
    result["up_to"] = "6.2" + "0" * 799_990 + "1"
    result["geodesics"] = result["geodesics"][:1] * 2000
    result["clusters"] = [{"first": 0, "count": 2000, "equal": False}]
    return result


@kind
def spectrum_of_a_geodesic_around_a_short_core():
    """A word of 192,000 letters around a core of length 10⁻⁸: its chords in a triangle are very many, and cross early."""
    result = geodesics("one-cuff-of-1e-8-to-6.5")
    result["up_to"] = "300"
    result["geodesics"] = [{"vertex": 20, "word": [12, 9] * 96_000 + [12], "length": [1e-3, 250], "simple": False}]
    result["clusters"] = [{"first": 0, "count": 1, "equal": False}]
    return result


@kind
def bound_of_cells_nested_deeply():
    """Cells of a triangle, each of which is cut again before any is asked."""
    with open(os.path.join(data, "bounds", "octagon-diameter-base.json")) as file:
        result = json.load(file)
    result["cells"][0] = [0] * 200_000 + [3] * 200_001
    return result


@kind
def tile_of_two_long_corners():
    """A convex tile of 2,000 corners on a circle, two of which have 90,000 digits: both are in the sign of each triple."""
    corners, count = [], 2000
    for k in range(count):
        t = Fraction(round(math.tan(math.pi * k / count - math.pi / 2 + 1e-3) * 10**12), 10**12)
        x, y = (1 - t * t) / (1 + t * t) / 2, 2 * t / (1 + t * t) / 2
        if k < 2:
            x, y = (z * (1 + Fraction(1, 10**90_000 + 1)) for z in (x, y))
        corners.append([rational(x), rational(y)])
    result = net("octagon-1-vertex")
    result["surface"] = {"kind": "tiles", "tiles": [corners],
                         "gluing": [[0, k, 0, k + count // 2] for k in range(count // 2)]}
    return result


@kind
def members_many():
    document = net("octagon-1-vertex")
    document.update((f"m{i}", 0) for i in range(80_000))
    return document


def main():
    global data, epsnet_program
    data, epsnet_program, directory, *wanted = sys.argv[1:]
    if directory == "-":
        print("\n".join(kinds))
        return
    os.makedirs(directory, exist_ok=True)
    for name in wanted or kinds:
        text = json.dumps(kinds[name](), separators=(",", ":"))
        if len(text) >= 1_000_000:
            sys.exit(f"{name} has {len(text)} bytes")
        with open(os.path.join(directory, name + ".json"), "w") as file:
            file.write(text)


main()
