// Threads need a page that is isolated from other sites. Where the host does not send the headers for that, the service worker adds
// them after one reload.
import { failing, words } from './words.js';

const TRIED = 'dapple-isolation-tried';
/** The longest time that a service worker may take to start, ms. */
const PATIENCE = 10000;

async function registered() {
    await navigator.serviceWorker.register(new URL('../sw.js', import.meta.url));
    await navigator.serviceWorker.ready;
}

/** Whether the page is isolated. If it is not, the page is being reloaded, or shows the reason. */
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
        } catch { /* shown below */ }
    }
    failing(words.isolation, '');
    return false;
}
