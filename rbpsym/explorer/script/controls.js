// The page: sliders, playing, seeking, what is said aloud.

const SPEEDS = [1, 0.5, 0.25, 0.1, 0.05], SHORTEST = 1.5, FASTEST = 14, CALM = 0.2, LONGEST_ARROW = 84;
const byId = (id) => document.getElementById(id);
const calm = matchMedia("(prefers-reduced-motion: reduce)");
const told = (key, slots = {}) => WORDS[key].replace(/\{(\w+)\}/g, (_, name) => slots[name] ?? "");

const state = { time: 0, playing: false, numbers: {}, motions: [], stated: [], change: { ...AS_STATED, off: new Set() }, drawings: [], readings: [], seekers: [] };

/** All adjustable numbers by name; those that two models share are one. */
const NUMBERS = new Map();
for (const one of MODELS.flatMap((model) => model.data.numbers)) if (!NUMBERS.has(one.name)) NUMBERS.set(one.name, one);

function begin() {
  const wanted = new URLSearchParams(location.hash.slice(1));
  for (const [name, one] of NUMBERS) state.numbers[name] = wanted.has(name) ? Number(wanted.get(name)) : one.value;
  byId("speed").replaceChildren(...SPEEDS.map((value) => element("option", { value }, told("times", { value: shown(value) }))));
  const kinds = SETS.filter((kind) => MODELS.some((model) => kind === "portrait" || (model.data.weighs && (kind !== "reactions" || Object.keys(model.data.unknowns).length))));
  byId("curves-kind").replaceChildren(...kinds.map((kind) => element("option", { value: kind }, WORDS[kind])));
  layerBoxes();
  releaseBoxes();
  document.querySelector(".legend").hidden = !MODELS.some((model) => model.data.weighs);
  MODELS.forEach((_, place) => draggable(byId("picture-" + place), place));
  sliders();
  rebuild();
  pace();
  seek(Math.min(Number(wanted.get("t")) || 0, longest()));
  document.documentElement.dataset.ready = "yes";
}

/** What is over in a moment, or turns fast, is played more slowly. */
function pace() {
  const turning = mostly(state.motions.flatMap(sampled).map(({ data, out }) => Math.max(...data.bodies.map((body) => Math.abs(out[body.omega])))));
  const fitting = SPEEDS.find((value) => longest() / value >= SHORTEST && turning * value <= FASTEST);
  byId("speed").value = fitting || SPEEDS[SPEEDS.length - 1];
}

// --- numbers

function sliders() {
  byId("numbers").replaceChildren(...[...NUMBERS.values()].map(slider));
}

function slider(one) {
  const id = "number-" + one.name, size = one.unit_size, now = state.numbers[one.name];
  const least = Math.min(one.least, now), most = Math.max(one.most, now);
  const input = element("input", { type: "range", id, min: least, max: most, step: (most - least) / 200, "data-name": one.name });
  input.setAttribute("aria-label", [one.spoken, one.meaning].filter(Boolean).join(", "));
  const reading = new Reading("p." + one.name, one.unit, size);
  const field = element("input", { type: "number", step: "any", "data-number": one.name, "aria-label": input.getAttribute("aria-label") + " (" + (one.unit || "1") + ")" });
  const tell = () => {
    reading.set(state.numbers[one.name]);
    input.setAttribute("aria-valuetext", reading.node.textContent);
    field.value = Number((state.numbers[one.name] / size).toPrecision(6));
  };
  input.value = now;
  tell();
  reading.node.hidden = true; // the field shows it
  input.addEventListener("input", () => { state.numbers[one.name] = Number(input.value); tell(); soon(); });
  input.addEventListener("change", () => tells("changed", { name: one.name }));
  field.addEventListener("change", () => { if (typed(one, field.valueAsNumber * size, input)) { soon(); tells("changed", { name: one.name }); } tell(); });
  const name = element("label", { for: id, class: "slider-name" }, formula(one));
  return element("div", { class: "slider", title: one.meaning }, [name, " ", field, one.unit ? "\u202f" + one.unit : "", reading.node, input]);
}

/** A number that was typed counts, also beyond the ends of its slider; where only positive ones make sense, others do not. */
function typed(one, value, input) {
  if (!Number.isFinite(value) || (one.least > 0 && value <= 0) || (one.least === 0 && value < 0)) return false;
  state.numbers[one.name] = value;
  Object.assign(input, { min: Math.min(input.min, value), max: Math.max(input.max, value), value });
  return true;
}

