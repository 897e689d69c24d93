// The window on a phone: a small screen and fingers.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { canvas, failure, grown, marks, settled, sight, widget, widgets } from './browser.mjs';
import { visit } from './visit.mjs';

// An emulated screen does not report a device pixel ratio, so the screen has a ratio of 1.
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 1 };
const here = visit(8232, { browser: phone });
const { fresh } = here;

const middle = (one) => [(one.left + one.right) / 2, (one.top + one.bottom) / 2];
async function tap(page, name, role) {
    const found = await widget(page, name, role);
    assert.ok(found.left >= -1 && found.right <= 391 && found.top >= -1 && found.bottom <= 845,
        `${name} is on the screen: ${JSON.stringify(found)}`);
    await page.touchscreen.tap(...middle(found));
    await settled(page);
    return found;
}

/** Fingers that move from some points to others at the same time. */
async function fingers(page, paths, steps = 12) {
    const cdp = await here.context.newCDPSession(page);
    const points = (share) => paths.map(([from, to], id) => ({
        x: from[0] + share * (to[0] - from[0]), y: from[1] + share * (to[1] - from[1]), id, force: 1,
    }));
    await cdp.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(0) });
    for (let step = 1; step <= steps; step++) {
        await cdp.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(step / steps) });
        await settled(page);
    }
    await cdp.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await settled(page);
}

test('one finger draws, two fingers move the view', async () => {
    const page = await fresh();
    await sight(page, 'phone-empty');
    const { left, top, right, bottom } = await canvas(page);
    const at = (x, y) => [left + x * (right - left), top + y * (bottom - top)];
    await fingers(page, [[at(0.3, 0.4), at(0.7, 0.4)]]);
    assert.equal(await marks(page), 1);
    await fingers(page, [[at(0.3, 0.6), at(0.7, 0.6)]]);
    assert.equal(await marks(page), 2);
    await grown(page);
    await sight(page, 'phone-grown');
    const zoom = async () => (await widgets(page)).find((one) => /^\d+ %$/.test(one.name)).name;
    const before = await zoom();
    await fingers(page, [[at(0.45, 0.5), at(0.2, 0.5)], [at(0.55, 0.5), at(0.8, 0.5)]]);
    assert.equal(await marks(page), 2);
    assert.ok(parseInt(await zoom(), 10) > 1.5 * parseInt(before, 10), `${before} ${await zoom()}`);
    await sight(page, 'phone-zoomed');
    assert.equal(await failure(page), '');
    await page.close();
});

test('a finger that rests opens the menu', async () => {
    const page = await fresh();
    const { left, top, right, bottom } = await canvas(page);
    const cdp = await here.context.newCDPSession(page);
    const touchPoints = [{ x: left + 0.5 * (right - left), y: top + 0.8 * (bottom - top) }];
    await cdp.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints });
    await widget(page, /^Paste/, 'Button');
    await cdp.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await settled(page);
    await widget(page, /^Paste/, 'Button');
    await sight(page, 'phone-menu');
    assert.equal(await marks(page), 0);
    await page.close();
});

test('panels unfold, and dialogs can be used', async () => {
    const page = await fresh();
    const { left, top, right, bottom } = await canvas(page);
    const at = (x, y) => [left + x * (right - left), top + y * (bottom - top)];
    await fingers(page, [[at(0.3, 0.4), at(0.7, 0.4)]]);
    await tap(page, 'Panels', 'Button');
    for (const tab of ['Canvas', 'Colour', 'Result', 'Draw']) {
        await tap(page, tab, 'Button');
        await sight(page, `phone-${tab.toLowerCase()}`);
    }
    await tap(page, 'Panels', 'Button');
    for (const [menu, entry, close] of [['File', /^New…/, 'Cancel'], ['File', /^Examples…/, 'Close'], ['File', /^Export…/, 'Cancel'],
        ['Edit', /^Preferences…/, 'Close'], ['File', /^Save as…/, 'Cancel'], ['Help', /^Keyboard shortcuts/, 'Close'], ['Help', /^About dapple/, 'Close']]) {
        await tap(page, menu, 'Button');
        await tap(page, entry, 'Button');
        await settled(page);
        await sight(page, `phone-${String(entry).replace(/\W/g, '').toLowerCase()}`);
        await tap(page, close, 'Button');
    }
    assert.equal(await failure(page), '');
    await page.close();
});
