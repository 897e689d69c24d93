// Palettes, tone, and documents on models: what comes from other files.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { choose, click, downloaded, give, grown, marks, saved, settled, sight, until, widget, widgets } from './browser.mjs';
import { ROOT, close, drawAndGrow, visit } from './visit.mjs';

const here = visit(8237);
const { fresh } = here;

/** The document that is open, saved. */
const document = async (page) => JSON.parse((await saved(page)).bytes);

test('colours are saved as a palette, and opened by the dialog and by dropping', async () => {
    const page = await fresh();
    await drawAndGrow(page);
    await click(page, 'Colour', 'Button');
    // The files are at the end of the column.
    await page.mouse.move(1140, 400);
    await page.mouse.wheel(0, 4000);
    await settled(page);
    const { name, bytes } = await downloaded(page, async () => {
        await click(page, 'Save palette…', 'Button');
        await click(page, 'Save', 'Button');
    });
    assert.match(name, /\.json$/);
    const palette = JSON.parse(bytes);
    const stops = palette.stops ?? palette.colours?.stops;
    assert.ok(stops.length >= 2, bytes.toString());
    const gpl = (colour) => Buffer.from(`GIMP Palette\nName: two\n#\n0 0 0 black\n${colour} other\n`);
    await choose(page, undefined, 'Open palette…', { name: 'two.gpl', mimeType: '', buffer: gpl('255 0 0') });
    const colours = async () => JSON.stringify((await document(page)).layers[0]);
    await until('they are the palette\'s', async () => /"#ff0000"/i.test(await colours()));
    await sight(page, 'palette');
    // What was saved is the first of them again.
    await choose(page, undefined, 'Open palette…', { name: 'back.json', mimeType: '', buffer: bytes });
    await until('they are back', async () => !/"#ff0000"/i.test(await colours()));
    await close(page);
});

test('a picture is the tone of a layer, chosen or dropped', async () => {
    const page = await fresh();
    await drawAndGrow(page);
    await give(page, 'drop', join(ROOT, 'assets/examples/zebra.png'), 'image/png');
    await widget(page, /^What is zebra\.png for/);
    await click(page, 'Tone', 'Button');
    await until('a layer has it', async () => !!(await document(page)).layers[0].tone, 60000);
    await grown(page);
    await sight(page, 'tone');
    assert.equal(await marks(page), 3);
    await close(page);
});

test('a document on a model opens, shows its flat sketch, says so, and keeps the model when it is saved', async () => {
    const page = await fresh();
    const file = join(ROOT, 'examples/bodies/cheetah.dapple');
    await choose(page, 'File', /^Open…/, file);
    await until('it is open', async () => (await marks(page)) > 3);
    await widget(page, /^This document grows on/);
    await sight(page, 'model');
    assert.deepEqual((await document(page)).model, JSON.parse(readFileSync(file, 'utf8')).model);
    await give(page, 'drop', join(ROOT, 'tests/window/hand.rs'), '');
    await settled(page);
    const names = (await widgets(page)).map((one) => one.name).join(' | ');
    assert.match(names, /hand\.rs/, names);
    await close(page);
});
