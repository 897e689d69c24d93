// What is kept from one visit to the next: settings, and unsaved work. Each record says which tab has written it; the unsaved work of a
// tab that is open is left to it.

const TAB = crypto.randomUUID();
const lockOf = (tab) => `dapple-tab-${tab}`;
const RECOVERY = '/kept/recovery/';
/** How long the database may take to answer at the start, ms. */
const PATIENCE = 4000;

const asPromise = (request) => new Promise((done, failed) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => failed(request.error);
});

let opened;
function database() {
    opened ??= (() => {
        const request = indexedDB.open('dapple', 1);
        request.onupgradeneeded = () => request.result.createObjectStore('kept', { keyPath: 'path' });
        return asPromise(request).then((result) => {
            // Another tab deletes or renews it: that one must not wait for this.
            result.onversionchange = () => {
                result.close();
                opened = undefined;
            };
            return result;
        });
    })();
    return opened;
}

async function store(mode) {
    return (await database()).transaction('kept', mode, { durability: 'strict' }).objectStore('kept');
}

/** Puts back what was kept, before the window is opened; it does not wait for ever for a database that does not answer. */
export async function restore(dapple) {
    const late = new Promise((_, failed) => setTimeout(() => failed(new Error('the database does not answer')), PATIENCE));
    try {
        await Promise.race([putBack(dapple), late]);
    } catch (error) {
        console.warn('Nothing can be kept from one visit to the next:', error);
    }
}

async function putBack(dapple) {
    // Held until this tab is gone, however it goes.
    navigator.locks.request(lockOf(TAB), () => new Promise(() => {}));
    const held = new Set((await navigator.locks.query()).held.map((lock) => lock.name));
    const records = await asPromise((await store('readonly')).getAll());
    for (const { path, bytes, tab } of records) {
        if (!path.startsWith(RECOVERY) || !held.has(lockOf(tab))) dapple.keep(path, bytes);
    }
    navigator.storage?.persist?.();
}

/** Keeps what has changed, a few times a second. */
export function keepChanges(dapple) {
    let isBusy = false;
    const keep = async () => {
        if (isBusy) return;
        isBusy = true;
        try {
            const changed = dapple.take_changed();
            if (changed.length > 0) {
                const kept = await store('readwrite');
                for (const [path, bytes] of changed) {
                    if (bytes) kept.put({ path, bytes, tab: TAB });
                    else kept.delete(path);
                }
            }
        } catch (error) {
            console.warn('Unsaved work cannot be kept:', error);
        }
        isBusy = false;
    };
    setInterval(keep, 100);
    addEventListener('visibilitychange', keep);
    addEventListener('pagehide', keep);
}

/** The document of the newest unsaved work of this tab. */
export async function drawn() {
    const records = await asPromise((await store('readonly')).getAll());
    const own = records.filter(({ path, tab }) => tab === TAB && path.startsWith(RECOVERY) && path.endsWith('.dapple')).sort((a, b) => (a.path < b.path ? -1 : 1));
    const text = own.length && new TextDecoder().decode(own.at(-1).bytes);
    // Before the document stand two lines and an empty one.
    return text && text.slice(text.indexOf('\n\n') + 2);
}
