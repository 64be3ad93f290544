// The engine as the page sees it: ask(name, keys) gives a promise; stop() ends what runs and starts anew.
export class Fault extends Error {
  constructor(error) { super(error.what); this.error = error; }
}

export class Engine {
  constructor(url, told) {
    this.url = url; this.told = told; this.number = 0; this.waiting = new Map();
    this.start();
  }

  start() {
    this.worker = new Worker(this.url, { type: "module" });
    this.worker.onmessage = ({ data }) => this.heard(data);
    this.worker.onerror = (event) => this.told({ broken: event.message || "the engine can't be loaded" });
  }

  heard(data) {
    if (data.id === undefined) return this.told(data);
    const { resolve, reject } = this.waiting.get(data.id) ?? {};
    this.waiting.delete(data.id);
    if (!resolve) return;
    if (data.broken) return reject(new Fault({ what: "the engine met a fault of its own: " + data.broken, told: data.broken, line: 0 }));
    const answer = JSON.parse(data.answer);
    if (answer.error) reject(new Fault(answer.error)); else resolve(answer.ok);
  }

  ask(name, keys = {}) {
    const id = ++this.number;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, request: JSON.stringify({ do: name, ...keys }) });
    });
  }

  stop() {
    this.worker.terminate();
    for (const { reject } of this.waiting.values()) reject(new Fault({ what: "stopped", told: "", line: 0 }));
    this.waiting.clear();
    this.start();
  }
}
