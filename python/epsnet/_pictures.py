"""What a notebook shows of things that have a picture."""
from __future__ import annotations

import base64
import html
from typing import Any


class Drawn:
    """It has the method ``svg``."""

    __slots__ = ()

    def svg(self, *args: Any, **options: Any) -> str:
        """The picture."""
        raise NotImplementedError

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """As SVG, and as an image in HTML: nbconvert before version 7, as Debian 12 has it, leaves SVG out of the pages that it makes."""
        svg = self.svg()
        data = base64.b64encode(svg.encode()).decode()
        return {"image/svg+xml": svg, "text/html": f'<img alt="{html.escape(repr(self))}" src="data:image/svg+xml;base64,{data}">'}
