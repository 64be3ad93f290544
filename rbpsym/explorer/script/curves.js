// Curves beside the picture, drawn as it moves, with their values at the cursor: energies, works, forces, or speed against place, where
// an angle that comes back after a turn is wrapped; two systems in one plot.

const WIDE = 400, HIGH = 190, PAD = 14, SETS = ["energies", "works", "reactions", "portrait"];

/** name → [{label, look, of: moment → value}] of one motion. */
const CURVES = {
  energies: (motion) => Object.entries(ENERGIES).filter(([name]) => name[0] === "K" || motion.data.phases.some((p) => p.potential !== null))
    .map(([name, of]) => ({ label: WORDS[name], look: name, unit: "J", of })),
  works: (motion) => motion.works.flatMap((key, k) => ["translational", "rotational"].map((look, half) => ({
    label: `${motion.data.forces[key].text}${motion.data.forces[key].on ? " " + motion.data.forces[key].on : ""}, ${WORDS[look]}`, look: `${look} c${k % 4}`, unit: "J", of: (m) => m.works[k][half],
  }))).filter(({ of }) => sampled(motion).some((m) => Math.abs(of(m)) > 1e-9)),
  reactions: (motion) => Object.entries(motion.data.unknowns).map(([name, label], k) => ({
    label: label.text, look: `c${k % 4}`, unit: motion.data.phases.some((p) => p.couples.includes(name)) ? "N m" : "N", of: (m) => (name in m.data.unknowns ? m.out[m.data.unknowns[name]] : NaN),
  })),
  portrait: (motion) => Object.entries(motion.data.coordinates).map(([name, c], k) => {
    const wraps = comesBack(motion, name), place = (m) => m.out[m.data.coordinates[name]];
    return { label: `${c.speed.text} (${c.here.text})`, look: `c${k % 4}`, unit: c.speedUnit, wraps, x: (m) => (wraps ? wrapped(place(m)) : place(m)) / c.size, across: c.unit, of: (m) => m.out[m.data.speeds[name]] };
  }),
};

const wrapped = (angle) => angle - TURN * Math.round(angle / TURN);

/** Is all as before after a whole turn of a coordinate, and does the motion go farther than that? */
function comesBack(motion, name) {
  const { phase, y, local } = motion.frames[0], data = motion.data.phases[phase], before = motion.look(phase, y, local), values = motion.frames.map((frame) => coordinate(motion, frame, name));
  if (motion.data.coordinates[name].unit !== "°" || Math.max(...values) - Math.min(...values) < TURN) return false;
  const turned = y.slice(0, data.free).map((_, k) => motion.look(phase, y.with(k, y[k] + TURN), local)), own = data.coordinates[name];
  const after = turned.find((out) => Object.values(data.coordinates).every((at) => Math.abs(out[at] - before[at] - (at === own ? TURN : 0)) < 1e-9));
  const seen = [...data.bodies.flatMap((body) => [...body.at, ...body.cm, ...body.v]), ...data.forces.flatMap((force) => [...force.at, ...force.vector, force.couple]), data.potential ?? own];
  return Boolean(after) && seen.every((at) => at === own || !(Math.abs(after[at] - before[at]) > 1e-6 * (1 + Math.abs(before[at])))) && data.bodies.every(({ angle }) => Math.abs(wrapped(after[angle] - before[angle])) < 1e-6);
}

class Curves {
  constructor(motions, kind) {
    this.lines = motions.flatMap((motion, place) => CURVES[kind](motion).map((one) => this.line(motion, one, place)));
    const points = this.lines.flatMap((one) => one.points).filter((p) => p.every(Number.isFinite));
    this.box = points.length ? boxOf([...points, ...(kind === "portrait" ? [] : [[0, 0]])]) : [0, 0, 1, 1];
    this.isInTime = kind !== "portrait";
    const zero = path([[0, 0], [WIDE, 0]].map(([x]) => [x, this.at([0, 0])[1]]));
    this.cursor = make("path", { class: "cursor" });
    byId("curves").replaceChildren(make("path", { class: "zero", d: zero }), ...this.lines.flatMap(({ faint, drawn, dot }) => [faint, drawn, dot]), ...(this.isInTime ? [this.cursor] : []), ...this.ends());
    for (const one of this.lines) one.faint.setAttribute("d", this.path(one.points, one.wraps));
    byId("curves").setAttribute("aria-label", `${WORDS.curves}: ${WORDS[kind]}. ${this.lines.map((one) => one.label).join("; ")}`);
    byId("curves-key").replaceChildren(...this.lines.map((one) => element("span", { class: "curve " + one.look }, [one.label + " ", one.reading.node])));
  }

