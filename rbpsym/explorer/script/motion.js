// The motion of a model from its start: states at many moments, the works done until then, what ends it.

const FLASH = 0.08, FRAME = 0.01, LONGEST = 10, RADIANS = 75, FAR = 6, APART = 2.5, HARDLY = 1e-7, NUDGE = 2e-3;

/** What a reader changes of a system: what is let go, the force whose line of action is moved, and how far to its left. */
const AS_STATED = { off: new Set(), force: "", aside: 0 };

/** A system with its numbers, ready to be asked. */
class Motion {
  constructor(model, numbers, change = AS_STATED) {
    this.data = { ...model.data, phases: [...model.data.phases], forces: { ...model.data.forces } };
    this.code = [...model.code];
    Object.assign(this, { model, numbers, change, floors: [] });
    this.frames = [];
    this.blows = [];
    this.end = null;
    this.works = [...new Set(this.data.phases.flatMap((phase) => phase.forces.map(keyOf)))];
    this.run();
  }

  /** All numbers of a phase at a state. */
  look(phase, x, t) {
    const out = this.code[phase].look(x, this.numbers, t), { active, bodies } = this.data.phases[phase];
    if (!active) for (const one of this.floors) { const body = bodies[one.body]; out.push(gapOf(one, pick(body.at, out), out[body.angle])); }
    return out;
  }

  run() {
    let t = 0, works = this.works.map(() => [0, 0]);
    this.watched();
    if (!this.change.off.size && !this.change.aside) for (let phase = 0; phase < this.model.code.length && !this.isOver(); phase++) [t, works] = this.runPhase(phase, t, works);
    while (this.goesOn()) {
      const phase = this.stretch();
      [t, works] = this.runPhase(phase, t, [...works, ...this.works.slice(works.length).map(() => [0, 0])]);
    }
    this.end = this.end || { kind: "time", time: t };
  }

  /** The floors on whose free side corners begin, and the events that they are met. */
  watched() {
    const y = this.start(0), out = this.code[0].look(y, this.numbers, 0);
    if (!this.model.loose.length || !out.every(Number.isFinite)) return;
    this.floors = floorsOf(this, out);
    this.data.phases = this.data.phases.map((data, phase) => {
      const base = this.code[phase].look([...y, ...Array(data.size).fill(0)], this.numbers, 0).length;
      return { ...data, events: [...data.events, ...this.floors.map(({ key }, k) => ({ kind: "meets", name: key, value: base + k }))] };
    });
  }

  isOver() { return this.end !== null; }

  start(phase) {
    if (this.data.phases[phase].begin) return this.data.phases[phase].begin;
    const places = this.data.phases[phase].start, values = this.code[phase].start([], this.numbers, 0);
    const { rows, held } = this.data.phases[phase].gaps, state = places.map((place) => values[place]);
    if (phase === 0 && !this.endsAtOnce()) this.nudge(state);
    if (!rows.length) return state;
    const free = this.allCoordinates(phase).filter((k) => !held.includes(k));
    return kept((x) => this.conditions(phase, x, 0), state, free.length ? free : this.allCoordinates(phase));
  }

  /** Does the first phase end where it begins? (A blow strikes what is at rest.) */
  endsAtOnce() {
    const { endsAt } = this.data.phases[0];
    return endsAt !== null && this.code[0].start([], this.numbers, 0)[endsAt] === 0;
  }

  /** What rests in equilibrium gets a small displacement, as every book tacitly gives it. */
  nudge(state) {
    const { nudge, size } = this.data.phases[0], full = [...state, ...this.data.phases[0].forces.flatMap(() => [0, 0])];
    if (!nudge || this.code[0].rates(full, this.numbers, 0).slice(0, size).some((rate) => !(Math.abs(rate) < HARDLY))) return;
    state[nudge.place] += NUDGE * nudge.way;
    this.nudged = nudge.name;
  }

  allCoordinates(phase) { return Array.from({ length: this.data.phases[phase].free }, (_, k) => k); }