let waiting = 0;
/** Work out the motions again before the next picture. */
function soon() {
  if (!waiting) waiting = requestAnimationFrame(() => { waiting = 0; rebuild(); seek(Math.min(state.time, longest())); });
}

function rebuild() {
  const made = (change) => MODELS.map((model) => new Motion(model, model.data.numbers.map((one) => state.numbers[one.name]), change));
  state.motions = made(isChanged() ? { ...state.change, off: new Set(state.change.off) } : AS_STATED);
  state.stated = isChanged() ? made(AS_STATED) : [];
  const fine = state.motions.filter((motion) => motion.end.kind !== "numbers");
  const whole = fine.length ? fine.map(boxOfMotion).reduce(joinBoxes) : [-1, -1, 1, 1], force = forceScale(fine);
  const size = Math.max(...fine.map((motion) => extentOf(motion, motion.frames[0])), 1e-9);
  const beyond = new Scale(whole, size).beyond(fine, force), scaled = () => new Scale(whole, size, beyond);
  state.drawings = state.motions.map((motion, k) => new Drawing(byId("picture-" + k), motion, scaled(), force));
  state.readings = state.motions.map((motion, k) => new Readings(byId("readings-" + k), motion, k));
  const slider = byId("time");
  slider.max = longest();
  slider.step = Math.max(longest() / 1000, 1e-6);
  byId("force-scale").textContent = told("scale", { size: shown(force.legend) });
  byId("force-bar").style.width = fixed(force.legend * force.factor * (byId("picture-0").clientWidth / ROOM || 0.8)) + "px";
  byId("impulse-key").hidden = !fine.some((motion) => motion.blows.length);
  seekers();
  curves();
  aboutTable();
  lineShown();
  asks();
}

function curves() {
  const fine = [...state.motions, ...state.stated].filter((motion) => motion.end.kind !== "numbers");
  state.curves = fine.length ? new Curves(fine, byId("curves-kind").value) : null;
}

const longest = () => Math.max(...state.motions.map((motion) => motion.duration));

/** Picture units for a newton and radians for a newton metre: the same for all arrows. */
function forceScale(motions) {
  const sizes = [], couples = [];
  motions.flatMap(sampled).forEach(({ data, out }) => {
    sizes.push(Math.max(0, ...data.forces.map((force) => Math.hypot(...pick(force.vector, out)))));
    couples.push(Math.max(0, ...data.forces.map((force) => Math.abs(out[force.couple]))));
  });
  const factor = LONGEST_ARROW / mostly(sizes), power = Math.pow(10, Math.floor(Math.log10(60 / factor)));
  const legend = power * ([5, 2, 1].find((n) => n * power <= 60 / factor) || 1);
  const blows = motions.flatMap((motion) => motion.blows.flatMap((blow) => blow.arrows.map((one) => Math.hypot(...one.vector))));
  return { factor, legend, couple: 5 / mostly(couples), impulse: LONGEST_ARROW / (Math.max(0, ...blows) || 1) };
}

/** The largest of some sizes, but for rare peaks. */
function mostly(sizes) {
  const sorted = sizes.filter(Number.isFinite).sort((a, b) => a - b), most = sorted[sorted.length - 1];
  return Math.min(most, 2.5 * sorted[Math.floor(0.9 * (sorted.length - 1))]) || most || 1;
}

// --- time

function seek(time) {
  state.time = Math.max(0, Math.min(time, longest()));
  state.motions.forEach((motion, k) => {
    if (motion.end.kind === "numbers") return byId("picture-" + k).replaceChildren();
    const moment = motion.at(state.time);
    state.drawings[k].show(moment);
    Object.assign(byId("picture-" + k).dataset, { phase: moment.phase, local: moment.local });
    state.readings[k].show(moment);
    byId("end-" + k).textContent = state.time >= motion.duration - 1e-9 ? ending(motion) : phaseName(motion, moment);
  });
  const slider = byId("time");
  slider.value = state.time;
  slider.setAttribute("aria-valuetext", clock());
  byId("clock").value = String(state.time);
  byId("clock").textContent = clock();
  state.seekers.forEach((update) => update());
  if (state.curves) state.curves.show(state.time);
  aboutShown();
  hear();
  decideAt(state.time);
}

