// What stands behind the # of the address: p (a statement, deflated, in base64url) or n (a problem of the library), tab, lang,
// detail, only (one panel without the rest, for a frame), beside (a
// problem of the library that moves beside it in the explorer); what else there is belongs to the explorer (numbers, t).
const OWN = ["p", "n", "tab", "lang", "detail", "only", "beside"];
const through = async (bytes, stream) => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

export async function packed(text) {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  return btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

export async function unpacked(code) {
  const bytes = Uint8Array.from(atob(code.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
  return new TextDecoder("utf-8", { fatal: true }).decode(await through(bytes, new DecompressionStream("deflate-raw")));
}

export const wanted = () => new URLSearchParams(location.hash.slice(1));

/** The part of the address that the explorer reads. */
export function forExplorer() {
  const rest = wanted();
  for (const key of OWN) rest.delete(key);
  return rest.toString();
}

/** The same address with the numbers of the explorer that are not those of the example, and no others. */
export function withNumbers(own) {
  const kept = wanted();
  return address({ ...Object.fromEntries([...kept.keys()].filter((key) => !OWN.includes(key)).map((key) => [key, null])), ...own });
}

/** The same address with other values; what is null is taken out. */
export function address(values) {
  const keys = wanted();
  for (const [key, value] of Object.entries(values)) if (value === null || value === undefined) keys.delete(key); else keys.set(key, value);
  return location.href.split("#")[0] + "#" + keys;
}
