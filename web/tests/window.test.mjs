// The window as visitors use it.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, afterEach, before, test } from 'node:test';
import {
    begin, canvas, click, downloaded, drawSpot, failure, grown, launch, marks, open, saved, serve, settled, sight, until, widget, widgets,
} from './browser.mjs';

const PORT = 8231;
const ROOT = new URL('../..', import.meta.url).pathname;
const profile = mkdtempSync(join(tmpdir(), 'dapple-profile-'));
let server;
let context;

before(async () => {
    server = await serve(PORT);
    context = await launch(profile);
});
after(async () => {
    await context?.close();
    server?.stop();
    rmSync(profile, { recursive: true, force: true });
});

afterEach(async () => {
    for (const page of context.pages().slice(1)) await page.close();
});

const PLACES = [[0.3, 0.35], [0.6, 0.4], [0.45, 0.65]];

/** The page with nothing kept from before. */
const fresh = () => begin(context, `${server.url}?test`, `${server.url}sw.js`);

/** Ends a test: nothing has failed. */
async function close(page) {
    console.log(`longest frame without painting: ${(await page.evaluate(() => dapple.longest_frame())).toFixed(0)} ms`);
    assert.equal(await failure(page), '');
    assert.deepEqual(page.problems, []);
    await page.close();
}

test('marks drawn by the pointer grow, and undo takes them back', async () => {
    const page = await fresh();
    await sight(page, 'empty');
    for (const place of PLACES) await drawSpot(page, place);
    assert.equal(await marks(page), 3);
    await grown(page);
    await sight(page, 'grown');
    await click(page, 'Undo', 'Button');
    assert.equal(await marks(page), 2);
    await click(page, 'Redo', 'Button');
    assert.equal(await marks(page), 3);
    await close(page);
});

test('each menu entry can be clicked', async () => {
    const page = await fresh();
    page.on('filechooser', () => {});
    const clicked = [];
    const never = new Set();
    const entries = async (menu) => {
        const before = await widgets(page);
        await click(page, menu, 'Button');
        const is = (one) => (other) => one.name === other.name && one.top === other.top;
        return (await widgets(page)).filter((one) => /Button|CheckBox|Radio/.test(one.role) && one.name && !before.some(is(one)));
    };
    const shut = async () => {
        for (let times = 0; times < 3; times++) {
            await page.keyboard.press('Escape');
            await settled(page);
        }
    };
    for (const menu of ['File', 'Edit', 'Layer', 'View', 'Growth', 'Help']) {
        const names = (await entries(menu)).map((entry) => entry.name);
        assert.ok(names.length >= 3, `${menu}: ${names}`);
        await shut();
        for (const name of names) {
            // Entries that need marks find some, selected.
            if (await marks(page).catch(() => 0) < 2) {
                for (const place of PLACES) await drawSpot(page, place);
                await grown(page);
            }
            if (menu === 'Edit') await page.keyboard.press('Control+A');
            const entry = (await entries(menu)).find((one) => one.name.split('\n')[0] === name.split('\n')[0]);
            if (entry?.enabled) {
                await page.mouse.click((entry.left + entry.right) / 2, (entry.top + entry.bottom) / 2);
                await settled(page);
                clicked.push(name);
            } else {
                never.add(`${menu}: ${name}`);
            }
            assert.equal(await failure(page), '', `${menu}: ${name}`);
            assert.deepEqual(page.problems, [], `${menu}: ${name}`);
            await shut();
        }
    }
    await sight(page, 'after-all-menus');
    console.log(`clicked ${clicked.length}; not possible just then: ${[...never].join(', ')}`);
    assert.ok(clicked.length >= 40, `${clicked.length}: ${clicked}`);
    await page.close();
});

