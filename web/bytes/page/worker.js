// Grows one document after the other, so that the page can be scrolled meanwhile.
import { grow, sha256 } from './grow.js';

const module = WebAssembly.compileStreaming(fetch('bytes.wasm'));

onmessage = async ({ data: name }) => {
    try {
        const response = await fetch(`documents/${name}.dapple`);
        if (!response.ok) throw new Error(`${name}.dapple: ${response.status} ${response.statusText}`);
        const began = performance.now();
        const files = await grow(await module, new Uint8Array(await response.arrayBuffer()));
        const seconds = (performance.now() - began) / 1000;
        for (const file of files) file.sha256 = await sha256(file.bytes);
        postMessage({ name, seconds, files });
    } catch (error) {
        postMessage({ name, error: error.message });
    }
};