const clock = () => shown(Math.round(state.time * 1e4) / 1e4) + "\u202fs";

function phaseName(motion, moment) {
  if (motion.unfit) return ending({ end: { ...motion.unfit, atOnce: true }, data: motion.data });
  if (motion.nudged) return told("nudged", { name: motion.data.coordinates[motion.nudged].here.text });
  const key = moment.data.name || moment.data.after ? "phase" : "phase_first", blow = motion.blow(moment.time);
  const before = motion.frames[0].phase, count = motion.code.length - before;
  const { after, name } = moment.data, met = after && (motion.data.unknowns[after.name] || { text: /^floor/.test(after.name) ? "N" : after.name }).text;
  const said = count > 1 || before ? told(key, { number: moment.phase + 1 - before, count, name: after ? told("stretch." + after.kind, { name: met }) : name }) : "";
  return blow ? said + ". " + struck(blow) : said;
}

/** What strikes, in words. */
function struck(blow) {
  const parts = blow.parts.map((one) => `${one.text} = ${shown(one.value)}\u202fN\u202fs`).join(", ");
  return told(blow.lost < 0 ? "struck_gained" : "struck", { parts, energy: shown(Math.abs(blow.lost)) });
}

/** What ended a motion, in words. */
function ending({ end, data }) {
  const name = end.name ? (data.unknowns[end.name] || (data.coordinates[end.name] || {}).here || { text: end.name }).text : "";
  return told("end." + end.kind + (end.atOnce ? "_at_once" : ""), { name, time: shown(end.time) });
}

/** A slider for each coordinate: it moves to the nearest moment at which the coordinate is there. */
function seekers() {
  state.seekers = [];
  byId("places").replaceChildren(...state.motions.flatMap((motion, k) => (motion.end.kind === "numbers" ? [] : Object.keys(motion.data.coordinates).map((name) => seeker(motion, k, name)))));
}

function seeker(motion, place, name) {
  const of = motion.data.coordinates[name], values = motion.frames.map((frame) => coordinate(motion, frame, name));
  const least = Math.min(...values), most = Math.max(...values), id = `place-${place}-${name}`;
  const input = element("input", { type: "range", id, min: least, max: most, step: (most - least) / 500 || 1 });
  const several = state.motions.length > 1 ? motion.data.title : "", wraps = comesBack(motion, name);
  input.setAttribute("aria-label", [of.here.spoken, of.meaning, several].filter(Boolean).join(", "));
  input.disabled = !(most - least > 1e-9);
  const reading = new Reading(`${place}.at.${name}`, of.unit, of.size);
  const update = () => {
    const moment = motion.at(state.time), value = moment.out[moment.data.coordinates[name]];
    if (document.activeElement !== input || state.playing) input.value = value;
    reading.set(value);
    if (wraps && value !== wrapped(value)) reading.node.textContent += ` (${shown(wrapped(value) / of.size)}° + ${Math.round(value / TURN)} · 360°)`;
    input.setAttribute("aria-valuetext", reading.node.textContent);
  };
  input.addEventListener("input", () => { pause(); seek(momentOf(motion, values, Number(input.value))); });
  state.seekers.push(update);
  const parts = [formula(of.here), " ", reading.node, several ? element("small", {}, " " + several) : ""];
  return element("div", { class: "slider", title: of.meaning }, [element("label", { for: id }, element("span", { class: "slider-name" }, parts)), input]);
}

function coordinate(motion, frame, name) {
  return motion.look(frame.phase, frame.y, frame.local)[motion.data.phases[frame.phase].coordinates[name]];
}

/** The moment nearest to now at which a coordinate passes a value. */
function momentOf(motion, values, wanted) {
  let best = state.time, least = Infinity;
  for (let k = 0; k + 1 < values.length; k++) {
    const [a, b] = [values[k], values[k + 1]], inside = (a - wanted) * (b - wanted) <= 0 && a !== b;
    if (!inside) continue;
    const [from, to] = [motion.frames[k].time, motion.frames[k + 1].time], time = from + ((wanted - a) / (b - a)) * (to - from);
    if (Math.abs(time - state.time) < least) [best, least] = [time, Math.abs(time - state.time)];
  }
  return best;
}

// --- playing

let before = 0;
function play() {
  if (state.time >= longest() - 1e-9) seek(0);
  state.playing = true;
  before = 0;
  mark();
  requestAnimationFrame(tick);
}

