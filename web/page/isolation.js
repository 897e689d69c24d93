// Threads need a page that is isolated from other sites. Where the host does not send the headers, the service worker adds them
// after one reload.
import { failing, words } from './words.js';

const TRIED = 'dapple-isolation-tried';

/** Whether the page is isolated; else it is being reloaded, or it says why not. */
export async function isolated() {
    if (globalThis.crossOriginIsolated) {
        sessionStorage.removeItem(TRIED);
        return true;
    }
    if (!sessionStorage.getItem(TRIED) && globalThis.isSecureContext && 'serviceWorker' in navigator) {
        sessionStorage.setItem(TRIED, '1');
        try {
            await navigator.serviceWorker.register(new URL('../sw.js', import.meta.url));
            await navigator.serviceWorker.ready;
            location.reload();
            return false;
        } catch { /* told below */ }
    }
    failing(words.isolation, '');
    return false;
}
