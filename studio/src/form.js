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

const plainly = (value) => /^"[^"\\\n]*"$/.test(value) ? value.slice(1, -1) : value;
const written = (typed, before) => (/^"[^"\\\n]*"$/.test(before) || before === "" ? JSON.stringify(typed) : typed);

export class Form {
  constructor(holder, el, tables, changed) { Object.assign(this, { holder, el, tables, changed, text: "" }); }

  show(text) {
    if (text === this.text && this.holder.childElementCount) return;
    this.text = text;
    const focused = document.activeElement?.id, sections = read(text);
    this.holder.replaceChildren(...sections.map((one, k) => this.section(one, k)), this.adder());
    if (focused) document.getElementById(focused)?.focus();
  }

  put(lines) { this.changed(lines.join("\n")); }

  section(one, place) {
    const { el } = this, rows = one.rows.map((row, k) => this.row(one, row, `form-${place}-${k}`));
    if (!rows.length && !one.name) return el("span");
    const tools = one.name ? [this.keys(one), this.remover(one)] : [];
    return el("fieldset", {}, el("legend", { textContent: one.name.replace(".", ": ") || say("statement") }), ...rows, el("div", { className: "tools" }, ...tools));
  }

  row(section, row, id) {
    const { el } = this, lines = this.text.split("\n");
    const choices = this.choices(section, row.key), value = plainly(row.value), long = value.includes("\n") || value.length > 60;
    const input = choices ? el("select", { id }, ...[...new Set([value, ...choices])].map((name) => el("option", { value: name, textContent: name, selected: name === value })))
      : el(long ? "textarea" : "input", { id, value, ...(long ? { rows: Math.min(8, value.split("\n").length + 1) } : { autocomplete: "off" }), spellcheck: false });
    input.onchange = () => {
      lines.splice(row.line, row.last - row.line + 1, ...(row.before + written(input.value, row.value)).split("\n"));
      this.put(lines);
    };
    return el("div", { className: "row" }, el("label", { htmlFor: id, textContent: row.key, title: this.known(section)[row.key] ?? "" }), input);
  }

  /** The last of “bodies.rod”, “phases.x.impulses.P” that has kinds. */
  own(section) {
    const names = section.name.split("."), tables = this.tables();
    return names.includes("impulses") ? "impulses" : names.find((name) => name in (tables?.kinds ?? {})) ?? names[0];
  }

  kind(section) {
    const key = this.tables()?.kinds[this.own(section)]?.key, row = section.rows.find((one) => one.key === key);
    return row && plainly(row.value);
  }

  choices(section, key) {
    const tables = this.tables(), kinds = tables?.kinds[this.own(section)];
    if (kinds?.key === key) return Object.keys(kinds.names);
    if (key === "dimension") return Object.keys(tables?.dimensions ?? {});
    return key === "event" ? Object.keys(tables?.events ?? {}) : null;
  }

  known(section) {
    const tables = this.tables(), own = this.own(section);
    return { ...tables?.keys[own], ...tables?.kinds[own]?.names[this.kind(section)]?.keys };
  }

  keys(section) {
    const has = new Set(section.rows.map((row) => row.key)), more = Object.entries(this.known(section)).filter(([key]) => !has.has(key));
    const add = (key) => {
      const lines = this.text.split("\n"), last = section.rows.at(-1)?.last ?? section.line;
      lines.splice(last + 1, 0, `${key} = ""`);
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
    const options = kinds.flatMap(([section, { key, names }]) => Object.entries(names).map(([name, { meaning }]) => [`${section} ${key} ${name}`, `${section}: ${name} – ${meaning}`]));
    const end = (lines) => this.put([...this.text.replace(/\n+$/, "").split("\n"), "", ...lines, ""]);
    const begin = (value) => {
      const [section, key, name] = value.split(" "), keys = this.tables().kinds[section].names[name].keys;
      const needed = Object.entries(keys).filter(([, meaning]) => !/may be left out$/.test(meaning)).map(([one]) => `${one} = ""`);
      place.replaceChildren(this.named(name, (own) => end([`[${section}.${own}]`, `${key} = "${name}"`, ...needed])));
      place.querySelector("input").focus();
    };
    const place = this.el("span"), ask = this.el("button", { type: "button", textContent: say("question"), onclick: () => end(["[[ask]]", 'question = ""']) });
    return this.el("div", { className: "tools" }, this.menu(say("add"), options, begin), " ", place, " ", ask);
  }
}
