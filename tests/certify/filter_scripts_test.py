#!/usr/bin/env python3
"""filter_scripts_test.py ROOT: the Gappa scripts in certify/net/filter/ are about the functions in certify/net/filter.cpp.

What a function computes is expanded to its arguments, and so is what its script computes: both must be the same tree of
operations. The exact values of a script, in capitals, must be the same trees as the rounded ones. Constants that the
code compares with must be twice what is proved of the errors, and scripts may assume only what others prove. What they
assume and prove is here once more, so that nobody proves something else by mistake.
"""

import ast
import pathlib
import re
import sys

BINARY = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
COMPARED = {ast.Gt: ">", ast.Lt: "<"}

GOALS = {
    "circumradius":
        r"x in [1b-214, 2] /\ y in [1b-214, 2] /\ z in [1b-214, 2] /\ greatest in [1, 2] /\ "
        r"|d0 -/ D0| <= 1b-46 /\ |d1 -/ D1| <= 1b-46 /\ |d2 -/ D2| <= 1b-46 /\ |a0 -/ A0| <= 1b-38 /\ "
        r"|a1 -/ A1| <= 1b-38 /\ |a2 -/ A2| <= 1b-38 -> |x -/ X| <= 1b-37 /\ |y -/ Y| <= 1b-37 /\ "
        r"|z -/ Z| <= 1b-37 /\ |k - K| <= 1b-30 /\ error >= 1b-29",
    "circumradius_quotient":
        r"d0 in [1b-200, 8] /\ d1 in [1b-200, 8] /\ d2 in [1b-200, 8] /\ |d0 -/ D0| <= 1b-46 /\ "
        r"|d1 -/ D1| <= 1b-46 /\ |d2 -/ D2| <= 1b-46 /\ k + error in [1b-436, 1b10] /\ "
        r"k - error in [1b-436, 1b10] -> |least -/ LEAST| <= 1b-40 /\ |most -/ MOST| <= 1b-40 /\ "
        r"lower / LEAST <= 1 /\ upper / MOST >= 1",
    "counterclockwise":
        r"|sx| <= 2 /\ |sy| <= 2 /\ |vx| <= 2 /\ |vy| <= 2 /\ |p| <= 1 /\ |q| <= 1 /\ |p1| <= 1 /\ "
        r"|q1| <= 1 /\ |p2| <= 1 /\ |q2| <= 1 /\ ns in [1, 2] /\ nv in [1, 2] -> "
        r"|determinant - DETERMINANT| <= 1b-43 /\ bound >= 1b-23",
    "delaunay":
        r"|ax| <= 2 /\ |ay| <= 2 /\ |bx| <= 2 /\ |by| <= 2 /\ |cx| <= 2 /\ |cy| <= 2 /\ |dx| <= 2 /\ "
        r"|dy| <= 2 /\ na in [1, 2] /\ nb in [1, 2] /\ nc in [1, 2] /\ nd in [1, 2] -> "
        r"|value - VALUE| <= 1b-42 /\ bound <= -1b-16",
    "gap":
        r"|p| <= 1 /\ |q| <= 1 -> |gap - GAP| <= 1b-51 /\ (gap >= 1b-12 -> |gap -/ GAP| <= 1b-38)",
    "squared_distance":
        r"|sx| in [1, 2] /\ |sy| <= 2 -> |squared - SQUARED| <= 1b-47 /\ |squared -/ SQUARED| <= 1b-46",
    "squared_half_sinh":
        r"d in [1b-200, 8] /\ a in [1b-12, 1] /\ b in [1b-12, 1] /\ |d -/ D| <= 1b-46 /\ |a -/ A| <= 1b-38 /\ "
        r"|b -/ B| <= 1b-38 -> |quotient -/ QUOTIENT| <= 1b-36 /\ lower / QUOTIENT <= 1 /\ "
        r"upper / QUOTIENT >= 1",
}
ARGUMENTS = {"counterclockwise": "z0 z1 z2", "delaunay": "z0 z1 z2 z3", "squared_distance": "p q", "gap": "z",
             "squared_half_sinh": "d a b", "squared_sinh_of_circumradius": "d a"}
