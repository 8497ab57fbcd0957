#!/usr/bin/env python3
"""Mutants of the checkers: a copy of every source of certify/ that contains all single changes; one is chosen at run time.

mutate.py SOURCE TARGET [CLANG++]: writes to TARGET/certify a copy of SOURCE/certify in which each place that can be
    changed calls `mutant::at(number)` to learn whether it is to be changed, and writes the list of all changes to
    TARGET/mutants.json.

Places are found in clang's syntax tree, which tells expressions, conditions and statements apart; their replacements
are built from the text of the source. One change of a place is one mutant:

  comparison   < <= > >= == != to the negation and to the neighbours; of three-valued answers `unknown` read as an answer
  logic        && to || and back; each operand alone; ! dropped
  condition    of if and ?: and of a returned bool forced to true and to false; of a loop to false
  arithmetic   + and -, * and /, += and -=, shifts exchanged; a remainder or a unary minus dropped
  term         a sum, a difference, or `both` and `either` of answers, without one of the two
  factor       a product without one of the two, a quotient undivided; a square, a double or a half of a number
  argument     of a call, for another one of the same type
  centre       of an interval or a ball, for the whole of it
  constant     literals and named constants: plus and minus 1, doubled, halved; bool literals; enumerators
  bound        a loop ends one step early, or omits the first or the last of a range; a parallel loop likewise
  first        of a range or of a loop's steps, and of what all_of, any_of and none_of ask, for all
  call         exchanged for its counterpart: bounds from below and above, rounding directions, sinh and cosh, ...
  dropped      a statement that is a call or an assignment

What does not compile is left out, by trial. Code that cannot affect a verdict is left out as well: messages, counts, the account of work, the bits of balls (the inclusion
principle holds for any number of bits), the writer, the programs.
"""
import concurrent.futures
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

# The writers of text, and the account of work: of the verdicts only UNDECIDED depends on them.
LEFT_OUT = ("certify/program/", "certify/exact/main.cpp", "certify/file/writer.", "certify/verdict/report.",
            "certify/numbers/budget.h")
# In these files texts are more than messages.
TEXT_MATTERS = ("certify/exact/json.", "certify/base/text.", "certify/file/json.", "certify/file/document_reader.")
# Functions that prepare a file's text for display in a message.
SHOWN = re.compile(r"^(in_quotes|path_in_quotes|printable(_length)?|display_name)$")
# Statements that only free or reserve memory, or count work.
NO_EFFECT = re.compile(r"(_clear|_init|^reserve|^shrink_to_fit|^spend\w*|^progress\w*|^flint_cleanup|^report_progress|^used)$")
# Counts, and estimates of work or memory: a change can only turn a decided verdict into UNDECIDED.
COUNTED = re.compile(r"(^|[.>_])(max_precision|bits_used_|counts\.\w+|triangles_beyond_64_bits|threads_?|identities)$")
ESTIMATES = re.compile(r"^spend|_work$|^work_|(^|_)bits$|^progress|_is_feasible$|^max_exact_bits|^least_bytes$|^digits$")
# Infinity plus one is still infinity. Bits of a ball: the inclusion principle holds for any precision, and a lower one only leaves more undecided.
PRECISIONS = re.compile(r"^k(Infinity|\w*Precision|\w*Bits|ExactFrom\w*)$")

NEIGHBOURS = {"<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",)}
SWAPS = {"+": "-", "-": "+", "*": "/", "/": "*", "<<": ">>", ">>": "<<", "&": "|", "|": "&", "^": "&",
         "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=", "<<=": ">>=", ">>=": "<<=", "|=": "&=", "&=": "|="}
PAIRS = [("arb_get_lbound_arf", "arb_get_ubound_arf"), ("ARF_RND_FLOOR", "ARF_RND_CEIL"), ("arb_lt", "arb_le"),
         ("arb_gt", "arb_ge"), ("arb_min", "arb_max"), ("arb_is_positive", "arb_is_nonnegative"),
         ("arb_is_negative", "arb_is_nonpositive"), ("arb_add", "arb_sub"), ("arb_mul", "arb_div"),
         ("arb_addmul", "arb_submul"), ("arb_sinh", "arb_cosh"), ("arb_cosh", "arb_sinh"), ("arb_tanh", "arb_sinh"),
         ("arb_sinh", "arb_tanh"), ("arb_asinh", "arb_acosh"), ("arb_add_ui", "arb_sub_ui"), ("arb_sin", "arb_cos"),
         ("arb_mul_ui", "arb_div_ui"), ("arb_mul_si", "arb_div_si"), ("arb_add_si", "arb_sub_si"),
         ("arb_tan", "arb_sin"), ("arb_atanh", "arb_asinh"), ("arb_overlaps", "arb_contains"),
         ("acb_add", "acb_sub"), ("acb_mul", "acb_div"), ("acb_realref", "acb_imagref"), ("re", "im"),
         ("certainly_positive", "certainly_negative"), ("below", "above"), ("lower", "upper"), ("min", "max"),
         ("next_dart", "previous_dart"), ("next", "previous"), ("front", "back"), ("begin", "end"), ("x", "y"), ("a", "b"),
         ("n", "d"), ("start", "end"), ("numerator", "denominator"), ("all_of", "any_of"), ("any_of", "all_of"),
         ("none_of", "any_of"), ("lower_bound", "upper_bound"), ("floor", "ceil"), ("sinh", "cosh"), ("sinh", "tanh"),
         ("tanh", "sinh"), ("cosh", "sinh"), ("arb_sqrt", "arb_set_round"), ("mpz_fdiv_q", "mpz_cdiv_q"),
         ("mpz_fdiv_q_2exp", "mpz_cdiv_q_2exp"), ("first", "second"), ("twice_real", "twice_imaginary"),
         ("arb_sqr", "arb_set_round"), ("arb_is_finite", "arb_is_exact"), ("arb_nonnegative_part", "arb_set"),
         ("arb_sqrtpos", "arb_sqrt"), ("mpz_gcd", "mpz_lcm"), ("min_element", "max_element")]
