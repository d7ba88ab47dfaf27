'use strict';

/** A node of a formula: { op: 'number', value }, { op: 'variable', name } or { op, parts }. Equal nodes are one object. */
class Nodes {
  constructor() {
    this.known = new Map();
  }
  make(node) {
    const parts = (node.parts ?? []).map(part => part.id);
    const key = JSON.stringify([node.op, node.value, node.name, parts]);
    if (!this.known.has(key)) this.known.set(key, { ...node, id: this.known.size });
    return this.known.get(key);
  }
}

const TOKEN = /\s*((?:[A-Za-z_]\w*::)?[A-Za-z_]\w*|(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?[fh]?|[-+*/()?:,<])/y;

function tokensOf(text) {
  const tokens = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.trimEnd().length) {
    const at = TOKEN.lastIndex, found = TOKEN.exec(text);
    if (!found) throw new Error(`cannot read '${text.slice(at, at + 20)}'`);
    tokens.push(found[1]);
  }
  return tokens;
}

/** Other names of the same functions. */
const NAMES = { fmin: 'min', fmax: 'max', fabs: 'abs' };

/** Reads an expression of C, MSL or WGSL; `names` holds the nodes of the names in it. */
function readExpression(nodes, text, names) {
  const tokens = tokensOf(text);
  let at = 0;
  const peek = () => tokens[at];
  const take = wanted => {
    if (wanted !== undefined && peek() !== wanted) throw new Error(`'${text}' has '${peek()}' in the place of '${wanted}'`);
    return tokens[at++];
  };
  const operation = (op, ...parts) => nodes.make({ op, parts });
  const chain = (signs, next) => () => {
    let left = next();
    while (signs.includes(peek())) left = operation(take(), left, next());
    return left;
  };
  function call(name) {
    const parts = [];
    take('(');
    do parts.push(choice()); while (peek() === ',' && take());
    take(')');
    name = name.replace(/^(std|metal)::/, '');
    if (name === 'select') return operation('?', parts[2], parts[1], parts[0]);
    const plain = names.isC ? name.replace(/f$/, '') : name;
    return operation(NAMES[plain] ?? plain, ...parts);
  }
  function atom() {
    const token = take();
    if (token === '(') {
      const inner = choice();
      take(')');
      return inner;
    }
    if (/^[\d.]/.test(token)) return nodes.make({ op: 'number', value: Math.fround(parseFloat(token)) });
    if (peek() === '(') return call(token);
    if (!names.of.has(token)) throw new Error(`'${text}' has the unknown name '${token}'`);
    return names.of.get(token);
  }
  function sign() {
    if (peek() !== '-') return atom();
    take();
    const inner = sign();
    return inner.op === 'number' ? nodes.make({ op: 'number', value: -inner.value }) : operation('negate', inner);
  }
  const sum = chain('+-', chain('*/', sign));
  function comparison() {
    const left = sum();
    return peek() === '<' ? operation(take(), left, sum()) : left;
  }
  function choice() {
    const condition = comparison();
    if (peek() !== '?') return condition;
    take();
    const yes = choice();
    take(':');
    return operation('?', condition, yes, choice());
  }
  const node = choice();
  if (at !== tokens.length) throw new Error(`'${text}' goes on behind its end`);
  return node;
}

/** The formula that a function returns. Its arguments are called as `variables`, whatever their names. `isC`: names of functions end in f. */
function formulaOf(nodes, code, { name, variables, isC = false }) {
  const [, list, body] = code.match(new RegExp(`^.*\\b${name}_?\\(([^)]*)\\)[^{;]*\\{([^}]*)\\}`, 'm'));
  const own = list.split(',').map(argument => argument.match(/(\w+)\s*(?::\s*f32\s*)?$/)[1]);
  const names = { isC, of: new Map(own.map((argument, i) => [argument, nodes.make({ op: 'variable', name: variables[i].name })])) };
  for (const statement of body.split(';').map(text => text.trim())) {
    const returned = statement.match(/^return\s([^]*)$/), named = statement.match(/^(?:const )?(?:float|let) (\w+) =([^]*)$/);
    if (returned) return readExpression(nodes, returned[1], names);
    if (!named) throw new Error(`cannot read '${statement}'`);
    names.of.set(named[1], readExpression(nodes, named[2], names));
  }
  throw new Error(`${name} returns nothing`);
}

module.exports = { Nodes, formulaOf };
