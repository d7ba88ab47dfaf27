'use strict';
const { tabTo } = require('./keyboard');

/** The languages of the blocks of code that are shown. */
function shownLanguages(tab) {
  return tab.$$eval('.code', blocks => blocks.filter(block => block.checkVisibility()).map(block => block.dataset.language));
}

/** The shown code against what `press` puts on the clipboard. */
async function judgeCopy(tab, language, how, press, note) {
  const block = await tab.$(`.code[data-language="${language}"]`);
  const wanted = await block.$eval('pre', pre => pre.textContent);
  const before = `nothing copied of ${language}`;
  await tab.evaluate(words => navigator.clipboard.writeText(words), before);
  const button = await block.$('button');
  await button.evaluate(element => (element.textContent = 'copy'));
  try {
    await press(button);
  } catch (error) {
    note(`${language}, by ${how}: ${error.message}`);
    return;
  }
  try {
    await tab.waitForFunction(element => element.textContent !== 'copy', { timeout: 2000 }, button);
  } catch {
    note(`${language}, by ${how}: the button does not say what it did`);
    return;
  }
  const copied = await tab.evaluate(() => navigator.clipboard.readText());
  if (copied !== wanted) note(`${language}, by ${how}: copied ${copied.length} characters, not the ${wanted.length} of the code`);
  if (wanted.trim() === '') note(`${language}: the code is empty`);
}

/** The choice of a language shows one block of code; its button copies it, by mouse and by keyboard. */
async function checkCode(tab, note) {
  await tab.bringToFront();
  const select = await tab.$('select');
  if (!select) {
    note('has no choice of a language');
    return;
  }
  const languages = await select.$$eval('option', options => options.map(option => option.value));
  if ((await shownLanguages(tab)).join() !== languages[0]) note(`shows code in '${await shownLanguages(tab)}' at first`);
  for (const language of languages.slice().reverse()) {
    await tab.select('select', language);
    const shown = await shownLanguages(tab);
    if (shown.join() !== language) note(`shows code in '${shown}', wanted ${language}`);
  }
  await judgeCopy(tab, languages[0], 'mouse', button => button.click(), note);

  await select.focus();
  await tab.keyboard.press('ArrowDown');
  const second = languages[1] ?? languages[0];
  if ((await shownLanguages(tab)).join() !== second) note(`ArrowDown does not choose ${second}`);
  const press = async button => {
    if (!(await tabTo(tab, button))) note('Tab does not reach the copy button with a visible focus');
    await tab.keyboard.press('Enter');
  };
  await judgeCopy(tab, second, 'keyboard', press, note);
}

module.exports = { checkCode };
