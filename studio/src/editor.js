// The editor of a statement: TOML in colours, completion from the engine's registries, errors under their line.
import { autocompletion, closeBrackets, completionKeymap, startCompletion } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab, isolateHistory, undo } from "@codemirror/commands";
import { StreamLanguage, HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { EditorState, StateEffect, StateField } from "@codemirror/state";
import { Decoration, EditorView, WidgetType, drawSelection, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";

const colours = HighlightStyle.define([
  { tag: [tags.propertyName, tags.keyword], class: "t-key" }, { tag: tags.string, class: "t-string" },
  { tag: tags.atom, class: "t-head" }, { tag: tags.comment, class: "t-comment" },
]);

class Told extends WidgetType {
  constructor(error) { super(); this.error = error; }
  eq(other) { return other.error.told === this.error.told; }
  toDOM() {
    const box = document.createElement("div");
    box.className = "cm-fault";
    const { column, width, what, instead } = this.error;
    box.textContent = " ".repeat(Math.max(column - 1, 0)) + "^".repeat(Math.max(width, 1)) + "\n" + what + (instead ? "\n  " + instead : "");
    return box;
  }
}

const setFault = StateEffect.define();
const fault = StateField.define({
  create: () => Decoration.none,
  update(marks, change) {
    marks = marks.map(change.changes);
    for (const effect of change.effects) if (effect.is(setFault)) marks = shown(change.state, effect.value);
    return marks;
  },
  provide: (field) => EditorView.decorations.from(field),
});

function shown(state, error) {
  if (!error || !error.line || error.line > state.doc.lines) return Decoration.none;
  const line = state.doc.line(error.line);
  return Decoration.set([Decoration.widget({ widget: new Told(error), block: true, side: 1 }).range(line.to)]);
}

const HEAD = /^\s*\[\[?\s*([^\]]+?)\s*\]?\]?\s*$/;

// Where the cursor stands: the section, its kind (by shape = or type =), and what is before the cursor on the line.
function place(state, pos) {
  const line = state.doc.lineAt(pos), before = line.text.slice(0, pos - line.from);
  let section = "", first = line.number;
  for (let n = line.number - 1; n > 0 && !section; n--) {
    const head = HEAD.exec(state.doc.line(n).text);
    if (head) { section = head[1]; first = n; }
  }
  let kind = "";
  for (let n = first + 1; n <= state.doc.lines && !HEAD.test(state.doc.line(n).text); n++) {
    kind = /^\s*(?:shape|type)\s*=\s*"([^"]*)"/.exec(state.doc.line(n).text)?.[1] ?? kind;
  }
  return { before, names: section.split("."), kind };
}

const rows = (words, apply = (name) => name) => Object.entries(words).map(([label, detail]) => ({ label, detail, apply: apply(label), type: "keyword" }));

function names(state, pattern) {
  const found = {};
  for (const line of state.doc.iterLines()) { const hit = pattern.exec(line); if (hit) found[hit[1]] = hit[2] ?? ""; }
  return found;
}

export function offered(state, pos, tables) {
  const { before, names: [section, ...rest], kind } = place(state, pos), word = /[\w.-]*$/.exec(before)[0];
  const own = rest.includes("impulses") ? "impulses" : rest.find((name) => name in tables.kinds) ?? section;
  const kinds = tables.kinds[own], from = pos - word.length;
  if (/^\s*\[\[?[\w]*$/.test(before)) return { from, options: rows(tables.sections) };
  const value = /^\s*([\w-]+)\s*=\s*(.*)$/.exec(before);
  if (!value) {
    if (!/^\s*[\w-]*$/.test(before)) return null;
    if (!section) return { from, options: rows(tables.sections, (name) => name + " = ") };
    const keys = { ...(kinds && own !== "bodies" ? { type: "its kind" } : {}), ...tables.keys[own], ...kinds?.names[kind]?.keys };
    return { from, options: rows(keys, (name) => `${name} = `) };
  }
  const [, key, typed] = value, open = typed.lastIndexOf('"');
  if (open < 0) return null;
  if (kinds?.key === key) return { from, options: rows(Object.fromEntries(Object.entries(kinds.names).map(([name, one]) => [name, one.meaning]))) };
  if (key === "event") return { from, options: rows(tables.events) };
  if (section === "parameters" || key === "dimension") return { from, options: rows(tables.dimensions) };
  if (key === "question") return { from: pos - typed.slice(open + 1).length, options: rows(Object.fromEntries(tables.quantities.map((q) => [q, ""]))) };
  const bodies = names(state, /^\[bodies\.(\w+)\]/), points = {};
  for (const name of Object.keys(bodies)) for (const point of pointsOf(state, name, tables)) points[`${name}.${point}`] = "a point of " + name;
  return { from, options: rows({ ...points, ...bodies, ...names(state, /^(\w+)\s*=\s*"[\w ]+:?\s*(.*)"/), ...names(state, /^\[coordinates\.(\w+)\]/) }) };
}

function pointsOf(state, body, tables) {
  const shape = new RegExp(`^\\[bodies\\.${body}\\][^\\[]*?^shape\\s*=\\s*"([^"]+)"`, "m").exec(state.doc.toString())?.[1];
  return tables.kinds.bodies.names[shape]?.points ?? [];
}

export function editor(parent, changed, tables) {
  const complete = ({ state, pos, explicit }) => {
    const found = tables() && offered(state, pos, tables());
    return found && (explicit || pos > found.from || /"$/.test(state.sliceDoc(pos - 1, pos))) ? { ...found, validFor: /^[\w. -]*$/ } : null;
  };
  return new EditorView({
    parent,
    state: EditorState.create({
      doc: "",
      extensions: [
        lineNumbers(), history(), drawSelection(), highlightActiveLine(), closeBrackets(), StreamLanguage.define(toml), syntaxHighlighting(colours),
        autocompletion({ override: [complete], icons: false }), fault, EditorView.lineWrapping,
        keymap.of([...completionKeymap, { key: "Mod-Space", run: startCompletion }, ...defaultKeymap, ...historyKeymap, indentWithTab]),
        EditorView.contentAttributes.of({ tabindex: "0", "aria-label": "The statement of the problem (TOML)" }),
        EditorView.updateListener.of((update) => update.docChanged && changed(update.state.doc.toString())),
      ],
    }),
  });
}

export const undone = (view) => undo(view);
export const tell = (view, error) => view.dispatch({ effects: setFault.of(error) });
/** Another text: one step of the history by itself, never joined to what is typed just before or behind. */
export const put = (view, text) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text }, selection: { anchor: 0 }, scrollIntoView: true, annotations: isolateHistory.of("full") });
