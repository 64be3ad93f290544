// A point about which torques are taken: it is dragged, and one sees which vanish (where a line of action passes through it).

const CATCH = 9, HARDLY_ANY = 1e-6, STEPS = 200;
const about = { at: null };

/** [{force, torque, line}] of the forces that act at a moment; `line` [a place on it, its way], null of a couple. */
function torques({ data, out }, [x, y]) {
  return data.forces.map((force) => {
    const at = pick(force.at, out), way = pick(force.vector, out), couple = out[force.couple] || 0, size = Math.hypot(...way);
    const torque = (at[0] - x) * way[1] - (at[1] - y) * way[0] + couple, arm = Math.hypot(at[0] - x, at[1] - y) + 1;
    return { force, torque, acts: size + Math.abs(couple) > 1e-9, vanishes: Math.abs(torque) < HARDLY_ANY * (size * arm + Math.abs(couple)), line: couple ? null : [at, way] };
  }).filter((one) => one.acts);
}

/** Where two lines of action meet, or a force acts: there the point is caught when it comes near. */
function catching(moment) {
  const lines = torques(moment, [0, 0]).map((one) => one.line).filter(Boolean), found = lines.map(([at]) => at);
  lines.forEach(([[x, y], [u, v]], k) => lines.slice(k + 1).forEach(([[p, q], [r, s]]) => {
    const turn = u * s - v * r, share = ((p - x) * s - (q - y) * r) / turn;
    if (Math.abs(turn) > 1e-9 * Math.hypot(u, v) * Math.hypot(r, s)) found.unshift([x + share * u, y + share * v]);
  }));
  return found;
}

function moveAbout(goal, place) {
  const { scale } = state.drawings[place], far = (point) => Math.hypot(point[0] - goal[0], point[1] - goal[1]) * scale.factor;
  about.at = catching(state.motions[place].at(state.time)).find((point) => far(point) < CATCH) || goal;
  seek(state.time);
}

/** The mark in the picture, and the lines of action that pass through it. */
function marked(drawing, moment) {
  if (!layers.has("moment")) return [];
  const [x, y] = drawing.scale.point(about.at), reach = 2 * ROOM;
  const lines = torques(moment, about.at).filter((one) => one.vanishes && one.line).map(({ line: [at, way] }) => {
    const [p, q] = drawing.scale.point(at), size = Math.hypot(...way), [u, v] = [(way[0] / size) * reach, (-way[1] / size) * reach];
    return make("path", { class: "action", d: path([[p - u, q - v], [p + u, q + v]]) });
  });
  return [...lines, make("circle", { class: "about", cx: fixed(x), cy: fixed(y), r: 8 }), make("path", { class: "about", d: path([[x - 12, y], [x + 12, y]]) + path([[x, y - 12], [x, y + 12]]) })];
}

/** The table beside it, and a slider for each of its coordinates, for those who do not drag. */
function aboutTable() {
  const holder = byId("moments");
  holder.hidden = !layers.has("moment");
  about.readings = [];
  if (holder.hidden) return holder.replaceChildren();
  about.at = about.at || pick(state.motions[0].data.phases[0].bodies[0].cm, state.motions[0].at(0).out);
  const fine = state.motions.filter((motion) => motion.end.kind !== "numbers"), whole = fine.map(boxOfMotion).reduce(joinBoxes);
  const rows = fine.flatMap((motion, k) => [...new Set(motion.data.phases.flatMap((phase) => phase.forces.map(keyOf)))].map((key) => {
    const reading = new Reading(`${k}.tau.${key}`, "", 1), of = motion.data.forces[key];
    about.readings.push({ motion, key, reading, text: of.text });
    return [element("span", {}, [formula(of), of.on ? element("small", {}, " " + of.on) : ""]), reading.node];
  }));
  const sliders = [0, 1].map((axis) => {
    const input = element("input", { type: "range", id: "about-" + axis, min: whole[axis], max: whole[axis + 2], step: (whole[axis + 2] - whole[axis]) / STEPS || 1 });
    input.addEventListener("input", () => { about.at = about.at.with(axis, Number(input.value)); seek(state.time); });
    return element("div", { class: "slider" }, [element("label", { for: input.id }, WORDS["point." + "xy"[axis]]), input]);
  });
  about.told = element("p", {});
  holder.replaceChildren(tableOf(WORDS.torques, [WORDS.force, WORDS.size], rows), about.told, element("div", { class: "sliders" }, sliders));
}

function aboutShown() {
  if (!layers.has("moment")) return;
  const gone = [];
  for (const { motion, key, reading, text } of about.readings) {
    const of = torques(motion.at(state.time), about.at).filter((one) => keyOf(one.force) === key), sum = of.reduce((all, one) => all + one.torque, 0);
    reading.set(of.length ? sum : NaN);
    if (of.length && of.every((one) => one.vanishes)) gone.push(text);
  }
  [0, 1].forEach((axis) => { const input = byId("about-" + axis); if (document.activeElement !== input) input.value = about.at[axis]; input.setAttribute("aria-valuetext", shown(about.at[axis]) + " m"); });
  about.told.textContent = gone.length ? told("vanish", { names: gone.join(", ") }) : WORDS.vanish_none;
}
