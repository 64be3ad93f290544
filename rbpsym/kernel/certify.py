"""A derivation as Rocq source: each claim of each step as a lemma from the premises of that step."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property

from rbpsym.errors import RbpsymError, Undecided
from rbpsym.expr import tree as t
from rbpsym.field.effort import at_most
from rbpsym.frozen import Frozen, field, replace
from rbpsym.kernel.certificates import Lemma, Proof
from rbpsym.kernel.claim import Proposition, SaidByStep
from rbpsym.kernel.claims import ClaimSource
from rbpsym.kernel.components import START
from rbpsym.kernel.proofs import Search
from rbpsym.kernel.reading import read_back
from rbpsym.kernel.rocq import Terms, Writer, identifier
from rbpsym.proof.step import Derivation, Step

MOST_PRODUCTS = 2_000_000  # of terms, in the search for one step: seven times what any known proof takes
Propositions = Mapping[str, Proposition]  # by their names


class Written(Frozen):
    """lemmas: those of each step, by its id; refused: why a step has none; unused: premises that no proof named."""

    source: ClaimSource
    lemmas: dict[str, list[Lemma]] = field(default_factory=dict)
    refused: dict[str, str] = field(default_factory=dict)
    unused: dict[str, tuple[str, ...]] = field(default_factory=dict)

    @cached_property
    def writer(self) -> Writer:
        """How the problem is written in Rocq."""
        speeds = {name: f"{name}_dot" for name in self.source.study.system.coordinates}
        return Writer(self.source, Terms(self.source.moving, speeds, self.source.integrals))

    def text(self, without: Collection[str] = (), *, trial: bool = False) -> str:
        """The Rocq source."""
        return text(self, without=without, trial=trial)


def named(id: str, said: SaidByStep) -> dict[str, Proposition]:
    """The claims of a step or fact by their names in Rocq."""
    found = {identifier(f"{id}.d{place}"): claim for place, claim in enumerate(said.definitions, 1)}
    return found | {identifier(f"{id}.{place}"): claim for place, claim in enumerate(said.assertions, 1)}


def written(derivation: Derivation, ids: Iterable[str] | None = None) -> Written:
    """All steps of a derivation, or those of these ids and what they follow from."""
    found, needed = Written(ClaimSource(derivation)), {step.id for step in derivation.steps} if ids is None else set(ids)
    derivation = found.source.derivation
    for step in reversed(derivation.steps):
        needed |= set(step.premises if step.id in needed else ())
    for step in (step for step in derivation.steps if step.id in needed):
        try:
            with at_most(MOST_PRODUCTS):
                lemmas = found.lemmas[step.id] = list(_lemmas(found, step))
            said = found.source.said[step.id]  # from now on with the conditions on which it was shown
            found.source.said[step.id] = replace(said, assertions=tuple(lemma.claim for lemma in lemmas))
        except (RbpsymError, ZeroDivisionError) as error:
            found.refused[step.id] = str(error)
    return found


def granted(source: ClaimSource, step: Step) -> dict[str, Proposition]:
    """The claims that a step may use: its own definitions, and what its premises say."""
    claims = named(step.id, SaidByStep(source.said[step.id].definitions))
    for id in (id for id in step.premises if id != source.own.get(step.id)):
        claims |= named(id, source.said[id] if id in source.said else source.fact(id))
    return claims


def declared(source: ClaimSource) -> dict[str, Proposition]:
    """What is in force for every step: the declared ranges, of which its obligations may be discharged."""
    claims: dict[str, Proposition] = {}
    for name in source.study.assumptions.ranges:
        with suppress(RbpsymError):  # an end that has no term
            claims |= named(f"range.{name}", source.fact(f"range.{name}"))
    return claims


def _lemmas(found: Written, step: Step) -> Iterator[Lemma]:
    claims, used = granted(found.source, step), set[str]()
    further = {name: claim for name, claim in declared(found.source).items() if name not in claims}
    own = named(step.id, SaidByStep(assertions=found.source.said[step.id].assertions))
    if not own:
        raise RbpsymError(found.source.unsaid.get(step.id, "there is no statement for it yet"))
    for name, claim in own.items():
        made = lemma_of(found, name, claim, found.source.conditions(step), (claims, further))
        used |= made.premises.keys()
        yield made
    idle = [id for id in step.premises if not any(name.startswith(identifier(id) + "'") for name in used)]
    found.unused.update({step.id: tuple(idle)} if idle else {})


def lemma_of(
    found: Written, name: str, claim: Proposition, printed: Iterable[Proposition], known: tuple[Propositions, Propositions]
) -> Lemma:
    """A claim as a lemma; where it needs them, on the `printed` conditions. known: premises, what is declared."""
    read_back(found.writer.said(claim), claim, found.source)  # raises for what has no term
    claim, proof, search = _proved(found.source, name, printed, claim, known)
    every = search.given
    names = _used(search, claim, proof, every)
    return Lemma(name, claim, {name: item for name, item in every.items() if name in names}, proof)


def _proved(
    source: ClaimSource, name: str, printed: Iterable[Proposition], claim: Proposition, known: tuple[Propositions, Propositions]
) -> tuple[Proposition, Proof, Search]:
    claims, further = known
    held = (part for item in (*claims.values(), *further.values()) for part in item.given)
    conditions = [part for part in dict.fromkeys((*printed, *held)) if part not in claim.given]
    lasting = {f"{name}'while{place}": part for place, part in enumerate(conditions, 1)}
    made = None
    for given, more in ((claim.given, {}), ((*claim.given, *conditions), {}), (claim.given, lasting))[: 3 if conditions else 1]:
        search = Search(source, {**claims, **further, **more}, further)
        try:
            made = replace(claim, given=given), search.prove(replace(claim, given=given)), search
        except Undecided:
            if made is None and (more or not conditions):
                raise
        if made is not None and search.is_sure:
            break
    assert made is not None, "what is not proved was raised"
    return made


def _used(search: Search, claim: Proposition, proof: Proof, claims: Mapping[str, Proposition]) -> set[str]:
    """Names of premises in a proof; rates and starts of letters are used where derivatives are taken."""
    parts = [proof.multiples, *(proof.like or ())[1:], *(by for have in proof.steps for by in have.accounts)]
    names = {known.name for part in parts for _, known in part.known}
    names |= {name for have in proof.steps for name in have.source.split()} | {name for name in claims if "'while" in name}
    derived = [node for have in proof.steps for node in (have.of, have.claim.left)] + list((proof.like or ())[:1])
    rated = _letters(search.source, derived)
    early = [known.claim for part in parts for _, known in part.known if known.when == "0"]
    flat = [each.claim.left for have in proof.steps if have.how in ("flat", "course") for each in (have, have.inner) if each]
    begun = _letters(search.source, [*flat, *(side for each in early for side in (each.left, each.right))])
    begun |= {n.removesuffix(START) for side in (claim.left, claim.right) for n in t.names(side) if n.endswith(START)}
    needs = {"rate": rated, "start": begun}
    claims = {name: each for name, each in claims.items() if name not in search.doubled}
    return names | {n for n, c in claims.items() if getattr(c.left, "name", "") in needs.get(c.kind, ())}


def _letters(source: ClaimSource, nodes: Sequence[t.Node]) -> set[str]:
    """The letters in some formulas and in the integrals that stand in them."""
    inner = [source.integrals[name] for node in nodes for name in t.names(node) & source.integrals.keys()]
    found = {name.removesuffix(START) for node in (*nodes, *inner) for name in t.names(node)}
    return found | {node.var for node in inner}


def results(found: Written, without: Collection[str] = ()) -> Iterator[str]:
    """Each boxed result as one theorem, with those on its way: from laws, starts, ranges and definitions alone."""
    lemmas = {lemma.name: lemma for each in found.lemmas.values() for lemma in each if lemma.name not in without}
    boxed = [lemma for step in found.source.derivation.steps if step.is_result for lemma in found.lemmas.get(step.id, ())]
    needed, left = set[str](), [lemma.name for lemma in boxed]
    while left:
        if (name := left.pop()) in lemmas and name not in needed:
            needed.add(name)
            left += lemmas[name].premises
    grounds: dict[str, dict[str, None]] = {}  # of each what it stands on at last, in order
    for name in (name for name in lemmas if name in needed):
        own = {premise: grounds.get(premise, {premise: None}) for premise in lemmas[name].premises}
        grounds[name] = dict.fromkeys(leaf for leaves in own.values() for leaf in leaves)
        shown = (" ".join((f"({premise}'result", *(f"h_{leaf}" for leaf in own[premise]))) + ")" if premise in grounds
                 else f"h_{premise}" for premise in own)  # fmt: skip
        enter = "".join(f" h_{leaf}" for leaf in grounds[name])
        body = " ".join((f"{name}'holds", *shown))
        yield (f"Theorem {name}'result : {''.join(f'{leaf} -> ' for leaf in grounds[name])}{name}.\n"
               f"Proof. {f'intros{enter}; ' if enter else ''}exact ({body}). Qed.")  # fmt: skip


def text(found: Written, *, without: Collection[str] = (), trial: bool = False) -> str:
    """The Rocq source; on `trial`, each lemma that is not accepted only says so and nothing is kept."""
    writer = found.writer
    lemmas = [lemma for each in found.lemmas.values() for lemma in each]
    claims: dict[str, Proposition] = {}
    for lemma in lemmas:
        claims |= {**lemma.premises, lemma.name: lemma.claim}
    lines = [*writer.opening(), *writer.letters(claims.values())]
    told = {name: read_back(writer.said(claim), claim, found.source) for name, claim in claims.items()}
    lines += [f"Definition {name} : Prop := {said}." for name, said in told.items()]
    kept = [lemma for lemma in lemmas if lemma.name not in without]
    lines += [writer.trial(lemma) if trial else writer.lemma(lemma) for lemma in kept]
    whole = ", ".join(f"{lemma.name}'holds" for lemma in kept)
    lines += [] if trial else results(found, without)
    lines += [] if trial or not kept else [f"Definition all'of'it := ({whole}).", "Print Assumptions all'of'it."]
    return "\n".join([*lines, "End Problem.", ""])
