// The page: the statement at the left, what follows from it at the right, as one types; first what is known at once.
import { Engine, Fault } from "./engine.js";
import { editor, put, tell, undone } from "./editor.js";
import { address, forExplorer, packed, unpacked, wanted, withNumbers } from "./link.js";
import { frameOf, listens, tells } from "./embed.js";
import { Form, questionsIn } from "./form.js";
import { read } from "./records.js";
import { shelf } from "./shelf.js";
import { Tutor } from "./tutor.js";
import { WORDS, dress, say, speak } from "./words.js";

const $ = (id) => document.getElementById(id);
const el = (tag, props = {}, ...inner) => { const one = Object.assign(document.createElement(tag), props); one.append(...inner); return one; };
const PAUSE = 120, PATIENCE = 4000; // ms after the last key; until a derivation that is outdated, or in the way, is ended
const TABS = ["notes", "answers", "explorer", "export", "check", "tutor"];
const FIRST = "sliding-ladder";
const NOTES = { pdf: "PDF", html: "HTML", tex: "LaTeX", md: "Markdown", ipynb: "Notebook", typ: "Typst" };
const SHEETS = { pdf: "PDF", html: "HTML", tex: "LaTeX", moodle: "Moodle", qti: "QTI", canvas: "Canvas", prairielearn: "PrairieLearn", gift: "GIFT" };

let tables = null, text = "", timer = 0, turn = 0, running = 0, tab = "notes", done = {}, glance = null;
// what tests and measurements read: ms from the last key to the first sight and to the notes, and of work in the engine
const marks = (window.studio = { began: performance.now(), times: [], glances: [], work: [] });

const engine = new Engine(new URL("./WORKER", import.meta.url), (told) => {
  if (told.worked !== undefined) return marks.work.push(told.worked);
  Object.assign((marks.boot ??= {}), told);
  if (told.broken) status(say("broken", { why: told.broken }));
});
const view = editor($("editor"), (now) => { text = now; clearTimeout(timer); timer = setTimeout(refresh, PAUSE); if (!$("form").hidden) form.show(text); }, () => tables);
const form = new Form($("form"), el, () => tables, (now) => { put(view, now); clearTimeout(timer); refresh(); });
const tutor = new Tutor(work, el, tells);

function status(words) { $("status").textContent = words; }

/** An answer of the engine. Proofs that take long wait for what else is asked: they are begun anew after it. */
async function work(name, keys, passing = false) {
  const waits = name !== "notes" && engine.lasts("notes") > PATIENCE;
  if (waits) engine.stop();
  running++;
  $("stop").hidden = false;
  try { return await engine.ask(name, keys, passing); } finally {
    if (!--running) $("stop").hidden = true;
    if (waits) noted(turn, performance.now()).catch(wrong);
  }
}

const asked = () => ({ text, language: $("language").value });

// --- what follows: the drawing and the motion at once, then what the open tab shows, then the proofs

async function refresh() {
  const mine = ++turn, began = performance.now(), spent = () => Math.round(performance.now() - began);
  if (!text.trim()) return;
  status(say("deriving"));
  const late = engine.drop() && setTimeout(() => { if (mine === turn) engine.stop(); }, PATIENCE);
  try {
    const found = await work("glance", asked(), true);
    if (mine !== turn) return;
    clearTimeout(late);
    done = {};
    wrong(null);
    glanced(found);
    marks.glances.push(spent());
    history.replaceState(null, "", address({ p: await packed(text), n: null, lang: $("language").value, detail: $("detail").value }));
    await Promise.all([tab === "notes" ? null : fill(), noted(mine, began)]);
  } catch (error) {
    if (mine === turn) wrong(error);
  } finally { clearTimeout(late); }
}

function glanced(found) {
  glance = found;
  document.title = `${found.title} – rbpsym studio`;
  $("figure").innerHTML = found.figure;
  $("figure").ariaLabel = found.alt;
  $("figure").hidden = !found.figure;
  $("motion").innerHTML = [...found.motion, ...found.forces].map((one) => `<p>${one}</p>`).join("");
  $("glance").hidden = !(found.figure || found.motion.length);
  document.body.classList.remove("stale");
}

