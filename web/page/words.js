// The texts of the page before the window is open, and when something fails.

export const words = {
    start: ['dapple could not be opened', 'The browser needs WebAssembly with threads (Chrome 91, Firefox 89, Safari 16.4 or newer) and WebGL.'],
    isolation: ['This page cannot run dapple', 'dapple needs threads, which browsers allow only in isolated pages. The host must send the ' +
        'headers "Cross-Origin-Opener-Policy: same-origin" and "Cross-Origin-Embedder-Policy: require-corp", or the page must be opened by ' +
        'https or from localhost in a window that is not private, so that its service worker can add them. In a frame, the page ' +
        'around it has to send them as well.'],
    page: ['An error in dapple has stopped the window', 'Your drawing is kept: reload the page to continue. Please report the error.'],
    forgotten: ['Your work from the last visit could not be read', 'The browser\'s database did not answer, so default settings are ' +
        'used and unsaved work is not offered. Nothing was deleted: close other tabs of this page and reload it.'],
    unkept: ['Your drawing is not being backed up', 'The browser does not store it: its storage may be full, or switched off for this page. ' +
        'Save the document (menu File) before you close the tab. dapple tries again every two seconds.'],
    worker: ['An error in dapple has stopped growing and exporting', 'Your drawing is kept: reload the page to continue. Please report the error.'],
};

/** The time after a failure until everything that was drawn before it is stored, ms. */
const WRITTEN = 2500;

const part = (id) => document.getElementById(id);

/** Shows the share of the module that has arrived. */
export function arriving(share) {
    part('share').value = Math.min(share, 1);
    if (share >= 1) part('said').textContent = 'Starting';
}

/** Hides the progress bar, because the window is open. */
export function arrived() {
    part('arriving').hidden = true;
}

/** Shows a warning while the window continues to work. */
export function warn([title, text], details) {
    // A window that is embedded in another page keeps nothing.
    if (/[?&](embed|view)\b/.test(location.search)) return;
    // A failure that has stopped the window is the only message.
    if (!part('failed').hidden) return;
    const shown = part('warned');
    shown.querySelector('b').textContent = title;
    shown.querySelector('p').textContent = `${text} (${details})`;
    shown.querySelector('button').onclick = () => {
        shown.dataset.seen = title;
        shown.hidden = true;
    };
    // A warning that the visitor has closed is not shown again until its cause has ended.
    shown.hidden = shown.dataset.seen === title;
}

/** Withdraws a warning, because its cause has ended. */
export function withdraw([title]) {
    const shown = part('warned');
    if (shown.dataset.seen === title) delete shown.dataset.seen;
    if (shown.querySelector('b').textContent === title) shown.hidden = true;
}

/** Shows that something has failed. Only the first failure is shown. */
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
