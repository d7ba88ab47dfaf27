'use strict';
// Holds the generated WGSL and MSL of all forms against the generated C; see ./run for the options. Exit code 1 if there is a fault, 2 if
// the options are wrong.
const fs = require('fs');
const os = require('os');
const path = require('path');
const { parseArgs } = require('util');
const { enclosures } = require('./accuracy');
const { Nodes, formulaOf } = require('./expression');
const { PLAIN_EXP2, emittedForms, printedForms } = require('./forms');
const { Gpu } = require('./gpu');
const { differingLanguages } = require('./metal');
const { load } = require('./packages');
const { wrongDigits } = require('./planted_faults');
const { onTheProcessor } = require('./processor');

const ROOT = path.join(__dirname, '../..');
/** 2^14 inputs for each form. */
const BITS = 14;
/** At so many of them an interval may be infinite: a pole of the form, or a root of a number that may be below zero. */
const MOST_UNBOUNDED = 0.02;

function options() {
  try {
    const { values, positionals } = parseArgs({
      options: { 'self-check': { type: 'boolean' }, 'exp2-ulps': { type: 'string' }, verbose: { type: 'boolean' } },
      allowPositionals: true,
    });
    const ulps = values['exp2-ulps'] === undefined ? undefined : Number(values['exp2-ulps']);
    if (ulps !== undefined && !(ulps >= 0)) throw new Error(`--exp2-ulps '${values['exp2-ulps']}' must be a number of at least 0`);
    const command = path.resolve(positionals[0] ?? path.join(ROOT, 'build/release/shadefit'));
    if (!fs.existsSync(command)) throw new Error(`there is no '${command}'`);
    return { command, exp2Ulps: ulps === undefined ? undefined : () => ulps, selfCheck: values['self-check'], verbose: values.verbose };
  } catch (error) {
    console.error(`tests/gpu/run: ${error.message}`);
    process.exit(2);
  }
}

/** Floats of each variable: a grid over their ranges, with both ends. */
function inputsOf(variables) {
  const bits = variables.map((_, i) => Math.floor((BITS + i) / variables.length));
  let shift = 0;
  return variables.map(({ low, high }, v) => {
    const steps = 2 ** bits[v], values = new Float32Array(2 ** BITS), from = shift;
    shift += bits[v];
    for (let i = 0; i < values.length; ++i) values[i] = low + ((high - low) * ((i >> from) % steps)) / (steps - 1);
    return values;
  });
}

/** Where a GPU's value is outside of its interval, the first such place in words; and how far from C's values it is. */
function judged(form, inputs, values, processor, { low, high }) {
  let fault = '', off = 0, unbounded = 0, outside = 0;
  for (let i = 0; i < values.length; ++i) {
    if (low[i] === -Infinity || high[i] === Infinity) {
      ++unbounded;
      continue;
    }
    off = Math.max(off, Math.abs(values[i] - processor[i]));
    const is = x => low[i] <= x && x <= high[i];
    if (is(values[i]) && is(processor[i])) continue;
    ++outside;
    const at = form.variables.map(({ name }, v) => `${name} = ${inputs[v][i]}`).join(', ');
    fault ||= `at ${at}: ${values[i]} on the GPU, ${processor[i]} in C; allowed ${low[i]} to ${high[i]}`;
  }
  if (outside > 0) fault = `${outside} of ${values.length} inputs, first ${fault}`;
  if (unbounded > MOST_UNBOUNDED * values.length) fault ||= `no bound at ${unbounded} of ${values.length} inputs`;
  return { fault, off, unbounded };
}

async function main() {
  const { command, exp2Ulps, selfCheck, verbose } = options();
  const gpu = await Gpu.open(), naga = await load('naga-wasm'), nodes = new Nodes();
  const emitted = await emittedForms(command, ['c', 'wgsl', 'msl']);
  const forms = [PLAIN_EXP2, ...emitted, ...(await printedForms(command))];
  const inputs = forms.map(form => inputsOf(form.variables));
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'gpu-'));
  const processor = await onTheProcessor(forms, inputs, folder);
  fs.rmSync(folder, { recursive: true });
  const faults = [];
  let planted = 0;
  for (const [i, form] of forms.entries()) {
    const formula = formulaOf(nodes, form.code.c, { ...form, isC: true });
    for (const language of differingLanguages(naga, nodes, form, formula)) faults.push(`${form.id}: ${language} has another formula than C`);
    const allowed = enclosures(formula, form.variables, inputs[i], exp2Ulps);
    const judge = async code => judged(form, inputs[i], await gpu.run(code, form.name, inputs[i]), processor[i], allowed);
    if (selfCheck) {
      for (const { code, words } of wrongDigits(form.code.wgsl)) {
        ++planted;
        if ((await judge(code)).fault === '') faults.push(`${form.id}: not found on the GPU: ${words}`);
        const wrong = { ...form, code: { ...form.code, wgsl: code } };
        if (differingLanguages(naga, nodes, wrong, formula).length !== 2) faults.push(`${form.id}: not found in the formula: ${words}`);
      }
      continue;
    }
    const { fault, off, unbounded } = await judge(form.code.wgsl);
    if (fault) faults.push(`${form.id}: ${fault}`);
    if (verbose) console.log(`${form.id}: at most ${off.toPrecision(2)} from C${unbounded > 0 ? `, ${unbounded} inputs without a bound` : ''}`);
  }
  for (const fault of faults) console.error(fault);
  if (faults.length > 0) process.exitCode = 1;
  else if (selfCheck) console.log(`${gpu.name}: ${planted} wrong digits are found`);
  else console.log(`${gpu.name}: the WGSL of ${forms.length} forms computes what their C does; their MSL is the formula of naga's`);
  process.exit();  // Dawn holds the process
}

main().catch(error => {
  console.error(error.message);
  process.exit(1);
});
