// The studio in a frame of another page: node embedding.mjs FOLDER-OF-node_modules ADDRESS; prints what that page heard as JSON.
import { createRequire } from "node:module";
const [folder, address] = process.argv.slice(2);
const { chromium } = createRequire(folder + "/any.js")("playwright-core");
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: ["--no-sandbox"] });
const page = await browser.newPage(), faults = [];
page.on("pageerror", (error) => faults.push(String(error)));

/** A page of another origin that the server gives too (it asks nothing of its own), with the studio in a frame. */
const embedded = async (hash) => {
  await page.goto("about:blank");
  await page.goto(address.replace("127.0.0.1", "localhost") + "sw.js");
  await page.evaluate((url) => {
    const frame = Object.assign(document.createElement("iframe"), { width: 900, height: 640 });
    let last = 0;
    window.heard = [];
    window.asks = (keys) => new Promise((resolve) => {
      const id = ++last, hear = ({ data }) => { if (data.event === "answer" && data.id === id) { removeEventListener("message", hear); resolve(data.ok ?? data.error); } };
      addEventListener("message", hear);
      frame.contentWindow.postMessage({ rbpsym: 1, id, ...keys }, "*");
    });
    addEventListener("message", ({ data, source }) => { if (source === frame.contentWindow) window.heard.push(data); });
    frame.src = url;
    document.body.replaceChildren(frame);
  }, `${address}index.html#${hash}`);
};
const event = (name) => page.waitForFunction((n) => window.heard.findLast((one) => one.event === n), name, { timeout: 120000 }).catch(async () => { throw new Error(`never heard ${name}, but ${await page.evaluate(() => JSON.stringify(window.heard).slice(0, 600))}; ${faults}`); }).then((one) => one.jsonValue());
const asks = (keys) => page.evaluate((k) => window.asks(k), keys);

const seen = { faults };
await embedded("n=sliding-ladder&only=explorer&theta_0=1.1&lang=en");
seen.moving = await event("moving");
seen.derived = await event("derived");
await asks({ do: "set", numbers: { theta_0: 1.3, nothing: 2 }, time: 0.25, play: true });
seen.plays = await page.waitForFunction(() => window.heard.find((one) => one.event === "plays" && one.numbers.theta_0 === 1.3), null, { timeout: 20000 }).then((one) => one.jsonValue());
seen.state = await asks({ do: "state" });
seen.asked = await asks({ do: "ask", request: { do: "judge", line: "theta_ddot = 3*g/(4*ell)*cos(theta)" } });
seen.refused = await asks({ do: "ask", request: { do: "no such thing" } });

await embedded("n=sliding-ladder&only=tutor&lang=en");
await event("derived");
const frame = page.frameLocator("iframe");
await frame.locator("#letters button").first().waitFor({ timeout: 60000 });
for (const line of ["I = M*ell^2/3", "theta_ddot = 3*g/(4*ell)*cos(theta)"]) {
  await frame.locator("#line").fill(line);
  await frame.locator("#line").press("Enter");
  await page.waitForFunction((l) => window.heard.some((one) => one.event === "judged" && one.line === l), line, { timeout: 60000 });
}
await page.waitForFunction(() => window.heard.filter((one) => one.event === "score").length === 2, null, { timeout: 60000 });
seen.judged = await page.evaluate(() => window.heard.filter((one) => one.event === "judged").map((one) => one.verdict));
seen.score = await event("score");
if (process.env.SHOT) await page.screenshot({ path: process.env.SHOT });
console.log(JSON.stringify(seen));
await browser.close();
