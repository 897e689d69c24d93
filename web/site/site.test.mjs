// The site as visitors meet it: on a host that sends no headers. SITE is the folder that .ci/site has made.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { drawSpot, failure, grown, launch, marks, sight, until } from '../tests/browser.mjs';
import { visit } from '../tests/visit.mjs';

const here = visit(8238, { plain: true, folder: process.env.SITE });

/** A page of the site whose errors are remembered. */
async function visited(path) {
    const page = await here.context.newPage();
    page.problems = [];
    page.on('pageerror', (error) => page.problems.push(String(error)));
    await page.goto(`${here.url}${path}`);
    return page;
}

test('the front page has a live sketch in it, which can be drawn in', async () => {
    const page = await visited('');
    const frame = page.frameLocator('iframe.live');
    await frame.locator('#arriving[hidden]').waitFor({ state: 'attached', timeout: 60000 });
    const bounds = await page.locator('iframe.live').boundingBox();
    assert.ok(bounds.width > 600 && bounds.height > 250, JSON.stringify(bounds));
    const seen = async () => (await page.screenshot({ clip: bounds })).toString('base64');
    // It is painted, and has grown.
    await page.waitForTimeout(4000);
    const before = await seen();
    await sight(page, 'site-front');
    assert.equal(await seen(), before, 'it rests');
    const [x, y] = [bounds.x + 0.2 * bounds.width, bounds.y + 0.5 * bounds.height];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let step = 1; step <= 16; step++) await page.mouse.move(x + 30 * Math.sin(step / 16 * 6.283), y + 20 - 20 * Math.cos(step / 16 * 6.283));
    await page.mouse.up();
    await until('the drawn mark is seen', async () => (await seen()) !== before);
    await page.waitForTimeout(2000);
    await sight(page, 'site-front-drawn');
    assert.equal(await frame.locator('#failed').isVisible(), false);
    assert.deepEqual(page.problems, []);
    await page.close();
});

test('the editor of the site opens from the front page, and from a picture of the gallery with its document', async () => {
    const page = await visited('');
    await page.click('text=Draw your own');
    await page.waitForFunction(() => globalThis.dapple, null, { timeout: 60000 });
    assert.equal(await failure(page), '');
    await page.goto(`${here.url}editor/index.html?test`);
    await page.waitForFunction(() => globalThis.dapple, null, { timeout: 60000 });
    await drawSpot(page, [0.5, 0.5]);
    await grown(page);
    await page.goto(`${here.url}gallery.html`);
    await sight(page, 'site-gallery');
    const links = await page.$$eval('.gallery a', (all) => all.map((one) => one.getAttribute('href')).filter((link) => link.startsWith('editor/')));
    assert.ok(links.length > 90, `${links.length}`);
    const editor = await visited(links.find((link) => link.includes('#dapple1=')).replace('#', '?test#'));
    await editor.waitForFunction(() => globalThis.dapple, null, { timeout: 60000 });
    await until('its document is open', async () => (await marks(editor)) > 1);
    await grown(editor);
    await sight(editor, 'site-editor');
    assert.equal(await failure(editor), '');
    assert.deepEqual([...page.problems, ...editor.problems], []);
});

test('without JavaScript everything but the editor works', async () => {
    const profile = mkdtempSync(join(tmpdir(), 'dapple-profile-'));
    const context = await launch(profile, { javaScriptEnabled: false });
    const page = await context.newPage();
    await page.goto(here.url);
    const picture = page.locator('.live img');
    assert.ok(await picture.evaluate((image) => image.naturalWidth > 100));
    await sight(page, 'site-without-scripts');
    for (const [link, title] of [['Gallery', 'Gallery'], ['Docs', /\w/]]) {
        await page.locator('nav').getByText(link, { exact: true }).click();
        assert.match(await page.title(), typeof title === 'string' ? new RegExp(title) : title);
        assert.ok((await page.locator('main').innerText()).length > 200);
    }
    await page.goto(`${here.url}gallery.html`);
    const pictures = await page.$$eval('.gallery img', (all) => all.length);
    assert.ok(pictures > 90, `${pictures}`);
    await page.goto(`${here.url}editor/index.html`);
    assert.match(await page.locator('body').innerText(), /The editor needs JavaScript/);
    await context.close();
    rmSync(profile, { recursive: true, force: true });
});
