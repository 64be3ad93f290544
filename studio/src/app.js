// The page: the statement at the left, what follows from it at the right, as one types.
import { Engine, Fault } from "./engine.js";
import { editor, put, tell } from "./editor.js";
import { packed, unpacked } from "./link.js";

const $ = (id) => document.getElementById(id);
const el = (tag, props = {}, ...inner) => { const one = Object.assign(document.createElement(tag), props); one.append(...inner); return one; };
const PAUSE = 150, PATIENCE = 4000; // ms after the last key; until an outdated derivation is ended
const TABS = { notes: "Notes", answers: "Drawing & answers", explorer: "Explorer", export: "Export", check: "Check a text", tutor: "Tutor" };
const FIRST = "sliding-ladder";
const NOTES = { html: "HTML", tex: "LaTeX", md: "Markdown", ipynb: "Notebook", typ: "Typst" };
const SHEETS = { html: "HTML", tex: "LaTeX", moodle: "Moodle", qti: "QTI", canvas: "Canvas", prairielearn: "PrairieLearn", gift: "GIFT" };

let tables = null, text = "", timer = 0, turn = 0, running = 0, tab = "notes", done = {}, notesPage = "";
const marks = (window.studio = { began: performance.now(), times: [] }); // what tests and measurements read

const engine = new Engine(new URL("./WORKER", import.meta.url), (told) => {
  Object.assign((marks.boot ??= {}), told);
  if (told.broken) status("The engine can't be started: " + told.broken);
});
const view = editor($("editor"), (now) => { text = now; clearTimeout(timer); timer = setTimeout(refresh, PAUSE); }, () => tables);

function status(words) { $("status").textContent = words; }

async function work(name, keys) {
  running++;
  $("stop").hidden = false;
  try { return await engine.ask(name, keys); } finally { if (!--running) $("stop").hidden = true; }
}

const asked = () => ({ text, language: $("language").value });

// --- notes, and what the open tab shows

async function refresh() {
  const mine = ++turn, began = performance.now();
  if (!text.trim()) return;
  status("Deriving …");
  const late = running && setTimeout(() => { if (mine === turn && running > 1) engine.stop(); }, PATIENCE);
  try {
    const found = await work("notes", { ...asked(), detail: $("detail").value });
    if (mine !== turn) return;
    done = {};
    notesPage = found.html;
    show($("notes"), found.html);
    document.title = `${found.title} – rbpsym studio`;
    wrong(null);
    const { proved, steps } = found.summary, seconds = ((performance.now() - began) / 1000).toFixed(1);
    status(`${proved} of ${steps} steps proved, ${seconds} s`);
    marks.times.push(Math.round(performance.now() - began));
    marks.notes ??= performance.now();
    document.body.classList.remove("stale");
    history.replaceState(null, "", "#p=" + await packed(text));
    await fill();
  } catch (error) {
    if (mine === turn) wrong(error);
  } finally { clearTimeout(late); }
}

function wrong(fault) {
  if (fault && !(fault instanceof Fault)) throw fault;
  const error = fault?.error;
  tell(view, error);
  $("fault").textContent = error ? error.told || error.what : "";
  $("fault").classList.toggle("bad", Boolean(error));
  document.body.classList.toggle("stale", Boolean(error));
  if (error) status(error.line ? `Line ${error.line}: ${error.what}` : error.what);
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
    const found = await work("answers", asked());
    const page = new DOMParser().parseFromString(notesPage, "text/html");
    const figure = el("figure", {}, el("div", { className: "scenes", role: "img", ariaLabel: found.alt, innerHTML: found.figure }));
    const list = found.answers.map((one) => el("section", {}, el("h2", { textContent: one.question }), ...said(one)));
    page.body.replaceChildren(el("main", {}, el("h1", { textContent: "Drawing and answers" }), ...(found.figure ? [figure] : []),
      ...(list.length ? list : [el("p", { textContent: "The statement asks nothing; add [[ask]] with a question." })])));
    show($("answers"), page.documentElement.outerHTML);
  },
  async explorer() {
    const frame = $("explorer"), none = $("explorer-none");
    try {
      const { html } = await work("explorer", asked());
      frame.hidden = !(none.hidden = true);
      frame.hidden = false;
      frame.onload = () => { frame.onload = null; frame.contentWindow.postMessage(html, "*"); };
      frame.src = "./frame.html";
    } catch (error) {
      frame.hidden = true; none.hidden = false;
      none.textContent = error.error.what + (error.error.instead ? " " + error.error.instead : "");
    }
  },
};

function said(one) {
  const shown = one.shown.map((math) => el("p", { innerHTML: (one.verdict === "PROVED" ? "✓ " : "? ") + math }));
  const where = one.where.length ? [el("p", { innerHTML: "where " + one.where.join(", ") })] : [];
  return [...shown, ...(one.says ? [el("p", { textContent: one.says })] : []), ...where];
}

async function fill() {
  if (done[tab] || !FILL[tab] || document.body.classList.contains("stale")) return;
  done[tab] = true;
  try { await FILL[tab](); } catch (error) { done[tab] = false; if (error.message !== "stopped") wrong(error); }
}

