'use strict';
// Tests a gallery in Chromium; see ./run for the options. Exit code 1 if there is a fault, 2 if the options are wrong.
const fs = require('fs');
const path = require('path');
const { parseArgs } = require('util');
const { checkGallery } = require('./gallery');
const { launch } = require('./chromium');
const { missedFaults } = require('./planted_faults');
const { takeScreenshots } = require('./screenshots');

/** The options, or an exit with 2 and one line. */
function options() {
  try {
    const { values, positionals } = parseArgs({
      options: { 'self-check': { type: 'boolean' }, screenshots: { type: 'string' } },
      allowPositionals: true,
    });
    const folder = path.resolve(positionals[0] ?? path.join(__dirname, '../../docs/gallery'));
    if (!fs.existsSync(path.join(folder, 'index.html'))) throw new Error(`${folder} has no index.html`);
    return { folder, screenshots: values.screenshots, selfCheck: values['self-check'] };
  } catch (error) {
    console.error(`tests/browser/run: ${error.message}`);
    process.exit(2);
  }
}

async function main() {
  const { folder, screenshots, selfCheck } = options();
  const pages = fs.readdirSync(folder).filter(name => name.endsWith('.html') && name !== 'index.html').sort();
  const browser = await launch();
  try {
    if (screenshots) await takeScreenshots(browser, folder, screenshots);
    const faults = selfCheck ? await missedFaults(browser, folder) : await checkGallery(browser, folder, pages);
    for (const fault of faults) console.error(fault);
    if (faults.length > 0) process.exitCode = 1;
    else if (selfCheck) console.log('Chromium finds every planted fault');
    else console.log(`Chromium finds no fault in the index and ${pages.length} pages`);
  } finally {
    await browser.close();
  }
}

main();
