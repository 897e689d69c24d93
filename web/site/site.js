// Puts the live sketch in place of its picture. A frame gets threads only where the page around it is isolated from other sites, so
// the service worker of the editor adds the headers that the host does not send; this takes one reload.

const live = document.querySelector('a.live');
const TRIED = 'dapple-front-isolation-tried';

function show() {
    const frame = document.createElement('iframe');
    frame.className = 'live';
    frame.title = live.title;
    frame.allow = 'cross-origin-isolated; clipboard-write';
    frame.src = live.dataset.frame;
    live.replaceWith(frame);
}

async function begin() {
    if (crossOriginIsolated) return show();
    if (!isSecureContext || !navigator.serviceWorker || sessionStorage.getItem(TRIED)) return;
    const worker = await fetch('sw.js', { method: 'HEAD' });
    if (!worker.ok) return;
    sessionStorage.setItem(TRIED, '1');
    await navigator.serviceWorker.register('sw.js');
    await navigator.serviceWorker.ready;
    location.reload();
}

// On a small screen, or where data are saved, the editor opens when the picture is touched.
if (live && matchMedia('(min-width: 48rem)').matches && !navigator.connection?.saveData) begin();
