'use strict';
const { formulaOf } = require('./expression');

/** Of WGSL, MSL and the MSL that naga makes of the WGSL, those that are not this formula. */
function differingLanguages({ translate }, nodes, form, formula) {
  const { code } = form, differing = [];
  const compare = (language, text, options = {}) => {
    if (formulaOf(nodes, text, { ...form, ...options }) !== formula) differing.push(language);
  };
  compare('WGSL', code.wgsl);
  compare('MSL', code.msl);
  compare('MSL by naga', translate({ from: 'wgsl', to: 'msl', source: code.wgsl }));
  return differing;
}

module.exports = { differingLanguages };
