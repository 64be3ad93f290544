// The statement as a form, for those who do not write TOML: it is read by lines and changed line by line, so that the text, its
// order and its remarks stay as they are. What can be chosen comes from the engine's registries.
import { say } from "./words.js";

const HEAD = /^\s*(\[\[?)\s*([^\]]+?)\s*\]?\]\s*(?:#.*)?$/, ROW = /^(\s*([\w."-]+)\s*=\s*)(.*)$/;

/** [{name, line, rows: [{key, line, before, value}]}] of a text; a value may go on over several lines. */
export function read(text) {
  const found = [{ name: "", line: -1, rows: [] }];
  let open = null;
  text.split("\n").forEach((line, number) => {
    if (open) {
      open.value += "\n" + line;
      open.last = number;
      if (isWhole(open.value)) open = null;
      return;
    }
    const head = HEAD.exec(line), row = head ? null : ROW.exec(line);
    if (head) found.push({ name: head[2], many: head[1] === "[[", line: number, rows: [] });
    else if (row) {
      const one = { key: row[2], line: number, last: number, before: row[1], value: row[3] };
      found.at(-1).rows.push(one);
      if (!isWhole(one.value)) open = one;
    }
  });
  return found;
}

function isWhole(value) {
  if ((value.match(/"""|'''/g) ?? []).length % 2) return false;
  const plain = value.replace(/"""[\s\S]*?"""|'''[\s\S]*?'''|"(?:[^"\\]|\\.)*"|'[^']*'|#.*/g, "");
  return ["[]", "{}"].every(([a, b]) => plain.split(a).length <= plain.split(b).length);
}

const STRING = /"(?:[^"\\\n]|\\.)*"|'[^'\n]*'/g, SEVERAL = ["pair", "points", "two bodies"];

/** [value, remark] of what stands after =. */
function parted(value) {
  if (value.includes("\n")) return [value, ""];
  const place = value.replace(STRING, (one) => "·".repeat(one.length)).indexOf("#"), inner = (place < 0 ? value : value.slice(0, place)).trimEnd();
  return [inner, value.slice(inner.length)];
}

/** The texts in a value that are edited one by one: it alone, the members of a list, that of the page's language; none of others. */
function texts(value) {
  const found = [...value.matchAll(STRING)], shape = value.replace(STRING, "·");
  if (/^·$|^\[ ?·(, ?·)*,? ?\]$/.test(shape)) return found;
  if (!/^\{ ?\w\w = ·(, \w\w = ·)* ?\}$/.test(shape)) return null;
  const names = [...shape.matchAll(/\w\w(?= =)/g)].map(String), place = names.indexOf(document.documentElement.lang);
  return [found[Math.max(place, 0)]];
}

function plainly(value) {
  try { return value[0] === '"' ? JSON.parse(value) : /^'[^']*'$/.test(value) ? value.slice(1, -1) : value; } catch { return value; }
}

const blank = (takes) => (SEVERAL.includes(takes) ? '["", ""]' : '""');

/** The bodies of a text and their points. */
function pointsIn(text, tables) {
  return read(text).filter((one) => one.name.startsWith("bodies.")).flatMap(({ name, rows }) => {
    const body = name.slice(7), shape = plainly(parted(rows.find((row) => row.key === "shape")?.value ?? "")[0]);
    return [body, ...(tables?.kinds.bodies.names[shape]?.points ?? []).map((point) => `${body}.${point}`)];
  });
}

/** Questions that can be asked of a text: those of the engine's table, with the names of its bodies, coordinates and constraints. */
export function questionsIn(text, tables) {
  const sections = read(text), of = (kind) => sections.filter((one) => one.name.startsWith(kind + ".")).map((one) => one.name.split(".")[1]);
  const names = { BODY: of("bodies"), COORDINATE: of("coordinates"), FORCE: of("constraints"), CONTACT: of("constraints"), PHASE: of("phases") };
  const filled = (phrase) => { const place = Object.keys(names).find((key) => phrase.includes(key)); return place ? names[place].flatMap((name) => filled(phrase.replaceAll(place, name))) : [phrase]; };
  return [...new Set((tables?.quantities ?? []).filter((one) => /[A-Z]{4}/.test(one)).flatMap(filled))].filter((one) => !/[A-Z]{4}/.test(one));
}

const PROSE = /^(title|source|level|topic|meaning|name|said|glyph)$/;

/** The text with a letter called otherwise wherever a formula or a key holds it: not in what is told to people. */
export function renamed(text, from, to) {
  const lines = text.split("\n"), word = new RegExp(`\\b${from}\\b`, "g");
  for (const { name, rows } of read(text)) for (const row of rows) {
    const [value, remark] = parted(row.value), isTold = PROSE.test(row.key) || /^(parameters|meanings|names)\b/.test(name);
    const now = isTold ? value : value.replace(STRING, (one) => one.replace(word, to)), before = row.key === from ? row.before.replace(word, to) : row.before;
    lines.splice(row.line, row.last - row.line + 1, ...Array(row.last - row.line).fill(null), before + now + remark);
  }
  return lines.filter((line) => line !== null).join("\n");
}

export class Form {
  constructor(holder, el, tables, changed) { Object.assign(this, { holder, el, tables, changed, text: "" }); }

  show(text) {
    if (text === this.text && this.holder.childElementCount) return;
    this.text = text;
    const focused = document.activeElement?.id, sections = read(text);
    this.holder.replaceChildren(...sections.map((one, k) => this.section(one, k)), this.adder());
    this.holder.append(this.names("form-names", pointsIn(text, this.tables())), this.names("form-dimensions", Object.keys(this.tables()?.dimensions ?? {})));
    document.getElementById("questions").replaceChildren(...questionsIn(text, this.tables()).map((value) => this.el("option", { value })));
    if (focused) document.getElementById(focused)?.focus();
    this.tell(this.error);
  }

  names(id, values) { return this.el("datalist", { id }, ...values.map((value) => this.el("option", { value }))); }

  /** What is wrong, told at the row in which it is. */
  tell(error) {
    this.error = error;
    for (const old of this.holder.querySelectorAll(".told")) old.remove();
    const row = [...this.holder.querySelectorAll("[data-line]")].findLast((one) => Number(one.dataset.line) < (error?.line ?? 0));
    if (!row || Number(row.dataset.last) < error.line - 1) return;
    row.append(this.el("p", { className: "told bad", textContent: `${error.what}${error.instead ? ". " + error.instead : ""}` }));
  }

  put(lines) { this.changed(lines.join("\n")); }

  section(one, place) {
    const { el } = this, rows = one.rows.map((row, k) => this.row(one, row, `form-${place}-${k}`));
    if (!rows.length && !one.name) return el("span");
    const tools = one.name ? [this.keys(one), this.remover(one)] : [];
    return el("fieldset", {}, el("legend", { textContent: one.name.replace(".", ": ") || say("statement") }), ...rows, el("div", { className: "tools" }, ...tools));
  }

  row(section, row, id) {
    const { el } = this, lines = this.text.split("\n"), [value, remark] = parted(row.value), found = texts(value);
    const put = (now) => { lines.splice(row.line, row.last - row.line + 1, ...(row.before + now + remark).split("\n")); this.put(lines); };
    const inputs = (found ?? [null]).map((one, k) => {
      const input = this.input(section, row.key, one ? plainly(one[0]) : value, `${id}-${k}`);
      input.onchange = () => put(one ? value.slice(0, one.index) + JSON.stringify(input.value) + value.slice(one.index + one[0].length) : input.value);
      if (k) input.ariaLabel = `${row.key} ${k + 1}`;
      return input;
    });
    const meaning = this.known(section)[row.key] ?? "", help = remark.replace(/^\s*#\s*/, "") || (inputs.some((one) => !one.value) ? meaning : "");
    const letter = el("input", { id: `${id}-key`, value: row.key, ariaLabel: `${row.key}: ${say("form.name")}`, autocomplete: "off", spellcheck: false });
    letter.onchange = () => /^[A-Za-z]\w*$/.test(letter.value) ? this.changed(renamed(this.text, row.key, letter.value)) : (letter.value = row.key);
    const called = section.name === "parameters" ? letter : el("label", { htmlFor: `${id}-0`, textContent: row.key, title: meaning });
    if (called === letter) inputs[0].ariaLabel = row.key;
    const line = el("div", { className: "row" }, called, el("span", { className: "inputs" }, ...inputs), ...(help ? [el("small", { textContent: help })] : []));
    Object.assign(line.dataset, { line: row.line, last: row.last });
    return line;
  }

  input(section, key, value, id) {
    const { el } = this, choices = this.choices(section, key), long = value.includes("\n") || value.length > 60;
    if (choices) return el("select", { id }, ...[...new Set([value, ...choices])].map((name) => el("option", { value: name, textContent: name, selected: name === value })));
    const input = el(long ? "textarea" : "input", { id, value, ...(long ? { rows: Math.min(8, value.split("\n").length + 1) } : { autocomplete: "off" }), spellcheck: false });
    const takes = this.takes(section)[key], list = section.name === "parameters" ? "form-dimensions" : key === "question" ? "questions" : /point|bod/.test(takes) ? "form-names" : "";
    if (list && !long) input.setAttribute("list", list);
    return input;
  }

  /** The last of “bodies.rod”, “phases.x.impulses.P” that has kinds. */
  own(section) {
    const names = section.name.split("."), tables = this.tables();
    return names.includes("impulses") ? "impulses" : names.find((name) => name in (tables?.kinds ?? {})) ?? names[0];
  }

  kind(section) {
    const key = this.tables()?.kinds[this.own(section)]?.key, row = section.rows.find((one) => one.key === key);
    return row && plainly(parted(row.value)[0]);
  }

  choices(section, key) {
    const tables = this.tables(), kinds = tables?.kinds[this.own(section)];
    if (kinds?.key === key) return Object.keys(kinds.names);
    if (key === "dimension") return Object.keys(tables?.dimensions ?? {});
    if (key === "event") return Object.keys(tables?.events ?? {});
    return Array.isArray(this.takes(section)[key]) ? this.takes(section)[key] : null;
  }

  /** What each key of a section takes: choices, or the name of what it is. */
  takes(section) { return this.tables()?.kinds[this.own(section)]?.names[this.kind(section)]?.takes ?? {}; }

  known(section) {
    const tables = this.tables(), own = this.own(section);
    return { ...tables?.keys[own], ...tables?.kinds[own]?.names[this.kind(section)]?.keys };
  }

  keys(section) {
    const has = new Set(section.rows.map((row) => row.key)), more = Object.entries(this.known(section)).filter(([key]) => !has.has(key));
    const add = (key) => {
      const lines = this.text.split("\n"), last = section.rows.at(-1)?.last ?? section.line;
      lines.splice(last + 1, 0, `${key} = ${blank(this.takes(section)[key])}`);
      this.put(lines);
    };
    if (section.name === "parameters") return this.named(section.name, (name) => {
      const lines = this.text.split("\n");
      lines.splice((section.rows.at(-1)?.last ?? section.line) + 1, 0, `${name} = "length"`);
      this.put(lines);
    });
    return more.length ? this.menu(say("add"), more.map(([key, meaning]) => [key, `${key} – ${meaning}`]), add) : this.el("span");
  }

  menu(words, options, chosen) {
    const menu = this.el("select", { ariaLabel: words }, this.el("option", { value: "", textContent: words }), ...options.map(([value, textContent]) => this.el("option", { value, textContent })));
    menu.onchange = () => menu.value && chosen(menu.value);
    return menu;
  }

  named(label, chosen) {
    const input = this.el("input", { placeholder: say("name"), ariaLabel: `${label}: ${say("form.name")}`, size: 10, pattern: "[A-Za-z]\\w*" });
    const go = () => /^[A-Za-z]\w*$/.test(input.value) ? chosen(input.value) : input.focus();
    input.onkeydown = (event) => { if (event.key === "Enter") { event.preventDefault(); go(); } };
    return this.el("span", {}, input, " ", this.el("button", { type: "button", textContent: say("add"), onclick: go }));
  }

  remover(section) {
    const remove = () => {
      const lines = this.text.split("\n"), next = read(this.text).find((one) => one.line > section.line)?.line ?? lines.length;
      lines.splice(section.line, next - section.line);
      this.put(lines);
    };
    return this.el("button", { type: "button", textContent: say("remove"), ariaLabel: `${say("remove")} ${section.name}`, onclick: remove });
  }

  /** A new body, force, constraint …: its kind is chosen, then its name; its keys follow with their meanings. */
  adder() {
    const kinds = Object.entries(this.tables()?.kinds ?? {}).filter(([section]) => section !== "impulses");
    const whole = { coordinates: "dimension", parameters: "" }, has = new Set(read(this.text).map((one) => one.name));
    const sections = Object.entries(whole).filter(([name]) => !has.has(name)).map(([name, key]) => [`${name} ${key}`, `${name} – ${this.tables()?.sections[name] ?? ""}`]);
    const options = kinds.flatMap(([section, { key, names }]) => Object.entries(names).map(([name, { meaning }]) => [`${section} ${key} ${name}`, `${section}: ${name} – ${meaning}`]));
    const end = (lines) => this.put([...this.text.replace(/\n+$/, "").split("\n"), "", ...lines, ""]);
    const begin = (value) => {
      const [section, key, name] = value.split(" ");
      if (section === "parameters") return end(["[parameters]", 'g = "acceleration: acceleration of gravity"']);
      if (!name) return ask(section, (own) => end([`[${section}.${own}]`, `${key} = "angle"`, 'start = ""', 'speed = "0"']));
      const { keys, takes } = this.tables().kinds[section].names[name];
      const needed = Object.entries(keys).filter(([, meaning]) => !/may be left out$/.test(meaning)).map(([one]) => `${one} = ${blank(takes[one])}`);
      ask(name, (own) => end([`[${section}.${own}]`, `${key} = "${name}"`, ...needed]));
    };
    const ask = (name, chosen) => { place.replaceChildren(this.named(name, chosen)); place.querySelector("input").focus(); };
    const place = this.el("span"), question = this.el("button", { type: "button", textContent: say("question"), onclick: () => end(["[[ask]]", 'question = ""']) });
    return this.el("div", { className: "tools" }, this.menu(say("add"), [...sections, ...options], begin), " ", place, " ", question);
  }
}
