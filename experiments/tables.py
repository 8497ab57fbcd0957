"""The tables of docs/experiments.md: our numbers beside the thesis' (chapter IV.6)."""

import math
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal, localcontext
from statistics import fmean, median, pstdev

import distances as measured

THESIS_POINTS = {"0.40": 54, "0.30": 96, "0.20": 216, "0.10": 865, "0.05": 3454, "0.01": 86314}  # Table IV.3.
THESIS_LIFTS = {  # Table IV.1, where our copy of the thesis has a number.
    "straight": {"0.40": 1.024, "0.30": 1.023, "0.20": 1.025, "0.10": 1.026, "0.05": 1.028},
    "visibility": {"0.50": 1.025, "0.40": 1.029, "0.30": 1.027, "0.20": 1.030, "0.10": 1.028, "0.05": 1.029}}
THESIS_WALK_SECONDS = {"0.50": 0.189, "0.40": 0.275, "0.30": 0.432, "0.20": 0.815, "0.10": 2.372, "0.05": 7.016}  # Visibility.
THESIS_LIST_SECONDS = {"A": {"0.50": 0.19, "0.20": 0.81, "0.10": 2.34, "0.05": 6.92},  # Table IV.2.
                       "B": {"0.50": 0.31, "0.20": 2.34, "0.10": 9.9, "0.05": 40.59},
                       "C": {"0.50": 0.36, "0.20": 1.61, "0.10": 4.8, "0.05": 15.44},
                       "D": {"0.50": 0.49, "0.20": 2.29, "0.10": 8.31, "0.05": 49.93}}
THESIS_FLIPS = {"0.50": 3.41, "0.01": 2.41}  # IV.6.2; figure IV.12 shows the values between.
THESIS_THIN = {"0.50": 58, "0.45": 64, "0.40": 75, "0.35": 108, "0.30": 137, "0.25": 179}  # Table IV.4.
THESIS_GENUS_3 = {"0.50": 70, "0.40": 108, "0.30": 193, "0.20": 428, "0.10": 1727}  # Table IV.5.


def thesis_seconds(epsilon: float) -> float:
    """The fit of figure IV.13."""
    return 0.0901 / epsilon**1.5962


def by_epsilon(records: list[dict]) -> dict[str, list[dict]]:
    """The records of each epsilon, the largest epsilon first."""
    groups: dict[float, list[dict]] = {}
    for record in records:
        groups.setdefault(record["epsilon"], []).append(record)
    return {f"{epsilon:.2f}": groups[epsilon] for epsilon in sorted(groups, reverse=True)}


def mean(records: list[dict], key: str) -> float:
    return fmean(record[key] for record in records)


def lifts_where_left(records: list[dict]) -> float:
    """Triangles entered by the walks that leave their first triangle."""
    return sum(r["walk_steps"] for r in records) / sum(r["located"] - r["located_at_start"] for r in records)


def lifts_per_query(records: list[dict]) -> float:
    return fmean(r["walk_steps"] / r["located"] for r in records)


def share_at_start(records: list[dict]) -> float:
    return fmean(r["located_at_start"] / r["located"] for r in records)


def flips_per_insertion(records: list[dict]) -> float:
    return fmean(r["flips"] / r["insertions"] for r in records)


def least(record: dict) -> float:
    """Theorem III.2."""
    return (record["genus"] - 1) / math.sinh(record["epsilon"] / 2) ** 2


def most(record: dict) -> float:
    """Theorem III.1, for a systole of at least epsilon."""
    return 16 * (record["genus"] - 1) / record["epsilon"] ** 2


def thin_model(epsilon: float) -> float:
    """The thesis' 0.5383 (16/epsilon^2 + w/epsilon), w the width of the epsilon-collar of a curve of length 1e-4."""
    width = 2 * math.acosh(math.sinh(epsilon / 2) / math.sinh(1e-4 / 2))
    return 0.5383 * (16 / epsilon**2 + width / epsilon)


