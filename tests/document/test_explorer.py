"""The explorer: its script and its page show the numbers of the derivation, for every problem that ships."""

from __future__ import annotations

import gzip
import json
import random
import re
import shutil
import subprocess
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from rbpsym.cli import main
from rbpsym.document.files import data_folder
from rbpsym.explorer.page import explorer, model
from rbpsym.mechanics.numbers import number
from rbpsym.mechanics.phases import known_stages
from rbpsym.statement.library import problem_files
from rbpsym.statement.loader import load_problem
from tests.architecture.source import ROOT
from tests.document import explored
from tests.library.derived import AT_START, NAMES
from tests.npm import MODULES

EXAMPLES = sorted((ROOT / "docs" / "examples").glob("[cei]*/*.toml"))
FILES = {**problem_files(), **{f"{path.parent.name}-{path.stem}": path for path in EXAMPLES}}
node = pytest.mark.skipif(shutil.which("node") is None, reason="needs Node")
browser = pytest.mark.skipif(shutil.which("chromium") is None, reason="needs Chromium")
GZIPPED = 150_000


def can_move(path: Path) -> bool:
    return "[coordinates" in path.read_text(encoding="utf-8")


MOVING = [name for name, path in FILES.items() if can_move(path) and name not in AT_START]


@pytest.mark.heavy(of=8)
@node
@pytest.mark.parametrize("name", MOVING)
def test_the_script_agrees_with_the_derivation(name: str) -> None:
    problem = load_problem(FILES[name])
    found = model(problem, "en")
    parts, _ = known_stages(problem)
    for moment in explored.run(found):
        assert moment["end"]["kind"] not in ("numbers", "singular"), moment["end"]
        assert moment["unfit"] in (None, "slack"), (
            "the example's numbers fit the statement (a string may be a light rod)"
        )
        assert moment["end"]["kind"] != "holds" or moment["end"]["time"] > moment["began"], "friction opposes the slip"
        told = explored.told(moment)
        size = max(abs(value) for value in told.values())
        numbers = explored.state_numbers(found, moment)
        derived = explored.derived(parts[moment["phase"]].study, numbers) if moment["phase"] < len(parts) else ()
        for what, value in derived:
            assert explored.close(told[what], value, size), (what, told[what], value)


@node
@pytest.mark.parametrize(
    "name",
    ["sliding-ladder", "sliding-ladder-with-spring", "rod-and-disk-fixed", "rod-and-disk-free", "half-disk-rocking"],
)
def test_works_and_motion_are_those_of_the_derivation(name: str) -> None:
    """Works against their closed forms; the motion against the square of the speed and an independent integration."""
    problem = load_problem(FILES[name])
    found = model(problem, "en")
    study = known_stages(problem)[0][0].study
    for moment in explored.run(found, (0.3, 0.9), seconds=explored.run(found, (0.0,))[0]["first"]):
        numbers = explored.state_numbers(found, moment)
        for coordinate, square in study.squares.items():
            speed = moment["v"][coordinate]
            assert explored.close(number(square, numbers), speed**2)
        closed = 0
        for item in study.works:
            for half, value in zip(
                (item.translational, item.rotational), moment["works"][f"{item.force}@{item.on}"], strict=True
            ):
                if half.value is not None:
                    closed += 1
                    assert explored.close(number(half.value, numbers), value, 10.0), item.force
        assert closed
        assert explored.close(moment["q"][study.system.independent[0]], integrated(study, found, moment["time"]))


FREE = random.Random(16).sample([name for name in MOVING if name in NAMES], 24)


def check_free_bodies(name: str) -> int:
    """Where all that is stated holds, free bodies move as the derivation says: places, speeds, forces. How many agree."""
    found, compared = model(load_problem(FILES[name]), "en"), 0
    if not found.loose:
        return 0
    seconds = min(explored.run(found, (0.0,))[0]["first"], 1.0)
    stated, free = (explored.run(found, (0.0, 0.4, 0.9), change, seconds) for change in ("AS_STATED", NOTHING_LET_GO))
    for one, other in zip(stated, free, strict=True):
        if one["phase"] == 0 and other["phase"] == len(found.phases):
            for kind in ("q", "v", "R"):
                for key, value in other[kind].items():
                    assert explored.close(one[kind][key], value, 10.0), (name, kind, key)
                    compared += 1
    return compared


