#!/usr/bin/env python3
"""mutate_test.py CLANG++: of a small checker, mutate.py makes the mutants that it says it makes, and they compile."""
import json
import os
import subprocess
import sys
import tempfile

SOURCE = """
#include <algorithm>
#include <array>
#include <vector>
namespace epsnet::certify {
struct Interval {
  double lower;
  double upper;
};
enum class Tri { no, yes, unknown };
Tri both(Tri x, Tri y) { return x == Tri::yes ? y : x; }
double square(double x) { return x * x; }
double distance(double from, double to) { return to - from; }
double sum(double x, double y) { return square(x) + 3 * y; }
double between(double x, double y) { return distance(x, y); }
Interval widest(const std::vector<Interval>& all) {
  Interval result{0, 0};
  for (const Interval& x : all) {
    const Interval y = x;
    if (y.upper > result.upper) result = y;
  }
  return result;
}
bool positive(const std::vector<double>& all) {
  return std::all_of(all.begin(), all.end(), [](double x) { return x > 0; });
}
int count(const std::array<int, 4>& all) {
  int result = 0;
  for (int i = 0; i < 4; ++i) {
    if (all[static_cast<unsigned>(i)] > 0) ++result;
  }
  return result;
}
Tri hold(Tri x, Tri y) { return both(x, y); }
}  // namespace epsnet::certify
"""
# Kind, what, and what for it.
EXPECTED = [
    ("term", "square(x) + 3 * y", "static_cast<double>(square(x))"),
    ("term", "square(x) + 3 * y", "static_cast<double>(3 * y)"),
    ("term", "to - from", "static_cast<double>(to)"),
    ("term", "both(x, y)", "(x)"),
    ("term", "both(x, y)", "(y)"),
    ("factor", "3 * y", "static_cast<double>(y)"),
    ("factor", "square(x)", "(x)"),
    ("argument", "x", "y"),
    ("argument", "y", "x"),
    ("centre", "x", "mutant::centre(x)"),
    ("centre", "y.upper", "((y.lower + y.upper) / 2)"),
    ("first", "all", "the first alone"),
    ("first", "all.end()", "mutant::after_first(all.begin(), all.end())"),
    ("first", "i < 4", "(i < 1 && i < 4)"),
    ("arithmetic", "to - from", "(to + from)"),
]


def main():
    clang = sys.argv[1]
    here = os.path.dirname(os.path.abspath(__file__))
    with tempfile.TemporaryDirectory() as folder:
        source, target = os.path.join(folder, "source"), os.path.join(folder, "target")
        os.makedirs(os.path.join(source, "certify", "net"))
        with open(os.path.join(source, "certify", "net", "sample.cpp"), "w", encoding="utf-8") as file:
            file.write(SOURCE)
        subprocess.run([sys.executable, os.path.join(here, "mutate.py"), source, target, clang], check=True)
        with open(os.path.join(target, "mutants.json"), encoding="utf-8") as file:
            found = [(m["kind"], m["from"], m["to"]) for m in json.load(file)]
        missing = [e for e in EXPECTED if e not in found]
        subprocess.run([clang, "-std=c++20", "-w", "-Wno-narrowing", "-fsyntax-only", f"-I{target}", "certify/net/sample.cpp"], cwd=target,
                       check=True)
        if missing:
            sys.exit(f"not made: {missing}\nmade: {sorted(found)}")


main()
