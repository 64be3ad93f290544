"""From display trees to boxes and from boxes to LaTeX, Typst, MathML, OMML, text, speech and text for machines."""
