// A browser with the page in it, and functions that use the page like a visitor.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const { chromium } = createRequire(join(process.env.NODE_PATH, 'x.js'))('playwright-core');
const HERE = dirname(fileURLToPath(import.meta.url));
const SIGHTS = process.env.SIGHTS;

const FLAGS = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
    '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

/** Serves the built page, or the site in `folder`; `plain` = without the headers that isolate it. */
export async function serve(port, plain = false, folder = undefined) {
    const server = spawn('python3', [join(HERE, '../serve'), String(port), ...(folder ? [folder] : []), ...(plain ? ['--plain'] : [])]);
    await once(server.stdout, 'data');
    return { url: `http://localhost:${port}/`, stop: () => server.kill() };
}

export const launch = (profile, options = {}) =>
    chromium.launchPersistentContext(profile, { executablePath: process.env.CHROMIUM, args: FLAGS, headless: true,
        viewport: { width: 1280, height: 800 }, acceptDownloads: true, ...options });

/** Opens the page and waits until the window is there. */
export async function open(context, url) {
    const page = await context.newPage();
    page.problems = [];
    page.on('pageerror', (error) => page.problems.push(String(error.stack ?? error)));
    page.on('console', (message) => {
        if (message.type() === 'error' && !/WebGL|GPU stall|favicon/.test(message.text())) page.problems.push(message.text());
    });
    await page.goto(url, { waitUntil: 'commit' });
    await page.waitForFunction(() => globalThis.dapple || !document.getElementById('failed')?.hidden, null, { timeout: 120000 });
    return page;
}

/** Opens the page without anything kept from earlier visits; `plain` is a file of the host that opens no window. */
export async function begin(context, url, plain) {
    const empty = await context.newPage();
    await empty.goto(plain);
    await empty.evaluate(() => new Promise((done) => {
        const request = indexedDB.deleteDatabase('dapple');
        request.onsuccess = request.onerror = request.onblocked = done;
    }));
    await empty.close();
    const page = await open(context, url);
    const told = await failure(page);
    if (told) throw new Error(told);
    return page;
}

/** The message about a failure; empty without one. */
export const failure = (page) => page.evaluate(() => {
    const shown = document.getElementById('failed');
    return shown.hidden ? '' : shown.innerText;
});

/** The widgets that are shown. */
export async function widgets(page) {
    const rows = await page.evaluate(() => [...dapple.widgets()].map((row) => [...row]));
    return rows.map(([role, name, left, top, right, bottom, enabled]) => ({ role, name, left, top, right, bottom, enabled }));
}

/** Waits for a widget with this name (a text, or an expression) and role. */
export async function widget(page, name, role, timeout = 30000) {
    const fits = (one) => (typeof name === 'string' ? one.name === name : name.test(one.name)) && (!role || one.role === role);
    const end = Date.now() + timeout;
    let all;
    while (Date.now() < end) {
        all = await widgets(page);
        const found = all.find(fits);
        if (found) return found;
        await page.waitForTimeout(50);
    }
    throw new Error(`no widget ${name}; there are ${all.map((one) => `${one.role} ${one.name}`).join(' | ')}`);
}

const middle = (one) => [(one.left + one.right) / 2, (one.top + one.bottom) / 2];

export async function click(page, name, role) {
    const found = await widget(page, name, role);
    await page.mouse.click(...middle(found));
    await settled(page);
    return found;
}

/** Two frames later. */
export const settled = (page) =>
    page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 60)))));

/** The canvas on which marks are drawn. */
export const canvas = (page) => widget(page, /^Sketch canvas/);
export const marks = async (page) => Number((await canvas(page)).name.match(/(\d+) mark/)[1]);

/** Draws a closed stroke round a place, given as shares of the canvas. */
export async function drawSpot(page, [x, y], radius = 12) {
    const { left, top, right, bottom } = await canvas(page);
    const [cx, cy] = [left + x * (right - left), top + y * (bottom - top)];
    const at = (step) => [cx + radius * 1.6 * Math.cos(step), cy + radius * Math.sin(step)];
    await page.mouse.move(...at(0));
    await page.mouse.down();
    for (let step = 1; step <= 16; step++) await page.mouse.move(...at(step / 16 * 2 * Math.PI));
    await page.mouse.up();
    await settled(page);
}

/** Gives the page a file as if it was dropped (`drop`) or pasted (`paste`). */
export const give = (page, how, file, type) => page.evaluate(([how, name, type, text]) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const data = new DataTransfer();
    data.items.add(new File([bytes], name, { type }));
    const event = how === 'drop' ? new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true })
        : new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true });
    document.getElementById('window').dispatchEvent(event);
}, [how, file.split('/').pop(), type, readFileSync(file).toString('base64')]);

/** Chooses a file in the dialog that an entry of a menu opens; without a menu, a button. */
export async function choose(page, menu, entry, file) {
    const chooser = page.waitForEvent('filechooser');
    if (menu) await click(page, menu, 'Button');
    await click(page, entry, 'Button');
    await (await chooser).setFiles(file);
}

/** What is in the database of the page: paths and texts. */
export const kept = (page) => page.evaluate(() => new Promise((done) => {
    indexedDB.open('dapple').onsuccess = ({ target: { result } }) => {
        result.transaction('kept').objectStore('kept').getAll().onsuccess = (event) => {
            done(event.target.result.map(({ path, bytes }) => [path, new TextDecoder().decode(bytes)]));
            result.close();
        };
    };
}));

/** Waits until the growth is over. */
export const grown = (page) => widget(page, 'Texture, finished', undefined, 180000);

/** The file that is downloaded while `act` runs: its name and its bytes. */
export async function downloaded(page, act, timeout = 60000) {
    const [download] = await Promise.all([page.waitForEvent('download', { timeout }), act()]);
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

/** Saves the document under the name that is suggested. */
export const saved = (page) => downloaded(page, async () => {
    await click(page, 'File', 'Button');
    await click(page, /^Save as…/, 'Button');
    await click(page, 'Save', 'Button');
});

/** Waits until a condition holds. */
export async function until(what, condition, timeout = 60000) {
    const end = Date.now() + timeout;
    for (;;) {
        const value = await condition();
        if (value) return value;
        if (Date.now() > end) throw new Error(`not in time: ${what}`);
        await new Promise((done) => setTimeout(done, 100));
    }
}

/** Saves a screenshot of the page, for people to look at. */
export async function sight(page, name) {
    if (!SIGHTS) return;
    mkdirSync(SIGHTS, { recursive: true });
    await page.screenshot({ path: join(SIGHTS, `${name}.png`) });
}
