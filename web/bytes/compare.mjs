// Grows documents with the desktop program and with the engine as WebAssembly, and compares the bytes of the written files.
//
//   node compare.mjs PROGRAM MODULE.wasm [--table TABLE.json] FILE…
//
// --table writes the checksums of the desktop program's files, for the page that makes this comparison; nothing is compared then.

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { grow } from './page/grow.js';

const [program, wasm, ...rest] = process.argv.slice(2);
const table = rest[0] === '--table' ? rest.splice(0, 2)[1] : undefined;
if (!rest.length) throw new Error('usage: node compare.mjs PROGRAM MODULE.wasm [--table TABLE.json] FILE…');
const scratch = mkdtempSync(join(tmpdir(), 'dapple-bytes-'));
process.on('exit', () => rmSync(scratch, { recursive: true }));

const sum = (bytes) => createHash('sha256').update(bytes).digest('hex');

/** The checksums of the files that the desktop program writes, by kind. */
function onTheDesktop(file) {
    const path = (name) => join(scratch, name);
    const run = (...options) => execFileSync(program, ['grow', file, '--quiet', ...options]);
    const sums = (names) => Object.fromEntries(Object.entries(names).map(([kind, name]) => [kind, sum(readFileSync(path(name)))]));
    if (JSON.parse(readFileSync(file, 'utf8')).model) {
        run('--size', '512x512', '-o', path('picture.png'));
        run('-o', path('model.ply'));
        return sums({ picture: 'picture.png', model: 'model.ply' });
    }
    run('-o', path('picture.png'), '--pattern', path('pattern.png'));
    return sums({ picture: 'picture.png', pattern: 'pattern.png' });
}

/** The checksums of the files that the engine as WebAssembly writes, by kind. */
async function here(module, file) {
    const files = await grow(module, readFileSync(file));
    return Object.fromEntries(files.map(({ kind, bytes }) => [kind, sum(bytes)]));
}

if (table) {
    const version = execFileSync(program, ['--version'], { encoding: 'utf8' }).trim().replace(/^dapple /, '');
    const documents = rest.map((file) => ({ name: basename(file, '.dapple'), files: onTheDesktop(file) }));
    writeFileSync(table, `${JSON.stringify({ version, documents }, null, 1)}\n`);
    console.log(`${table}: the sums of ${documents.length} documents`);
} else {
    const module = await WebAssembly.compile(readFileSync(wasm));
    let different = 0, seconds = 0;
    for (const file of rest) {
        const expected = onTheDesktop(file);
        const began = performance.now();
        const got = await here(module, file).catch((error) => ({ error: error.message }));
        seconds += (performance.now() - began) / 1000;
        const kinds = [...new Set([...Object.keys(expected), ...Object.keys(got)])];
        const others = kinds.filter((kind) => expected[kind] !== got[kind]);
        different += others.length > 0;
        for (const kind of others) console.log(`DIFFERENT ${file}: ${kind}: desktop ${expected[kind]}, here ${got[kind]}`);
        if (!others.length) console.log(`equal ${file} ${kinds.map((kind) => `${kind} ${got[kind].slice(0, 12)}`).join(' ')}`);
    }
    console.log(`${rest.length - different} of ${rest.length} documents are equal; ${seconds.toFixed(0)} s as WebAssembly`);
    process.exitCode = different ? 1 : 0;
}
