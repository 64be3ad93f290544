// The motion with all bodies free: what is lost lets go, what is met holds (smooth, without bouncing), what a reader lets go is free.

const STRETCHES = 40, SOFT = 1e-12, TOUCH = 1e-6, ROUND = { disk: "radius", ring: "radius", ball: "radius", shell: "radius", annulus: "outer" };
const ANGULAR = new Set(["rod", "rectangle", "triangle", "polygon", "particle"]);
const keyed = (one) => (one.turns ? one.of + " turns" : one.of);

/** [{key, body, at, rim, line}]: corners and rims of bodies, in their frames, with each fixed line [a, b, c] on whose free side they begin. */
function floorsOf(motion, out) {
  const data = motion.data.phases[0], size = extentOf(motion, { phase: 0, y: motion.start(0), local: 0 });
  const lines = (data.lines || []).filter((line) => !line.of && line.normal).map((line) => {
    const [u, v] = pick(line.normal, out), length = Math.hypot(out[line.a], out[line.b]) * (Math.sign(out[line.a] * u + out[line.b] * v) || 1);
    return [out[line.a] / length, out[line.b] / length, out[line.c] / length];
  });
  const found = data.bodies.flatMap((body, k) => cornersOf(body, out).flatMap((one) => lines.map((line) => ({ ...one, body: k, on: body.name, line }))));
  const held = data.forces.filter((force) => force.unknown).map((force) => ({ on: force.on, at: pick(force.at, out) }));
  const begins = (one) => { const { at, angle } = data.bodies[one.body], [x, y] = carried(one.at, pick(at, out), out[angle]), [a, b] = one.line; return [gapOf(one, pick(at, out), out[angle]), [x - one.rim * a, y - one.rim * b]]; };
  return found.filter((one) => {
    const [gap, [x, y]] = begins(one), taken = held.some(({ on, at }) => on === one.on && Math.hypot(at[0] - x, at[1] - y) < TOUCH * size);
    return gap > -TOUCH * size && !(taken && gap < TOUCH * size); // what a constraint holds there, it holds
  }).map((one, k) => ({ ...one, key: `floor ${k}`, size }));
}

function cornersOf(body, out) {
  const own = body.parts.length ? body.parts.filter((part) => !part.removed) : [body];
  return own.flatMap((part) => {
    const at = part === body ? [0, 0] : pick(part.at, out), turn = part === body ? 0 : out[part.angle];
    if (part.kind in ROUND) return [{ at, rim: out[part.sizes[ROUND[part.kind]]] }];
    const points = ANGULAR.has(part.kind) ? piecesOf(part.kind, Object.fromEntries(Object.entries(part.sizes).map(([key, place]) => [key, out[place]])))[0].points : [];
    return points.map((point) => ({ at: carried(point, at, turn), rim: 0 }));
  });
}

/** How far it is from its line. */
function gapOf({ at, rim, line: [a, b, c] }, place, angle) { const [x, y] = carried(at, place, angle); return a * x + b * y - c - rim; }

class Free {
  constructor(motion, phase) {
    const { data, code } = motion.model.loose[phase], { places, conditions, forces } = data.loose;
    Object.assign(this, { motion, data, code, n: places.length, floors: motion.floors, plans: new Map() });
    this.place = data.bodies.map((_, body) => [0, 1, 2].map((axis) => places.findIndex(([b, x]) => b === body && x === axis)));
    this.names = [...new Set([...conditions, ...forces].map(keyed))];
    this.closing = conditions.filter((one) => one.gap !== null && forces.some((force) => force.of === one.of && force.pushes));
  }

  /** What holds, in the order of the rows and columns that it adds. */
  plan(active) {
    if (!this.plans.has(active)) {
      const { n, data: { loose } } = this, forces = loose.forces.map((one, k) => k).filter((k) => active.has(keyed(loose.forces[k])));
      const where = [...Array(n).keys(), ...loose.forces.map((_, k) => (forces.includes(k) ? n + forces.indexOf(k) : -1))];
      const conditions = loose.conditions.filter((one) => active.has(keyed(one))), floors = this.floors.filter((one) => active.has(one.key));
      this.plans.set(active, { forces, where, conditions, floors, size: n + forces.length + floors.length });
    }
    return this.plans.get(active);
  }

