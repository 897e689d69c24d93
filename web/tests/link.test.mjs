// Documents in links, and pages that show less of the window.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { begin, canvas, click, drawSpot, failure, grown, launch, marks, open, serve, settled, sight, until, widgets } from './browser.mjs';

const PORT = 8234;
const profile = mkdtempSync(join(tmpdir(), 'dapple-profile-'));
let server;
let context;

before(async () => {
    server = await serve(PORT);
    context = await launch(profile);
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
});
after(async () => {
    await context?.close();
    server?.stop();
    rmSync(profile, { recursive: true, force: true });
});

/** The link that the window copies of three drawn marks. */
async function copied() {
    const page = await begin(context, `${server.url}?test`, `${server.url}sw.js`);
    for (const place of [[0.3, 0.35], [0.6, 0.4], [0.45, 0.65]]) await drawSpot(page, place);
    await grown(page);
    await click(page, 'Edit', 'Button');
    await click(page, /^Copy link/, 'Button');
    await settled(page);
    // Outlines of strokes make long links.
    if ((await widgets(page)).some((one) => one.name === 'Copy the link anyway')) await click(page, 'Copy the link anyway', 'Button');
    const link = await until('a copied link', () => page.evaluate(() => navigator.clipboard.readText()));
    await page.close();
    return link;
}

test('a copied link leads to this page and opens the document, whole, without panels, and as a texture alone', async () => {
    const link = await copied();
    assert.ok(link.startsWith(`${server.url}#dapple1=`), link);
    const fragment = link.slice(link.indexOf('#'));
    for (const [query, buttons] of [['?test', 20], ['?test&embed', 0], ['?test&view', 0]]) {
        const page = await open(context, `${server.url}${query}${fragment}`);
        await page.waitForTimeout(3000);
        await sight(page, `link${query.replace(/\W/g, '-')}`);
        const all = await widgets(page);
        const menus = all.filter((one) => ['File', 'Edit', 'View'].includes(one.name));
        assert.equal(menus.length, buttons ? 3 : 0, query);
        assert.equal(all.some((one) => /^Unsaved work/.test(one.name)), buttons > 0, query);
        if (!query.includes('view')) assert.equal(await marks(page), 3, query);
        else assert.ok(!all.some((one) => /^Sketch canvas/.test(one.name)), query);
        assert.equal(await failure(page), '');
        assert.deepEqual(page.problems, []);
        await page.close();
    }
});

test('another link in the same tab keeps what is unsaved', async () => {
    const fragment = new URL(await copied()).hash;
    const page = await begin(context, `${server.url}?test`, `${server.url}sw.js`);
    await drawSpot(page, [0.5, 0.5]);
    await grown(page);
    await page.waitForTimeout(1500);
    await page.evaluate((hash) => { location.hash = hash; }, fragment);
    await page.waitForTimeout(500);
    await page.waitForFunction(() => globalThis.dapple?.widgets, null, { timeout: 120000 });
    await canvas(page);
    await page.waitForTimeout(2000);
    await sight(page, 'link-in-the-same-tab');
    // The document of the link is there, and the unsaved one is offered.
    const names = (await widgets(page)).map((one) => one.name).join(' | ');
    assert.match(names, /unsaved|recover/i, names);
    assert.equal(await failure(page), '');
    await page.close();
});