  conditions(phase, x, t) {
    if (this.data.phases[phase].active) return this.free.conditions(this.data.phases[phase].active, x, t);
    const out = this.code[phase].gaps(x, this.numbers, t);
    return this.data.phases[phase].gaps.rows.map(([gap, slopes]) => [out[gap], slopes.map((k) => out[k])]);
  }

  /** Frames of a phase that begins at `began`; [the time of its end, the works until then]. */
  runPhase(phase, began, worksBefore) {
    const data = this.data.phases[phase], places = data.forces.map((force) => this.works.indexOf(keyOf(force)));
    const ends = data.endsAt === null ? Infinity : this.code[phase].start([], this.numbers, 0)[data.endsAt];
    const watch = new Watch(data, (x, t) => this.look(phase, x, t));
    const pack = (y) => this.frame(phase, y, worksBefore, places);
    let y = [...this.start(phase), ...data.forces.flatMap(() => [0, 0])], t = 0;
    this.strike(phase, began);
    const push = () => { const frame = pack(y); Object.assign(frame, { time: began + t, local: t, began }); this.frames.push(frame); };
    push();
    if (!y.every(Number.isFinite) || !this.look(phase, y, 0).every(Number.isFinite)) {
      this.end = { kind: "numbers", time: began };
      return [began, worksBefore];
    }
    if (data.active) watch.first(y); else this.unfit = this.unfit || watch.first(y);
    const longest = this.longest(phase, y, began);
    let event = null;
    while (!event && t < ends && began + t < longest - 1e-9) {
      const span = Math.min(FRAME, ends - t, longest - began - t), next = this.after(phase, y, t, span);
      if (!next) { event = { kind: "singular" }; break; }
      event = watch.passed(next, t + span);
      if (event) {
        const share = this.moment(phase, y, t, span, watch, event);
        y = this.after(phase, y, t, share) || y;
        t += share;
      } else { y = next; t += span; }
      push();
      if (!event && phase + 1 === this.code.length && this.isFar(phase)) event = { kind: "far" };
    }
    const last = this.frames[this.frames.length - 1];
    if (event && data.endsWith.some(([kind, name]) => kind === event.kind && name === event.name)) event = null;
    if (event) this.end = { ...event, time: last.time };
    if (began + t >= longest - 1e-9) this.end = this.end || { kind: "time", time: last.time };
    return [last.time, last.works];
  }

  /** The time beyond which nothing is recorded: what turns fast is not watched for long. */
  longest(phase, y, began) {
    if (phase + 1 < this.code.length) return LONGEST;
    const out = this.look(phase, y, 0), turning = Math.max(...this.data.phases[phase].bodies.map((body) => Math.abs(out[body.omega])));
    const rests = this.data.phases[phase].active && this.code[phase].rates(y, this.numbers, 0).slice(0, this.data.phases[phase].size).every((rate, k, all) => k < all.length / 2 || Math.abs(rate) < HARDLY);
    return Math.min(LONGEST, began + 1 + (rests ? 0 : RADIANS / turning));
  }

  /** Notes the impulses with which a phase begins. */
  strike(phase, time) {
    const strikes = this.data.phases[phase].strikes;
    if (!strikes) return;
    const values = this.code[phase].start([], this.numbers, 0), of = (place) => values[place];
    const arrows = strikes.arrows.map((one) => ({ ...one, at: one.at.map(of), vector: one.vector.map(of), couple: of(one.couple) }));
    const parts = strikes.parts.map((one) => ({ ...one, value: of(one.value) }));
    this.blows.push({ phase, time, arrows, parts, lost: of(strikes.lost) });
  }

  /** The impulses that act just now: they are seen for a while. */
  blow(time) {
    const shown = FLASH * this.duration;
    return this.blows.find((one) => one.time <= time + 1e-9 && time < one.time + shown);
  }

  /** The kinetic energy that impulses have taken until a time. */
  lost(time) { return this.blows.reduce((sum, one) => sum + (one.time <= time + 1e-9 ? one.lost : 0), 0); }

  /** The state and works a little later, the conditions kept. */
  after(phase, y, t, span) {
    const size = this.data.phases[phase].size;
    const next = span > 0 ? advance((z, at) => this.code[phase].rates(z, this.numbers, at), y, t, span) : y;
    if (!next || !this.data.phases[phase].gaps.rows.length) return next;
    const state = kept((x) => this.conditions(phase, x, t + span), next.slice(0, size), this.allCoordinates(phase));
    return [...state, ...next.slice(size)];
  }

