// The page without a network: a service worker that keeps all its files after the first visit. wasm/page/make writes two constants
// before this: kFiles, by file the SHA-256, and kVersion, that of all. Another version is another worker, which waits until nobody has the page open:
// the parts of the module of two versions do not fit together.

const kName = `epsnet ${registration.scope} `, kCache = kName + kVersion;
const integrity = hex => 'sha256-' + btoa(String.fromCharCode(...hex.match(/../g).map(byte => parseInt(byte, 16))));

async function install() {
  const cache = await caches.open(kCache);
  await Promise.all(Object.entries(kFiles).map(async ([file, hex]) => {
    const response = await fetch(file, {cache: 'no-cache', integrity: integrity(hex)});
    if (!response.ok) throw new Error(`${file}: ${response.status}`);
    await cache.put(file, response);
  }));
}
async function activate() {
  const old = (await caches.keys()).filter(name => name.startsWith(kName) && name !== kCache);
  await Promise.all(old.map(name => caches.delete(name)));
  if (old.length === 0) await clients.claim();
}
async function answer(request, file) {
  const cache = await caches.open(kCache);
  return await cache.match(file) ?? fetch(request);
}

addEventListener('install', event => event.waitUntil(install()));
addEventListener('activate', event => event.waitUntil(activate()));
addEventListener('fetch', event => {
  const {request} = event, [address] = request.url.split(/[?#]/);
  if (request.method !== 'GET' || !address.startsWith(registration.scope)) return;
  const file = address.slice(registration.scope.length) || 'index.html';
  if (Object.hasOwn(kFiles, file)) event.respondWith(answer(request, file));
});