  /** Places and speeds of the bodies as they are in a phase. */
  from(data, out) {
    const of = data.bodies.map((body) => {
      const at = pick(body.at, out), cm = pick(body.cm, out), v = pick(body.v, out), turning = out[body.omega];
      return [[...at, out[body.angle]], [v[0] + turning * (cm[1] - at[1]), v[1] - turning * (cm[0] - at[0]), turning]];
    });
    return [0, 1].flatMap((rate) => this.data.loose.places.map(([body, axis]) => of[body][rate][axis]));
  }

  pose(y, body, rate = 0) { return this.place[body].map((k) => (k < 0 ? 0 : y[k + rate * this.n])); }

  /** [cells, rest, rate of the gap] of a corner that touches, and where. */
  floor(one, y) {
    const [x, z, angle] = this.pose(y, one.body), [vx, vz, turning] = this.pose(y, one.body, 1), [a, b] = one.line;
    const [u, v] = carried(one.at, [0, 0], angle), turn = b * u - a * v, cells = [a, b, turn].map((value, axis) => [this.place[one.body][axis], value]).filter(([k]) => k >= 0);
    return { cells, rest: -turning * turning * (a * u + b * v), rate: a * vx + b * vz + turning * turn, at: [x + u - one.rim * a, z + v - one.rim * b] };
  }

  /** Accelerations and forces where `active` holds; or, in a blow, what the speeds gain and the impulses. */
  solve(active, y, t, blow = false) {
    const { n, data: { loose, bodies }, motion } = this, out = this.code.balance(y, motion.numbers, t), { forces, where, conditions, floors, size } = this.plan(active);
    const matrix = [], right = [];
    const row = (cells, rest) => { const made = new Array(size).fill(0); for (const [k, value] of cells) if (where[k] >= 0) made[where[k]] += value; matrix.push(made); right.push(-rest); return made; };
    const put = (one, rest) => { const made = new Array(size).fill(0); for (const [k, place] of one.cells) if (where[k] >= 0) made[where[k]] += out[place]; matrix.push(made); right.push(-rest); };
    for (const one of loose.rows) put(one, blow ? 0 : out[one.rest]);
    for (const one of conditions) put(one, out[blow ? one.rate : one.rest]);
    const seen = floors.length || motion.change.aside ? this.code.look([...y, ...new Array(n + loose.forces.length).fill(0)], motion.numbers, t) : null;
    floors.forEach((one, k) => {
      const met = this.floor(one, y), column = n + forces.length + k, [x, z] = pick(bodies[one.body].cm, seen), [a, b] = one.line;
      row(met.cells, blow ? met.rate : met.rest)[column] = SOFT;
      [a, b, (met.at[0] - x) * b - (met.at[1] - z) * a].forEach((value, axis) => { const own = this.place[one.body][axis]; if (own >= 0) matrix[own][column] -= value; });
    });
    if (motion.change.aside && !blow) for (const force of this.aside()) {
      const own = this.place[bodies.findIndex((body) => body.name === force.on)][2];
      if (own >= 0) right[own] -= motion.change.aside * Math.hypot(...pick(force.vector, seen));
    }
    const found = solve(matrix, right), all = new Array(loose.forces.length).fill(0);
    forces.forEach((k) => { all[k] = found[where[n + k]]; });
    return { gained: found.slice(0, n), forces: all, floors: new Map(floors.map((one, k) => [one.key, found[n + forces.length + k]])), out };
  }

  /** The forces whose line of action is moved. */
  aside() { return this.data.forces.filter((force) => keyOf(force) === this.motion.change.force); }

  /** What can only push, and would pull. */
  pulling(found, tiny) {
    const all = [...this.data.loose.forces.flatMap((one, k) => (one.pushes ? [[one.of, found.forces[k]]] : [])), ...found.floors];
    return all.reduce((worst, one) => (one[1] < worst[1] ? one : worst), ["", -tiny])[0];
  }

  /** What holds of `active` where nothing pulls. */
  holding(active, y, t, blow) {
    let now = new Set(active);
    for (let k = 0; k <= active.size; k++) {
      const found = this.solve(now, y, t, blow), worst = this.pulling(found, blow ? 1e-12 : 1e-9);
      if (!worst) return [now, found];
      now = new Set([...now].filter((key) => key !== worst && key !== worst + " turns"));
    }
    return [now, this.solve(now, y, t, blow)];
  }

