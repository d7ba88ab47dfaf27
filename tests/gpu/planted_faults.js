'use strict';

/** The specification bounds these by thousands of ulps: where they are, the second digit is wrong, not the third. */
const ROUGH = /\b(a?sin|a?cos|a?tan)\(/;

/** The places of the digits of a number, from its first digit that is not 0. */
function digitsOf(text) {
  const digits = [...text.matchAll(/\d/g)];
  return digits.slice(digits.findIndex(([digit]) => digit !== '0')).map(({ index }) => index);
}

/** Copies of a shader with one wrong digit, for each constant with so many digits. If no constant has so many, the last digit of each is wrong. */
function wrongDigits(code) {
  const comment = code.lastIndexOf('\n//') + 1, start = code.indexOf('\n', comment);
  const head = code.slice(0, start), body = code.slice(start);
  const place = ROUGH.test(body) ? 1 : 2;
  const constants = [...body.matchAll(/\d+\.\d+f/g)].map(({ 0: text, index }) => ({ text, index, digits: digitsOf(text) }));
  const long = constants.filter(({ digits }) => digits.length > place);
  return (long.length > 0 ? long : constants).map(({ text, index, digits }) => {
    const at = digits[Math.min(place, digits.length - 1)], digit = (Number(text[at]) + 5) % 10;
    const wrong = text.slice(0, at) + digit + text.slice(at + 1);
    return { code: head + body.slice(0, index) + wrong + body.slice(index + text.length), words: `${wrong} for ${text}` };
  });
}

module.exports = { wrongDigits };
