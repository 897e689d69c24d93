// Measures how long visitors wait, and how long the page's thread is occupied. The results are printed for people to read.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { click, failure, grown, marks, saved, settled, sight, until, widget, widgets } from './browser.mjs';
import { ROOT, close, drawAndGrow, visit } from './visit.mjs';

const here = visit(8236);
const { fresh } = here;

/** Prints the longest call since it was printed last: what the window computes in a frame, and each other call of the page. */
async function longest(page, what) {
    await settled(page);
    const [frame, calls] = await page.evaluate(() => {
        const calls = globalThis.longestCalls;
        globalThis.longestCalls = {};
        return [dapple.longest_frame(), calls];
    });
    const [name, ms] = Object.entries(calls).sort(([, a], [, b]) => b - a)[0] ?? ['none', 0];
    console.log(`${what}: ${frame.toFixed(0)} ms in a frame without painting, ${ms.toFixed(0)} ms in another call (${name})`);
    assert.equal(await failure(page), '');
}

/** Opens another document; the changes are not saved. */
async function opened(page, file) {
    const chooser = page.waitForEvent('filechooser');
    await click(page, 'File', 'Button');
    await click(page, /^Open…/, 'Button');
    await click(page, 'Don\'t save', 'Button');
    await (await chooser).setFiles(join(ROOT, file));
    await widget(page, file.split('/').pop());
}

test('a new visitor sees the window, and the first texture', async () => {
    const page = await here.context.newPage();
    await page.addInitScript(() => {
        const shown = () => (globalThis.dapple ? requestAnimationFrame(() => { globalThis.painted = performance.now(); }) : requestAnimationFrame(shown));
        requestAnimationFrame(shown);
    });
    await page.goto(`${here.url}?test`, { waitUntil: 'commit' });
    await page.waitForFunction(() => globalThis.painted, null, { timeout: 120000, polling: 20 });
    // A picture of the start page begins a sketch.
    await click(page, 'Spots', 'Button');
    await widget(page, /^Texture/);
    await grown(page);
    const [painted, texture] = await page.evaluate(() => [globalThis.painted, performance.now()]);
    console.log(`the window after ${(painted / 1000).toFixed(2)} s, the first texture after ${(texture / 1000).toFixed(2)} s`);
    await longest(page, 'opening and the first texture');
    await page.close();
});

test('the longest calls on the thread of the page', async () => {
    const page = await fresh();
    await longest(page, 'opening');
    await drawAndGrow(page);
    await longest(page, 'drawing');
    for (const tab of ['Result', 'Colour', 'Canvas', 'Draw']) await click(page, tab, 'Button');
    await longest(page, 'tabs');
    await click(page, 'File', 'Button');
    await click(page, /^Examples…/, 'Button');
    await widget(page, 'Example: Zebra', 'Button');
    await longest(page, 'examples');
    await click(page, 'Example: Zebra', 'Button');
    await click(page, 'Don\'t save', 'Button');
    await until('it is open', async () => (await marks(page).catch(() => 0)) > 3);
    await grown(page);
    await click(page, 'Result', 'Button');
    await until('it is measured', async () => !(await widgets(page)).some((one) => /^Measuring/.test(one.name)));
    await longest(page, 'zebra and its result');
    await click(page, 'Alternatives', 'Button');
    await widget(page, /^Use Seed/, undefined, 120000);
    await click(page, 'Alternatives', 'Button');
    await longest(page, 'alternatives');
    await click(page, 'Edit', 'Button');
    await click(page, /^Select all/, 'Button');
    for (const key of ['ArrowRight', 'ArrowLeft', 'Control+Z']) await page.keyboard.press(key);
    await grown(page);
    await longest(page, 'moving all marks');
    await saved(page);
    await longest(page, 'saving');
    // Something that is not saved.
    await click(page, 'Edit', 'Button');
    await click(page, /^Select all/, 'Button');
    await page.keyboard.press('ArrowRight');
    await settled(page);
    await opened(page, 'examples/portrait.dapple');
    await grown(page);
    await click(page, 'Edit', 'Button');
    await click(page, /^Copy link/, 'Button');
    await settled(page);
    await page.keyboard.press('Escape');
    await longest(page, 'a document with a picture, and its link');
    for (const kind of ['Picture', 'Material', 'Outlines']) {
        await click(page, 'File', 'Button');
        await click(page, /^Export…/, 'Button');
        await click(page, kind, 'Button');
        await until('the preview is made', async () => !(await widgets(page)).some((one) => one.role === 'ProgressIndicator'), 120000);
        if (kind === 'Material') await turn(page);
        await page.keyboard.press('Escape');
        await longest(page, `exporting: ${kind}`);
    }
    await close(page);
});

/** Turns the lit preview of a material by the pointer. */
async function turn(page) {
    const lit = await widget(page, /^Lit preview/);
    const at = (share) => [lit.left + share * (lit.right - lit.left), 0.5 * (lit.top + lit.bottom)];
    await page.mouse.move(...at(0.3));
    await page.mouse.down();
    for (let share = 0.3; share < 0.7; share += 0.05) {
        await page.mouse.move(...at(share));
        await settled(page);
    }
    await page.mouse.up();
    await settled(page);
    await sight(page, 'lit');
}
