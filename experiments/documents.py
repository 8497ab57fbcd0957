"""Files that are written in one step, and documents with places for generated tables."""

import os
import subprocess
from pathlib import Path


class DocumentError(Exception):
    """The text is one line that starts with the path."""


def write_atomically(path: Path, text: str) -> None:
    temporary = path.with_name(f".{path.name}.part")
    temporary.write_text(text, encoding="utf-8")
    os.replace(temporary, path)


def commit(root: Path) -> str:
    """The commit of the sources in a folder, with "-dirty" if something but documents is not committed; "unknown" outside of a repository."""
    def git(*command: str) -> str:
        return subprocess.run(["git", "-C", root, *command], check=True, capture_output=True, text=True).stdout.strip()
    try:
        changed = git("status", "--porcelain", "--untracked-files=no", "--", ".", ":!docs")
        return git("rev-parse", "--short=12", "HEAD") + ("-dirty" if changed else "")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def update(path: Path, made: dict[str, str], of: str) -> None:
    """Puts tables between the marks <!-- NAME --> and <!-- end --> of a document, each with the commit that it is of."""
    text = path.read_text(encoding="utf-8")
    for name, table in made.items():
        table += f"\nCommit `{of}`.\n"
        begin = text.find(f"<!-- {name} -->\n")
        end = text.find("<!-- end -->", begin)
        if begin < 0 or end < 0:
            raise DocumentError(f"{path}: no place for the table {name}")
        text = text[: text.index("\n", begin) + 1] + table + text[end:]
    write_atomically(path, text)
