// The tutor's sheet: a student's lines, each judged at once; the record stays in this browser until it is saved.
import { say } from "./words.js";

const SIGNS = ["=", "+", "-", "*", "/", "^2", "(", ")", "sqrt(", "sin(", "cos("], DIGITS = [..."1234567890"], BACK = "⌫", SOON = 120;
const $ = (id) => document.getElementById(id);

export class Tutor {
  constructor(work, el, tells) {
    Object.assign(this, { el, tells, seen: "", lines: [], given: [], depth: 0, hints: 0, principles: [] });
    this.work = (name, keys = {}) => work(name, { text: this.seen, language: document.documentElement.lang, ...keys });
    this.ready(false);
    $("line-form").onsubmit = (event) => { event.preventDefault(); this.line(); };
    $("hint").onclick = () => this.hint();
    $("line").oninput = () => { clearTimeout(this.later); this.later = setTimeout(() => this.typed(), SOON); };
  }

  /** The line as it will be printed, while it is typed. */
  async typed() {
    const line = $("line").value.trim(), { math } = line ? await this.work("typed", { line }) : { math: "" };
    if ($("line").value.trim() === line) $("typed").innerHTML = math;
  }

  /** Nothing is judged before the problem is there. */
  ready(is) { for (const one of $("line-form").elements) one.disabled = !is; }

  /** What the student reads: the drawing and the first section of the notes, in which the problem is told. */
  task(figure, page) {
    const told = [];
    for (let one = page.querySelector("h2")?.nextElementSibling; one && one.localName !== "h2"; one = one.nextElementSibling) if (one.localName !== "figure") told.push(one);
    for (const link of told.flatMap((one) => [...one.querySelectorAll("a")])) link.replaceWith(...(/^\(\d+\)$/.test(link.textContent) ? [] : link.childNodes)); // they lead to places in the notes: no equation of these is told here
    $("task").replaceChildren(this.el("div", { className: "scenes", innerHTML: figure }), ...told);
  }

  /** The sheet of another problem: what was written on it before comes back. */
  async open(text, key) {
    if (this.seen === text) return;
    Object.assign(this, { seen: text, key: "sheet " + key, lines: [], given: [], depth: 0, hints: 0, principles: [] });
    this.ready(false);
    $("lines").replaceChildren();
    $("score").textContent = "";
    let before = [];
    try {
      const kept = JSON.parse(localStorage.getItem(this.key) ?? "[]");
      before = kept.lines ?? kept;
      Object.assign(this, { hints: kept.hints ?? 0, principles: kept.principles ?? [] });
      $("student").value = localStorage.getItem("student") ?? "";
    } catch { /* a browser that keeps nothing */ }
    const { letters, shown } = await this.work("letters");
    this.letters(letters, shown);
    $("line").placeholder = `${letters.find((name) => /^alpha$|_ddot$/.test(name)) ?? letters[0]} = …`;
    for (const line of before) await this.judge(line);
    if (this.seen === text) this.ready(true);
    if (before.length) await this.scored(); else await this.work("judge", { line: "0 = 1" }); // what judging needs is worked out before the first line
  }

  /** Keys that show letters as they are printed; on a phone with digits, so that its own keyboard may stay away. */
  letters(names, shown) {
    const put = (sign) => {
      const line = $("line"), end = line.selectionEnd ?? line.value.length, at = line.selectionStart ?? end, back = sign === BACK;
      line.setRangeText(back ? "" : sign, back && at === end ? Math.max(0, at - 1) : at, end, "end");
      if (matchMedia("(pointer: fine)").matches) line.focus();
      line.oninput();
    };
    const key = (sign, name, look = "") => this.el("button", { type: "button", className: look, [name ? "innerHTML" : "textContent"]: name || sign, title: sign, onclick: () => put(sign) });
    $("letters").replaceChildren(...names.map((name, k) => key(name, shown[k])), ...SIGNS.map((sign) => key(sign)), ...[...DIGITS, BACK].map((sign) => key(sign, "", "digit")));
  }

  async line() {
    const line = $("line").value.trim();
    if (!line) return;
    const found = await this.judge(line);
    if (found.verdict !== "unread") { $("line").value = ""; $("typed").replaceChildren(); }
    this.depth = 0;
    await this.scored();
  }

  async scored() {
    this.keep();
    const { steps, all, lines } = await this.work("record", { lines: this.lines });
    const stand = lines.filter((one) => one.verdict.startsWith("true")).length;
    $("score").textContent = say("score", { lines: stand, of: lines.length, steps, all });
    this.tells("score", { steps, all, lines: stand, of: lines.length });
  }

  keep() { const { lines, hints, principles } = this; try { localStorage.setItem(this.key, JSON.stringify({ lines, hints, principles })); localStorage.setItem("student", $("student").value); } catch { /* the same */ } }

  /** What is handed in: the lines with their verdicts, whose they are, and the statement, by which all is judged anew. */
  async record() {
    this.keep();
    return { student: $("student").value, ...await this.work("record", { lines: this.lines }), hints: this.hints, principles: this.principles, statement: this.seen };
  }

  async judge(line) {
    let found;
    try { found = await this.work("judge", { line, lines: this.lines }); } catch (error) { found = { verdict: "", says: error.message, choices: [] }; }
    const row = this.row(line, found.verdict, found.says, found.math);
    if (found.choices?.length && !this.lines.includes(line)) row.append(this.asked(line, found));
    if (!this.lines.includes(line) && found.verdict && found.verdict !== "unread") this.lines.push(line);
    this.tells("judged", { line, verdict: found.verdict, says: found.says });
    return found;
  }

  /** The last line stands first: beneath the place in which one writes. */
  row(line, verdict, says, math) {
    const look = verdict === "wrong" ? "bad" : verdict.startsWith("true") ? "good" : "";
    const row = this.el("li", { className: look }, this.el("span", math ? { innerHTML: math, title: line } : { textContent: line, className: "plain" }), " ", this.el("strong", { textContent: verdict && say("verdict." + verdict) }), " ", says);
    $("lines").prepend(row);
    return row;
  }

  /** “Which principle?”, asked where a line is one. */
  asked(line, { choices, principle }) {
    const told = this.el("output", {});
    const choose = (one) => { told.textContent = " " + say(one.key === principle ? "principle.right" : "principle.wrong"); this.principles.push({ line, chosen: one.key, right: one.key === principle }); this.keep(); this.tells("principle", { chosen: one.key, right: one.key === principle }); };
    const buttons = choices.map((one) => this.el("button", { type: "button", textContent: one.words, onclick: () => choose(one) }));
    return this.el("div", { className: "asked" }, say("principle") + " ", ...buttons, told);
  }

  /** More of the next step with each hint; when all of it is told, the next hint is of the step after it. */
  async hint() {
    const { says, line } = await this.work("hint", { lines: [...this.lines, ...this.given], depth: ++this.depth });
    this.row(say("hint.given"), "", says);
    this.hints++;
    this.keep();
    if (line) { this.given.push(line); this.depth = 0; }
  }
}
