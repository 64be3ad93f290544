"""The verbs of the grammar in their forms: “reach”, “reaches”, “reached”, “reaching”, with what may stand before them."""

from __future__ import annotations

# what a verb is called in the grammar -> what may be said, the forms of irregular ones written out
VERBS = {
    "Reach": "reach get+to|gets+to|got+to|getting+to "
             "come+to|comes+to|came+to|coming+to arrive+at|arrives+at|arrived+at|arriving+at "
             "pass|passes|passed|passing pass+through|passes+through|passed+through|passing+through attain "
             "is+at|are+at|be+at|being+at go+through|goes+through",
    "Hit": "hit|hits|hitting strike|strikes|struck|striking collide+with|collides+with|collided+with|colliding+with "
           "land+on|lands+on|landed+on|landing+on touch impact bounce+off|bounces+off bounce+on|bounces+on "
           "meet|meets|met|meeting",
    "Leave": "leave|leaves|left|leaving lose+contact+with|loses+contact+with|lost+contact+with|losing+contact+with "
             "lift+off|lifts+off|lifted+off|lifting+off fly+off|flies+off come+off|comes+off separate+from|separates+from "
             "lose+contact|loses+contact|losing+contact lift|lifts|lifting lift+from|lifts+from",
    "Stop": "stop|stops|stopped|stopping come+to+rest|comes+to+rest|came+to+rest|coming+to+rest come+to+a+stop|comes+to+a+stop "
            "is+at+rest|be+at+rest is+brought+to+rest|being+brought+to+rest|be+brought+to+rest halt "
            "come+to+a+halt|comes+to+a+halt come+to+a+complete+stop|comes+to+a+complete+stop "
            "is+momentarily+at+rest|comes+momentarily+to+rest|comes+to+rest+momentarily",
    "Return": "return come+back|comes+back|came+back|coming+back go+back|goes+back is+back",
    "Fall": "fall|falls|fallen|falling|fell drop|drops|dropped|dropping descend sink|sinks|sunk|sinking|sank lower",
    "Rise": "rise|rises|risen|rising|rose climb ascend raise|raises|raised|raising",
    "Go": "move travel|travels|travelled|travelling|traveled|traveling roll slide|slides|slid|sliding go|goes|gone|going|went "
          "advance cover run|runs|running",
    "Turn": "turn rotate|rotates|rotated|rotating swing|swings|swung|swinging spin|spins|spun|spinning",
    "Tip": "tip|tips|tipped|tipping topple overturn tip+over|tips+over|tipping+over topple+over|topples+over",
    "Cut": "is+cut|being+cut|was+cut is+removed|being+removed|was+removed "
           "is+released|was+released is+let+go is+switched+off is+turned+off "
           "is+burned is+burnt "
           "break|breaks|broke|breaking snap|snaps|snapped|snapping fail is+severed is+taken+away is+disconnected",
}  # fmt: skip


def forms(row: str) -> list[str]:
    """All forms of the verbs of a row; those of a regular one are made."""
    found: list[str] = []
    for verb in row.split():
        words = [word.replace("+", " ") for word in verb.split("|")]
        if len(words) == 1:
            stem = words[0].removesuffix("e")
            words += [f"{words[0]}{'es' if words[0].endswith(('h', 's')) else 's'}", f"{stem}ed", f"{stem}ing"]
        found += words
    return list(dict.fromkeys(found))


def patterns() -> dict[str, str]:
    """The rows of the grammar for verbs: what may help them, and a form."""
    return {name: f"[Aux] ({'|'.join(forms(row))}) -> " for name, row in VERBS.items()}
