'use strict';
// What a GPU may compute: intervals that hold every result that the specification of WGSL allows. Source: WGSL,
// 15.7 "Floating Point Evaluation": correct rounding is to either neighbour, operands and results that are
// subnormal may be flushed to zero, and a reassociated or fused expression has to be at least as accurate. Each
// interval holds the exact result too, so a fused one is inside.

const LEAST_NORMAL = 2 ** -126;
/** A double is rounded by so much; the functions of JavaScript are far more exact than the bounds here. */
const DOUBLE = 2 ** -50;
const ANYTHING = [-Infinity, Infinity];

const number = new Float64Array(1), bits = new Uint32Array(number.buffer);

/** An ulp of x as a float. */
function ulpOf(x) {
  number[0] = x;
  return 2 ** (Math.max(((bits[1] >>> 20) & 0x7ff) - 1023, -126) - 23);
}

/** [low, high] with an error of some ulps and an absolute one; subnormal numbers may be zero. */
function widened([low, high], ulps, absolute = 0) {
  if (Number.isNaN(low) || Number.isNaN(high)) return ANYTHING;
  const most = Math.max(Math.abs(low), Math.abs(high)), error = ulps * ulpOf(most) + most * DOUBLE + absolute;
  low -= error;
  high += error;
  // an infinite result is of no value
  if (Math.abs(low) >= 2 ** 128 || Math.abs(high) >= 2 ** 128) return ANYTHING;
  return [low > 0 && low < LEAST_NORMAL ? 0 : low, high < 0 && high > -LEAST_NORMAL ? 0 : high];
}

function corners(operation, [a, b], [c, d]) {
  const values = [operation(a, c), operation(a, d), operation(b, c), operation(b, d)];
  return [Math.min(...values), Math.max(...values)];
}

/** exp and exp2: 3 + 2 |x| ulp. */
const usualExp2Ulps = x => 3 + 2 * Math.abs(x);

function exponential(operation, [low, high], ulps) {
  const [least] = widened([operation(low), operation(low)], ulps(low)), [, most] = widened([operation(high), operation(high)], ulps(high));
  return [Math.max(least, 0), most];
}

/** log and log2: 2^-21 for x in [0.5, 2], else 3 ulp; here their sum. */
const logarithm = (operation, [low, high]) => (low < 0 ? ANYTHING : low === 0 && high === 0 ? [-Infinity, -Infinity]
  : [low === 0 ? -Infinity : widened([operation(low), 0], 3, 2 ** -21)[0], widened([0, operation(high)], 3, 2 ** -21)[1]]);

/** sin and cos: 2^-11 for x in [-pi, pi]; beyond, where WGSL says nothing, the same. */
function wave(operation, [low, high], phase) {
  const turn = 2 * Math.PI, holds = peak => Math.ceil((low - peak) / turn) * turn + peak <= high;
  const ends = [operation(low), operation(high)];
  return widened([holds(phase + Math.PI) ? -1 : Math.min(...ends), holds(phase) ? 1 : Math.max(...ends)], 0, 2 ** -11);
}

const rising = (operation, [low, high]) => [operation(low), operation(high)];

/** The functions and operations, by their names. acos and asin are inherited from atan2, which is within 4096 ulp. */
function operationsFor(exp2Ulps) {
  const operations = {
    '+': ([a, b], [c, d]) => widened([a + c, b + d], 1),
    '-': ([a, b], [c, d]) => widened([a - d, b - c], 1),
    '*': (x, y) => widened(corners((a, b) => a * b, x, y), 1),
    '/': (x, y) => (y[0] <= 0 && 0 <= y[1] ? ANYTHING : widened(corners((a, b) => a / b, x, y), 2.5)),
    negate: ([low, high]) => [-high, -low],
    abs: ([low, high]) => (low >= 0 ? [low, high] : high <= 0 ? [-high, -low] : [0, Math.max(-low, high)]),
    min: ([a, b], [c, d]) => [Math.min(a, c), Math.min(b, d)],
    max: ([a, b], [c, d]) => [Math.max(a, c), Math.max(b, d)],
    floor: x => rising(Math.floor, x),
    '<': ([a, b], [c, d]) => [b < c ? 1 : 0, a < d ? 1 : 0],
    '?': ([no, yes], x, y) => (no === 1 ? x : yes === 0 ? y : [Math.min(x[0], y[0]), Math.max(x[1], y[1])]),
    exp: x => exponential(Math.exp, x, usualExp2Ulps),
    exp2: x => exponential(v => 2 ** v, x, exp2Ulps),
    log: x => logarithm(Math.log, x),
    log2: x => logarithm(Math.log2, x),
    // 1/inverseSqrt(x), within 2 ulp and 2.5 ulp
    sqrt: ([low, high]) => (low < 0 ? ANYTHING : [Math.max(0, widened([Math.sqrt(low), 0], 5)[0]), widened([0, Math.sqrt(high)], 5)[1]]),
    sin: x => wave(Math.sin, x, Math.PI / 2),
    cos: x => wave(Math.cos, x, 0),
    tan: x => operations['/'](operations.sin(x), operations.cos(x)),
    atan: x => widened(rising(Math.atan, x), 4096),
    asin: x => (x[0] < -1 || x[1] > 1 ? ANYTHING : widened(rising(Math.asin, x), 4096, 6.81e-5)),
    acos: x => (x[0] < -1 || x[1] > 1 ? ANYTHING : widened([Math.acos(x[1]), Math.acos(x[0])], 4096, 6.77e-5)),
    // inherited from exp2(y log2 x); the log2 of 0 may be that of any number below the least normal one
    pow: (x, y) => (x[0] < 0 || (x[0] === 0 && y[0] <= 0) ? ANYTHING : x[0] === 0 ? [0, operations.pow(Array(2).fill(Math.max(x[1], LEAST_NORMAL)), y)[1]]
      : operations.exp2(operations['*'](operations.log2(x), y))),
  };
  return operations;
}

/** For each input the interval of a formula's results, as two arrays; an unknown function is an error. */
function enclosures(formula, variables, inputs, exp2Ulps = usualExp2Ulps) {
  const operations = operationsFor(exp2Ulps), count = inputs[0].length;
  const low = new Float64Array(count), high = new Float64Array(count);
  const order = [], seen = new Set();
  const visit = node => {
    if (seen.has(node)) return;
    seen.add(node);
    (node.parts ?? []).forEach(visit);
    order.push(node);
  };
  visit(formula);
  for (const node of order) {
    if (node.parts && !operations[node.op]) throw new Error(`the accuracy of '${node.op}' is not known here`);
  }
  const values = new Map();
  for (let i = 0; i < count; ++i) {
    for (const node of order) {
      if (node.op === 'number') values.set(node, [node.value, node.value]);
      else if (node.op === 'variable') {
        const x = inputs[variables.findIndex(variable => variable.name === node.name)][i];
        values.set(node, Math.abs(x) < LEAST_NORMAL ? [Math.min(x, 0), Math.max(x, 0)] : [x, x]);
      } else values.set(node, operations[node.op](...node.parts.map(part => values.get(part))));
    }
    [low[i], high[i]] = values.get(formula);
    if (!(low[i] <= high[i])) [low[i], high[i]] = ANYTHING;
  }
  return { low, high };
}

module.exports = { enclosures };
