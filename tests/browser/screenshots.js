'use strict';
const fs = require('fs');
const path = require('path');
const { address, openTab } = require('./chromium');

const PAGES = ['index', 'acos-linear', 'pq-patry'];
const WIDTHS = [1280, 390];
/** A whole page is too long to look at: the first screens of it. In CSS pixels. */
const MOST_HEIGHT = 2600;

/** Pictures of some pages, for the eye: NAME-WIDTH-SCHEME.png. */
async function takeScreenshots(browser, folder, to) {
  fs.mkdirSync(to, { recursive: true });
  const tab = await openTab(browser, []);
  for (const name of PAGES) {
    for (const width of WIDTHS) {
      await tab.setViewport({ width, height: 900 });
      for (const scheme of ['light', 'dark']) {
        await tab.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
        await tab.goto(address(folder, `${name}.html`));
        const height = Math.min(MOST_HEIGHT, await tab.evaluate(() => document.documentElement.scrollHeight));
        await tab.screenshot({ path: path.join(to, `${name}-${width}-${scheme}.png`), clip: { x: 0, y: 0, width, height } });
      }
    }
  }
  await tab.close();
}

module.exports = { takeScreenshots };