async function noted(mine, began) {
  $("notes").classList.add("old");
  const long = setTimeout(() => mine === turn && status(say("long")), PATIENCE);
  const found = await work("notes", { ...asked(), detail: $("detail").value }, true).finally(() => clearTimeout(long));
  if (mine !== turn) return;
  show($("notes"), found.html);
  tutor.task(glance.figure, new DOMParser().parseFromString(found.html, "text/html"));
  $("notes").classList.remove("old");
  const { proved, steps } = found.summary, ms = Math.round(performance.now() - began);
  status(say("proved", { proved, steps, seconds: (ms / 1000).toFixed(1) }));
  marks.times.push(ms);
  marks.notes ??= performance.now();
  done.notes = true;
  tells("derived", { title: found.title, text, proved, steps });
}

function wrong(fault) {
  if (fault && !(fault instanceof Fault)) throw fault;
  if (fault && /^(outdated|stopped)$/.test(fault.message)) return;
  const error = fault?.error;
  tell(view, error);
  form.tell(error);
  $("fault").textContent = error ? error.told || error.what : "";
  $("fault").classList.toggle("bad", Boolean(error));
  document.body.classList.toggle("stale", Boolean(error));
  if (!error) return;
  status(error.line ? say("line", error) : error.what);
  marks.faults = (marks.faults ?? 0) + 1;
  tells("fault", { what: error.what, instead: error.instead, line: error.line });
}

// A page in a frame: its body is put in the place of the one before, so that one stays where one reads.
function show(frame, html) {
  const inner = frame.contentDocument;
  if (!frame.srcdoc) {
    frame.srcdoc = html;
    frame.onload = () => frame.contentDocument.addEventListener("click", follow);
    return;
  }
  const next = new DOMParser().parseFromString(html, "text/html");
  inner.documentElement.lang = next.documentElement.lang;
  inner.body.replaceWith(inner.adoptNode(next.body));
}

function follow(event) {
  const link = event.target.closest?.("a[href]");
  if (!link) return;
  event.preventDefault();
  const goal = link.getAttribute("href");
  if (goal.startsWith("#")) link.ownerDocument.getElementById(goal.slice(1))?.scrollIntoView({ block: "center" });
  else open(link.href, "_blank", "noopener");
}

const FILL = {
  async answers() {
    const found = await work("answers", { text }, true);
    const figure = el("div", { className: "scenes", role: "img", ariaLabel: glance.alt, innerHTML: glance.figure }), list = found.map(answered);
    $("questions").replaceChildren(...questionsIn(text, tables).map((value) => el("option", { value })));
    $("answers").replaceChildren(...(glance.figure ? [figure] : []), ...(list.length ? list : [el("p", { textContent: say("asksnothing") })]));
    if ($("told").firstChild) await ask(); // the answer to what was asked of the statement before
  },
  async explorer() {
    const none = $("explorer-none");
    try {
      const { html } = await work("explorer", { ...asked(), beside: wanted().get("beside") ?? "" }, true);
      none.hidden = true;
      framed("explorer", html, forExplorer());
    } catch (error) {
      if (error.message === "outdated") throw error;
      $("explorer").hidden = true; none.hidden = false;
      none.textContent = error.error.what + (error.error.instead ? " " + error.error.instead : "");
    }
  },
  async tutor() { await tutor.open(text, glance.title); },
};

/** A page with scripts of its own, in a frame that holds nothing else. */
function framed(id, html, hash = "") {
  const old = $(id), frame = old.cloneNode();
  frame.hidden = false;
  frame.onload = () => { frame.onload = null; frame.contentWindow.postMessage(html, "*"); };
  frame.src = "./frame.html#" + hash;
  old.replaceWith(frame);
}

const answered = (one) => el("section", {}, el("h2", { textContent: one.question }), ...said(one));

/** A question that is asked beside the statement; it may be put into it. */
async function ask(event) {
  event?.preventDefault();
  const question = $("asked").value.trim();
  if (!question) return;
  $("told").textContent = say("deriving");
  try {
    const [found] = await work("answers", { text, questions: [question] });
    $("told").replaceChildren(answered(found));
    $("keep").hidden = !found.verdict;
    $("keep").onclick = () => { $("keep").hidden = true; $("told").replaceChildren(); put(view, `${text.trimEnd()}\n\n[[ask]]\nquestion = ${JSON.stringify(question)}\n`); };
  } catch (error) { $("told").textContent = error.error?.what ?? String(error); }
}

function said(one) {
  const shown = one.shown.map((math) => el("p", { innerHTML: (one.verdict === "PROVED" ? "✓ " : "? ") + math }));
  const where = one.where.length ? [el("p", { innerHTML: say("where") + " " + one.where.join(", ") })] : [];
  return [...shown, ...(one.says ? [el("p", { textContent: one.says })] : []), ...where];
}

