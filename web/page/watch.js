// Measures how long each call into the program occupies the page's thread, for tests.

/** The longest call of each function so far, ms. */
globalThis.longestCalls = {};

/** The functions of the program, each with its duration measured. */
export function watched(program) {
    const watch = (name, call) => (...values) => {
        const began = performance.now();
        try {
            return call(...values);
        } finally {
            globalThis.longestCalls[name] = Math.max(globalThis.longestCalls[name] ?? 0, performance.now() - began);
        }
    };
    // Names of classes begin with a capital letter.
    const isCall = ([name, value]) => typeof value === 'function' && /^[a-z]/.test(name) && name !== 'default';
    return Object.fromEntries(Object.entries(program).map((one) => (isCall(one) ? [one[0], watch(...one)] : one)));
}