MEMBERS = {"start", "end", "begin", "next", "previous", "x", "y", "a", "b", "n", "d", "lower", "upper", "first", "second", "re",
           "im", "numerator", "denominator", "front", "back"}
COUNTERPARTS = {}
for left, right in PAIRS:
    for name, other in ((left, right), (right, left)):
        if other not in COUNTERPARTS.setdefault(name, []):
            COUNTERPARTS[name].append(other)
# Functions of one number that are factors of it, or its powers.
FACTORS = re.compile(r"^(sqr|square|twice|half|scaled)$")
# Answers of two questions.
JOINT = ("both", "either")
RANGES = ("all_of", "any_of", "none_of")
ENUMERATORS = {"Tri": ("no", "yes", "unknown"), "Verdict": ("verified", "refuted", "undecided")}
WORDS = {"Tri": "unknown", "Verdict": "undecided"}
# The name of a file that is none, in the trial.
TRIAL = "mutant"


class Tree:
    """The changes of one file."""

    def __init__(self, path, text):
        self.path, self.text = path, text  # Bytes, as offsets count bytes.
        self.changes = {}   # (begin, end): {replacement: (kind, what)}
        self.wraps = {}     # (begin, end): [(kind, what, form)]
        self.functions = {}
        self.undivided = set()

    def get(self, span):
        return self.text[span[0]:span[1]].decode()


def balanced(text):
    depth = []
    for c in re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])*\'', "", text):
        if c in "([{":
            depth.append(c)
        elif c in ")]}":
            if not depth or depth.pop() + c not in ("()", "[]", "{}"):
                return False
    return not depth


