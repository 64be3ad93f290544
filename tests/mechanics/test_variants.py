"""The shipped problems stated otherwise: the physics stays, and every step is proved again."""

from fractions import Fraction

import pytest

from rbpsym.field.normal import same
from rbpsym.field.scalar import PI, symbol
from tests.mechanics.textbook import answer, complaints, derivation, read
from tests.mechanics.variants import changed, edited, image, names_as_scalars, renamed, shipped, values

LADDERS = ("sliding-ladder", "sliding-ladder-with-spring")
PENDULUMS = ("rod-and-disk-fixed", "rod-and-disk-free")

NAMES = {
    "m": "b",
    "M": "m",
    "ell": "q",
    "R": "r_1",
    "g": "a",
    "k": "kappa",
    "theta": "phi",
    "phi": "psi",
    "theta_0": "alpha_1",
    "omega_0": "v",
    "phi_0": "w",
    "beta_0": "z",
    "ladder": "plank",
    "rod": "bar",
    "disk": "wheel",
    "W": "G",
    "F": "A",
    "N": "B",
    "N_w": "S",
    "N_f": "T",
    "F_s": "K",
    "tau": "C",
    "omega": "nu",
    "beta": "eta",
}


@pytest.mark.parametrize("name", (*LADDERS, *PENDULUMS))
def test_other_names(name: str) -> None:
    original = shipped(name)
    variant = renamed(original, NAMES).replace('type = "gravity"', 'type = "gravity"\ng = "a"')
    parts = {f"{n}_{axis}": f"{NAMES[n]}_{axis}" for n in ("F", "N") for axis in "xy"}
    used = {a: b for a, b in NAMES.items() if a not in ("omega", "beta")}
    images = names_as_scalars(used, parts)
    images |= {f"d_{n}": symbol(f"d_{NAMES[n]}") for n in ("theta", "phi")}
    before, after = dict(values(answer(original))), dict(values(answer(variant)))
    keys = {**NAMES, **parts}
    wrong = []
    for path, value in before.items():
        if path[0] in ("problem", "coordinates", "symbols") or path[-1] == "force" or "speeds" in path:
            continue
        other = after[tuple(keys.get(key, key) if k else key for k, key in enumerate(path))]
        if not same(image(original, value, images), read(variant, other)):
            wrong.append((path, value, other))
    assert not wrong
    assert len(before) == len(after) > 30
    assert not complaints(variant)


# --- mirrored


SIGNLESS = ("kinetic_energy/total", "potential_energy", "first_integral")


@pytest.mark.parametrize("name", LADDERS)
def test_ladder_on_the_other_wall(name: str) -> None:
    original = shipped(name)
    variant = edited(original, (r'center = \["ell', 'center = ["-ell'), ('"pi - theta"', '"theta"'))
    paths = {
        p: (p, 1)
        for p in (
            *SIGNLESS,
            "accelerations/theta",
            "speed_squared/theta",
            "reactions/N_w",
            "reactions/N_f",
            "reactions_along_motion/N_w",
            "reactions_along_motion/N_f",
            "works/N_w/ladder/translational/value",
            "works/N_f/ladder/rotational/value",
            "conditions/0/vanishes",
        )
        if answer(original)["conditions"] or not p.startswith("conditions")
    }
    paths |= {
        f"angular_momentum/O/ladder/{half}": (f"angular_momentum/O/ladder/{half}", -1) for half in ("orbital", "spin")
    }
    if [c["vanishes"] for c in answer(original)["conditions"]] != [c["vanishes"] for c in answer(variant)["conditions"]]:
        paths.pop("conditions/0/vanishes", None)
    assert not changed(original, variant, {}, paths)
    assert not complaints(variant)


@pytest.mark.parametrize("name", PENDULUMS)
def test_pendulum_to_the_other_side(name: str) -> None:
    original = shipped(name)
    variant = edited(
        original,
        (r'"ell\*sin\(theta\)"', '"-ell*sin(theta)"'),
        ('"theta - pi/2"', '"-theta - pi/2"'),
        (r'^angle  = "(theta|phi)"', f'angle = "-{"theta" if "fixed" in name else "phi"}"'),
    )
    paths = {
        p: (p, 1)
        for p in (
            *SIGNLESS,
            "accelerations/theta",
            "reactions/F_y",
            "reactions/N_y",
            "equilibria/0/frequencies_squared/0",
            "works/N/disk/translational/value",
        )
    }
    flipped = [
        "reactions/F_x",
        "reactions/N_x",
        "angular_momentum/O/rod/spin",
        "angular_momentum/O/disk/orbital",
        "angular_momentum/O/disk/spin",
        *(["reactions/tau"] if "fixed" in name else []),
    ]
    images = {"F_x": -symbol("F_x"), "N_x": -symbol("N_x")}
    assert not changed(original, variant, images, paths | {p: (p, -1) for p in flipped})
    assert not complaints(variant)


# --- the ladder's angle against the wall


