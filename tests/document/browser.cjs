// Explorers in Chromium, met by a person: node browser.cjs FOLDER-OF-node_modules JOBS.json ; prints a list as JSON.
// A job is {file, hash, act}; `act` is one of ACTS. Each answer holds the numbers of the page and what was seen.
const { createRequire } = require("module");
const { readFileSync } = require("fs");
const [folder, jobs] = process.argv.slice(2);
const { chromium } = createRequire(folder + "/any.js")("playwright-core");

/** The numbers by key, and the phase of each system with the time since it began. */
const readings = (page) => page.evaluate(() => {
  const pairs = [...document.querySelectorAll("data[data-key]")].map((one) => [one.dataset.key, one.value]);
  document.querySelectorAll(".picture").forEach((one, k) => pairs.push([`${k}.phase`, one.dataset.phase], [`${k}.local`, one.dataset.local]));
  return Object.fromEntries(pairs);
});

/** How many different pictures are seen in a while of playing. */
async function pictures(page, reducedMotion) {
  await page.emulateMedia({ reducedMotion });
  await page.evaluate(() => {
    window.seen = 0;
    new MutationObserver(() => { window.seen += 1; }).observe(document.getElementById("picture-0"), { childList: true });
  });
  await page.click("#restart");
  await page.click("#play");
  await page.waitForTimeout(900);
  await page.evaluate(() => document.getElementById("play").dataset.playing === "true" && document.getElementById("play").click());
  return page.evaluate(() => window.seen);
}

/** What has the focus: its id, its role for a screen reader, its name. */
const focused = (page) => page.evaluate(() => {
  const one = document.activeElement, label = one.labels && one.labels[0];
  const name = one.getAttribute("aria-label") || (label && label.textContent.trim()) || one.textContent.trim();
  return { id: one.id, tag: one.tagName, name, value: one.value, said: one.getAttribute("aria-valuetext") };
});