test('every kind of export is a download, a material as a ZIP', async () => {
    const page = await fresh();
    for (const place of PLACES) await drawSpot(page, place);
    await grown(page);
    const begins = { Picture: '\x89PNG', Material: 'PK\x03\x04', Outlines: '<', Film: 'GIF8' };
    for (const [kind, beginning] of Object.entries(begins)) {
        await click(page, 'File', 'Button');
        await click(page, /^Export…/, 'Button');
        await click(page, kind, 'Button');
        await settled(page);
        // Its preview has been made, and it is none that the browser cannot make.
        if (kind !== 'Film') {
            await until('the preview is made', async () => !(await widgets(page)).some((one) => one.role === 'ProgressIndicator'), 120000);
            await settled(page);
        }
        await sight(page, `export-${kind.toLowerCase()}`);
        assert.ok(!(await widgets(page)).some((one) => /not supported/.test(one.name)), kind);
        const { name, bytes } = await downloaded(page, async () => {
            await click(page, 'Export…', 'Button');
            await click(page, 'Export', 'Button');
        }, 180000);
        console.log(`${name}: ${bytes.length} bytes`);
        assert.equal(bytes.toString('latin1', 0, beginning.length), beginning, name);
        if (kind === 'Material') {
            const text = bytes.toString('latin1');
            for (const part of ['untitled-material/', '_Height.png', '_NormalGL.png', '.gltf']) assert.ok(text.includes(part), part);
        }
        await until('it is said', async () => (await widgets(page)).some((one) => one.name.startsWith('Written: ')));
    }
    await close(page);
});

test('a document is saved and opened again by the dialog, by dropping and by pasting', async () => {
    const page = await fresh();
    for (const place of PLACES) await drawSpot(page, place);
    const { name, bytes } = await saved(page);
    assert.equal(name, 'untitled.dapple');
    const document = JSON.parse(bytes);
    assert.equal(document.layers[0].strokes.length, 3);
    await close(page);

    const other = await fresh();
    const chooser = other.waitForEvent('filechooser');
    await click(other, 'File', 'Button');
    await click(other, /^Open…/, 'Button');
    await (await chooser).setFiles(join(ROOT, 'examples/zebra.dapple'));
    await until('it is open', async () => (await marks(other)) > 3);
    await grown(other);
    await sight(other, 'opened');
    const give = (how, file, type) => other.evaluate(([how, file, type, text]) => {
        const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
        const data = new DataTransfer();
        data.items.add(new File([bytes], file, { type }));
        const event = how === 'drop' ? new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true })
            : new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true });
        document.getElementById('window').dispatchEvent(event);
    }, [how, file.split('/').pop(), type, readFileSync(join(ROOT, file)).toString('base64')]);
    await give('drop', 'examples/cheetah-run.dapple', '');
    await until('the dropped document is open', async () => (await widgets(other)).some((one) => one.name === 'cheetah-run.dapple'));
    await give('paste', 'assets/examples/zebra.png', 'image/png');
    await widget(other, /^What is zebra\.png for/);
    await sight(other, 'pasted');
    await click(other, 'Reference picture', 'Button');
    await close(other);
});

test('what was drawn comes back after the tab was killed', async () => {
    const page = await fresh();
    for (const place of PLACES) await drawSpot(page, place);
    await click(page, 'View', 'Button');
    await click(page, 'Dark theme');
    const kept = () => page.evaluate(() => new Promise((done) => {
        indexedDB.open('dapple').onsuccess = ({ target: { result } }) => {
            result.transaction('kept').objectStore('kept').getAll().onsuccess = (event) => {
                done(event.target.result.map(({ path, bytes }) => [path, new TextDecoder().decode(bytes)]));
                result.close();
            };
        };
    }));
    await until('it is kept', async () => {
        const files = await kept();
        const work = files.find(([path]) => path.endsWith('.dapple'))?.[1] ?? '';
        const strokes = work && JSON.parse(work.slice(work.indexOf('\n\n'))).layers[0].strokes.length;
        return strokes === 3 && files.some(([path, text]) => path.endsWith('settings') && text.includes('dark'));
    });
    const cdp = await context.newCDPSession(page);
    const crashed = page.waitForEvent('crash');
    cdp.send('Page.crash').catch(() => {});
    await crashed;
    await page.close();

    const again = await open(context, `${server.url}?test`);
    await widget(again, 'Unsaved work was found');
    await sight(again, 'recovery');
    await click(again, 'Restore', 'Button');
    assert.equal(await marks(again), 3);
    await grown(again);
    await sight(again, 'restored-dark');
    await close(again);
});

test('a tab that is open keeps its work to itself', async () => {
    const page = await fresh();
    await drawSpot(page, [0.5, 0.5]);
    await until('it is kept', () => page.evaluate(() => new Promise((done) => {
        indexedDB.open('dapple').onsuccess = ({ target: { result } }) => {
            result.transaction('kept').objectStore('kept').count().onsuccess = (event) => {
                done(event.target.result > 0);
                result.close();
            };
        };
    })));
    const other = await open(context, `${server.url}?test`);
    await settled(other);
    assert.ok(!(await widgets(other)).some((one) => one.name === 'Unsaved work was found'));
    await close(other);
    await close(page);
});

