// Tests of documents in links, and of pages that show only a part of the window.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { canvas, click, drawSpot, failure, grown, marks, open, settled, sight, until, widget, widgets } from './browser.mjs';
import { drawAndGrow, visit } from './visit.mjs';

const here = visit(8234);
const { fresh } = here;

/** The link that the window copies of three drawn marks. */
async function copied() {
    const page = await fresh();
    await drawAndGrow(page);
    await click(page, 'Edit', 'Button');
    await click(page, /^Copy link/, 'Button');
    await settled(page);
    // It is short enough to be copied without a question.
    await widget(page, /^Copied a link that holds this document/);
    const link = await until('a copied link', () => page.evaluate(() => navigator.clipboard.readText()));
    console.log(`a link of three freehand strokes: ${new URL(link).hash.length} characters`);
    await page.close();
    return link;
}

test('a copied link leads to this page and opens the document, whole, without panels, and as a texture alone', async () => {
    const link = await copied();
    assert.ok(link.startsWith(`${here.url}#dapple1=`), link);
    const fragment = link.slice(link.indexOf('#'));
    for (const [query, buttons] of [['?test', 20], ['?test&embed', 0], ['?test&view', 0]]) {
        const page = await open(here.context, `${here.url}${query}${fragment}`);
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
    const page = await fresh();
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
