// Builds the static site: node studio/build.mjs OUT PYTHON. Nothing is fetched: Pyodide and the editor are packages of
// npm (studio/package.json), sympy, mpmath, jinja2 and markupsafe those of the PYTHON that runs rbpsym.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, rmSync, writeFileSync, readdirSync, existsSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";
import { loadPyodide } from "pyodide";

const here = dirname(fileURLToPath(import.meta.url)), root = dirname(here);
const out = resolve(process.argv[2] ?? join(root, "build", "studio")), python = process.argv[3] ?? "python3";
const ENGINE = ["pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "pyodide-lock.json"], LIBRARY = "python_stdlib.zip";
const PYODIDE = join(here, "node_modules", "pyodide");
const TYPST = join(here, "node_modules", "@myriaddreamin", "typst-ts-web-compiler", "pkg");
const FONTS = ["NewComputerModernMath-Regular", "NewComputerModern10-Regular", "NewComputerModern10-Bold", "NewComputerModern10-Italic", "NewComputerModern10-BoldItalic"];
const PACKAGES = ["sympy", "mpmath", "jinja2", "markupsafe"];

const hashed = (data) => createHash("sha256").update(data).digest("hex").slice(0, 10);
const source = (name) => readFileSync(join(here, "src", name), "utf8");
function put(name, data) {
  mkdirSync(dirname(join(out, name)), { recursive: true });
  writeFileSync(join(out, name), data);
  return name;
}

// --- the program and its packages, compiled by the Python that will run them

async function archive() {
  const find = `import json, importlib.util as u; print(json.dumps({n: u.find_spec(n).submodule_search_locations[0] for n in ${JSON.stringify(PACKAGES)}}))`;
  const folders = { ...JSON.parse(execFileSync(python, ["-c", find])), rbpsym: join(root, "rbpsym") };
  const py = await loadPyodide({ indexURL: PYODIDE });
  for (const [name, folder] of Object.entries({ ...folders, templates: join(root, "templates"), derivations: join(root, "derivations"), pack: here })) {
    py.FS.mkdirTree("/src/" + name);
    py.FS.mount(py.FS.filesystems.NODEFS, { root: folder }, "/src/" + name);
  }
  py.runPython(`import sys; sys.path[:0] = ["/src", "/src/pack"]; sys.dont_write_bytecode = True; import pack_engine`);
  py.FS.writeFile("/given.zip", readFileSync(join(PYODIDE, LIBRARY)));
  py.runPython(`pack_engine.pack("/engine", "/data", "/scene.css"); pack_engine.library("/given.zip", "/library.zip")`);
  return [...["/engine", "/data", "/scene.css", "/library.zip"].map((name) => py.FS.readFile(name)), py.runPython("pack_engine.words()"), py.runPython("pack_engine.stock()")];
}

// --- Typst, for PDF: its compiler from npm, its fonts out of the library of the Python package, in which they lie as they are

function fonts() {
  const find = "import importlib.util as u, pathlib as p; print(next(p.Path(u.find_spec('typst').origin).parent.glob('_typst*')))";
  const data = readFileSync(execFileSync(python, ["-c", find], { encoding: "utf8" }).trim()), found = {};
  for (let at = data.indexOf("OTTO"); at >= 0; at = data.indexOf("OTTO", at + 4)) {
    const tables = Array.from({ length: Math.min(data.readUInt16BE(at + 4), 40) }, (_, k) => at + 12 + 16 * k).map((k) => [data.latin1Slice(k, k + 4), data.readUInt32BE(k + 8), data.readUInt32BE(k + 12)]);
    const [, from, size] = tables.find(([tag]) => tag === "name") ?? [];
    if (!from || from + size > 1e7) continue;
    const names = data.latin1Slice(at + from, at + from + size).replaceAll("\0", ""), own = FONTS.find((one) => new RegExp(one + "(?![-A-Za-z])").test(names));
    if (own) found[own] ??= data.subarray(at, at + Math.max(...tables.map(([, start, length]) => start + length)));
  }
  if (Object.keys(found).length < FONTS.length) throw new Error(`the package typst holds no longer the fonts ${FONTS.filter((one) => !found[one]).join(", ")}`);
  return Object.entries(found).map(([name, font]) => put(`typst/${name}.otf`, font));
}

function typst() {
  const names = ["typst_ts_web_compiler.mjs", "typst_ts_web_compiler_bg.wasm"].map((name) => put("typst/" + name, readFileSync(join(TYPST, name))));
  const made = source("typst.js").replace("FILES;", JSON.stringify({ module: names[0], wasm: names[1], fonts: fonts() }) + ";");
  return put(`typst.${hashed(made)}.js`, made);
}

// --- the site

rmSync(out, { recursive: true, force: true });
const began = Date.now();
const [modules, contents, scene, library, words, stock] = await archive();
const engine = Object.fromEntries([...ENGINE.map((name) => [name, readFileSync(join(PYODIDE, name))]), [LIBRARY, library]]);
const pyodide = `pyodide.${hashed(Object.values(engine).map(hashed).join())}/`;
for (const [name, content] of Object.entries(engine)) put(pyodide + name, content);
const [py, data] = [["engine", modules], ["data", contents]].map(([name, made]) => put(`py/${name}.${hashed(made)}.pack`, gzipSync(made, { level: 9 })));
const files = { pyodide, py, data, key: `snapshot-${hashed(pyodide + py + data)}`, snapshots: process.env.STUDIO_SNAPSHOTS !== "0" };

const worker = source("worker.js").replace("FILES;", JSON.stringify(files) + ";");
const workerName = put(`worker.${hashed(worker)}.js`, worker);
const bundled = await build({ entryPoints: [join(here, "src", "app.js")], bundle: true, minify: true, format: "esm", write: false, define: { LANGUAGES: words }, target: "es2022", logLevel: "error" });
const app = bundled.outputFiles[0].text.replace("./WORKER", "./" + workerName).replace("./TYPST", "./" + typst()).replace("./STOCK", "./" + put(`stock.${hashed(stock)}.json`, stock));
const appName = put(`app.${hashed(app)}.js`, app);
const font = readFileSync(join(root, "templates", "math.woff2")), fontName = put(`math.${hashed(font)}.woff2`, font);
const style = source("style.css").replace("FONT", fontName) + new TextDecoder().decode(scene), styleName = put(`style.${hashed(style)}.css`, style);
put("index.html", source("index.html").replace("STYLE", styleName).replace("APP", appName));
put("frame.html", source("frame.html"));

const all = (folder = "") => readdirSync(join(out, folder), { withFileTypes: true })
  .flatMap((one) => one.isDirectory() ? all(join(folder, one.name)) : [join(folder, one.name)]);
const names = all().filter((name) => name !== "index.html").sort(), first = names.filter((name) => !name.startsWith("typst/")); // Typst comes when a PDF is asked for
const sw = source("sw.js").replace("LIST", first.map((name) => JSON.stringify("./" + name)).join(", "));
put("sw.js", sw.replace("VERSION", hashed(names.map((name) => name + hashed(readFileSync(join(out, name)))).join() + readFileSync(join(out, "index.html")))));
const size = (names) => (names.reduce((sum, name) => sum + gzipSync(readFileSync(join(out, name))).length, 0) / 1e6).toFixed(1);
console.log(`${out}: ${all().length} files, ${size(["index.html", ...first])} MB gzipped, ${size(names.filter((name) => !first.includes(name)))} MB more for PDF, ${((Date.now() - began) / 1000).toFixed(0)} s`);
process.exit(0);
