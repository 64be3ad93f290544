"""The documentation site: Markdown pages in four kinds and a gallery of the library. `make docs` builds it, offline."""

import rbpsym

project = "rbpsym"
version = release = rbpsym.__version__
extensions = ["myst_parser"]
exclude_patterns = ["*.intro.md", "examples"]
html_theme = "furo"
html_title = "rbpsym"
myst_heading_anchors = 3
suppress_warnings = ["myst.xref_missing"]  # links to files of the repository: tests/architecture/test_docs.py follows them
