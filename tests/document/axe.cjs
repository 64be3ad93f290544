// What axe-core finds wrong with pages: node axe.cjs FOLDER-OF-node_modules PAGE... ; prints a list as JSON.
// Each page is met on a desktop in light, on a phone of 360 px in dark, and as it is printed.
const { createRequire } = require("module");
const [folder, ...pages] = process.argv.slice(2);
const load = createRequire(folder + "/any.js");
const { chromium } = load("playwright-core");

const VIEWS = [
  { name: "desktop light", width: 1000, colorScheme: "light" },
  { name: "phone dark", width: 360, colorScheme: "dark" },
  { name: "print", width: 800, colorScheme: "light", media: "print" },
];

async function look(browser, file, view) {
  const viewport = { width: view.width, height: 800 };
  const page = await browser.newPage({ viewport, colorScheme: view.colorScheme });
  const outside = [];
  page.on("request", (request) => /^(file|data|about):/.test(request.url()) || outside.push(request.url()));
  await page.emulateMedia({ media: view.media || "screen", colorScheme: view.colorScheme });
  await page.goto("file://" + file);
  await page.addScriptTag({ path: load.resolve("axe-core/axe.min.js") });
  const found = await page.evaluate(async () => ({
    violations: (await axe.run()).violations.map((v) => `${v.id}: ${v.nodes.length} × ${v.nodes[0].html.slice(0, 160)}`),
    wider: document.documentElement.scrollWidth - window.innerWidth,
    font: document.fonts.check('16px "Notes Math"'),
  }));
  await page.close();
  return { file, view: view.name, outside, ...found };
}

(async () => {
  const executablePath = process.env.CHROMIUM || "/usr/bin/chromium";
  const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
  const results = [];
  for (const file of pages) for (const view of VIEWS) results.push(await look(browser, file, view));
  console.log(JSON.stringify(results));
  await browser.close();
})();
