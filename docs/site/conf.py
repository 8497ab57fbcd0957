# The site: the documents as they are in the repository, and the reference of the public headers (cmake/site.cmake).
import logging
import re

from breathe.renderer.sphinxrenderer import SphinxRenderer

project = "epsnet"
author = "The epsnet authors"
copyright = "the epsnet authors"
extensions = ["myst_parser", "breathe"]
exclude_patterns = ["README.md"]  # Included by index.md.
myst_heading_anchors = 4
breathe_default_project = "epsnet"
primary_domain = "cpp"
highlight_language = "none"
html_theme = "furo"
html_title = "epsnet"
html_show_sphinx = False

# Every header opens the namespaces again, which is no second declaration of them.
create_doxygen_target = SphinxRenderer.create_doxygen_target


def create_target_but_of_namespaces(self, node):
    return [] if getattr(node, "kind", None) == "namespace" else create_doxygen_target(self, node)


def is_no_namespace_again(record):
    return not re.search(r"Duplicate C\+\+ declaration[^\n]*\n.*cpp:type:: (epsnet|certify|unproved)'", record.getMessage())


SphinxRenderer.create_doxygen_target = create_target_but_of_namespaces
logging.getLogger("sphinx.sphinx.domains.cpp").addFilter(is_no_namespace_again)
