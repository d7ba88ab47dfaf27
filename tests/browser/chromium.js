'use strict';
const { pathToFileURL } = require('url');
const path = require('path');
const puppeteer = require('puppeteer-core');

/** Debian's Chromium. As root it has no sandbox; the pages are our own. English sets the order of letters. */
async function launch() {
  const browser = await puppeteer.launch({
    executablePath: '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--lang=en-US'],
  });
  const session = await browser.target().createCDPSession();
  const permissions = ['clipboardReadWrite', 'clipboardSanitizedWrite'];
  await session.send('Browser.grantPermissions', { permissions });
  return browser;
}

/** A new tab. What its pages say as an error, throw or ask of a network is pushed to `faults`. */
async function openTab(browser, faults) {
  const tab = await browser.newPage();
  const note = words => faults.push(`${path.basename(tab.url())}: ${words}`);
  tab.on('console', message => {
    if (message.type() === 'error') note(`console error: ${message.text()}`);
  });
  tab.on('pageerror', error => note(`page error: ${error.message}`));
  tab.on('request', request => {
    if (!/^(file|data):/.test(request.url())) note(`asks the network for ${request.url()}`);
  });
  tab.on('requestfailed', request => note(`cannot load ${request.url()}`));
  return tab;
}

const address = (folder, name) => pathToFileURL(path.join(folder, name)).href;

module.exports = { address, launch, openTab };
