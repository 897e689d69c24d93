// Tests of what is kept from one visit to the next, and of the messages where that fails.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { click, downloaded, drawSpot, failure, grown, kept, marks, open, settled, sight, until, widget, widgets } from './browser.mjs';
import { PLACES, close, drawAndGrow, visit } from './visit.mjs';

const here = visit(8235);
const { fresh } = here;

/** The marks of the unsaved work that is in the database. */
async function keptMarks(page) {
    const work = (await kept(page)).find(([path]) => path.endsWith('.dapple'))?.[1] ?? '';
    return work ? JSON.parse(work.slice(work.indexOf('\n\n'))).layers[0].strokes.length : 0;
}

test('what was drawn comes back after the tab was killed', async () => {
    const page = await fresh();
    for (const place of PLACES) await drawSpot(page, place);
    await click(page, 'View', 'Button');
    await click(page, 'Dark theme');
    await until('it is kept', async () => await keptMarks(page) === 3 &&
        (await kept(page)).some(([path, text]) => path.endsWith('settings') && text.includes('dark')));
    const cdp = await here.context.newCDPSession(page);
    const crashed = page.waitForEvent('crash');
    cdp.send('Page.crash').catch(() => {});
    await crashed;
    await page.close();

    const again = await open(here.context, `${here.url}?test`);
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
    await until('it is kept', async () => await keptMarks(page) === 1);
    const other = await open(here.context, `${here.url}?test`);
    await settled(other);
    assert.ok(!(await widgets(other)).some((one) => one.name === 'Unsaved work was found'));
    await close(other);
    await close(page);
});

for (const [where, onPage] of [['a worker', false], ['the page', true]]) {
    test(`a failure in ${where} is told in words, and what was drawn can be saved`, async () => {
        const page = await fresh();
        await drawAndGrow(page);
        await page.evaluate((onPage) => { try { dapple.fail(onPage); } catch { /* that is the test */ } }, onPage);
        await until('it is told', () => failure(page));
        const told = await failure(page);
        assert.match(told, /reload the page/);
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

/** The warning that the drawing is not stored; empty while there is none. */
const warned = (page) => page.evaluate(() => {
    const shown = document.getElementById('warned');
    return shown.hidden ? '' : shown.innerText;
});

test('work that the database refuses stays pending, is told of, and is written when that is possible', async () => {
    const page = await fresh();
    await page.evaluate(() => {
        const put = IDBObjectStore.prototype.put;
        globalThis.isFull = true;
        IDBObjectStore.prototype.put = function (...record) {
            const request = put.apply(this, record);
            // A browser whose storage is full does the same: it undoes the writes of this transaction.
            if (globalThis.isFull) this.transaction.abort();
            return request;
        };
    });
    await drawAndGrow(page);
    await until('it is told', () => warned(page));
    assert.match(await warned(page), /Your drawing is not.*Save the document/s);
    await sight(page, 'not-kept');
    assert.equal(await keptMarks(page), 0);
    // A closed warning is not shown again while its cause lasts.
    await page.click('#warned button');
    await page.waitForTimeout(2500);
    assert.equal(await warned(page), '');
    await page.evaluate(() => { globalThis.isFull = false; });
    await until('it is kept', async () => await keptMarks(page) === 3);
    await close(page);
});

test('what was drawn can be saved after a failure even where the database refuses it', async () => {
    const page = await fresh();
    await page.evaluate(() => { IDBObjectStore.prototype.put = () => { throw new DOMException('full', 'QuotaExceededError'); }; });
    await drawAndGrow(page);
    await until('it is told', () => warned(page));
    await page.evaluate(() => { try { dapple.fail(true); } catch { /* that is the test */ } });
    await until('it is told', () => failure(page));
    const { bytes } = await downloaded(page, () => page.click('#rescue'));
    assert.equal(JSON.parse(bytes).layers[0].strokes.length, 3);
    await page.close();
});

test('a database that does not answer at the start is told of, and the window opens', async () => {
    const page = await here.context.newPage();
    await page.addInitScript(() => { indexedDB.open = () => ({}); });
    await page.goto(`${here.url}?test`, { waitUntil: 'commit' });
    await page.waitForFunction(() => globalThis.dapple, null, { timeout: 120000 });
    assert.match(await warned(page), /last visit.*Nothing was deleted/s);
    await sight(page, 'not-restored');
    await drawSpot(page, PLACES[0]);
    await grown(page);
    assert.equal(await failure(page), '');
    await page.close();
});
