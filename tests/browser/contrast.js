'use strict';

/** Of words against what is behind them, and of a curve: WCAG 2.2, success criteria 1.4.3 and 1.4.11, level AA. */
const LEAST_OF_WORDS = 4.5;
const LEAST_OF_CURVES = 3;

/** The pairs of colours on the page with too little contrast; runs in the page. */
function lowContrasts(leastOfWords, leastOfCurves) {
  const context = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  const known = new Map();
  /** Red, green, blue and alpha in [0, 1] of any colour that CSS has. */
  const parts = colour => {
    if (!known.has(colour)) {
      context.clearRect(0, 0, 1, 1);
      context.fillStyle = colour;
      context.fillRect(0, 0, 1, 1);
      known.set(colour, [...context.getImageData(0, 0, 1, 1).data].map(part => part / 255));
    }
    return known.get(colour);
  };
  const over = ([r, g, b, a], under) => [r, g, b].map((part, i) => part * a + under[i] * (1 - a));
  const behind = element => {
    if (!element) return parts(getComputedStyle(document.documentElement).colorScheme === 'dark' ? '#121212' : '#ffffff');
    const own = parts(getComputedStyle(element).backgroundColor);
    return own[3] === 1 ? own : over(own, behind(element.parentElement));
  };
  const linear = part => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
  const luminance = colour => 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) + 0.0722 * linear(colour[2]);
  const contrast = (front, back) => {
    const [dark, light] = [luminance(over(front, back)), luminance(back)].sort((a, b) => a - b);
    return (light + 0.05) / (dark + 0.05);
  };

  const low = new Set();
  const judge = (element, colour, least) => {
    const value = contrast(parts(colour), behind(element));
    if (!(value >= least)) low.add(`${element.localName}.${element.getAttribute('class') ?? ''} has contrast ${value.toFixed(2)}, needs ${least}`);
  };
  for (const element of document.body.querySelectorAll('*')) {
    const style = getComputedStyle(element);
    const isDrawn = element instanceof SVGElement;
    if (['script', 'style', 'option'].includes(element.localName)) continue;
    if (element.localName === 'polyline') judge(element, style.stroke, leastOfCurves);
    const hasWords = [...element.childNodes].some(node => node.nodeType === Node.TEXT_NODE && node.data.trim() !== '');
    if (hasWords || ['input', 'select'].includes(element.localName)) judge(element, isDrawn ? style.fill : style.color, leastOfWords);
  }
  return [...low];
}

async function checkContrast(tab, note) {
  for (const words of await tab.evaluate(lowContrasts, LEAST_OF_WORDS, LEAST_OF_CURVES)) note(words);
}

module.exports = { checkContrast };