NOTHING_LET_GO = '{ ...AS_STATED, off: new Set(["nothing"]) }'


@pytest.mark.heavy(of=6)
@node
@pytest.mark.parametrize("name", FREE)
def test_free_bodies_move_as_the_derivation_says(name: str) -> None:
    check_free_bodies(name)


@node
@pytest.mark.thorough
def test_free_bodies_of_the_whole_library() -> None:
    assert sum(check_free_bodies(name) > 0 for name in MOVING) > 0.95 * len(MOVING)


@node
def test_the_ladder_falls_to_the_floor_after_it_has_left_the_wall() -> None:
    """It keeps its speed along the floor; what it loses is the kinetic energy with which it lands (without bouncing)."""
    found = model(load_problem(FILES["sliding-ladder"]), "en")
    before, landed = (explored.run(found, (share,))[0] for share in (0.5, 0.9))
    assert landed["phase"] == 2 and landed["end"]["kind"] == "time"
    assert landed["K"][1] == pytest.approx(0, abs=1e-9) and landed["q"]["theta"] == pytest.approx(0, abs=1e-6)
    energy = [sum(one["K"]) + one["U"] for one in (before, landed)]
    assert explored.close(energy[0], energy[1] + landed["lost"], 100.0) and landed["lost"] > 1


@node
def test_a_box_that_falls_back_is_held_by_the_floor() -> None:
    [last] = explored.run(model(load_problem(FILES["box-against-ridge"]), "en"), (1.0,))
    assert last["q"]["theta"] == pytest.approx(0, abs=1e-6) and sum(last["K"]) == pytest.approx(0, abs=1e-9)


@node
def test_a_weld_that_is_let_go_is_a_bearing() -> None:
    """The pendulum with the welded disk then swings as the one whose disk is free."""
    found = model(load_problem(FILES["rod-and-disk-fixed"]), "en")
    free = explored.run(found, (0.5,), '{ ...AS_STATED, off: new Set(["N turns"]) }')[0]
    other = explored.run(model(load_problem(FILES["rod-and-disk-free"]), "en"), (1.0,), seconds=free["time"])[0]
    assert free["phase"] == 1 and explored.close(free["q"]["theta"], other["q"]["theta"])


@node
def test_the_centre_of_mass_does_not_care_where_a_force_acts() -> None:
    """The weight of the falling stick, moved aside once the floor lets it go: the same fall, another turn."""
    found = model(load_problem(FILES["falling-stick"]), "en")
    change = '{ off: new Set(MODELS[0].loose[0].data.loose.conditions.map(keyed)), force: "W@stick", aside: %s }'
    straight, aside = (explored.run(found, (0.5,), change % far, 0.2)[0] for far in ("0", "0.1"))
    assert explored.close(straight["U"], aside["U"]) and explored.close(straight["K"][0], aside["K"][0])
    assert straight["K"][1] == pytest.approx(0, abs=1e-9) and aside["K"][1] > 1e-3


@node
def test_what_can_only_push_lets_go_where_it_would_pull() -> None:
    """The ladder's weight moved beyond its foot: it leaves the wall at once, and no contact ever pulls."""
    found, shares = model(load_problem(FILES["sliding-ladder"]), "en"), (0.0, 0.2, 0.4, 0.6, 0.8, 1.0)
    seen = explored.run(found, shares, '{ off: new Set(), force: "W@ladder", aside: 1 }')
    assert seen[0]["R"]["N_w"] == 0 and min(force for one in seen for force in one["R"].values()) > -1e-6


STRUCK = [name for name in MOVING if "impulses" in FILES[name].read_text(encoding="utf-8")]


@node
@pytest.mark.parametrize("name", STRUCK)
def test_impulses_are_those_of_the_derivation(name: str) -> None:
    """Their sizes and the energy lost; and the energy that is left is that before without it."""
    problem = load_problem(FILES[name])
    found = model(problem, "en")
    parts, _ = known_stages(problem)
    [moment] = explored.run(found, (1.0,))
    numbers = {one["name"]: one["value"] for one in found.data["numbers"]}
    began = [part.began for part in parts[1:] if part.began.is_blow]
    assert len(moment["blows"]) >= len(began) > 0  # then floors may be met
    for blow, handed in zip(moment["blows"], began, strict=False):
        assert explored.close(blow["lost"], number(handed.energy_lost, numbers))
        assert blow["arrows"]
        for value in handed.impulses.values():
            size = number(value, numbers)
            assert abs(size) < 1e-9 or any(explored.close(size, part) for part in blow["parts"])
    assert explored.close(moment["lost"], sum(blow["lost"] for blow in moment["blows"]))
    assert found.phases[0].data["strikes"] is None


