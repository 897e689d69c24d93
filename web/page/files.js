// Files between the visitor and the program.

/** Offers a file to the visitor as a download. */
export function save(name, parts) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob(parts));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const bytesOf = async (file) => new Uint8Array(await file.arrayBuffer());

function choose(dapple, number, endings) {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = endings;
    input.onchange = async () => {
        const [file] = input.files;
        if (file) dapple.answer(number, file.name, await bytesOf(file));
        else dapple.answer(number, '', undefined);
    };
    input.oncancel = () => dapple.answer(number, '', undefined);
    document.body.append(input);
    input.hidden = true;
    input.click();
    input.remove();
}

async function load(dapple, here, number, name) {
    try {
        const response = await fetch(new URL(name, here));
        if (!response.ok) throw new Error(response.statusText);
        dapple.answer(number, name, new Uint8Array(await response.arrayBuffer()));
    } catch {
        dapple.answer(number, '', undefined);
    }
}

/** Puts a PNG into the clipboard. */
async function copy(dapple, name) {
    try {
        const png = new Blob([dapple.take_written(name)], { type: 'image/png' });
        await navigator.clipboard.write([new ClipboardItem({ 'image/png': png })]);
    } catch (error) {
        dapple.tell(`The browser does not let the page copy the picture (${error.message}). Try to copy it again, or export it as a file.`);
    }
}

/** Returns a function that carries out the requests of the program; it is to be called repeatedly. */
export function serveRequests(dapple, here) {
    return () => {
        for (let asked; (asked = dapple.next_request());) {
            const { what, name, number } = asked;
            asked.free();
            if (what === 'choose') choose(dapple, number, name);
            else if (what === 'load') load(dapple, here, number, name);
            else if (what === 'copy') copy(dapple, name);
            else save(name.split('/').pop(), [dapple.take_written(name)]);
        }
    };
}

/** Takes files that are dropped on the page, and pictures that are pasted. */
export function takeDropped(dapple, canvas) {
    const take = async (files) => {
        for (const file of files) dapple.drop_file(file.name || 'pasted.png', await bytesOf(file));
    };
    addEventListener('dragover', (event) => event.preventDefault(), true);
    addEventListener('drop', (event) => {
        const files = [...(event.dataTransfer?.files ?? [])];
        event.preventDefault();
        event.stopImmediatePropagation();
        // The window then hides its hint about dropping.
        canvas.dispatchEvent(new DragEvent('dragleave', { bubbles: true }));
        take(files);
    }, true);
    addEventListener('paste', (event) => {
        const files = [...(event.clipboardData?.files ?? [])];
        if (files.length === 0) return;
        event.preventDefault();
        event.stopImmediatePropagation();
        take(files);
    }, true);
}