def fit_power(records: list[dict], key: str) -> tuple[float, float, float]:
    """c, k and r^2 of the mean = c / epsilon^k, by least squares of the logarithms."""
    groups = by_epsilon(records)
    x = [math.log(float(epsilon)) for epsilon in groups]
    y = [math.log(mean(group, key)) for group in groups.values()]
    mx, my = fmean(x), fmean(y)
    slope = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)
    left = sum((b - my - slope * (a - mx)) ** 2 for a, b in zip(x, y))
    return math.exp(my - slope * mx), -slope, 1 - left / sum((b - my) ** 2 for b in y)


# Markdown.

def table(head: list[str], rows: list[list]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join("" if cell is None else str(cell) for cell in line) + " |\n" for line in lines)


def integer(x: float | None) -> str | None:
    return None if x is None else f"{x:,.0f}"


def decimal(x: float | None, digits: int) -> str | None:
    return None if x is None else f"{x:.{digits}f}"


def rounded_down(x: float, digits: int) -> str:
    """Returns x, a lower bound, with `digits` decimal places, rounded down so that it is still a lower bound."""
    return str(Decimal(x).quantize(Decimal(1).scaleb(-digits), ROUND_FLOOR))


def exact(epsilon: float) -> Decimal:
    """Returns the decimal that the user gave."""
    return Decimal(str(epsilon))


def one_digit_after_point(x: Decimal, rounding: str) -> str:
    """Returns a text such as 1.2e-13, rounded in the given direction."""
    with localcontext() as context:
        context.rounding = rounding
        return f"{x:.1e}"


def difference(ours: float, thesis: float | None) -> str | None:
    return None if thesis is None else f"{100 * (ours / thesis - 1):+.1f}%"


def walks(straight: list[dict], visibility: list[dict]) -> str:
    ours = {"straight": by_epsilon(straight), "visibility": by_epsilon(visibility)}
    epsilons = list(ours["visibility"])
    rows = [[f"lifts, {walk}"] + [decimal(lifts_where_left(groups[e]), 3) for e in epsilons] for walk, groups in ours.items()]
    rows += [[f"lifts, {walk}, thesis"] + [decimal(THESIS_LIFTS[walk].get(e), 3) for e in epsilons] for walk in ours]
    rows += [[f"milliseconds, {walk}"] + [decimal(1e3 * mean(groups[e], "net_seconds"), 2) for e in epsilons]
             for walk, groups in ours.items()]
    rows.append(["milliseconds, visibility, thesis"] + [integer(1e3 * THESIS_WALK_SECONDS[e]) for e in epsilons])
    rows += [[f"points, {walk}"] + [decimal(mean(groups[e], "vertices"), 1) for e in epsilons] for walk, groups in ours.items()]
    return table(["ε", *epsilons], rows)


def lists(ours: dict[tuple[str, str], list[dict]]) -> str:
    groups = {key: by_epsilon(records) for key, records in ours.items()}
    epsilons = list(next(iter(groups.values())))
    rows = []
    for letter in "ABCD":
        rows.append([f"{letter}, thesis: seconds"] + [THESIS_LIST_SECONDS[letter].get(e) for e in epsilons])
        for way in ("flips", "cavity"):
            rows.append([f"{letter}, {way}: milliseconds"] +
                        [decimal(1e3 * mean(groups[letter, way][e], "net_seconds"), 2) for e in epsilons])
    for letter in "ABCD":
        rows.append([f"{letter}, flips: points"] + [decimal(mean(groups[letter, "flips"][e], "vertices"), 1) for e in epsilons])
    for letter in "ABCD":
        rows.append([f"{letter}, flips: flips per insertion"] +
                    [decimal(flips_per_insertion(groups[letter, "flips"][e]), 2) for e in epsilons])
    return table(["variant", *epsilons], rows)


def points(main: list[dict], cavity: list[dict]) -> str:
    shown = [e for e in by_epsilon(main) if float(e) in (0.5, 0.4, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01)]
    ours, fast = by_epsilon(main), by_epsilon(cavity)
    rows = []
    for e in shown:
        flips_mean, cavity_mean = mean(ours[e], "vertices"), mean(fast[e], "vertices")
        thesis = THESIS_POINTS.get(e)
        rows.append([e, integer(thesis), decimal(flips_mean, 1), difference(flips_mean, thesis), decimal(cavity_mean, 1),
                     difference(cavity_mean, thesis), integer(least(ours[e][0])), integer(most(ours[e][0]))])
    return table(["ε", "thesis", "flips, list A", "", "default (cavity, C)", "", "lower bound", "upper bound"], rows)


