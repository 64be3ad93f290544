// What may be shown besides: the ways of the centres of mass, their velocities and accelerations; bodies that are dragged to their start.

const LAYERS = ["trace", "velocity", "acceleration", "moment", "sound"], BESIDE = 1e-3, ARROW = 70, REACH = 34, TRIED = 40;
const layers = new Set();

function layerBoxes() {
  byId("layers").replaceChildren(...LAYERS.map((name) => {
    const box = element("input", { type: "checkbox", id: "layer-" + name });
    box.addEventListener("change", () => { layers[box.checked ? "add" : "delete"](name); if (name === "sound") listening(box.checked); aboutTable(); seek(state.time); });
    return element("label", { class: "layer " + name }, [box, " " + WORDS["layer." + name]]);
  }));
}

/** [velocity, acceleration] of a body's centre of mass, from its places at this moment and a little later in the same phase. */
function rushes(motion, { phase, y, local }, cm) {
  const states = [0, 1, 2].map((k) => motion.after(phase, y, local, k * BESIDE));
  if (!states.every(Boolean)) return [[0, 0], [0, 0]];
  const [p, q, r] = states.map((one, k) => pick(cm, motion.look(phase, one, local + k * BESIDE)));
  return [p.map((_, k) => (4 * q[k] - 3 * p[k] - r[k]) / (2 * BESIDE)), p.map((_, k) => (p[k] - 2 * q[k] + r[k]) / BESIDE ** 2)];
}

/** The parts of the picture that the chosen layers add. */
function layered(drawing, moment) {
  const { motion, scale } = drawing;
  const ways = layers.has("trace") ? waysOf(motion).map((way) => {
    const seen = way.filter(([time]) => time <= moment.time + 1e-9).map(([, point]) => point);
    return make("path", { class: "trace", d: path(scale.points([...seen, pick(moment.data.bodies.find((b) => b.name === way.name).cm, moment.out)])) });
  }) : [];
  const arrows = ["velocity", "acceleration"].flatMap((name, k) => (layers.has(name) ? moment.data.bodies.flatMap((body) => {
    const [u, v] = rushes(motion, moment, body.cm)[k], size = (Math.hypot(u, v) * ARROW) / fastest(motion)[k];
    return size > 1.5 ? drawing.pointed(scale.point(pick(body.cm, moment.out)), [u, -v], Math.min(size, 1.5 * ARROW), name, "") : [];
  }) : []));
  return [...ways, ...arrows, ...marked(drawing, moment)];
}

/** Of each body the places of its centre of mass, with their times. */
function waysOf(motion) {
  if (!motion.ways) {
    const step = Math.max(1, Math.floor(motion.frames.length / 240)), frames = motion.frames.filter((_, k) => k % step === 0);
    motion.ways = motion.data.phases[0].bodies.map(({ name }) => Object.assign(frames.map((frame) => {
      const body = motion.data.phases[frame.phase].bodies.find((one) => one.name === name);
      return [frame.time, pick(body.cm, motion.look(frame.phase, frame.y, frame.local))];
    }), { name }));
  }
  return motion.ways;
}

/** The usual largest speed and acceleration of a motion, by which arrows are scaled. */
function fastest(motion) {
  if (!motion.fastest) {
    const all = sampled(motion).flatMap((moment) => moment.data.bodies.map((body) => rushes(motion, moment, body.cm)));
    motion.fastest = [0, 1].map((k) => mostly(all.map((pair) => Math.hypot(...pair[k]))));
  }
  return motion.fastest;
}

// --- dragging: the numbers of the start that bring a body nearest to the pointer

/** A motion that is not worked out: only its start is asked for. */
function startOf(model, numbers) {
  const motion = Object.assign(Object.create(Motion.prototype), { data: model.data, code: model.code, numbers, floors: [] });
  const state = motion.start(0);
  return { state: state.slice(0, model.data.phases[0].free), out: motion.look(0, state, 0) };
}

const numbersOf = (model) => model.data.numbers.map((one) => state.numbers[one.name]);