# By how much points that were moved change what is compared, as a power of two (Lemma 30.2).
MOVED = {"counterclockwise": -24, "delaunay": -16.9}


class Different(Exception):
    pass


def same(what, found, expected):
    if found != expected:
        raise Different(f"{what}:\n  {found}\n  {expected}")


def python(text):
    """An expression of C++ or Gappa as one of Python; 0x1p-9 and 1b-9 become power(-9)."""
    text = text.replace("&&", "and").replace("std::numeric_limits<double>::infinity()", "infinity")
    text = re.sub(r"\b(?:0x1p|1b)(-?\d+)", r"power(\1)", re.sub(r"\s+", " ", text).strip())
    return re.sub(r"^\{(.*)\}$", r"(\1)", text)


class Expander:
    """Expressions as trees of operations, whose leaves are numbers and the names that stand for themselves."""

    def __init__(self, values, functions=None):
        self.values, self.functions = dict(values), functions or {}

    def tree(self, text):
        return self.of(ast.parse(python(text), mode="eval").body)

    def of(self, node):
        if isinstance(node, ast.Constant):
            return str(node.value)
        if isinstance(node, ast.Name):
            if node.id not in self.values:
                raise Different(f"{node.id} is not known")
            return self.values[node.id]
        if isinstance(node, ast.Attribute):
            return self.of(node.value)["xy".index(node.attr)]
        if isinstance(node, ast.Subscript):
            return self.of(node.value)[node.slice.value]
        if isinstance(node, ast.Tuple):
            return tuple(map(self.of, node.elts))
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return ("-", self.of(node.operand))
        if isinstance(node, ast.BinOp):
            return (BINARY[type(node.op)], self.of(node.left), self.of(node.right))
        if isinstance(node, ast.Compare) and len(node.ops) == 1:
            return (COMPARED[type(node.ops[0])], self.of(node.left), self.of(node.comparators[0]))
        if isinstance(node, ast.BoolOp) and isinstance(node.op, ast.And):
            return ("and", *map(self.of, node.values))
        if isinstance(node, ast.Call) and node.func.id == "select":
            return ("if", *map(self.of, node.args))
        if isinstance(node, ast.Call) and node.func.id == "power":
            return "2^" + ast.unparse(node.args[0])
        if isinstance(node, ast.Call) and node.func.id == "norm":
            return "norm of " + ast.unparse(node.args[0])
        if isinstance(node, ast.Call) and node.func.id in self.functions:
            names, body = self.functions[node.func.id]
            return Expander(dict(zip(names, map(self.of, node.args))), self.functions).tree(body)
        raise Different("not understood: " + ast.unparse(node))


class Code:
    """certify/net/filter.cpp: its constants, its helpers, and the functions."""

    def __init__(self, text):
        text = re.sub(r"//.*", "", text)
        self.functions, self.bodies, self.arguments = {}, {}, {}
        for name, arguments, body in re.findall(r"^(?:inline )?\w+ (\w+)\(([^)]*)\) \{(.*?)\}$", text, re.M | re.S):
            self.bodies[name] = body
            self.arguments[name] = re.findall(r"[& ](\w+)(?=,|$)", arguments)
            returned = re.fullmatch(r"\s*return (.*);\s*", body, re.S)
            if returned:
                self.functions[name] = self.arguments[name], returned[1]
        same("minus", self.functions["minus"], (["p", "q"], "{p.x - q.x, p.y - q.y}"))
        same("norm", self.functions["norm"], (["z"], "max(abs(z.x), abs(z.y))"))
        constants = Expander({})
        self.constants = {name: constants.tree(value)
                          for name, value in re.findall(r"constexpr double (\w+) = (.*?);", text)}

    def expand(self, name, leaves):
        """Its local variables and its `return` in terms of the leaves; the texts of leaves."""
        same(f"arguments of {name}", self.arguments[name], ARGUMENTS[name].split())
        body = self.bodies[name]
        expander = Expander({**self.constants, **leaves}, self.functions)
        texts = {}
        for local, value in re.findall(r"const (?:Lanes|Points|Mask) (\w+) = (.*?);", body, re.S):
            if local in leaves:
                texts[local] = value
            else:
                expander.values[local] = expander.tree(value)
        returns = re.findall(r"return (.*?);", body, re.S)
        same(f"ways out of {name}", len(returns), 1)
        return expander.values, expander.tree(returns[0]), texts


