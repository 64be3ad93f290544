// All files of the site are kept at the first visit, Typst's at the first PDF; after it the page needs no network. A new site is a new cache.
const CACHE = "rbpsym-studio-VERSION", FILES = ["./", LIST];
self.addEventListener("install", (event) => event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(FILES)).then(() => self.skipWaiting())));
self.addEventListener("activate", (event) => event.waitUntil((async () => {
  for (const name of await caches.keys()) if (name.startsWith("rbpsym-studio-") && name !== CACHE && name !== "rbpsym-studio-snapshot") await caches.delete(name);
  await self.clients.claim();
})()));
self.addEventListener("fetch", (event) => {
  const url = new URL(event.request.url);
  if (event.request.method !== "GET" || url.origin !== self.location.origin) return;
  event.respondWith(caches.open(CACHE).then((cache) => cache.match(event.request, { ignoreSearch: true })).then((found) => found || fetched(event.request, url)));
});
async function fetched(request, url) {
  const answer = await fetch(request);
  if (answer.ok && url.pathname.includes("/typst/")) await (await caches.open(CACHE)).put(request, answer.clone());
  return answer;
}
