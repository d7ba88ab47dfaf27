'use strict';
const fs = require('fs');
const path = require('path');
const { output } = require('./forms');

/** A C program that reads the inputs of all forms from a file, and writes what their functions give. */
function programOf(forms, count) {
  const loops = forms.map(({ name, variables }, at) => {
    const list = variables.map((_, i) => `in[${i}][i]`).join(', ');
    return `  for (int j = 0; j < ${variables.length}; ++j)\n    if (fread(in[j], sizeof(float), count, from) != count) return 1;\n` +
      `  for (int i = 0; i < count; ++i) result[i] = ${name}_${at}(${list});\n  if (fwrite(result, sizeof(float), count, to) != count) return 1;\n`;
  });
  return '#include <stdio.h>\n' + forms.map(({ code, name }, at) => code.c.replaceAll(new RegExp(`\\b${name}\\(`, 'g'), `${name}_${at}(`)).join('') +
    `enum { count = ${count} };\nstatic float in[3][count], result[count];\n` +
    `int main(int words, char **word) {\n  if (words != 3) return 1;\n  FILE *from = fopen(word[1], "rb"), *to = fopen(word[2], "wb");\n` +
    `  if (!from || !to) return 1;\n${loops.join('')}  return fclose(to) != 0;\n}\n`;
}

/** What the emitted C computes for each form, compiled without contraction. */
async function onTheProcessor(forms, inputs, folder) {
  const count = inputs[0][0].length, file = name => path.join(folder, name);
  fs.writeFileSync(file('forms.c'), programOf(forms, count));
  fs.writeFileSync(file('inputs'), Buffer.concat(inputs.flat().map(values => Buffer.from(values.buffer))));
  await output('cc', ['-O1', '-ffp-contract=off', '-o', file('forms'), file('forms.c'), '-lm']);
  await output(file('forms'), [file('inputs'), file('results')]);
  const results = fs.readFileSync(file('results'));
  return forms.map((_, i) => new Float32Array(results.buffer.slice(results.byteOffset + 4 * count * i, results.byteOffset + 4 * count * (i + 1))));
}

module.exports = { onTheProcessor };