  line(motion, { label, look, x, of, unit, across, wraps }, place) {
    const moments = wraps ? motion.frames.map((frame) => ({ ...frame, data: motion.data.phases[frame.phase], out: motion.look(frame.phase, frame.y, frame.local) })) : sampled(motion), looks = `${look}${place ? " second" : ""}`, first = x || ((m) => m.time);
    const several = [state.motions.length > 1 ? `${motion.data.title}: ` : "", state.stated.includes(motion) ? `${WORDS.as_stated}: ` : ""].join("");
    return {
      motion, first, of, wraps, across, label: several + label, look: looks, times: moments.map((m) => m.time), points: moments.map((m) => [first(m), of(m)]), reading: new Reading(`${place}.curve.${label}`, unit),
      faint: make("path", { class: "faint " + looks }), drawn: make("path", { class: "drawn " + looks }), dot: make("circle", { r: 3.2, class: "tip " + looks }),
    };
  }

  /** The numbers at the ends of both axes. */
  ends() {
    const [left, bottom, right, top] = this.box, text = (x, y, anchor, value) => make("text", { x, y, "text-anchor": anchor }, shown(value)), unit = this.isInTime ? "\u202fs" : new Set(this.lines.map((one) => one.across)).size === 1 ? (this.lines[0].across === "°" ? "°" : "\u202f" + this.lines[0].across) : "";
    const low = text(2, HIGH - 3, "start", bottom), far = text(WIDE - 2, HIGH - 3, "end", right);
    far.append(unit);
    return [text(2, 11, "start", top), low, far, ...(this.isInTime ? [] : [text(WIDE / 3, HIGH - 3, "middle", left)])];
  }

  /** The time of a place in the plot: of speed against place, that of the nearest point of a curve. */
  timeAt(x, y) {
    const [left, , right] = this.box, far = (point) => { const [u, v] = this.at(point), away = Math.hypot(u - x, v - y); return Number.isFinite(away) ? away : Infinity; };
    if (this.isInTime) return left + ((x - PAD) / (WIDE - 2 * PAD)) * (right - left);
    return this.lines.flatMap((one) => one.points.map((point, k) => [far(point), one.times[k]])).reduce((a, b) => (b[0] < a[0] ? b : a), [Infinity, 0])[1];
  }

  at([x, y]) {
    const [left, bottom, right, top] = this.box, wide = right - left || 1, high = top - bottom || 1;
    return [PAD + ((x - left) / wide) * (WIDE - 2 * PAD), HIGH - PAD - ((y - bottom) / high) * (HIGH - 2 * PAD)];
  }

  /** A path that is broken where a quantity is not known, and where a wrapped angle jumps. */
  path(points, wraps) {
    const runs = [[]];
    points.forEach((point, k) => {
      if (wraps && k && Math.abs(point[0] - points[k - 1][0]) > 180) runs.push([]);
      if (point.every(Number.isFinite)) runs[runs.length - 1].push(this.at(point)); else runs.push([]);
    });
    return runs.filter((run) => run.length).map((run) => path(run)).join("");
  }

  show(time) {
    for (const one of this.lines) {
      const now = one.motion.at(Math.min(time, one.motion.duration)), tip = [one.first(now), one.of(now)];
      const done = one.points.filter((_, k) => one.times[k] <= time), known = tip.every(Number.isFinite);
      one.drawn.setAttribute("d", this.path([...done, ...(known ? [tip] : [])], one.wraps));
      one.reading.set(tip[1]);
      const [x, y] = known ? this.at(tip) : [-9, -9];
      one.dot.setAttribute("cx", fixed(x));
      one.dot.setAttribute("cy", fixed(y));
    }
    const [x] = this.at([Math.min(time, this.box[2]), 0]);
    this.cursor.setAttribute("d", path([[x, 0], [x, HIGH]]));
  }
}