@node
def test_what_is_struck_at_rest_is_not_displaced_besides() -> None:
    first, then = explored.run(explored.explored(load_problem(FILES["center-of-percussion"])), (0.0, 1e-6))
    assert first["q"]["theta"] == 0 and 0 < then["q"]["theta"] < 1e-3
    assert (first["phase"], then["phase"]) == (0, 1)  # it opens with the first phase


def integrated(study, found, time: float) -> float:
    """The first coordinate at a time, from the derived accelerations by scipy."""
    from scipy.integrate import solve_ivp

    system = study.system
    numbers = {one["name"]: one["value"] for one in found.data["numbers"]}
    names = (*system.coordinates, *system.speeds)
    start = [number(system.scope.start[name], numbers) for name in names]

    def rate(t: float, y: np.ndarray) -> list[float]:
        known = numbers | dict(zip(names, y.tolist(), strict=True)) | {"t": t}
        gained = [number(study.dynamics.accelerations[name], known) for name in system.accelerations]
        return [number(system.scope.rates[name], known) for name in system.coordinates] + gained

    done = solve_ivp(rate, (0, time), start, rtol=1e-10, atol=1e-12)
    return float(done.y[0, -1])


class Readings(HTMLParser):
    """The <data> elements of a page by key, its status, and whether the script came to its end."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: dict[str, float] = {}
        self.attributes: list[tuple[str, dict[str, str | None]]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        known = dict(attrs)
        self.attributes.append((tag, known))
        if tag == "data" and "data-key" in known:
            self.found[str(known["data-key"])] = float(known["value"] or "nan")
        if "data-phase" in known:
            place = str(known["id"]).rpartition("-")[2]
            self.found |= {f"{place}.{key}": float(str(known[f"data-{key}"])) for key in ("phase", "local")}


def shown(page: Path, fragment: str = "", extra: str = "") -> Readings:
    """What Chromium makes of a page; `extra` is a script that plays the part of a person."""
    if extra:
        text = page.read_text(encoding="utf-8").replace("</body>", f"<script>{extra}</script></body>")
        page = page.with_name("played.html")
        page.write_text(text, encoding="utf-8")
    flags = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={page.parent / 'profile'}"]
    wait = ["--virtual-time-budget=5000", "--dump-dom", f"{page.as_uri()}{fragment}"]
    done = subprocess.run(["chromium", *flags, *wait], capture_output=True, text=True, timeout=120, check=True)
    found = Readings(done.stdout)
    assert found.attributes[0][1].get("data-ready") == "yes", "the script did not come to its end"
    return found


def written(tmp_path: Path, *names: str) -> Path:
    """The explorer's page, by the command."""
    result = CliRunner().invoke(main, ["explore", *names, "-o", str(tmp_path)])
    assert result.exit_code == 0, result.output
    return Path(result.output.strip())


