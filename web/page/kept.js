// What is kept from one visit to the next: settings, and unsaved work. Each record says which tab has written it; the unsaved work of a
// tab that is open is left to it.
import { withdraw, warn, words } from './words.js';

const TAB = crypto.randomUUID();
const lockOf = (tab) => `dapple-tab-${tab}`;
const RECOVERY = '/kept/recovery/';
/** How long the database may take to answer, ms. */
const PATIENCE = 4000;
/** How often what has changed is looked for, ms. */
const OFTEN = 100;
/** When writing is tried again after it has failed, ms. */
const AGAIN = 2000;

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
            result.onclose = () => { opened = undefined; };
            return result;
        });
    })();
    // It is tried again.
    opened.catch(() => { opened = undefined; });
    return opened;
}

const begun = async (mode) => (await database()).transaction('kept', mode, { durability: 'strict' });

/** What is done, unless the database does not answer. */
const inTime = (done) => Promise.race([done, new Promise((_, failed) => {
    setTimeout(() => failed(new Error('the database does not answer')), PATIENCE);
})]);

/** Puts back what was kept, before the window is opened; it does not wait for ever for a database that does not answer. */
export async function restore(dapple) {
    try {
        await inTime(putBack(dapple));
    } catch (error) {
        warn(words.forgotten, error);
    }
}

async function putBack(dapple) {
    // Held until this tab is gone, however it goes.
    navigator.locks.request(lockOf(TAB), () => new Promise(() => {}));
    const held = new Set((await navigator.locks.query()).held.map((lock) => lock.name));
    const records = await asPromise((await begun('readonly')).objectStore('kept').getAll());
    for (const { path, bytes, tab } of records) {
        if (!path.startsWith(RECOVERY) || !held.has(lockOf(tab))) dapple.keep(path, bytes);
    }
    navigator.storage?.persist?.();
}

/** What has changed and is not in the database yet: by path its bytes, or nothing where it is to be deleted. */
const pending = new Map();

/** Writes what is pending, and waits until it is there, whole. */
async function write(changes) {
    const transaction = await begun('readwrite');
    const complete = new Promise((done, failed) => {
        transaction.oncomplete = done;
        transaction.onabort = () => failed(transaction.error ?? new Error('the browser has stopped it'));
    });
    const kept = transaction.objectStore('kept');
    for (const [path, bytes] of changes) {
        if (bytes) kept.put({ path, bytes, tab: TAB });
        else kept.delete(path);
    }
    await complete;
}

/** Keeps what has changed, a few times a second. What cannot be written stays pending, which is said. */
export function keepChanges(dapple) {
    let isBusy = false;
    let next = 0;
    const keep = async () => {
        for (const [path, bytes] of dapple.take_changed()) pending.set(path, bytes);
        if (isBusy || pending.size === 0 || performance.now() < next) return;
        isBusy = true;
        const changes = [...pending];
        try {
            await inTime(write(changes));
            // What has changed again meanwhile stays.
            for (const [path, bytes] of changes) if (pending.get(path) === bytes) pending.delete(path);
            withdraw(words.unkept);
        } catch (error) {
            next = performance.now() + AGAIN;
            warn(words.unkept, error);
        }
        isBusy = false;
    };
    setInterval(keep, OFTEN);
    addEventListener('visibilitychange', keep);
    addEventListener('pagehide', keep);
}

/** The document of the newest unsaved work of this tab. */
export async function drawn() {
    // Where the database fails, it is pending.
    const kept = begun('readonly').then((transaction) => asPromise(transaction.objectStore('kept').getAll())).catch(() => []);
    const files = new Map((await kept).filter(({ tab }) => tab === TAB).map(({ path, bytes }) => [path, bytes]));
    for (const [path, bytes] of pending) files.set(path, bytes);
    const own = [...files].filter(([path, bytes]) => bytes && path.startsWith(RECOVERY) && path.endsWith('.dapple'));
    const [, newest] = own.sort(([a], [b]) => (a < b ? -1 : 1)).at(-1) ?? [];
    const text = newest && new TextDecoder().decode(newest);
    // Before the document stand two lines and an empty one.
    return text && text.slice(text.indexOf('\n\n') + 2);
}