class Script:
    """A Gappa script: its values, rounded in lower case and exact in capitals, and what it proves of them."""

    def __init__(self, name, text):
        self.name = name
        self.comments = dict(re.findall(r"^(\w)x = .*# (.*)$", text, re.M))
        text = re.sub(r"#.*", "", text)
        statements, goal = re.match(r"([^{]*)\{([^}]*)\}", text).groups()
        same("what is assumed and proved", re.sub(r"\s+", " ", goal).strip(), GOALS[name])
        self.given, self.proved = goal.split("->", 1)
        same("rounding", re.findall(r"@\w+ = [^;]*", statements), ["@fl = float<ieee_64, ne>"])
        self.values = {}
        for name, value in re.findall(r"(?<!@)\b(\w+) (?:fl)?= ([^;]*);", statements):
            leaf = re.fullmatch(r"fl\((\w+)\)", value)
            if leaf:
                # sx = fl(SX), d0 = fl(dd0), error = fl(ee).
                same("what is rounded", leaf[1] in (name.upper(), name[0] * 2 + re.sub(r"\D", "", name)), True)
                self.values[name] = name
                continue
            words = re.findall(r"\b[A-Za-z]\w*", value)
            self.values[name] = Expander({word: self.values.get(word, word.lower()) for word in words}).tree(value)
            if name.isupper():
                same(f"{name} is not what {name.lower()} rounds", self.values[name], self.values[name.lower()])

    def bound(self, of):
        """The exponent in what is proved, "OF <= 1bEXPONENT" or with >=."""
        found = re.search(re.escape(of) + r" [<>]= -?1b(-?\d+)", self.proved)
        if not found:
            raise Different(f"nothing is proved of {of}")
        return int(found[1])


def points(*names):
    return {name: (name + "x", name + "y") for name in names}


def compared(code, script, texts, returned, names):
    """What is compared, after the norms of all points, which are the differences that the script says."""
    for name in names:
        same(f"what {name} is", texts[name], script.comments[name])
    norms = [(">", f"norm of {name}", code.constants["kLeastNorm"]) for name in names]
    same("norms that are asked", returned[:-1], ("and", *norms))
    return returned[-1]


def with_norms(tree, names):
    """The tree with the norms, which the script calls nNAME, as in the code."""
    if isinstance(tree, tuple):
        return tuple(with_norms(part, names) for part in tree)
    return "norm of " + tree[1] if re.fullmatch(f"n[{names}]", tree) else tree


def bounded(script, of):
    """The bound is more than the errors by rounding and by labels together."""
    errors = 2.0 ** script.bound(f"|{of} - {of.upper()}|") + 2.0 ** MOVED[script.name]
    same("errors below the bound", errors < 2.0 ** script.bound("bound"), True)


def counterclockwise(code, scripts):
    script = scripts["counterclockwise"]
    z = {"z0": ("p", "q"), "z1": ("p1", "q1"), "z2": ("p2", "q2")}
    _, returned, texts = code.expand("counterclockwise", {**points("s", "v"), **z})
    same("comparison", compared(code, script, texts, returned, "sv"),
         (">", script.values["determinant"], with_norms(script.values["bound"], "sv")))
    bounded(script, "determinant")


