// The engine as the page sees it: ask(name, keys) gives a promise; one request is with the worker at a time. What was asked
// `passing` is of no use once the statement has changed: drop() takes it out of the queue; stop() ends what runs, too.
export class Fault extends Error {
  constructor(error) { super(error.what); this.error = error; }
}
const gone = (what) => new Fault({ what, told: "", line: 0 });

export class Engine {
  constructor(url, told) {
    this.url = url; this.told = told; this.queue = []; this.running = null;
    this.start();
  }

  start() {
    this.worker = new Worker(this.url, { type: "module" });
    this.worker.onmessage = ({ data }) => this.heard(data);
    this.worker.onerror = (event) => this.told({ broken: event.message || "the engine can't be loaded" });
  }

  heard(data) {
    if (!data.done) return this.told(data);
    const { resolve, reject } = this.running;
    this.running = null;
    this.next();
    if (data.broken) return reject(new Fault({ what: "the engine met a fault of its own: " + data.broken, told: data.broken, line: 0 }));
    const answer = JSON.parse(data.answer);
    this.told({ worked: data.worked });
    if (answer.error) reject(new Fault(answer.error)); else resolve(answer.ok);
  }

  next() {
    if (this.running || !this.queue.length) return;
    this.running = this.queue.shift();
    this.since = performance.now();
    this.worker.postMessage(this.running.request);
  }

  ask(name, keys = {}, passing = false) {
    return new Promise((resolve, reject) => {
      this.queue.push({ resolve, reject, passing, name, request: JSON.stringify({ do: name, ...keys }) });
      this.next();
    });
  }

  /** For how long what was asked under this name runs already, in ms. */
  lasts(name) { return this.running?.name === name ? performance.now() - this.since : 0; }

  /** True if what runs is outdated, too. */
  drop() {
    const old = this.queue.filter((one) => one.passing);
    this.queue = this.queue.filter((one) => !one.passing);
    for (const one of old) one.reject(gone("outdated"));
    return Boolean(this.running?.passing);
  }

  stop() {
    this.worker.terminate();
    for (const one of [this.running, ...this.queue]) one?.reject(gone("stopped"));
    Object.assign(this, { queue: [], running: null });
    this.start();
  }
}
