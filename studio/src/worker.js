// The engine in a worker: Pyodide with the program's compiled modules; one JSON request in, one JSON answer out.
const files = FILES; // put in by the build: {pyodide, data, py, key, snapshots}
const here = new URL("./", self.location.href).href, engine = here + files.pyodide;
const CACHE = "rbpsym-studio-snapshot";
let call;

async function kept() {
  try {
    const cache = await caches.open(CACHE), found = await cache.match(here + files.key);
    for (const old of await cache.keys()) if (!old.url.endsWith(files.key)) await cache.delete(old);
    return found && new Uint8Array(await found.arrayBuffer());
  } catch { return null; }
}

async function boot() {
  const began = performance.now();
  const snapshot = files.snapshots ? await kept() : null;
  const { loadPyodide } = await import(engine + "pyodide.mjs");
  let python, how = "plain";
  if (snapshot) try { python = await restored(loadPyodide, snapshot); how = "snapshot"; } catch (error) { console.warn("no snapshot:", error); }
  if (!python) {
    const packs = [files.data, files.py].map(fetched);
    python = await loadPyodide({ indexURL: engine, _makeSnapshot: Boolean(files.snapshots) });
    for (const pack of packs) laid(python, await pack);
    python.runPython('import sys\nsys.path.insert(0, "/engine")');
  }
  call = python.runPython("from rbpsym.studio.api import call\ncall");
  postMessage({ ready: Math.round(performance.now() - began), how });
  if (how === "plain" && files.snapshots) keeping = () => setTimeout(keep, 1500, python);
}

const fetched = async (name) => new Response((await fetch(here + name)).body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();

/** The files of a pack, where Python finds them: behind a list of [name, length] and its own length. */
function laid(python, pack) {
  const size = new DataView(pack).getUint32(0, true), folders = new Set();
  let at = 4 + size;
  for (const [name, length] of JSON.parse(new TextDecoder().decode(new Uint8Array(pack, 4, size)))) {
    const path = "/engine/" + name, folder = path.slice(0, path.lastIndexOf("/"));
    if (!folders.has(folder)) python.FS.mkdirTree(folder);
    folders.add(folder);
    python.FS.writeFile(path, new Uint8Array(pack, at, length), { canOwn: true });
    at += length;
  }
}

// All that was imported is in the memory that was kept; the files are not: data are laid out now, modules after the first notes or when one is missing.
let late = null;
async function restored(loadPyodide, snapshot) {
  const data = fetched(files.data), make = (await import(engine + "pyodide.asm.mjs")).default;
  const python = await loadPyodide({
    indexURL: engine, _loadSnapshot: snapshot,
    createPyodideModule: async (settings) => {
      const made = await make(settings);
      if (made.HEAP8.length < snapshot.length) made.growMemory(snapshot.length);
      return made;
    },
  });
  laid(python, await data);
  late = async () => {
    late = null;
    laid(python, await fetched(files.py));
    python.runPython("from importlib import invalidate_caches\ninvalidate_caches()");
  };
  return python;
}

function answered(request) {
  const began = performance.now(), answer = call(request);
  postMessage({ done: true, answer, worked: Math.round(performance.now() - began) });
}

// The memory after the first answer, for the next visit: it begins there.
let keeping = null;
async function keep(python) {
  try {
    call.destroy();
    const memory = python.makeMemorySnapshot();
    call = python.runPython("from rbpsym.studio.api import call\ncall");
    await (await caches.open(CACHE)).put(here + files.key, new Response(memory));
    postMessage({ snapshot: memory.length });
  } catch (error) { console.warn("no snapshot is kept:", error); }
}

const booted = boot();
let laying = null;
onmessage = async ({ data }) => {
  try {
    await booted;
    await laying;
    try { answered(data); } catch (error) {
      if (!late || !/ModuleNotFoundError/.test(error.message)) throw error;
      await (laying = late());
      answered(data);
    }
    if (!data.includes('"do":"notes"')) return;
    if (keeping) { keeping(); keeping = null; }
    if (late) laying = late();
  } catch (error) {
    postMessage({ done: true, broken: String(error && error.message || error) });
  }
};
