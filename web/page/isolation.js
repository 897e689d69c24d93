// Threads need a page that is isolated from other sites. Where the host does not send the headers, the service worker adds them
// after one reload.
import { failing, words } from './words.js';

const TRIED = 'dapple-isolation-tried';
/** How long a service worker may take to begin, ms. */
const PATIENCE = 10000;

async function registered() {
    await navigator.serviceWorker.register(new URL('../sw.js', import.meta.url));
    await navigator.serviceWorker.ready;
}

/** Whether the page is isolated; else it is being reloaded, or it says why not. */
export async function isolated() {
    if (globalThis.crossOriginIsolated) {
        sessionStorage.removeItem(TRIED);
        return true;
    }
    if (!sessionStorage.getItem(TRIED) && globalThis.isSecureContext && 'serviceWorker' in navigator) {
        sessionStorage.setItem(TRIED, '1');
        try {
            await Promise.race([registered(), new Promise((_, failed) => setTimeout(failed, PATIENCE))]);
            location.reload();
            return false;
        } catch { /* told below */ }
    }
    failing(words.isolation, '');
    return false;
}
