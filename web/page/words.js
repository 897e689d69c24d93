// What the page says before the window is there, and when something fails.

export const words = {
    start: ['dapple could not be opened', 'The browser needs WebAssembly with threads (Chrome 91, Firefox 89, Safari 16.4 or newer) and WebGL.'],
    isolation: ['This page has no threads', 'Browsers give them to isolated pages only. The host must send the headers ' +
        '"Cross-Origin-Opener-Policy: same-origin" and "Cross-Origin-Embedder-Policy: require-corp", or the page must be opened by ' +
        'https or from localhost in a window that is not private, so that its service worker can add them. In a frame, the page ' +
        'around it has to send them as well.'],
    page: ['An error in dapple has stopped the window', 'What you have drawn is kept: reload the page to go on. Please report the error.'],
    forgotten: ['The work of your last visit could not be looked for', 'The browser\'s database did not answer, so settings are the usual ' +
        'ones and unsaved work is not offered. Nothing was deleted: close other tabs of this page and reload it.'],
    unkept: ['What you draw is not being kept', 'The browser does not store it: its storage may be full, or be switched off for this page. ' +
        'Save the document (menu File) before you close the tab. It is tried again every two seconds.'],
    worker: ['An error in dapple has stopped work in the background', 'What you have drawn is kept: reload the page to go on. Please report the error.'],
};

/** When all that was drawn before a failure has been written, ms. */
const WRITTEN = 2500;

const part = (id) => document.getElementById(id);

/** Shows the share of the module that has arrived. */
export function arriving(share) {
    part('share').value = Math.min(share, 1);
    if (share >= 1) part('said').textContent = 'Starting';
}

/** The window is there. */
export function arrived() {
    part('arriving').hidden = true;
}

/** Says in words what the visitor should know while the window goes on. */
export function warn([title, text], details) {
    // A frame in a page of others keeps nothing.
    if (/[?&](embed|view)\b/.test(location.search)) return;
    // What has stopped the window is said alone.
    if (!part('failed').hidden) return;
    const shown = part('warned');
    shown.querySelector('b').textContent = title;
    shown.querySelector('p').textContent = `${text} (${details})`;
    shown.querySelector('button').onclick = () => {
        shown.dataset.seen = title;
        shown.hidden = true;
    };
    // Once it was put away, it is not said again until it was over.
    shown.hidden = shown.dataset.seen === title;
}

/** What was said is over. */
export function withdraw([title]) {
    const shown = part('warned');
    if (shown.dataset.seen === title) delete shown.dataset.seen;
    if (shown.querySelector('b').textContent === title) shown.hidden = true;
}

/** Says in words that something has failed; the first failure is what counts. */
export function failing([title, text], details) {
    const shown = part('failed');
    if (!shown.hidden) return;
    arrived();
    part('warned').hidden = true;
    shown.querySelector('h1').textContent = title;
    shown.querySelector('p').textContent = text;
    shown.querySelector('pre').textContent = details;
    shown.hidden = false;
    part('again').onclick = () => location.reload();
    part('rescue').hidden = !globalThis.dapple;
    const since = performance.now();
    part('rescue').onclick = async () => {
        const { drawn } = await import('./kept.js');
        const { save } = await import('./files.js');
        // Unsaved work is written after a moment.
        await new Promise((done) => setTimeout(done, Math.max(0, WRITTEN - (performance.now() - since))));
        const text = await drawn();
        if (text) save('rescued.dapple', [text]);
        else shown.querySelector('p').textContent = 'Nothing was drawn that could be saved.';
    };
}