function choose(name, focus) {
  tab = name;
  for (const key of Object.keys(TABS)) {
    const button = $("tab-" + key), is = key === name;
    button.setAttribute("aria-selected", is);
    button.tabIndex = is ? 0 : -1;
    $("panel-" + key).hidden = !is;
    if (is && focus) button.focus();
  }
  fill();
}

function moved(event) {
  const keys = Object.keys(TABS), step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  if (step) choose(keys[(keys.indexOf(tab) + step + keys.length) % keys.length], true);
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

async function exported(name, keys) {
  $("exported").textContent = "Writing …";
  try {
    const { files, left_out } = await work(name, { ...asked(), ...keys });
    for (const file of files) save(file.name, file.content, file.base64);
    $("exported").textContent = [`Saved: ${files.map((file) => file.name).join(", ")}.`, ...left_out].join(" ");
  } catch (error) { $("exported").textContent = error.error?.told ?? String(error); }
}

async function decided() {
  const box = $("decided");
  try {
    const found = await work("check", { text, paper: $("paper").value });
    const head = el("tr", {}, ...["Line", "Formula", "Verdict", "Why"].map((word) => el("th", { scope: "col", textContent: word })));
    const rows = found.map((one) => el("tr", {}, ...[one.line, one.latex, one.outcome, one.detail + (one.fix ? ` – write: ${one.fix}` : "")]
      .map((cell, k) => el("td", { textContent: cell, className: k === 2 ? { PROVED: "good", REFUTED: "bad" }[cell] ?? "" : "" }))));
    box.replaceChildren(found.length ? el("table", {}, head, ...rows) : "No formula was found: write it between \\[ and \\], or between dollars.");
  } catch (error) { box.textContent = error.error?.told ?? String(error); }
}

// --- the tutor

const student = { lines: [], seen: "", hints: [] };
async function tutored(name, keys) {
  if (student.seen !== text) { Object.assign(student, { lines: [], seen: text, hints: [] }); $("lines").replaceChildren(); }
  let found;
  try { found = await work(name, { text, lines: student.lines, ...keys }); } catch (error) { found = { verdict: "", says: error.message }; }
  $("lines").append(el("li", { className: found.verdict === "wrong" ? "bad" : /^true/.test(found.verdict) ? "good" : "" },
    el("code", { textContent: keys.line ?? "a hint:" }), " ", el("strong", { textContent: found.verdict ?? "" }), " ", found.says));
  return found;
}
async function lined(event) {
  event.preventDefault();
  const line = $("line").value.trim();
  if (!line) return;
  const found = await tutored("judge", { line });
  student.lines.push(line);
  student.depth = 0;
  if (found.verdict !== "unread") $("line").value = "";
}

// --- beginning

async function opened() {
  const code = /^#p=([\w-]+)$/.exec(location.hash)?.[1];
  if (code) try { return put(view, await unpacked(code)); } catch { status("The link can't be read; here is a problem of the library."); }
  await started(FIRST);
}

async function started(name) { put(view, (await engine.ask("statement", { name })).text); }

function buttons(parent, formats, write) {
  $(parent).append(...Object.entries(formats).map(([format, label]) => el("button", { type: "button", textContent: label, onclick: () => write(format) })));
}

$("tabs").append(...Object.entries(TABS).map(([key, label]) => {
  const button = el("button", { id: "tab-" + key, type: "button", role: "tab", textContent: label, onclick: () => choose(key) });
  button.setAttribute("aria-controls", "panel-" + key);
  return button;
}));
$("tabs").addEventListener("keydown", moved);
choose("notes");
buttons("formats", NOTES, (format) => exported("export", { format, detail: $("detail").value }));
buttons("sheets", SHEETS, (format) => exported("worksheet", { format, seed: $("seed").value }));
$("save").onclick = () => save("problem.toml", text);
$("decide").onclick = decided;
$("line-form").onsubmit = lined;
$("hint").onclick = () => tutored("hint", { depth: (student.depth = (student.depth || 0) + 1) });
$("record").onclick = async () => { const found = await engine.ask("record", { text, lines: student.lines }); save("record.json", JSON.stringify(found, null, 2)); };
$("detail").onchange = $("language").onchange = refresh;
$("stop").onclick = () => engine.stop();
$("gallery").onchange = () => $("gallery").value && started($("gallery").value);
$("link").onclick = async () => {
  const address = location.href.split("#")[0] + "#p=" + await packed(text);
  try { await navigator.clipboard.writeText(address); status("The link is copied; the problem travels in it."); } catch { status(address); }
};
addEventListener("hashchange", opened);

opened();
engine.ask("completions").then((found) => { tables = found; });
engine.ask("gallery").then((cards) => {
  for (const topic of new Set(cards.map((card) => card.topic))) {
    const own = cards.filter((card) => card.topic === topic).map((card) => el("option", { value: card.name, textContent: card.title }));
    $("gallery").append(el("optgroup", { label: topic }, ...own));
  }
});
if ("serviceWorker" in navigator) navigator.serviceWorker.register("./sw.js").then(() => navigator.serviceWorker.ready).then(() => { marks.kept = performance.now(); });
