"""The classes that annotations name in modules below theirs: a net has a surface, and a surface makes nets; an error has a certificate.

They are imported for a type checker alone. No other module of the package imports one above it, not for annotations either (``test_imports.py``).
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .certificates import Certificate as Certificate
    from .surfaces import Surface as Surface
else:
    Certificate = Surface = Any
