"""The plots of docs/experiments.md."""

from contextlib import contextmanager
from pathlib import Path

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.fonttype": "path", "svg.hashsalt": "epsnet", "axes.grid": True, "grid.alpha": 0.3,
                            "figure.figsize": (6.4, 3.8), "figure.constrained_layout.use": True})
import matplotlib.pyplot as plt

import distances
import tables


def means(records, value):
    groups = tables.by_epsilon(records)
    return [float(e) for e in groups], [value(group) for group in groups.values()]


def save(directory: Path, name: str) -> None:
    plt.savefig(directory / f"{name}.svg", metadata={"Date": None})
    plt.close()


def epsilon_axis(axes) -> None:
    axes.set_xlabel("ε")
    axes.invert_xaxis()


@contextmanager
def plot(directory: Path, name: str, ylabel: str, xlabel: str | None = None, legend: str = "best"):
    """One pair of axes, saved with its labels and a legend; without an xlabel, epsilon falls from left to right."""
    _, axes = plt.subplots()
    yield axes
    if xlabel is None:
        epsilon_axis(axes)
    else:
        axes.set_xlabel(xlabel)
    axes.set_ylabel(ylabel)
    axes.legend(loc=legend)
    save(directory, name)


def points(directory, main) -> None:
    """Table IV.3: the points of every net between the bounds."""
    with plot(directory, "points", "points / (16/ε²)") as axes:
        groups = {float(e): group for e, group in tables.by_epsilon(main).items()}
        upper = [tables.most(group[0]) for group in groups.values()]
        ratio = [[r["vertices"] / tables.most(r) for r in group] for group in groups.values()]
        axes.fill_between(list(groups), [min(r) for r in ratio], [max(r) for r in ratio], alpha=0.2, label="all surfaces")
        axes.plot(list(groups), [sum(r) / len(r) for r in ratio], label="mean")
        axes.plot(list(groups), [tables.least(group[0]) / u for group, u in zip(groups.values(), upper)], "k--", label="lower bound")
        thesis = {float(e): n * float(e) ** 2 / 16 for e, n in tables.THESIS_POINTS.items()}
        axes.plot(list(thesis), list(thesis.values()), "rx", label="thesis, Table IV.3")


def walks(directory, main) -> None:
    """Figure IV.11."""
    figure, left = plt.subplots()
    right = left.twinx()
    right.grid(False)
    left.plot(*means(main, tables.lifts_per_query), label="lifts per query (left)")
    right.plot(*means(main, lambda group: 100 * tables.share_at_start(group)), "C1--", label="% in own triangle (right)")
    left.set_ylabel("lifted triangles per query")
    right.set_ylabel("% in the first triangle")
    left.set_ylim(0, 0.5)
    right.set_ylim(50, 100)
    epsilon_axis(left)
    figure.legend(loc="upper center", bbox_to_anchor=(0.5, 0.95))
    save(directory, "walks")


def flips(directory, main) -> None:
    """Figure IV.12."""
    with plot(directory, "flips", "flips per insertion") as axes:
        axes.plot(*means(main, tables.flips_per_insertion), label="flips, list A")
        axes.plot([float(e) for e in tables.THESIS_FLIPS], list(tables.THESIS_FLIPS.values()), "rx", label="thesis")


def seconds(directory, main, cavity) -> None:
    """Figure IV.13."""
    with plot(directory, "seconds", "seconds, one core") as axes:
        epsilons, values = means(main, lambda group: tables.mean(group, "net_seconds"))
        axes.loglog(epsilons, [tables.thesis_seconds(e) for e in epsilons], "r--", label="thesis: 0.0901/ε^1.5962")
        axes.loglog(*means(main, lambda group: tables.mean(group, "certificate_seconds")), label="certificate")
        axes.loglog(epsilons, values, label="net, flips, list A")
        axes.loglog(*means(cavity, lambda group: tables.mean(group, "net_seconds")), label="net, cavity, list C")


def lists(directory, data) -> None:
    """Table IV.2, the points: how the order of the list changes the net."""
    with plot(directory, "lists", "points / (16/ε²)") as axes:
        for letter in "ABCD":
            epsilons, values = means(data[f"list-{letter}-flips"], lambda group: tables.mean(group, "vertices") / tables.most(group[0]))
            axes.semilogx(epsilons, values, "o--" if letter == "C" else "o-", label=f"variant {letter}")  # A and C coincide.


def thin(directory, records) -> None:
    """Table IV.4."""
    with plot(directory, "thin", "points") as axes:
        epsilons, values = means(records, lambda group: tables.mean(group, "vertices"))
        axes.semilogy(epsilons, values, "o", label="mean of our surfaces")
        axes.semilogy(epsilons, [tables.thin_model(e) for e in epsilons], "k--", label="0.5383 (16/ε² + w/ε)")
        axes.semilogy([float(e) for e in tables.THESIS_THIN], list(tables.THESIS_THIN.values()), "rx", label="thesis, Table IV.4")