/** The numbers by which one says where it starts: the coordinates at the start change with them. */
function startNumbers(model) {
  const own = numbersOf(model), { state: before } = startOf(model, own);
  return model.data.numbers.filter((one, k) => {
    const moved = own.with(k, own[k] + (one.most - one.least) / 50), { state: after } = startOf(model, moved);
    return after.some((value, n) => Number.isFinite(value) && Math.abs(value - before[n]) > 1e-9);
  });
}

/** The point of a body that was taken hold of comes as near to the goal as the start lets it. */
function drag(model, body, own, goal) {
  const away = () => { const { out } = startOf(model, numbersOf(model)), at = carried(own, pick(body.at, out), out[body.angle]); return Math.hypot(at[0] - goal[0], at[1] - goal[1]); };
  for (const one of [...startNumbers(model), ...startNumbers(model)]) {
    let best = state.numbers[one.name], least = away();
    for (const share of [1, 1 / TRIED]) {  // first the whole range, then around the best of it
      const middle = share < 1 ? best : (one.least + one.most) / 2, half = ((one.most - one.least) / 2) * share;
      for (let k = -TRIED; k <= TRIED; k++) {
        state.numbers[one.name] = Math.min(Math.max(middle + (half * k) / TRIED, one.least), one.most);
        const now = away();
        if (now < least) [best, least] = [state.numbers[one.name], now];
      }
    }
    state.numbers[one.name] = best;
  }
}

/** The point between two that is nearest to a third. */
function along([a, b], [c, d], [x, y]) {
  const [u, v] = [c - a, d - b], share = Math.min(Math.max(((x - a) * u + (y - b) * v) / (u * u + v * v || 1), 0), 1);
  return [a + share * u, b + share * v];
}

/** What lies under a finger or the pointer: the point for torques, or a body that can be dragged; the handle takes a place in metres. */
function handleAt(place, goal, reach) {
  const model = MODELS[place], { scale, out } = state.drawings[place];
  const away = (point) => Math.hypot(point[0] - goal[0], point[1] - goal[1]) * scale.factor;
  if (layers.has("moment") && away(about.at) < REACH) return (point) => moveAbout(point, place);
  const line = state.change.force && lineHandle(place, away);
  if (line) return line;
  const outer = (body) => [pick(body.cm, out), ...outlineOf(body, out).flatMap((piece) => piece.points)];
  const far = (body) => Math.min(...outer(body).map((point, _, [from]) => away(along(from, point, goal)))); // anywhere on it, not only at its middle
  const body = model.data.phases[0].bodies.map((one) => [far(one), one]).reduce((a, b) => (b[0] < a[0] ? b : a));
  if (body[0] > reach || !startNumbers(model).length) return null;
  const [x, y] = pick(body[1].at, out), own = carried([goal[0] - x, goal[1] - y], [0, 0], -out[body[1].angle]);
  return (point) => { pause(); if (state.time) seek(0); drag(model, body[1], own, point); sliders(); soon(); };
}

function draggable(svg, place) {
  let held = null;
  const at = (event, scale) => {
    const box = svg.getBoundingClientRect(), size = Math.min(box.width / ROOM, box.height / scale.height);
    const x = (event.clientX - box.left - (box.width - size * ROOM) / 2) / size, y = (event.clientY - box.top - (box.height - size * scale.height) / 2) / size;
    return [scale.middle[0] + (x - ROOM / 2) / scale.factor, scale.middle[1] - (y - scale.height / 2) / scale.factor];
  };
  const handle = (event, isTouch) => { const { scale } = state.drawings[place], goal = at(event, scale); return [handleAt(place, goal, isTouch ? REACH : REACH * 2), scale]; };
  svg.addEventListener("touchstart", (event) => { if (event.touches.length === 1 && handle(event.touches[0], true)[0]) event.preventDefault(); }, { passive: false }); // else the page scrolls
  svg.addEventListener("pointerdown", (event) => {
    const [move, scale] = handle(event, event.pointerType === "touch");
    if (!move) return;
    held = { move, scale }; // nothing is drawn anew before “touchstart” has met what is touched
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener("pointermove", (event) => { if (held) held.move(at(event, held.scale)); });
  const drop = () => { if (held) { held = null; say(); tells("changed", { name: "start" }); } };
  svg.addEventListener("pointerup", drop);
  svg.addEventListener("pointercancel", drop);
}
