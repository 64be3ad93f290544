// The tutor's sheet: a student's lines, each judged at once; the record stays in this browser until it is saved.
import { say } from "./words.js";

const SIGNS = ["=", "+", "-", "*", "/", "^2", "(", ")", "sqrt(", "sin(", "cos("];
const $ = (id) => document.getElementById(id);

export class Tutor {
  constructor(work, el, tells) {
    Object.assign(this, { work, el, tells, seen: "", lines: [], depth: 0 });
    $("line-form").onsubmit = (event) => { event.preventDefault(); this.line(); };
    $("hint").onclick = () => this.hint();
  }

  /** The sheet of another problem: what was written on it before comes back. */
  async open(text, key) {
    if (this.seen === text) return;
    Object.assign(this, { seen: text, key: "sheet " + key, lines: [], depth: 0 });
    $("lines").replaceChildren();
    $("score").textContent = "";
    let before = [];
    try { before = JSON.parse(localStorage.getItem(this.key) ?? "[]"); } catch { /* a browser that keeps nothing */ }
    for (const line of before) await this.judge(line);
    this.letters((await this.work("letters", { text })).letters);
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
    try { localStorage.setItem(this.key, JSON.stringify(this.lines)); } catch { /* the same */ }
    const { steps, all, lines } = await this.work("record", { text: this.seen, lines: this.lines });
    const stand = lines.filter((one) => one.verdict.startsWith("true")).length;
    $("score").textContent = say("score", { lines: stand, steps, all });
    this.tells("score", { steps, all, lines: stand, of: lines.length });
  }

  async judge(line) {
    let found;
    try { found = await this.work("judge", { text: this.seen, line, lines: this.lines }); } catch (error) { found = { verdict: "", says: error.message, choices: [] }; }
    const row = this.row(line, found.verdict, found.says);
    if (found.choices?.length && !this.lines.includes(line)) row.append(this.asked(found));
    if (!this.lines.includes(line) && found.verdict !== "unread") this.lines.push(line);
    this.tells("judged", { line, verdict: found.verdict, says: found.says });
    return found;
  }

  row(line, verdict, says) {
    const look = verdict === "wrong" ? "bad" : verdict.startsWith("true") ? "good" : "";
    const row = this.el("li", { className: look }, this.el("code", { textContent: line }), " ", this.el("strong", { textContent: verdict }), " ", says);
    $("lines").append(row);
    return row;
  }

  /** “Which principle?”, asked where a line is one. */
  asked({ choices, principle }) {
    const told = this.el("output", {});
    const choose = (one) => { told.textContent = " " + say(one.key === principle ? "principle.right" : "principle.wrong"); this.tells("principle", { chosen: one.key, right: one.key === principle }); };
    const buttons = choices.map((one) => this.el("button", { type: "button", textContent: one.words, onclick: () => choose(one) }));
    return this.el("div", { className: "asked" }, say("principle") + " ", ...buttons, told);
  }

  async hint() {
    const { says } = await this.work("hint", { text: this.seen, lines: this.lines, depth: ++this.depth });
    this.row(say("hint.given"), "", says);
  }
}
