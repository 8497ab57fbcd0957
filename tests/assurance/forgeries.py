#!/usr/bin/env python3
"""False files, one idea each, and the rule by which both checkers refute each of them.

forgeries.py check [--small] CERTIFY CERTIFY-EXACT [NAME...]: makes the files (all, or those named), runs both programs
    on them, and fails unless exit code, last line and rule are as listed. With --small, files of more than 100,000 bytes, which take minutes with sanitizers, are left out.
forgeries.py list: prints all files, each with its idea and the verdicts of both programs, as tables.
forgeries.py write NAME: writes the file to standard output.
forgeries.py write-all FOLDER: writes all files, each as NAME.json.

The function of a forgery makes it from a true file of tests/data/forgeries. Its docstring states the idea and, where it
is not plain, why the file is false or what it is aimed at. Disguises are true files that look unusual: they must stay
VERIFIED, so that a checker cannot pass by rejecting everything.
"""
import copy
import itertools
import json
import math
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from decimal import ROUND_FLOOR, Decimal, localcontext
from fractions import Fraction

sys.dont_write_bytecode = True  # Nothing is written beside the sources.

from field_surfaces import right_angled_octagon, written_crossing
from forgeries_plane import (ONE, ZERO, Gaussian, Isometry, Mesh, Surface, arsinh_sqrt, following, net_of_tiles,
                             orientation, point, preceding, rational, sinh2_circumradius, sinh2_half, translation_to,
                             written_point)

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)
TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SEEDS = os.path.join(TOP, "tests", "data", "forgeries")
LEFT = "UNDECIDED: document: not for this checker"
VERIFIED = "VERIFIED"
CODES = {"VERIFIED": 0, "REFUTED": 1, "UNDECIDED": 2, "MALFORMED": 3}


class Entry:
    def __init__(self, function, group, certify, exact, also, says):
        self.make, self.group, self.certify, self.also, self.says = function, group, certify, also, says
        self.exact = exact or ("MALFORMED" if certify.startswith("MALFORMED") else certify)
        self.name = function.__name__.replace("_", "-")
        self.idea = re.sub(r"\s+", " ", function.__doc__.strip())


entries = {}
group = None


def forgery(certify, exact=None, also=(), says=""):
    """certify: the beginning of the last line; exact: that of certify-exact, by default the same; also: further rules that
    are unavoidably refuted; says: a regular expression for the messages of both, where a rule has clauses."""
    def register(function):
        entry = Entry(function, group, certify, exact, set(also), says)
        assert entry.name not in entries, entry.name
        entries[entry.name] = entry
        return function
    return register


def disguise(exact=VERIFIED):
    return forgery(VERIFIED, exact)


def refuted(rule, exact=None, also=(), says=""):
    return forgery("REFUTED: " + rule, exact, also, says)


def malformed(place="", exact=None):
    """place: the place that certify names; for a text that is not JSON it depends on its library."""
    return forgery("MALFORMED" + (": " + place if place else ""), exact)


# ---- Files -------------------------------------------------------------------------------------------------------


def seed(name):
    with open(os.path.join(SEEDS, name + ".json"), encoding="utf-8") as file:
        return json.load(file)


class Raw(str):
    """A value that is written literally."""


def text(value):
    """Returns the bytes of a document; Raw values are written literally."""
    tokens = []

    def prepared(x):
        if isinstance(x, Raw):
            tokens.append(str(x))
            return f"@raw{len(tokens) - 1}@"
        if isinstance(x, dict):
            return {k: prepared(v) for k, v in x.items()}
        if isinstance(x, list) and len(x) < 100_000:
            return [prepared(v) for v in x]
        return x
    result = json.dumps(prepared(value), separators=(",", ":"))
    if tokens:
        result = re.sub(r'"@raw(\d+)@"', lambda match: tokens[int(match[1])], result)
    return result.encode()


def with_(document, **changes):
    return {**document, **changes}


def octagon():
    return seed("octagon")


def largest_radius(mesh):
    return max(sinh2_circumradius(*mesh.corners(t)) for t in range(len(mesh.vertex)))


def shortest_edge(mesh):
    return min(mesh.length(d) for d in range(len(mesh.opposite)) if mesh.start(d) != mesh.start(following(d)))


def to_60_digits(x, step=0, digits=60):
    """Returns the decimal rounded down to 60, or `digits`, digits, plus `step` units of the last one."""
    with localcontext() as context:
        context.prec = 100
        unit = Decimal(1).scaleb(-digits)
        return str(x.quantize(unit, ROUND_FLOOR) + step * unit)


def radius_of(mesh):
    return arsinh_sqrt(largest_radius(mesh))


def edge_of(mesh):
    with localcontext() as context:
        context.prec = 100
        return 2 * arsinh_sqrt(shortest_edge(mesh))


def parity(side):
    """A crossing of sides 0 and 4 of an octagon with opposite sides glued: a homomorphism to the integers."""
    return {0: 1, 4: -1}.get(side, 0)


def field(name="bolza", **changes):
    """A net on a surface over a number field, with members of the surface changed."""
    document = seed("field-" + name)
    document["surface"].update(changes)
    return document


def on_field(net):
    """A net on the regular surface of genus 2, on the same octagon over a number field."""
    return with_(net, surface=field()["surface"])


def multiple(factor, row):
    """A row of numbers of a field, all times an integer."""
    return [[str(factor * int(c)) for c in x] for x in row]


def tiled_octagon():
    """The net of the octagon cut along its own edges: triangles as tiles. Tiles and opposite darts."""
    mesh = Mesh(octagon())
    return [mesh.corners(t) for t in range(len(mesh.vertex))], mesh.opposite, mesh


def symmetric_surface(a=Fraction(5, 6), b=None):
    """The octagon with the corners a, (1 + i)b and so on, turned; its angles add up to 2π if and only if ab = 1/2."""
    b = b or 1 / (2 * a)
    corners = [(a, 0), (b, b), (0, a), (-b, b), (-a, 0), (-b, -b), (0, -a), (b, -b)]
    return {"kind": "tiles", "tiles": [[[rational(Fraction(x)), rational(Fraction(y))] for x, y in corners]],
            "gluing": [[0, k, 0, k + 4] for k in range(4)]}


def symmetric_net(**surface):
    """One vertex, the centre of the symmetric octagon, and its Delaunay triangulation."""
    return with_(seed("symmetric-octagon-centre"), surface=symmetric_surface(**surface))


RELATOR = [0, 5, 2, 7, 4, 1, 6, 3]  # Once around the corner of an octagon with opposite sides glued.


def with_word(document, change, k=0):
    """Label k + 1 with its word changed."""
    document["labels"][k][2] = change(document["labels"][k][2])
    return document


def inverse(word):
    return [(side + 4) % 8 for side in reversed(word)]


def commutator(x, y):
    return x + y + inverse(x) + inverse(y)


# ---- The text ----------------------------------------------------------------------------------------------------

group = "text"


@malformed()
def key_twice_under_an_escape():
    """`"epsilon"` and after it `"epsil\\u006fn"`, the same key with another value.

    A reader that compares keys as they are written takes one, another reader the other."""
    return text(octagon()).replace(b'"epsilon":"1"', b'"epsilon":"1","epsil\\u006fn":"0.5"')


@malformed()
def key_twice_with_the_true_value_first():
    """Two members `surface`, the one of the net and another octagon."""
    document = text(octagon())
    return document[:-1] + b',"surface":' + text(symmetric_surface()) + b"}"


@malformed()
def key_with_a_byte_zero_at_its_end():
    """A second `"epsilon\\u0000"`: a reader that stops at the byte 0 sees `epsilon` twice, or the false one."""
    return text(octagon()).replace(b'"epsilon":"1"', b'"epsilon\\u0000":"1","epsilon":"1"')


@malformed()
def key_of_another_alphabet():
    """`epsilon` with a Cyrillic е, beside the true one."""
    return text(octagon()).replace(b'"epsilon"', '"еpsilon":"1","epsilon"'.encode())


@malformed()
def key_in_capitals():
    """`"Epsilon"`."""
    return text(octagon()).replace(b'"epsilon"', b'"Epsilon"')


@malformed()
def byte_order_mark():
    """A byte order mark before the document, which the format does not allow."""
    return b"\xef\xbb\xbf" + text(octagon())


@malformed()
def utf_16():
    """The file in UTF-16."""
    return text(octagon()).decode().encode("utf-16")


@malformed()
def overlong_quote():
    """The quote that ends a text as two bytes, C0 A2, an overlong form that is no UTF-8."""
    return text(octagon()).replace(b'"kind":', b'"about":"\xc0\xa2","kind":', 1)


@malformed()
def lone_surrogate():
    """Half of a surrogate pair in the free text."""
    return text(octagon()).replace(b'"kind":', b'"about":"\\ud834 and nothing","kind":', 1)


@malformed()
def comma_at_the_end():
    """A comma after the last triangle."""
    return text(octagon())[:-2] + b",]}"


@malformed()
def comment_that_hides_epsilon():
    """A comment between two values, which some readers skip."""
    return text(octagon()).replace(b'"epsilon":"1"', b'"epsilon":/*"1"*/"1"')


@malformed()
def second_document_after_the_first():
    """A true file, and a second document after it."""
    return text(octagon()) + text(octagon())


@malformed()
def byte_zero_after_the_end():
    """A true file, a byte 0, and something else."""
    return text(octagon()) + b"\0{}"


@malformed()
def nested_a_million_times():
    """A million opening brackets: a reader that calls itself runs out of stack."""
    return text(octagon()).replace(b'"labels":[', b'"labels":[' + b"[" * 1_000_000)


@malformed()
def objects_nested_a_hundred_thousand_times():
    """`{"about":` again and again as the free text."""
    return text(octagon()).replace(b'"kind":', b'"about":' + b'{"about":' * 100_000 + b'0' +
                                   b"}" * 100_000 + b',"kind":', 1)


@malformed("surface.about")
def free_text_of_a_mebibyte_and_one_byte():
    """The free text has 2²⁰ + 1 bytes."""
    document = octagon()
    document["surface"]["about"] = "a" * (2**20 + 1)
    return document


@malformed("surface.about")
def free_text_of_a_mebibyte_in_characters():
    """The free text has 2²⁰ characters of two bytes each: the limit is one of bytes."""
    document = octagon()
    document["surface"]["about"] = "é" * 2**20
    return json.dumps(document, ensure_ascii=False).encode()


@malformed()
def file_that_stops():
    """A true file without its last byte."""
    return text(octagon())[:-1]


# ---- Numbers -----------------------------------------------------------------------------------------------------

group = "numbers"


def with_raw_coordinate(token):
    """The octagon with the x of vertex 3 written so."""
    document = octagon()
    document["vertices"][3][1] = Raw(token)
    return document


@malformed("vertices[1]")
def index_as_1e0():
    """A chart's index 1 as `1e0`."""
    document = octagon()
    document["vertices"][1][0] = Raw("1e0")
    return document


@malformed("vertices[1]")
def index_as_a_decimal():
    """A chart's index 1 as `1.0`."""
    document = octagon()
    document["vertices"][1][0] = Raw("1.0")
    return document


@malformed("vertices[0]")
def index_minus_zero():
    """A chart's index 0 as `-0`."""
    document = octagon()
    document["vertices"][0][0] = Raw("-0")
    return document


@malformed("vertices[1]")
def index_with_a_leading_zero():
    """A chart's index 1 as `01`, which is octal elsewhere."""
    document = octagon()
    document["vertices"][1][0] = Raw("01")
    return document


@malformed("vertices[1]")
def index_as_a_string():
    """A chart's index 1 as `"1"`."""
    document = octagon()
    document["vertices"][1][0] = "1"
    return document


@malformed("labels[0]")
def index_minus_one():
    """A letter −1, the last side for those who count from the end."""
    return with_word(octagon(), lambda word: [-1] + word[1:])


@malformed("version")
def version_plus_2_to_32():
    """Version 2³² + 1, which is 1 in 32 bits."""
    return with_(octagon(), version=2**32 + 1)


@malformed("charts[0]")
def tile_of_a_chart_plus_2_to_64():
    """The tile 2⁶⁴ of a chart, which is 0 in 64 bits."""
    document = octagon()
    document["charts"][0][0] = 2**64
    return document


@malformed("surface.gluing[0]")
def glued_side_plus_2_to_32():
    """A glued side 2³² + 4, which is 4 in 32 bits."""
    document = octagon()
    document["surface"]["gluing"][0][3] += 2**32
    return document


@malformed("labels[0]")
def letter_plus_2_to_32():
    """A letter of a word plus 2³²."""
    return with_word(octagon(), lambda word: [word[0] + 2**32] + word[1:])


@malformed("labels[0]")
def chart_of_a_label_plus_2_to_64():
    """The chart of a label plus 2⁶⁴."""
    document = octagon()
    document["labels"][0][1] += 2**64
    return document


@malformed("vertices[1]")
def chart_of_a_vertex_plus_2_to_32():
    """The chart of a vertex plus 2³²."""
    document = octagon()
    document["vertices"][1][0] += 2**32
    return document


@malformed("triangles[0]")
def vertex_plus_2_to_32():
    """A corner of a triangle plus 2³²."""
    document = octagon()
    document["triangles"][0][0] += 2**32
    return document


@malformed("triangles[0]")
def dart_plus_2_to_32():
    """An opposite dart plus 2³²."""
    document = octagon()
    document["triangles"][0][3] += 2**32
    return document


@malformed("triangles[0]")
def dart_plus_2_to_64():
    """An opposite dart plus 2⁶⁴."""
    document = octagon()
    document["triangles"][0][3] += 2**64
    return document


@malformed("triangles[1]")
def label_number_plus_2_to_32():
    """The label number of a triangle plus 2³²."""
    document = octagon()
    document["triangles"][1][7] += 2**32
    return document


@malformed("triangles[0]")
def dart_2_to_31():
    """An opposite dart 2³¹, negative in 32 bits."""
    document = octagon()
    document["triangles"][0][3] = 2**31
    return document


@malformed("triangles[0]")
def dart_of_32_ones():
    """An opposite dart 2³² − 1, which programs keep for "none"."""
    document = octagon()
    document["triangles"][0][3] = 2**32 - 1
    return document


@malformed("triangles[1]")
def label_number_of_32_ones():
    """The label number 2³² − 1: one more is 0, and the identity."""
    document = octagon()
    document["triangles"][1][7] = 2**32 - 1
    return document


@malformed("surface.gluing[0]")
def glued_side_of_32_ones():
    """A side glued to side 2³² − 1, which programs keep for "none"."""
    document = octagon()
    document["surface"]["gluing"][0][3] = 2**32 - 1
    return document


@malformed("surface.genus")
def genus_plus_2_to_32():
    """A regular surface of genus 2³² + 2."""
    document = seed("regular")
    document["surface"]["genus"] += 2**32
    return document


@refuted("delaunay", also=["covering", "packing"])
def coordinate_wrapped_at_2_to_64():
    """A coordinate of twenty digits that is the true one modulo 2⁶⁴.

    The fault of simdjson 3.0.1: what is written is another point."""
    document = with_(Mesh(octagon()).write(), vertices=[[v, 0.0, 0.0] for v in range(9)])
    document["vertices"][3][1] = Raw("0." + str(2**64).rjust(20, "0"))
    return document


@refuted("packing")
def coordinate_with_an_exponent_behind_60_digits():
    """A coordinate that is a tenth of the true one, with 60 digits before its exponent e-1: what is cut there is true.
    """
    x = repr(octagon()["vertices"][3][1])
    return with_raw_coordinate(x + "0" * (62 - len(x)) + "e-1")


@malformed("vertices[3]")
def coordinate_that_rounds_to_1():
    """0.99999999999999999999, whose binary64 is 1."""
    document = with_raw_coordinate("0." + "9" * 20)
    document["vertices"][3][2] = 0
    return document


@malformed("vertices[3]")
def vertex_outside_by_4e_17():
    """The vertex (0.6, 0.8): as binary64 numbers, |z|² is 1 + 4·10⁻¹⁷, and computed in binary64 it is 1."""
    document = octagon()
    document["vertices"][3][1:] = [0.6, 0.8]
    return document


@malformed("charts[1]")
def centre_on_the_circle():
    """A chart with the centre 3/5 + 4/5 i."""
    document = octagon()
    document["charts"][1][1:] = ["3/5", "4/5"]
    return document


@malformed("vertices[3]")
def coordinate_too_large_for_binary64():
    """1e309, infinity to some readers."""
    return with_raw_coordinate("1e309")


@malformed("vertices[3]")
def coordinate_of_an_exponent_that_overflows():
    """0.1 with the exponent 2⁶⁴, which is 0 in 64 bits."""
    return with_raw_coordinate("0.1e18446744073709551616")


@malformed("vertices[3]")
def coordinate_not_a_number():
    """`NaN`, of which every comparison is false."""
    return with_raw_coordinate("NaN")


@malformed("vertices[3]")
def coordinate_with_a_plus():
    """`+0.1`."""
    return with_raw_coordinate("+0.1")


@malformed("vertices[3]")
def coordinate_that_begins_with_a_point():
    """`.1`."""
    return with_raw_coordinate(".1")


@malformed("epsilon")
def epsilon_zero_with_an_exponent():
    """`0e9999`."""
    return with_(octagon(), epsilon="0e9999")


@malformed("epsilon")
def epsilon_minus_zero():
    """`-0`."""
    return with_(octagon(), epsilon="-0")


@malformed("epsilon")
def epsilon_minus_one():
    """`-1`: its square, and sinh² of it, are those of 1."""
    return with_(octagon(), epsilon="-1")


@malformed("epsilon")
def epsilon_over_zero():
    """`1/0`."""
    return with_(octagon(), epsilon="1/0")


@malformed("epsilon")
def epsilon_minus_over_minus():
    """`-1/-1`."""
    return with_(octagon(), epsilon="-1/-1")


@malformed("epsilon")
def epsilon_with_an_exponent_of_five_digits():
    """`1e00000`: at most four digits are allowed, whatever they say."""
    return with_(octagon(), epsilon="1e00000")


@malformed("epsilon")
def epsilon_of_wide_digits():
    """`１`, a digit to Unicode."""
    return with_(octagon(), epsilon="１")


@malformed("epsilon")
def epsilon_with_a_line_feed():
    """`1\\n`."""
    return with_(octagon(), epsilon="1\n")


@malformed("epsilon")
def epsilon_with_a_byte_zero():
    """`1\\u00009`: a reader that stops at the byte 0 sees 1."""
    return with_(octagon(), epsilon="1\0" + "9")


@malformed("epsilon")
def epsilon_without_quotes():
    """The number 1, not the string."""
    return with_(octagon(), epsilon=1)


@malformed("epsilon")
def epsilon_of_a_million_and_one_digits():
    """1.000… with one digit more than the format allows."""
    return with_(octagon(), epsilon="1." + "0" * 1_000_000)


@malformed("surface.tiles[0]")
def rational_of_a_million_and_one_digits():
    """A corner of the tile, exactly, not reduced, with one digit more than the format allows."""
    document = octagon()
    zeros = "0" * 499_996
    document["surface"]["tiles"][0][0] = [f"9373{zeros}/10000{zeros}", "0"]
    return document


@malformed("surface.tiles[0]")
def rational_as_a_decimal():
    """A corner's coordinate 9373/10000 as `0.9373`."""
    document = octagon()
    document["surface"]["tiles"][0][0] = ["0.9373", "0"]
    return document


# ---- Structure ---------------------------------------------------------------------------------------------------

group = "structure"


