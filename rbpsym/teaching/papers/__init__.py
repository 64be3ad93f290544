"""Papers: a worksheet, its key and its solution as pages (PDF, LaTeX exam class, HTML)."""
