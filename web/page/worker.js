// A thread: it shares the program's memory and does one piece of work after the other.
import init, { work } from './dapple.js';

globalThis.dappleFailed = (text) => postMessage({ failed: text });

onmessage = async ({ data: { module, memory } }) => {
    await init({ module_or_path: module, memory });
    postMessage({ ready: true });
    try {
        work();
    } catch (error) {
        postMessage({ ended: String(error) });
    }
};