function pause() {
  if (!state.playing) return;
  state.playing = false;
  mark();
  say();
}

function tick(now) {
  if (!state.playing) return;
  const step = before ? ((now - before) / 1000) * Number(byId("speed").value) : 0;
  if (!calm.matches || step >= CALM * Number(byId("speed").value) || !before) {
    before = now;
    seek(state.time + step);
  }
  if (state.time >= longest() - 1e-9) { state.playing = false; mark(); say(); } else requestAnimationFrame(tick);
}

// --- the page around: it hears what happens and may set numbers, the time and whether it plays

function tells(event, keys = {}) {
  const own = Object.fromEntries([...NUMBERS].filter(([name, one]) => state.numbers[name] !== one.value).map(([name]) => [name, state.numbers[name]]));
  if (window.parent !== window) window.parent.postMessage({ rbpsym: 1, event, time: state.time, numbers: { ...state.numbers }, own, ...keys }, "*");
}

window.addEventListener("message", ({ data, source }) => {
  if (source !== window.parent || !data || data.rbpsym !== 1 || data.do !== "set") return;
  for (const [name, value] of Object.entries(data.numbers || {})) if (NUMBERS.has(name) && Number.isFinite(value)) state.numbers[name] = value;
  if (data.numbers) { sliders(); rebuild(); }
  if (Number.isFinite(data.time)) seek(data.time);
  if (data.play !== undefined && data.play !== state.playing) (data.play ? play : pause)();
});

function mark() {
  byId("play").textContent = state.playing ? WORDS.pause : WORDS.play;
  byId("play").dataset.playing = state.playing;
  tells(state.playing ? "plays" : "rests");
}

/** The state in a sentence, for those who do not see it. */
function say() {
  const parts = state.motions.map((motion, k) => {
    const moment = motion.at(state.time);
    const places = Object.entries(motion.data.coordinates).map(([name, c]) => `${c.here.text} = ${shown(moment.out[moment.data.coordinates[name]] / c.size)}${c.unit === "°" ? "°" : " " + c.unit}`);
    return [state.motions.length > 1 ? motion.data.title + ": " : "", places.join(", "), ". ", byId("end-" + k).textContent].join("");
  });
  const vanishing = layers.has("moment") ? [about.told.textContent] : [];
  byId("status").textContent = [told("now", { time: clock() }), ...parts, ...vanishing].join(" ");
}

function restart() { pause(); seek(0); say(); }

function reset() {
  for (const [name, one] of NUMBERS) state.numbers[name] = one.value;
  state.change = { ...AS_STATED, off: new Set() };
  releaseBoxes();
  sliders();
  rebuild();
  restart();
  tells("changed", { name: "reset" });
}

byId("play").addEventListener("click", () => (state.playing ? pause() : play()));
byId("restart").addEventListener("click", restart);
byId("reset").addEventListener("click", reset);
byId("time").addEventListener("input", (event) => { pause(); seek(Number(event.target.value)); });
byId("time").addEventListener("change", say);
byId("question").addEventListener("change", offers);
byId("release").addEventListener("click", release);
byId("predict").addEventListener("toggle", () => predicting(byId("predict").open));
byId("curves-kind").addEventListener("change", () => { curves(); seek(state.time); });
byId("line-of").addEventListener("change", (event) => { state.change.force = event.target.value; aside(0); });
byId("line-aside").addEventListener("input", (event) => { pause(); aside(Number(event.target.value)); });
const seeking = (event) => { const box = byId("curves").getBoundingClientRect(); if (state.curves && event.buttons) { pause(); seek(state.curves.timeAt(((event.clientX - box.left) / box.width) * WIDE, ((event.clientY - box.top) / box.height) * HIGH)); } };
byId("curves").addEventListener("pointerdown", seeking);
byId("curves").addEventListener("pointermove", seeking);
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT|BUTTON|SUMMARY|A)$/.test(event.target.tagName)) return;
  const keys = { " ": () => (state.playing ? pause() : play()), ArrowRight: () => nudge(0.02), ArrowLeft: () => nudge(-0.02), Home: restart };
  if (keys[event.key]) { event.preventDefault(); keys[event.key](); }
});

function nudge(step) { pause(); seek(state.time + step); say(); }

mark();
begin();
tells("moving");
