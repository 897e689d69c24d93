// What is kept from one visit to the next: settings, and unsaved work. Each record names the tab that wrote it. The
// unsaved work of a tab that is still open belongs to that tab.
import { withdraw, warn, words } from './words.js';

const TAB = crypto.randomUUID();
const lockOf = (tab) => `dapple-tab-${tab}`;
const RECOVERY = '/kept/recovery/';
/** The longest time that the database may take to answer, ms. */
const PATIENCE = 4000;
/** The time between two checks for changes, ms. */
const OFTEN = 100;
/** The time after which a failed write is tried again, ms. */
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
            // Another tab deletes or upgrades the database. It must not have to wait for this tab.
            result.onversionchange = () => {
                result.close();
                opened = undefined;
            };
            result.onclose = () => { opened = undefined; };
            return result;
        });
    })();
    // The next call tries again.
    opened.catch(() => { opened = undefined; });
    return opened;
}

const begun = async (mode) => (await database()).transaction('kept', mode, { durability: 'strict' });

/** The result of `done`, or an error where the database does not answer in time. */
const inTime = (done) => Promise.race([done, new Promise((_, failed) => {
    setTimeout(() => failed(new Error('the database does not answer')), PATIENCE);
})]);

/** Restores the kept files, before the window is opened. It stops waiting where the database does not answer. */
export async function restore(dapple) {
    try {
        await inTime(putBack(dapple));
    } catch (error) {
        warn(words.forgotten, error);
    }
}

async function putBack(dapple) {
    // The lock is held until this tab is closed or crashes.
    navigator.locks.request(lockOf(TAB), () => new Promise(() => {}));
    const held = new Set((await navigator.locks.query()).held.map((lock) => lock.name));
    const records = await asPromise((await begun('readonly')).objectStore('kept').getAll());
    for (const { path, bytes, tab } of records) {
        if (!path.startsWith(RECOVERY) || !held.has(lockOf(tab))) dapple.keep(path, bytes);
    }
    navigator.storage?.persist?.();
}

/** Changes that are not in the database yet: for each path the bytes, or nothing where the file is to be deleted. */
const pending = new Map();

/** Writes changes to the database, and waits until all of them are stored. */
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

/** Stores changes several times a second. Changes that cannot be written stay pending, and the visitor is told. */
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
            // Files that have changed again meanwhile stay pending.
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
    // Where the database fails, the unsaved work is pending.
    const kept = begun('readonly').then((transaction) => asPromise(transaction.objectStore('kept').getAll())).catch(() => []);
    const files = new Map((await kept).filter(({ tab }) => tab === TAB).map(({ path, bytes }) => [path, bytes]));
    for (const [path, bytes] of pending) files.set(path, bytes);
    const own = [...files].filter(([path, bytes]) => bytes && path.startsWith(RECOVERY) && path.endsWith('.dapple'));
    const [, newest] = own.sort(([a], [b]) => (a < b ? -1 : 1)).at(-1) ?? [];
    const text = newest && new TextDecoder().decode(newest);
    // Two lines and an empty line precede the document.
    return text && text.slice(text.indexOf('\n\n') + 2);
}
