// Curves beside the picture, drawn as it moves: energies, works, forces, or speed against place; two systems in one plot.

const WIDE = 400, HIGH = 190, PAD = 14, SETS = ["energies", "works", "reactions", "portrait"];

/** name → [{label, look, of: moment → value}] of one motion. */
const CURVES = {
  energies: (motion) => Object.entries(ENERGIES).filter(([name]) => name[0] === "K" || motion.data.phases.some((p) => p.potential !== null))
    .map(([name, of]) => ({ label: WORDS[name], look: name, of })),
  works: (motion) => motion.works.flatMap((key, k) => ["translational", "rotational"].map((look, half) => ({
    label: `${motion.data.forces[key].text}${motion.data.forces[key].on ? " " + motion.data.forces[key].on : ""}, ${WORDS[look]}`, look: `${look} c${k % 4}`, of: (m) => m.works[k][half],
  }))).filter(({ of }) => sampled(motion).some((m) => Math.abs(of(m)) > 1e-9)),
  reactions: (motion) => Object.entries(motion.data.unknowns).map(([name, label], k) => ({
    label: label.text, look: `c${k % 4}`, of: (m) => (name in m.data.unknowns ? m.out[m.data.unknowns[name]] : NaN),
  })),
  portrait: (motion) => Object.entries(motion.data.coordinates).map(([name, c], k) => ({
    label: `${c.speed.text} (${c.here.text})`, look: `c${k % 4}`, x: (m) => m.out[m.data.coordinates[name]], of: (m) => m.out[m.data.speeds[name]],
  })),
};

class Curves {
  constructor(motions, kind) {
    this.lines = motions.flatMap((motion, place) => CURVES[kind](motion).map((one) => this.line(motion, one, place)));
    const points = this.lines.flatMap((one) => one.points).filter((p) => p.every(Number.isFinite));
    this.box = points.length ? boxOf([...points, ...(kind === "portrait" ? [] : [[0, 0]])]) : [0, 0, 1, 1];
    this.isInTime = kind !== "portrait";
    const zero = path([[0, 0], [WIDE, 0]].map(([x]) => [x, this.at([0, 0])[1]]));
    this.cursor = make("path", { class: "cursor" });
    byId("curves").replaceChildren(make("path", { class: "zero", d: zero }), ...this.lines.flatMap(({ faint, drawn, dot }) => [faint, drawn, dot]), ...(this.isInTime ? [this.cursor] : []), ...this.ends());
    for (const one of this.lines) one.faint.setAttribute("d", this.path(one.points));
    byId("curves").setAttribute("aria-label", `${WORDS.curves}: ${WORDS[kind]}. ${this.lines.map((one) => one.label).join("; ")}`);
    byId("curves-key").replaceChildren(...this.lines.map((one) => element("span", { class: "curve " + one.look }, one.label)));
  }

  line(motion, { label, look, x, of }, place) {
    const moments = sampled(motion), looks = `${look}${place ? " second" : ""}`, first = x || ((m) => m.time);
    const several = [state.motions.length > 1 ? `${motion.data.title}: ` : "", state.stated.includes(motion) ? `${WORDS.as_stated}: ` : ""].join("");
    return {
      motion, first, of, label: several + label, look: looks, times: moments.map((m) => m.time), points: moments.map((m) => [first(m), of(m)]),
      faint: make("path", { class: "faint " + looks }), drawn: make("path", { class: "drawn " + looks }), dot: make("circle", { r: 3.2, class: "tip " + looks }),
    };
  }

  /** The numbers at the ends of both axes. */
  ends() {
    const [left, bottom, right, top] = this.box, text = (x, y, anchor, value) => make("text", { x, y, "text-anchor": anchor }, shown(value)), unit = this.isInTime ? "\u202fs" : "";
    const low = text(2, HIGH - 3, "start", bottom), far = text(WIDE - 2, HIGH - 3, "end", right);
    far.append(unit);
    return [text(2, 11, "start", top), low, far, ...(this.isInTime ? [] : [text(WIDE / 3, HIGH - 3, "middle", left)])];
  }

  timeAt(x) { const [left, , right] = this.box; return left + ((x - PAD) / (WIDE - 2 * PAD)) * (right - left); }

  at([x, y]) {
    const [left, bottom, right, top] = this.box, wide = right - left || 1, high = top - bottom || 1;
    return [PAD + ((x - left) / wide) * (WIDE - 2 * PAD), HIGH - PAD - ((y - bottom) / high) * (HIGH - 2 * PAD)];
  }

  /** A path that is broken where a quantity is not known. */
  path(points) {
    const runs = [[]];
    for (const point of points) if (point.every(Number.isFinite)) runs[runs.length - 1].push(this.at(point)); else runs.push([]);
    return runs.filter((run) => run.length).map((run) => path(run)).join("");
  }

  show(time) {
    for (const one of this.lines) {
      const now = one.motion.at(Math.min(time, one.motion.duration)), tip = [one.first(now), one.of(now)];
      const done = one.points.filter((_, k) => one.times[k] <= time), known = tip.every(Number.isFinite);
      one.drawn.setAttribute("d", this.path([...done, ...(known ? [tip] : [])]));
      const [x, y] = known ? this.at(tip) : [-9, -9];
      one.dot.setAttribute("cx", fixed(x));
      one.dot.setAttribute("cy", fixed(y));
    }
    const [x] = this.at([Math.min(time, this.box[2]), 0]);
    this.cursor.setAttribute("d", path([[x, 0], [x, HIGH]]));
  }
}
