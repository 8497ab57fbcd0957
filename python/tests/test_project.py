"""pyproject.toml says of the project what CITATION.cff says."""
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).parents[2]


def cited(name, text):
    """The values of a member of CITATION.cff, of the software itself or of one of its references."""
    return [value.strip('"') for value in re.findall(rf"^ *(?:- )?{name}: (.*)$", text, re.M)]


def test_pyproject_says_what_the_citation_says():
    tomllib = pytest.importorskip("tomllib")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    software = text.partition("references:")[0]
    assert [author["name"] for author in project["authors"]] == cited("name", software) != []
    assert [project["version"]] == cited("version", software) and [project["license"]["text"]] == cited("license", software)
    # A home page, as soon as the citation has one; until then the paper.
    urls = cited("url", software) + cited("repository-code", software) + [f"https://doi.org/{doi}" for doi in cited("doi", text)]
    assert sorted(project["urls"].values()) == sorted(urls) != []