class Reader:
    def __init__(self, source, trees):
        self.source, self.trees = source, trees
        self.file = None
        self.constants = set()
        self.siblings = {}
        self.function = ""
        self.call = None
        self.returns = ""
        self.in_template = False

    # -- locations: clang writes a file name only where it differs from that of the previous location.
    def plain(self, place):
        if "file" in place:
            self.file = place["file"]
        if "offset" in place:
            place["_file"] = self.file

    def visit_locations(self, node):
        for key in ("loc", "range"):
            value = node.get(key)
            if not isinstance(value, dict):
                continue
            for place in ([value] if key == "loc" else [value.get("begin", {}), value.get("end", {})]):
                if "spellingLoc" in place:
                    self.plain(place["spellingLoc"])
                    self.plain(place["expansionLoc"])
                else:
                    self.plain(place)
        for child in self.kids(node):
            self.visit_locations(child)

    def span(self, node):
        """Returns (tree, begin, end), or None if the node is not in a file of certify/ or lies inside a macro."""
        ends = []
        for key in ("begin", "end"):
            place = node.get("range", {}).get(key, {})
            macro = "spellingLoc" in place
            if macro:
                if place["spellingLoc"].get("_file") == place["expansionLoc"].get("_file") and place["expansionLoc"].get("isMacroArgExpansion"):
                    place = place["spellingLoc"]
                    macro = False
                else:
                    place = place["expansionLoc"]
            if "offset" not in place or place.get("_file") is None:
                return None
            ends.append((place["_file"], place["offset"], place["tokLen"], macro))
        if ends[0][0] != ends[1][0]:
            return None
        path = os.path.relpath(os.path.join(self.source, ends[0][0]), self.source)
        if path not in self.trees:
            return None
        tree = self.trees[path]
        begin, end = ends[0][1], ends[1][1] + ends[1][2]
        if ends[0][3] and ends[1][3] and node["kind"] not in ("CallExpr",):
            if ends[0][1] == ends[1][1]:
                return None  # The whole is made by a macro.
        if ends[1][3]:
            rest = tree.text[end:]
            gap = len(rest) - len(rest.lstrip())
            if rest[gap:gap + 1] == b"(":
                depth, at = 0, end + gap
                while True:
                    depth += {b"(": 1, b")": -1}.get(tree.text[at:at + 1], 0)
                    at += 1
                    if depth == 0:
                        break
                end = at
        if begin >= end or not balanced(tree.text[begin:end].decode()):
            return None
        return tree, (begin, end)

    def text(self, node):
        where = self.span(node)
        return None if where is None else where[0].get(where[1])

    # -- what is changed
    def change(self, node, kind, replacement, same_type=True):
        where = self.span(node)
        if where is None or replacement is None or not self.function:
            return
        tree, span = where
        if replacement == tree.get(span):
            return
        if not same_type:
            replacement = f"mutant::value({replacement})"
        tree.changes.setdefault(span, {}).setdefault(replacement, (kind, same_type))
        tree.functions[span] = self.function

    def wrap(self, node, kind, form, what):
        where = self.span(node)
        if where is None or not self.function:
            return
        tree, span = where
        entry = (kind, what, form)
        if entry not in tree.wraps.setdefault(span, []):
            tree.wraps[span].append(entry)
        tree.functions[span] = self.function

    @staticmethod
    def kids(node):
        return [k for k in node.get("inner", []) if isinstance(k, dict)]

    @staticmethod
    def type_of(node):
        return node.get("type", {}).get("desugaredQualType") or node.get("type", {}).get("qualType", "")

    def explicit(self, node):
        """Returns the node without the implicit nodes around it, which are not in the text."""
        while node.get("kind") in ("ImplicitCastExpr", "ExprWithCleanups", "MaterializeTemporaryExpr", "CXXBindTemporaryExpr",
                                   "ConstantExpr", "FullExpr") and self.kids(node):
            node = self.kids(node)[0]
        return node

    def is_text(self, node):
        t = self.type_of(node).replace("const ", "")
        return t.startswith(("std::basic_string<", "std::string", "std::__cxx11::basic_string", "basic_string<", "std::__cxx11::basic_ostr"))

    def callee(self, node):
        """The name that a call calls."""
        kids = self.kids(node)
        if not kids:
            return "", None
        f = self.explicit(kids[0])
        if f["kind"] == "ParenExpr":
            f = self.explicit(self.kids(f)[0])
        if f["kind"] == "DeclRefExpr":
            return f.get("referencedDecl", {}).get("name", ""), f
        if f["kind"] in ("MemberExpr", "CXXDependentScopeMemberExpr"):
            return f.get("name", f.get("member", "")).lstrip("->."), f
        return f.get("name", ""), f

    def condition(self, node, force=("true", "false")):
        t = self.text(node)
        if t is None or t in ("true", "false"):
            return
        for value in force:
            self.change(node, "condition", value)

    def binary(self, node, left, right):
        a, b = self.span(left), self.span(right)
        whole = self.span(node)
        if a is None or b is None or whole is None or a[0] is not whole[0] or b[0] is not whole[0]:
            return None
        tree = whole[0]
        if whole[1][0] != a[1][0] or whole[1][1] != b[1][1] or a[1][1] > b[1][0]:
            return None
        operator = re.sub(r"//[^\n]*\n|/\*.*?\*/", "", tree.get((a[1][1], b[1][0]))).strip()
        x, y = tree.get(a[1]), tree.get(b[1])
        kind = self.type_of(node)
        builtin = node["kind"] in ("BinaryOperator", "CompoundAssignOperator") and "dependent" not in kind
        if operator in NEIGHBOURS:
            choice = [NEIGHBOURS[operator][0]] if operator not in ("==", "!=") else []
            self.change(node, "negation", f"({x} {NEIGHBOURS[operator][-1]} {y})")
            types = {self.type_of(left), self.type_of(right)}
            ordered = not any("Tri" in t or "Verdict" in t or "iterator" in t or "string" in t or "optional" in t or "*" in t
                              or "bool" == t or "dependent" in t or "Gaussian" in t for t in types)
            numbers = all(re.search(r"int|long|size_t|double|char|mpz|mpq|__gmp|short|difference_type", t) for t in types)
            if y in ("0", "0U") and re.search(r"unsigned|size_t|uint", " ".join(types | {self.type_of(self.explicit(left))})):
                numbers = False  # <= is ==.
            if operator in ("==", "!=") and ordered and numbers:
                choice += ["<=", ">="] if operator == "==" else ["<", ">"]
            for other in choice:
                self.change(node, "comparison", f"({x} {other} {y})")
            for name in ("yes", "no"):
                opposite = {"yes": "no", "no": "yes"}[name]
                match = re.fullmatch(r"((?:\w+::)*Tri::)" + name, y) if operator in ("==", "!=") else None
                if match:
                    inverse = {"==": "!=", "!=": "=="}[operator]
                    self.change(node, "comparison", f"({x} {inverse} {match[1]}{opposite})")
            return operator
        if operator in ("&&", "||"):
            self.change(node, "logic", f"(({x}) {'||' if operator == '&&' else '&&'} ({y}))")
            self.change(node, "logic", f"static_cast<bool>({x})")
            self.change(node, "logic", f"static_cast<bool>({y})")
            return operator
        if operator == "%":
            self.change(node, "arithmetic", f"({x})" if not builtin else f"static_cast<{self.written_type(node)}>({x})", builtin)
            return operator
        if operator in ("*", "/") and not builtin and "__gmp_expr" not in kind:
            # Rings and isometries are not divided.
            if self.type_of(left).replace("const ", "") == self.type_of(right).replace("const ", ""):
                self.change(node, "factor", f"({x})", False)
                if operator == "*":
                    self.change(node, "factor", f"({y})", False)
            else:
                tree.undivided.add(whole[1])
            return operator
        if "iterator" in self.type_of(left) + self.type_of(right) or "*" in self.type_of(left) + self.type_of(right):
            if "iterator" not in kind and "*" not in kind:
                return operator  # The sum of two iterators is none.
        if operator in SWAPS and not re.search(r"precision", x + y):
            text = f"({x} {SWAPS[operator]} {y})"
            if '"' in x + y or "basic_string" in kind or any(self.is_text(k) for k in (left, right)):
                return operator
            if operator.endswith("="):
                self.change(node, "arithmetic", text)
            else:
                self.change(node, "arithmetic", text, builtin)
            whole = f"static_cast<{self.written_type(node)}>" if builtin else ""
            if operator in ("+", "-", "*", "/"):
                kind_of_part = "term" if operator in ("+", "-") else "factor"
                self.change(node, kind_of_part, f"{whole}({x})", builtin)
                if operator in ("+", "*"):
                    self.change(node, kind_of_part, f"{whole}({y})", builtin)
        return operator

    def written_type(self, node):
        return self.type_of(node).replace("const ", "") or "auto"

    def literal(self, node, t):
        match = re.fullmatch(r"(0[xX][0-9a-fA-F']+|[0-9][0-9']*)([uUlLzZ]*)", t)
        if match:
            value = int(match[1].replace("'", ""), 0 if not re.fullmatch(r"0\d+", match[1]) else 8)
            for new in dict.fromkeys((value + 1, value - 1) + ((2 * value, value // 2) if value > 3 else ())):
                if new >= 0:
                    self.change(node, "constant", f"{new}{match[2]}")
        elif re.search(r"[.eEpP]", t):
            zero = re.fullmatch(r"0*\.?0*", t)
            for new in (f"({t} + 1)", f"({t} - 1)") + (() if zero else (f"(2 * {t})", f"({t} / 2)")):
                self.change(node, "constant", new)

    def statement(self, node):
        """A statement that is an expression, which can be left out."""
        inner = self.explicit(node)
        kind = inner["kind"]
        if kind in ("CallExpr", "CXXMemberCallExpr"):
            name, _ = self.callee(inner)
            if NO_EFFECT.search(name):
                return
            if "noreturn" in json.dumps(inner.get("type", {})):
                return
        elif kind == "CXXOperatorCallExpr":
            if len(self.kids(inner)) > 1 and self.is_text(self.kids(inner)[1]) and not self.text_matters(node):
                return
        elif kind == "BinaryOperator":
            if inner.get("opcode") != "=" or COUNTED.search(self.text(self.kids(inner)[0]) or ""):
                return
        elif kind not in ("CompoundAssignOperator", "UnaryOperator"):
            return
        self.wrap(node, "dropped", "(mutant::at({id}) ? static_cast<void>(0) : static_cast<void>({inner}))", "")

    def text_matters(self, node):
        where = self.span(node)
        return where is not None and where[0].path.startswith(TEXT_MATTERS)

    def walk(self, node, constant=False):
        kind = node.get("kind")
        if kind is None:
            return
        if kind in ("StaticAssertDecl", "EnumDecl", "ConstantExpr", "SubstNonTypeTemplateParmExpr", "TemplateArgument",
                    "UnaryExprOrTypeTraitExpr", "TypeAliasDecl", "TypedefDecl", "ConceptDecl", "BindingDecl"):
            return
        kids = self.kids(node)
        if kind in ("FunctionDecl", "CXXMethodDecl", "CXXConstructorDecl", "CXXDestructorDecl", "CXXConversionDecl"):
            if node.get("constexpr") and not node.get("inline") and kind == "FunctionDecl":
                return
            if node.get("isImplicit") or node.get("explicitlyDefaulted"):
                return
            returns = node.get("type", {}).get("qualType", "").split("(")[0].strip()
            in_lambda = node.get("name") == "operator()" and self.function
            if re.fullmatch(r"(const )?(std::)?(string|string_view)", returns) and not self.text_matters(node) and not in_lambda:
                return
            if kind == "CXXDestructorDecl" or ESTIMATES.search(node.get("name", "")) or SHOWN.search(node.get("name", "")):
                return
            outer = (self.function, self.returns)
            if not in_lambda:
                self.function = node.get("name", "?")
            self.returns = returns
            for kid in kids:
                self.walk(kid)
            self.function, self.returns = outer
            return
        if kind in ("CXXRecordDecl", "ClassTemplateDecl", "ClassTemplateSpecializationDecl") and not self.function:
            outer = self.function
            for kid in kids:
                if kid.get("kind") == "FieldDecl":
                    if "int" in kid.get("type", {}).get("qualType", ""):
                        continue  # Counters, which start from 0.
                    self.function = node.get("name", "?")
                    self.walk(kid)
                    self.function = outer
                else:
                    self.walk(kid)
            return
        if kind == "FunctionTemplateDecl":
            outer, self.in_template = self.in_template, True
            for kid in kids:
                self.walk(kid)
            self.in_template = outer
            return
        if kind == "VarDecl" and (node.get("constexpr")):
            return
        if kind == "VarDecl" and node.get("init") is None and not kids:
            return
        if kind == "VarDecl" and re.fullmatch(r"(const )?(epsnet::certify::)?(Ball|Interval)", node.get("type", {}).get("qualType", "")):
            value = self.explicit(kids[-1]) if kids else {}
            while value.get("kind") == "CXXConstructExpr" and len(self.kids(value)) == 1:
                value = self.explicit(self.kids(value)[0])
            if value.get("kind") in ("CallExpr", "CXXMemberCallExpr", "CXXOperatorCallExpr", "DeclRefExpr", "MemberExpr"):
                self.centre(value, self.text(value), "mutant::centre({0})")
        if kind == "LambdaExpr":
            for kid in kids:
                if kid.get("kind") == "CXXRecordDecl":
                    for member in self.kids(kid):
                        if member.get("name") == "operator()":
                            self.walk(member)
                        elif member.get("kind") == "FunctionTemplateDecl":
                            self.walk(member)
                elif kid.get("kind") != "CompoundStmt":
                    self.walk(kid)
            return
        is_expression = "valueCategory" in node
        if is_expression and self.is_text(node) and not self.text_matters(node):
            # A message. Calls inside it do not matter either.
            return
        t = self.text(node) if is_expression else None
        if t and re.fullmatch(r"(\d+ \* )?(precision|max_precision_?|cap)|std::min\([^()]*precision[^()]*\)", t):
            return
        if kind in ("BinaryOperator", "CompoundAssignOperator") and len(kids) == 2:
            self.binary(node, kids[0], kids[1])
        elif kind == "CXXOperatorCallExpr" and len(kids) == 3:
            self.binary(node, kids[1], kids[2])
        elif kind == "CXXRewrittenBinaryOperator" and kids:
            inner = kids[0]
            while inner and inner.get("kind") not in ("CXXOperatorCallExpr", "BinaryOperator"):
                inner = (self.kids(inner) or [None])[0]
            if inner is not None:
                operands = self.kids(inner)[-2:]
                self.binary(node, operands[0], operands[1])
                kids = operands
        elif kind == "UnaryOperator" and t:
            if node.get("opcode") == "-" and kids:
                self.change(node, "arithmetic", self.text(kids[0]) and f"(+{self.text(kids[0])})")
            elif node.get("opcode") == "!" and kids:
                self.change(node, "logic", self.text(kids[0]) and f"static_cast<bool>({self.text(kids[0])})")
        elif kind in ("IntegerLiteral", "FloatingLiteral") and t and not constant:
            self.literal(node, t)
        elif kind == "CXXBoolLiteralExpr" and t:
            self.change(node, "constant", "false" if t == "true" else "true")
        elif kind == "DeclRefExpr" and t:
            declared = node.get("referencedDecl", {})
            name = declared.get("name", "")
            if declared.get("kind") == "EnumConstantDecl":
                typed = declared.get("type", {}).get("qualType", "").split("::")[-1]
                for other in ENUMERATORS.get(typed, ()):
                    if other != name:
                        self.change(node, "constant", t[:len(t) - len(name)] + other)
            elif declared.get("id") in self.constants and not PRECISIONS.search(name) and re.fullmatch(r"(const )?(std::)?(u?int\d+_t|slong|ulong|(unsigned )?(int|long)|size_t|double|unsigned|mp_\w+)", declared.get("type", {}).get("qualType", "")):
                for new in (f"({t} + 1)", f"({t} - 1)", f"({t} * 2)", f"({t} / 2)"):
                    self.change(node, "constant", f"static_cast<std::decay_t<decltype({t})>>({new})")
        elif kind in ("CallExpr", "CXXMemberCallExpr"):
            name, f = self.callee(node)
            if NO_EFFECT.search(name):
                return
            self.call = node
            if f is not None and t:
                inner = self.text(f)
                for other in COUNTERPARTS.get(name, ()):
                    if kind == "CallExpr" and name in MEMBERS:
                        continue
                    if kind == "CXXMemberCallExpr" and not self.alike(f, name, other):
                        continue
                    if inner and inner.endswith(name) and t.startswith(inner):
                        self.wrap(node, "call", None, (inner[:len(inner) - len(name)] + other + t[len(inner):], f"{name} → {other}"))
            self.arguments(kids[1:], name)
            if name == "conjugate" and len(kids) == 2 and self.text(kids[1]):
                self.change(node, "call", self.text(kids[1]), False)
            if name in ("for_each_parallel", "first_problem") and len(kids) > 1 and self.text(kids[1]):
                count = self.text(kids[1])
                self.change(kids[1], "bound", f"mutant::one_less({count})")
                self.change(kids[1], "bound", f"mutant::at_most_one({count})")
            if re.match(r"(arb|acb)_", name) and len(kids) > 3 and self.type_of(self.explicit(kids[-1])) in ("int", "long"):
                kids = kids[:-1]  # The precision.
            for left, right in (("FLOOR", "CEIL"), ("CEIL", "FLOOR")):
                if t and "ARF_RND_" + left in t and len(t) < 200:
                    self.wrap(node, "call", None, (t.replace("ARF_RND_" + left, "ARF_RND_" + right), "direction"))
        elif kind == "MemberExpr" and t:
            name = node.get("name", "").lstrip("->.")
            if name in ("lower", "upper") and kids and self.type_of(node) in ("double", "const double") and re.search(r"certify::Interval$|^(const )?Interval$", self.type_of(kids[0])):
                base = self.text(kids[0])
                if base and t.startswith(base):
                    self.centre(node, base, "(({0}.lower + {0}.upper) / 2)")
            if name in COUNTERPARTS and t.endswith(name) and "bound member" not in self.type_of(node):
                for other in COUNTERPARTS[name]:
                    if not self.alike(node, name, other):
                        continue
                    self.wrap(node, "call", None, (t[:len(t) - len(name)] + other, f"{name} → {other}"))
        elif kind == "IfStmt":
            at = (1 if node.get("hasInit") else 0) + (1 if node.get("hasVar") else 0)
            if not node.get("isConstexpr") and not node.get("hasVar") and len(kids) > at:
                self.condition(kids[at])
            if node.get("isConstexpr"):
                for kid in kids[at + 1:]:
                    self.part(kid)
                    self.walk(kid)
                return
            for kid in kids[at + 1:]:
                self.part(kid)
        elif kind == "ConditionalOperator":
            self.condition(kids[0])
        elif kind == "WhileStmt":
            if not node.get("hasVar"):
                self.condition(kids[0], ("false",))
            self.part(kids[-1])
        elif kind == "DoStmt":
            self.condition(kids[1], ("false",))
            self.part(kids[0])
        elif kind == "ForStmt":
            every = node.get("inner", [])
            if len(every) == 5:
                c = every[2]
                if c.get("kind"):
                    self.condition(c, ("false",))
                    c = self.explicit(c)
                    if c["kind"] == "BinaryOperator" and c.get("opcode") in ("<", "!="):
                        x, y = self.text(self.kids(c)[0]), self.text(self.kids(c)[1])
                        if x and y and re.search(r"int|long|size_t|unsigned", self.type_of(self.explicit(self.kids(c)[0]))):
                            self.change(c, "bound", f"({x} + 1 {c['opcode']} {y})")
                            started = [k for d in self.kids(every[0]) for k in self.kids(d)] if every[0].get("kind") else []
                            if started and self.text(self.explicit(started[0])) in ("0", "0U"):
                                self.change(c, "first", f"({x} < 1 && {x} {c['opcode']} {y})")
                self.part(every[4])
        elif kind == "CXXForRangeStmt":
            every = node.get("inner", [])
            declared = every[1]
            variables = self.kids(declared) if declared.get("kind") == "DeclStmt" else []
            if variables and self.kids(variables[0]):
                value = self.kids(variables[0])[0]
                inner = self.explicit(value)
                text = self.text(inner)
                if text and inner["kind"] not in ("InitListExpr", "CXXStdInitializerListExpr") and not text.startswith("{"):
                    self.wrap(inner, "bound", "mutant::part({id}, {inner})", "without the first")
                    self.wrap(inner, "bound", "mutant::but_last({id}, {inner})", "without the last")
                    self.wrap(inner, "first", "mutant::first_alone({id}, {inner})", "the first alone")
                self.walk(value)
            self.part(every[-1])
            self.walk(every[-1])
            return
        elif kind == "CompoundStmt":
            for kid in kids:
                self.part(kid)
        elif kind == "ReturnStmt" and kids:
            if self.returns == "bool" and self.type_of(kids[0]) == "bool" and not self.in_template:
                self.condition(kids[0])
        for kid in kids:
            self.walk(kid)

    def arguments(self, given, name):
        """The changes of a call's arguments."""
        given = [a for a in given if a.get("kind") != "CXXDefaultArgExpr"]
        texts = [self.text(a) for a in given]
        types = [re.sub(r"\bconst\b|&", "", self.type_of(self.explicit(a))).strip() for a in given]
        if FACTORS.match(name) and texts and texts[0] and "basic_string" not in types[0]:
            call = self.call
            self.change(call, "factor", f"({texts[0]})", False)
        if name in JOINT and len(texts) == 2 and all(texts):
            for part in texts:
                self.change(self.call, "term", f"({part})", False)
        if name in RANGES and len(texts) == 3 and all(texts[:2]):
            self.change(given[1], "first", f"mutant::after_first({texts[0]}, {texts[1]})")
        for i, j in ((i, j) for i in range(len(given)) for j in (i - 1, i + 1) if 0 <= j < len(given)):
            if not texts[i] or not texts[j] or texts[i] == texts[j] or types[i] != types[j] or name in JOINT:
                continue
            if re.search(r"lambda|iterator|basic_string|bool|\*", types[i]) or re.fullmatch(r"[0-9.]+[uUlL]*", texts[i]):
                continue
            self.change(given[i], "argument", texts[j])

    def centre(self, node, text, of):
        """Of an expression that is an interval or a ball of the first checker."""
        where = self.span(node)
        if where is None or where[0].path.startswith("certify/exact/") or not text:
            return
        self.change(node, "centre", of.format(text), True)

    def alike(self, member, name, other):
        """Whether the counterpart exists and has the same type."""
        members = self.siblings.get(member.get("referencedMemberDecl"))
        if members is None:
            return (name, other) in (("front", "back"), ("back", "front"))
        return other in members and members[name] == members[other]

    def part(self, node):
        if "valueCategory" in node:
            self.statement(node)

    def collect_constants(self, node):
        kind = node.get("kind")
        if kind == "VarDecl" and node.get("constexpr"):
            self.constants.add(node.get("id"))
        if kind in ("CXXRecordDecl", "ClassTemplateSpecializationDecl"):
            members = {k.get("name"): k.get("type", {}).get("qualType") for k in self.kids(node) if k.get("kind") in ("FieldDecl", "CXXMethodDecl")}
            for k in self.kids(node):
                if k.get("kind") in ("FieldDecl", "CXXMethodDecl"):
                    self.siblings[k.get("id")] = members
        for kid in self.kids(node):
            self.collect_constants(kid)


def documents(text):
    decoder = json.JSONDecoder()
    at = 0
    while at < len(text):
        while at < len(text) and text[at] in " \n\r\t":
            at += 1
        if at >= len(text):
            break
        if text[at] != "{":
            at = text.index("\n", at) + 1
            continue
        value, at = decoder.raw_decode(text, at)
        yield value


def syntax(source, clang, path):
    done = subprocess.run([clang, "-std=c++20", "-I", source, "-w", "-fsyntax-only", "-Xclang", "-ast-dump=json",
                           "-Xclang", "-ast-dump-filter=epsnet", os.path.join(source, path)],
                          stdout=subprocess.PIPE, cwd=source, check=True)
    return done.stdout.decode()


def read(source, clang, path, texts):
    trees = {p: Tree(p, t) for p, t in texts.items()}
    reader = Reader(source, trees)
    found = list(documents(syntax(source, clang, path)))
    for value in found:
        reader.visit_locations(value)
        reader.collect_constants(value)
    for value in found:
        reader.walk(value)
    return {p: (t.changes, t.wraps, t.functions, t.undivided) for p, t in trees.items() if t.changes or t.wraps}


def render(tree, spans, number, trial=False):
    """Returns the file with all its changes; `number` assigns the next mutant's number to a change.

    In a trial each replacement is a line of its own in a file called "mutant", with the mutant's number: so that is where the compiler sees an error.
    """
    text = tree.text.decode("latin-1")

    def marked(number, replacement, at):
        if not trial:
            return replacement
        line = tree.text[:at].count(b"\n") + 1
        return f'\n#line {number} "{TRIAL}"\n{replacement}\n#line {line} "{tree.path}"\n'

    def line_of(at):
        begin = tree.text.rfind(b"\n", 0, at) + 1
        end = tree.text.find(b"\n", at)
        return tree.text[:at].count(b"\n") + 1, tree.text[begin:end if end >= 0 else None].decode().strip()

    def register(span, kind, before, after, table, key):
        number, line = line_of(span[0])
        return add({"file": tree.path, "function": tree.functions[span], "line_number": number, "line": line,
                    "kind": kind, "from": before, "to": after, "change": (table, span, key)})
    add = number

    def shown(text):
        return re.sub(r"\s+", " ", text)

    def inside(begin, end, children):
        out, at = [], begin
        for child in children:
            out.append(text[at:child[0][0]])
            out.append(whole(child))
            at = child[0][1]
        out.append(text[at:end])
        return "".join(out)

    def whole(item):
        span, children = item
        original = text[span[0]:span[1]]
        before = original.encode("latin-1").decode()
        body = inside(span[0], span[1], children)
        arms = []
        for replacement, (kind, same) in tree.changes.get(span, {}).items():
            after = replacement[len("mutant::value("):-1] if not same else replacement
            number = register(span, kind, shown(before), shown(after), tree.changes, replacement)
            arms.append((number, marked(number, replacement.encode().decode("latin-1"), span[1]), same))
        calls = [w for w in tree.wraps.get(span, []) if w[2] is None]
        for call in calls:
            kind, (replacement, _), _ = call
            number = register(span, kind, shown(before), shown(replacement), tree.wraps, call)
            body = f"(mutant::at({number}) ? {marked(number, replacement.encode().decode('latin-1'), span[0])} : {body})"
        if arms:
            valued = not all(same for _, _, same in arms)
            if any(kind in ("condition", "logic", "comparison") for kind, _ in tree.changes[span].values()):
                body = f"static_cast<bool>({body})"
            body = f"mutant::value({body})" if valued else body
            chain = "".join(f"mutant::at({n}) ? {r} : " for n, r, _ in arms)
            body = f"({chain}{body})"
        for kind, what, form in tree.wraps.get(span, []):
            if form is None:
                continue
            number = register(span, kind, shown(before), what, tree.wraps, (kind, what, form))
            body = form.replace("{id}", str(number)).replace("{inner}", body)
        return body

    # Nesting of spans.
    stack = []
    roots = []
    for span in sorted(spans, key=lambda s: (s[0], -s[1])):
        while stack and stack[-1][0][1] <= span[0]:
            stack.pop()
        if stack and span[1] > stack[-1][0][1]:
            continue
        item = (span, [])
        (stack[-1][1] if stack else roots).append(item)
        stack.append(item)
    return inside(0, len(text), roots)


def errors(target, source, clang, path):
    """Where changes do not compile in a file of the trial: pairs of a file and a line."""
    command = [clang, "-std=c++20", "-fsyntax-only", "-w", "-ferror-limit=0", "-Wno-narrowing", f"-I{target}", f"-I{source}", path]
    run = subprocess.run(command, cwd=target, capture_output=True, text=True, check=False)
    places = set()
    for error in re.split(r"^(?=[^\s:]+:\d+:\d+: (?:fatal )?error: )", run.stderr, flags=re.MULTILINE)[1:]:
        found = [(file, int(line)) for file, line in re.findall(r"^([^\s:]+):(\d+):\d+: (?:error|note): ", error, re.MULTILINE)]
        # An error in a header of others is that of who instantiates it; a value that is not constant, that of what is called for it.
        ours = [place for place in found if place[0] == TRIAL or place[0].startswith("certify/")]
        places.update(ours if "constant expression" in error else ours[:1])
    if run.returncode != 0 and not places:
        sys.exit(f"mutate.py: {path} does not compile:\n{run.stderr[:2000]}")
    return places


def leave_out_what_does_not_compile(trees, compiled, source, target, clang):
    """Takes changes away until all files compile, and returns how many. Of an error outside of all replacements it takes all changes of the line."""
    count, failing = 0, compiled
    while failing:
        mutants = []

        def number(entry):
            mutants.append(entry)
            return len(mutants)
        for path in sorted(trees):
            write_tree(trees[path], target, number, trial=True)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            found = list(pool.map(lambda path: errors(target, source, clang, path), failing))
        failing = [path for path, places in zip(failing, found) if places]
        places = set().union(*found)
        before = count
        for n, m in enumerate(mutants, 1):
            if (TRIAL, n) in places or (m["file"], m["line_number"]) in places:
                table, span, key = m["change"]
                if key in table.get(span, ()):
                    table[span].pop(key) if isinstance(table[span], dict) else table[span].remove(key)
                    count += 1
        if failing and count == before:
            sys.exit(f"mutate.py: without a change that could be left out, these do not compile: {', '.join(failing)}: {sorted(places)[:5]}")
    return count


def write(path, data):
    """Writes a file only if it changes, so that nothing that depends on it is rebuilt."""
    if os.path.exists(path):
        with open(path, "rb") as file:
            if file.read() == data:
                return
    with open(path, "wb") as file:
        file.write(data)


def write_tree(tree, target, number, trial=False):
    body = render(tree, {span for table in (tree.changes, tree.wraps) for span in table if table[span]}, number, trial)
    lead = b'#include "mutant.h"\n#line 1 "' + tree.path.encode() + b'"\n'
    write(os.path.join(target, tree.path), (b"#pragma once\n" if tree.path.endswith(".h") else b"") + lead + body.encode("latin-1"))


def main():
    source, target = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    clang = sys.argv[3] if len(sys.argv) > 3 else "clang++"
    texts, compiled = {}, []
    for folder, _, names in os.walk(os.path.join(source, "certify")):
        for name in sorted(names):
            path = os.path.relpath(os.path.join(folder, name), source)
            if not name.endswith((".h", ".cpp")):
                continue
            with open(os.path.join(source, path), "rb") as file:
                text = file.read()
            out = os.path.join(target, path)
            os.makedirs(os.path.dirname(out), exist_ok=True)
            if path.startswith(LEFT_OUT):
                write(out, text)
                continue
            texts[path] = text
            if name.endswith(".cpp"):
                compiled.append(path)
    compiled.sort()
    trees = {p: Tree(p, t) for p, t in texts.items()}
    with concurrent.futures.ProcessPoolExecutor(2) as pool:
        for found in pool.map(read, [source] * len(compiled), [clang] * len(compiled), compiled, [texts] * len(compiled)):
            for path, (changes, wraps, functions, undivided) in found.items():
                tree = trees[path]
                for span, new in changes.items():
                    old = tree.changes.setdefault(span, {})
                    for replacement, entry in new.items():
                        old.setdefault(replacement, entry)
                for span, new in wraps.items():
                    old = tree.wraps.setdefault(span, [])
                    old.extend(w for w in new if w not in old)
                tree.undivided |= undivided
                for span, name in functions.items():
                    tree.functions.setdefault(span, name)
    for tree in trees.values():
        for span, changes in tree.changes.items():
            # Forcing a condition to be true, and to be false, tests more than negating it.
            if span in tree.undivided:
                changes.clear()
            if "false" in changes:
                for replacement in [r for r, (kind, _) in changes.items() if kind == "negation"]:
                    del changes[replacement]
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "mutant.h"), "rb") as file:
        header = file.read()
    write(os.path.join(target, "mutant.h"), header)
    with tempfile.TemporaryDirectory() as trial:
        for folder, _, names in os.walk(os.path.join(target, "certify")):  # Those that are not changed.
            for name in names:
                path = os.path.relpath(os.path.join(folder, name), target)
                if path.startswith(LEFT_OUT):
                    os.makedirs(os.path.dirname(os.path.join(trial, path)), exist_ok=True)
                    shutil.copy(os.path.join(target, path), os.path.join(trial, path))
        for path in trees:
            os.makedirs(os.path.dirname(os.path.join(trial, path)), exist_ok=True)
        write(os.path.join(trial, "mutant.h"), header)
        left_out = leave_out_what_does_not_compile(trees, compiled, source, trial, clang)
    mutants = []

    def number(entry):
        mutants.append(entry)
        entry["id"] = len(mutants)
        del entry["change"]
        return len(mutants)
    for path in sorted(trees):
        write_tree(trees[path], target, number)
    # Equal changes on one line are distinguished by a number.
    seen = {}
    for m in mutants:
        key = (m["file"], m["function"], m["line"], m["from"], m["to"])
        seen[key] = seen.get(key, 0) + 1
        m["nth"] = seen[key]
    write(os.path.join(target, "mutants.json"), json.dumps(mutants, ensure_ascii=False, indent=0).encode())
    write(os.path.join(target, "mutant_count.h"), f"#define MUTANT_COUNT {len(mutants) + 1}\n".encode())
    print(f"{len(mutants)} mutants of {sum(bool(t.changes or t.wraps) for t in trees.values())} files; {left_out} changes that do not compile are left out")


if __name__ == "__main__":
    main()
