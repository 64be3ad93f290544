"use strict";
// Checks the answers of a worksheet in the page itself. Typed formulas are read by the small parser below and
// compared with the key at some points; nothing that is typed is ever run.
const Worksheet = (() => {
  const FUNCTIONS = {sin: Math.sin, cos: Math.cos, tan: Math.tan, sqrt: Math.sqrt, exp: Math.exp, ln: Math.log,
    asin: Math.asin, acos: Math.acos, atan: Math.atan, arcsin: Math.asin, arccos: Math.acos, arctan: Math.atan, sen: Math.sin, tg: Math.tan, raiz: Math.sqrt};
  const RAISED = {"⁰": "0", "¹": "1", "²": "2", "³": "3", "⁴": "4", "⁵": "5", "⁶": "6", "⁷": "7", "⁸": "8", "⁹": "9", "⁻": "-"};
  const LONGEST = 600;

  // text -> tokens: numbers, names of the task, functions, operators; null at the first thing that is not known
  function tokens(text, spellings) {
    const found = [], names = Object.keys(spellings).sort((a, b) => b.length - a.length);
    text = text.normalize("NFC").replace(/[¼-¾⅐-⅞]/g, one => `(${one.normalize("NFKD").replace("⁄", "/")})`).replace(/[−–]/g, "-").replace(/[·×⋅∙]/g, "*").replace(/÷/g, "/").replace(/√/g, "sqrt")
      .replace(/½/g, "(1/2)").replace(/¼/g, "(1/4)").replace(/¾/g, "(3/4)").replace(/π/g, "pi")
      .replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+/g, run => "^(" + [...run].map(c => RAISED[c]).join("") + ")");
    for (let at = 0; at < text.length;) {
      const rest = text.slice(at);
      const space = /^\s+/.exec(rest), number = /^(\d+([.,]\d+)?|[.,]\d+)/.exec(rest);
      if (space) { at += space[0].length; continue; }
      if (number) { found.push({kind: "number", value: parseFloat(number[0].replace(",", "."))}); at += number[0].length; continue; }
      if (rest.startsWith("**")) { found.push({kind: "^"}); at += 2; continue; }
      const name = names.find(n => rest.startsWith(n));
      const word = /^[A-Za-z]+/.exec(rest);
      const isFunction = word && Object.hasOwn(FUNCTIONS, word[0]);
      if (isFunction && !(name && name.length >= word[0].length)) { found.push({kind: "function", value: FUNCTIONS[word[0]]}); at += word[0].length; continue; }
      if (name) { found.push({kind: "name", value: spellings[name]}); at += name.length; continue; }
      if (rest.startsWith("pi")) { found.push({kind: "number", value: Math.PI}); at += 2; continue; }
      if ("+-*/^()[]".includes(rest[0])) { found.push({kind: rest[0] === "[" ? "(" : rest[0] === "]" ? ")" : rest[0]}); at += 1; continue; }
      return null;
    }
    return found;
  }

  // tokens -> function of a point; sum, product (also by juxtaposition), sign, power
  function parsed(text, spellings) {
    if (text.length > LONGEST) return null;
    const list = tokens(text, spellings);
    if (!list || !list.length) return null;
    let at = 0, depth = 0;
    const peek = () => (at < list.length ? list[at].kind : "");
    const starts = kind => ["number", "name", "function", "("].includes(kind);
    function sum() {
      let left = product();
      while (left && (peek() === "+" || peek() === "-")) {
        const sign = list[at++].kind === "+" ? 1 : -1, a = left, b = product();
        left = b && (p => a(p) + sign * b(p));
      }
      return left;
    }
    function product() {
      let left = signed();
      while (left && (peek() === "*" || peek() === "/" || starts(peek()))) {
        const divides = peek() === "/";
        if (!starts(peek())) at++;
        const a = left, b = signed();
        left = b && (divides ? p => a(p) / b(p) : p => a(p) * b(p));
      }
      return left;
    }
    function signed() {
      if (peek() === "-") { at++; const inner = signed(); return inner && (p => -inner(p)); }
      if (peek() === "+") { at++; return signed(); }
      return power();
    }
    function power() {
      const base = atom();
      if (base && peek() === "^") { at++; const exponent = signed(); return exponent && (p => Math.pow(base(p), exponent(p))); }
      return base;
    }
    function atom() {
      const token = list[at++];
      if (!token || ++depth > 200) return null;
      try {
        if (token.kind === "number") return () => token.value;
        if (token.kind === "name") return p => p[token.value];
        if (token.kind === "function") {
          let exponent = null;
          if (peek() === "^") { at++; exponent = atom(); if (!exponent) return null; }
          const arg = peek() === "(" ? atom() : argument();
          if (!arg) return null;
          return exponent ? p => Math.pow(token.value(arg(p)), exponent(p)) : p => token.value(arg(p));
        }
        if (token.kind === "(") { const inner = sum(); if (peek() !== ")") return null; at++; return inner; }
        return null;
      } finally { depth--; }
    }
    // sin 2 theta: factors up to the next function, sign or operator
    function argument() {
      let left = power();
      while (left && ["number", "name", "("].includes(peek())) { const a = left, b = power(); left = b && (p => a(p) * b(p)); }
      return left;
    }
    const result = sum();
    return at === list.length ? result : null;
  }

  function same(formula, points, values) {
    return points.every((point, k) => {
      const value = formula(point), scale = Math.max(Math.abs(value), Math.abs(values[k]), 1e-9);
      return Number.isFinite(value) && Math.abs(value - values[k]) <= 1e-6 * scale;
    });
  }

  function checkFormula(key, text) {
    const formula = parsed(text, key.spellings);
    if (!formula) return {verdict: "invalid"};
    if (same(formula, key.points, key.values)) return {verdict: "right"};
    const slip = key.slips.find(s => same(formula, key.points, s.values));
    return {verdict: "wrong", comment: slip ? slip.comment : ""};
  }

  function checkNumber(key, text) {
    const found = /^\s*([-+−]?\s*\d*[.,]?\d*(?:\s*(?:[eE]|[·×*]\s*10\s*\^?)\s*[-−+]?\d+)?)\s*(.*)$/.exec(text.replace(/−/g, "-"));
    const digits = found && found[1].replace(/\s+/g, "").replace(",", ".").replace(/[·×*]10\^?/, "e");
    const number = digits && /\d/.test(digits) ? parseFloat(digits) : NaN;
    if (!Number.isFinite(number)) return {verdict: "invalid"};
    const unit = found[2].trim().replace(/·|\s+/g, "*").replace(/²/g, "^2").replace(/°/g, "deg");
    if (!Object.hasOwn(key.units, unit)) return {verdict: "unit"};
    const value = number * key.units[unit], near = (a, b) => Math.abs(a - b) <= key.tolerance * Math.abs(b) + 1e-12;
    if (!near(value, key.exact)) {
      const slip = key.slips.find(s => near(value, s.exact));
      return {verdict: "wrong", comment: slip ? slip.comment : ""};
    }
    const figures = digits.replace(/e.*/, "").replace(/^[-+]?0*\.?0*/, "").replace(".", "").length;
    return {verdict: figures < key.digits - 1 ? "few" : figures > key.digits + 1 ? "many" : "right"};
  }

  function checkOrder(key, text) {
    const order = (text.toLowerCase().match(/[a-z]/g) || []).map(c => c.charCodeAt(0) - 97), place = {};
    order.forEach((piece, at) => { place[piece] = at; });
    if (order.length !== key.count || Object.keys(place).length !== key.count || order.some(p => p >= key.count)) return {verdict: "invalid"};
    return {verdict: key.before.every(([i, j]) => place[i] < place[j]) ? "right" : "wrong"};
  }

  const CHECKS = {
    formula: (key, answers) => checkFormula(key, answers[0]),
    number: (key, answers) => checkNumber(key, answers[0]),
    order: (key, answers) => checkOrder(key, answers[0]),
    choose: (key, answers) => answers[0] === "" ? {verdict: "invalid"}
      : {verdict: Number(answers[0]) === key.right ? "right" : "wrong", comment: key.comments[Number(answers[0])] || ""},
    // three fields a row: two signs, and a letter that rows share whose works cancel
    signs: (key, answers) => {
      const rows = key.rows.map((_, k) => answers.slice(3 * k, 3 * k + 3).map(a => a.trim().toLowerCase()));
      if (rows.some(([a, b]) => a === "" || b === "")) return {verdict: "invalid"};
      const right = rows.every(([a, b, letter], k) => a === key.rows[k][0] && b === key.rows[k][1]
        && (letter !== "") === (key.rows[k][2] !== "")
        && rows.every((other, j) => (letter !== "" && letter === other[2]) === (key.rows[k][2] !== "" && key.rows[k][2] === key.rows[j][2])));
      return {verdict: right ? "right" : "wrong"};
    },
  };

  return {parsed, checkFormula, checkNumber, checkOrder, CHECKS};
})();

if (typeof document !== "undefined") document.addEventListener("DOMContentLoaded", () => {
  const {keys, words} = JSON.parse(document.getElementById("keys").textContent);
  document.documentElement.classList.add("checks");
  for (const area of document.querySelectorAll("[data-key]")) {
    const key = keys[area.dataset.key], told = area.querySelector(".verdict");
    const fields = [...area.querySelectorAll("input[type=text],select")];
    const picked = () => { const radio = area.querySelector("input[type=radio]:checked"); return radio ? radio.value : ""; };
    const answers = () => key.check === "choose" ? [picked()] : fields.map(f => f.value);
    area.querySelector("button").addEventListener("click", () => {
      const result = Worksheet.CHECKS[key.check](key, answers());
      told.className = "verdict " + (["right", "few", "many"].includes(result.verdict) ? "right" : "wrong");
      told.innerHTML = words[result.verdict] + (result.comment ? " " + result.comment : "");
    });
  }
});
if (typeof module !== "undefined") module.exports = Worksheet;
