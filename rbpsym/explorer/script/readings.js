// Numbers beside the picture: every one stands in a <data> element with its full value.

const LANGUAGE = document.documentElement.lang || "en";
const SHORT = new Intl.NumberFormat(LANGUAGE, { maximumSignificantDigits: 4 });

function shown(value) {
  if (!Number.isFinite(value)) return "–";
  return SHORT.format(Math.abs(value) < 1e-9 ? 0 : value).replace(/^-/, "−");
}

function element(tag, attributes = {}, inside = []) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...(Array.isArray(inside) ? inside : [inside]));
  return node;
}

/** A formula of the model: seen as it is printed, heard as it is spoken. */
function formula(label) {
  const seen = element("span", { class: "formula", "aria-hidden": "true" });
  seen.innerHTML = label.math;
  return element("span", {}, [seen, element("span", { class: "hidden" }, label.spoken)]);
}

/** A number that is read out: `key` names it, `value` holds it in SI units. */
class Reading {
  constructor(key, unit = "", size = 1) {
    this.node = element("data", { "data-key": key, value: "0" });
    Object.assign(this, { unit, size });
  }

  set(value) {
    this.node.value = Number.isFinite(value) ? String(value) : "NaN";
    const text = shown(value / this.size);
    this.node.textContent = this.unit && Number.isFinite(value) ? text + (this.unit === "°" ? "°" : "\u202f" + this.unit) : text;
  }
}

/** A bar from zero to the left or right; its full length is `scale`. */
class Bar {
  constructor(look) {
    this.fill = element("span", { class: "fill " + look });
    this.node = element("span", { class: "track", "aria-hidden": "true" }, this.fill);
  }

  set(value, scale) {
    const share = Math.min(1, Math.abs(value) / (scale || 1)) * 50;
    this.fill.style.width = share.toFixed(2) + "%";
    this.fill.style.left = (value < 0 ? 50 - share : 50).toFixed(2) + "%";
  }
}

const LOOKS = { [WORDS.translational]: "translational", [WORDS.orbital]: "translational", [WORDS.rotational]: "rotational", [WORDS.spin]: "rotational" };

/** A table with a caption, a row of heads, and rows that begin with a head. */
function tableOf(caption, heads, rows) {
  const head = element("tr", {}, heads.map((text) => (text ? element("th", { scope: "col", class: LOOKS[text] || "" }, text) : element("td"))));
  const lines = rows.map(([first, ...cells]) => element("tr", {}, [element("th", { scope: "row" }, first), ...cells.map((cell) => element("td", {}, cell))]));
  return element("div", { class: "scroll" }, element("table", {}, [element("caption", {}, caption), ...(heads.length ? [element("thead", {}, head)] : []), element("tbody", {}, lines)]));
}

/** All numbers and bars of one motion. */
class Readings {
  constructor(holder, motion, place) {
    Object.assign(this, { motion, place, updates: [] });
    const weighed = motion.data.weighs ? [this.works(), this.energies(), this.momenta()] : [];
    holder.replaceChildren(...weighed, this.forces(), this.impulses(), this.position());
    this.scales = this.measured();
  }

  reading(key, unit, size, of) {
    const found = new Reading(`${this.place}.${key}`, unit, size);
    this.updates.push((moment) => found.set(of(moment)));
    return found.node;
  }

  bar(look, of, scale) {
    const found = new Bar(look);
    this.updates.push((moment) => found.set(of(moment), this.scales[scale]));
    return found.node;
  }

  position() {
    const rows = Object.entries(this.motion.data.coordinates).map(([name, c]) => [
      formula(c.here),
      this.reading(`q.${name}`, c.unit, c.size, (m) => m.out[m.data.coordinates[name]]),
      this.reading(`v.${name}`, c.speedUnit, 1, (m) => m.out[m.data.speeds[name]]),
      this.motion.data.phases.some((p) => name in p.accelerations) ? this.reading(`a.${name}`, c.gainUnit, 1, (m) => m.out[m.data.accelerations[name]]) : "",
    ]);
    return tableOf(WORDS.position, [WORDS.coordinate, WORDS.here, WORDS.speed, WORDS.acceleration], rows);
  }

  works() {
    const rows = this.motion.works.map((key, k) => {
      const of = this.motion.data.forces[key], name = element("span", {}, [formula(of), of.on ? element("small", {}, " " + of.on) : ""]);
      const bars = element("span", { class: "pair" }, [this.bar("translational", (m) => m.works[k][0], "work"), this.bar("rotational", (m) => m.works[k][1], "work")]);
      return [name, bars, ...this.halves(key, k)];
    });
    const heads = [WORDS.force, "", WORDS.translational, WORDS.rotational, WORDS.sum];
    return tableOf(WORDS.works, heads, rows);
  }