  /** How many numbers the code of the system tells. */
  base(y) { return this.code.look([...y.slice(0, 2 * this.n), ...Array(this.n + this.data.loose.forces.length).fill(0)], this.motion.numbers, 0).length; }

  /** All numbers of a state, then of each floor [force, gap, its place, its force along x and y], then the gaps that may close, and where moved lines act. */
  look(active, y, t) {
    const { gained, forces, floors, out } = this.solve(active, y.slice(0, 2 * this.n), t), all = this.code.look([...y.slice(0, 2 * this.n), ...gained, ...forces], this.motion.numbers, t);
    for (const one of this.floors) {
      const [x, z, angle] = this.pose(y, one.body), push = floors.get(one.key) || 0;
      all.push(push, gapOf(one, [x, z], angle), ...this.floor(one, y).at, push * one.line[0], push * one.line[1]);
    }
    for (const one of this.closing) all.push(out[one.gap]);
    for (const force of this.aside()) { const [x, z] = pick(force.at, all), [u, v] = pick(force.vector, all), far = this.motion.change.aside / (Math.hypot(u, v) || 1); all.push(x - v * far, z + u * far); }
    return Object.assign(all, { gained });
  }

  rates(active, y, t, data) {
    const n = this.n, out = this.look(active, y, t), now = data.loose.places.map((_, k) => y[n + k]);
    return [...now, ...out.gained, ...data.forces.flatMap((force) => {
      const body = data.bodies.find((one) => one.name === force.on), [x, y0] = pick(body.cm, out), [p, q] = pick(force.at, out), [u, v] = pick(force.vector, out), speed = pick(body.v, out);
      return [u * speed[0] + v * speed[1], ((p - x) * v - (q - y0) * u + (out[force.couple] || 0)) * out[body.omega]];
    })];
  }

  /** [gap, slopes] of what holds and has a place. */
  conditions(active, x, t) {
    const y = [...x, ...Array(2 * this.n - x.length).fill(0)], out = this.code.balance(y, this.motion.numbers, t), row = (cells) => { const all = Array(this.n).fill(0); for (const [k, value] of cells) if (k < this.n) all[k] += value; return all; };
    const own = this.data.loose.conditions.filter((one) => one.gap !== null && active.has(keyed(one))).map((one) => [out[one.gap], row(one.cells.map(([k, place]) => [k, out[place]]))]);
    return [...own, ...this.floors.filter((one) => active.has(one.key)).map((one) => { const [u, v, angle] = this.pose(y, one.body); return [gapOf(one, [u, v], angle), row(this.floor(one, y).cells)]; })];
  }
}

const AFTER = new Set(["lost", "slack", "meets"]);

