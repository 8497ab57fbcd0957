"""The plan: the sweeps behind each table and figure, as data."""

import random
from dataclasses import dataclass


@dataclass(frozen=True)
class Sweep:
    """Nets of all surfaces for all epsilons, made in one way. A surface is given by its name and the arguments of `epsnet surface`."""
    name: str
    surfaces: tuple[tuple[str, tuple[str, ...]], ...]
    epsilons: tuple[str, ...]
    insertion: str = "cavity"
    walk: str = "visibility"
    triangle_list: str = "C"


@dataclass(frozen=True)
class Seeds:
    """The seeds of a sweep or of a batch, including the last one."""
    first: int
    last: int

    @staticmethod
    def of(text: str) -> "Seeds":
        """Reads FIRST-LAST. Throws ValueError."""
        first, last = map(int, text.split("-"))
        if not 1 <= first <= last:
            raise ValueError
        return Seeds(first, last)

    def batches(self, size: int) -> list["Seeds"]:
        return [Seeds(first, min(first + size - 1, self.last)) for first in range(self.first, self.last + 1, size)]

    def __str__(self) -> str:
        return f"{self.first}-{self.last}"


@dataclass(frozen=True)
class Measurement:
    """Systoles, largest embedded disks, radii and diameters of all surfaces, or some of these, enclosed to these widths at most."""
    name: str
    surfaces: tuple[tuple[str, tuple[str, ...]], ...]
    quantities: tuple[str, ...] = ("systole", "disk", "radius", "diameter")
    disk_width: str = "1e-6"
    radius_width: str = "1e-2"
    diameter_width: str = "1e-6"


def octagons(count: int):
    """The random octagons of seeds 1 to `count`, which replace the thesis' surfaces, from the same distribution."""
    return tuple((f"octagon-{seed:03}", ("octagon", "--seed", str(seed))) for seed in range(1, count + 1))


def thin(count: int):
    """Surfaces of genus 2 with a cuff of length 1e-4, the others random in [1, 4], with random twists (IV.6.3)."""
    result = []
    for seed in range(1, count + 1):
        dice = random.Random(seed)
        lengths = [f"{dice.uniform(1, 4):.6f}" for _ in range(2)]
        twists = [f"{dice.uniform(0, 1):.6f}" for _ in range(2)]
        result.append((f"thin-{seed:02}", ("fenchel-nielsen", "--pants-graph", "0-1 0-1 0-1", "--lengths",
                                           ",".join(["1e-4", *lengths]), "--twists", ",".join(["0", *twists]))))
    return tuple(result)


def random_surfaces(genus: int, count: int):
    """Random Fenchel-Nielsen coordinates on random graphs."""
    return tuple((f"genus-{genus}-{seed:02}", ("fenchel-nielsen", "--genus", str(genus), "--seed", str(seed)))
                 for seed in range(1, count + 1))


def seeded(genus: int | None, seeds: Seeds):
    """The random octagons of these seeds, or the random surfaces of this genus."""
    of_all = octagons(seeds.last) if genus is None else random_surfaces(genus, seeds.last)
    return of_all[seeds.first - 1:]


def hundredths(largest: int, smallest: int, step: int = 1):
    return tuple(f"{k / 100:.2f}" for k in range(largest, smallest - 1, -step))


def experiments(quick: bool) -> dict[str, list[Sweep | Measurement]]:
    """The sweeps of every experiment, in the order of the thesis. Quick: few surfaces, large epsilons, all experiments."""
    few = (lambda count: 3) if quick else (lambda count: count)
    coarse = ("0.50", "0.40", "0.30")

    def epsilons(*values):
        return coarse if quick else values

    main = epsilons(*hundredths(50, 1))
    design = epsilons("0.50", "0.40", "0.30", "0.20", "0.10", "0.05")
    return {
        "walks": [Sweep(f"walk-{walk}", octagons(few(100)), design, "flips", walk, "A") for walk in ("straight", "visibility")],
        "lists": [Sweep(f"list-{letter}-{insertion}", octagons(few(100)), epsilons("0.50", "0.20", "0.10", "0.05"), insertion,
                        triangle_list=letter) for insertion in ("flips", "cavity") for letter in "ABCD"],
        "main": [Sweep("main", octagons(few(180)), main, "flips", "visibility", "A"),
                 Sweep("main-cavity", octagons(few(180)), main)],
        "systoles": [Measurement("systoles", octagons(few(180)), ("systole",))],
        "distances": [Measurement("distances", octagons(few(180)))],
        "thin": [Sweep("thin", thin(few(20)), epsilons("0.50", "0.45", "0.40", "0.35", "0.30", "0.25", "0.20", "0.10"))],
        "genus-3": [Sweep("genus-3", random_surfaces(3, few(50)), epsilons("0.50", "0.40", "0.30", "0.20", "0.10", "0.05"))],
        "higher-genus": [Sweep("higher-genus",
                               tuple(surface for genus in ((5, 9) if quick else (*range(2, 10), 20, 50, 100))
                                     for surface in random_surfaces(genus, 1)),
                               epsilons("0.50", "0.25", "0.10"))],
    }
