// Opens the page that compares the bytes in a real browser, and fails where the page finds a difference.
//
//   node chromium.mjs PLAYWRIGHT-CORE FOLDER [SCREENSHOT.png]

import { createServer } from 'node:http';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { extname, join, normalize } from 'node:path';

const [playwright, folder, screenshot] = process.argv.slice(2);
const { chromium } = createRequire(import.meta.url)(playwright);
const types = { '.html': 'text/html', '.js': 'text/javascript', '.json': 'application/json', '.wasm': 'application/wasm' };

const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname)).replace(/\/$/, '/index.html');
    try {
        const bytes = readFileSync(join(folder, path));
        response.writeHead(200, { 'Content-Type': types[extname(path)] ?? 'application/octet-stream' }).end(bytes);
    } catch {
        response.writeHead(404).end();
    }
}).listen(0, '127.0.0.1');

const args = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args });
try {
    const page = await browser.newPage({ viewport: { width: 390, height: 844 } });
    page.on('pageerror', (error) => console.log(`the page: ${error}`));
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    await page.waitForSelector('#verdict.equal, #verdict.different', { timeout: 600_000 });
    console.log(await page.textContent('#verdict'));
    for (const line of await page.$$eval('tbody tr', (rows) => rows.map((row) => `${row.cells[1].innerText} ${row.cells[3].innerText}`))) console.log(`  ${line}`);
    if (screenshot) await page.screenshot({ path: screenshot });
    process.exitCode = (await page.$('#verdict.equal')) ? 0 : 1;
} finally {
    await browser.close();
    server.close();
}
