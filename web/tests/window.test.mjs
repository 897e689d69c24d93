// The window as visitors use it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import {
    canvas, choose, click, downloaded, drawSpot, failure, give, grown, marks, saved, settled, sight, until, widget, widgets,
} from './browser.mjs';
import { PLACES, ROOT, close, drawAndGrow, visit } from './visit.mjs';

const here = visit(8231);
const { fresh } = here;

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
    await drawAndGrow(page);
    const begins = { Picture: '\x89PNG', Material: 'PK\x03\x04', Outlines: '<', Film: 'GIF8' };
    for (const [kind, beginning] of Object.entries(begins)) {
        await click(page, 'File', 'Button');
        await click(page, /^Export…/, 'Button');
        await click(page, kind, 'Button');
        await settled(page);
        // Its preview has been made; previews that the browser cannot make are left out.
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

test('the texture is copied as a picture, and what the browser forbids is told', async () => {
    const page = await fresh();
    await drawAndGrow(page);
    const copied = async () => {
        await click(page, 'Edit', 'Button');
        await click(page, /^Copy the texture as a picture/, 'Button');
    };
    await copied();
    await widget(page, /^Copied the texture as a picture, 512 × 512 px/);
    const side = await until('it is in the clipboard', () => page.evaluate(async () => {
        const [item] = await navigator.clipboard.read();
        return item?.types.includes('image/png') && (await createImageBitmap(await item.getType('image/png'))).width;
    }));
    assert.equal(side, 512);
    await page.evaluate(() => { navigator.clipboard.write = () => Promise.reject(new Error('not allowed')); });
    await copied();
    await widget(page, /^The browser does not let the page copy the picture \(not allowed\)/);
    await close(page);
});

test('files that cannot be packed are reported and stay', async () => {
    const page = await fresh();
    await drawAndGrow(page);
    // Where the archive would be written, a folder is.
    await page.evaluate(() => dapple.keep('/written/untitled-material.zip/taken', new Uint8Array(1)));
    await click(page, 'File', 'Button');
    await click(page, /^Export…/, 'Button');
    await click(page, 'Material', 'Button');
    await click(page, 'Export…', 'Button');
    await click(page, 'Export', 'Button');
    const told = await widget(page, /^untitled-material: the files could not be packed/, 'Label', 120000);
    assert.match(told.name, /They stay in memory/);
    await sight(page, 'not-packed');
    const kept = await page.evaluate(() => dapple.take_written('/written/untitled-material/untitled_Height.png').length);
    assert.ok(kept > 1000, `${kept}`);
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
    await choose(other, 'File', /^Open…/, join(ROOT, 'examples/zebra.dapple'));
    await until('it is open', async () => (await marks(other)) > 3);
    await grown(other);
    await sight(other, 'opened');
    await give(other, 'drop', join(ROOT, 'examples/cheetah-run.dapple'), '');
    await until('the dropped document is open', async () => (await widgets(other)).some((one) => one.name === 'cheetah-run.dapple'));
    await give(other, 'paste', join(ROOT, 'assets/examples/zebra.png'), 'image/png');
    await widget(other, /^What is zebra\.png for/);
    await sight(other, 'pasted');
    await click(other, 'Reference picture', 'Button');
    await close(other);
});

test('a canvas that does not fit into memory is refused with a message', async () => {
    // 512 MB.
    const page = await fresh('&memory=8192');
    const document = JSON.parse(readFileSync(join(ROOT, 'examples/cheetah-run.dapple'), 'utf8'));
    document.size = [8192, 8192];
    await choose(page, 'File', /^Open…/, { name: 'large.dapple', mimeType: '', buffer: Buffer.from(JSON.stringify(document)) });
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
    const cdp = await here.context.newCDPSession(page);
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

test('an example that arrives late is waited for in words, and one that does not is told of', async () => {
    const page = await fresh();
    let arrive;
    await page.route('**/examples/zebra.dapple', async (route) => {
        await new Promise((done) => { arrive = done; });
        await route.continue();
    });
    await page.route('**/examples/tiger.dapple', (route) => route.abort());
    const example = async (name) => {
        await click(page, 'File', 'Button');
        await click(page, /^Examples…/, 'Button');
        await click(page, `Example: ${name}`, 'Button');
    };
    await example('Tiger');
    await widget(page, /^examples\/tiger\.dapple could not be loaded/);
    await sight(page, 'example-missing');
    await example('Zebra');
    await widget(page, 'Loading Zebra …');
    await sight(page, 'example-late');
    const letArrive = async () => {
        await until('it is asked for', () => arrive);
        arrive();
        arrive = undefined;
    };
    // What is drawn meanwhile is not lost.
    await drawSpot(page, PLACES[0]);
    await letArrive();
    await click(page, 'Don\'t save', 'Button');
    await letArrive();
    await until('it is open', async () => (await marks(page).catch(() => 0)) > 3);
    await grown(page);
    assert.equal(await failure(page), '');
    await page.close();
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
    await choose(page, 'File', /^Import a photograph…/, join(ROOT, 'assets/drawn-spots.jpg'));
    // The picture is a table of many pictures, so that the dialog doubts that it shows a pattern.
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