  halves(key, k) {
    return [
      this.reading(`W_T.${key}`, "", 1, (m) => m.works[k][0]),
      this.reading(`W_R.${key}`, "", 1, (m) => m.works[k][1]),
      this.reading(`W.${key}`, "", 1, (m) => m.works[k][0] + m.works[k][1]),
    ];
  }

  energies() {
    const rows = Object.entries(ENERGIES).filter(([name]) => name[0] === "K" || this.motion.data.phases.some((p) => p.potential !== null));
    if (this.motion.blows.length) rows.push(["lost", (m) => this.motion.lost(m.time)]);
    return tableOf(WORDS.energies, [], rows.map(([name, of]) => [
      WORDS[name], this.bar(name, (m) => of(m), "energy"), this.reading(name, "", 1, of),
    ]));
  }

  momenta() {
    const origins = Object.entries(this.motion.data.origins), bodies = Object.entries(this.motion.data.bodies);
    const rows = origins.flatMap(([origin, label]) => bodies.map(([body, title]) => [
      element("span", {}, [title, origins.length > 1 ? " · " : "", origins.length > 1 ? formula(label) : ""]),
      element("span", { class: "pair" }, [this.bar("translational", (m) => momentum(m, body, origin)[0], "momentum"), this.bar("rotational", (m) => momentum(m, body, origin)[1], "momentum")]),
      this.reading(`L_orbital.${body}.${origin}`, "", 1, (m) => momentum(m, body, origin)[0]),
      this.reading(`L_spin.${body}.${origin}`, "", 1, (m) => momentum(m, body, origin)[1]),
    ]));
    return tableOf(WORDS.momenta, [WORDS.body, "", WORDS.orbital, WORDS.spin], rows);
  }

  forces() {
    const names = Object.entries(this.motion.data.unknowns);
    const unit = (name) => (this.motion.data.phases.some((p) => p.couples.includes(name)) ? "N m" : "N");
    if (!names.length) return "";
    return tableOf(WORDS.reactions, [WORDS.force, WORDS.size], names.map(([name, label]) => [
      formula(label), this.reading(`R.${name}`, unit(name), 1, (m) => (name in m.data.unknowns ? m.out[m.data.unknowns[name]] : NaN)),
    ]));
  }

  /** The impulses that have acted until now. */
  impulses() {
    const rows = this.motion.blows.flatMap((blow, k) => blow.parts.map((one, n) => [
      formula(one), this.reading(`J.${k}.${n}`, "N s", 1, (m) => (blow.time <= m.time + 1e-9 ? one.value : NaN)),
    ]));
    return rows.length ? tableOf(WORDS.impulses, [WORDS.impulse, WORDS.size], rows) : "";
  }

  /** The largest of each kind of number over the motion: what a whole bar stands for. */
  measured() {
    const found = { work: 1e-12, energy: 1e-12, momentum: 1e-12 };
    sampled(this.motion).forEach((m) => {
      for (const pair of m.works) found.work = Math.max(found.work, ...pair.map(Math.abs));
      for (const of of Object.values(ENERGIES)) found.energy = Math.max(found.energy, Math.abs(of(m)) || 0);
      found.energy = Math.max(found.energy, Math.abs(this.motion.lost(m.time)));
      for (const origin of Object.keys(m.data.origins)) {
        for (const body of m.data.bodies) found.momentum = Math.max(found.momentum, ...momentum(m, body.name, origin).map(Math.abs));
      }
    });
    return found;
  }

  show(moment) { this.updates.forEach((update) => update(moment)); }
}

/** Some moments all over a motion. */
function sampled(motion) {
  const step = Math.max(1, Math.floor(motion.frames.length / 120)), found = [];
  for (let k = 0; k < motion.frames.length; k += step) {
    const frame = motion.frames[k], data = motion.data.phases[frame.phase];
    found.push({ ...frame, data, out: motion.look(frame.phase, frame.y, frame.local) });
  }
  return found;
}

function kinetic(m, of) { return m.data.bodies.reduce((sum, body) => sum + of(body, m.out), 0); }
const translation = (m) => kinetic(m, (body, out) => 0.5 * out[body.mass] * (out[body.v[0]] ** 2 + out[body.v[1]] ** 2));
const rotation = (m) => kinetic(m, (body, out) => 0.5 * out[body.moment] * out[body.omega] ** 2);
const potential = (m) => (m.data.potential === null ? NaN : m.out[m.data.potential]);
const ENERGIES = { K_T: translation, K_R: rotation, U: potential, E: (m) => translation(m) + rotation(m) + potential(m) };

/** [R × P, I ω] of a body about an origin. */
function momentum(m, name, origin) {
  const body = m.data.bodies.find((one) => one.name === name), at = pick(m.data.origins[origin], m.out);
  const [x, y] = pick(body.cm, m.out), [u, v] = pick(body.v, m.out);
  return [m.out[body.mass] * ((x - at[0]) * v - (y - at[1]) * u), m.out[body.moment] * m.out[body.omega]];
}
