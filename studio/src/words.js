// The page's own words, in one table: [English, Spanish]. Those of notes, errors and verdicts are the engine's.
const TABLE = {
  starting: ["Starting the engine …", "Iniciando el motor …"],
  deriving: ["Deriving …", "Deduciendo …"],
  long: ["Deriving: this takes long; what the other tabs show need not wait for it.", "Deduciendo: tarda; lo que muestran las otras pestañas no tiene que esperar."],
  broken: ["The engine can't be started: {why}", "El motor no puede iniciarse: {why}"],
  proved: ["{proved} of {steps} steps proved, {seconds} s", "{proved} de {steps} pasos demostrados, {seconds} s"],
  line: ["Line {line}: {what}", "Línea {line}: {what}"],
  "from": ["Start from", "Partir de"],
  "from.none": ["a problem of the library …", "un problema de la biblioteca …"],
  detail: ["Notes", "Apuntes"], brief: ["brief", "breves"], standard: ["standard", "normales"], full: ["full", "completos"],
  language: ["in", "en"],
  link: ["Copy link", "Copiar enlace"],
  embed: ["Copy frame", "Copiar marco"],
  stop: ["Stop", "Parar"],
  copied: ["The link is copied; the problem travels in it.", "El enlace está copiado; el problema viaja en él."],
  badlink: ["The link can't be read; here is a problem of the library.", "El enlace no se puede leer; aquí hay un problema de la biblioteca."],
  statement: ["The problem", "El problema"],
  editor: ["The statement of the problem (TOML)", "El enunciado del problema (TOML)"],
  fault: ["What is wrong with the statement", "Qué falla en el enunciado"],
  astext: ["as text", "como texto"], asform: ["as a form", "como formulario"],
  undo: ["undo", "deshacer"],
  results: ["What follows from it", "Lo que se sigue de él"],
  glance: ["At a glance", "De un vistazo"],
  notes: ["Notes", "Apuntes"], answers: ["Drawing & answers", "Dibujo y respuestas"], explorer: ["Explorer", "Explorador"],
  export: ["Export", "Exportar"], check: ["Check a text", "Comprobar un texto"], tutor: ["Tutor", "Tutor"],
  asksnothing: ["The statement asks nothing; add [[ask]] with a question.", "El enunciado no pregunta nada; añada [[ask]] con una pregunta."],
  where: ["where", "donde"],
  "export.notes": ["Lecture notes", "Apuntes de clase"], "export.sheets": ["Worksheet with key", "Hoja de ejercicios con soluciones"],
  "export.statement": ["The statement", "El enunciado"],
  seed: ["Seed (the same seed gives the same numbers again)", "Semilla (la misma da otra vez los mismos números)"],
  writing: ["Writing …", "Escribiendo …"], saved: ["Saved: {files}.", "Guardado: {files}."],
  paper: ["Paste a text with formulas (LaTeX); each is decided with the names of this problem.", "Pegue un texto con fórmulas (LaTeX); cada una se decide con los nombres de este problema."],
  decide: ["Check", "Comprobar"],
  "col.line": ["Line", "Línea"], "col.formula": ["Formula", "Fórmula"], "col.verdict": ["Verdict", "Veredicto"], "col.why": ["Why", "Por qué"],
  nopdf: ["Typst, which makes PDF, can't be loaded; without a network it is there after the first PDF.", "No se puede cargar Typst, que hace los PDF; sin red está disponible después del primer PDF."],
  beside: ["Beside it moves", "A su lado se mueve"], "beside.none": ["nothing else", "nada más"],
  write: [" – write: {fix}", " – escriba: {fix}"],
  noformula: ["No formula was found: write it between \\[ and \\], or between dollars.", "No se encontró ninguna fórmula: escríbala entre \\[ y \\], o entre dólares."],
  "tutor.intro": ["Work on the problem line by line: any true line counts, in any order.", "Trabaje el problema línea a línea: toda línea verdadera cuenta, en cualquier orden."],
  aline: ["A line", "Una línea"], judge: ["Judge", "Juzgar"], hint: ["A hint", "Una pista"], record: ["Save my record", "Guardar mi trabajo"],
  "hint.given": ["a hint:", "una pista:"],
  "verdict.true": ["true", "verdadera"], "verdict.true, not used": ["true, not used", "verdadera, no se usa"],
  "verdict.true, not yet justified": ["true, not yet justified", "verdadera, aún sin justificar"], "verdict.wrong": ["wrong", "falsa"],
  "verdict.undecided": ["undecided", "sin decidir"], "verdict.unread": ["unread", "ilegible"], task: ["The problem", "El problema"],
  principle: ["Which principle is this?", "¿Qué principio es este?"],
  "principle.right": ["Yes.", "Sí."], "principle.wrong": ["No; look again at what the line says.", "No; mire otra vez lo que dice la línea."],
  score: ["{lines} lines stand, {steps} of {all} steps of the derivation.", "{lines} líneas en pie, {steps} de {all} pasos de la deducción."],
  keys: ["Signs and letters", "Signos y letras"],
  add: ["Add …", "Añadir …"], remove: ["Remove", "Quitar"], name: ["Name", "Nombre"], question: ["Question", "Pregunta"],
  "form.none": ["The statement is empty: start from a problem of the library.", "El enunciado está vacío: parta de un problema de la biblioteca."],
  "form.name": ["What is it called? (one word of letters)", "¿Cómo se llama? (una palabra de letras)"],
  change: ["Change this problem", "Cambiar este problema"],
};

let place = 0;
export const speak = (language) => { place = language === "es" ? 1 : 0; };
export const say = (key, slots = {}) => (TABLE[key]?.[place] ?? key).replace(/\{(\w+)\}/g, (_, name) => slots[name] ?? "");

/** Every element with data-w gets its words, with data-l its label, data-t its title. */
export function dress(root = document) {
  for (const one of root.querySelectorAll("[data-w]")) one.textContent = say(one.dataset.w);
  for (const one of root.querySelectorAll("[data-l]")) one.setAttribute("aria-label", say(one.dataset.l));
  for (const one of root.querySelectorAll("[data-t]")) one.title = say(one.dataset.t);
}
