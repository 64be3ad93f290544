// The problems that ship, as cards with their drawings, which are made as they come into sight; and one to begin anew from.
import { say } from "./words.js";

/** A problem to begin from, in the words of the page: it is derived as it stands. */
const fresh = () => `title = "${say("new.title")}"

[parameters]
M   = "mass: ${say("new.mass")}"
ell = "length: ${say("new.length")}"
g   = "acceleration: ${say("new.gravity")}"

[coordinates.theta]
meaning = "${say("new.angle")}"
start   = "theta_0"
range   = ["-pi", "pi"]

[bodies.rod]
shape  = "rod"
mass   = "M"
length = "ell"
start  = "O"
angle  = "theta - pi/2"

[interactions.W]
type = "gravity"

[constraints.F]
type  = "pivot"
point = "rod.start"

[[ask]]
question = "period of theta"
`;
const $ = (id) => document.getElementById(id);
const plain = (text) => text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase().replace(/[^\p{L}\d]+/gu, " ");

/** Cards are chosen by started(name), or began(text) for a new one; picture(name) gives {figure, alt}. */
export function shelf(el, picture, started, began) {
  const seen = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue;
      seen.unobserve(target);
      picture(target.dataset.name).then(({ figure }) => { target.firstChild.innerHTML = figure; }, (error) => { if (/^(outdated|stopped)$/.test(error.message)) seen.observe(target); }); // else it has none: the title stands alone
    }
  }, { root: $("cards"), rootMargin: "100px" });
  const card = (name, title, about, chosen) => {
    const one = el("button", { type: "button", onclick: () => { $("shelf").close(); chosen(); } }, el("span", { className: "scenes", ariaHidden: "true", textContent: name ? "" : "+" }), el("strong", { textContent: title }), el("small", { textContent: about }));
    one.dataset.name = name;
    one.dataset.words = plain(` ${title} ${about} ${name}`);
    if (name) seen.observe(one);
    return one;
  };
  $("gallery").onclick = () => { $("shelf").showModal(); $("wanted").focus(); };
  $("close").onclick = () => $("shelf").close();
  $("wanted").oninput = () => {
    const words = plain($("wanted").value).split(" "); // each begins a word
    for (const one of $("cards").children) one.hidden = !words.every((word) => one.dataset.words.includes(" " + word));
    $("found").textContent = say("found", { count: [...$("cards").children].filter((one) => !one.hidden).length });
  };
  return (problems) => {
    $("cards").replaceChildren(card("", say("new"), say("new.about"), () => began(fresh())), ...problems.map((one) => card(one.name, one.title, [one.topic, one.level].filter(Boolean).join(" · "), () => started(one.name))));
    $("wanted").oninput();
  };
}