async function fill() {
  const name = tab;
  if (done[name] || !FILL[name] || !glance || document.body.classList.contains("stale")) return;
  done[name] = true;
  try { await FILL[name](); } catch (error) { done[name] = false; wrong(error); }
}

function choose(name, focus) {
  tab = name;
  for (const key of TABS) {
    const button = $("tab-" + key), is = key === name;
    button.setAttribute("aria-selected", is);
    button.tabIndex = is ? 0 : -1;
    $("panel-" + key).hidden = !is;
    document.body.dataset.tab = name;
    if (is && focus) button.focus();
  }
  history.replaceState(null, "", address({ tab: name === "notes" ? null : name }));
  return fill();
}

function moved(event) {
  const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  if (step) choose(TABS[(TABS.indexOf(tab) + step + TABS.length) % TABS.length], true);
}

// --- export and check

function save(name, content, is64) {
  const data = is64 ? Uint8Array.from(atob(content), (c) => c.charCodeAt(0)) : content;
  const link = el("a", { href: URL.createObjectURL(new Blob([data])), download: name.replaceAll("/", "-") });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** What PDF is made of, in a worker that is begun when one is first asked for. */
let typst = null, papers = 0;
function pdf(source) {
  typst ??= new Worker(new URL("./TYPST", import.meta.url), { type: "module" });
  const id = ++papers;
  return new Promise((resolve, reject) => {
    const hear = ({ data }) => { if (data.id !== id) return; typst.removeEventListener("message", hear); if (data.pdf) resolve(data.pdf); else reject(new Error(data.error)); };
    typst.addEventListener("message", hear);
    typst.addEventListener("error", () => { typst = null; reject(new Error(say("nopdf"))); }, { once: true });
    typst.postMessage({ id, source });
  });
}

/** Files are called as the problem is; what is more than two files comes as one archive. */
async function exported(name, keys) {
  $("exported").textContent = say("writing");
  const title = glance?.title.normalize("NFD").toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "") || "problem", isPdf = keys.format === "pdf";
  try {
    const { files, left_out } = await work(name, { ...asked(), ...keys, format: isPdf ? "typ" : keys.format, packed: !isPdf });
    for (const file of files) {
      file.name = file.name.replace("problem", title);
      if (isPdf) Object.assign(file, { name: file.name.replace(/typ$/, "pdf"), content: await pdf(file.content) });
      save(file.name, file.content, file.base64);
    }
    $("exported").textContent = [say("saved", { files: files.map((file) => file.name).join(", ") }), ...left_out].join(" ");
  } catch (error) { $("exported").textContent = error.error?.told ?? error.message; }
}

async function decided() {
  const box = $("decided");
  try {
    const found = await work("check", { text, paper: $("paper").value });
    const head = el("tr", {}, ...["line", "formula", "verdict", "why"].map((word) => el("th", { scope: "col", textContent: say("col." + word) })));
    const rows = found.map((one) => el("tr", {}, ...[one.line, one.latex, one.outcome, one.detail + (one.fix ? say("write", one) : "")]
      .map((cell, k) => el("td", { textContent: cell, className: k === 2 ? { PROVED: "good", REFUTED: "bad" }[cell] ?? "" : "" }))));
    box.replaceChildren(found.length ? el("table", {}, head, ...rows) : say("noformula"));
  } catch (error) { box.textContent = error.error?.told ?? String(error); }
}

// --- beginning

async function opened() {
  const keys = wanted();
  if (keys.get("p")) try { return put(view, await unpacked(keys.get("p"))); } catch { status(say("badlink")); }
  await started(keys.get("n") || FIRST);
}

async function started(name) {
  try { put(view, (await engine.ask("statement", { name })).text); } catch (error) { wrong(error); if (name !== FIRST) await started(FIRST); }
}

/** Another problem: the explorer's numbers were those of the one before. */
function opening(name) {
  history.replaceState(null, "", withNumbers({}));
  return started(name);
}

function buttons(parent, formats, write) {
  $(parent).append(...Object.entries(formats).map(([format, label]) => el("button", { type: "button", textContent: label, onclick: () => write(format) })));
}

async function copied(content, words = "copied") {
  try { await navigator.clipboard.writeText(content); status(say(words)); } catch { status(content); }
}