  /** How long after t the event comes, by halving. */
  moment(phase, y, t, span, watch, event) {
    let low = 0, high = span;
    for (let k = 0; k < 48; k++) {
      const middle = (low + high) / 2, state = this.after(phase, y, t, middle);
      if (state && watch.value(event, state, t + middle) > 0) low = middle; else high = middle;
    }
    return low;
  }

  frame(phase, y, before, places) {
    const size = this.data.phases[phase].size, works = before.map((pair) => pair.slice());
    places.forEach((place, k) => {
      works[place][0] += y[size + 2 * k];
      works[place][1] += y[size + 2 * k + 1];
    });
    return { phase, y, works, before };
  }

  /** Has a body gone, in the last phase, much farther than the system is large, or have the bodies come apart? */
  isFar(phase) {
    const centres = (frame) => {
      const out = this.look(frame.phase, frame.y, frame.local);
      return this.data.phases[frame.phase].bodies.map((body) => [out[body.cm[0]], out[body.cm[1]]]);
    };
    if (!this.reach) {
      const first = this.frames.find((frame) => frame.phase === phase);
      this.first = centres(first);
      this.reach = FAR * extentOf(this, first);
    }
    const frame = this.frames[this.frames.length - 1], now = centres(frame);
    return extentOf(this, frame) > (APART / FAR) * this.reach || now.some(([x, y], k) => Math.hypot(x - this.first[k][0], y - this.first[k][1]) > this.reach);
  }

  get duration() { return this.frames[this.frames.length - 1].time; }

  /** Everything at a time: the frame before it, carried on to that very moment. */
  at(time) {
    let low = 0, high = time > 0 ? this.frames.length - 1 : 0;  // it opens with the first phase, also if that ends at once
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.frames[middle].time <= time) low = middle; else high = middle - 1;
    }
    const frame = this.frames[low], phase = frame.phase, more = Math.min(time, this.duration) - frame.time;
    const data = this.data.phases[phase];
    const y = more > 0 && low < this.frames.length - 1 ? this.after(phase, frame.y, frame.local, more) || frame.y : frame.y;
    const places = data.forces.map((force) => this.works.indexOf(keyOf(force)));
    const shown = this.frame(phase, y, frame.before, places), local = frame.local + Math.max(0, more);
    return { ...shown, time: Math.min(time, this.duration), local, data, out: this.look(phase, y, local) };
  }
}

/** Forces of one name on one body are one row of the ledger. */
function keyOf(force) { return force.name + "@" + force.on; }

/** What may end a phase: numbers that must stay positive. */
class Watch {
  constructor(data, look) {
    this.events = data.events;
    this.look = look;
    this.armed = this.events.map(() => false);
  }

  value(event, y, t) { return this.signed(event, this.look(y, t)); }

  /** The number of an event; what is reached may come from either side. */
  signed(event, out) {
    const value = out[event.value];
    if (event.kind !== "reaches") return value;
    if (!event.side && Math.abs(value) > HARDLY) event.side = Math.sign(value);
    return value * (event.side || 0);
  }

  /** An event that is there from the start: it is told, and watched no more. */
  first(y) {
    const out = this.look(y, 0);
    this.events.forEach((event, k) => { event.side = 0; this.armed[k] = this.signed(event, out) > HARDLY; });
    const found = this.events.find((event) => this.signed(event, out) < -HARDLY);
    this.events = this.events.filter((event) => !(this.signed(event, out) < -HARDLY));
    this.armed = this.events.map((event) => this.signed(event, out) > HARDLY);
    return found || null;
  }

  /** The first event that has come since the last time. */
  passed(y, t) {
    const out = this.look(y, t);
    const found = this.events.find((event, k) => this.signed(event, out) < (this.armed[k] ? 0 : -HARDLY));
    this.events.forEach((event, k) => { this.armed[k] = this.armed[k] || this.signed(event, out) > HARDLY; });
    return found || null;
  }
}