def ratios(main: list[dict]) -> str:
    def row(name, values, thesis):
        percent = [100 * value for value in values]
        return [name, thesis] + [f"{f(percent):.1f}%" for f in (fmean, pstdev, min, max)]

    return table(["number of points to", "thesis: mean, σ, least, greatest", "mean", "σ", "least", "greatest"],
                 [row("lower bound", [r["vertices"] / least(r) for r in main], "217%, 7%, 190%, 257%"),
                  row("upper bound", [r["vertices"] / most(r) for r in main], "54%, 2%, 47%, 63%")])


def behaviour(main: list[dict], cavity: list[dict]) -> str:
    fast = by_epsilon(cavity)
    shown = {e: group for e, group in by_epsilon(main).items()
             if float(e) in (0.5, 0.4, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01)}
    rows = [[e, decimal(lifts_per_query(group), 3), f"{100 * share_at_start(group):.1f}%",
             max(r["longest_walk"] for r in group), decimal(flips_per_insertion(group), 2), THESIS_FLIPS.get(e),
             decimal(1e3 * mean(group, "net_seconds"), 2), decimal(1e3 * mean(fast[e], "net_seconds"), 2),
             decimal(1e3 * mean(group, "certificate_seconds"), 1), integer(1e3 * thesis_seconds(float(e)))]
            for e, group in shown.items()]
    rows.append(["all", decimal(lifts_per_query(main), 3), f"{100 * share_at_start(main):.1f}%",
                 max(r["longest_walk"] for r in main), decimal(flips_per_insertion(main), 2)] + [None] * 5)
    return table(["ε", "lifts per query", "in own triangle", "longest walk", "flips", "thesis", "flips: ms", "cavity: ms",
                  "certificate: ms", "thesis' fit: ms"], rows)


def fits(main: list[dict], cavity: list[dict]) -> str:
    rows = [["thesis", "0.0901", "1.596", "> 0.999"]]
    for name, records, key in (("flips, list A", main, "net_seconds"), ("cavity, list C", cavity, "net_seconds"),
                               ("certificate, one core", main, "certificate_seconds")):
        c, k, r2 = fit_power(records, key)
        rows.append([name, f"{c:.3g}", f"{k:.3f}", f"{r2:.3f}"])
    return table(["seconds = c/ε^k", "c", "k", "r²"], rows)


def thin(records: list[dict]) -> str:
    rows = []
    for e, group in by_epsilon(records).items():
        ours, model = mean(group, "vertices"), thin_model(float(e))
        rows.append([e, THESIS_THIN.get(e), integer(model), decimal(ours, 1), min(r["vertices"] for r in group),
                     max(r["vertices"] for r in group), difference(ours, model)])
    return table(["ε", "thesis", "0.5383 (16/ε² + w/ε)", "mean", "least", "greatest", "mean to model"], rows)


def genus_3(records: list[dict]) -> str:
    rows = []
    for e, group in by_epsilon(records).items():
        ours = mean(group, "vertices")
        rows.append([e, integer(THESIS_GENUS_3.get(e)), decimal(ours, 1), difference(ours, THESIS_GENUS_3.get(e)),
                     f"{100 * ours / least(group[0]):.0f}%", f"{100 * ours / most(group[0]):.1f}%"])
    return table(["ε", "thesis", "mean", "", "of the lower bound", "of the upper bound"], rows)


def higher_genus(records: list[dict]) -> str:
    rows = [[r["genus"], f"{r['epsilon']:.2f}", integer(r["vertices"]), f"{100 * r['vertices'] / most(r):.1f}%",
             one_digit_after_point(exact(r['epsilon']) - Decimal(r['largest_circumradius_upper']), ROUND_FLOOR),
             one_digit_after_point(Decimal(r['shortest_edge_lower']) - exact(r['epsilon']), ROUND_FLOOR), decimal(1e3 * r["net_seconds"], 1),
             decimal(1e3 * r["certificate_seconds"], 1)] for r in records]
    return table(["genus", "ε", "points", "of the upper bound", "ε − largest circumradius", "shortest edge − ε", "net: ms",
                  "certificate: ms"], rows)


