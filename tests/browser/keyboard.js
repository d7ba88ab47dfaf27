'use strict';

/** The most stops between two controls of a page. */
const MOST_STOPS = 30;

/** Presses Tab until the element has the focus. False if it never gets it, or if the focus cannot be seen. */
async function tabTo(tab, handle) {
  for (let stop = 0; stop < MOST_STOPS; ++stop) {
    await tab.keyboard.press('Tab');
    const state = await handle.evaluate(element => {
      if (document.activeElement !== element) return 'elsewhere';
      const style = getComputedStyle(element);
      return style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 1 ? 'seen' : 'unseen';
    });
    if (state !== 'elsewhere') return state === 'seen';
  }
  return false;
}

module.exports = { tabTo };
