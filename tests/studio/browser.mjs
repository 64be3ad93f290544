// The page in Chromium: node browser.mjs FOLDER-OF-node_modules ADDRESS; prints what was seen as JSON.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
const [folder, address] = process.argv.slice(2);
const load = createRequire(folder + "/any.js");
const { chromium } = load("playwright-core");
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: ["--no-sandbox"] });
const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, acceptDownloads: true });
await context.grantPermissions(["clipboard-read", "clipboard-write"], { origin: new URL(address).origin });
const page = await context.newPage(), seen = { foreign: [], faults: [] };
context.on("request", (request) => { if (!request.url().startsWith(address) && !/^(data|blob|about):/.test(request.url())) seen.foreign.push(request.url()); });
page.on("pageerror", (error) => seen.faults.push(String(error)));
page.on("console", (message) => message.type() === "error" && seen.faults.push(message.text()));

const noted = (count) => page.waitForFunction((n) => window.studio?.times.length >= n, count, { timeout: 90000 });
const title = () => page.frameLocator("#notes").locator("h1").first().textContent();

async function axe(name) {
  await page.evaluate(readFileSync(load.resolve("axe-core/axe.min.js"), "utf8") + "; 0"); // no script tag: the page allows none
  return page.evaluate(async () => (await window.axe.run(document, { iframes: false })).violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html.slice(0, 120)).join(" | ")}`));
}

// load, and the notes of a problem
await page.goto(address);
await noted(1);
seen.title = await title();
seen.status = await page.textContent("#status");

// the problems that ship, with their drawings
await page.click("#gallery");
await page.fill("#wanted", "escalera resbala");
await page.fill("#wanted", "sliding LADDER spring");
await page.locator("#cards button:visible svg").first().waitFor({ timeout: 30000 });
seen.shelf = [await page.locator("#cards button:visible strong").allTextContents(), await axe("shelf")];
await page.click("#close");

// an edit: typed at the end of the statement
const end = async (text) => { await page.click("#editor .cm-content"); await page.keyboard.press("Control+End"); await page.keyboard.insertText(text); };
await end('\n[[ask]]\nquestion = "N_f at the start"\n');
await noted(2);
await page.click("#tab-answers");
await page.locator("#answers").getByText("N_f at the start").waitFor({ timeout: 30000 });
seen.edited = await page.locator("#answers h2").count();
await page.fill("#asked", "F_x at the start");
await page.keyboard.press("Enter");
await page.locator("#told").getByText("means nothing").waitFor({ timeout: 30000 });
await page.fill("#asked", "N_w at the start");
await page.keyboard.press("Enter");
await page.locator("#told math").waitFor({ timeout: 30000 });
seen.asked = [await page.textContent("#told"), await page.locator('#questions option[value="angular velocity of ladder"]').count()];
seen.glance = await page.evaluate(() => [document.querySelectorAll("#figure svg").length, document.querySelectorAll("#motion math").length]);

// the same as a form: a value that is changed there is changed in the text
await page.click("#asform");
seen.axeForm = await axe("form");
for (const [from, to] of [["ell", "L"], ["L", "ell"]]) { // a letter is called otherwise wherever it stands, and again as it was
  await page.getByLabel(new RegExp(`^${from}: `)).fill(to);
  await page.keyboard.press("Tab");
  await page.getByLabel(new RegExp(`^${to}: `)).waitFor({ timeout: 10000 });
  seen.renamed = [...(seen.renamed ?? []), await page.locator("#form").getByLabel("length", { exact: true }).inputValue()];
}
await page.locator("#form").getByLabel("question").last().fill("N_w at the start");
await page.keyboard.press("Tab");
await page.locator("#answers").getByText("N_w at the start").waitFor({ timeout: 30000 });
await page.click("#astext");
seen.formed = await page.evaluate(() => document.querySelector("#editor .cm-content").textContent.includes("N_w at the start"));

// an error: told under its line
await end('[bodies.other]\nshap = "rod"\n');
await page.waitForSelector(".cm-fault", { timeout: 30000 });
seen.fault = await page.textContent(".cm-fault");
seen.panel = await page.textContent("#fault");
await page.keyboard.press("Control+z"); // what was typed, and nothing that the form did before
await page.waitForFunction(() => !document.querySelector(".cm-fault"), null, { timeout: 30000 });

// completion from the registries
await end('\n[interactions.S]\ntype = "spr');
await page.keyboard.press("Control+Space");
await page.getByText("a linear spring").first().waitFor({ timeout: 10000 });
seen.completed = true;
await page.keyboard.press("Escape");
await page.keyboard.press("Control+z");
await page.waitForTimeout(400);

// the explorer moves, an export is saved, a pasted text is decided
await page.click("#tab-explorer");
await page.frameLocator("#explorer").getByRole("button", { name: "Play" }).waitFor({ timeout: 30000 });
seen.explorer = true;
const explorer = page.frameLocator("#explorer");
await explorer.locator('[data-number="M"]').fill("12.5");
await explorer.locator('[data-number="M"]').press("Enter");
await page.waitForFunction(() => /&M=12.5/.test(location.hash), null, { timeout: 10000 });
await explorer.locator("#loose-title").click();
await explorer.locator('[data-holds="N_w"]').uncheck();
await explorer.getByText("as stated: total").waitFor({ timeout: 60000 });
await page.selectOption("#beside", "rod-pendulum");
await explorer.locator("#picture-1 path.band").first().waitFor({ timeout: 60000 });
await page.selectOption("#beside", "");
seen.released = true;
await page.click("#tab-export");
await page.click("#look");
seen.sheet = await page.frameLocator("#sheet").locator("h1").textContent({ timeout: 60000 });
const waiting = page.waitForEvent("download", { timeout: 60000 });
await page.click("#formats >> text=LaTeX");
const file = await waiting;
seen.export = [file.suggestedFilename(), readFileSync(await file.path(), "utf8").slice(0, 14)];
const printing = page.waitForEvent("download", { timeout: 120000 });
await page.click("#formats >> text=PDF");
const paper = await printing;
seen.pdf = [paper.suggestedFilename(), readFileSync(await paper.path(), "latin1").slice(0, 5)];
await page.click("#tab-check");
await page.fill("#paper", "\\[ \\ddot\\theta = -\\frac{3g}{2\\ell}\\cos\\theta \\]");
await page.click("#decide");
await page.waitForSelector("#decided td", { timeout: 30000 });
seen.check = await page.textContent("#decided");
await page.click("#tab-tutor");
await page.fill("#line", "theta_ddot = -3*g/(2*ell)*cos(theta)");
seen.typed = await page.locator("#typed mfrac").textContent({ timeout: 60000 });
await page.keyboard.press("Enter");
await page.waitForFunction(() => document.querySelector("#score").textContent, null, { timeout: 60000 });
seen.axeTutor = await axe("tutor");
seen.tutor = await page.textContent("#lines li");

// what is handed in, and how a teacher reads it: a record that praises itself is judged anew
await page.click("#hint");
await page.fill("#student", "Ana");
const handing = page.waitForEvent("download", { timeout: 30000 });
await page.click("#record");
const record = JSON.parse(readFileSync(await (await handing).path(), "utf8"));
for (const line of record.lines) line.verdict = "true";
const handed = (name, text) => ({ name, mimeType: "application/json", buffer: Buffer.from(text) });
await page.setInputFiles("#files", [handed("ana.json", JSON.stringify(record)), handed("other.json", "{}")]);
await page.locator("#records table").waitFor({ state: "attached", timeout: 60000 });
seen.records = await page.locator("#records tr").evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
await page.click("#tab-notes");

// a link brings the problem to another page
await page.click("#link");
await page.waitForFunction(() => /copied/.test(document.querySelector("#status").textContent), null, { timeout: 10000 });
const link = await page.evaluate(() => navigator.clipboard.readText());
seen.axe = await axe("desktop");
await page.waitForFunction(() => window.studio.kept, null, { timeout: 60000 });
const other = await context.newPage();
await other.goto(link);
await other.waitForFunction(() => window.studio?.notes, null, { timeout: 90000 });
seen.linked = await other.evaluate(() => document.querySelector("#editor .cm-content").textContent.includes("[bodies.ladder]"));
await other.waitForFunction(() => window.studio.boot.snapshot || window.studio.boot.how === "snapshot", null, { timeout: 30000 });
await other.close();

// without a network, on a phone
await context.setOffline(true);
await page.setViewportSize({ width: 360, height: 740 });
await page.emulateMedia({ colorScheme: "dark" });
await page.goto("about:blank");
await page.goto(link);
await noted(1);
seen.offline = await title();
seen.boot = await page.evaluate(() => window.studio.boot.how);
seen.wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
seen.axePhone = await axe("phone");
if (process.env.SHOT) await page.screenshot({ path: process.env.SHOT, fullPage: true });
console.log(JSON.stringify(seen));
await browser.close();
