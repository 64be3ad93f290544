// The tutor's sheet: a student's lines, each judged at once; the record stays in this browser until it is saved.
import { say } from "./words.js";

const SIGNS = ["=", "+", "-", "*", "/", "^2", "(", ")", "sqrt(", "sin(", "cos("];
const $ = (id) => document.getElementById(id);

export class Tutor {
  constructor(work, el, tells) {
    Object.assign(this, { el, tells, seen: "", lines: [], given: [], depth: 0 });
    this.work = (name, keys = {}) => work(name, { text: this.seen, language: document.documentElement.lang, ...keys });
    this.ready(false);
    $("line-form").onsubmit = (event) => { event.preventDefault(); this.line(); };
    $("hint").onclick = () => this.hint();
  }

  /** Nothing is judged before the problem is there. */
  ready(is) { for (const one of $("line-form").elements) one.disabled = !is; }

  /** What the student reads: the drawing and the first section of the notes, in which the problem is told. */
  task(figure, page) {
    const told = [];
    for (let one = page.querySelector("h2")?.nextElementSibling; one && one.localName !== "h2"; one = one.nextElementSibling) if (one.localName !== "figure") told.push(one);
    for (const link of told.flatMap((one) => [...one.querySelectorAll("a")])) link.replaceWith(...link.childNodes); // they lead to places in the notes
    $("task").replaceChildren(this.el("div", { className: "scenes", innerHTML: figure }), ...told);
  }

  /** The sheet of another problem: what was written on it before comes back. */
  async open(text, key) {
    if (this.seen === text) return;
    Object.assign(this, { seen: text, key: "sheet " + key, lines: [], given: [], depth: 0 });
    this.ready(false);
    $("lines").replaceChildren();
    $("score").textContent = "";
    let before = [];
    try { before = JSON.parse(localStorage.getItem(this.key) ?? "[]"); } catch { /* a browser that keeps nothing */ }
    const { letters } = await this.work("letters");
    this.letters(letters);
    $("line").placeholder = `${letters.at(-1)} = …`;
    for (const line of before) await this.judge(line);
    if (this.seen === text) this.ready(true);
    if (before.length) await this.scored();
  }

  letters(names) {
    const put = (sign) => {
      const line = $("line"), at = line.selectionStart ?? line.value.length;
      line.setRangeText(sign, at, line.selectionEnd ?? at, "end");
      line.focus();
    };
    $("letters").replaceChildren(...[...names, ...SIGNS].map((sign) => this.el("button", { type: "button", textContent: sign, onclick: () => put(sign) })));
  }

  async line() {
    const line = $("line").value.trim();
    if (!line) return;
    const found = await this.judge(line);
    if (found.verdict !== "unread") $("line").value = "";
    this.depth = 0;
    await this.scored();
  }

  async scored() {
    try { localStorage.setItem(this.key, JSON.stringify(this.lines)); } catch { /* the same */ }
    const { steps, all, lines } = await this.work("record", { lines: this.lines });
    const stand = lines.filter((one) => one.verdict.startsWith("true")).length;
    $("score").textContent = say("score", { lines: stand, steps, all });
    this.tells("score", { steps, all, lines: stand, of: lines.length });
  }

  async judge(line) {
    let found;
    try { found = await this.work("judge", { line, lines: this.lines }); } catch (error) { found = { verdict: "", says: error.message, choices: [] }; }
    const row = this.row(line, found.verdict, found.says);
    if (found.choices?.length && !this.lines.includes(line)) row.append(this.asked(found));
    if (!this.lines.includes(line) && found.verdict && found.verdict !== "unread") this.lines.push(line);
    this.tells("judged", { line, verdict: found.verdict, says: found.says });
    return found;
  }

  /** The last line stands first: beneath the place in which one writes. */
  row(line, verdict, says) {
    const look = verdict === "wrong" ? "bad" : verdict.startsWith("true") ? "good" : "";
    const row = this.el("li", { className: look }, this.el("code", { textContent: line }), " ", this.el("strong", { textContent: verdict && say("verdict." + verdict) }), " ", says);
    $("lines").prepend(row);
    return row;
  }

  /** “Which principle?”, asked where a line is one. */
  asked({ choices, principle }) {
    const told = this.el("output", {});
    const choose = (one) => { told.textContent = " " + say(one.key === principle ? "principle.right" : "principle.wrong"); this.tells("principle", { chosen: one.key, right: one.key === principle }); };
    const buttons = choices.map((one) => this.el("button", { type: "button", textContent: one.words, onclick: () => choose(one) }));
    return this.el("div", { className: "asked" }, say("principle") + " ", ...buttons, told);
  }

  /** More of the next step with each hint; when all of it is told, the next hint is of the step after it. */
  async hint() {
    const { says, line } = await this.work("hint", { lines: [...this.lines, ...this.given], depth: ++this.depth });
    this.row(say("hint.given"), "", says);
    if (line) { this.given.push(line); this.depth = 0; }
  }
}
