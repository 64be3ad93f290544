// The page inside another page: events go to it, and it may ask. Messages are objects with {rbpsym: 1}; docs/studio.md tells them.
const outside = window.parent !== window;

/** Tells the page around what happened. */
export function tells(event, keys = {}) {
  if (outside) window.parent.postMessage({ rbpsym: 1, event, ...keys }, "*");
}

/** Answers the page around, by the table {do: function(message)}; hears and passes on what the explorer in its frame tells. */
export function listens(doing, frame, hears) {
  addEventListener("message", async ({ data, source }) => {
    if (!data || data.rbpsym !== 1) return;
    if (data.event && source === frame()?.contentWindow) { hears(data); return tells(data.event, { ...data, from: "explorer" }); }
    if (!outside || source !== window.parent || !Object.hasOwn(doing, data.do)) return;
    try { tells("answer", { id: data.id, ok: (await doing[data.do](data)) ?? null }); }
    catch (error) { tells("answer", { id: data.id, error: error.error ?? { what: String(error.message) } }); }
  });
}

/** An element for another page that holds this one. */
export const frameOf = (url, title) => `<iframe src="${url.replaceAll("&", "&amp;")}" title="${title.replaceAll("&", "&amp;").replaceAll('"', "&quot;")}" width="100%" height="640" loading="lazy" allow="clipboard-write"></iframe>`;