def genera(directory, data) -> None:
    """Table IV.5 and IV.6.4: the points of every net of higher genus."""
    with plot(directory, "genera", "points / (16(g − 1)/ε²)", "genus") as axes:
        records = data.get("genus-3", []) + data.get("higher-genus", [])
        for epsilon in sorted({r["epsilon"] for r in data.get("higher-genus", records)}, reverse=True):
            chosen = [r for r in records if r["epsilon"] == epsilon]
            axes.semilogx([r["genus"] for r in chosen], [r["vertices"] / tables.most(r) for r in chosen], "o", alpha=0.5, label=f"ε = {epsilon}")


def systoles(directory, records) -> None:
    with plot(directory, "systoles", "systole", "surfaces, by systole") as axes:
        axes.plot(sorted(r["systole_lower"] for r in records), "o", markersize=3)
        axes.axhline(0.5, color="r", linestyle="--", label="thesis: 173 of 180 are above")


def scatter(axes, records, x: str, y: str) -> list[dict]:
    """Plots a point for each surface that has both numbers, at the midpoints of the enclosures; returns these surfaces."""
    both = [r for r in records if r[f"{x}_lower"] is not None and r[f"{y}_lower"] is not None]
    axes.plot([distances.middle(r, x) for r in both], [distances.middle(r, y) for r in both], "o", markersize=3,
              label="octagons")
    return both


def bound(axes, value: float, label: str) -> None:
    axes.axhline(value, color="r", linestyle="--", label=label)


def systole_diameter(directory, records) -> None:
    with plot(directory, "systole-diameter", "diameter", "systole") as axes:
        scatter(axes, records, "systole", "diameter")


def systole_disk(directory, records) -> None:
    """The radius of the largest embedded disk is at least half the systole, and at most Bavard's bound."""
    with plot(directory, "systole-disk", "radius of the largest embedded disk", "systole") as axes:
        found = scatter(axes, records, "systole", "disk")
        bound(axes, distances.disk_bound(records[0]["genus"]), "Bavard's bound")
        line = [f((r["systole_upper"] for r in found), default=1) for f in (min, max)]
        axes.plot(line, [x / 2 for x in line], "k:", label="systole/2")


def diameter_radius(directory, records) -> None:
    with plot(directory, "diameter-radius", "radius", "diameter", "lower right") as axes:
        found = scatter(axes, records, "diameter", "radius")
        bound(axes, distances.radius_bound(records[0]["genus"]), "least radius that covers")
        line = [min((r["diameter_lower"] for r in found), default=1), max((r["radius_upper"] for r in found), default=1)]
        axes.plot(line, line, "k:", label="radius = diameter")
        axes.set_ylim(bottom=1.35)  # Room for the legend.


def histograms(directory, records) -> None:
    _, grid = plt.subplots(2, 2)
    for axes, (quantity, name) in zip(grid.flat, tables.QUANTITY_NAMES.items()):
        axes.hist([distances.middle(r, quantity) for r in records if r[f"{quantity}_lower"] is not None], bins=20)
        axes.set_xlabel(name)
        axes.yaxis.set_major_locator(plt.MaxNLocator(5, integer=True))
    for axes in grid[:, 0]:
        axes.set_ylabel("surfaces")
    save(directory, "distances")


def gaps(directory: Path, genera: dict[int, list[list[float]]]) -> None:
    """Enclosures of λ_1 of random covers, by genus, beside each other in the order of λ_1."""
    with plot(directory, "gaps", "λ₁", "genus", "upper right") as axes:
        for place, found in enumerate(genera.values()):
            middles = sorted((sum(ends) / 2, (ends[1] - ends[0]) / 2) for ends in found)
            axes.errorbar([place + 0.7 * (i / len(middles) - 0.5) for i in range(len(middles))], [middle for middle, _ in middles],
                          [half for _, half in middles], fmt="C0.", markersize=3, elinewidth=0.6)
        axes.set_xticks(range(len(genera)), [str(genus) for genus in genera])
        bound(axes, 0.25, "1/4")
        axes.set_ylim(bottom=0)


def draw(directory: Path, data: dict[str, list[dict]]) -> None:
    """The plots for which there are records."""
    if "main" in data:
        points(directory, data["main"])
        walks(directory, data["main"])
        flips(directory, data["main"])
        seconds(directory, data["main"], data["main-cavity"])
    if "list-A-flips" in data:
        lists(directory, data)
    if "thin" in data:
        thin(directory, data["thin"])
    if "genus-3" in data or "higher-genus" in data:
        genera(directory, data)
    if "systoles" in data:
        systoles(directory, data["systoles"])
    if "distances" in data:
        for draw_one in (systole_diameter, systole_disk, diameter_radius, histograms):
            draw_one(directory, data["distances"])