def delaunay(code, scripts):
    script = scripts["delaunay"]
    _, returned, texts = code.expand("delaunay", points("a", "b", "c", "d"))
    same("comparison", compared(code, script, texts, returned, "abcd"),
         ("<", script.values["value"], with_norms(script.values["bound"], "abcd")))
    bounded(script, "value")


def measures(code, scripts):
    distance, gap, quotient = (scripts[name] for name in ("squared_distance", "gap", "squared_half_sinh"))
    _, returned, texts = code.expand("squared_distance", points("s"))
    same("what s is", texts["s"], "minus(p, q)")
    same("squared_distance", returned, (distance.values["squared"], (">", "norm of s", code.constants["kLeastNorm"])))
    _, returned, _ = code.expand("gap", {"z": ("p", "q")})
    least = code.constants["kLeastGap"]
    same("gap", returned, ("if", (">", gap.values["gap"], least), gap.values["gap"], "0"))
    same("least gap", least, f"2^{gap.bound('gap')}")
    leaves = {name: name for name in "dab"}
    _, returned, _ = code.expand("squared_half_sinh", leaves)
    same("squared_half_sinh", returned, (quotient.values["lower"], quotient.values["upper"]))


def circumradius(code, scripts):
    script, quotient = scripts["circumradius"], scripts["circumradius_quotient"]
    leaves = {"d": ("d0", "d1", "d2"), "a": ("a0", "a1", "a2"), "greatest": "greatest", "certain": "certain",
              "infinity": "infinity"}
    values, _, texts = code.expand("squared_sinh_of_circumradius", leaves)
    same("no flat triangle", texts["certain"], "k > 0x1p-4 * (greatest * greatest)")
    same("greatest", texts["greatest"], "max(max(x, y), z)")
    for name in ("x", "y", "z", "k", "error"):
        same(name, values[name], script.values[name])
    _, returned, _ = code.expand("squared_sinh_of_circumradius", {**leaves, "k": "k", "error": "error"})
    same("quotients", returned, (("if", "certain", quotient.values["lower"], "0"),
                                 ("if", "certain", quotient.values["upper"], "infinity")))
    same("half of the error", script.bound("|k - K|") + 1, script.bound("error"))


def assumptions(code, scripts):
    """Scripts assume of distances and gaps what others prove of them."""
    proved = {"d": scripts["squared_distance"].bound("|squared -/ SQUARED|"), "a": scripts["gap"].bound("|gap -/ GAP|")}
    proved["b"] = proved["a"]
    same("least norm", code.constants["kLeastNorm"], "2^-100")
    for name, script in scripts.items():
        for letter, digit, exponent in re.findall(r"\|([dab])(\d?) -/ [DAB]\d?\| <= 1b(-\d+)", script.given):
            same(f"{name}: accuracy of {letter}{digit}", int(exponent), proved[letter])
        for exponent in re.findall(r"\bd\d? in \[1b(-\d+)", script.given):
            same(f"{name}: least squared distance", int(exponent), -200)
        for exponent in re.findall(r"\b[ab] in \[1b(-\d+)", script.given):
            same(f"{name}: least gap", f"2^{exponent}", code.constants["kLeastGap"])


def main(root):
    folder = root / "certify" / "net" / "filter"
    problems = []
    code = Code((root / "certify" / "net" / "filter.cpp").read_text(encoding="utf-8"))
    scripts = {}
    for path in sorted(folder.glob("*.g")):
        try:
            scripts[path.stem] = Script(path.stem, path.read_text(encoding="utf-8"))
        except Different as difference:
            problems.append(f"{path.name}: {difference}")
    for check in (counterclockwise, delaunay, measures, circumradius, assumptions):
        try:
            check(code, scripts)
        except (Different, KeyError) as difference:
            problems.append(f"{check.__name__}: {difference}")
    print("\n".join(problems) if problems else f"{len(scripts)} scripts are about the code")
    return bool(problems)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