function asForm(is) {
  $("form").hidden = !is;
  $("editor").hidden = is;
  $("asform").setAttribute("aria-pressed", is);
  $("astext").setAttribute("aria-pressed", !is);
  if (is) form.show(text);
  try { localStorage.setItem("studio form", is ? "yes" : ""); } catch { /* a browser that keeps nothing */ }
}

function dressed() {
  speak($("language").value);
  document.documentElement.lang = $("language").value;
  dress();
}

const keys = wanted(), only = keys.get("only");
$("language").append(...Object.entries(WORDS).map(([code, { own }]) => new Option(own, code)));
$("language").value = [keys.get("lang"), navigator.language.split("-")[0], "en"].find((code) => code in WORDS);
if (keys.get("detail")) $("detail").value = keys.get("detail");
if (only) document.body.classList.add("only");
$("tabs").append(...TABS.map((key) => {
  const button = el("button", { id: "tab-" + key, type: "button", role: "tab", onclick: () => choose(key) });
  button.dataset.w = key;
  button.setAttribute("aria-controls", "panel-" + key);
  return button;
}));
$("tabs").addEventListener("keydown", moved);
dressed();
status(say("starting"));
choose(TABS.find((one) => one === (only ?? keys.get("tab"))) ?? "notes");
buttons("formats", NOTES, (format) => exported("export", { format, detail: $("detail").value }));
buttons("sheets", SHEETS, (format) => exported("worksheet", { format, seed: $("seed").value }));
$("save").onclick = () => save("problem.toml", text);
$("decide").onclick = decided;
$("record").onclick = async () => { const found = await tutor.record(); save(`${found.student || "record"}.json`, JSON.stringify(found, null, 2)); };
$("detail").onchange = refresh;
$("language").onchange = () => { dressed(); stocked(); refresh(); };
$("stop").onclick = () => engine.stop();
$("asform").onclick = () => asForm(true);
$("astext").onclick = () => asForm(false);
$("link").onclick = async () => copied(address({ p: await packed(text), only: null }));
$("embed").onclick = async () => copied(frameOf(address({ p: await packed(text), only: tab, tab: null }), document.title), "embed.copied");
$("whole").onclick = () => $("whole").setAttribute("aria-pressed", document.body.classList.toggle("whole"));
$("ask").onsubmit = ask;
$("files").onchange = async () => $("records").replaceChildren(await read($("files").files, work, el));
$("look").onclick = async () => {
  try { framed("sheet", (await work("worksheet", { ...asked(), format: "html", seed: $("seed").value })).files[0].content); } catch (error) { $("exported").textContent = error.error?.told ?? String(error); }
};
$("beside").onchange = () => { history.replaceState(null, "", address({ beside: $("beside").value || null })); done.explorer = false; fill(); };
$("undo").onclick = () => undone(view);
try { if (localStorage.getItem("studio form")) asForm(true); } catch { /* the same */ }
addEventListener("hashchange", opened);
listens({
  open: ({ text: given, name }) => (name ? started(name) : put(view, given)),
  show: ({ tab: name }) => TABS.includes(name) && choose(name),
  ask: ({ request: { do: name, ...rest } }) => work(name, { text, ...rest }),
  set: (data) => $("explorer").contentWindow.postMessage(data, "*"),
  state: async () => ({ text, tab, link: address({ p: await packed(text) }) }),
}, () => $("explorer"), ({ own }) => own && history.replaceState(null, "", withNumbers(own)));

opened();
const stock = fetch(new URL("./STOCK", import.meta.url)).then((found) => found.json());
const shelved = shelf(el, (name) => engine.ask("picture", { name, language: $("language").value }, true), opening, (fresh) => put(view, fresh));
/** The problems that ship, on the shelf and to be put beside this one; what can be written where, for editor and form. */
async function stocked() {
  const { completions, gallery } = await stock, cards = gallery[$("language").value], others = $("beside"), beside = wanted().get("beside") ?? "";
  tables = completions;
  if (!$("form").hidden) form.show(text);
  shelved(cards);
  others.replaceChildren(others.options[0], ...[...new Set(cards.map((card) => card.topic))].map((topic) => el("optgroup", { label: topic },
    ...cards.filter((card) => card.topic === topic).map((card) => el("option", { value: card.name, textContent: card.title, selected: card.name === beside })))));
}
stocked();
tells("ready");
if ("serviceWorker" in navigator) navigator.serviceWorker.register("./sw.js").then(() => navigator.serviceWorker.ready).then(() => { marks.kept = performance.now(); }).catch(() => { /* a frame may not keep the page */ });
