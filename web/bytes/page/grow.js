// Grows a document with the WebAssembly module and returns the files of `dapple grow`; for node and for pages.

const KINDS = ['error', 'picture', 'pattern', 'model'];

/**
 * Grows a document in its own memory.
 * @param {WebAssembly.Module} module
 * @param {Uint8Array} document the bytes of its file
 * @returns {Promise<{kind: string, bytes: Uint8Array}[]>} or an error that says why it cannot be grown
 */
export async function grow(module, document) {
    const { exports } = await WebAssembly.instantiate(module, {});
    const copied = (file) => new Uint8Array(exports.memory.buffer, exports.start(file), exports.length(file)).slice();
    const said = () => new TextDecoder().decode(copied(0));
    const room = exports.room(document.length);
    new Uint8Array(exports.memory.buffer, room, document.length).set(document);
    let failed;
    try {
        failed = exports.grow();
    } catch (trap) {
        throw new Error(exports.files() ? said() : String(trap));
    }
    if (failed) throw new Error(said());
    return Array.from({ length: exports.files() }, (_, file) => ({ kind: KINDS[exports.kind(file)], bytes: copied(file) }));
}

/** SHA-256 of bytes, in hexadecimal digits. */
export async function sha256(bytes) {
    const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
    return Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join('');
}
