// Hosts that send no headers.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { drawSpot, failure, grown, launch, open, serve, sight } from './browser.mjs';

const PORT = 8233;
let server;
const profiles = [];
const profile = () => profiles[profiles.push(mkdtempSync(join(tmpdir(), 'dapple-plain-'))) - 1];

before(async () => { server = await serve(PORT, true); });
after(() => {
    server?.stop();
    for (const folder of profiles) rmSync(folder, { recursive: true, force: true });
});

test('on a plain host the service worker makes the page isolated', async () => {
    const context = await launch(profile());
    const page = await open(context, `${server.url}?test`);
    assert.equal(await failure(page), '');
    assert.equal(await page.evaluate(() => crossOriginIsolated), true);
    await drawSpot(page, [0.5, 0.5]);
    await grown(page);
    await context.close();
});

test('a page that cannot be isolated says so and what to do', async () => {
    const context = await launch(profile(), { serviceWorkers: 'block' });
    const page = await open(context, server.url);
    assert.match(await failure(page), /Cross-Origin-Opener-Policy/);
    await sight(page, 'not-isolated');
    await context.close();
});
