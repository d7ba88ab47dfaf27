'use strict';
const { tabTo } = require('./keyboard');

/** The texts of the rows that are shown, a list of cells each, and what the page says about their number. */
function shownRows(tab) {
  return tab.evaluate(() => ({
    rows: [...document.querySelectorAll('table.sortable tbody tr')]
      .filter(row => row.checkVisibility())
      .map(row => [...row.cells].map(cell => cell.textContent)),
    said: document.querySelector('#shown').textContent,
  }));
}

/** The search keeps the rows that have all words, in any case, and says how many. */
async function checkSearch(tab, note) {
  const all = (await shownRows(tab)).rows;
  const [id, , verdict] = all[0];
  const firstWord = verdict.split(/\W/)[0];
  for (const words of ['', id, firstWord, id.toUpperCase() + '  ' + firstWord, 'no such words']) {
    await tab.click('input[type=search]', { count: 3 });
    await tab.keyboard.press('Backspace');
    await tab.keyboard.type(words);
    const { rows, said } = await shownRows(tab);
    const wanted = all.filter(row => words.toLowerCase().split(/\s+/).every(word => row.join('').toLowerCase().includes(word)));
    if (JSON.stringify(rows) !== JSON.stringify(wanted)) note(`search '${words}' shows ${rows.length} rows, wanted ${wanted.length}`);
    if (parseInt(said) !== wanted.length) note(`search '${words}' says '${said}', wanted ${wanted.length}`);
  }
  await tab.click('input[type=search]', { count: 3 });
  await tab.keyboard.press('Backspace');
}

/** Numbers by their value, with "exact" as 0; words by the alphabet. Empty cells come last, up and down. */
function isSorted(cells, rising) {
  const filled = cells.filter(cell => cell !== '');
  if (cells.slice(filled.length).some(cell => cell !== '')) return false;
  const value = cell => (cell === 'exact' ? 0 : Number(cell));
  const areNumbers = filled.every(cell => !Number.isNaN(value(cell)));
  const words = new Intl.Collator('en-US');
  const compare = areNumbers ? (a, b) => value(a) - value(b) : words.compare;
  return filled.every((cell, i) => i === 0 || compare(filled[i - 1], cell) * (rising ? 1 : -1) <= 0);
}

async function judgeSort(tab, column, rising, unsorted, how, note) {
  const { rows } = await shownRows(tab);
  const states = await tab.$$eval('table.sortable th', heads => heads.map(head => head.getAttribute('aria-sort')));
  const name = `column ${column + 1}, ${rising ? 'ascending' : 'descending'}, by ${how}`;
  if (!isSorted(rows.map(row => row[column]), rising)) note(`${name}: wrong order`);
  const wanted = states.map((_, i) => (i !== column ? 'none' : rising ? 'ascending' : 'descending'));
  if (states.join() !== wanted.join()) note(`${name}: aria-sort is ${states.join()}`);
  const same = list => JSON.stringify(list.map(row => row.join('\n')).sort());
  if (same(rows) !== same(unsorted)) note(`${name}: the rows are not the same as before`);
}

/** Each column sorts up, then down: by mouse and by Tab and Enter. */
async function checkSort(tab, note) {
  const { rows } = await shownRows(tab);
  if (rows.length === 0) {
    note('shows no row to sort');
    return;
  }
  const buttons = await tab.$$('table.sortable th button');
  if (buttons.length !== rows[0].length) note(`${buttons.length} of ${rows[0].length} columns have a button`);
  for (const [column, button] of buttons.entries()) {
    for (const rising of [true, false]) {
      await button.click();
      await judgeSort(tab, column, rising, rows, 'mouse', note);
    }
  }
  await tab.focus('input[type=search]');
  for (const [column, button] of buttons.entries()) {
    if (!(await tabTo(tab, button))) {
      note(`column ${column + 1}: Tab does not reach its button with a visible focus`);
      return;
    }
    // The last column is still sorted from the mouse: its first Enter sorts it up again.
    for (const rising of [true, false]) {
      await tab.keyboard.press('Enter');
      await judgeSort(tab, column, rising, rows, 'keyboard', note);
    }
  }
}

module.exports = { checkSort, checkSearch };
