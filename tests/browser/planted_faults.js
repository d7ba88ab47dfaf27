'use strict';
const fs = require('fs');
const os = require('os');
const path = require('path');
const { checkGallery } = require('./gallery');

const PAGE = 'acos-linear.html';
const INDEX = 'index.html';

/** Each fault: the file, a text in it, what takes its place, and what the test has to say of it. */
const FAULTS = [
  [PAGE, '</script>', 'console.error("planted");</script>', /console error: planted/],
  [PAGE, '</script>', 'undefined.planted;</script>', /page error/],
  [PAGE, '</h1>', '</h1><img alt="" src="https://example.invalid/x.png">', /asks the network/],
  [PAGE, '</h1>', '</h1><img alt="" src="missing.png">', /cannot load/],
  [PAGE, '<h1>', '<h1>another</h1><h1>', /has 2 h1/],
  [PAGE, 'href="index.html"', 'href="indexes.html"', /dead link/],
  [PAGE, '</h1>', '</h1><p style="width: 500px">wide</p>', /px wide on a screen/],
  [PAGE, '.scroll { overflow-x: auto; }', 'body { overflow-x: hidden; }', /wider than 390 px/],
  [PAGE, '--soft: #5a5a5a', '--soft: #9a9a9a', /light: .*contrast/],
  [PAGE, '--two: #8ab8ff', '--two: #1b3458', /dark: polyline.*contrast/],
  [PAGE, "querySelector('pre').textContent)", "querySelector('pre').textContent.trim())", /by mouse: copied/],
  [PAGE, '</style>', 'button:focus { outline: none; }</style>', /copy button with a visible focus/],
  [PAGE, 'code.dataset.language !== language.value', 'code.dataset.language < language.value', /shows code in/],
  [PAGE, '</style>', '.code { display: none; } .shown { display: block; }</style>', /without JavaScript/],
  [INDEX, ' : rising ? x - y : y - x', ' : rising ? x - y : x - y', /column 4, descending, by mouse: wrong order/],
  [INDEX, 'isNaN(x) && isNaN(y)', 'true', /wrong order/],
  [INDEX, "setAttribute('aria-sort', 'none')", "removeAttribute('x')", /aria-sort is/],
  [INDEX, '<button type="button">Used in', '<button type="button" tabindex="-1">Used in', /column 2: Tab does not reach/],
  [INDEX, 'words.every', 'words.some', /search .* shows/],
  [INDEX, 'if (!row.hidden) ++shown', '++shown', /search .* says/],
  [INDEX, 'href="acos-linear.html"', 'href="acos-linea.html"', /dead link|has no link to/],
];

/** For each planted fault that is not found, a line. */
async function missedFaults(browser, folder) {
  const missed = [];
  for (const [file, text, instead, wanted] of FAULTS) {
    const copy = fs.mkdtempSync(path.join(os.tmpdir(), 'planted-'));
    for (const name of fs.readdirSync(folder)) fs.symlinkSync(path.join(folder, name), path.join(copy, name));
    const page = fs.readFileSync(path.join(folder, file), 'utf8');
    if (!page.includes(text)) missed.push(`${file} has no '${text}': this fault cannot be planted`);
    fs.rmSync(path.join(copy, file));
    fs.writeFileSync(path.join(copy, file), page.replace(text, () => instead));
    const found = await checkGallery(browser, copy, [PAGE]);
    if (!found.some(fault => wanted.test(fault))) missed.push(`not found: ${wanted} after '${instead}'; found: ${found.join('; ')}`);
    fs.rmSync(copy, { recursive: true });
  }
  return missed;
}

module.exports = { missedFaults };