def met(tmp_path: Path, *jobs: dict) -> list[dict]:
    """What Chromium makes of pages, driven by playwright."""
    file = tmp_path / "jobs.json"
    file.write_text(json.dumps(jobs), encoding="utf-8")
    command = ["node", str(Path(__file__).with_name("browser.cjs")), str(MODULES), str(file)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=240, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    found = json.loads(done.stdout)
    assert [one["errors"] for one in found] == [[]] * len(jobs)
    return found


played = pytest.mark.skipif(
    shutil.which("chromium") is None or not (MODULES / "playwright-core").is_dir(),
    reason="needs Chromium and playwright",
)
# name -> the moment at which it is looked at
READ = {
    "sliding-ladder": 0.5,
    "sliding-ladder-with-spring": 0.7,
    "slider-crank": 0.02,
    "atwood-with-massive-pulley": 0.3,
    "ball-slipping-to-rolling": 1.5,
    "rod-hits-ball-at-bottom": 0.6,
    "rod-tipping-over-edge": 0.3,
}


@played
def test_pages_show_the_numbers_of_the_derivation(tmp_path: Path) -> None:
    """Systems of all kinds, read out in the browser, later phases too."""
    pages = [written(tmp_path, name) for name in READ]
    jobs = [{"file": str(p), "hash": f"#t={t}", "act": "read"} for p, t in zip(pages, READ.values(), strict=True)]
    for name, found in zip(READ, met(tmp_path, *jobs), strict=True):
        agree(name, 0, {key: float(value) for key, value in found["readings"].items()})


@browser
def test_two_systems_from_different_files_show_their_numbers(tmp_path: Path) -> None:
    """Side by side in the browser, other numbers than the example's, read out at t = 0.6 s."""
    for pair, hashed in (
        (("rod-and-disk-fixed", "rod-and-disk-free"), "#t=0.6&ell=1.3&M=1.7"),
        (("rod-pendulum", "disk-off-center"), "#t=0.6&M=1.7"),
    ):
        read = shown(written(tmp_path, *pair), hashed).found
        assert read["p.M"] == 1.7
        for place, name in enumerate(pair):
            agree(name, place, read)


def agree(name: str, place: int, read: dict[str, float]) -> None:
    """The numbers of a page are those that the derivation gives for its state."""
    problem = load_problem(FILES[name])
    parts, _ = known_stages(problem)
    phase = int(read[f"{place}.phase"])
    study = parts[phase].study
    numbers = {key.removeprefix("p."): value for key, value in read.items() if key.startswith("p.")}
    for coordinate in study.problem.coordinates:
        numbers[coordinate.name] = read[f"{place}.q.{coordinate.name}"]
        numbers[f"{coordinate.name}_dot"] = read[f"{place}.v.{coordinate.name}"]
    numbers["t"] = read[f"{place}.local"]
    compared = 0
    for what, value in explored.derived(study, numbers):
        kind, _, rest = what.partition(" ")
        key = f"{place}." + ("K_" + "TR"[int(rest)] if kind == "K" else f"{kind}.{rest.replace(' ', '.')}")
        assert explored.close(read[key], value, 10.0), (name, key, read[key], value)
        compared += 1
    assert compared > 4
    if f"{place}.E" in read and study.potential is not None:
        total = number(sum(study.kinetic), numbers) + number(study.potential, numbers)
        assert explored.close(read[f"{place}.E"], total), name
    for item in study.works if phase == 0 else ():
        for letter, half in (("T", item.translational), ("R", item.rotational)):
            if half.value is not None:
                value = read[f"{place}.W_{letter}.{item.force}@{item.on}"]
                assert explored.close(number(half.value, numbers), value, 10.0), (name, item.force)


PERSON = """
const press = (key) => document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
const slide = (id, value) => {
  const one = document.getElementById(id);
  one.value = value;
  one.dispatchEvent(new Event("input"));
};
setTimeout(() => {
  press("ArrowRight"); press("ArrowRight"); press("ArrowRight");
  document.body.dataset.stepped = document.getElementById("clock").value;
  document.body.dataset.said = document.getElementById("status").textContent;
  press(" ");
  document.body.dataset.playing = document.getElementById("play").dataset.playing;
  press(" "); press("Home");
  document.body.dataset.home = document.getElementById("clock").value;
  slide("place-0-theta", 1.0);
  document.body.dataset.place = document.querySelector('[data-key="0.q.theta"]').value;
  slide("number-g", 20);
}, 200);
"""


@browser
def test_it_is_worked_by_keyboard_and_sliders(tmp_path: Path) -> None:
    seen = shown(written(tmp_path, "sliding-ladder"), extra=PERSON)
    told = next(attributes for tag, attributes in seen.attributes if tag == "body")
    assert float(told["data-stepped"]) == pytest.approx(0.06)
    assert "θ = " in told["data-said"]
    assert "°" in told["data-said"]
    assert told["data-playing"] == "true"
    assert float(told["data-home"]) == 0
    assert float(told["data-place"]) == pytest.approx(1.0, abs=1e-3)
    assert seen.found["p.g"] == pytest.approx(20, abs=0.1)
    sliders = [a for tag, a in seen.attributes if tag == "input" and a.get("type") == "range" and a.get("id") != "time"]
    assert len(sliders) >= 5
    assert all(one.get("aria-label") and one.get("aria-valuetext") for one in sliders)
    assert any(a.get("role") == "status" and a.get("aria-live") == "polite" for _, a in seen.attributes)


@played
def test_reduced_motion_is_respected(tmp_path: Path) -> None:
    """Who wants little motion sees few pictures a second, and the same numbers."""
    job = {"file": str(written(tmp_path, "rod-pendulum")), "act": "calm"}
    for _ in range(3):  # a busy machine counts for longer than it is told to
        [seen] = met(tmp_path, job)
        if seen["calm"] <= 7:
            break
    assert 2 <= seen["calm"] <= 7
    assert seen["lively"] > 2 * seen["calm"]


@played
def test_ways_and_arrows_are_shown_and_a_body_is_dragged_to_its_start(tmp_path: Path) -> None:
    """Arrows only when they are asked for; dragging down the ladder lowers its angle at the start, and no length changes."""
    [seen] = met(tmp_path, {"file": str(written(tmp_path, "sliding-ladder")), "hash": "#t=0.5", "act": "layers"})
    assert (seen["before"], seen["after"]) == (0, [1, 1, 1])
    assert seen["tip"] > 0  # it moves away from the wall
    assert 0 < float(seen["dragged"]) < float(seen["start"]) - 0.1
    assert float(seen["length"]) == problem_length("ell")
    assert "θ = " in seen["said"]


def problem_length(name: str) -> float:
    """The number of the ladder's example."""
    return next(one["value"] for one in model(load_problem(FILES["sliding-ladder"]), "en").data["numbers"] if one["name"] == name)


@played
def test_an_angle_is_wrapped_the_cursor_follows_the_pointer_and_numbers_are_typed(tmp_path: Path) -> None:
    """A rod that goes round: speed against place within half a turn to both sides; where it is fastest, it hangs."""
    text = FILES["rod-pendulum"].read_text(encoding="utf-8").replace("range   =", 'speed = "Omega"\n# range')
    text = text.replace("[example]", '[example]\nOmega = "9 rad/s"')
    text = text.replace("[parameters]", '[parameters]\nOmega = "angular velocity"')
    file = tmp_path / "round.toml"
    file.write_text(text, encoding="utf-8")
    [seen] = met(tmp_path, {"file": str(written(tmp_path, str(file))), "act": "numbers"})
    angle = float(seen["top"]["0.q.theta"])
    assert angle > 1 and abs(np.sin(angle / 2)) < 0.1
    assert float(seen["top"]["0.curve.ω (θ)"]) == float(seen["top"]["0.v.theta"])
    assert seen["ends"][2].startswith("1") and "360°" in seen["said"]
    assert seen["seen"] == ["40", "40"] and float(seen["readings"]["p.Omega"]) == 40  # beyond its slider; not −1


@played
def test_a_prediction_is_decided_by_the_motion(tmp_path: Path) -> None:
    """Of all that can end the ladder's first phase the force of the wall vanishes; the readings wait for the prediction."""
    found = model(load_problem(FILES["sliding-ladder"]), "en")
    ended = explored.run(found, (0.5,))[0]["ended"]
    [seen] = met(tmp_path, {"file": str(written(tmp_path, "sliding-ladder")), "act": "predict"})
    right = [key for key, told in seen["said"].items() if told.startswith("The motion says so, too")]
    known = {f"{one['kind']} {one['name']}" for one in found.data["phases"][0]["events"]}
    assert set(seen["said"]) == {*known, "none"} and len(known) > 1
    assert right == [" ".join(ended)]
    assert seen["hidden"] and seen["after"]


@played
def test_a_point_for_torques_is_dragged_by_touch_and_the_motion_is_heard(tmp_path: Path) -> None:
    """Where the lines of action of both contacts meet, only the weight has a torque: M g ℓ cos θ."""
    [seen] = met(tmp_path, {"file": str(written(tmp_path, "sliding-ladder")), "act": "moment"})
    read = {key: float(value) for key, value in seen["readings"].items()}
    weight = read["p.M"] * read["p.g"] * read["p.ell"] * np.cos(read["0.q.theta"])
    assert explored.close(read["0.tau.W@ladder"], weight)
    assert max(abs(read["0.tau.N_w@ladder"]), abs(read["0.tau.N_f@ladder"])) < 1e-6 * weight
    assert seen["lines"] == 2 and "N" in seen["told"] and "W" not in seen["told"]
    assert float(seen["before"]) == read["p.theta_0"] and seen["scrolled"] == 0, "the point is dragged, not the body or the page"
    assert seen["silent"] == "" and seen["heard"][0] != seen["heard"][1] and min(seen["heard"]) > 100


@played
def test_it_is_worked_by_keyboard_alone(tmp_path: Path) -> None:
    """Tab meets every control in the order of the page, each with a name; keys move the sliders and press the buttons."""
    page = str(written(tmp_path, "sliding-ladder"))
    for found in met(tmp_path, {"file": page, "act": "keys"}, {"file": page, "act": "keys", "width": 360}):
        order, after = found["order"], found["after"]
        ids = [one["id"] for one in order]
        assert ids[:4] == ["play", "restart", "speed", "time"]
        assert ids[4:9] == [f"layer-{name}" for name in ("trace", "velocity", "acceleration", "moment", "sound")]
        assert ids[9:13] == ["predict-title", "loose-title", "curves-kind", "place-0-theta"]
        assert ids[-1] == "reset"
        assert sum(one.startswith("number-") for one in ids) == 4
        assert all(one["name"] for one in order)
        assert all(one["said"] for one in order if one["id"].startswith(("time", "place", "number")))
        assert 0 < after["ArrowRight"] < after["PageUp"] < after["End"]
        assert after["Home"] == 0
        assert (after["space"], after["enter"]) == ("true", "false")
        before, later = after["slider"]
        assert float(later["value"]) > float(before["value"])
        assert later["said"] != before["said"]
        assert "θ = " in found["status"]


@pytest.mark.heavy(of=8)
@pytest.mark.parametrize("name", [name for name in MOVING if name in NAMES])
def test_one_small_file_without_a_network(name: str) -> None:
    page = explorer((load_problem(FILES[name]),))
    assert len(gzip.compress(page.encode())) < GZIPPED
    assert not re.search(r"""(?:src|href)=["']?(?:https?:)?//|@import|fetch\(|XMLHttp""", page)


@pytest.mark.skipif(shutil.which("node") is None or not (MODULES / "axe-core").is_dir(), reason="needs axe-core")
@browser
def test_everyone_can_use_it(tmp_path: Path) -> None:
    """axe-core finds nothing, on a desktop, on a phone of 360 px in the dark, on paper; no network is asked."""
    pages = [written(tmp_path, "rod-and-disk-fixed", "rod-and-disk-free"), written(tmp_path, "brake-drum")]
    command = ["node", str(Path(__file__).with_name("axe.cjs")), str(MODULES), *map(str, pages)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=180, check=True)
    for found in json.loads(done.stdout):
        where = f"{Path(found['file']).name}, {found['view']}"
        assert found["violations"] == [], where
        assert found["outside"] == [], where
        assert found["wider"] <= 0, f"{where}: the page is wider than the screen"


def test_what_can_not_be_explored_gets_a_sentence(tmp_path: Path) -> None:
    for wanted, said in (("paper", "is a course"), ("no-such-problem", "no problem and no file")):
        result = CliRunner().invoke(main, ["explore", wanted, "-o", str(tmp_path)])
        assert result.exit_code == 2
        assert said in result.output
    assert not list(tmp_path.iterdir())


def test_numbers_without_a_start_get_a_sentence(tmp_path: Path) -> None:
    text = problem_files()["sliding-ladder"].read_text(encoding="utf-8")
    text = re.sub(r'start   = "theta_0"[^\n]*', 'start = "acos(h/ell)"', text).replace(
        "[parameters]", '[parameters]\nh = "length: height"'
    )
    text = text.replace("theta_0 =", "h =").replace("70 deg", "5 m")
    file = tmp_path / "ladder.toml"
    file.write_text(text, encoding="utf-8")
    result = CliRunner().invoke(main, ["explore", str(file), "-o", str(tmp_path / "out")])
    assert result.exit_code == 2
    assert "there is no start" in result.output
    assert not (tmp_path / "out").exists()


def test_the_scripts_hold_no_formula_of_a_problem() -> None:
    """The templates are shells; what moves is in the package and knows no problem."""
    assert "<script>" in (data_folder("templates") / "explorer.html").read_text(encoding="utf-8")
    text = "".join(path.read_text(encoding="utf-8") for path in explored.FOLDER.glob("*.js"))
    assert not [name for name in problem_files() if name in text]