@malformed("labels[1]")
def word_of_a_million_and_one_letters():
    """A true label whose word goes to and fro until it has one letter more than the format allows."""
    return with_word(octagon(), lambda word: [3, 7] * ((1_000_001 - len(word)) // 2) + word, 1)


@malformed("labels[26]")
def words_of_ten_million_and_two_letters():
    """Eleven words, none of them too long by itself, but too long in total."""
    document = octagon()
    document["labels"] += [[0, 0, [3, 7] * 500_000]] * 10 + [[0, 0, [3, 7]]]
    return document


@malformed("labels[0]")
def word_that_is_no_path():
    """A word that crosses a side of a tile other than the one that it has reached."""
    document = seed("curve-of-1e-12")
    tiles = Surface(document["surface"])
    label = next(row for row in document["labels"] if row[2])
    tile = tiles.tile_of[label[2][0]]
    label[2][0] = next(s for s, t in enumerate(tiles.tile_of) if t != tile)
    return document


@malformed("labels[0]")
def word_that_ends_in_another_tile():
    """A path that ends in a tile other than that of the label's chart."""
    document = seed("curve-of-1e-12")
    tiles = Surface(document["surface"])
    label = next(row for row in document["labels"] if row[2])
    to = document["charts"][label[1]][0]
    side = next(s for s, t in enumerate(tiles.tile_of) if t == to and tiles.tile_of[tiles.partner[s]] != to)
    label[2].append(side)
    return document


@malformed("triangles[2]")
def identity_between_two_equal_charts():
    """Label number 0 between two charts that are equal but have different numbers."""
    document = octagon()
    document["charts"].append(list(document["charts"][2]))
    document["vertices"][8][0] = len(document["charts"]) - 1
    return document


@malformed("triangles[1]")
def label_from_another_chart():
    """A triangle whose label leads from the chart of another vertex."""
    document = octagon()
    document["triangles"][1][6] = 1
    return document


@malformed("surface.gluing[4]")
def side_glued_twice():
    """Side 4 is glued to two sides."""
    document = octagon()
    document["surface"]["gluing"].append([0, 0, 0, 4])
    return document


@malformed("surface.gluing[0]")
def side_glued_to_itself():
    """Side 0 glued to itself, folded in its midpoint: a cone point of angle π."""
    document = octagon()
    document["surface"]["gluing"][0] = [0, 0, 0, 0]
    document["surface"]["gluing"].append([0, 4, 0, 4])
    return document


@malformed("surface.gluing")
def side_not_glued():
    """Sides 3 and 7 glued to nothing: a surface with boundary."""
    document = octagon()
    del document["surface"]["gluing"][3]
    return document


@malformed("net")
def version_2():
    """A version that does not exist."""
    return with_(octagon(), version=2)


@malformed("surface")
def kind_of_both():
    """A surface of tiles that has a genus too."""
    document = octagon()
    document["surface"]["genus"] = 2
    return document


@malformed("surface.polynomial")
def field_polynomial_with_a_leading_2():
    """The polynomial is not monic: numbers of the field would not be integers, and divisors of it neither."""
    return field(polynomial=["-4", "0", "-4", "0", "2"])


@malformed("surface.polynomial")
def field_polynomial_of_degree_65():
    """x⁶⁵ − 2."""
    return field(polynomial=["-2"] + ["0"] * 64 + ["1"], root=["1", "2"])


@malformed("surface.root")
def field_interval_from_the_right_to_the_left():
    """The ends of the interval exchanged."""
    return field(root=["3", "2"])


@malformed("surface.crossings")
def field_crossing_missing():
    """Three crossings for four rows of the gluing."""
    return field(crossings=seed("field-bolza")["surface"]["crossings"][:3])


# ---- Surface -----------------------------------------------------------------------------------------------------

group = "surface"


@refuted("surface", says="2 full turns")
def cone_angle_of_4_pi():
    """The double cover of a surface, branched in two vertices, as a surface of its own, and the cover of its net.

    Sides are equal, the corners close up, the map is a map of that surface, every triangle is right; only two angles
    are 4π."""
    tiles, opposite, mesh = tiled_octagon()
    dart = next(d for d in range(len(opposite)) if mesh.start(d) != mesh.start(following(d)))
    return net_of_tiles(tiles * 2, branched(opposite, dart, 2), "1")


def branched(opposite, dart, degree):
    """The cyclic cover that is cut along one edge: branched in its ends."""
    n = len(opposite)
    shift = {dart: 1, opposite[dart]: -1}
    return [(sheet + shift.get(d, 0)) % degree * n + opposite[d] for sheet in range(degree) for d in range(n)]


@refuted("surface", says="3 full turns")
def cone_angle_of_6_pi():
    """The same with three sheets."""
    tiles, opposite, mesh = tiled_octagon()
    dart = next(d for d in range(len(opposite)) if mesh.start(d) != mesh.start(following(d)))
    return net_of_tiles(tiles * 3, branched(opposite, dart, 3), "1")


def turned_around(mesh, move, v):
    """The sheets in which one arrives after a turn around a vertex, if crossing dart d leads from sheet s to move[d][s].
    """
    sheets = range(3)
    for dart in mesh.star(v):
        sheets = [move[preceding(dart)][s] for s in sheets]
    return tuple(sheets)


def moves_around(mesh, v):
    """Permutations of three sheets for all darts, such that they are exchanged by a turn around v and around no other
    vertex, by a cycle of three."""
    darts = range(len(mesh.opposite))
    move = {}

    def set_move(dart, to):
        move[dart], move[mesh.opposite[dart]] = to, tuple(to.index(s) for s in range(3))

    # A tree of triangles, in one sheet each; of the other edges a tree of vertices.
    reached = [0]
    for t in reached:
        for dart in range(3 * t, 3 * t + 3):
            if mesh.opposite[dart] // 3 not in reached:
                reached.append(mesh.opposite[dart] // 3)
                set_move(dart, (0, 1, 2))
    vertices, tree = [v], []
    for w in vertices:
        for dart in mesh.star(w):
            if dart not in move and mesh.start(following(dart)) not in vertices:
                vertices.append(mesh.start(following(dart)))
                tree.append(dart)
    edges = set(tree) | {mesh.opposite[dart] for dart in tree}
    free = [d for d in darts if d < mesh.opposite[d] and d not in move and d not in edges]
    all_moves = list(itertools.permutations(range(3)))
    for choice in itertools.product(all_moves, repeat=len(free)):
        for dart, to in zip(free, choice):
            set_move(dart, to)
        # From the leaves on, the edge to the root is the only one at a vertex that is not known.
        for dart in reversed(tree):
            for to in all_moves:
                set_move(dart, to)
                if turned_around(mesh, move, mesh.start(following(dart))) == (0, 1, 2):
                    break
        if turned_around(mesh, move, v) in ((1, 2, 0), (2, 0, 1)):
            return move
    raise AssertionError("no such permutations")


@refuted("surface", says="3 full turns")
def cone_angle_of_6_pi_at_the_last_of_25_vertices():
    """Three sheets that are branched at one vertex alone, the last one in the order of the file, and the cover of the
    net: all other angles are 2π."""
    tiles, opposite, mesh = tiled_octagon()
    n = len(tiles)
    stars = {v: {dart // 3 for dart in mesh.star(v)} for v in range(len(mesh.points))}
    # Every other vertex has a tile that is not at this one.
    v = next(v for v in stars if all(w == v or stars[w] - stars[v] for w in stars))
    move = moves_around(mesh, v)
    order = sorted(range(3 * n), key=lambda t: t % n in stars[v])
    names = {t: k for k, t in enumerate(order)}
    across = [3 * (move[d][t // n] * n + opposite[d] // 3) + opposite[d] % 3
              for t in order for d in range(3 * (t % n), 3 * (t % n) + 3)]
    return net_of_tiles([tiles[t % n] for t in order], [3 * names[d // 3] + d % 3 for d in across], "1")


@refuted("surface", says="vertex 0 of tile 0 add up to 2 full turns")
def cone_angle_of_4_pi_in_large_steps():
    """Isosceles triangles around a point, four with the angle arg (3 + 4i) and four with π less that: the angle 4π.

    A step of the large angle leads from below the positive axis to far behind it. (The other corner does not close up.)
    """
    document = octagon()
    small = Gaussian(Fraction(3, 5), Fraction(4, 5))
    large = Gaussian(Fraction(-3, 5), Fraction(4, 5))
    half = Fraction(1, 2)
    tiles = [[Gaussian(0), Gaussian(half), Gaussian(half) * turn] for turn in [small] + [large] * 4 + [small] * 3]
    document["surface"]["tiles"] = [[[rational(z.re), rational(z.im)] for z in tile] for tile in tiles]
    legs = [[k, 2, (k + 1) % 8, 0] for k in range(8)]
    document["surface"]["gluing"] = legs + [[1, 1, 3, 1], [2, 1, 4, 1], [5, 1, 7, 1], [6, 1, 0, 1]]
    document["charts"] = [[0, "0", "0"]]
    document["vertices"], document["labels"], document["triangles"] = [[0, 0.0, 0.0]], [], []
    return document


@refuted("surface", says="do not close up")
def cone_angle_of_2_pi_and_1e_9():
    """An octagon with equal opposite sides whose angles add up to 2π + 10⁻⁹, nearly."""
    return symmetric_net(a=Fraction(5, 6), b=Fraction(3, 5) - Fraction(3, 8 * 10**10))


@refuted("surface", says="do not close up")
def cone_angle_of_2_pi_less_1e_60():
    """The same with 2π − 10⁻⁶⁰, nearly."""
    return symmetric_net(a=Fraction(5, 6), b=Fraction(3, 5) + Fraction(3, 8 * 10**61))


@refuted("surface", says="do not close up")
def equal_opposite_sides_and_angles_that_miss_2_pi():
    """An octagon with equal opposite sides, far from closing up.

    Programs that ask for no more than sides of equal length make nets of it."""
    return symmetric_net(a=Fraction(5, 6), b=Fraction(1, 2))


@refuted("surface", says="do not close up")
def corner_rounded_to_40_digits():
    """The octagon with two opposite corners rounded to 40 digits: sides are equal by symmetry, the angles miss 2π."""
    document = octagon()
    tile = document["surface"]["tiles"][0]
    for k, sign in ((3, 1), (7, -1)):
        tile[k] = [rational(Fraction(sign * round(abs(Fraction(z)) * 10**40) * (1 if Fraction(tile[3][i]) > 0 else -1),
                                     10**40)) for i, z in enumerate(tile[3])]
    return document


@refuted("surface")
def pairing_that_preserves_orientation():
    """Neighbouring sides of an octagon of equal sides are glued, aabbccdd. If a pairing could keep the direction of
    a side, the surface would not be orientable; as every pairing reverses it, the surface is a sphere with
    sharp cone points."""
    document = symmetric_net()
    document["surface"]["gluing"] = [[0, k, 0, k + 1] for k in range(0, 8, 2)]
    return document


@refuted("surface")
def pairing_of_a_torus():
    """An octagon of equal sides glued to a torus with cone points."""
    document = symmetric_net()
    document["surface"]["gluing"] = [[0, 0, 0, 2], [0, 1, 0, 3], [0, 4, 0, 5], [0, 6, 0, 7]]
    return document


@refuted("surface", says="not strictly convex")
def clockwise_tile():
    """The tile, mirrored: its interior is on the right of its sides."""
    document = symmetric_net()
    document["surface"]["tiles"][0] = [[x, "-" + y if y[0] not in "-0" else y.lstrip("-")]
                                       for x, y in document["surface"]["tiles"][0]]
    return document


@refuted("surface", says="tile 21 is not strictly convex")
def last_tile_clockwise():
    """Twenty-two tiles, of which only the last one is clockwise: two of its corners are exchanged."""
    tiles, opposite, _ = tiled_octagon()
    document = net_of_tiles(tiles, opposite, "1")
    last = document["surface"]["tiles"][-1]
    last[0], last[1] = last[1], last[0]
    return document


@refuted("surface", says="tile 21, which is not of equal length")
def last_sides_differ_by_1e_40():
    """Twenty-two tiles; a corner of the last one is moved by 10⁻⁴⁰, so that two pairs of sides are not equal."""
    tiles, opposite, _ = tiled_octagon()
    document = net_of_tiles(tiles, opposite, "1")
    corner = document["surface"]["tiles"][-1][2]
    corner[0] = rational(Fraction(corner[0]) + Fraction(1, 10**40))
    return document


def with_a_corner_on_a_side(move):
    """The octagon of one vertex with one corner more inside of side 0, moved a little away from the interior, and its
    image in side 4."""
    document = seed("octagon-of-one-vertex")
    surface = Surface(document["surface"])
    p, q = surface.ends(0)
    there = translation_to(p)
    end = there.inverse()(q)
    # Seen from p the side is straight.
    z = there(Gaussian(end.re / 3 + move * end.im, end.im / 3 - move * end.re))
    tile = document["surface"]["tiles"][0]
    other = surface.crossing(0)(z)
    document["surface"]["tiles"] = [tile[:1] + [written_point(z)] + tile[1:5] + [written_point(other)] + tile[5:]]
    document["surface"]["gluing"] = [[0, 0, 0, 6], [0, 1, 0, 5], [0, 2, 0, 7], [0, 3, 0, 8], [0, 4, 0, 9]]
    names = {0: 0, 4: 6, 1: 2, 2: 3, 3: 4, 5: 7, 6: 8, 7: 9}
    document["labels"] = [[f, t, [names[s] for s in word]] for f, t, word in document["labels"]]
    return document


@refuted("surface", says="not strictly convex")
def corner_of_angle_pi():
    """The octagon with a corner on side 0 and one on side 4, of angle π: the same surface, but no strictly convex
    tile."""
    return with_a_corner_on_a_side(Fraction(0))


@refuted("surface", says="not strictly convex")
def corner_of_more_than_pi():
    """The same with the corner on side 0 moved inward by 10⁻³⁰, the other one outward: lengths and angles are right."""
    return with_a_corner_on_a_side(Fraction(-1, 10**30))


@refuted("surface", says="not strictly convex")
def octagram():
    """The octagon of equal sides, its corners visited in threes: a left turn at every one, around three times."""
    document = symmetric_net()
    tile = document["surface"]["tiles"][0]
    document["surface"]["tiles"] = [[tile[3 * k % 8] for k in range(8)]]
    return document


@refuted("surface")
def corner_on_the_circle():
    """A corner at 3/5 + 4/5 i, at infinity."""
    document = octagon()
    document["surface"]["tiles"][0][1] = ["3/5", "4/5"]
    return document


@refuted("surface", says="connected")
def two_surfaces():
    """Two octagons, each glued to itself; the net is on the first."""
    document = octagon()
    document["surface"]["tiles"] *= 2
    document["surface"]["gluing"] += [[1, k, 1, k + 4] for k in range(4)]
    return document


@refuted("surface", says="not of equal length")
def sides_glued_to_the_wrong_ones():
    """Sides are glued as commutators, to a surface of genus 2 with one corner, but they are not of equal length."""
    document = octagon()
    document["surface"]["gluing"] = [[0, 0, 0, 2], [0, 1, 0, 3], [0, 4, 0, 6], [0, 5, 0, 7]]
    return document


@refuted("surface")
def field_crossing_with_another_sign():
    """The imaginary part of B of the crossing of side 3, of the regular octagon over a number field, with another sign:
    an isometry of the same length."""
    document = field()
    row = document["surface"]["crossings"][3]
    row[3:] = multiple(-1, row[3:])
    return document


@refuted("surface")
def field_crossing_that_takes_one_end_to_its_place():
    """The crossing of side 0 followed by a turn about the end of side 4, where the start of side 0 goes."""
    document = field("octagon")
    surface = Surface(octagon()["surface"])
    to_end = translation_to(surface.ends(4)[1])
    turn = to_end.after(Isometry(Gaussian(Fraction(3, 5), Fraction(4, 5)), ZERO, ZERO)).after(to_end.inverse())
    document["surface"]["crossings"][0] = written_crossing(turn.after(surface.crossing(0)))
    return document


@refuted("surface")
def field_crossing_inside_out():
    """A and B exchanged: it takes the disk to its outside."""
    document = field()
    row = document["surface"]["crossings"][1]
    document["surface"]["crossings"][1] = row[2:] + row[:2]
    return document


@refuted("surface")
def field_vertex_outside_of_the_light_cone():
    """A vertex with X² + Y² > T²."""
    document = field()
    document["surface"]["polygons"][0][5][2] = ["1"]
    return document


@refuted("surface")
def field_vertex_on_the_light_cone():
    """A vertex with X² + Y² = T², at infinity."""
    document = field()
    document["surface"]["polygons"][0][5] = [["0", "-3"], ["0", "-4"], ["0", "5"]]
    return document


@refuted("surface")
def field_vertex_in_the_past():
    """A vertex times −1."""
    document = field()
    tile = document["surface"]["polygons"][0]
    tile[5] = multiple(-1, tile[5])
    return document


@refuted("surface")
def field_of_another_root():
    """The octagon over ℚ(√2) written with multiples of x² − 2, where (x² − 2)(x² − 3) is 0, but the root is √3."""
    return field("reducible", root=["3/2", "2"])


@forgery("UNDECIDED: surface")
def field_interval_of_two_roots():
    """The interval contains √2 and √3, two roots of (x² − 2)(x² − 3)."""
    return field("reducible", root=["1", "2"])


@refuted("surface")
def field_interval_without_a_root():
    """The interval begins just above √2: 10⁻⁶⁰ farther."""
    with localcontext() as context:
        context.prec = 100
        low = Fraction(to_60_digits(Decimal(2).sqrt(), 1))
    return field("octagon", root=[rational(low), "2"])


@refuted("surface", says="2 full turns")
def field_cone_angle_of_4_pi():
    """The regular octagon with right angles, over ℚ(2^(1/4)): its one vertex has the angle 4π, all else is right."""
    return with_(field(), surface=right_angled_octagon())


@refuted("surface", says="connected")
def field_two_surfaces():
    """Two octagons, each glued to itself; the net is on the first."""
    document = field()
    document["surface"]["polygons"] *= 2
    document["surface"]["gluing"] += [[1, k, 1, k + 4] for k in range(4)]
    document["surface"]["crossings"] *= 2
    return document


# ---- Map ---------------------------------------------------------------------------------------------------------

group = "map"


def covered(degree, opposite, document, mesh):
    """The net whose triangles are the sheets of a cover with these darts: vertices are those of the base, repeated."""
    n = len(mesh.vertex)
    vertices, triangles, rows = [], [], document["triangles"]
    seen = [None] * (3 * n * degree)
    for first in range(len(seen)):
        if seen[first] is not None:
            continue
        base = rows[first // 3 % n][first % 3]
        vertices.append(document["vertices"][base])
        dart = first
        while seen[dart] is None:
            seen[dart] = len(vertices) - 1
            dart = opposite[preceding(dart)]
    for t in range(n * degree):
        triangles.append(seen[3 * t:3 * t + 3] + opposite[3 * t:3 * t + 3] + rows[t % n][6:])
    return with_(document, vertices=vertices, triangles=triangles)


@refuted("map", says="-4")
def double_cover():
    """The triangles of the double cover of the surface, without branch points: every vertex and triangle twice.

    Every label, triangle, edge and radius is right; only the Euler characteristic is −4."""
    mesh = Mesh(octagon())
    return covered(2, mesh.cover(2, parity), octagon(), mesh)


@refuted("map", says="-10")
def cover_of_five_sheets():
    """The same with five sheets, one after the other."""
    mesh = Mesh(octagon())
    return covered(5, mesh.cover(5, parity), octagon(), mesh)


@refuted("map", says="-6")
def double_cover_with_branch_points():
    """Two sheets that are cut along one edge and glued crosswise: both ends are branch points, where the angles of the
    triangles add up to 4π."""
    mesh = Mesh(octagon())
    return covered(2, branched(mesh.opposite, 0, 2), octagon(), mesh)


@refuted("map", says="connected")
def double_cover_and_a_sphere():
    """The double cover and, beside it, a sphere of two triangles: the Euler characteristic is −4 + 2, that of the
    surface.

    Only connectedness is broken (and the sphere's second triangle is clockwise)."""
    mesh = Mesh(octagon())
    document = covered(2, mesh.cover(2, parity), octagon(), mesh)
    row, n, v = octagon()["triangles"][0], 3 * len(document["triangles"]), len(document["vertices"])
    a, b, c = v, v + 1, v + 2
    document["vertices"] += [octagon()["vertices"][row[i]] for i in range(3)]
    # Both are frames of a, so that one pair of labels serves both.
    document["triangles"] += [[a, b, c, n + 5, n + 4, n + 3, row[6], row[7]],
                              [a, c, b, n + 2, n + 1, n, row[7], row[6]]]
    return document


@refuted("map", says="connected")
def two_copies():
    """Everything twice, side by side."""
    document = octagon()
    n, v = 3 * len(document["triangles"]), len(document["vertices"])
    document["vertices"] *= 2
    document["triangles"] += [[x + v for x in row[:3]] + [x + n for x in row[3:6]] + row[6:]
                              for row in document["triangles"]]
    return document


@refuted("map", says="= 2")
def map_of_a_sphere():
    """Two triangles, back to back."""
    document = octagon()
    row = document["triangles"][0]
    document["vertices"] = [document["vertices"][v] for v in row[:3]]
    document["triangles"] = [[0, 1, 2, 5, 4, 3, row[6], row[7]], [0, 2, 1, 2, 1, 0, row[7], row[6]]]
    return document


@refuted("map", says="= 0")
def map_of_a_torus():
    """One vertex, three edges, two triangles: every vertex, dart and label is in order, the genus is not."""
    document = seed("octagon-of-one-vertex")
    document["triangles"] = [[0, 0, 0, 3, 4, 5, 1, 2], [0, 0, 0, 0, 1, 2, 2, 1]]
    return document


@refuted("map")
def vertex_under_two_names():
    """A vertex has a second number, at the same point, in half of its triangles."""
    document = octagon()
    document["vertices"].append(document["vertices"][0])
    mesh = Mesh(octagon())
    star = mesh.star(0)
    for dart in star[:len(star) // 2]:
        document["triangles"][dart // 3][dart % 3] = len(document["vertices"]) - 1
    return document


@refuted("map", says="vertex 3.* cycle")
def two_vertices_under_one_name():
    """Two vertices of one chart get one number: it has two cycles of darts."""
    document = octagon()
    for row in document["triangles"]:
        row[:3] = [3 if v == 8 else v for v in row[:3]]
    document["vertices"].pop()
    return document


@refuted("map", says="vertex 9")
def vertex_in_no_triangle():
    """One more vertex, which is in no triangle."""
    document = octagon()
    document["vertices"].append([0, 0.3, 0.3])
    return document


@refuted("map")
def dart_opposite_to_itself():
    """A dart is its own opposite: an edge folded, or with nothing behind it."""
    document = octagon()
    row = document["triangles"][0]
    other = row[3]
    document["triangles"][other // 3][3 + other % 3] = other
    row[3] = 0
    return document


@refuted("map")
def opposite_of_another_edge():
    """A dart's opposite is one whose opposite is another dart."""
    document = octagon()
    document["triangles"][0][3] = document["triangles"][5][4]
    return document


@refuted("map")
def edges_of_other_vertices_glued():
    """Two edges exchange their opposite darts, which join other vertices."""
    document = octagon()
    o = [d for row in document["triangles"] for d in row[3:6]]
    a, b = o[0], o[7]
    for x, y in ((0, b), (b, 0), (7, a), (a, 7)):
        document["triangles"][x // 3][3 + x % 3] = y
    return document


@refuted("map", says="cycle")
def disk_cut_out_and_sewn_up():
    """Two neighbouring triangles are left out, and the hole is closed by gluing its four sides in pairs; all vertices
    are one, so that every dart fits."""
    document = seed("octagon-of-one-vertex")
    mesh = Mesh(document)
    other = mesh.opposite[0]
    hole = [following(0), preceding(0), following(other), preceding(other)]
    outer = [mesh.opposite[d] for d in hole]
    for x, y in ((0, 1), (2, 3)):
        mesh.opposite[outer[x]], mesh.opposite[outer[y]] = outer[y], outer[x]
    mesh.drop_triangles({0, other // 3})
    return mesh.write()


@refuted("map")
def no_triangle():
    """Vertices, and no triangle: nothing that could be wrong."""
    return with_(octagon(), triangles=[])


@refuted("map")
def nothing_at_all():
    """No vertex, no triangle."""
    return with_(octagon(), triangles=[], vertices=[], labels=[], charts=[])


@refuted("map")
def genus_of_another_surface():
    """A net of the regular surface of genus 2, said to be one of genus 3."""
    document = seed("regular")
    document["surface"]["genus"] = 3
    return document


# ---- Gluing ------------------------------------------------------------------------------------------------------

group = "gluing"


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_with_one_letter_replaced():
    """One letter of one word is another one."""
    return with_word(octagon(), lambda word: [(word[0] + 1) % 8] + word[1:])


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_with_one_letter_left_out():
    """One letter of one word is missing."""
    return with_word(octagon(), lambda word: word[1:])


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_conjugated():
    """A label's word, from a chart to itself, is replaced by a conjugate: trace and translation length are the same."""
    return with_word(seed("octagon-of-one-vertex"), lambda word: [1] + word + [5])


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_turned():
    """The letters of a word in cyclic order, begun elsewhere."""
    return with_word(seed("octagon-of-one-vertex"), lambda word: word[1:] + word[:1])


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_squared():
    """A label's word twice: the same axis."""
    return with_word(seed("octagon-of-one-vertex"), lambda word: word + word)


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_inverted():
    """A label's word, inverted: the same axis and length."""
    return with_word(seed("octagon-of-one-vertex"), inverse)


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_read_backwards():
    """The letters of a word in the other order: what one gets by multiplying from the wrong side."""
    return with_word(seed("octagon-of-one-vertex"), lambda word: word[::-1])


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_of_the_identity():
    """The empty word in place of a label."""
    return with_word(seed("octagon-of-one-vertex"), lambda word: [])


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def two_labels_exchanged():
    """Two words are exchanged."""
    document = seed("octagon-of-one-vertex")
    document["labels"][:2] = document["labels"][1::-1]
    return document


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_with_a_relator_less_a_letter():
    """A word and seven of the eight letters once around the corner."""
    return with_word(octagon(), lambda word: RELATOR[:7] + word)


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_with_the_letters_of_a_relator():
    """A word and the eight letters around the corner, two of them exchanged."""
    return with_word(octagon(), lambda word: RELATOR[:2] + RELATOR[3:1:-1] + RELATOR[4:] + word)


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_with_a_commutator():
    """A word and a commutator: nothing that homology sees."""
    return with_word(seed("octagon-of-one-vertex"), lambda word: commutator([0], [1]) + word)


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_with_a_commutator_of_commutators():
    """A word and [[a, b], [b, c]]: nothing that a metabelian quotient sees."""
    return with_word(seed("octagon-of-one-vertex"),
                     lambda word: commutator(commutator([0], [1]), commutator([1], [2])) + word)


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_with_a_power_of_a_thousand():
    """A word and the thousandth power of a side: far beyond the range of binary64."""
    return with_word(octagon(), lambda word: [0] * 1_000 + word)


def around_the_short_curve(letters):
    """The net with a curve of length 10⁻¹² with so many letters of that curve before a label of its tile."""
    document = seed("curve-of-1e-12")
    surface = Surface(document["surface"])
    # The cuffs inside of one pair of pants are glued side to side of one tile; the shortest of them is the curve.
    best = None
    for label in document["labels"]:
        tile = document["charts"][label[0]][0]
        for s, t in enumerate(surface.tile_of):
            if t == tile and surface.tile_of[surface.partner[s]] == t:
                g = surface.crossing(s)
                z = point(*document["charts"][label[0]][1:])
                moved = float(sinh2_half(z, g(z)))
                if best is None or moved < best[0]:
                    best = moved, label, s
    best[1][2] = [best[2]] * letters + best[1][2]
    return document


@refuted("gluing")
def label_with_a_curve_of_length_1e_12():
    """A word and once around a closed geodesic of length 10⁻¹²: the points hardly move, and every other rule holds."""
    return around_the_short_curve(1)


@refuted("gluing")
def label_with_a_thousand_times_that_curve():
    """A word and a thousand times around that geodesic, still no longer than 10⁻⁹."""
    return around_the_short_curve(1_000)


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_of_a_million_letters_of_which_one_is_wrong():
    """A word that goes to and fro, 10⁶ letters in all, one of them wrong."""
    def change(word):
        result = [3, 7] * ((1_000_000 - len(word)) // 2) + word
        result[500_000] = 2
        return result
    return with_word(symmetric_net(), change)


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def pairing_of_another_surface():
    """The net of the octagon of equal sides with opposite sides glued, its sides glued as commutators: also a surface
    of genus 2, and every word is a path."""
    document = seed("symmetric-octagon")
    document["surface"]["gluing"] = [[0, 0, 0, 2], [0, 1, 0, 3], [0, 4, 0, 6], [0, 5, 0, 7]]
    return document


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def label_of_a_regular_surface():
    """One letter of one word of a net on the regular surface is replaced by the next side, which the symmetries do
    not distinguish from it."""
    return with_word(seed("regular-of-one-vertex"), lambda word: [(word[0] + 1) % 8] + word[1:])


@refuted("gluing", also=["orientation", "delaunay", "covering", "packing"])
def field_label():
    """The same on the regular octagon over a number field."""
    return on_field(label_of_a_regular_surface())


# ---- Orientation -------------------------------------------------------------------------------------------------

group = "orientation"


@refuted("orientation", also=["delaunay"])
def mirror_image_of_the_map():
    """All triangles the other way around: a map, labels that fit, the same points and lengths."""
    document = octagon()
    flipped = []
    # The mirrored triangle has the corners 0, 2, 1: its darts are the old ones 2, 1, 0, backwards.
    for v0, v1, v2, o0, o1, o2, l1, l2 in document["triangles"]:
        flipped.append([v0, v2, v1] + [o // 3 * 3 + 2 - o % 3 for o in (o2, o1, o0)] + [l2, l1])
    return with_(document, triangles=flipped)


@refuted("orientation", also=["delaunay", "covering", "packing"])
def mirror_image_of_the_surface():
    """The net on the mirror image of its octagon: sides are numbered so that all labels fit in the group."""
    document = octagon()
    tile = document["surface"]["tiles"][0]
    document["surface"]["tiles"] = [[[x, rational(-Fraction(y))] for x, y in [tile[-k % 8] for k in range(8)]]]
    return document


@refuted("orientation", also=["delaunay", "covering", "packing"])
def mirror_image_of_the_vertices():
    """The net with all coordinates of vertices and charts conjugated."""
    document = octagon()
    document["charts"] = [[t, x, rational(-Fraction(y))] for t, x, y in document["charts"]]
    document["vertices"] = [[c, x, -y] for c, x, y in document["vertices"]]
    return document


@refuted("orientation", also=["delaunay", "covering", "packing"])
def surface_of_other_lengths():
    """The net of one octagon on another one of the same genus: sides have the same numbers, so all labels fit in the
    group."""
    document = octagon()
    document["surface"] = symmetric_surface()
    return document


@refuted("orientation", also=["delaunay", "covering", "packing"])
def labels_all_the_identity():
    """All words are empty: every equation of labels holds, the whole map is laid into one disk."""
    document = octagon()
    document["labels"] = [[f, t, []] for f, t, _ in document["labels"]]
    return document


@refuted("orientation", also=["delaunay", "covering", "packing"])
def labels_in_a_cyclic_group():
    """Every word is mapped to a power of side 0 by how often it crosses sides 0 and 4: a homomorphism, so every
    equation of labels holds; the map is laid onto an annulus."""
    document = octagon()
    document["labels"] = [[f, t, [0 if n > 0 else 4] * abs(n)]
                          for f, t, n in ((f, t, sum(map(parity, word))) for f, t, word in document["labels"])]
    return document


@refuted("orientation", also=["delaunay", "covering", "packing"])
def labels_turned_by_one_side():
    """Every letter is the next side: an automorphism of the group, as the relation is symmetric, but none of the
    surface."""
    document = octagon()
    document["labels"] = [[f, t, [(s + 1) % 8 for s in word]] for f, t, word in document["labels"]]
    return document


@refuted("orientation", also=["delaunay", "covering", "packing"])
def labels_of_a_dehn_twist():
    """Every word is changed by a Dehn twist: the relation of the group is a w a⁻¹ w′ with words w, w′ without a,
    side 0, and a becomes a w. So every equation of labels holds."""
    document = seed("octagon-of-one-vertex")
    surface = Surface(document["surface"])
    image = {**{s: [s] for s in range(8)}, 0: [0, 5, 2, 7], 4: [3, 6, 1, 4]}
    document["labels"] = [[f, t, surface.reduced(sum((image[s] for s in word), []))] for f, t, word in
                          document["labels"]]
    return document


@refuted("orientation", also=["delaunay", "covering", "packing"])
def all_vertices_in_one_point():
    """All vertices have the coordinate of the first one."""
    document = octagon()
    document["vertices"] = [[c, 0, 0] for c, _, _ in document["vertices"]]
    return document


def with_flat_triangle(beyond):
    """The octagon's net with one vertex moved onto the opposite side of one of its triangles, or beyond it."""
    mesh = Mesh(octagon())
    for dart in range(len(mesh.opposite)):
        t, v = dart // 3, mesh.start(preceding(dart))
        if dart % 3 != 1 or mesh.start(dart) == v or mesh.start(following(dart)) == v:
            continue
        # The triangle's corner 0 is v itself, in its own tile; the opposite side goes from p to q.
        p, q = mesh.corner(dart), mesh.corner(following(dart))
        there = translation_to(p)
        z, end = there.inverse()(mesh.points[v][1]), there.inverse()(q)
        share = Fraction(round(1000 * float((z * end.conjugate()).re / end.norm())), 1000)
        foot = Gaussian(end.re * share + beyond * end.im, end.im * share - beyond * end.re)
        moved = Mesh(octagon())
        moved.points[v] = (mesh.points[v][0], there(foot))
        others = [u for u in range(len(mesh.vertex)) if u != t]
        if all(orientation(*moved.corners(u)) > 0 for u in others):
            assert (orientation(*moved.corners(t)) == 0) == (beyond == 0)
            return moved.write()
    raise AssertionError


@refuted("orientation", also=["delaunay", "covering", "packing"])
def flat_triangle():
    """One vertex is moved exactly onto the opposite side of one of its triangles; all other triangles stay
    counterclockwise."""
    return with_flat_triangle(Fraction(0))


@refuted("orientation", also=["delaunay", "covering", "packing"])
def triangle_turned_over_by_1e_40():
    """The same vertex moved 10⁻⁴⁰ further, beyond that side."""
    return with_flat_triangle(Fraction(1, 10**40))


@refuted("orientation", also=["delaunay", "covering", "packing"])
def centres_of_charts_exchanged():
    """Two charts exchange their centres."""
    document = octagon()
    charts = document["charts"]
    charts[0], charts[1] = charts[1], charts[0]
    return document


# ---- Delaunay ----------------------------------------------------------------------------------------------------

group = "delaunay"


@refuted("delaunay")
def edge_flipped():
    """One edge of a net of one vertex is replaced by the other diagonal of its quadrilateral; ε is 10, more than any
    circumradius, and no edge joins different vertices."""
    for dart in range(18):
        mesh = Mesh(seed("octagon-of-one-vertex"))
        if mesh.is_flippable(dart):
            mesh.flip(dart)
            if all(sinh2_circumradius(*mesh.corners(t)) is not None for t in range(len(mesh.vertex))):
                return mesh.write("10")
    raise AssertionError


@refuted("delaunay", also=["covering"])
def edge_flipped_among_nine_vertices():
    """One edge of a net of nine vertices is replaced by the other diagonal."""
    mesh = Mesh(octagon())
    mesh.flip(next(d for d in range(len(mesh.opposite)) if mesh.is_flippable(d)))
    return mesh.write()


def tie():
    """The mesh of the square of four vertices on a circle, and the dart of its diagonal."""
    mesh = Mesh(seed("square"))
    return mesh, next(d for d in range(len(mesh.opposite)) if mesh.excess(d) == 0)


def with_tie_missed_by(distance):
    """One end of the diagonal of the square moved towards the other one, or away from it."""
    mesh, dart = tie()
    v = mesh.start(preceding(dart))
    tile, z = mesh.points[v]
    mesh.points[v] = (tile, Gaussian(z.re * (1 + distance), z.im))
    return mesh


@refuted("delaunay")
def tie_missed_by_1e_30():
    """Four vertices on a circle but for 10⁻³⁰, with the diagonal that is not Delaunay."""
    mesh = with_tie_missed_by(Fraction(1, 10**30))
    _, dart = tie()
    if mesh.excess(dart) <= 0:
        mesh = with_tie_missed_by(Fraction(-1, 10**30))
    return mesh.write()


@refuted("delaunay")
def tie_missed_by_the_least_binary64():
    """Four vertices on a circle but for 2⁻¹⁰⁷⁴, the least binary64 number, a coordinate of one of them in a chart of
    its own."""
    mesh, dart = tie()
    document = mesh.write()
    v = mesh.start(preceding(dart))
    for least in (Raw("4.9406564584124654e-324"), Raw("-4.9406564584124654e-324")):
        document["vertices"][v] = [v, least, 0]
        z = mesh.points[v][1]
        moved = translation_to(z)(Gaussian(Fraction(1 if least[0] != "-" else -1, 2**1074)))
        changed = Mesh(seed("square"))
        changed.points[v] = (changed.points[v][0], moved)
        if changed.excess(dart) > 0:
            return document
    raise AssertionError


@refuted("delaunay")
def tie_of_a_regular_surface_missed():
    """Symmetric vertices of the regular octagon, one of them moved by one unit in the last place."""
    document = seed("regular-of-one-vertex")
    document["vertices"][0][1] = 1e-16
    return document


@refuted("delaunay")
def field_tie_missed():
    """The same on the regular octagon over a number field."""
    return on_field(tie_of_a_regular_surface_missed())


@refuted("delaunay", also=["covering"])
def packing_hidden_by_a_flip():
    """Two vertices nearer than ε, not joined as their edge is flipped away: every edge is at least ε long."""
    mesh, dart = with_close_pair()
    mesh.flip(dart)
    return mesh.write()


def with_close_pair():
    """The octagon's net with a vertex more that is nearer than ε to one other vertex alone, and the edge between them,
    which can be flipped. The place was found by trying some."""
    mesh = Mesh(octagon())
    v = mesh.insert(2, Gaussian(Fraction(-824929, 10**6), Fraction(-24929, 500_000)))
    mesh.make_delaunay()
    # sinh²(ε/2) is 0.2715402….
    short = [d for d in mesh.star(v) if mesh.length(d) < Fraction(2715, 10**4)]
    assert len(short) == 1 and mesh.is_flippable(short[0])
    return mesh, short[0]


def of_2400_triangles():
    """A net of 2,400 triangles: that of the cover of the symmetric octagon with 150 sheets, a surface of genus 151."""
    mesh = Mesh(seed("symmetric-octagon"))

    def rounded(x):
        return x if abs(x) == Fraction(5, 6) else Fraction(round(x * 16), 16)
    mesh.points = [(t, Gaussian(rounded(z.re), rounded(z.im))) for t, z in mesh.points]
    mesh.make_delaunay()
    tiles = [mesh.corners(t) for t in range(len(mesh.vertex))]
    return net_of_tiles(tiles * 150, mesh.cover(150, parity), "1.1")


@refuted("delaunay", also=["covering"], says="dart 7[0-9]{3} ")
def edge_flipped_in_the_last_of_2400_triangles():
    """A net of 2,400 triangles, the wrong diagonal in two of the last."""
    mesh = Mesh(of_2400_triangles())
    mesh.flip(next(d for d in range(3 * 2_399, 0, -1) if mesh.opposite[d] // 3 > 2_300 and mesh.is_flippable(d)))
    return mesh.write()


# ---- Covering ----------------------------------------------------------------------------------------------------

group = "covering"


@refuted("covering")
def epsilon_1e_60_less_than_the_largest_radius():
    """ε is the largest circumradius, rounded down after 60 digits."""
    return with_(octagon(), epsilon=to_60_digits(radius_of(Mesh(octagon()))))


@refuted("covering")
def disk_left_uncovered():
    """A true net without one of its vertices, and the Delaunay triangulation of the others."""
    mesh = Mesh(octagon())
    mesh.remove(3)
    mesh.make_delaunay()
    return mesh.write()


@refuted("covering")
def surface_longer_by_1e_30():
    """The net of a symmetric octagon on one whose lengths differ by some 10⁻³⁰; ε lies between the two covering
    radii."""
    one, other = symmetric_net(), symmetric_net(a=Fraction(5, 6) + Fraction(1, 10**30))
    radii = sorted((radius_of(Mesh(document)), k) for k, document in enumerate((one, other)))
    with localcontext() as context:
        context.prec = 100
        epsilon = to_60_digits((radii[0][0] + radii[1][0]) / 2)
    return with_((one, other)[radii[1][1]], epsilon=epsilon)


@refuted("covering")
def vertex_moved_by_1e_50():
    """ε is more than the largest circumradius by less than 10⁻⁶⁰; a corner of that triangle is moved outward by
    10⁻⁵⁰."""
    mesh = Mesh(octagon())
    epsilon = to_60_digits(radius_of(mesh), 1)
    worst = max(range(len(mesh.vertex)), key=lambda t: sinh2_circumradius(*mesh.corners(t)))
    v = mesh.vertex[worst][0]
    tile, z = mesh.points[v]
    before = largest_radius(mesh)
    for step in (Gaussian(1), Gaussian(-1), Gaussian(0, 1), Gaussian(0, -1)):
        mesh.points[v] = (tile, z + Gaussian(step.re / 10**50, step.im / 10**50))
        if largest_radius(mesh) - before > Fraction(1, 10**51):
            return mesh.write(epsilon)
    raise AssertionError


@refuted("covering")
def epsilon_1e_minus_9999():
    """ε = 10⁻⁹⁹⁹⁹, so that no edge is too short."""
    return with_(octagon(), epsilon="1e-9999")


@refuted("covering")
def epsilon_1e_60_less_than_the_radius_of_the_regular_octagon():
    """ε is arcosh(3 + 2√2), the circumradius of the regular octagon, rounded down after 60 digits."""
    return with_(seed("regular-of-one-vertex"), epsilon=to_60_digits(regular_radius()))


@refuted("covering")
def field_epsilon_1e_60_less_than_the_radius():
    """The same for the regular octagon over a number field."""
    return on_field(epsilon_1e_60_less_than_the_radius_of_the_regular_octagon())


def regular_radius():
    with localcontext() as context:
        context.prec = 100
        cosh = 3 + 2 * Decimal(2).sqrt()
        return (cosh + (cosh * cosh - 1).sqrt()).ln()


@refuted("covering", says="triangle 2[23][0-9]{2} ")
def radius_too_large_in_the_last_of_2400_triangles():
    """A net of 2,400 triangles and a disk left uncovered in one of the last sheets: a vertex is missing there."""
    mesh = Mesh(of_2400_triangles())
    t = 2_300
    v = mesh.vertex[t][0]
    around = {mesh.start(following(d)) for d in mesh.star(v)}
    mesh.remove(v)
    around = [w - (w > v) for w in around]
    make_delaunay_around(mesh, around)
    return mesh.write()


def make_delaunay_around(mesh, vertices):
    changed = True
    while changed:
        changed = False
        for v in vertices:
            for dart in mesh.star(v):
                for edge in (dart, following(dart)):
                    if not changed and mesh.excess(edge) > 0:
                        mesh.flip(edge)
                        changed = True


# ---- Packing -----------------------------------------------------------------------------------------------------

group = "packing"


@refuted("packing")
def epsilon_1e_60_more_than_the_shortest_edge():
    """ε is the shortest edge, rounded up after 60 digits."""
    mesh = Mesh(octagon())
    return with_(octagon(), epsilon=to_60_digits(edge_of(mesh), 1))


@refuted("packing", exact="UNDECIDED: packing")
def epsilon_1e_80_more_than_edges_of_length_15():
    """ε is the shortest edge, rounded up after 80 digits. sinh²(ε/2) is more than a million, so that its bounds in 256
    bits lie on both sides of what they are compared with: one that is a unit too small for ε² calls this a net."""
    mesh = Mesh(seed("long-edges"))
    return with_(seed("long-edges"), epsilon=to_60_digits(edge_of(mesh), 1, 80))


@refuted("packing")
def vertex_and_its_twin():
    """Beside a vertex another one, 10⁻³⁰ away, and the Delaunay triangulation of all."""
    mesh = Mesh(octagon())
    t = next(t for t in range(len(mesh.vertex)))
    corners = mesh.corners(t)
    share = Fraction(1, 10**30)
    a, b, c = corners
    z = Gaussian(a.re + (b.re + c.re - 2 * a.re) * share, a.im + (b.im + c.im - 2 * a.im) * share)
    mesh.insert(t, z)
    mesh.make_delaunay()
    return mesh.write()


@refuted("packing")
def one_vertex_too_many():
    """A true net and one vertex more, nearer than ε to one other vertex alone."""
    return with_close_pair()[0].write()


@refuted("packing", says="dart 7[0-9]{3} ")
def one_vertex_too_many_in_the_last_of_2400_triangles():
    """A net of 2,400 triangles, with one vertex more in the last sheet, too near to others."""
    mesh = Mesh(of_2400_triangles())
    a, b, c = mesh.corners(2_399)
    z = Gaussian((a.re + b.re + c.re) / 3, (a.im + b.im + c.im) / 3)
    v = mesh.insert(2_399, Gaussian(Fraction(round(z.re * 64), 64), Fraction(round(z.im * 64), 64)))
    make_delaunay_around(mesh, [v])
    return mesh.write()


@refuted("packing")
def narrow_collar_as_a_net():
    """A pseudo net whose core is nearly as long as ε, without its collar: all disks are small enough, only the
    collar's two vertices are too near to each other."""
    document = seed("narrow-collar")
    del document["collars"]
    return document


@refuted("packing")
def epsilon_more_than_the_edges_of_a_regular_surface():
    """A net of the regular surface whose ε exceeds its shortest edge by less than 10⁻¹⁵."""
    return with_(seed("regular"), epsilon="1.52857091948099")


@refuted("packing")
def field_epsilon_more_than_the_edges():
    """The same on the regular octagon over a number field."""
    return on_field(epsilon_more_than_the_edges_of_a_regular_surface())


# ---- Collars -----------------------------------------------------------------------------------------------------

group = "collars"


def collars(*changes):
    """The pseudo net, its collars changed: (number, member, value)."""
    document = seed("collars")
    for k, member, value in changes:
        document["collars"][k][member] = value
    return document


@refuted("collars", says="is not the core")
def collars_that_exchange_their_cores():
    """The cores and lengths of two collars are exchanged, with ways to and fro between their tiles."""
    document = collars()
    surface = Surface(document["surface"])
    a, b = document["collars"]
    ways = []
    for c in (a, b):
        tile = document["charts"][document["vertices"][c["vertices"][0]][0]][0]
        ways.append(next([s] for s, t in enumerate(surface.tile_of)
                         if t == tile != surface.tile_of[surface.partner[s]]))
    a["core"], b["core"] = [way + c["core"] + surface.inverse_word(way) for way, c in zip(ways, (b, a))]
    a["length"], b["length"] = b["length"], a["length"]
    return document


@refuted("collars", says="than the file says")
def collars_that_exchange_their_lengths():
    """The lengths of two collars are exchanged."""
    document = collars()
    a, b = document["collars"]
    a["length"], b["length"] = b["length"], a["length"]
    return document


@refuted("collars", says="corners")
def collars_that_exchange_a_triangle():
    """The second triangles of two collars are exchanged: no two of them make an annulus."""
    document = collars()
    a, b = document["collars"]
    a["triangles"][1], b["triangles"][1] = b["triangles"][1], a["triangles"][1]
    return document


@refuted("collars", says="corners")
def collars_that_exchange_a_vertex():
    """The second vertices of two collars are exchanged."""
    document = collars()
    a, b = document["collars"]
    a["vertices"][1], b["vertices"][1] = b["vertices"][1], a["vertices"][1]
    return document


@refuted("collars", says="named twice")
def collar_twice():
    """The same collar twice."""
    document = collars()
    document["collars"].append(document["collars"][0])
    return document


@refuted("collars", says="named twice")
def collar_twice_from_its_other_side():
    """The same collar once more, seen from its other vertex."""
    document = collars()
    c = document["collars"][1]
    document["collars"].append({**c, "vertices": c["vertices"][::-1], "triangles": c["triangles"][::-1]})
    return document


@refuted("collars", says="vertex 0 is named twice")
def collars_with_a_vertex_in_common():
    """A third collar of other triangles, at a vertex of the first one."""
    document = collars()
    used = {t for c in document["collars"] for t in c["triangles"]}
    t, row = next((t, row) for t, row in enumerate(document["triangles"]) if 0 in row[:3] and t not in used)
    other = next(o // 3 for o in row[3:6] if o // 3 not in used)
    second = next(v for v in row[:3] if v not in (0, 1, 3, 4))
    document["collars"].append({**document["collars"][0], "vertices": [0, second], "triangles": [t, other]})
    return document


@refuted("collars", says="is not the core")
def core_squared():
    """The core is the square of the loop."""
    return collars((1, "core", collars()["collars"][1]["core"] * 2))


@refuted("collars", says="is not the core")
def core_conjugated():
    """The core is a conjugate of the loop: the same geodesic, another element."""
    document = collars()
    c = document["collars"][1]
    surface = Surface(document["surface"])
    tile = document["charts"][document["vertices"][c["vertices"][0]][0]][0]
    # A loop that is no power of the core: to the other tile, around a cuff there, and back.
    there = next(s for s, t in enumerate(surface.tile_of) if t == tile != surface.tile_of[surface.partner[s]])
    other = surface.tile_of[surface.partner[there]]
    cuff = next(s for s, t in enumerate(surface.tile_of) if t == other == surface.tile_of[surface.partner[s]])
    loop = [there, cuff, surface.partner[there]]
    c["core"] = loop + c["core"] + surface.inverse_word(loop)
    return document


@refuted("collars", says="is not the core")
def core_empty():
    """The core is the empty word."""
    return collars((1, "core", []))


@refuted("collars", says="more than the file says")
def length_of_the_core_too_small():
    """The core is said to be shorter than it is by one unit in the last place."""
    length = 0.25
    return collars((1, "length", [0.2, below(length)]))


def below(x):
    return math.nextafter(x, 0)


@refuted("collars", says="less than the file says")
def length_of_the_core_too_large():
    """The core is said to be longer than it is, by 10⁻¹⁵."""
    return collars((1, "length", [0.25 + 1e-15, 0.3]))


@refuted("collars")
def length_of_the_core_zero():
    """The core is said to have the length 0, a cusp."""
    return collars((1, "length", [0, 0]))


@refuted("collars", says="greater than epsilon")
def core_longer_than_epsilon():
    """ε is 0.2, less than the core of one collar, which is 0.25 long."""
    document = collars()
    return with_(document, epsilon="0.2", collars=document["collars"][::-1])


@refuted("collars", also=["covering"], says="does not cover")
def collar_wider_than_its_vertices_cover():
    """ε is 0.3: a collar's vertices are too far away to cover its part of the thick part."""
    return with_(collars(), epsilon="0.3")


@refuted("collars", also=["packing"], says="thin part")
def vertices_of_a_collar_in_the_thin_part():
    """ε is 0.3465, so that the vertices of a collar have loops that are shorter."""
    return with_(collars(), epsilon="0.3465")


@refuted("collars", says="ln sqrt")
def epsilon_more_than_the_logarithm_of_root_2():
    """ε is ln √2, rounded up after 60 digits."""
    with localcontext() as context:
        context.prec = 100
        return with_(collars(), epsilon=to_60_digits(Decimal(2).ln() / 2, 1))


@refuted("collars")
def collar_where_there_is_none():
    """Two ordinary neighbouring triangles are said to be a collar."""
    document = collars()
    t, row = next((t, row) for t, row in enumerate(document["triangles"]) if len(set(row[:3])) == 3)
    document["collars"].append({"core": [], "length": [0.1, 0.2], "vertices": row[:2], "triangles": [t, row[3] // 3]})
    document["collars"] = document["collars"][::-1]
    return document


@refuted("covering", also=["packing", "thick"])
def collar_left_out():
    """One of two collars is not listed."""
    document = collars()
    document["collars"].pop()
    return document


@refuted("covering", also=["packing"])
def collars_left_out_of_a_net():
    """A pseudo net without its member `collars`: a net, for the second checker too."""
    document = collars()
    del document["collars"]
    return document


@refuted("thick")
def vertices_in_the_thin_part():
    """A net, with the empty list of collars: vertices around a short geodesic are in the thin part."""
    return seed("net-with-short-curves")


@malformed("collars[0]")
def triangle_of_a_collar_of_32_ones():
    """A collar's triangle 2³² − 1."""
    return collars((0, "triangles", [collars()["collars"][0]["triangles"][0], 2**32 - 1]))


@malformed("collars[0].vertices")
def vertex_of_a_collar_plus_2_to_32():
    """A collar's vertex plus 2³²."""
    p, q = collars()["collars"][0]["vertices"]
    return collars((0, "vertices", [p, q + 2**32]))


@malformed("collars[0]")
def length_of_the_core_the_other_way_around():
    """The length of a core between 0.3 and 0.2."""
    return collars((0, "length", [0.3, 0.2]))


# ---- Geodesics ---------------------------------------------------------------------------------------------------

group = "geodesics"


def runs(document):
    """The clusters that the lengths make, all said to be of equal length."""
    clusters, end = [], 0
    for i, row in enumerate(document["geodesics"]):
        if row["length"][0] > end:
            clusters.append({"first": i, "count": 0, "equal": True})
        clusters[-1]["count"] += 1
        end = max(end, row["length"][1])
    return with_(document, clusters=clusters)


def spectrum():
    return seed("spectrum")


@refuted("complete")
def spectrum_without_one():
    """One geodesic in the middle of the list is left out."""
    document = spectrum()
    del document["geodesics"][len(document["geodesics"]) // 2]
    return runs(document)


@refuted("complete")
def spectrum_without_the_first():
    """The shortest geodesic is left out."""
    document = spectrum()
    del document["geodesics"][0]
    return runs(document)


@refuted("complete")
def spectrum_without_one_just_below_its_bound():
    """The longest geodesic is left out, `up_to` being more than its length by 10⁻¹⁵."""
    document = spectrum()
    last = document["geodesics"].pop()
    return runs(with_(document, up_to=repr(last["length"][1])))


@refuted("complete")
def spectrum_of_nothing():
    """No geodesic at all, up to 2.2647398959355344, more than the systole by less than 10⁻¹⁵."""
    return with_(spectrum(), geodesics=[], clusters=[],
                 up_to=repr(math.nextafter(spectrum()["geodesics"][0]["length"][1], 3)))


@refuted("complete")
def spectrum_without_one_of_twelve_equal_ones():
    """One of the twelve systoles of the Bolza surface is left out."""
    document = seed("spectrum-of-equal-lengths")
    del document["geodesics"][7]
    return runs(document)


@refuted("geodesics")
def spectrum_with_one_beyond_its_bound():
    """`up_to` is less than the longest length by 10⁻¹⁵."""
    document = spectrum()
    return with_(document, up_to=repr(document["geodesics"][-1]["length"][0] - 1e-15))


@refuted("distinct")
def spectrum_with_a_power():
    """Twice around the shortest geodesic, as one more of a list that has all."""
    document = seed("spectrum-with-a-figure-eight")
    row = copy.deepcopy(document["geodesics"][0])
    row["word"] *= 2
    row["length"] = [2 * x for x in row["length"]]
    document["geodesics"].append(row)
    document["geodesics"].sort(key=lambda row: row["length"][0])
    return runs(document)


@refuted("distinct")
def spectrum_with_a_twin():
    """The shortest geodesic again, as another loop, conjugated."""
    document = spectrum()
    rows = document["geodesics"]
    twin = copy.deepcopy(rows[0])
    twin["word"] = twin["word"][1:] + twin["word"][:1]
    rows.insert(1, twin)
    return runs(document)


@refuted("distinct")
def spectrum_with_an_inverse():
    """The shortest geodesic again, the other way around."""
    document = spectrum()
    rows = document["geodesics"]
    rows.insert(1, {**rows[0], "word": inverse(rows[0]["word"])})
    return runs(document)


@refuted("distinct")
def spectrum_with_a_twin_for_one_left_out():
    """One of twelve geodesics of equal length is replaced by another one of them, inverted and conjugated: their number
    is right."""
    document = seed("spectrum-of-equal-lengths")
    word = document["geodesics"][0]["word"]
    document["geodesics"][7] = {**document["geodesics"][0], "word": [2] + inverse(word) + [6]}
    return document


@refuted("geodesics")
def length_too_small_by_one_unit():
    """A length's upper end is the binary64 number below the lower end of the true enclosure."""
    document = spectrum()
    low = document["geodesics"][0]["length"][0]
    document["geodesics"][0]["length"] = [low - 1e-3, below(low)]
    return document


@refuted("geodesics")
def word_of_the_identity():
    """A word that goes once around the corner of the octagon, and so is no geodesic."""
    document = spectrum()
    document["geodesics"][0]["word"] = list(RELATOR)
    return document


@refuted("geodesics")
def word_of_another_geodesic():
    """The word of the second geodesic with the length of the first."""
    document = spectrum()
    rows = document["geodesics"]
    rows[0]["word"], rows[0]["vertex"] = rows[1]["word"], rows[1]["vertex"]
    return document


@refuted("simple")
def simple_geodesic_said_to_cross_itself():
    """A simple geodesic is said not to be simple."""
    document = spectrum()
    document["geodesics"][1]["simple"] = False
    return document


@refuted("simple")
def figure_eight_said_to_be_simple():
    """A geodesic that crosses itself is said to be simple."""
    document = seed("spectrum-with-a-figure-eight")
    next(row for row in document["geodesics"] if not row["simple"])["simple"] = True
    return document


@refuted("equal")
def lengths_said_to_be_equal():
    """The enclosures of two lengths are widened until they meet, and the lengths said to be equal."""
    document = spectrum()
    a, b = document["geodesics"][:2]
    a["length"][1] = b["length"][1] = max(a["length"][1], b["length"][1])
    return runs(document)


@malformed("clusters[0]")
def clusters_that_are_not_the_runs():
    """Twelve equal lengths as two clusters of six."""
    document = seed("spectrum-of-equal-lengths")
    document["clusters"] = [{"first": 0, "count": 6, "equal": True}, {"first": 6, "count": 6, "equal": True}]
    return document


@malformed("clusters[0].count")
def cluster_of_2_to_32_more():
    """A cluster of 2³² + 12 geodesics."""
    document = seed("spectrum-of-equal-lengths")
    document["clusters"][0]["count"] += 2**32
    return document


@malformed("clusters[0]")
def cluster_that_overflows():
    """Clusters of 2³² − 1 and 13 geodesics: twelve in 32 bits."""
    document = seed("spectrum-of-equal-lengths")
    document["clusters"] = [{"first": 0, "count": 2**32 - 1, "equal": True},
                            {"first": 2**32 - 1, "count": 13, "equal": True}]
    return document


@refuted("complete")
def systole_that_is_the_second():
    """The second shortest geodesic is said to be the shortest."""
    document = seed("systole")
    second = seed("spectrum")["geodesics"][1]
    return with_(document, net=seed("spectrum")["net"], geodesics=[second])


@refuted("complete")
def systole_run_through_twice():
    """The square of the systole is said to be the systole."""
    document = seed("systole")
    row = document["geodesics"][0]
    row["word"] *= 2
    row["length"] = [2 * x for x in row["length"]]
    return document


@refuted("geodesics")
def systole_too_short():
    """The systole with a length that is less by 10⁻¹⁵."""
    document = seed("systole")
    row = document["geodesics"][0]
    row["length"] = [row["length"][0] - 2e-15, row["length"][0] - 1e-15]
    return document


@malformed("geodesics[0]")
def systole_between_nearly_nothing_and_its_length():
    """The length of the systole between 10⁻³⁰⁰ and 2.3: a true enclosure that says nothing."""
    document = seed("systole")
    document["geodesics"][0]["length"] = [1e-300, 2.3]
    return document


@malformed("geodesics[0].vertex")
def vertex_of_a_geodesic_plus_2_to_32():
    """A geodesic's vertex plus 2³²."""
    document = seed("systole")
    document["geodesics"][0]["vertex"] += 2**32
    return document


def maximum(**changes):
    """Bolza's surface, twelve systoles of which six are the basis."""
    return with_(seed("maximum"), **changes)


@refuted("complete")
def maximum_without_one_of_its_systoles():
    """A local maximum by eleven of the twelve systoles of Bolza's surface."""
    document = maximum(basis=[0, 1, 2, 3, 4, 5], weights=[1] * 5)
    del document["geodesics"][7]
    return runs(document)


@refuted("complete")
def maximum_of_systoles_run_through_twice():
    """Each systole of Bolza's surface run through twice."""
    twelve = maximum()
    rows = [{**row, "word": row["word"] * 2, "length": [2 * x for x in row["length"]]}
            for row in twelve["geodesics"]]
    return with_(twelve, geodesics=rows, up_to="6.2")


@refuted("maximal")
def maximum_with_a_great_weight():
    """One systole of Bolza's surface weighs as much as a thousand others: weights of the basis would be negative."""
    document = maximum()
    document["weights"][2] *= 1000
    return document


@refuted("maximal")
def maximum_of_which_one_systole_weighs_much():
    """The same of each other one that is not in the basis, but for the least weight that is too much."""
    document = maximum()
    document["weights"] = [1, 1, 1, 1, 1, 4]
    return document


@forgery("UNDECIDED: maximal")
def maximum_at_fermats_quartic():
    """Fermat's quartic has 16 systoles, more than 6g - 6 = 12; but their gradients span 6 dimensions, and the systole
    has no local maximum there. The certificate proves nothing: matrices that are singular are not told from others."""
    document = seed("spectrum-of-fermats-quartic")
    return with_(document, claim="local-maximum", basis=list(range(12)), weights=[1] * 4)


@refuted("equal")
def maximum_of_lengths_that_are_not_equal():
    """A surface with lengths from 0.04 to 3.6: their enclosures are widened until they meet."""
    document = seed("spectrum-with-a-figure-eight")
    rows = document["geodesics"]
    greatest = max(row["length"][1] for row in rows)
    for row in rows:
        row["length"][1] = greatest
    return with_(runs(document), claim="local-maximum", basis=[0, 1, 2, 3, 4, 5], weights=[1] * (len(rows) - 6))


@refuted("simple")
def maximum_with_a_systole_that_crosses_itself():
    """A systole in the basis is said not to be simple."""
    document = maximum()
    document["geodesics"][document["basis"][0]]["simple"] = False
    return document


@refuted("distinct")
def maximum_with_a_twin():
    """A systole occurs twice in place of another one, once inverted."""
    document = maximum()
    rows = document["geodesics"]
    rows[11] = {**rows[10], "word": inverse(rows[10]["word"])}
    return document


@malformed("clusters")
def maximum_of_lengths_that_are_not_said_to_be_equal():
    """`equal` is false."""
    document = maximum()
    document["clusters"][0]["equal"] = False
    return document


@malformed("basis")
def maximum_with_five_in_its_basis():
    """Five of the six geodesics of the basis; the other one has a weight."""
    document = maximum()
    return with_(document, basis=document["basis"][:5], weights=document["weights"] + [1])


@malformed("basis[5]")
def maximum_with_one_twice_in_its_basis():
    """The last geodesic of the basis is the one before."""
    basis = maximum()["basis"]
    return maximum(basis=basis[:5] + basis[4:5])


@malformed("basis")
def maximum_with_a_basis_of_2_to_32_more():
    """An index of the basis plus 2³²."""
    basis = maximum()["basis"]
    return maximum(basis=basis[:5] + [basis[5] + 2**32])


@malformed("weights[0]")
def maximum_with_a_weight_of_0():
    """A weight of 0: its geodesic would not count."""
    return maximum(weights=[0] + maximum()["weights"][1:])


@malformed("weights")
def maximum_with_a_negative_weight():
    """A weight of -1."""
    return maximum(weights=[-1] + maximum()["weights"][1:])


@malformed("weights")
def maximum_with_a_weight_too_many():
    """A weight for the basis, too."""
    return maximum(weights=maximum()["weights"] + [1])


@malformed("geodesics file")
def spectrum_with_a_basis():
    """A spectrum with the basis of a local maximum."""
    return with_(maximum(), claim="spectrum")


@disguise()
def maximum_with_other_words():
    """Weights of a million, and each systole the other way around, conjugated."""
    document = maximum(weights=[1_000_000] * 6)
    for row in document["geodesics"]:
        row["word"] = [2] + inverse(row["word"]) + [6]
    return document


@malformed("geodesics file")
def spectrum_said_to_be_small_curves():
    """A spectrum under the claim `thick-thin`, for which it has no pieces."""
    return with_(spectrum(), claim="thick-thin")


@refuted("covering")
def geodesics_of_a_net_that_is_none():
    """The net of a list of geodesics has an ε that is too small."""
    document = spectrum()
    document["net"]["epsilon"] = "0.9"
    return document


@malformed("net")
def geodesics_of_a_pseudo_net():
    """The net of a list of geodesics has the empty list of collars, and may so leave disks uncovered."""
    document = spectrum()
    document["net"]["collars"] = []
    return document


def small_curves():
    return seed("small-curves")


@refuted("complete")
def small_curve_left_out():
    """The shortest of three small curves is left out, and the pieces are those of the other two."""
    document = small_curves()
    del document["geodesics"][0]
    document["pieces"] = [{"genus": 0, "boundaries": [[0, 0], [0, 1], [1, 0], [1, 1]]}]
    return runs(document)


@refuted("complete")
def all_small_curves_left_out():
    """No small curves are listed, and the surface is the only piece."""
    return runs(with_(small_curves(), geodesics=[], pieces=[{"genus": 2, "boundaries": []}]))


@refuted("distinct")
def small_curve_listed_twice():
    """The longest small curve once more, with an annulus between the two."""
    document = small_curves()
    document["geodesics"].append(document["geodesics"][2])
    for piece in document["pieces"]:
        piece["boundaries"] = [[3, 1] if b == [2, 1] else b for b in piece["boundaries"]]
    document["pieces"].append({"genus": 0, "boundaries": [[2, 1], [3, 0]]})
    return runs(document)


@refuted("simple")
def small_curve_said_to_cross_itself():
    """A small curve is said not to be simple."""
    document = small_curves()
    document["geodesics"][1]["simple"] = False
    return document


@refuted("equal")
def small_curves_said_to_be_of_equal_length():
    """The enclosures of two small curves are widened until they meet, and the lengths said to be equal."""
    document = small_curves()
    a, b = document["geodesics"][:2]
    a["length"][1] = b["length"][1]
    return runs(document)


@refuted("geodesics")
def small_curve_that_is_too_long():
    """Among the small curves is the next geodesic, longer than 2 arsinh 1."""
    document = small_curves()
    longer = next(row for row in seed("spectrum-with-a-figure-eight")["geodesics"] if row["length"][0] > 1.77)
    assert document["net"] == seed("spectrum-with-a-figure-eight")["net"]
    k = len(document["geodesics"])
    document["geodesics"].append(longer)
    document["pieces"][0]["boundaries"] += [[k, 0], [k, 1]]
    return runs(document)


@refuted("pieces")
def piece_of_another_genus():
    """A pair of pants is said to have genus 1."""
    document = small_curves()
    document["pieces"][0]["genus"] = 1
    return document


@refuted("pieces")
def piece_on_the_other_side():
    """The two sides of one curve are exchanged between two pieces."""
    document = small_curves()
    other = {(0, 0): [0, 1], (0, 1): [0, 0]}
    for piece in document["pieces"]:
        piece["boundaries"] = [other.get(tuple(b), b) for b in piece["boundaries"]]
    return document


@refuted("pieces")
def side_moved_to_another_piece():
    """One side of a curve bounds the other piece: an annulus and a sphere with four holes, with the same χ in all."""
    document = small_curves()
    first, second = (piece["boundaries"] for piece in document["pieces"])
    second.append(first.pop())
    return document


@refuted("pieces")
def pieces_of_a_surface_without_its_curves():
    """The shortest curve is no boundary but on one side of a torus with a hole, and on the other of a third piece."""
    document = small_curves()
    document["pieces"] = [{"genus": 1, "boundaries": [[0, 0]]}, {"genus": 0, "boundaries": [[0, 1]]},
                          {"genus": 0, "boundaries": [[1, 0], [1, 1], [2, 0], [2, 1]]}]
    return document


@refuted("pieces")
def pieces_made_one():
    """Two pairs of pants are said to be one piece."""
    document = small_curves()
    document["pieces"] = [{"genus": 0, "boundaries": sum((piece["boundaries"] for piece in document["pieces"]), [])}]
    return document


@refuted("pieces")
def piece_without_boundary():
    """A sphere without boundary beside the pieces."""
    document = small_curves()
    document["pieces"].append({"genus": 0, "boundaries": []})
    return document


@malformed("pieces[0]")
def boundary_of_a_third_side():
    """A boundary on side 2 of a curve."""
    document = small_curves()
    document["pieces"][0]["boundaries"][0][1] = 2
    return document


@malformed("pieces[1]")
def side_of_a_curve_in_two_pieces():
    """A side of a curve bounds both pairs of pants."""
    document = small_curves()
    first, second = (piece["boundaries"] for piece in document["pieces"])
    second.append(first[0])
    return document


@malformed("pieces")
def side_of_a_curve_in_no_piece():
    """A side of a curve bounds no piece, and that piece has another genus."""
    document = small_curves()
    document["pieces"][0]["boundaries"].pop()
    document["pieces"][0]["genus"] = 1
    return document


# ---- Eigenvalues -------------------------------------------------------------------------------------------------

group = "eigenvalues"


def eigenvalues(name="octagon-5"):
    with open(os.path.join(TOP, "tests", "data", "eigenvalues", name + ".json"), encoding="utf-8") as file:
        return json.load(file)


def eigenvalues_with(changes, name="octagon-5", **members):
    """`changes` are (list, index, members); the file of an octagon has λ_1, then two eigenvalues, then two."""
    document = {**eigenvalues(name), **members}
    for key, i, row in changes:
        document[key][i].update(row)
    return document


NOT_MOST = "UNDECIDED: most"
NOT_LEAST = "UNDECIDED: least"
UNPROVED = "UNDECIDED: eigenfunctions"


@forgery(NOT_MOST)
def eigenvalues_one_less_below():
    """There are four eigenvalues below the third interval instead of five: of λ_5 nothing is said, and `next` is where λ_6 is."""
    document = eigenvalues_with([("at_most", 3, {"count": 4})])
    document["eigenvalues"][2] = {**document["eigenvalues"][2], "count": 1}
    return document


@forgery(NOT_MOST)
def eigenvalues_none_where_one_is():
    """No eigenvalue is less than 3.4, where λ_1 is, and that is all that is claimed."""
    document = eigenvalues_with([("at_most", 1, {"count": 0})], eigenvalues=[], at_least=[], vertex_order=[])
    document["next"] = document["at_most"][1]["below"]
    return document


@forgery(NOT_MOST)
def eigenvalues_counted_below_sigma():
    """A count below sigma is said to be one below sigma itself, not below sigma/(1 + H sigma); the interval moves along."""
    document = eigenvalues()
    low = document["at_most"][0]["sigma"]
    return eigenvalues_with([("at_most", 0, {"below": low}), ("eigenvalues", 0, {"in": [low, 2.86]})])


@forgery(NOT_MOST)
def eigenvalues_counted_a_bit_further():
    """`below` is 10⁻⁹ beyond sigma/(1 + H sigma), as is the end of the interval."""
    document = eigenvalues()
    low = document["at_most"][0]["below"] * (1 + 1e-9)
    return eigenvalues_with([("at_most", 0, {"below": low}),
                             ("eigenvalues", 0, {"in": [low, document["eigenvalues"][0]["in"][1]]})])


@forgery(NOT_MOST)
def eigenvalues_with_sigma_beyond_the_next_one():
    """sigma is a hundredth greater: the matrix has one negative eigenvalue more."""
    return eigenvalues_with([("at_most", 0, {"sigma": eigenvalues()["at_most"][0]["sigma"] * 1.01})])


@forgery(NOT_MOST)
def eigenvalues_with_an_enormous_sigma():
    """sigma is 10³⁰⁸, where numbers are too large to be factored."""
    return eigenvalues_with([("at_most", 0, {"sigma": 1e308})])


@forgery(NOT_MOST)
def eigenvalues_of_another_octagon():
    """The counts of one octagon for the net of another one, of as many triangles: it has λ_1 elsewhere."""
    document = eigenvalues("octagon-5-of-one-vertex")
    return with_(document, net=seed("octagon-of-one-vertex"))


@forgery(NOT_MOST)
def eigenvalues_of_the_bolza_surface_moved():
    """All numbers of the Bolza surface are a thirtieth greater."""
    document = eigenvalues("bolza")
    by = 31 / 30
    for row in document["at_most"]:
        row.update(below=row["below"] * by, sigma=row["sigma"] * by)
    for row in document["at_least"]:
        row["below"] *= by
    for row in document["eigenvalues"]:
        row["in"] = [x * by for x in row["in"]]
    document["next"] *= by
    return document


@forgery(NOT_LEAST)
def eigenvalues_one_more_below():
    """The Bolza surface has four eigenvalues in the first interval, and three in the second one."""
    document = eigenvalues("bolza")
    document["at_least"][0]["count"] = 4
    document["at_most"][1]["count"] = 4
    document["eigenvalues"][0]["count"] = 4
    document["eigenvalues"][1]["count"] = 3
    return document


@forgery(NOT_LEAST)
def eigenvalues_in_a_narrower_interval():
    """λ_1 is said to be less than a number a tenth of a percent smaller than what the matrix proves."""
    document = eigenvalues()
    high = document["at_least"][0]["below"] * 0.999
    return eigenvalues_with([("at_least", 0, {"below": high}),
                             ("eigenvalues", 0, {"in": [document["eigenvalues"][0]["in"][0], high]})])


@forgery(NOT_LEAST)
def eigenvalue_0_counted():
    """An eigenvalue is less than 1/4: the constants, which are not one of those counted."""
    return eigenvalues_with([("at_least", 0, {"below": 0.25})], eigenvalues=[{"in": [0, 0.25], "count": 1}], next=0,
                            at_most=[], side_order=[])


@forgery(NOT_LEAST)
def eigenvalues_below_a_denormal():
    """An eigenvalue is less than 2⁻¹⁰⁷⁴."""
    return eigenvalues_with([("at_least", 0, {"below": 5e-324})], eigenvalues=[{"in": [0, 5e-324], "count": 1}], next=0,
                            at_most=[], side_order=[])


# Sections of flat line bundles: the octagon with a third of a turn across side 0, five eigenvalues in three intervals.

SECTIONS = "octagon-sections-of-a-third"


def sections_with(phases, **members):
    return {**eigenvalues(SECTIONS), "phases": phases, **members}


def bundle_of_klein(phases):
    """Nothing is counted: only that the phases of 24 heptagons are those of a line bundle."""
    with open(os.path.join(TOP, "tests", "data", "certify", "verified", "map-klein.json"), encoding="utf-8") as file:
        net = json.load(file)
    document = with_(eigenvalues(), net=net, eigenvalues=[], next=0, halvings=0, side_order=[], vertex_order=[],
                     at_most=[], at_least=[], eigenfunctions=[])
    return {**document, "phases": phases(net["surface"]["gluing"])}


@disguise()
def sections_with_phases_written_otherwise():
    """The same phases: one less than 0 is one more, and a third has a denominator of eighteen digits."""
    return sections_with(["100000000000000000/300000000000000000", "-0", "0.000", "-0/7", "2/3", "0", "0", "0"])


@disguise()
def sections_of_the_conjugate_line_bundle():
    """All phases have the other sign: the same eigenvalues, of conjugate sections."""
    return sections_with(["-1/3", "0", "0", "0", "1/3", "0", "0", "0"])


@refuted("phases")
def sections_conjugate_on_one_side():
    """A third of a turn across a side, and a third, not minus a third, on the way back."""
    return sections_with(["1/3", "0", "0", "0", "1/3", "0", "0", "0"])


@refuted("phases")
def sections_with_a_phase_on_one_side_only():
    """A phase across a side, and none on the way back."""
    return sections_with(["1/3"] + ["0"] * 7)


@refuted("phases")
def sections_with_phases_that_nearly_fit():
    """The phases of two sides add up to 10⁻¹⁸."""
    return sections_with(["0.333333333333333333", "0", "0", "0", "-0.333333333333333332", "0", "0", "0"])


@refuted("phases")
def sections_with_phases_around_a_vertex():
    """Sides fit in pairs, but a way around a vertex of Klein's map turns sections by a third."""
    def phases(gluing):
        t, k, other_t, other_k = gluing[0]
        result = ["0"] * 168
        result[7 * t + k], result[7 * other_t + other_k] = "1/3", "-1/3"
        return result
    return bundle_of_klein(phases)


@disguise()
def sections_with_phases_of_tiles():
    """Phases across all sides of one heptagon of Klein's map: sections times a unit in this tile."""
    def phases(gluing):
        result = ["0"] * 168
        for t, k, other_t, other_k in gluing:
            if (t == 3) != (other_t == 3):
                result[7 * t + k] = "0.2" if other_t == 3 else "-0.2"
                result[7 * other_t + other_k] = "0.2" if t == 3 else "-0.2"
        return result
    return bundle_of_klein(phases)


def in_a_box(change, name="octagon-sections-in-a-box"):
    document = eigenvalues(name)
    change(document)
    return document


@disguise()
def box_with_heights_from_elsewhere():
    """All heights of a direction are a quarter more."""
    def change(document):
        direction = document["box"]["directions"][2]
        direction["heights"] = [height + 0.25 for height in direction["heights"]]
    return in_a_box(change)


@refuted("enclosures")
def box_of_half_a_turn():
    """The radius is fifty times as large; the intervals are those of a hundredth of a turn."""
    return in_a_box(lambda document: document["box"].update(radius="1/2"))


@refuted("enclosures")
def box_with_the_intervals_of_its_centre():
    """The intervals are those of the counts, for one character."""
    def change(document):
        for row, least, most in zip(document["eigenvalues"], document["at_least"], document["at_most"]):
            row["in"] = [most["below"], least["below"]]
    return in_a_box(change)


@refuted("enclosures")
def box_without_heights():
    """All heights are 0: all of a step is made in the triangles at a side."""
    def change(document):
        for direction in document["box"]["directions"]:
            direction["heights"] = [0] * len(direction["heights"])
    return in_a_box(change)


@refuted("box")
def box_with_a_step_on_one_side_only():
    """A step across a side, and none on the way back, so that all heights may be 0."""
    def change(document):
        direction = document["box"]["directions"][0]
        direction["steps"] = [1] + [0] * 7
    return in_a_box(change)


@malformed()
def box_of_no_phases():
    """A box of functions."""
    return in_a_box(lambda document: document.pop("phases"))


@malformed()
def box_of_a_radius_less_than_0():
    """All numbers t with |t| at most −1/100: none."""
    return in_a_box(lambda document: document["box"].update(radius="-1/100"))


@malformed()
def box_with_a_direction_too_many():
    """Five directions on a surface of genus 2."""
    return in_a_box(lambda document: document["box"]["directions"].append(document["box"]["directions"][0]))


@forgery(NOT_MOST)
def sections_of_a_line_bundle_turned_elsewhere():
    """A third of a turn across side 1 instead of side 0: the eigenvalues are others."""
    return sections_with(["0", "1/3", "0", "0", "0", "-1/3", "0", "0"])


@forgery(NOT_MOST)
def sections_of_a_half_for_those_of_a_third():
    """The counts of a third of a turn for half a turn, which has λ_1 further down."""
    return sections_with(eigenvalues("octagon-sections-of-a-half")["phases"])


@forgery(NOT_MOST)
def sections_without_any_turn():
    """All phases are 0: the constants are sections, and 0 is an eigenvalue less than all that are said to be the first ones."""
    return sections_with(["0"] * 8)


@forgery(NOT_LEAST)
def sections_that_are_functions():
    """The counts of sections, said of functions: there is no phase in the file."""
    document = eigenvalues(SECTIONS)
    del document["phases"]
    return document


@forgery(NOT_LEAST)
def sections_with_an_empty_list_of_phases():
    """No phases in the list: functions again."""
    return sections_with([])


@forgery(NOT_MOST)
def sections_one_less_below():
    """There are two sections below the next eigenvalues, and it is said that there is one."""
    document = eigenvalues(SECTIONS)
    document["at_most"][2]["count"] = 1
    return document


@forgery(NOT_LEAST)
def sections_one_more_below():
    """As if the constants were counted, there are two eigenvalues in the first interval."""
    document = eigenvalues(SECTIONS)
    document["at_least"][0]["count"] = 2
    document["at_most"][1]["count"] = 2
    document["eigenvalues"] = [{**document["eigenvalues"][0], "count": 2}, document["eigenvalues"][2]]
    return document


@refuted("enclosures")
def sections_from_the_second_one_on():
    """λ_0 is left out, as it is for functions."""
    document = eigenvalues(SECTIONS)
    del document["eigenvalues"][0]
    return document


@malformed("phases")
def sections_without_a_phase_of_the_last_side():
    """Seven phases for eight sides."""
    return sections_with(["1/3", "0", "0", "0", "-1/3", "0", "0"])


@malformed("phases[0]")
def sections_with_a_whole_turn():
    """A phase is 1, which is 0 modulo 1, but not less than 1."""
    return sections_with(["1", "0", "0", "0", "0", "0", "0", "0"])


@malformed("phases[0]")
def sections_with_an_exponent_in_a_phase():
    """A phase is 5e-1, with an exponent."""
    return sections_with(["5e-1", "0", "0", "0", "0.5", "0", "0", "0"])


@malformed("phases[1]")
def sections_with_a_common_denominator_of_19_digits():
    """Denominators of ten digits each, without a common factor."""
    return sections_with(["1/1000000007", "1/1000000009", "0", "0", "-1/1000000007", "-1/1000000009", "0", "0"])


@malformed()
def sections_with_numbers_for_phases():
    """A phase is a number instead of a string."""
    return sections_with([0.5, "0", "0", "0", "0.5", "0", "0", "0"])


@malformed("eigenfunctions")
def sections_with_a_real_function():
    """The phases are 0, and a function proves an eigenvalue."""
    return {**eigenvalues("octagon-5-with-a-function"), "phases": ["0"] * 8}


@refuted("enclosures")
def interval_later_by_a_unit():
    """An interval begins one unit in the last place later."""
    low, high = eigenvalues()["eigenvalues"][1]["in"]
    return eigenvalues_with([("eigenvalues", 1, {"in": [math.nextafter(low, 9), high]})])


@refuted("enclosures")
def interval_shorter_by_a_unit():
    """An interval ends one unit in the last place earlier."""
    low, high = eigenvalues()["eigenvalues"][2]["in"]
    return eigenvalues_with([("eigenvalues", 2, {"in": [low, math.nextafter(high, 0)]})])


@refuted("enclosures")
def interval_left_out():
    """The second interval is missing: the third one is said to have λ_2."""
    document = eigenvalues()
    del document["eigenvalues"][1]
    return document


@refuted("enclosures")
def interval_twice():
    """The first interval is there twice: λ_2 is said to be where λ_1 is."""
    document = eigenvalues()
    document["eigenvalues"].insert(1, document["eigenvalues"][0])
    return document


@refuted("enclosures")
def intervals_in_another_order():
    """The last interval comes first."""
    return with_(eigenvalues(), eigenvalues=eigenvalues()["eigenvalues"][::-1])


@refuted("enclosures")
def interval_with_another_number():
    """An interval has three eigenvalues, the next one has one: in all there are as many."""
    return eigenvalues_with([("eigenvalues", 1, {"count": 3}), ("eigenvalues", 2, {"count": 1})])


@refuted("enclosures")
def next_by_a_unit_more():
    """All others are said to be one unit in the last place greater."""
    return with_(eigenvalues(), next=math.nextafter(eigenvalues()["next"], 9))


@refuted("enclosures")
def next_without_a_count():
    """The count that says where λ_6 is is missing."""
    document = eigenvalues()
    document["at_most"].pop()
    return document


@refuted("enclosures")
def interval_without_a_count():
    """No count says that λ_1 is not greater."""
    document = eigenvalues()
    del document["at_least"][0]
    return document


@refuted("enclosures")
def eigenvalues_without_any_counts():
    """Nothing is proved of what is claimed."""
    return with_(eigenvalues(), at_most=[], at_least=[], side_order=[], vertex_order=[])


@refuted("enclosures")
def count_of_2_to_32_less_1():
    """A count of 2³² − 1, which would be −1 in 32 bits with a sign."""
    return eigenvalues_with([("at_most", 0, {"count": 2**32 - 1})])


def one_function(**changes):
    """The file of an octagon with λ_1 = 2.77507… in the interval of its function, the row of which is changed."""
    document = eigenvalues("octagon-5-with-a-function")
    document["eigenfunctions"][0].update(changes)
    document["eigenvalues"][0]["in"] = document["eigenfunctions"][0]["in"]
    return document


def functions_of(document):
    return document["eigenfunctions"][0]["functions"]


@forgery(UNPROVED)
def eigenfunction_enclosed_in_less():
    """The interval of a function is a hundredth as wide as what it proves."""
    return one_function(**{"in": [2.77505, 2.77508]})


@forgery(UNPROVED)
def eigenfunction_of_another_eigenvalue():
    """λ and the interval are 0.05 greater, the function is the same."""
    return one_function(**{"lambda": 2.825, "in": [2.805, 2.845]})


@forgery(UNPROVED)
def eigenfunction_after_one_of_another_eigenvalue():
    """A second row has the function of λ_1 for an eigenvalue in [3.2, 3.3], where none is, and λ_2 is said to be there."""
    document = one_function()
    row = document["eigenfunctions"][0]
    document["eigenfunctions"].append({**row, "lambda": 3.25, "in": [3.2, 3.3]})
    document["eigenvalues"].append({"in": [3.2, 3.3], "count": 1})
    return document


@forgery(UNPROVED)
def eigenfunction_of_squares_beyond_binary64():
    """It is 2^700 around one vertex and 2^540 elsewhere; no eigenvalue is in [0.49, 0.51], where one is said to be.

    Vertices are numbered such that, if all squares of bounds are infinite, a sort leaves those far from the vertex first.
    """
    document = eigenvalues("octagon-5")
    net = document["net"]
    vertex = 31
    near = [2, 4, 7, 22, 26, vertex, 32]
    order = [*near, 19, 20, 21, 23, 24, 25, 27, 28, 29, 30, 12, 1, 3, 5, 6, 8, 9, 10, 11, 0, 13, 14, 15, 16, 17, 18, 33]
    net["vertices"] = [net["vertices"][v] for v in order]
    for triangle in net["triangles"]:
        triangle[:3] = [order.index(v) for v in triangle[:3]]
    function = []
    for v in order:
        function += [2.0 ** (700 if v == vertex else 540)] + 24 * [0]
    document["eigenvalues"] = [{"in": [0.49, 0.51], "count": 1}]
    document["next"] = document["at_most"][0]["below"]
    document["at_most"] = document["at_most"][:1]
    document["at_least"] = document["vertex_order"] = []
    document["eigenfunctions"] = [{"in": [0.49, 0.51], "lambda": 0.5, "radius": 0.55, "functions": [function]}]
    return document


@forgery(UNPROVED)
def eigenfunction_that_is_constant():
    """The function 1 around each vertex."""
    document = one_function()
    each = len(functions_of(document)[0]) // 9
    return one_function(functions=[([1] + [0] * (each - 1)) * 9])


@forgery(UNPROVED)
def eigenfunction_of_one_vertex():
    """The function is 0 around all vertices but one."""
    (function,) = functions_of(one_function())
    each = len(function) // 9
    return one_function(functions=[function[:each] + [0] * (8 * each)])


@forgery(UNPROVED)
def eigenfunction_with_vertices_exchanged():
    """The coefficients of the first two vertices are exchanged."""
    (function,) = functions_of(one_function())
    each = len(function) // 9
    return one_function(functions=[function[each:2 * each] + function[:each] + function[2 * each:]])


@forgery(UNPROVED)
def eigenfunction_turned():
    """Around one vertex the function is turned by 1/100."""
    (function,) = functions_of(one_function())
    for m in range(1, len(function) // 9 // 2 + 1):
        c, s = math.cos(m / 100), math.sin(m / 100)
        a, b = function[2 * m - 1:2 * m + 1]
        function[2 * m - 1:2 * m + 1] = [c * a - s * b, s * a + c * b]
    return one_function(functions=[function])


@forgery(UNPROVED)
def eigenfunction_mirrored():
    """All β are their negatives."""
    (function,) = functions_of(one_function())
    each = len(function) // 9
    return one_function(functions=[[-c if i % each % 2 == 0 and i % each else c for i, c in enumerate(function)]])


@forgery(UNPROVED)
def eigenfunction_with_a_changed_coefficient():
    """One coefficient is a thousandth greater."""
    (function,) = functions_of(one_function())
    function[0] *= 1.001
    return one_function(functions=[function], **{"in": [2.766, 2.784]})


@forgery(UNPROVED)
def eigenfunction_twice():
    """One function, twice in a row: two eigenvalues are said to be in the interval."""
    document = one_function()
    document["eigenvalues"][0]["count"] = 2
    document["at_most"][0]["count"] = 2
    document["eigenfunctions"][0]["functions"] *= 2
    return document


@forgery(UNPROVED)
def eigenfunction_and_a_multiple():
    """One function, and −2 times that."""
    document = one_function()
    document["eigenvalues"][0]["count"] = 2
    document["at_most"][0]["count"] = 2
    (function,) = functions_of(document)
    document["eigenfunctions"][0]["functions"] = [function, [-2 * c for c in function]]
    return document


@forgery(UNPROVED)
def eigenfunctions_of_which_one_is_a_sum():
    """Of three functions of the Bolza surface one is the sum of the others."""
    document = eigenvalues("bolza-with-three-functions")
    first, second, _ = functions_of(document)
    functions_of(document)[2] = [x + y for x, y in zip(first, second)]
    return document


@forgery(UNPROVED)
def eigenfunctions_four_where_three_are():
    """The Bolza surface has a fourth function, a sum with a small rest."""
    document = eigenvalues("bolza-with-three-functions")
    first, second, third = functions_of(document)
    functions_of(document).append([x - y + z * 1.001 for x, y, z in zip(first, second, third)])
    document["at_most"][0]["count"] = document["eigenvalues"][0]["count"] = 4
    return document


@refuted("enclosures")
def eigenvalues_one_more_than_functions():
    """Four eigenvalues of the Bolza surface are claimed, and three have functions."""
    document = eigenvalues("bolza-with-three-functions")
    document["at_most"][0]["count"] = document["eigenvalues"][0]["count"] = 4
    return document


@refuted("enclosures")
def eigenfunction_left_out():
    """The function is missing, and the interval is as narrow as with it."""
    return with_(one_function(), eigenfunctions=[])


@refuted("enclosures")
def eigenvalue_enclosed_in_a_unit_less():
    """The interval that is claimed ends a unit before that of its function."""
    document = one_function()
    document["eigenvalues"][0]["in"] = [2.755, math.nextafter(2.795, 0)]
    return document


@refuted("enclosures")
def eigenfunction_that_ends_where_the_count_does():
    """The end of the function's interval is the number below which one eigenvalue is: that may be another one."""
    document = one_function()
    below = document["at_most"][0]["below"]
    document = one_function(**{"in": [2.755, below]})
    document["eigenvalues"][0]["in"] = [2.755, below]
    return document


@malformed("side_order[6]")
def order_with_a_repetition():
    """A side is eliminated twice, and another one never."""
    document = eigenvalues()
    document["side_order"][5] = document["side_order"][6]
    return document


@malformed("vertex_order")
def order_of_too_few():
    """A vertex is left out."""
    document = eigenvalues()
    document["vertex_order"].remove(max(document["vertex_order"]))
    return document


@malformed("side_order")
def order_of_one_halving_more():
    """The triangles are said to be halved twice, the order is of one time."""
    return with_(eigenvalues(), halvings=2)


@malformed("halvings")
def halvings_13():
    """More halvings than the format knows."""
    return with_(eigenvalues(), halvings=13)


@malformed("side_order")
def order_without_counts():
    """An order of sides, and no counts for it."""
    return with_(eigenvalues(), at_most=[])


@malformed("at_most[0]")
def below_beyond_sigma():
    """`below` is greater than sigma by a unit."""
    return eigenvalues_with([("at_most", 0, {"below": math.nextafter(eigenvalues()["at_most"][0]["sigma"], 9)})])


@malformed("at_least[0]")
def at_least_0():
    """At least 0 eigenvalues are less than the number."""
    return eigenvalues_with([("at_least", 0, {"count": 0})])


@malformed("eigenvalues[1]")
def interval_of_0_eigenvalues():
    """An interval with no eigenvalue."""
    return eigenvalues_with([("eigenvalues", 1, {"count": 0})])


@malformed("eigenvalues[1]")
def interval_the_other_way():
    """The ends of an interval are exchanged."""
    return eigenvalues_with([("eigenvalues", 1, {"in": eigenvalues()["eigenvalues"][1]["in"][::-1]})])


@malformed("next")
def next_that_is_negative():
    """All others are at least −1."""
    return with_(eigenvalues(), next=-1)


@malformed("at_most[0].count")
def count_plus_2_to_32():
    """A count of 2³²."""
    return eigenvalues_with([("at_most", 0, {"count": 2**32})])


@malformed("eigenfunctions[0]")
def eigenfunction_on_disks_that_do_not_cover():
    """The radius is less than ε."""
    return one_function(radius=0.875)


@malformed("eigenfunctions[0]")
def eigenfunction_that_is_zero():
    """The function 0, of which nothing follows."""
    return one_function(functions=[[0] * len(functions_of(one_function())[0])])


@malformed("eigenfunctions[0]")
def eigenfunction_of_the_eigenvalue_0():
    """The function 1 is an eigenfunction indeed, of the eigenvalue 0, which is none of those counted."""
    each = len(functions_of(one_function())[0]) // 9
    return one_function(functions=[([1] + [0] * (each - 1)) * 9], **{"lambda": 0, "in": [0, 2.7]})


@malformed("eigenfunctions[0]")
def eigenfunctions_of_different_orders():
    """A second function of a row has fewer coefficients."""
    document = one_function()
    functions_of(document).append([1] * 27)
    return document


@malformed("eigenfunctions[1]")
def eigenfunctions_with_a_common_point():
    """Two rows whose intervals have a point in common, where both may mean one eigenvalue."""
    document = one_function()
    row = document["eigenfunctions"][0]
    document["eigenfunctions"].append({**row, "in": [row["in"][1], 3], "lambda": 2.9})
    return document


# ---- Isometries --------------------------------------------------------------------------------------------------

group = "isometries"


def isometries(name="octagon-5", **changes):
    """The octagon, with the hyperelliptic involution and nothing else; or the Bolza surface, with 96."""
    with open(os.path.join(TOP, "tests", "data", "isometries", name + ".json"), encoding="utf-8") as file:
        return {**json.load(file), **changes}


def with_image(document, k, word):
    """The image of element k under the first isometry replaced."""
    document["isometries"][0]["images"][k] = word
    return document


@refuted("complete")
def isometries_without_a_geodesic():
    """One closed geodesic is left out; what is seen from the others would be as before."""
    document = isometries()
    del document["geodesics"][-1]
    return runs(document)


@refuted("geodesics")
def isometries_of_another_surface():
    """The net is that of another octagon, which has an involution with the same images."""
    return isometries(net=octagon())


@refuted("isometries")
def isometry_with_an_image_inverted():
    """One generator goes to the inverse of its image, which has the same trace."""
    document = isometries()
    image = document["isometries"][0]["images"][3]
    return with_image(document, 3, [(s + 4) % 8 for s in reversed(image)])


@refuted("isometries")
def isometry_with_an_image_conjugated():
    """One generator goes to a conjugate of its image, which has the same trace; its products have others."""
    document = isometries()
    loop, image = document["isometries"][0]["images"][4:6]
    return with_image(document, 5, loop + image + [(s + 4) % 8 for s in reversed(loop)])


@refuted("isometries")
def isometry_with_another_orientation():
    """The involution is said to reverse the orientation."""
    document = isometries()
    document["isometries"][0]["preserves_orientation"] = False
    return document


@refuted("isometries")
def pair_with_one_axis():
    """The two elements of the pair are the same, so that they say nothing of orientations."""
    document = isometries()
    document["pair"][1] = document["pair"][0]
    for row in document["isometries"]:
        row["images"][1] = row["images"][0]
    return document


@refuted("least")
def isometries_of_a_lower_order():
    """The Bolza surface is said to have 95 isometries."""
    return isometries("bolza", order=95)


@forgery("UNDECIDED: least")
def isometries_told_apart_by_nothing():
    """The cocycle is 0."""
    document = isometries()
    return with_(document, cocycle=[0] * len(document["cocycle"]))


@forgery("UNDECIDED: most")
def involution_left_out():
    """The octagon is said to have no isometry but the identity."""
    return isometries(isometries=[], order=1)


@forgery("UNDECIDED: most")
def isometries_of_a_cover_left_out():
    """A cover of the Bolza surface is said to have no isometry but the identity: where its geodesics are followed, it has one."""
    return isometries("cover-of-bolza", isometries=[], order=1)


@refuted("most")
def isometries_of_a_higher_order():
    """The Bolza surface is said to have 97 isometries."""
    return isometries("bolza", order=97)


# ---- Two surfaces ------------------------------------------------------------------------------------------------

group = "comparisons"


def comparison(name="mirror-image", **changes):
    """Two surfaces: an octagon and its mirror image, or another pair of tests/data/comparisons."""
    with open(os.path.join(TOP, "tests", "data", "comparisons", name + ".json"), encoding="utf-8") as file:
        return {**json.load(file), **changes}


def against_itself(document, **changes):
    """The claim that the first surface is different from itself, with other lists of closed geodesics."""
    other = {key: document[key] for key in ("net", "up_to", "geodesics", "clusters")}
    document["other_spectrum"] = {"format": "epsnet-geodesics", "version": 1, "claim": "spectrum", **other, **changes}
    return document


def shorter(document, length):
    """The closed geodesics that are not longer."""
    return {"up_to": str(length), **{key: value for key, value in runs({"geodesics": [
        row for row in document["geodesics"] if row["length"][0] <= length]}).items() if key in ("geodesics", "clusters")}}


@refuted("isometric")
def isometric_by_another_orientation():
    """An octagon and its mirror image, by an isometry that preserves the orientation, the file says."""
    return comparison(preserves_orientation=True)


@refuted("isometric")
def isometric_with_an_image_inverted():
    """One generator goes to the inverse of its image, which has the same trace."""
    document = comparison("bolza-octagons-8-3")
    partner = {}
    for t, k, u, l in document["other_net"]["surface"]["gluing"]:
        partner[8 * t + k], partner[8 * u + l] = 8 * u + l, 8 * t + k
    document["images"][3] = [partner[s] for s in reversed(document["images"][3])]
    return document


@refuted("isometric", says="genera are 3 and 2")
def isometric_to_the_octagon_below():
    """A cover of two sheets; each element goes to itself, an element of the group of the octagon."""
    document = comparison("cover-of-an-octagon", other_net=comparison()["net"])
    paths, partner = document["paths"], {}
    for t, k, u, l in document["net"]["surface"]["gluing"]:
        partner[8 * t + k], partner[8 * u + l] = 8 * u + l, 8 * t + k
    elements = [paths[s // 8] + [s] + [partner[r] for r in reversed(paths[partner[s] // 8])]
                for s in range(16) if s < partner[s]]
    return with_(document, images=[[s % 8 for s in word] for word in document["pair"] + elements])


@refuted("isometric")
def isometric_to_another_octagon():
    """The other surface is another octagon, with the same words."""
    return comparison(other_net=comparison("octagons")["other_spectrum"]["net"])


@refuted("other")
def isometric_by_a_net_that_is_none():
    """The net of the other surface covers less than its epsilon says."""
    document = comparison()
    document["other_net"]["epsilon"] = "0.5"
    return document


@forgery("UNDECIDED: different")
def different_from_itself():
    """Isospectral it is."""
    return against_itself(comparison("sunada"))


@forgery("UNDECIDED: different")
def different_from_its_mirror_image():
    """An octagon with other isometries to its mirror image than to itself."""
    return comparison("mirror-image-different")


@forgery("UNDECIDED: different")
def different_by_a_shorter_list():
    """The list of the other surface, the same one, ends earlier, with fewer closed geodesics and fewer crossings."""
    document = comparison("octagons")
    return against_itself(document, **shorter(document, 3))


@refuted("other")
def different_by_a_geodesic_left_out():
    """In the list of the other surface, the same one, a closed geodesic is missing."""
    document = comparison("octagons")
    rest = {"geodesics": document["geodesics"][1:]}
    return against_itself(document, **{key: runs(rest)[key] for key in ("geodesics", "clusters")})


@malformed("other_spectrum.claim")
def different_by_a_systole():
    """The other list is a systole and no spectrum."""
    document = comparison("octagons")
    document["other_spectrum"] = {"format": "epsnet-geodesics", "version": 1, "claim": "systole",
                                  "net": document["net"], "geodesics": document["geodesics"][:1]}
    return document


# ---- Closed curves -----------------------------------------------------------------------------------------------

group = "curves"


def curves(*changes, **members):
    """Closed curves of an octagon, of tests/data/curves, with curves and pairs changed: (i, member, value) and
    ((i, j), member, value)."""
    with open(os.path.join(TOP, "tests", "data", "curves", "octagon-5.json"), encoding="utf-8") as file:
        document = {**json.load(file), **members}
    for which, member, value in changes:
        row = document["curves"][which] if isinstance(which, int) else pair_of(document, *which)
        row[member] = value(row[member]) if callable(value) else value
    return document


def pair_of(document, i, j):
    return next(row for row in document["pairs"] if (row["first"], row["second"]) == (i, j))


def with_curve(document, i, word, **members):
    """With the word of another curve, and its length if it is not given."""
    document["curves"][i].update(word=word, **members)
    return document


@refuted("lengths")
def curve_that_is_null_homotopic():
    """A word around the vertex of the octagon, which no letter cancels."""
    document = curves()
    surface = Surface(document["net"]["surface"])
    word, side = [], 0
    while not word or side != 0:
        word.append(side)
        side = (surface.partner[side] + 1) % 8
    return with_curve(document, 5, word, length=[1e-9, 1e-8])


@refuted("lengths")
def curve_that_is_a_square_with_the_length_of_its_root():
    """The curve is run through twice, its length is that of one time."""
    return curves((6, "length", curves()["curves"][4]["length"]))


@refuted("powers")
def curve_that_is_a_square_said_to_be_primitive():
    """A square, with the number of self-intersections that a primitive curve could have."""
    return curves((6, "power", 1))


@refuted("powers")
def curve_that_is_primitive_said_to_be_a_square():
    """Its class in homology is twice another one, for a basis that is half as fine."""
    return curves((10, "power", 2))


@refuted("intersections")
def curve_that_is_a_cube_said_to_be_simple():
    """A power of a simple curve, whose parallel strands have to cross to close up."""
    return curves((7, "self_intersections", 0))


@refuted("intersections")
def curve_that_is_a_square_with_the_crossings_of_its_points_alone():
    """The four crossings at the one point where its root crosses itself, without that which closes it up."""
    return curves((6, "self_intersections", 4))


@refuted("intersections")
def curves_of_one_geodesic_said_to_be_disjoint():
    """A curve with a crossing, and its square, which is moved apart from it along the geodesic but not at the crossing."""
    return curves(((4, 6), "intersections", 0))


@refuted("intersections")
def curves_of_one_geodesic_with_as_many_common_points_as_one_of_them_has():
    """Half as many as they have: the crossing of the root is one of two passages of both."""
    return curves(((4, 6), "intersections", 2))


@refuted("intersections")
def curves_that_cross_the_other_way():
    """The sign of the algebraic number of two curves that cross once, as if the surface had the other orientation."""
    return curves(((1, 2), "algebraic", lambda sign: -sign))


@refuted("intersections")
def curves_all_crossing_the_other_way():
    """All signs: the numbers of the mirror image, which has the same basis and the same classes."""
    document = curves()
    for row in document["pairs"]:
        row["algebraic"] = -row["algebraic"]
    return document


@refuted("intersections")
def curves_with_more_points_than_they_need():
    """Two more common points, as curves in general position may have."""
    return curves(((0, 1), "intersections", lambda number: number + 2))


@refuted("homology")
def curve_of_the_class_of_its_inverse():
    """The class of a curve, with the other sign, and the algebraic numbers of the curve."""
    return curves((10, "homology", lambda row: [-n for n in row]))


@refuted("homology", says="determinant")
def basis_of_a_third_of_all_classes():
    """A cube in place of the curve itself: everything has rational coefficients in this basis."""
    document = curves()
    rows = [row["homology"] for row in document["curves"]]
    # Curve 7 is three times (1, −1, 0, −1): in place of curve 1 of the basis.
    document["basis"][0] = 7
    for row, (a, b, c, d) in zip(document["curves"], rows):
        row["homology"] = [a // 3, b + a, c, d + a]
    return document


@refuted("homology", says="has 0 curves|not 0$")
def basis_of_nothing():
    """No curve in the basis, so the determinant is 1, and no coefficient is wrong."""
    document = curves(basis=[])
    for row in document["curves"]:
        row["homology"] = []
    return document


@refuted("homology", says="has 2 curves|not 2$")
def basis_of_two_curves():
    """Two curves that cross once, whose matrix has the determinant 1; all other curves but these are left out."""
    document = curves(basis=[0, 1], filling=[])
    kept = [1, 2]
    document["pairs"] = [{**pair_of(document, *kept), "first": 0, "second": 1}]
    document["curves"] = [{**document["curves"][i], "homology": [int(k == j) for k in range(2)]}
                          for j, i in enumerate(kept)]
    return document


@refuted("filling")
def curve_that_fills_alone():
    """A curve with one crossing: one of the components of its complement is no disk, as 2 − 2g = −1 + b has no b > 0."""
    return curves(filling=[[4]])


@refuted("filling")
def curves_that_cross_often_and_do_not_fill():
    """Three curves with four crossings, one more than a complement of one disk needs."""
    return curves(filling=[[0, 1, 2, 3], [3, 4, 5]])


@refuted("filling")
def no_curves_that_fill():
    """An empty set of curves."""
    return curves(filling=[[]])


@refuted("filling")
def curve_and_its_powers_that_fill():
    """The same geodesic several times, with many crossings."""
    return curves(filling=[[4, 6]])


@malformed("pairs[0]")
def pairs_of_curves_the_other_way_round():
    """The first pair with the second curve first."""
    document = curves()
    document["pairs"][0].update(first=1, second=0)
    return document


@malformed("pairs")
def pairs_of_curves_of_which_one_is_missing():
    """The last pair is left out."""
    return with_(curves(), pairs=curves()["pairs"][:-1])


@malformed("pairs[1].algebraic")
def algebraic_number_of_a_fraction():
    """A number with a fraction that is zero."""
    return curves(((0, 2), "algebraic", 1.0))


@malformed("curves[3].self_intersections")
def self_intersections_less_than_none():
    """A number with a sign."""
    return curves((3, "self_intersections", -1))


@malformed("curves[3]")
def self_intersections_beyond_2_to_the_53():
    """An integer that a program which keeps numbers in binary64 reads as another one."""
    return curves((3, "self_intersections", 2 ** 53 + 1))


@disguise()
def curves_as_they_are():
    """The file that most of these are made from."""
    return curves()


@disguise()
def curves_with_detours():
    """A word that goes forth and back a hundred times before it begins."""
    document = curves()
    word = document["curves"][3]["word"]
    by = [7, 2, 5] * 30
    return with_curve(document, 3, by + word + backwards(document, by))


# ---- Pants decompositions ----------------------------------------------------------------------------------------

group = "pants"


def pants(name="octagon-5", **changes):
    """The octagon; or the Bolza surface, or one of two tiles whose lengths are exactly known."""
    with open(os.path.join(TOP, "tests", "data", "pants", name + ".json"), encoding="utf-8") as file:
        return {**json.load(file), **changes}


def pants_with(changes, name="octagon-5"):
    """Some members of some cuffs replaced: from the numbers of cuffs to members."""
    document = pants(name)
    for i, members in changes.items():
        document["cuffs"][i].update(members)
    return document


def backwards(document, word):
    surface = document["net"]["surface"]
    return inverse(word) if surface["kind"] == "regular" else Surface(surface).inverse_word(word)


def path_of_cuff(document, end):
    (p, k) = end
    first, second = document["pants"][p]
    return (first, second, backwards(document, first + second))[k]


def ends_of(document):
    """Each end, with its row and its place there."""
    return [(end, row, place) for row in document["cuffs"] for place, end in enumerate(row["ends"])]


def going_first(document, row, place, word):
    """At the first or second end of a row, the path across goes along a word first; or comes along its inverse last."""
    row["across"] = word + row["across"] if place == 0 else row["across"] + backwards(document, word)


def with_pants_mirrored(document, p):
    """Cuffs 0 and 1 of a pair of pants exchanged: the paths β, α, and at cuff 2 another path across."""
    first, second = document["pants"][p]
    for end, row, place in ends_of(document):
        if end[0] == p:
            # (βα)⁻¹ = α⁻¹(αβ)⁻¹α
            if end[1] == 2:
                going_first(document, row, place, backwards(document, first))
            else:
                end[1] = 1 - end[1]
    document["pants"][p] = [second, first]
    return document


def with_pants_conjugated(document, p, word):
    """The paths of a pair of pants go along a word first, and back."""
    back = backwards(document, word)
    document["pants"][p] = [back + path + word for path in document["pants"][p]]
    for end, row, place in ends_of(document):
        if end[0] == p:
            going_first(document, row, place, back)
    return document


def shifted(interval, by):
    """Both ends moved to the next number, `by` times up or down."""
    for _ in range(abs(by)):
        interval = [math.nextafter(x, math.inf if by > 0 else -math.inf) for x in interval]
    return interval


def plus(interval, other, factor=1):
    """Contains all sums of numbers of the first one and of the second one times the factor, rounded outward."""
    lower, upper = sorted(Fraction(x) * factor for x in other)
    return [math.nextafter(float(Fraction(interval[0]) + lower), -math.inf),
            math.nextafter(float(Fraction(interval[1]) + upper), math.inf)]


def with_pants_twice(document):
    """All pairs of pants and cuffs once more, with other numbers."""
    count = len(document["pants"])
    document["pants"] = document["pants"] * 2
    document["cuffs"] += [{**row, "ends": [[p + count, k] for p, k in row["ends"]]} for row in document["cuffs"]]
    return document


def on_the_right(document):
    """All paths backwards."""
    for p, (first, second) in enumerate(document["pants"]):
        # (α⁻¹β⁻¹)⁻¹ = β(αβ)β⁻¹
        for end, row, place in ends_of(document):
            if end == [p, 2]:
                going_first(document, row, place, second)
        document["pants"][p] = [backwards(document, first), backwards(document, second)]
    return document


@refuted("pants", says="on whose left|on the right")
def pants_on_the_right_of_their_paths():
    """All paths are backwards, and the paths across fit: everything is the same but for the sides."""
    return on_the_right(pants())


@refuted("pants", also=["lengths"], says="on whose left|on the right")
def pants_on_the_right_of_a_cuff_of_another_exact_length():
    """The same, and exp_half_length is wrong, which is asked exactly, and of which nothing is said before."""
    document = on_the_right(pants())
    document["cuffs"][0]["exp_half_length"] = "3"
    return document


@refuted("pants", also=["glued"], says="on whose left|on the right")
def pants_on_the_right_once():
    """One pair of pants is on the right of its paths, the other one on the left."""
    document = pants()
    document["pants"][0] = [backwards(document, path) for path in document["pants"][0]]
    return document


@refuted("pants", also=["glued"], says="on whose left|for their traces")
def pants_of_a_figure_eight():
    """One of two paths is backwards, so that the third one is a figure eight."""
    document = pants()
    document["pants"][0][1] = backwards(document, document["pants"][0][1])
    return document


@refuted("pants", also=["glued"], says="on whose left|for their traces")
def pants_of_a_path_to_nowhere():
    """A second path of no letters: the third cuff is the first one, backwards."""
    document = pants()
    document["pants"][1][1] = []
    return document


@refuted("pants", also=["glued"], says="on whose left|for their traces")
def pants_of_a_path_that_is_null_homotopic():
    """A first path that cancels."""
    document = pants()
    document["pants"][1][0] = [3, 7]
    return document


@refuted("pants", says="4 pairs of pants, expected|not 4$")
def pants_twice():
    """Every pair of pants and every cuff twice: a covering by two copies of the surface, for which all else holds."""
    return with_pants_twice(pants())


@refuted("pants", says="4 pairs of pants, expected|not 4$")
def pants_of_a_double_cover():
    """The pairs of pants of a connected double cover, for which all else holds: its sheets are exchanged along a cuff."""
    document = with_pants_twice(pants())
    first, second = (document["cuffs"][i]["ends"] for i in (2, 5))
    first[1], second[1] = second[1], first[1]
    return document


@refuted("pants", says="0 pairs of pants, expected|not 0$")
def no_pants():
    """No pairs of pants, and no cuffs: all other rules have nothing to ask."""
    return pants(pants=[], cuffs=[])


@refuted("pants", says="2 pairs of pants, expected|not 2$")
def pants_too_few():
    """The pairs of pants of a surface of genus 2, in a net of genus 3 whose sides have the same numbers."""
    with open(os.path.join(TOP, "tests", "data", "certify", "verified", "regular-3-centre.json"), encoding="utf-8") as file:
        return pants("bolza", net=json.load(file))


@refuted("glued")
def paths_of_pants_exchanged():
    """The two paths of a pair of pants are exchanged: a pair of pants, with its cuffs at the wrong ends."""
    document = pants()
    document["pants"][1].reverse()
    return document


@refuted("glued")
def path_of_pants_squared():
    """One path twice around its cuff; with the other one it bounds another pair of pants, which overlaps itself."""
    document = pants()
    document["pants"][0][0] = document["pants"][0][0] * 2
    return document


@refuted("glued")
def pants_beside_themselves():
    """The second pair of pants is the first one, too."""
    document = pants()
    document["pants"][1] = document["pants"][0]
    return document


@refuted("glued")
def cuff_glued_around_a_handle():
    """The path across goes around another cuff first."""
    document = pants()
    row = document["cuffs"][1]
    row["across"] = path_of_cuff(document, [1, 0]) + row["across"]
    return document


@refuted("glued")
def cuff_glued_around_a_cuff_of_1e_12():
    """The path across a cuff goes around one of length 10⁻¹² first, which moves hardly anything beside it."""
    document = pants("cuff-1e-12")
    row = document["cuffs"][2]
    row["across"] = path_of_cuff(document, document["cuffs"][0]["ends"][0]) + row["across"]
    return document


@refuted("glued")
def cuff_glued_backwards():
    """The path across goes from the second end to the first."""
    document = pants()
    row = document["cuffs"][2]
    row["across"] = backwards(document, row["across"])
    return document


@refuted("glued")
def ends_of_pants_exchanged_between_cuffs_of_equal_length():
    """The second ends of two cuffs of the Bolza surface are exchanged, which have the same length and twist."""
    document = pants("bolza")
    first, second = (row["ends"] for row in document["cuffs"][:2])
    first[1], second[1] = second[1], first[1]
    return document


@refuted("glued")
def pants_moved_alone():
    """The paths of a pair of pants are conjugated in the last place, those across are as before."""
    document = pants()
    rows = copy.deepcopy(document["cuffs"])
    return {**with_pants_conjugated(document, 1, [4]), "cuffs": rows}


@refuted("lengths")
def cuff_an_ulp_longer():
    """The two numbers around the length of the last cuff, a unit higher each."""
    return pants_with({2: {"length": shifted(pants()["cuffs"][2]["length"], 1)}})


@refuted("lengths")
def cuff_an_ulp_shorter():
    """The two numbers around the length of the first cuff, a unit lower each."""
    return pants_with({0: {"length": shifted(pants()["cuffs"][0]["length"], -1)}})


@refuted("lengths")
def cuff_of_a_length_that_is_only_nearly_a_number():
    """The length is said to be the number 3 that it is nearest to; that is none, as 3 is not 2 ln R."""
    return pants_with({2: {"length": [3, 3]}}, "cuff-1e-12")


@refuted("lengths")
def cuff_of_the_length_of_a_double_cover():
    """The length of twice around."""
    return pants_with({1: {"length": [2 * x for x in pants()["cuffs"][1]["length"]]}})


@refuted("lengths")
def cuffs_of_exchanged_lengths():
    """The first and the last length are exchanged."""
    rows = pants()["cuffs"]
    return pants_with({0: {"length": rows[2]["length"]}, 2: {"length": rows[0]["length"]}})


@refuted("lengths")
def pants_of_another_surface():
    """The net is that of another octagon, which the same paths cut into pairs of pants."""
    return pants(net=octagon())


def with_root(change, i=2, name="fenchel-nielsen-2"):
    document = pants(name)
    row = document["cuffs"][i]
    row["exp_half_length"] = str(change(Fraction(row["exp_half_length"])))
    return document


@refuted("lengths", says="exp_half_length")
def root_of_a_cuff_wrong_in_the_last_digit():
    """The last digit of the denominator of exp_half_length."""
    return with_root(lambda r: Fraction(r.numerator, r.denominator - 1))


@refuted("lengths", says="exp_half_length")
def root_of_a_cuff_wrong_by_1e_60():
    """exp_half_length is 10⁻⁶⁰ more."""
    return with_root(lambda r: r + Fraction(1, 10**60))


@refuted("lengths", says="exp_half_length")
def root_of_a_cuff_of_its_whole_length():
    """The square of exp_half_length, the exponential of the length."""
    return with_root(lambda r: r * r)


@refuted("lengths", says="exp_half_length")
def root_of_a_cuff_that_has_none():
    """The octagon's cuffs have algebraic exponentials: exp_half_length is a rational number within 10⁻⁵⁰ of one."""
    document = pants()
    row = document["cuffs"][0]
    f = Surface(document["net"]["surface"]).value(path_of_cuff(document, row["ends"][0]))
    # cosh²(l/2)
    square = ((f.a + ONE) * (f.a + ONE) / (f.a - f.b * f.c)).re / 4
    with localcontext() as context:
        context.prec = 60
        cosh = (Decimal(square.numerator) / Decimal(square.denominator)).sqrt()
        row["exp_half_length"] = rational(Fraction(cosh + (cosh * cosh - 1).sqrt()))
    return document


@refuted("twists")
def twist_of_the_opposite_sign():
    """One twist to the other side."""
    return pants_with({0: {"twist": [-x for x in reversed(pants()["cuffs"][0]["twist"])]}})


@refuted("twists")
def twists_of_the_mirror_image():
    """All twists to the other side."""
    rows = pants()["cuffs"]
    return pants_with({i: {"twist": [-x for x in reversed(row["twist"])]} for i, row in enumerate(rows)})


@refuted("twists")
def twist_an_ulp_more():
    """The two numbers around the twist of the last cuff, a unit higher each."""
    return pants_with({2: {"twist": shifted(pants()["cuffs"][2]["twist"], 1)}})


@refuted("twists")
def twist_an_ulp_less():
    """The two numbers around the twist of the first cuff, a unit lower each."""
    return pants_with({0: {"twist": shifted(pants()["cuffs"][0]["twist"], -1)}})


@refuted("twists")
def twist_of_half_a_length_more():
    """The mark of one of the two pairs of pants is on the other side of the cuff."""
    row = pants()["cuffs"][1]
    return pants_with({1: {"twist": plus(row["twist"], row["length"], Fraction(1, 2))}})


@refuted("twists")
def twists_by_the_marks_of_the_cuffs_before():
    """The cuffs of one pair of pants are numbered the other way around, so that its marks are those of cuffs k − 1."""
    return with_pants_mirrored(pants(), 1)


@refuted("twists")
def twist_modulo_another_length():
    """The length of another cuff more."""
    rows = pants()["cuffs"]
    return pants_with({0: {"twist": plus(rows[0]["twist"], rows[1]["length"])}})


@refuted("twists")
def twist_of_a_cuff_of_1e_12_by_half_of_it():
    """Half of the length of 10⁻¹² more."""
    row = pants("cuff-1e-12")["cuffs"][0]
    return pants_with({0: {"twist": plus(row["twist"], row["length"], Fraction(1, 2))}}, "cuff-1e-12")


@refuted("twists")
def twist_of_the_least_positive_number():
    """A twist that is exactly 0 is said to be at least 2⁻¹⁰⁷⁴."""
    return pants_with({0: {"twist": [5e-324, 0.5]}}, "bolza")


@refuted("twists")
def twist_in_a_gap_of_an_ulp():
    """An interval of nearly the length, from just after the twist to just before the next one."""
    row = pants()["cuffs"][0]
    last = math.nextafter(row["twist"][0] + row["length"][0], 0)
    return pants_with({0: {"twist": [row["twist"][1], last]}})


@malformed("cuffs[1]")
def end_of_two_cuffs():
    """One end is in two rows, another one in none."""
    document = pants()
    document["cuffs"][1]["ends"][1] = document["cuffs"][0]["ends"][1]
    return document


@malformed("cuffs[1].ends")
def end_plus_2_to_32():
    """The number of a pair of pants is 2³² more."""
    document = pants()
    document["cuffs"][1]["ends"][0][0] += 2**32
    return document


@malformed("cuffs[2]")
def end_of_a_cuff_3():
    """An end is cuff 3 of the first pair of pants, which could be taken for cuff 0 of the next one."""
    document = pants()
    document["cuffs"][2]["ends"][1] = [0, 5]
    return document


@malformed("cuffs")
def pants_with_an_open_cuff():
    """One cuff is left out: a surface with boundary."""
    document = pants()
    del document["cuffs"][2]
    return document


@malformed("cuffs[2]")
def cuff_with_a_path_to_another_tile():
    """The path across ends in the tile where it begins, and the other pair of pants is in another tile."""
    return pants_with({2: {"across": []}}, "fenchel-nielsen-2")


@malformed("pants[0]")
def path_of_pants_that_is_open():
    """A path of a pair of pants ends in the other tile."""
    document = pants("fenchel-nielsen-2")
    document["pants"][0][1] = [4]
    return document


@malformed("pants[1]")
def pants_in_two_tiles():
    """The second path of a pair of pants is closed, and begins in the other tile."""
    document = pants("fenchel-nielsen-2")
    document["pants"][1][1] = document["pants"][0][1]
    return document


@malformed("cuffs[1]")
def root_of_a_cuff_that_is_inverse():
    """exp_half_length is the exponential of minus half of the length."""
    return with_root(lambda r: 1 / r, 1)


@malformed("cuffs[1]")
def root_of_a_cuff_that_is_1():
    """exp_half_length is that of the length 0."""
    return with_root(lambda r: 1, 1)


@malformed("cuffs[0]")
def cuff_of_a_length_of_0_or_more():
    """The length is at least 0."""
    return pants_with({0: {"length": [0, 3]}})


@malformed("cuffs[0]")
def twist_the_other_way():
    """The ends of the twist's interval are exchanged, so that it contains nothing."""
    return pants_with({0: {"twist": pants()["cuffs"][0]["twist"][::-1]}})


# ---- Distances ---------------------------------------------------------------------------------------------------

group = "distances"


def distance_file(name):
    with open(os.path.join(TOP, "tests", "data", "distances", name + ".json"), encoding="utf-8") as file:
        return json.load(file)


def four_paths():
    return distance_file("four-equal")


def seven_paths():
    return distance_file("across-a-cuff-of-1e-8")


@refuted("nearest")
def distance_without_one_of_four_equal_paths():
    """One of four shortest paths of equal length is left out."""
    document = four_paths()
    del document["paths"][2]
    return document


@refuted("nearest")
def distance_without_a_path_that_is_longer_by_1e_16():
    """One of seven paths is left out: not a shortest one, and longer by less than binary64 tells."""
    document = seven_paths()
    del document["paths"][6]
    return document


@refuted("nearest")
def distance_along_another_path():
    """The one path listed goes once around a side first, and the distance is said to be as large as that."""
    return with_(distance_file("bolza"), paths=[[2, 0]], distance=[0, 10])


@refuted("nearest")
def distance_with_an_upper_end_beyond_the_next_path():
    """hi is more than the length of the next path, which is not listed."""
    document = distance_file("bolza")
    return with_(document, distance=[document["distance"][0], 5])


@refuted("paths")
def distance_too_large_by_1e_12():
    """The enclosure is moved up by 10⁻¹²."""
    document = distance_file("bolza")
    return with_(document, distance=[x + 1e-12 for x in document["distance"]])


@refuted("paths")
def distance_too_small_by_1e_12():
    """The enclosure is moved down by 10⁻¹²."""
    document = distance_file("bolza")
    return with_(document, distance=[x - 1e-12 for x in document["distance"]])


@refuted("paths")
def distance_with_a_longer_path():
    """One of four paths goes around a closed geodesic first."""
    document = four_paths()
    document["paths"][1] = [0, 1] + document["paths"][1]
    return document


@refuted("paths", says="again")
def distance_with_a_path_twice():
    """One of four paths takes the place of another one, once around the corner of the octagon before it begins."""
    document = four_paths()
    document["paths"][3] = RELATOR + document["paths"][1]
    return document


@refuted("paths")
def distance_zero_of_points_1e_400_apart():
    """The distance of a point and one 10⁻⁴⁰⁰ away is said to be 0."""
    document = distance_file("zero")
    tile, x, y = document["point"]
    return with_(document, point=[tile, rational(Fraction(x) + Fraction(1, 10**400)), y])


@refuted("equal")
def distance_with_lengths_that_are_nearly_equal():
    """Seven lengths that agree in 15 digits are said to be equal."""
    return with_(seven_paths(), equal=True)


@malformed("net")
def distance_in_a_net_of_more_vertices():
    """A net of several vertices: the nearest vertex of the net may be another one."""
    return with_(distance_file("bolza"), net=octagon(), paths=[[]])


@malformed("paths[0]")
def distance_along_a_path_to_another_tile():
    """The path ends in the other tile."""
    document = seven_paths()
    del document["paths"][0][-1]
    return document


@malformed("distance")
def distance_below_zero():
    """The enclosure begins at −10⁻³⁰⁰."""
    return with_(distance_file("zero"), distance=[-1e-300, 0])


# ---- Bounds ------------------------------------------------------------------------------------------------------

group = "bounds"


def bound_file(name):
    with open(os.path.join(TOP, "tests", "data", "bounds", name + ".json"), encoding="utf-8") as file:
        return json.load(file)


def bound_moved(name, low, high):
    """The file with the ends of its enclosure moved."""
    document = bound_file(name)
    return with_(document, value=[document["value"][0] + low, document["value"][1] + high])


@refuted("cells")
def diameter_too_small_by_1e_12():
    """The upper end for the regular surface of genus 2 is less than its diameter by 10⁻¹², the lower end by more."""
    return with_(bound_file("regular-diameter"), value=[2.4, math.acosh(math.tan(math.pi / 8) ** -2) - 1e-12])


@refuted("lower")
def diameter_too_large_by_1e_12():
    """The whole enclosure is moved up by 10⁻¹²."""
    return bound_moved("regular-diameter", 1e-12, 1e-12)


@refuted("cells")
def diameter_with_all_cells_bounded_by_the_triangulation_of_the_net():
    """No cell has a triangulation of its own, and the circumradii of the net's grow away from its vertex."""
    document = bound_file("octagon-diameter")
    return with_(document, cells=[[entry if entry < 3 else 3 for entry in row] for row in document["cells"]])


@refuted("cells")
def diameter_with_a_flip_left_out():
    """A triangulation lacks its last flip, and so do all that are made from it."""
    document = bound_file("regular-diameter")
    row = max(document["triangulations"], key=len)
    row.pop()
    return document


@refuted("cells")
def diameter_with_a_triangle_that_is_one_cell():
    """A triangle is not cut: its bound is asked for at its corners, the net's vertex, and is too large for all."""
    document = bound_file("octagon-diameter")
    document["cells"][0] = document["cells"][0][-1:]
    return document


@malformed("cells")
def diameter_without_a_triangle():
    """The last triangle of the net has no cells: a part of the surface is not looked at."""
    document = bound_file("octagon-diameter")
    del document["cells"][-1]
    return document


@malformed("cells[1]")
def diameter_without_a_cell():
    """The last cell of a triangle is left out."""
    document = bound_file("octagon-diameter")
    document["cells"][1].pop()
    return document


@malformed("cells[1]")
def diameter_with_a_cell_too_many():
    """One cell more than the cuts make."""
    document = bound_file("octagon-diameter")
    document["cells"][1].append(3)
    return document


@malformed("triangulations[0]")
def diameter_with_a_triangulation_made_from_itself():
    """The first triangulation is made from itself."""
    document = bound_file("octagon-diameter")
    document["triangulations"][0][0] = 1
    return document


@refuted("covering")
def diameter_with_a_net_that_is_none():
    """The ε of the net is less than the eccentricity of its vertex."""
    document = bound_file("octagon-diameter")
    document["net"]["epsilon"] = "0.1"
    return document


@refuted("orientation", also=("delaunay", "covering"))
def diameter_of_another_surface():
    """The surface is another octagon; net, triangulations and cells are left as they are."""
    document = bound_file("octagon-diameter")
    document["net"]["surface"] = bound_file("octagon-radius")["net"]["surface"]
    return document


@refuted("upper")
def radius_too_small_by_1e_12():
    """The upper end is less than the eccentricity of the net's vertex by 10⁻¹²."""
    return bound_moved("octagon-radius", 0, -1e-12)


@refuted("cells")
def radius_with_a_lower_end_larger_by_1e_12():
    """The lower end is more by 10⁻¹² than what the worst cell proves."""
    return bound_moved("octagon-radius", 1e-12, 0)


@refuted("cells")
def radius_with_a_triangulation_that_is_not_delaunay():
    """The lower end is next to nothing, but one cell has the triangulation of another one, whose largest circumradius at
    its midpoint is no eccentricity."""
    document = with_(bound_file("octagon-radius"), value=[1e-3, 3])
    row = document["cells"][0]
    k = next(k for k, entry in enumerate(row) if entry >= 3)
    row[k] = 3 + row[k] % (3 * len(document["triangulations"]) + 3)
    return document


@refuted("cells")
def diameter_said_to_be_the_radius():
    """The claim is another one, and the same triangulations are asked for the eccentricity at midpoints of sides."""
    document = with_(bound_file("octagon-diameter"), claim="radius")
    return with_(document, cells=[[entry if entry < 3 else 3 * entry - 6 for entry in row] for row in document["cells"]],
                 value=[document["value"][0], 3])


@refuted("cells")
def embedded_disk_too_small_by_a_tenth():
    """Both ends are moved down by 1/10: there are larger disks."""
    return bound_moved("octagon-embedded-disk", -0.1, -0.1)


@malformed("value")
def embedded_disk_of_radius_nothing():
    """The enclosure begins at 0, which says nothing."""
    document = bound_file("octagon-embedded-disk")
    return with_(document, value=[0, document["value"][1]])


def in_a_domain(name="octagon-diameter-domain"):
    """A bound file with a symmetry, and that."""
    document = bound_file(name)
    return document, document["symmetry"]


@refuted("isometries")
def bound_with_a_row_that_is_no_isometry():
    """Of one side of the domain the image of a generator is another element."""
    document, symmetry = in_a_domain()
    images = symmetry["isometries"][1]["images"]
    images[2], images[3] = images[3], images[2]
    return document


@refuted("isometries")
def bound_with_an_isometry_said_to_reverse_the_orientation():
    """The image of the centre is then another point."""
    document, symmetry = in_a_domain()
    symmetry["isometries"][0]["preserves_orientation"] = False
    return document


@refuted("isometries")
def bound_with_the_reflections_of_a_surface_without_any():
    """An octagon, with the isometries of Bolza's surface, and a net of its own."""
    document, symmetry = in_a_domain()
    _, other = in_a_domain("bolza-radius-domain")
    symmetry.update(isometries=other["isometries"], pair=other["pair"])
    return with_(document, cells=[[3]] * len(other["isometries"]))


@refuted("cells")
def bound_with_the_sides_of_a_domain_in_another_order():
    """Two sides that follow each other are exchanged, with the cells of their triangles: their lines meet farther out."""
    document, symmetry = in_a_domain()
    for rows in (symmetry["isometries"], document["cells"]):
        rows[1], rows[2] = rows[2], rows[1]
    return document


@refuted("domain")
def bound_with_the_sides_of_a_domain_clockwise():
    """They surround the centre the other way round."""
    document, symmetry = in_a_domain()
    symmetry["isometries"].reverse()
    document["cells"].reverse()
    return document


@refuted("domain")
def bound_with_three_sides_of_a_domain():
    """They do not surround the centre."""
    document, symmetry = in_a_domain()
    symmetry["isometries"] = symmetry["isometries"][:3]
    document["cells"] = document["cells"][:3]
    return document


@refuted("domain")
def bound_with_a_centre_outside_of_the_reflections():
    """The mirrors bound a triangle; seen from the other side of one of them they do not surround the centre."""
    document, symmetry = in_a_domain("bolza-radius-domain")
    symmetry["centre"] = [-x for x in symmetry["centre"]]
    return document


@refuted("cells")
def bound_of_a_domain_that_is_not_cut():
    """Each triangle of the domain is one cell."""
    document, _ = in_a_domain()
    return with_(document, cells=[[3]] * len(document["cells"]))


@refuted("cells")
def radius_in_a_domain_said_to_be_larger():
    """LO is HI."""
    document, _ = in_a_domain("bolza-radius-domain")
    return with_(document, value=[document["value"][1]] * 2)


@malformed("base")
def bound_with_a_base_and_a_domain():
    """One would not know which is cut into cells."""
    document, _ = in_a_domain()
    return with_(document, base=[1])


@malformed("symmetry")
def bound_with_a_centre_on_the_circle():
    """It is no point."""
    document, symmetry = in_a_domain()
    symmetry["centre"] = [0.6, 0.8]
    return document


@malformed("symmetry")
def bound_with_two_sides_of_a_domain():
    """Two lines surround nothing."""
    document, symmetry = in_a_domain("bolza-radius-domain")
    symmetry["isometries"] = symmetry["isometries"][:2]
    document["cells"] = document["cells"][:2]
    return document


@malformed("bound file")
def bound_with_another_claim():
    """A claim that does not exist."""
    return with_(bound_file("regular-diameter"), claim="girth")


# ---- Disguises ---------------------------------------------------------------------------------------------------

group = "disguises"


@disguise()
def as_it_is():
    """The net that most forgeries are made from."""
    return octagon()


@disguise()
def collars_as_they_are():
    """The pseudo net of the forged collars."""
    return collars()


@disguise()
def spectrum_as_it_is():
    """The spectrum of the forged ones."""
    return spectrum()


@disguise()
def spectrum_of_nothing_below_the_systole():
    """No geodesic at all, up to a number less than the systole by less than 10⁻¹⁵."""
    return with_(spectrum(), geodesics=[], clusters=[], up_to=repr(below(spectrum()["geodesics"][0]["length"][0])))


@disguise()
def equal_lengths_as_they_are():
    """The twelve systoles of the Bolza surface."""
    return seed("spectrum-of-equal-lengths")


@disguise()
def figure_eight_as_it_is():
    """A spectrum with a geodesic that crosses itself."""
    return seed("spectrum-with-a-figure-eight")


@disguise()
def systole_as_it_is():
    """The systole."""
    return seed("systole")


@disguise()
def small_curves_as_they_are():
    """The small curves and pieces."""
    return small_curves()


@disguise()
def equal_distances_as_they_are():
    """A distance with four shortest paths."""
    return four_paths()


@disguise()
def distance_with_words_in_other_letters():
    """The same with words that go once around the corner of the octagon, and to and fro."""
    document = four_paths()
    document["paths"] = [RELATOR + [5, 1] + path for path in document["paths"]]
    return document


@disguise()
def distance_with_a_lower_end_of_zero():
    """An enclosure that says less than it could."""
    return with_(seven_paths(), distance=[-0.0, seven_paths()["distance"][1]])


@disguise()
def narrow_collar_as_it_is():
    """A pseudo net with a core nearly as long as ε: the two vertices of the collar are 0.11 apart, ε is 0.34."""
    return seed("narrow-collar")


@disguise()
def curve_of_1e_12_as_it_is():
    """The surface with a closed geodesic of length 10⁻¹²."""
    return seed("curve-of-1e-12")


@disguise()
def one_vertex_as_it_is():
    """The net of one vertex."""
    return seed("octagon-of-one-vertex")


@disguise()
def symmetric_octagon_as_it_is():
    """The octagon of equal sides, with one vertex in its centre."""
    return symmetric_net()


@disguise()
def symmetric_octagon_of_another_length():
    """The same with lengths that differ by 10⁻³⁰."""
    return symmetric_net(a=Fraction(5, 6) + Fraction(1, 10**30))


@disguise()
def short_curves_as_they_are():
    """The net of the vertices in the thin part, as a net."""
    document = seed("net-with-short-curves")
    del document["collars"]
    return document


@disguise()
def regular_as_it_is():
    """The regular surface."""
    return seed("regular")


@disguise()
def field_octagon_as_it_is():
    """The octagon over ℚ(√2), which is rational but for factors."""
    return field("octagon")


@disguise()
def field_reducible_as_it_is():
    """The same, where numbers that are 0 are not written as 0: x² − 2, √2 a root of (x² − 2)(x² − 3)."""
    return field("reducible")


@disguise()
def field_bolza_as_it_is():
    """The regular octagon over the field of √(2 + 2√2)."""
    return field()


@disguise()
def field_with_another_root_at_an_end():
    """√2 as the root between 1 and 2 of (x − 1)(x − 2)(x² − 2)."""
    return field("octagon", polynomial=["-4", "6", "0", "-3", "1"], root=["1", "2"])


@disguise()
def field_vectors_of_other_sizes():
    """A vertex times 10⁶⁰ and a crossing times −7: the same point and isometry."""
    document = field()
    tile, crossings = document["surface"]["polygons"][0], document["surface"]["crossings"]
    tile[2] = multiple(10**60, tile[2])
    crossings[2] = multiple(-7, crossings[2])
    return document


@disguise()
def triangles_as_tiles():
    """The net's own triangles are the tiles."""
    tiles, opposite, _ = tiled_octagon()
    return net_of_tiles(tiles, opposite, "1")


@disguise()
def double_cover_of_surface_and_net():
    """The double cover of the surface as a surface of genus 3, and that of the net."""
    tiles, opposite, mesh = tiled_octagon()
    return net_of_tiles(tiles * 2, mesh.cover(2, parity), "1")


@disguise()
def cover_of_150_sheets_of_surface_and_net():
    """The cover of both with 150 sheets, 2,400 triangles."""
    return of_2400_triangles()


@disguise()
def chart_for_every_vertex():
    """Every vertex is the centre of a chart of its own."""
    return Mesh(octagon()).write()


@disguise()
def keys_escaped():
    """Every letter of every key as an escape."""
    return re.sub(rb'"([a-z]+)":', lambda match: b'"' + b"".join(b"\\u%04X" % c for c in match[1]) + b'":',
                  text(octagon()))


@disguise()
def strings_escaped():
    """Every character of every rational as an escape, the slash also as `\\/`."""
    return re.sub(rb'"([0-9/-]+)"',
                  lambda match: b'"' + b"".join(b"\\/" if c == 47 else b"\\u%04x" % c for c in match[1]) + b'"',
                  text(octagon()))


@disguise()
def keys_in_another_order():
    """All members in reverse order."""
    document = octagon()
    document["surface"] = dict(reversed(document["surface"].items()))
    return dict(reversed(document.items()))


@disguise()
def white_space_everywhere():
    """Tabs, line feeds, carriage returns and spaces between all symbols."""
    return b" \r\n\t" + re.sub(rb'([,:\[\]{}])(?=[^"]|"[a-z0-9-])', b"\\1 \t\r\n", text(octagon())) + b"\n \t"


@disguise()
def free_text_that_looks_like_a_net():
    """The free text is a net with another ε."""
    document = octagon()
    document["surface"]["about"] = text(with_(octagon(), epsilon="0.1")).decode() + '\0"}]'
    return document


@disguise()
def free_text_of_a_mebibyte():
    """The free text has 2²⁰ bytes, the most that is allowed."""
    document = octagon()
    document["surface"]["about"] = "é" * 2**19
    return json.dumps(document, ensure_ascii=False).encode()


@disguise()
def epsilon_in_other_ways():
    """ε = 1 as `00010.000E-1`."""
    return with_(octagon(), epsilon="00010.000E-1")


@disguise()
def epsilon_as_a_fraction():
    """ε = 1 as `007/7`."""
    return with_(octagon(), epsilon="007/7")


@disguise()
def epsilon_of_a_million_digits():
    """ε = 1 with 10⁶ digits, as many as the format allows."""
    return with_(octagon(), epsilon="1." + "0" * 999_999)


@disguise()
def rational_of_a_million_digits():
    """A corner of the tile, not reduced, with 10⁶ digits, as many as the format allows."""
    document = octagon()
    zeros = "0" * 499_995
    document["surface"]["tiles"][0][0] = [f"09373{zeros}/10000{zeros}", "0"]
    return document


@disguise()
def rationals_not_reduced():
    """Every rational times 6/6, with zeros in front and a minus before zeros."""
    def change(x):
        x = Fraction(x)
        return ("-" if x <= 0 else "") + f"00{abs(x.numerator) * 6}/0{x.denominator * 6}"
    document = octagon()
    document["surface"]["tiles"] = [[[change(z) for z in vertex] for vertex in tile]
                                    for tile in document["surface"]["tiles"]]
    document["charts"] = [[t, change(x), change(y)] for t, x, y in document["charts"]]
    return document


def coordinates(change):
    document = octagon()
    document["vertices"] = [[c, Raw(change(x)), Raw(change(y))] for c, x, y in document["vertices"]]
    return document


@disguise()
def coordinates_with_exponents():
    """Every coordinate with a capital E, a sign and zeros in its exponent."""
    def change(x):
        mantissa, exponent = f"{x:.16e}".split("e")
        return f"{mantissa}E{exponent[0]}000{exponent[1:]}"
    return coordinates(change)


@disguise()
def coordinates_in_full():
    """Every coordinate with all digits of its binary64 number, hundreds of them for the small ones."""
    return coordinates(lambda x: format(Decimal(x), "f"))


@disguise()
def coordinates_with_zeros_at_their_end():
    """Every coordinate with a hundred zeros at its end."""
    return coordinates(lambda x: format(Decimal(repr(x)), "f") + ("" if "." in format(Decimal(repr(x)), "f") else ".") +
                       "0" * 100)


@disguise()
def coordinates_that_round_to_the_same():
    """Every coordinate with a digit more, less than half a unit of the last place away."""
    def change(x):
        return "0.0" if x == 0 else format(Decimal(x) * (1 + Decimal(10) ** -17), "f")
    return coordinates(change)


@disguise()
def zeros_of_all_kinds():
    """The coordinate 0 as `-0.0e99999999999999999999`, and as 10⁻⁴⁰⁰."""
    document = octagon()
    document["vertices"][0] = [0, Raw("-0.0e99999999999999999999"), Raw("1e-400")]
    return document


@disguise()
def word_of_a_million_letters():
    """A word that goes to and fro, 10⁶ letters in all."""
    document = symmetric_net()
    even = next(k for k, label in enumerate(document["labels"]) if label[2] and len(label[2]) % 2 == 0)
    return with_word(document, lambda word: [3, 7] * ((1_000_000 - len(word)) // 2) + word, even)


@disguise()
def word_with_relators():
    """A word and a hundred times around the corner of the octagon."""
    return with_word(octagon(), lambda word: RELATOR * 100 + word)


@disguise()
def charts_and_labels_that_nothing_uses():
    """A chart and labels more, not reduced, trivial and repeated."""
    document = octagon()
    document["charts"].append([0, "99999999999999999999/100000000000000000000", "0"])
    document["labels"] += [[3, 3, RELATOR], [3, 0, []], [3, 0, []], [0, 3, [0, 4, 1, 5]]]
    return document


@disguise()
def exact_tie():
    """Four vertices on a circle, with one diagonal."""
    return seed("square")


@disguise()
def exact_tie_flipped():
    """The same with the other diagonal."""
    mesh, dart = tie()
    mesh.flip(dart)
    return mesh.write()


@disguise()
def tie_missed_on_the_right_side():
    """Four vertices on a circle but for 10⁻³⁰, with the diagonal that is Delaunay."""
    mesh = with_tie_missed_by(Fraction(1, 10**30))
    _, dart = tie()
    if mesh.excess(dart) >= 0:
        mesh = with_tie_missed_by(Fraction(-1, 10**30))
    return mesh.write()


@disguise()
def epsilon_1e_60_more_than_the_largest_radius():
    """ε is the largest circumradius, rounded up after 60 digits."""
    return with_(octagon(), epsilon=to_60_digits(radius_of(Mesh(octagon())), 1))


@disguise()
def epsilon_1e_60_less_than_the_shortest_edge():
    """ε is the shortest edge, rounded down after 60 digits."""
    return with_(octagon(), epsilon=to_60_digits(edge_of(Mesh(octagon()))))


@disguise()
def epsilon_1e_60_more_than_the_radius_of_the_regular_octagon():
    """ε is the circumradius of the regular octagon, rounded up after 60 digits."""
    return with_(seed("regular-of-one-vertex"), epsilon=to_60_digits(regular_radius(), 1))


@disguise()
def field_epsilon_1e_60_more_than_the_radius():
    """The same for the regular octagon over a number field."""
    return on_field(epsilon_1e_60_more_than_the_radius_of_the_regular_octagon())


@disguise()
def core_inverted():
    """The core of a collar is the inverse of the loop, which the format allows."""
    document = collars()
    surface = Surface(document["surface"])
    for c in document["collars"]:
        c["core"] = surface.inverse_word(c["core"])
    return document


@disguise()
def enclosures_made_wide():
    """The lengths of cores are enclosed by the wide but true interval from 0 to 0.3."""
    return collars((0, "length", [0, 0.3]), (1, "length", [0, 0.3]))


@disguise()
def eigenvalues_said_in_other_words():
    """Counts in another order and twice, a weaker one among them; sides and vertices eliminated in other orders."""
    document = eigenvalues()
    weak = {**document["at_most"][1], "count": 7}
    document["at_most"] = document["at_most"][::-1] + [weak] + document["at_most"][:2]
    document["at_least"] = document["at_least"][::-1] + document["at_least"]
    document["side_order"].reverse()
    document["vertex_order"] = document["vertex_order"][::-1]
    return document


@disguise()
def eigenvalues_claimed_in_less():
    """An interval from 0 on, one that contains others, a single point that counts nothing: all is claimed of less."""
    document = eigenvalues()
    (first, second, third) = document["eigenvalues"]
    document["eigenvalues"] = [{"in": [0, first["in"][1]], "count": 1},
                               {"in": [second["in"][0], third["in"][1]], "count": 4}]
    return with_(document, next=0)


@disguise()
def eigenvalues_of_which_nothing_is_said():
    """No interval, no count, and all eigenvalues are at least 0; halvings of nothing."""
    return with_(eigenvalues(), eigenvalues=[], next=0, at_most=[], at_least=[], side_order=[], vertex_order=[],
                 halvings=12)


@disguise()
def eigenfunction_in_other_words():
    """Coefficients −2⁵⁰⁰ times as large."""
    (function,) = functions_of(one_function())
    return one_function(functions=[[-math.ldexp(c, 500) for c in function]])


@disguise()
def isometries_in_other_words():
    """Another lift of the involution, which is listed twice; all paths begin with a loop, so that other elements generate."""
    document = isometries()

    def conjugated(loop, word):
        return loop + word + [(s + 4) % 8 for s in reversed(loop)]

    loop = document["pair"][0]
    (row,) = document["isometries"]
    x, y, *others = row["images"]
    images = [conjugated(loop, word) for word in [x, y, *(conjugated(x, word) for word in others)]]
    document["isometries"] = [{**row, "images": images}] * 2
    document["paths"] = [loop + path for path in document["paths"]]
    return document


@disguise()
def isometric_in_other_words():
    """Another lift of the isometry of an octagon to its mirror image."""
    document = comparison()
    loop = document["images"][0]
    turned = [loop + word + [(s + 4) % 8 for s in reversed(loop)] for word in document["images"]]
    return with_(document, images=turned)


@disguise()
def different_though_isospectral():
    """Two covers with the same closed geodesics, which cross otherwise; the other one comes first."""
    document = comparison("sunada")
    other = document["other_spectrum"]
    first = {key: document[key] for key in ("net", "up_to", "geodesics", "clusters")}
    document["other_spectrum"] = {**other, **first}
    return {**document, **{key: other[key] for key in first}}


@disguise()
def pants_with_twists_by_lengths_more():
    """Twists plus five lengths, minus a thousand, and in an interval longer than the length."""
    rows = pants()["cuffs"]
    return pants_with({0: {"twist": plus(rows[0]["twist"], rows[0]["length"], 5)},
                       1: {"twist": plus(rows[1]["twist"], rows[1]["length"], -1000)}, 2: {"twist": [-7e300, 3]}})


@disguise()
def pants_with_paths_around_cuffs():
    """Paths across turn around the cuff three times before, and once the other way behind."""
    document = pants()
    for row in document["cuffs"]:
        around, other = (path_of_cuff(document, end) for end in row["ends"])
        row["across"] = around * 3 + row["across"] + other
    return document


@disguise()
def pants_with_ends_exchanged():
    """The ends of every cuff exchanged, with the path across backwards; cuffs in another order."""
    document = pants("fenchel-nielsen-2")
    for row in document["cuffs"]:
        row["ends"].reverse()
        row["across"] = backwards(document, row["across"])
    document["cuffs"].reverse()
    return document


@disguise()
def pants_in_words_that_cancel():
    """Letters there and back in all paths, and relators around the corner of the octagon."""
    document = pants()
    document["pants"] = [[[3, 7] + RELATOR + path + [5, 1] for path in paths] for paths in document["pants"]]
    for row in document["cuffs"]:
        row["across"] = [0, 4, 1, 5] * 10 + row["across"] + inverse(RELATOR)
    return document


@disguise()
def pants_from_another_tile():
    """The paths of a pair of pants begin in the other tile, those of the other one go around before."""
    document = with_pants_conjugated(pants("fenchel-nielsen-2"), 0, [4])
    return with_pants_conjugated(document, 1, [7, 10, 9, 9])


@disguise()
def pants_with_cuffs_numbered_otherwise():
    """Cuffs 1 and 2 of a pair of pants are its cuffs 0 and 1: the marks are the same. Pairs of pants exchanged."""
    document = pants()
    document["pants"][0] = [path_of_cuff(document, [0, k]) for k in (1, 2)]
    for end, _, _ in ends_of(document):
        if end[0] == 0:
            end[1] = (end[1] + 2) % 3
        end[0] = 1 - end[0]
    document["pants"].reverse()
    return document


@disguise()
def pants_with_the_cuffs_of_both_numbered_the_other_way():
    """Cuffs 0 and 1 exchanged in both pairs of pants: all marks are on the other sides of the cuffs."""
    return with_pants_mirrored(with_pants_mirrored(pants(), 0), 1)


@disguise()
def pants_with_cuffs_0_and_1_braided():
    """The paths αβα⁻¹ and α for α and β: cuffs 0 and 1 of both pairs of pants exchanged, and the third path is the same."""
    document = pants("fenchel-nielsen-2")
    for p, (first, second) in enumerate(document["pants"]):
        for end, row, place in ends_of(document):
            if end[0] == p and end[1] < 2:
                if end[1] == 1:
                    going_first(document, row, place, first)
                end[1] = 1 - end[1]
        document["pants"][p] = [first + second + backwards(document, first), first]
    return document


@disguise()
def pants_of_which_little_is_said():
    """Lengths are positive, twists are any, exact lengths are not stated."""
    document = pants("cuff-1e-12")
    for row in document["cuffs"]:
        row.update(length=[5e-324, sys.float_info.max], twist=[-sys.float_info.max, sys.float_info.max],
                   exp_half_length="0")
    return document


@disguise()
def pants_with_a_twist_around_0():
    """Twists that are exactly 0, within 2⁻¹⁰⁷⁴."""
    return pants_with({i: {"twist": [-5e-324, 5e-324]} for i in (0, 1)}, "bolza")


# ---- Asking the programs -----------------------------------------------------------------------------------------


def contents(name):
    made = entries[name].make()
    return made if isinstance(made, bytes) else text(made)


def agrees(line, expected):
    """certify names the file between MALFORMED and the place."""
    line = re.sub(r'^MALFORMED: "[^"]*": ', "MALFORMED: ", line)
    return (line + ": ").startswith(expected + ": ")


def run(program, path, *options):
    """Exit code and lines of output."""
    done = subprocess.run([program, *options, path], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300)
    # What certify-exact quotes may have a line feed in it.
    output = re.sub(r"(?s)^MALFORMED: .*", lambda match: match[0].replace("\n", " "),
                    done.stdout.decode("utf-8", "replace").rstrip("\n"))
    return done.returncode, output.split("\n")


def problems_of(name, certify, exact, folder, largest):
    """None if the file has more bytes than `largest`."""
    entry = entries[name]
    path = os.path.join(folder, name + ".json")
    made = contents(name)
    if len(made) > largest:
        return None
    with open(path, "wb") as file:
        file.write(made)
    problems = []
    code, lines = run(certify, path, "--threads", "1")
    # What certify-exact says, where certify asks it: the answer is the same, and is wanted once.
    asked = [line for line in lines if line.startswith("second checker: ") and ": not asked" not in line]
    if asked:
        exact_lines = [asked[0].removeprefix("second checker: ")]
        exact_code = CODES[exact_lines[0].split(":")[0]]
    else:
        exact_code, exact_lines = run(exact, path)
    for program, code, lines, expected in ((certify, code, lines, entry.certify), (exact, exact_code, exact_lines, entry.exact)):
        last = lines[-1]
        if not agrees(last, expected):
            problems.append(f"{name}: {os.path.basename(program)} says '{last[:200]}', expected '{expected}'")
        elif code != CODES[last.split(":")[0]]:
            problems.append(f"{name}: {os.path.basename(program)} has the exit code {code} with '{last[:200]}'")
        if not expected.startswith("UNDECIDED") and not re.search(entry.says, last):
            problems.append(f"{name}: {os.path.basename(program)} says '{last[:200]}', expected '{entry.says}'")
        if program == certify and not problems:
            rules = {line.split(":")[0] for line in lines[:-1] if re.match(r"[a-z]+: REFUTED", line)}
            rule = entry.certify.split(": ")[-1]
            if entry.certify.startswith("REFUTED") and rule not in rules:
                problems.append(f"{name}: the first checker does not refute it by {rule}")
            more = rules - entry.also - {rule}
            if more:
                problems.append(f"{name}: also refuted by {', '.join(sorted(more))}")
    os.remove(path)
    return problems


def check(certify, exact, names, largest):
    """How many files were asked about, and what is wrong."""
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as pool:
        found = list(pool.map(lambda name: problems_of(name, certify, exact, folder, largest), names))
    asked = [problems for problems in found if problems is not None]
    return len(asked), sum(asked, [])


# ---- The list ----------------------------------------------------------------------------------------------------

GROUPS = {
    "text": "The text", "numbers": "Numbers", "structure": "Structure", "surface": "Rule `surface`",
    "map": "Rule `map`", "gluing": "Rule `gluing`", "orientation": "Rule `orientation`",
    "delaunay": "Rule `delaunay`", "covering": "Rule `covering`", "packing": "Rule `packing`",
    "collars": "Pseudo nets", "geodesics": "Closed geodesics", "eigenvalues": "Eigenvalues",
    "isometries": "Isometries", "comparisons": "Two surfaces", "curves": "Closed curves", "pants": "Pants decompositions",
    "distances": "Distances", "bounds": "Diameter, radius, embedded disk", "disguises": "Disguises"}


def tables():
    lines = []
    for key, title in GROUPS.items():
        lines += [f"### {title}", "", "| file | idea | `certify` | `certify-exact` |", "| --- | --- | --- | --- |"]
        for entry in entries.values():
            if entry.group == key:
                exact = "not for this checker" if entry.exact == LEFT else entry.exact
                certify = entry.certify.rstrip("[")
                lines.append(f"| `{entry.name}` | {entry.idea.replace('|', chr(92) + '|')} | {certify} | {exact} |")
        lines.append("")
    return "\n".join(lines + [total()])


def total():
    disguises = sum(entry.group == "disguises" for entry in entries.values())
    return f"{len(entries) - disguises} forgeries and {disguises} disguises"


def main():
    command, *arguments = sys.argv[1:] or ["--help"]
    largest = sys.maxsize
    if command == "check" and arguments[:1] == ["--small"]:
        largest = 100_000
        del arguments[0]
    names = arguments[2:] if command == "check" else arguments if command == "write" else []
    for name in names:
        if name not in entries:
            sys.exit(f"forgeries.py: no file '{name}'; 'list' says which there are")
    if command == "check" and len(arguments) >= 2:
        asked, problems = check(*arguments[:2], arguments[2:] or list(entries), largest)
        print("\n".join(problems + [f"{asked} files, {len(problems)} problems"]))
        sys.exit(1 if problems else 0)
    if command == "write" and len(arguments) == 1:
        sys.stdout.buffer.write(contents(arguments[0]))
    elif command == "write-all" and len(arguments) == 1:
        for name in entries:
            with open(os.path.join(arguments[0], name + ".json"), "wb") as file:
                file.write(contents(name))
    elif command == "list":
        print(tables())
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
