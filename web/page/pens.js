// Passes the events of pens to the window, which gets no pressure otherwise.

/** Listens to pens on the whole page. */
export function followPens(dapple) {
    const tell = (what) => (event) => {
        if (event.pointerType !== 'pen' || (what === 'move' && event.buttons === 0)) return;
        for (const one of event.getCoalescedEvents?.() ?? []) dapple.pen(what, one.clientX, one.clientY, one.pressure);
        if (what !== 'move') dapple.pen(what, event.clientX, event.clientY, event.pressure);
    };
    addEventListener('pointerdown', tell('down'), true);
    addEventListener('pointermove', tell('move'), true);
    addEventListener('pointerup', tell('up'), true);
    addEventListener('pointercancel', tell('up'), true);
}
