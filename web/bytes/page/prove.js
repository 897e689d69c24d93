// Grows the golden documents in this tab and compares their files with the table that the desktop program has made.

const table = await (await fetch('expected.json')).json();
const rows = new Map(table.documents.map((one) => [one.name, row(one)]));
const verdict = document.getElementById('verdict');
const again = document.getElementById('again');
again.onclick = run;
document.getElementById('version').textContent = table.version;
run();

function element(name, text, parts = []) {
    const made = document.createElement(name);
    if (text) made.textContent = text;
    made.append(...parts);
    return made;
}

/** A line of the table. */
function row({ name, files }) {
    const picture = element('img');
    picture.alt = '';
    const said = element('td', 'waits');
    const expected = element('td', '', Object.entries(files).map(([kind, sum]) => element('div', `${kind} ${sum.slice(0, 16)}…`)));
    const link = element('a', name);
    link.href = `documents/${name}.dapple`;
    const line = element('tr', '', [element('td', '', [picture]), element('td', '', [link]), expected, said]);
    document.querySelector('tbody').append(line);
    return { expected: files, picture, said, line };
}

function run() {
    again.disabled = true;
    for (const { said, line } of rows.values()) [said.textContent, line.className] = ['waits', ''];
    let equal = 0, different = 0;
    const names = [...rows.keys()];
    const worker = new Worker('worker.js', { type: 'module' });
    const next = () => {
        const name = names[equal + different];
        if (name) {
            rows.get(name).said.textContent = 'grows';
            worker.postMessage(name);
            return;
        }
        worker.terminate();
        again.disabled = false;
        verdict.className = different ? 'different' : 'equal';
        verdict.textContent = different
            ? `${different} of ${names.length} documents gave other bytes. Please report it, with the name and version of your browser: ${navigator.userAgent}`
            : `✓ All ${names.length} documents gave the same bytes as on the desktop.`;
    };
    const settle = (name, difference, words) => {
        const { said, line } = rows.get(name);
        difference ? different++ : equal++;
        [said.textContent, line.className] = [words, difference ? 'different' : 'equal'];
        verdict.className = '';
        verdict.textContent = `${equal + different} of ${names.length} documents`;
        next();
    };
    worker.onmessage = ({ data: { name, error, seconds, files } }) => {
        if (error) return settle(name, true, `could not be grown: ${error}`);
        const { expected, picture } = rows.get(name);
        picture.src = URL.createObjectURL(new Blob([files[0].bytes], { type: 'image/png' }));
        picture.onload = () => URL.revokeObjectURL(picture.src);
        const others = files.filter(({ kind, sha256 }) => expected[kind] !== sha256);
        const words = others.map(({ kind, sha256 }) => `the ${kind} is ${sha256.slice(0, 16)}…`).join(', ');
        settle(name, words, words || `✓ ${seconds.toFixed(1)} s`);
    };
    worker.onerror = (error) => settle(names[equal + different], true, error.message || 'the worker could not be started');
    next();
}
