'use strict';
const path = require('path');
const { spawn } = require('child_process');

/** What `emit` writes of the catalogue, with its options, one for each family at least. */
const EMITTED = [
  ['fresnel-one-term'], ['fresnel-quadratic'], ['fresnel-cubic'], ['fresnel-quartic'], ['fresnel-fourth'],
  ['fresnel-square'], ['fresnel-rational'], ['sg-offset-mean'], ['sg-offset', '--exponent', '16'],
  ['sg-scaled', '--exponent', '16'], ['phong-blinn-gotanda'], ['phong-blinn', '--exponent', '16'],
];
/** exp2 alone, written here: its error is not hidden by that of its argument. */
const PLAIN_EXP2 = {
  id: 'exp2',
  name: 'plain_exp2',
  variables: [{ name: 'x', low: -14, high: 14 }],
  code: {
    c: '#include <math.h>\nstatic inline float plain_exp2(float x) {\n  return exp2f(x);\n}\n',
    wgsl: 'fn plain_exp2(x: f32) -> f32 {\n  return exp2(x);\n}\n',
    msl: 'inline float plain_exp2(float x) {\n  return metal::exp2(x);\n}\n',
  },
};

/** What a command prints, or an error with what it says. */
function output(command, words) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, words, { stdio: ['ignore', 'pipe', 'pipe'] });
    let out = '', said = '';
    child.stdout.on('data', text => (out += text));
    child.stderr.on('data', text => (said += text));
    child.on('error', reject);
    child.on('close', code => (code === 0 ? resolve(out) : reject(new Error(`${command} ${words.join(' ')}: exit ${code}\n${said}`))));
  });
}

/** The variables of a form with their ranges, from the last line of its comment: "for c in [0, 1], k = 3 to 15 (..)". */
function rangesOf(code) {
  const line = code.match(/^\/\/ (?:Proven|Sampled): .*? for (.*), in exact arithmetic\.$/m)[1];
  return [...line.matchAll(/(\w+) (?:in \[([^,]+), ([^\]]+)\]|= (\S+) to (\S+))/g)]
    .map(([, name, low, high, least, most]) => ({ name, low: Number(low ?? least), high: Number(high ?? most) }));
}

/** The generated code of a form in each of the languages, and its variables. */
async function emitted(command, words, languages) {
  const code = {};
  for (const language of languages) code[language] = await output(command, ['emit', ...words, '--lang', language]);
  const [, name, list] = code.wgsl.match(/^fn (\w+)\((.*)\) -> f32/m);
  const ranges = rangesOf(code.wgsl);
  const variables = list.split(', ').map(argument => ranges.find(range => range.name === argument.split(':')[0]));
  if (variables.includes(undefined)) throw new Error(`${words.join(' ')}: the comment does not say the range of an argument`);
  return { id: words.join(' '), name, variables, code };
}

/** Every form that `bench` measures, with every set of its constants, and every form of a study with every published set. */
async function printedForms(command) {
  return JSON.parse(await output(path.join(path.dirname(command), 'tests/print_forms'), []));
}

/** What `emit` writes of the catalogue; two commands run at a time. */
async function emittedForms(command, languages) {
  const forms = [];
  let next = 0;
  const work = async () => {
    while (next < EMITTED.length) {
      const place = next++;
      forms[place] = await emitted(command, EMITTED[place], languages);
    }
  };
  await Promise.all([work(), work()]);
  return forms;
}

module.exports = { PLAIN_EXP2, emittedForms, output, printedForms };
