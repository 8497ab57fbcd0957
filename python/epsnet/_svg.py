"""Pictures drawn in Python, not by the library."""
from __future__ import annotations

from typing import Sequence


def polygon_svg(vertices: Sequence[complex], size: int = 500, rays: Sequence[complex] = ()) -> str:
    """A polygon of geodesics in the Poincaré disk, and segments from 0 to other points."""
    half = size / 2
    scale = 0.98 * half

    def place(z: complex) -> str:
        return f"{half + scale * z.real:.2f} {half - scale * z.imag:.2f}"

    path = [f"M {place(vertices[0])}"]
    for start, end in zip(vertices, [*vertices[1:], vertices[0]]):
        radius = _radius(start, end)
        turn = (start.conjugate() * end).imag
        # The circle bends away from the centre of the disk; on the page y points down.
        path.append(f"L {place(end)}" if radius is None else f"A {scale * radius:.2f} {scale * radius:.2f} 0 0 {1 if turn > 0 else 0} {place(end)}")
    dots = "".join(f'<circle cx="{place(z).split()[0]}" cy="{place(z).split()[1]}" r="2.5" fill="#10202f"/>' for z in vertices)
    for end in rays:
        x, y = place(end).split()
        dots += f'<path d="M {half} {half} L {x} {y}" stroke="#5a2ee0" stroke-width="2.5"/><circle cx="{x}" cy="{y}" r="4" fill="#5a2ee0"/>'
    if rays:
        dots += f'<circle cx="{half}" cy="{half}" r="4" fill="#0a6fe0"/>'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{size}" height="{size}" viewBox="0 0 {size} {size}">'
        f'<circle cx="{half}" cy="{half}" r="{scale:.2f}" fill="#ffffff" stroke="#9aa5b1"/>'
        f'<path d="{" ".join(path)} Z" fill="#e6f3f4" stroke="#00909e" stroke-width="1.5"/>{dots}</svg>'
    )


def _radius(z: complex, w: complex) -> "float | None":
    """The radius of the circle through z and w that meets the unit circle at right angles; None if it is a line."""
    cross = (z.conjugate() * w).imag
    if abs(cross) < 1e-9:
        return None
    # Its centre c has 2 Re(z̄c) = 1 + |z|² and 2 Re(w̄c) = 1 + |w|².
    centre = ((1 + abs(z) ** 2) * w - (1 + abs(w) ** 2) * z) / (2j * cross)
    return abs(centre - z)