const ACTS = {
  read: async () => ({}),
  calm: async (page) => ({ calm: await pictures(page, "reduce"), lively: await pictures(page, "no-preference") }),
  layers: async (page) => {
    const count = (look) => page.locator(`#picture-0 path.${look}`).count(), before = await count("velocity");
    for (const name of ["trace", "velocity", "acceleration"]) await page.check("#layer-" + name);
    const after = await Promise.all(["trace", "velocity", "acceleration"].map(count)), start = (await readings(page))["p.theta_0"];
    const tip = await page.evaluate(() => document.querySelector("#picture-0 path.velocity-head").getBoundingClientRect().x - document.querySelector("#picture-0 path.trace").getBoundingClientRect().x);
    await page.click("#restart");
    const dot = await page.locator("#picture-0 path.band-edge").first().boundingBox(); // taken at its upper end, not at its middle
    await page.mouse.move(dot.x + 2, dot.y + 2);
    await page.mouse.down();
    await page.mouse.move(dot.x + 30, dot.y + 50, { steps: 4 });
    await page.mouse.up();
    await page.waitForTimeout(300);
    return { before, after, tip, start, dragged: (await readings(page))["p.theta_0"], length: (await readings(page))["p.ell"], said: await page.textContent("#status") };
  },
  numbers: async (page) => {
    const at = async (x, y) => { const box = await page.locator("#curves").boundingBox(); return [box.x + x * box.width, box.y + y * box.height]; };
    await page.selectOption("#curves-kind", "portrait");
    await page.locator("#curves").scrollIntoViewIfNeeded();
    await page.mouse.move(...(await at(0.5, 0.05)));
    await page.mouse.down();
    await page.mouse.up();
    const top = await readings(page), ends = await page.locator("#curves text").allTextContents(), said = await page.locator("#places").textContent();
    const field = page.locator('[data-number="Omega"]'), seen = [];
    for (const text of ["40", "-1"]) { await field.fill(text); await field.press("Enter"); seen.push(await field.inputValue()); }
    return { top, ends, said, seen };
  },
  predict: async (page) => {
    const said = {}, told = () => page.textContent("#outcome");
    await page.click("#predict summary");
    const hidden = await page.locator("#readings-0").isHidden(), last = (await page.locator("#question option").count()) - 1;
    await page.selectOption("#speed", "1");
    await page.selectOption("#question", String(last));
    const keys = await page.locator("#choices input").evaluateAll((all) => all.map((one) => one.value));
    for (const key of keys) {
      await page.check(`#choices input[value="${key}"]`);
      await page.click("#release");
      await page.waitForFunction(() => document.querySelector("#outcome").textContent, null, { timeout: 20000 });
      said[key] = await told();
      await page.click("#restart");
      await page.selectOption("#question", String(last));
    }
    return { said, hidden, after: await page.locator("#readings-0").isVisible() };
  },
  moment: async (page) => {
    await page.check("#layer-moment");
    await page.evaluate(() => scrollTo(0, 0));
    const [wall, floor] = await page.evaluate(() => [...document.querySelectorAll("#picture-0 path.reaction")].map((one) => one.getBoundingClientRect().toJSON()));
    const mark = await page.locator("#picture-0 circle.about").boundingBox(), session = await page.context().newCDPSession(page);
    const goal = [floor.x + floor.width / 2 + 3, wall.y + wall.height / 2 - 3], before = (await readings(page))["p.theta_0"];
    const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
    await touch("touchStart", [[mark.x + mark.width / 2, mark.y + mark.height / 2]]);
    for (const share of [0.3, 0.7, 1]) await touch("touchMove", [[mark.x + share * (goal[0] - mark.x), mark.y + share * (goal[1] - mark.y)]]);
    await touch("touchEnd", []);
    await page.waitForTimeout(100);
    const lines = await page.locator("#picture-0 path.action").count(), told = await page.locator("#moments p").textContent();
    const silent = await page.evaluate(() => document.documentElement.dataset.pitch ?? "");
    await page.check("#layer-sound");
    const heard = [];
    for (const time of ["0", "0.6"]) { await page.fill("#time", time); heard.push(await page.evaluate(() => Number(document.documentElement.dataset.pitch))); }
    await page.fill("#time", "0");
    return { lines, told, before, silent, heard, scrolled: await page.evaluate(() => scrollY) };
  },
  keys: async (page) => {
    const order = [], after = {};
    await page.evaluate(() => document.activeElement.blur());
    for (let k = 0; k < 30; k++) {
      await page.keyboard.press("Tab");
      const one = await focused(page);
      if (one.tag === "BODY" || (order.length && one.id === order[0].id)) break;
      order.push(one);
      if (one.id === "time") {
        for (const key of ["Home", "ArrowRight", "PageUp", "End", "Home"]) { await page.keyboard.press(key); after[key] = Number((await focused(page)).value); }
      }
      if (one.id === "play") {
        await page.keyboard.press("Space");
        after.space = await page.getAttribute("#play", "data-playing");
        await page.keyboard.press("Enter");
        after.enter = await page.getAttribute("#play", "data-playing");
      }
      if (one.id.startsWith("number-") && !after.slider) {
        await page.keyboard.press("ArrowRight");
        after.slider = [one, await focused(page)];
      }
    }
    return { order, after, status: await page.textContent("#status") };
  },
};

(async () => {
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: ["--no-sandbox"] });
  const found = [];
  for (const { file, hash, act, width } of JSON.parse(readFileSync(jobs, "utf8"))) {
    const page = await browser.newPage({ viewport: { width: width || 1000, height: 800 }, hasTouch: act === "moment" }), errors = [];
    page.on("pageerror", (error) => errors.push(error.message));
    await page.goto("file://" + file + (hash || ""));
    await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
    found.push({ ...(await ACTS[act](page)), readings: await readings(page), errors });
    await page.close();
  }
  console.log(JSON.stringify(found));
  await browser.close();
})();
