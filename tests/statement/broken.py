"""Broken statements: what a user writes wrong, the sentence that is told, and where its caret is.

Each row edits the sound statement `SOUND`. «» marks the characters under which the caret must
stand; the marks are taken away before the text is read.
"""

from __future__ import annotations

from tests.statement.sound import Broken

ROWS = [
    # --- TOML
    Broken("key without value", 'm   = "mass: mass', 'm   «"»mass: mass', "followed by “=”"),
    Broken("expression without quotes", 'mass   = "m"', "mass   = «m»", "not a value", 'mass = "M"'),
    Broken("text not ended", 'length = "ell"', 'length = "ell«\n»', "quote is missing"),
    Broken("two things after =", 'length = "ell"', 'length = "ell" «*» 2', "something after the value"),
    Broken("table twice", "[points]", "«[parameters]»", "this table is there already"),
    Broken("key twice", 'length = "ell"', 'length = "ell"\n«length» = "ell"', "this key is there already"),
    Broken("header not closed", "[bodies.bob]", "[bodies.bob«\n»", "table is not closed"),
    Broken("backslash", 'mass   = "m"', 'mass   = "«\\m»"', "a backslash"),
    # --- keys
    Broken("unknown section", "[notation]", "[«notations»]", "unknown key “notations”", "did you mean “notation”?"),
    Broken("unknown top key", "title = {", "«titel» = {", "unknown key “titel”", "did you mean “title”?"),
    Broken(
        "unknown key of a body",
        'length = "ell"',
        '«lenght» = "ell"',
        "unknown key “lenght” in the body “rod”",
        "did you mean “length”?",
    ),
    Broken("radius of a rod", 'length = "ell"', 'length = "ell"\n«radius» = "R"', "unknown key “radius”", "keys here"),
    Broken("unknown key of a coordinate", 'start   = "pi/3"', '«strat»   = "pi/3"', "unknown key “strat”", "“start”"),
    Broken("unknown key of an interaction", 'stiffness = "k"\n', '«stifness» = "k"\n', "unknown key “stifness”"),
    Broken(
        "unknown key of a constraint", 'line  = "y', '«lines»  = "y', "unknown key “lines” in contact “L”", "“line”"
    ),
    Broken("unknown key of a parameter", 'sign = "real"', '«signum» = "real"', "unknown key “signum”", "“sign”"),
    Broken("missing size", 'radius = "R"\n', "", "the body “disk” has no “radius”"),
    Broken("missing mass", 'mass  = "m"\n', "", "the body “bob” has no “mass”", 'add mass = "M"'),
    Broken("missing shape", 'shape = "particle"\n', "", "bodies.bob has no “shape”", "rod"),
    Broken("missing type", 'type = "gravity"\n', "", "interactions.W has no “type”", "gravity"),
    Broken("missing stiffness", 'stiffness = "k"\n', "", "spring “S” has no “stiffness”", "force per elongation"),
    Broken("contact without line", 'line  = "y = x*tan(beta)"\n', "", "contact “L” touches nothing", "write line ="),
    Broken("missing dimension", 'dimension = "force", ', "", "the parameter “F” has no “dimension”"),
    # --- kinds
    Broken("unknown shape", 'shape  = "disk"', 'shape  = «"dsik"»', "unknown shape “dsik”", "did you mean “disk”?"),
    Broken(
        "unknown interaction", 'type = "gravity"', 'type = «"gravitation"»', "unknown type “gravitation”", "“gravity”"
    ),
    Broken("unknown constraint", 'type  = "pivot"', 'type  = «"pivott"»', "unknown type “pivott”", "“pivot”"),
    Broken("constraint among interactions", 'type = "gravity"', 'type = «"weld"»', "unknown type “weld”", "types"),
    Broken(
        "unknown dimension", '"mass: mass of the rod"', '"«mas»: mass of the rod"', "unknown dimension “mas”", "“mass”"
    ),
    Broken("unknown sign", '"mass, nonnegative', '"mass, «nonegative»', "unknown sign “nonegative”", "“nonnegative”"),
    Broken("unknown choice", 'line  = "y', 'side  = «"left"»\nline  = "y', "must be one of auto, positive, negative"),
    # --- values of the wrong sort
    Broken("parameter is a number", '"acceleration: gravity"', "«9.81»", "must be a text, not a number"),
    Broken("mass is a list", 'mass   = "m"', 'mass   = «["m"]»', "an expression in quotes, not a list"),
    Broken("mass is empty", 'mass   = "m"', 'mass   = «""»', "not an empty text"),
    Broken("mass is true", 'mass   = "m"', "mass   = «true»", "not true or false"),
    Broken("place is one text", 'start  = ["0", "0"]', 'start  = «"0, 0"»', "not a fixed point", 'a pair ["0", "0"]'),
    Broken(
        "place has three parts",
        'start  = ["0", "0"]',
        'start  = «["0", "0", "0"]»',
        "a pair of expressions, not a list of 3",
    ),
    Broken("range is a text", 'range   = ["-pi/2", "pi/2"]', 'range   = «"pi/2"»', "must be a list of two"),
    Broken(
        "body is a text",
        '[bodies.bob]\nshape = "particle"\nmass  = "m"',
        '[bodies]\nbob = «"particle"»',
        "bodies.bob must be a table, not a text",
    ),
    Broken("title is a number", 'title = { en = "All things", es = "De todo" }', "title = «3»", "a text in quotes"),
    Broken("language", 'es = "De todo"', '«Spanish» = "De todo"', "“Spanish” is no language"),
    Broken("origins is a text", 'origins = ["O", "disk.cm"]', 'origins = «"O"»', "a list of points"),
    # --- references
    Broken("unknown body", '"rod.end"\nline', '"«rdo».end"\nline', "there is no body “rdo”", "did you mean “rod”?"),
    Broken(
        "unknown point", '"rod.end"\nline', '"rod.«tip»"\nline', "“rod” has no point “tip”", "its points: center, start"
    ),
    Broken("body for a point", '"rod.end"\nline', '«"rod"»\nline', "“rod” is a body, not a point", "rod.end"),
    Broken("unknown fixed point", '"rod.knot", "Q"', '"rod.knot", «"P1"»', "there is no point “P1”"),
    Broken("unknown origin", '"disk.cm"]', '"disk.«cmm»"]', "no point “cmm”", "did you mean “cm”?"),
    Broken("couple on an unknown body", 'on     = "disk"', 'on     = «"disc"»', "“disc” is not a body", "“disk”"),
    Broken(
        "torsion spring to an unknown body",
        '"ground", "rod"',
        '«"Ground"», "rod"',
        "“Ground” is not a body",
        "“ground”",
    ),
    Broken(
        "spring with one end", 'between   = ["rod.knot", "Q"]', 'between   = «["Q"]»', "must name two points, not 1"
    ),
    Broken(
        "gravity on an unknown body",
        'type = "gravity"',
        'type = "gravity"\nbodies = ["rod", «"rode"»]',
        "“rode” is not a body",
    ),
    # --- symbols and expressions
    Broken("unknown symbol", 'length = "ell"', 'length = "2*«el»"', "“el”", "ell"),
    Broken("unknown symbol in a list of lines", '"-ell*cos(theta)",', '"-ell*cos(«thta»)",', "“thta”", "theta"),
    Broken("unknown symbol in a line", '"y = x*tan(beta)"', '"y = x*tan(«bta»)"', "“bta”", "beta"),
    Broken("gravity without g", 'g   = "acceleration: gravity"\n', "", "“g”"),
    Broken(
        "coordinate in a length", 'length = "ell"', 'length = "ell*«theta»"', "must not depend on “theta”, a coordinate"
    ),
    Broken("speed in a pose", 'angle  = "phi"', 'angle  = "«phi_dot»"', "must not depend on “phi_dot”, a speed"),
    Broken("coordinate in a line", '"y = x*tan(beta)"', '"y = x*tan(«phi»)"', "must not depend on “phi”"),
    Broken("open parenthesis", '"-ell*cos(theta)",', '"-ell*cos«(»theta",', "", ""),
    Broken("operator at the end", 'length = "ell"', 'length = "2*ell +"', ""),
    Broken("division by zero", 'length = "ell"', 'length = "«ell/(1 - 1)»"', "divides by zero"),
    Broken("Greek name", 'k   = "stiffness', '«"κ"»   = "stiffness', "“κ” can't be a name", "a-z"),
    # --- dimensions
    Broken(
        "length for an angle",
        'angle  = "phi"',
        'angle  = "«ell»"',
        "must be an angle or a number, but this is a length",
    ),
    Broken("mass plus length", 'length = "ell"', 'length = "M + «ell»"', "a length is added to a mass"),
    Broken("angle plus length", '"ell*sin(theta)", ', '"ell + «theta»", ', "an angle or a number is added to a length"),
    Broken("mass for a length", 'length = "ell"', 'length = "«m»"', "must be a length, but this is a mass"),
    Broken("sine of a length", '"ell*sin(theta)", ', '"ell*sin(«ell»)", ', "the argument of sin must be an angle"),
    Broken("number for a mass", 'mass   = "m"', 'mass   = "«2»"', "must be a mass, but this is an angle or a number"),
    Broken("stiffness of a torsion spring", 'stiffness = "kappa"', 'stiffness = "«k»"', "must be a"),
    Broken("force for a couple", 'couple = "F*R"', 'couple = "«F»"', "must be a torque, but this is a force"),
    Broken("start of another dimension", 'start   = "pi/3"', 'start   = "«ell»"', "must be an angle or a number"),
    Broken("line that mixes", '"y = x*tan(beta)"', '"y = «tan(beta)»"', "must be a length"),
    Broken(
        "length that was not said to be one",
        'start  = ["0", "0"]',
        'start  = ["«phi»", "0"]',
        "must be a length",
        'dimension = "length" in [coordinates.phi]',
    ),
    # --- starts and ranges
    Broken("start outside", 'start   = "pi/3"', 'start   = «"2*pi/3"»', "outside its range", "between -pi/2 and pi/2"),
    Broken("start below", 'start   = "pi/3"', 'start   = «"-1.6"»', "outside its range"),
    Broken("range upside down", '["-pi/2", "pi/2"]', '«["pi/2", "-pi/2"]»', "range of “theta” is empty"),
    Broken("misspelt start", 'start   = "pi/3"', 'start   = "«betas»"', "“betas”", "beta"),
    # --- names
    Broken(
        "parameter and coordinate",
        "[coordinates.phi]",
        "[coordinates.«beta»]",
        "“beta” is the name of a parameter and of a coordinate",
    ),
    Broken("reserved parameter", 'k   = "stiffness', '«t»   = "stiffness', "“t” is reserved: it means the time"),
    Broken("axis as a parameter", 'k   = "stiffness', '«x»   = "stiffness', "“x” is reserved: it means an axis"),
    Broken("name with a hyphen", 'k   = "stiffness', '«k-1»   = "stiffness', "“k-1” can't be a name"),
    Broken("quoted name", 'k   = "stiffness', '«"k 1"»   = "stiffness', "“k 1” can't be a name"),
    Broken("name of a speed", 'k   = "stiffness', '«theta_dot»   = "stiffness', "can't be declared"),
    Broken("reserved body", "[bodies.bob]", "[bodies.«ground»]", "“ground” is reserved"),
    Broken(
        "interaction and constraint",
        "[constraints.A]",
        "[constraints.«W»]",
        "the name of an interaction and of a constraint",
    ),
    Broken(
        "unknown force and parameter",
        'k   = "stiffness',
        'N_x = "length"\nk   = "stiffness',
        "“N_x” is the name of a parameter and of an unknown of the pin “N”",
    ),
    Broken("body and point", "[bodies.bob]", "[bodies.«Q»]", "“Q” is the name of a point and of a body"),
    Broken("own point twice", "knot = [", "«end» = [", "has “end” already"),
    Broken(
        "notation of nothing",
        'theta_dot = "omega"',
        '«thetadot» = "omega"',
        "[notation] speaks of “thetadot”",
        "theta_dot",
    ),
    Broken("meaning of nothing", 'm = "masa', '«mm» = "masa', "speaks of “mm”"),
    Broken("example of nothing", 'ell = "1 m"', '«l» = "1 m"', "speaks of “l”"),
    # --- what can't be meant
    Broken("slanted direction", 'type = "gravity"', 'type = "gravity"\ndirection = ["1", "-1"]', "no unit vector"),
    Broken(
        "body frame of a particle",
        'on    = "disk.center"',
        'on    = "bob.cm"\nframe = "body"',
        "a particle, which has no angle",
    ),
    Broken("negative length", 'length = "ell"', 'length = "«-ell»"', "must be positive, but this is negative"),
    Broken("no length", 'length = "ell"', 'length = "«0»"', "must be positive, but this is zero"),
    Broken("negative mass", 'mass   = "m"', 'mass   = "«-2*m»"', "must be nonnegative, but this is negative"),
    Broken("placed twice", 'start  = ["0", "0"]', 'start  = ["0", "0"]\n«center» = ["ell/2", "0"]', "placed twice"),
    Broken("angle of a particle", 'mass  = "m"', 'mass  = "m"\n«angle» = "theta"', "it has no angle"),
    Broken("density of no mass", 'mass   = "m"', 'mass   = "m"\n«density» = "ell - 2*s"', "is zero in all", "how it varies"),
    Broken("line without =", '"y = x*tan(beta)"', '«"y - x"»', "an equation with one “=”"),
    Broken("curve for a line", '"y = x*tan(beta)"', '«"y = x**2/ell"»', "is not a straight line"),
    Broken("line without x and y", '"y = x*tan(beta)"', '«"ell = R"»', "is not a straight line"),
    Broken("line that is everywhere", '"y = x*tan(beta)"', '«"x = x"»', "is not a straight line"),
    Broken(
        "pin of one body", '["rod.end", "disk.center"]', '["rod.end", "rod.start"]', "joins the body “rod” to itself"
    ),
    Broken("pin to a place", '["rod.end", "disk.center"]', '["rod.end", "O"]', "a fixed place", "pivot"),
    Broken("pivot of a place", 'point = "rod.start"', 'point = "O"', "“O”, a fixed place"),
    Broken("spring of one body", '"rod.knot", "Q"', '"rod.knot", "rod.end"', "two points of one body"),
    Broken("spring of no body", '"rod.knot", "Q"', '"O", "Q"', "joins two fixed places"),
    Broken("torsion spring of one body", '"ground", "rod"', '"rod", "rod"', "joins “rod” to itself"),
    Broken("torsion spring on a particle", '"ground", "rod"', '"ground", "bob"', "a particle, which has no angle"),
    Broken("couple on a particle", 'on     = "disk"', 'on     = "bob"', "a particle, which has no angle"),
    Broken(
        "coordinate that nothing uses", 'angle  = "phi"', 'angle  = "0"', "no body's pose uses the coordinate “phi”"
    ),
    Broken(
        "pivot of an unplaced point", 'start  = ["0", "0"]\n', "", "does not say where “rod.start” is held", "at = "
    ),
    Broken("pivot that moves", 'start  = ["0", "0"]', 'start  = ["ell*cos(phi)", "0"]', "lets it move with “phi”"),
    Broken("no direction", 'type = "gravity"', 'type = "gravity"\ndirection = ["0", "0"]', "no unit vector"),
    Broken(
        "contact twice",
        "[notation]",
        '[constraints.L2]\ntype = "contact"\npoint = "rod.end"\nline = "y = x*tan(beta)"\n[notation]',
        "says again what “L” says",
    ),
    # --- words and units brought along from elsewhere
    Broken("bar for a rod", 'shape  = "rod"', 'shape  = «"bar"»', "unknown shape “bar”", "write “rod”."),
    Broken("weight", 'type = "gravity"', 'type = "weight"', "unknown type “weight”", "write “gravity”."),
    Broken("degrees", '"pi/3"', '"60 «deg»"', "unknown symbol “deg”", "radians"),
    Broken("degrees as a number", '"pi/3"', '«"60"»', "outside its range", "60*pi/180"),
    Broken("number with a unit", '"omega_0"', '"5 «s»"', "unknown symbol “s”", "in [example]"),
    Broken("cosine", '"ell*sin(theta)"', '"ell*«cosine»(theta)"', "unknown symbol “cosine”", "Write cos(x)."),
    Broken(
        "value for a dimension",
        '"mass: mass of the rod"',
        '"«5 kg»"',
        "unknown dimension",
        'here stands what it is: "mass',
    ),
    Broken("sign for a dimension", '"mass: mass of the rod"', '"«real»: mass of the rod"', "unknown dimension", '"length, real:'),
    Broken("meaning for a dimension", '"mass: mass of the rod"', '"«mass of the rod»"', "unknown dimension", "a colon"),
    Broken("undeclared", '= "k"', '= "«c»"', "unknown symbol “c”", '[parameters]: c = "stiffness: '),
    Broken("no value at the start", '"theta - pi/2"', '"«ln(theta - 3/2)»"', "outside its domain at the start"),
    Broken(
        "string tied to a fixed point on its way",
        "[notation]",
        '[constraints.«K»]\ntype = "string"\npath = ["bob.center", "Q", "rod.end"]\n[notation]',
        "to which it is tied",
        "around",
    ),
    Broken("number for a length", 'length = "ell"', 'length = "«2»"', "must be a length", "multiply it by a parameter"),
]
