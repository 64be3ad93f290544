// What students hand in, as their teacher reads it: every line is judged anew here; what a record says of itself is not believed.
import { say } from "./words.js";

const HEADS = ["student", "problem", "stand", "steps", "hints", "principles"];

/** A table of the records in files, each with its lines behind it; work(name, keys) asks the engine. */
export async function read(files, work, el) {
  const rows = [];
  for (const file of files) {
    try { rows.push(...await row(JSON.parse(await file.text()), work, el)); } catch (error) {
      rows.push(el("tr", {}, el("th", { scope: "row", textContent: file.name }), el("td", { colSpan: HEADS.length - 1, className: "bad", textContent: error.error?.what ?? say("norecord") })));
    }
  }
  return el("table", {}, el("caption", { textContent: say("records.judged") }), el("tr", {}, ...HEADS.map((key) => el("th", { scope: "col", textContent: say("col." + key) }))), ...rows);
}

async function row({ student, statement, lines, hints = 0, principles = [] }, work, el) {
  const found = await work("record", { text: statement, lines: lines.map((one) => one.line), language: document.documentElement.lang });
  const told = found.lines.map((one) => el("li", { className: one.verdict === "wrong" ? "bad" : one.verdict.startsWith("true") ? "good" : "" }, el("code", { textContent: one.line }), " ", el("strong", { textContent: say("verdict." + one.verdict) }), " ", one.says));
  const folded = el("details", {}, el("summary", { textContent: say("lines") }), el("ol", {}, ...told));
  const stand = found.lines.filter((one) => one.verdict.startsWith("true")).length;
  const cells = [found.title, `${stand}/${found.lines.length}`, `${found.steps}/${found.all}`, hints, `${principles.filter((one) => one.right).length}/${principles.length}`];
  return [el("tr", {}, el("th", { scope: "row", textContent: student || "–" }), ...cells.map((textContent) => el("td", { textContent }))), el("tr", {}, el("td", { colSpan: HEADS.length }, folded))];
}