/** The motion goes on with free bodies where something is lost or met, or from the start where a reader has let something go. */
Object.assign(Motion.prototype, {
  goesOn() { return this.model.loose.length > 0 && (this.end ? AFTER.has(this.end.kind) : !this.frames.length) && (this.stretches || 0) < STRETCHES; },

  /** The next stretch, as one more phase: what holds then, how it begins, what ends it. */
  stretch() {
    const event = this.end || { kind: "changed" }, last = this.frames[this.frames.length - 1] || { phase: 0, y: this.start(0), local: 0, time: 0 };
    if (!this.free) this.free = new Free(this, this.end ? this.model.loose.length - 1 : 0);
    const { free } = this, before = this.data.phases[last.phase], { loose } = free.data;
    let y = before.active ? last.y.slice(0, 2 * free.n) : free.from(before, this.look(last.phase, last.y, last.local));
    let active = new Set(before.active || free.names.filter((name) => !this.change.off.has(name)));
    const owner = (name) => (loose.forces.find((force) => force.name === name) || { of: name }).of, t = last.time;
    if (event.kind === "lost" || event.kind === "slack") { active.delete(owner(event.name)); active.delete(owner(event.name) + " turns"); }
    let strike = null;
    if (event.kind === "meets") {
      const gaps = free.look(active, y, t), touching = free.floors.filter((one, k) => gaps[free.base(y) + 6 * k + 1] < TOUCH * one.size).map((one) => one.key);
      for (const name of [event.name, ...touching]) active.add(name);
      const [now, blow] = free.holding(active, y, t, true), n = free.n;
      strike = this.struck(free, y, blow, t);
      active = now;
      y = y.map((value, k) => (k < n ? value : value + blow.gained[k - n]));
    }
    [active] = free.holding(active, y, t);
    this.stretches = (this.stretches || 0) + 1;
    if (this.end) before.endedBy = [this.end.kind, this.end.name];
    this.end = null;
    this.data.phases.push(this.data.phase = this.staged(free, active, y, event));
    this.code.push({ rates: (z, p, at) => free.rates(active, z, at, this.data.phase), look: (z, p, at) => free.look(active, z, at), start: () => [] });
    if (strike) this.blows.push({ phase: this.code.length - 1, time: last.time, ...strike });
    return this.code.length - 1;
  },

  /** The data of a stretch: the forces of floors that are touched, and what may end it. */
  staged(free, active, y, event) {
    const { data } = free, base = free.base(y), several = data.bodies.length > 1;
    const floors = free.floors.map((one, k) => ({ ...one, from: base + 6 * k })), touched = floors.filter((one) => active.has(one.key)), closing = base + 6 * floors.length;
    const forces = touched.map((one) => ({ name: one.key, on: one.on, law: "constraint", unknown: true, at: [one.from + 2, one.from + 3], vector: [one.from + 4, one.from + 5], couple: -1 }));
    for (const force of forces) {
      this.data.forces[keyOf(force)] = { math: "<math><mi>N</mi></math>", text: "N", spoken: "N", on: several ? this.data.bodies[force.on] : "" };
      if (!this.works.includes(keyOf(force))) { this.works.push(keyOf(force)); for (const frame of this.frames) for (const all of new Set([frame.works, frame.before])) all.push([0, 0]); }
    }
    const holds = (name) => active.has((data.loose.forces.find((force) => force.name === name) || { of: name }).of);
    const events = [
      ...data.events.filter((one) => one.kind !== "edge" && holds(one.name)), ...touched.map((one) => ({ kind: "lost", name: one.key, value: one.from })),
      ...floors.filter((one) => !active.has(one.key)).map((one) => ({ kind: "meets", name: one.key, value: one.from + 1 })),
      ...free.closing.flatMap((one, k) => (active.has(one.of) || this.change.off.has(one.of) ? [] : [{ kind: "meets", name: one.of, value: closing + k }])),
    ];
    const moved = free.aside(), asides = closing + free.closing.length, own = data.forces.map((force) => (moved.includes(force) ? { ...force, at: [0, 1].map((axis) => asides + 2 * moved.indexOf(force) + axis) } : force));
    return { ...data, forces: [...own, ...forces], events, active, begin: y, gaps: { rows: [0], held: [] }, after: event };
  },

  /** The impulses of a blow as the explorer shows them, and the kinetic energy that is lost. */
  struck(free, y, { gained, forces, floors }, t) {
    const { data, n } = free, state = (speeds, all) => free.code.look([...y.slice(0, n), ...speeds, ...Array(n).fill(0), ...all], this.numbers, t), none = forces.map(() => 0);
    const before = y.slice(n), after = before.map((value, k) => value + gained[k]), kinetic = (out) => translation({ data, out }) + rotation({ data, out });
    const [old, now, pushed] = [state(before, none), state(after, none), state(before, forces)];
    const own = data.forces.filter((force) => force.unknown).map((force) => ({ ...this.data.forces[keyOf(force)], at: pick(force.at, pushed), vector: pick(force.vector, pushed), couple: pushed[force.couple] || 0 }));
    const met = free.floors.filter((one) => floors.get(one.key) > 0).map((one) => ({ math: "<math><mi>N</mi></math>", text: "N", spoken: "N", at: free.floor(one, y).at, vector: one.line.slice(0, 2).map((part) => part * floors.get(one.key)), couple: 0 }));
    const arrows = [...own, ...met].filter((one) => Math.hypot(...one.vector) > 1e-9);
    return { arrows, parts: arrows.map((one) => ({ ...one, value: Math.hypot(...one.vector) })), lost: kinetic(old) - kinetic(now) };
  },
});