@pytest.mark.parametrize("name", LADDERS)
def test_angle_against_the_wall(name: str) -> None:
    original = shipped(name)
    variant = edited(
        original,
        (r"cos\(theta\)", "SIN"),
        (r"sin\(theta\)", "cos(psi)"),
        ("SIN", "sin(psi)"),
        ('"pi - theta"', '"pi/2 + psi"'),
        (r"coordinates\.theta", "coordinates.psi"),
        ('"theta_0"', '"psi_0"'),
        ("^theta_d", "psi_d"),
    )
    if "spring" in name:
        variant = edited(variant, (r"cos\(theta_0\)", "sin(psi_0)"))
    quarter = PI * Fraction(1, 2)
    images = {"theta": quarter - symbol("psi"), "theta_0": quarter - symbol("psi_0"), "theta_dot": -symbol("psi_dot")}
    paths = {
        p: (p, 1)
        for p in (
            *SIGNLESS,
            "reactions/N_w",
            "reactions/N_f",
            "reactions_along_motion/N_w",
            "reactions_along_motion/N_f",
            "angular_momentum/O/ladder/orbital",
            "angular_momentum/O/ladder/spin",
            "works/N_w/ladder/translational/value",
            "works/N_f/ladder/rotational/value",
        )
    }
    paths |= {"accelerations/theta": ("accelerations/psi", -1), "speed_squared/theta": ("speed_squared/psi", 1)}
    assert not changed(original, variant, images, paths)
    assert not complaints(variant)


# --- more coordinates than degrees of freedom


LENGTH = '[coordinates.{0}]\ndimension = "length"\nmeaning = "a place"\n'
MORE = "".join(LENGTH.format(name) for name in "xy")
SAME = ("accelerations/theta", "speed_squared/theta", "kinetic_energy/total", "potential_energy", "first_integral")


def _keep(original: str) -> dict[str, tuple[str, int]]:
    """All results of the original that the variant must have as they are."""
    reactions = [f"reactions/{n}" for n in answer(original)["reactions"]]
    momenta = ["/".join(p) for p, _ in values(answer(original)) if p[0] in ("angular_momentum", "moments_of_inertia")]
    return {p: (p, 1) for p in (*SAME[:1], *SAME[2:], *reactions, *momenta)}


@pytest.mark.parametrize("name", LADDERS)
def test_ladder_in_three_coordinates(name: str) -> None:
    original = shipped(name)
    variant = edited(
        original, (r"^center = .*", 'center = ["x", "y"]'), (r"^\[bodies\.ladder\]", MORE + "[bodies.ladder]")
    )
    found = answer(variant)
    assert found["degrees_of_freedom"] == 1
    assert same(read(variant, found["dependent_coordinates"]["x"]), read(variant, "ell*cos(theta)"))
    assert same(read(variant, found["dependent_coordinates"]["y"]), read(variant, "ell*sin(theta)"))
    assert same(read(variant, found["accelerations"]["x"]), read(variant, _second("cos", "sin", found)))
    assert not changed(original, variant, {}, _keep(original) | {"speed_squared/theta": ("speed_squared/theta", 1)})
    assert not complaints(variant)


def _second(f: str, df: str, found) -> str:
    """d²(ell cos θ)/dt²."""
    return f"-ell*({f}(theta)*theta_dot**2 + {df}(theta)*({found['accelerations']['theta']}))"


@pytest.mark.parametrize("name", PENDULUMS)
def test_pendulum_in_five_coordinates(name: str) -> None:
    original = shipped(name)
    more = MORE + "".join(LENGTH.format(n) for n in ("u", "v"))
    variant = edited(
        original,
        ('^start  = "O"', 'center = ["x", "y"]'),
        (r'^center = \["ell.*', 'center = ["u", "v"]'),
        (r"^\[bodies\.rod\]", more + "[bodies.rod]"),
        ('^point = "rod.start"', 'point = "rod.start"\nat = "O"'),
    )
    assert answer(variant)["degrees_of_freedom"] == answer(original)["degrees_of_freedom"]
    assert not changed(original, variant, {}, _keep(original))
    assert not complaints(variant)


# --- poses left to the constraints


@pytest.mark.parametrize("name", LADDERS)
def test_ladder_placed_by_its_contacts(name: str) -> None:
    original = shipped(name)
    variant = edited(original, (r"^center = .*\n", ""))
    assert not changed(original, variant, {}, _keep(original))
    assert not complaints(variant)


@pytest.mark.parametrize("name", PENDULUMS)
def test_pendulum_placed_by_its_joints(name: str) -> None:
    original = shipped(name)
    variant = edited(
        original,
        ('^start  = "O".*\n', ""),
        (r"^center = .*\n", ""),
        ('^point = "rod.start"', 'point = "rod.start"\nat = "O"'),
    )
    paths = _keep(original)
    if "fixed" in name:  # the weld says how the disk is turned as well: as the rod
        variant = edited(variant, (r'^angle  = "theta"\n', ""))
    assert not changed(original, variant, {}, paths)
    assert not complaints(variant)
    assert derivation(variant).study.system.bodies["disk"].center
