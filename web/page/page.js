// Opens the window: the module, its memory, its workers, the files of the last visit.
import init, * as program from './dapple.js';
import { isolated } from './isolation.js';
import { arrived, arriving, failing, words } from './words.js';
import { keepChanges, restore } from './kept.js';
import { serveRequests, takeDropped } from './files.js';
import { followPens } from './pens.js';

const asked = new URLSearchParams(location.search);
const here = new URL('.', import.meta.url);
/** The functions of the program that the page can call. */
let dapple = program;

/** The size of the module before compression, bytes; the build inserts it. */
const SIZE = MODULE_BYTES;

/** A file beside this one. */
async function bytes(name) {
    const response = await fetch(new URL(name, here));
    if (!response.ok) throw new Error(`${name}: ${response.status} ${response.statusText}`);
    return new Uint8Array(await response.arrayBuffer());
}

async function module() {
    const response = await fetch(new URL('dapple.wasm', here));
    if (!response.ok) throw new Error(`dapple.wasm: ${response.status} ${response.statusText}`);
    let bytes = 0;
    const counted = response.body.pipeThrough(new TransformStream({
        transform(chunk, out) {
            arriving((bytes += chunk.length) / SIZE);
            out.enqueue(chunk);
        },
    }));
    return WebAssembly.compileStreaming(new Response(counted, { headers: { 'Content-Type': 'application/wasm' } }));
}

/** As much memory as the browser gives, in pages of 64 KiB: 4 GiB at most. */
function sharedMemory() {
    const wanted = Number(asked.get('memory')) || 65536;
    for (const maximum of [65536, 32768, 16384, 8192].filter((pages) => pages <= wanted)) {
        try {
            return [new WebAssembly.Memory({ initial: 1024, maximum, shared: true }), maximum * 65536];
        } catch { /* try less memory */ }
    }
    throw new Error('the browser gives less than 512 MB of memory');
}

/** Starts workers when there is more work than workers, and keeps a few that wait. */
function workers(compiled, memory) {
    const limit = 48;
    let all = 0, starting = 0;
    const one = () => {
        all++;
        starting++;
        const worker = new Worker(new URL('worker.js', here), { type: 'module' });
        worker.onmessage = ({ data }) => {
            if (data.ready) starting--;
            if (data.failed) failing(words.worker, data.failed);
            if (data.ended) failing(words.worker, data.ended);
        };
        worker.onerror = (event) => failing(words.worker, event.message ?? 'a worker could not be started');
        worker.postMessage({ module: compiled, memory });
    };
    return () => {
        for (let wanted = dapple.workers_wanted() - starting; wanted > 0 && all < limit; wanted--) one();
    };
}

globalThis.dappleFailed = (text) => failing(words.page, text);

// Errors that are not panics of the program.
addEventListener('error', (event) => failing(words.page, String(event.error?.stack ?? event.message)));
addEventListener('unhandledrejection', (event) => failing(words.page, String(event.reason?.stack ?? event.reason)));

/** Does `what` before each frame, and a few times a second where the page is hidden. */
function always(what) {
    let broken = false;
    const guarded = () => {
        if (broken) return;
        try {
            what();
        } catch (error) {
            broken = true;
            failing(words.page, String(error?.stack ?? error));
        }
    };
    const frame = () => {
        guarded();
        requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    setInterval(guarded, 200);
}

async function main() {
    if (!await isolated()) return;
    // Tests measure how long calls take.
    if (asked.has('test')) dapple = (await import('./watch.js')).watched(program);
    const [memory, most] = sharedMemory();
    const compiled = await module();
    // The window opens without the training rows; only the workers wait for them.
    const rows = bytes('rows.pack');
    rows.catch(() => {});
    await init({ module_or_path: compiled, memory });
    dapple.begin(Math.max(1, navigator.hardwareConcurrency ?? 2), most);
    await restore(dapple);
    const canvas = document.getElementById('window');
    await dapple.open_window(canvas, location.href, asked.has('test'));
    // Another link was opened in this tab: the unsaved work is kept for the reloaded page.
    addEventListener('hashchange', () => location.reload());
    arrived();
    takeDropped(dapple, canvas);
    followPens(dapple);
    const startWorkers = workers(compiled, memory);
    const requests = serveRequests(dapple, here);
    always(() => {
        dapple.tick();
        requests();
        startWorkers();
    });
    keepChanges(dapple);
    globalThis.dapple = dapple;
    performance.mark('opened');
    dapple.bring_rows(await rows);
    dapple.open_workers();
    // Fonts with signs and emoji, which the window itself does not use. If they cannot be loaded, the window works without them.
    for (const [name, file, scale] of [['signs', 'NotoEmoji-Regular', 0.81], ['more signs', 'emoji-icon-font', 0.9]]) {
        const font = await bytes(`fonts/${file}.ttf`).catch(() => undefined);
        if (font) dapple.add_font(name, font, scale);
    }
}

main().catch((error) => failing(words.start, String(error?.stack ?? error)));
