// What a reader changes of the system itself: what is held is let go; the line of action of a force is moved, and its torque with it.

const isChanged = () => state.change.off.size > 0 || state.change.aside !== 0;

/** [name, words] of what holds the bodies of the models, and of the forces whose line can be moved. */
function held() {
  const found = new Map();
  for (const { data, loose } of MODELS) for (const one of loose.length ? loose[0].data.loose.conditions : []) if (!found.has(keyed(one))) found.set(keyed(one), told(one.turns ? "turns" : "holds", { name: (data.unknowns[one.of] || { math: one.of }).math }));
  return [...found];
}

const movable = (data) => data.phases[0].forces.filter((force) => !force.unknown && data.forces[keyOf(force)] && !data.forces[keyOf(force)].couple);

function releaseBoxes() {
  const names = held(), forces = new Map(MODELS.flatMap(({ data, loose }) => (loose.length ? movable(data).map((force) => [keyOf(force), data.forces[keyOf(force)]]) : [])));
  byId("loose").hidden = !names.length && !forces.size;
  byId("holds").replaceChildren(...names.map(([name, words]) => {
    const box = element("input", { type: "checkbox", "data-holds": name });
    box.checked = !state.change.off.has(name);
    box.addEventListener("change", () => { state.change.off[box.checked ? "delete" : "add"](name); changed(); });
    return element("label", { class: "layer" }, [box, " ", Object.assign(element("span", {}), { innerHTML: words })]);
  }));
  byId("line-of").replaceChildren(element("option", { value: "" }, WORDS.line_none), ...[...forces].map(([key, of]) => element("option", { value: key }, of.text + (of.on ? " · " + of.on : ""))));
  byId("line-of").value = state.change.force;
  byId("line-box").hidden = !forces.size;
}

function changed() { pause(); rebuild(); seek(0); tells("changed", { name: "system" }); }

/** The line of action at a distance from where it is stated, to the left of the force. */
function aside(distance, now = true) {
  state.change.aside = state.change.force ? distance : 0;
  if (now) { soon(); if (state.time) seek(0); }
}

/** The slider fits the size of the system; what it says, too. */
function lineShown() {
  const motion = state.motions[0], input = byId("line-aside"), size = motion.end.kind === "numbers" ? 1 : extentOf(motion, motion.frames[0]) / 2;
  Object.assign(input, { min: -size, max: size, step: size / 100, disabled: !state.change.force });
  input.value = state.change.aside;
  input.setAttribute("aria-valuetext", shown(state.change.aside) + " m");
  const [key, on] = [state.change.force, state.change.force.split("@")[1]], stated = state.change.aside && new Motion(MODELS[0], numbersOf(MODELS[0]), { ...state.change, aside: 0 });
  byId("line-told").textContent = !key || !state.change.aside || !stated ? "" : told(sameCentre(motion, stated, on) ? "line_same" : "line_other", { body: motion.data.bodies[on] });
}

/** Does the centre of mass of a body set out in both motions alike? */
function sameCentre(one, other, name) {
  const [a, b] = [one, other].map((motion) => { const moment = motion.at(0); return rushes(motion, moment, moment.data.bodies.find((body) => body.name === name).cm)[1]; });
  return Math.hypot(a[0] - b[0], a[1] - b[1]) < 1e-4 * (Math.hypot(...a) + Math.hypot(...b));
}

/** The handle of the force whose line is moved, in a picture. */
function lineHandle(place, away) {
  const { force } = state.change, motion = state.motions[place], moment = motion.at(state.time), own = moment.data.forces.find((one) => keyOf(one) === force);
  if (!own || away(pick(own.at, moment.out)) > REACH) return null;
  return (point) => {
    const now = motion.at(0), mine = now.data.forces.find((one) => keyOf(one) === force), [x, y] = pick(mine.at, now.out), [u, v] = pick(mine.vector, now.out), size = Math.hypot(u, v) || 1;
    aside(motion.change.aside + (-v * (point[0] - x) + u * (point[1] - y)) / size);
  };
}