def systoles(records: list[dict]) -> str:
    cells = [f"{r['surface'].split('-')[1].lstrip('0')}: {rounded_down(r['systole_lower'], 6)}" for r in records]
    columns = 6
    height = -(-len(cells) // columns)
    return table(["seed: systole"] * columns,
                 [[cells[i + j * height] if i + j * height < len(cells) else None for j in range(columns)] for i in range(height)])


QUANTITY_NAMES = {"systole": "systole", "disk": "largest embedded disk", "radius": "radius", "diameter": "diameter"}


def seed(record: dict) -> str:
    return record["surface"].split("-")[1].lstrip("0")


def distances(records: list[dict]) -> str:
    """Statistics of the midpoints of the enclosures, and their cost."""
    rows = []
    for quantity, name in QUANTITY_NAMES.items():
        found = sorted((r for r in records if r[f"{quantity}_lower"] is not None), key=lambda r: measured.middle(r, quantity))
        seconds = [r[f"{quantity}_seconds"] for r in records]
        cost = [decimal(fmean(seconds), 2), decimal(max(seconds), 2)]
        if not found:
            rows.append([name, 0] + [None] * 6 + cost)
            continue
        values = [measured.middle(r, quantity) for r in found]
        digits = 3 if quantity == "radius" else 4
        rows.append([name, len(found), *(f"{values[i]:.{digits}f} ({seed(found[i])})" for i in (0, -1)),
                     *(decimal(f(values), digits) for f in (fmean, median, pstdev)),
                     one_digit_after_point(max(Decimal(r[f"{quantity}_upper"]) - Decimal(r[f"{quantity}_lower"]) for r in found), ROUND_CEILING), *cost])
    return table(["", "surfaces", "least (seed)", "greatest (seed)", "mean", "median", "σ", "widest enclosure", "seconds: mean",
                  "most"], rows)


def correlation(x: list[float], y: list[float]) -> float | None:
    """Pearson's correlation."""
    mx, my = fmean(x), fmean(y)
    scale = math.sqrt(sum((a - mx) ** 2 for a in x) * sum((b - my) ** 2 for b in y))
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / scale if scale > 0 else None


def correlations(records: list[dict]) -> str:
    whole = [r for r in records if measured.has_all(r)]
    values = {quantity: [measured.middle(r, quantity) for r in whole] for quantity in QUANTITY_NAMES}
    rows = [[QUANTITY_NAMES[a], *(decimal(correlation(values[a], values[b]), 2) if whole else None for b in values)] for a in values]
    return table(["", *QUANTITY_NAMES.values()], rows)


def octagons(records: list[dict]) -> str:
    """The lower ends of all enclosures, rounded down."""
    def lower(record, quantity, digits):
        value = record[f"{quantity}_lower"]
        return "?" if value is None else rounded_down(value, digits)

    cells = [[seed(r), lower(r, "systole", 6), lower(r, "disk", 6), lower(r, "radius", 3), lower(r, "diameter", 6)] for r in records]
    height = -(-len(cells) // 2)
    return table(["seed", "systole", "disk", "radius", "diameter"] * 2,
                 [cells[i] + (cells[i + height] if i + height < len(cells) else [None] * 5) for i in range(height)])


def make(data: dict[str, list[dict]]) -> dict[str, str]:
    """Returns the tables for which there are records, as Markdown."""
    result = {}
    if "walk-straight" in data:
        result["walks"] = walks(data["walk-straight"], data["walk-visibility"])
    if "list-A-flips" in data:
        result["lists"] = lists({(letter, way): data[f"list-{letter}-{way}"] for letter in "ABCD" for way in ("flips", "cavity")})
    if "main" in data:
        result["points"] = points(data["main"], data["main-cavity"])
        result["ratios"] = ratios(data["main"])
        result["behaviour"] = behaviour(data["main"], data["main-cavity"])
        result["fits"] = fits(data["main"], data["main-cavity"])
    if "distances" in data:
        result["distances"] = distances(data["distances"])
        result["correlations"] = correlations(data["distances"])
        result["octagons"] = octagons(data["distances"])
    for name, make_table in (("systoles", systoles), ("thin", thin), ("genus-3", genus_3), ("higher-genus", higher_genus)):
        if name in data:
            result[name] = make_table(data[name])
    return result
