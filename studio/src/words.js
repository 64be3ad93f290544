// The page's own words: `studio.toml` of each language, put in by the build. Those of notes, errors and verdicts are the engine's.
export const WORDS = LANGUAGES;

let spoken = WORDS.en;
export const speak = (language) => { spoken = WORDS[language] ?? WORDS.en; };
export const say = (key, slots = {}) => (spoken[key] ?? key).replace(/\{(\w+)\}/g, (_, name) => slots[name] ?? "");

/** Every element with data-w gets its words, with data-l its label, data-t its title. */
export function dress(root = document) {
  for (const one of root.querySelectorAll("[data-w]")) one.textContent = say(one.dataset.w);
  for (const one of root.querySelectorAll("[data-l]")) one.setAttribute("aria-label", say(one.dataset.l));
  for (const one of root.querySelectorAll("[data-t]")) one.title = say(one.dataset.t);
}
