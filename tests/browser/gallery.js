'use strict';
const fs = require('fs');
const { fileURLToPath } = require('url');
const { address, openTab } = require('./chromium');
const { checkContrast } = require('./contrast');
const { checkSearch, checkSort } = require('./index_page');
const { checkCode } = require('./code_blocks');

const WIDE = { width: 1280, height: 900 };
const PHONE = { width: 390, height: 844 };
const SCHEMES = ['light', 'dark'];
/** Smaller words in a picture cannot be read on a phone. In CSS pixels. */
const SMALLEST_WORDS = 9;

async function setScheme(tab, scheme) {
  await tab.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
}

/** One title, one h1, ids that are unique, links that lead to files. */
async function checkStructure(tab, note) {
  const page = await tab.evaluate(() => ({
    title: document.title,
    headings: document.querySelectorAll('h1').length,
    links: [...document.querySelectorAll('a[href]')].map(link => link.href),
    ids: [...document.querySelectorAll('[id]')].map(element => element.id),
  }));
  if (page.title === '') note('has no title');
  if (page.headings !== 1) note(`has ${page.headings} h1`);
  if (new Set(page.ids).size !== page.ids.length) note('has an id twice');
  for (const link of new Set(page.links)) {
    if (link.startsWith('file:') && !fs.existsSync(fileURLToPath(link.split('#')[0]))) note(`dead link: ${link}`);
  }
  return page.links;
}

/** At the width of a phone the page does not scroll sideways; a table may, in its own box. */
async function checkPhone(tab, note) {
  await tab.setViewport(PHONE);
  const found = await tab.evaluate((width, smallest) => {
    const inABox = element => {
      for (let box = element; box !== document.body && box; box = box.parentElement)
        if (['auto', 'scroll'].includes(getComputedStyle(box).overflowX) && box !== element) return true;
      return false;
    };
    const wide = [...document.body.querySelectorAll('*')].filter(
      element => element.getBoundingClientRect().right > width + 0.5 && !inABox(element));
    const size = words => parseFloat(getComputedStyle(words).fontSize) * words.getScreenCTM().a;
    const labels = [...document.querySelectorAll('svg text')];
    return {
      scrolls: document.documentElement.scrollWidth,
      wide: wide.slice(0, 3).map(element => element.outerHTML.slice(0, 80)),
      small: labels.filter(words => size(words) < smallest).length,
      cut: labels.filter(words => {
        const box = words.getBoundingClientRect(), svg = words.ownerSVGElement.getBoundingClientRect();
        return box.left < svg.left - 1 || box.right > svg.right + 1 || box.bottom > svg.bottom + 1 || box.top < svg.top - 1;
      }).map(words => words.textContent),
    };
  }, PHONE.width, SMALLEST_WORDS);
  if (found.scrolls > PHONE.width) note(`is ${found.scrolls} px wide on a screen of ${PHONE.width} px`);
  for (const element of found.wide) note(`is wider than ${PHONE.width} px: ${element}`);
  if (found.small > 0) note(`${found.small} words of a picture are smaller than ${SMALLEST_WORDS} px on a phone`);
  if (found.cut.length > 0) note(`words of a picture are cut on a phone: ${found.cut.join(', ')}`);
  await tab.setViewport(WIDE);
}

/** Everything that any page has to hold; gives the links of the page. */
async function checkPage(tab, folder, name, note) {
  await tab.goto(address(folder, name));
  const links = await checkStructure(tab, note);
  for (const scheme of SCHEMES) {
    await setScheme(tab, scheme);
    await checkContrast(tab, words => note(`${scheme}: ${words}`));
  }
  await checkPhone(tab, note);
  return links;
}

/** Without JavaScript all rows of the table and all code can be read. */
async function checkWithoutScript(browser, folder, name, selector, faults) {
  const tab = await openTab(browser, faults);
  await tab.setJavaScriptEnabled(false);
  await tab.goto(address(folder, name));
  const hidden = await tab.evaluate(selector => {
    const all = [...document.querySelectorAll(selector)];
    return all.filter(element => !element.checkVisibility() || element.innerText.trim() === '').length + (all.length === 0);
  }, selector);
  if (hidden > 0) faults.push(`${name}: without JavaScript ${hidden} of '${selector}' cannot be read`);
  await tab.close();
}

/** The faults of the index and of these pages, each a line. */
async function checkGallery(browser, folder, pages) {
  const faults = [];
  const tab = await openTab(browser, faults);
  tab.setDefaultTimeout(10000);
  await tab.setViewport(WIDE);
  const noteOf = name => words => faults.push(`${name}: ${words}`);

  const onIndex = noteOf('index.html');
  const links = await checkPage(tab, folder, 'index.html', onIndex);
  for (const name of pages) {
    if (!links.includes(address(folder, name))) onIndex(`has no link to ${name}`);
  }
  await checkSearch(tab, onIndex);
  await checkSort(tab, onIndex);
  await checkWithoutScript(browser, folder, 'index.html', 'tbody tr', faults);

  for (const name of pages) {
    const pageLinks = await checkPage(tab, folder, name, noteOf(name));
    if (!pageLinks.includes(address(folder, 'index.html'))) noteOf(name)('has no link to the index');
    await checkCode(tab, noteOf(name));
  }
  if (pages.length > 0) await checkWithoutScript(browser, folder, pages[0], '.code pre', faults);
  await tab.close();
  return faults;
}

module.exports = { PHONE, SCHEMES, WIDE, checkGallery, setScheme };
