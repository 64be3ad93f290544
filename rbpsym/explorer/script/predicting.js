// A prediction before the motion: one of what the derivation knows to be possible is chosen, then the motion decides.

const prediction = { asked: null, chosen: null };

/** [{words, choices: [[key, words]], truth, until}]: how a coordinate sets out; what ends the first phase. */
function questionsOf(motion) {
  if (!motion || motion.end.kind === "numbers") return [];
  const found = motion.nudged || motion.unfit ? [] : Object.keys(motion.data.coordinates).map((name) => setsOut(motion, name)).filter(Boolean);
  return [...found, ...endsWith(motion)];
}

function setsOut(motion, name) {
  const values = motion.frames.filter((frame) => frame.phase === 0).map((frame) => coordinate(motion, frame, name));
  const most = Math.max(...values.map((value) => Math.abs(value - values[0]))), place = values.findIndex((value) => Math.abs(value - values[0]) > 1e-3 * most);
  const truth = most < 1e-9 ? "stays" : values[place] > values[0] ? "grows" : "falls", { here, meaning } = motion.data.coordinates[name];
  return { words: told("predict.sets_out", { name: `${here.text}${meaning ? ` (${meaning})` : ""}` }), choices: ["grows", "falls", "stays"].map((key) => [key, WORDS[key]]), truth, until: motion.duration / 3 };
}

function endsWith(motion) {
  const data = motion.data.phases[0], goesOn = motion.frames.some((frame) => frame.phase > 0), key = (kind, name) => `${kind} ${name}`;
  const ended = goesOn ? data.endedBy || data.endsWith[0] : [motion.end.kind, motion.end.name], is = ended && data.events.some((one) => one.kind === ended[0] && one.name === ended[1]);
  const known = data.events.filter((one) => `end.${one.kind}` in WORDS && one.kind !== "meets");
  if (motion.unfit || !known.length || (goesOn && !is) || (is && !known.some((one) => one.kind === ended[0]))) return [];
  const choices = new Map(known.map((one) => [key(one.kind, one.name), ending({ end: { ...one, time: 0 }, data: motion.data }).split(". ")[0].replace(/\.?$/, ".")]));
  return [{ words: WORDS["predict.ends"], choices: [...choices, ["none", WORDS.goes_on]], truth: is ? key(...ended) : "none", until: motion.frames.findLast((frame) => frame.phase === 0).time }];
}

/** The questions of the motion as it is now. */
function asks() {
  prediction.asked = prediction.chosen = null;
  prediction.all = questionsOf(state.motions[0]);
  const menu = byId("question"), before = menu.value;
  byId("predict").hidden = !prediction.all.length;
  menu.replaceChildren(...prediction.all.map((one, k) => element("option", { value: k }, one.words)));
  if (prediction.all[before]) menu.value = before;
  offers();
}

function offers() {
  const asked = prediction.all[byId("question").value];
  byId("release").disabled = true;
  byId("outcome").textContent = "";
  byId("choices").replaceChildren(...(asked ? asked.choices : []).map(([key, words]) => {
    const input = element("input", { type: "radio", name: "choice", value: key });
    input.addEventListener("change", () => { prediction.chosen = key; byId("release").disabled = false; });
    return element("label", { class: "layer" }, [input, " " + words]);
  }));
}

/** While one predicts, what would tell it is hidden. */
function predicting(is) {
  document.documentElement.dataset.predicting = is ? "yes" : "";
  if (is) { restart(); offers(); }
}

function release() {
  predicting(true);
  prediction.asked = prediction.all[byId("question").value];
  play();
}

/** What the motion says, once it has come so far. */
function decideAt(time) {
  const { asked, chosen } = prediction;
  if (!asked || time < asked.until - 1e-9) return;
  prediction.asked = null;
  const words = new Map(asked.choices), right = chosen === asked.truth;
  byId("outcome").textContent = told(right ? "predicted_right" : "predicted_wrong", { chosen: words.get(chosen), truth: words.get(asked.truth) });
  document.documentElement.dataset.predicting = "";
  tells("predicted", { question: asked.words, chosen, right });
}
