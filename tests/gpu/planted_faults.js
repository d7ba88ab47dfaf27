'use strict';

/** The specification bounds these by thousands of ulps: where they are, the second digit is wrong, not the third. */
const ROUGH = /\b(a?sin|a?cos|a?tan)\(/;

/** Copies of a shader with one wrong digit, for each constant with so many digits. */
function wrongDigits(code) {
  const comment = code.lastIndexOf('\n//') + 1, start = code.indexOf('\n', comment);
  const head = code.slice(0, start), body = code.slice(start);
  const place = ROUGH.test(body) ? 1 : 2;
  return [...body.matchAll(/\d+\.\d+f/g)].map(found => {
    const digits = [...found[0].matchAll(/\d/g)].filter(({ index }, _, all) => index >= all.find(([digit]) => digit !== '0')?.index);
    if (digits.length <= place) return null;
    const { index } = digits[place], digit = (Number(found[0][index]) + 5) % 10;
    const wrong = found[0].slice(0, index) + digit + found[0].slice(index + 1);
    return { code: head + body.slice(0, found.index) + wrong + body.slice(found.index + found[0].length), words: `${wrong} for ${found[0]}` };
  }).filter(fault => fault);
}

module.exports = { wrongDigits };
