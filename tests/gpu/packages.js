'use strict';
const { pathToFileURL } = require('url');

/** A package of NODE_PATH that is a module: Node 18 finds it by `require` but loads it only by `import`. */
function load(name) {
  return import(pathToFileURL(require.resolve(name)));
}

module.exports = { load };
