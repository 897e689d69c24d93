// Shared by the tests of a file: a server, a browser with its own profile, and fresh pages in it.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, afterEach, before } from 'node:test';
import { begin, drawSpot, failure, grown, launch, serve } from './browser.mjs';

/** The project's folder. */
export const ROOT = new URL('../..', import.meta.url).pathname;
/** Where three marks are drawn, as shares of the canvas. */
export const PLACES = [[0.3, 0.35], [0.6, 0.4], [0.45, 0.65]];

/** Serves the page at `port` and opens a browser for all tests of this file, with a new profile. */
export function visit(port, options = {}) {
    const profile = mkdtempSync(join(tmpdir(), 'dapple-profile-'));
    const here = { url: `http://localhost:${port}/` };
    let server;
    before(async () => {
        server = await serve(port, options.plain, options.folder);
        here.context = await launch(profile, options.browser);
        await here.context.grantPermissions(['clipboard-read', 'clipboard-write']);
    });
    afterEach(async () => {
        for (const page of here.context.pages().slice(1)) await page.close();
    });
    after(async () => {
        await here.context?.close();
        server?.stop();
        rmSync(profile, { recursive: true, force: true });
    });
    /** The page without anything kept from earlier visits; `more` is added to its query. */
    here.fresh = (more = '') => begin(here.context, `${here.url}?test${more}`, `${here.url}sw.js`);
    return here;
}

/** Draws three marks and waits until they have grown. */
export async function drawAndGrow(page) {
    for (const place of PLACES) await drawSpot(page, place);
    await grown(page);
}

/** Ends a test, and checks that nothing has failed. */
export async function close(page) {
    assert.equal(await failure(page), '');
    assert.deepEqual(page.problems, []);
    await page.close();
}