for (const [where, onPage] of [['a worker', false], ['the page', true]]) {
    test(`a failure in ${where} is told in words, and what was drawn can be saved`, async () => {
        const page = await fresh();
        for (const place of PLACES) await drawSpot(page, place);
        await grown(page);
        await page.evaluate((onPage) => { try { dapple.fail(onPage); } catch { /* that is the test */ } }, onPage);
        await until('it is told', () => failure(page));
        const told = await failure(page);
        assert.match(told, /What you have drawn is kept/);
        assert.match(told, /a test lets this thread fail/);
        await sight(page, `failed-${onPage ? 'page' : 'worker'}`);
        let bytes;
        await until('all of it is there', async () => {
            ({ bytes } = await downloaded(page, () => page.click('#rescue')));
            return JSON.parse(bytes).layers[0].strokes.length === 3;
        });
        await page.click('#again');
        await page.waitForFunction(() => globalThis.dapple);
        await widget(page, 'Unsaved work was found');
        await page.close();
    });
}

test('a canvas that does not fit into memory is refused in words', async () => {
    // 512 MB.
    const page = await begin(context, `${server.url}?test&memory=8192`, `${server.url}sw.js`);
    const chooser = page.waitForEvent('filechooser');
    await click(page, 'File', 'Button');
    await click(page, /^Open…/, 'Button');
    const document = JSON.parse(readFileSync(join(ROOT, 'examples/cheetah-run.dapple'), 'utf8'));
    document.size = [8192, 8192];
    await (await chooser).setFiles({ name: 'large.dapple', mimeType: '', buffer: Buffer.from(JSON.stringify(document)) });
    await widget(page, 'This cannot be grown', undefined, 60000);
    await sight(page, 'refused');
    const why = (await widgets(page)).find((one) => /memory|GB|MB/.test(one.name));
    console.log(why?.name);
    assert.ok(why);
    await close(page);
});

test('the pressure of a pen sets the width', async () => {
    const page = await fresh();
    const { left, top, right, bottom } = await canvas(page);
    const cdp = await context.newCDPSession(page);
    const stroke = async (force, y) => {
        const at = (share) => ({
            x: left + (right - left) * share, y: top + (bottom - top) * y, pointerType: 'pen', force, button: 'left', buttons: 1,
        });
        await cdp.send('Input.dispatchMouseEvent', { type: 'mousePressed', clickCount: 1, ...at(0.3) });
        for (let share = 0.32; share < 0.7; share += 0.02) await cdp.send('Input.dispatchMouseEvent', { type: 'mouseMoved', ...at(share) });
        await cdp.send('Input.dispatchMouseEvent', { type: 'mouseReleased', clickCount: 1, ...at(0.7) });
        await settled(page);
    };
    await stroke(0.95, 0.35);
    await stroke(0.05, 0.65);
    const [hard, soft] = JSON.parse((await saved(page)).bytes).layers[0].strokes.map((line) => line.width);
    assert.ok(hard > 2 * soft, `${hard} ${soft}`);
    await close(page);
});

test('examples, photographs and alternatives', async () => {
    const page = await fresh();
    await click(page, 'File', 'Button');
    await click(page, /^Examples…/, 'Button');
    await widget(page, 'Example: Zebra', 'Button');
    await sight(page, 'examples');
    await click(page, 'Example: Zebra', 'Button');
    assert.ok(await marks(page) > 3);
    await grown(page);
    await click(page, 'Alternatives', 'Button');
    await widget(page, /^Use Seed/, undefined, 120000);
    await sight(page, 'alternatives');
    await click(page, 'Alternatives', 'Button');
    const chooser = page.waitForEvent('filechooser');
    await click(page, 'File', 'Button');
    await click(page, /^Import a photograph…/, 'Button');
    await (await chooser).setFiles(join(ROOT, 'assets/drawn-spots.jpg'));
    // It is a table of many pictures, which is doubted.
    await widget(page, 'Take it anyway', 'CheckBox', 120000);
    await sight(page, 'photograph');
    await click(page, 'Take it anyway', 'CheckBox');
    await until('the sketch is found', async () =>
        (await widgets(page)).some((one) => one.name === 'Open the sketch' && one.role === 'Button' && one.enabled), 120000);
    await click(page, 'Open the sketch', 'Button');
    await until('it is open', async () => !(await widgets(page)).some((one) => one.name === 'Open the sketch'));
    assert.ok(await marks(page) > 10);
    await close(page);
});
