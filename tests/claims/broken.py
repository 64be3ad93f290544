"""Broken claims files: what is written, and words that the sentence must hold."""

HEAD = """
[settings.ladder]
problem = "sliding-ladder"
[settings.ladder.symbols]
'\\theta' = "theta"
'\\alpha' = "acceleration of theta"
'g' = "g"
'\\ell' = "ell"
"""
CLAIM = """
[[claim]]
id = "a"
setting = "ladder"
latex = '''\\alpha=-\\frac{3g}{4\\ell}\\cos\\theta'''
"""

LOADING = {
    "no claims": (HEAD, "without claims"),
    "not TOML": ("[[claim]\n", "the name of the table is not closed"),
    "backslash": (HEAD + '[[claim]]\nid = "a"\nlatex = "\\ell"\n', "single quotes"),
    "unknown key": (HEAD + CLAIM + "colour = 1\n", "unknown key “colour”"),
    "near key": (HEAD + CLAIM.replace("latex", "latax"), "did you mean “latex”"),
    "no id": (HEAD + CLAIM.replace('id = "a"', ""), "has no “id”"),
    "id twice": (HEAD + CLAIM + CLAIM, "two claims are called “a”"),
    "unknown setting": (HEAD + CLAIM.replace('"ladder"', '"lader"'), "did you mean “ladder”"),
    "no formula": (HEAD + '[[claim]]\nid = "a"\nsetting = "ladder"\n', "has no formula"),
    "empty formula": (HEAD + '[[claim]]\nid = "a"\nsetting = "ladder"\nlatex = " "\n', "is empty"),
    "expectation": (HEAD + CLAIM + 'expect = "true"\n', "“true” is not a value of “expect”"),
    "depth": (HEAD + CLAIM + 'holds = "always"\n', "“always” is not a value of “holds”"),
    "right without refuted": (HEAD + CLAIM + "right = 'a=b'\n", "belongs to a claim that is refuted"),
    "erratum without refuted": (HEAD + CLAIM + 'erratum = "E1"\n', "an erratum is a claim that is refuted"),
    "line": (HEAD + CLAIM + 'line = "12"\n', "number of a line"),
    "number": (HEAD + CLAIM + "number = true\n", "number of the equation"),
    "given": (HEAD + CLAIM + "given = 3\n", "list of formulas"),
    "neither": ("[settings.x]\n" + CLAIM, "neither a problem nor a theory"),
    "both": ('[settings.x]\nproblem = "a"\ntheory = "b"\n' + CLAIM, "both a problem and a theory"),
    "like": ('[settings.x]\nlike = "y"\n' + CLAIM, "there is no setting “y” above"),
    "flag": ('[settings.x]\ntheory = "plane-motion"\nfixed_axis = "yes"\n' + CLAIM, "true or false"),
    "symbol": (HEAD + "'M' = 3\n" + CLAIM, "must be a text"),
    "claims are no table": ("claim = 3\n", "list of tables"),
}

CHECKING = {
    "unknown phrase": ('"acceleration of theta"', '"acceleratoin of theta"', "means nothing"),
    "unknown body": ('"acceleration of theta"', '"angular velocity of leder"', "there is no body “leder”"),
    "unknown force": ('"acceleration of theta"', '"work of N_x on ladder"', "no force “N_x”"),
    "unknown point": ('"acceleration of theta"', '"velocity of ladder.top"', "has no point “top”"),
    "unknown problem": ('"sliding-ladder"', '"sliding-lader"', "did you mean “sliding-ladder”"),
    "unknown symbol": (r"\frac{3g}{4\ell}", r"\frac{3k}{4\ell}", "unknown symbol “k”"),
    "unknown command": (r"\cos\theta", r"\foo\theta", r"“\foo”"),
    "open brace": (r"\frac{3g}{4\ell}", r"\frac{3g}{4\ell", "never closed"),
    "an expression": (r"\alpha=-", r"-", ""),
}
