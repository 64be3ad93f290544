// The engine in a worker: Pyodide with the program's compiled modules; one JSON request in, one JSON answer out.
const files = FILES; // put in by the build: {data, py, key, snapshots}
const here = new URL("./", self.location.href).href;
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
  const { loadPyodide } = await import(here + "pyodide/pyodide.mjs");
  let python, how = "plain";
  if (snapshot) try { python = await restored(loadPyodide, snapshot); how = "snapshot"; } catch (error) { console.warn("no snapshot:", error); }
  if (!python) {
    const [data, py] = [fetched(files.data), fetched(files.py)];
    python = await loadPyodide({ indexURL: here + "pyodide/", _makeSnapshot: Boolean(files.snapshots) });
    for (const archive of [await data, await py]) python.unpackArchive(archive, "zip", { extractDir: "/engine" });
    python.runPython('import sys\nsys.path.insert(0, "/engine")');
  }
  call = python.runPython("from rbpsym.studio.api import call\ncall");
  postMessage({ ready: Math.round(performance.now() - began), how });
  if (how === "plain" && files.snapshots) keeping = () => setTimeout(keep, 1500, python);
}

const fetched = async (name) => (await fetch(here + name)).arrayBuffer();

// All that was imported is in the memory that was kept; the files are not: data are unpacked now, modules when one is missing.
async function restored(loadPyodide, snapshot) {
  const data = fetched(files.data), make = (await import(here + "pyodide/pyodide.asm.mjs")).default;
  const python = await loadPyodide({
    indexURL: here + "pyodide/", _loadSnapshot: snapshot,
    createPyodideModule: async (settings) => {
      const made = await make(settings);
      if (made.HEAP8.length < snapshot.length) made.growMemory(snapshot.length);
      return made;
    },
  });
  python.unpackArchive(await data, "zip", { extractDir: "/engine" });
  self.unpackModules = () => python.unpackArchive(now(files.py), "zip", { extractDir: "/engine" });
  python.runPython(LATE);
  return python;
}

const LATE = `
import sys
from importlib import invalidate_caches
from importlib.machinery import PathFinder

class Late:
    """Finds a module that is not there yet: its archive is unpacked first."""

    def find_spec(self, name, path=None, target=None):
        from js import unpackModules

        sys.meta_path.remove(self)
        unpackModules()
        invalidate_caches()
        return PathFinder.find_spec(name, path, target)

sys.meta_path.append(Late())
`;

function now(name) {
  const request = new XMLHttpRequest();
  request.open("GET", here + name, false);
  request.responseType = "arraybuffer";
  request.send();
  return request.response;
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
onmessage = async ({ data }) => {
  try {
    await booted;
    const began = performance.now(), answer = call(data);
    postMessage({ done: true, answer, worked: Math.round(performance.now() - began) });
    if (keeping && data.includes('"do":"notes"')) { keeping(); keeping = null; }
  } catch (error) {
    postMessage({ done: true, broken: String(error && error.message || error) });
  }
};
