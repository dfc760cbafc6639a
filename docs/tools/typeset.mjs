// Sets formulas (MathJax; with MathML, and with the words of speech-rule-engine for those who
// listen) and colours code (highlight.js), once, here, so that pages need no script for either.
// usage: node typeset.mjs fragments.json typeset.json
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import hljs from 'highlight.js/lib/core';
import bash from 'highlight.js/lib/languages/bash';
import cmake from 'highlight.js/lib/languages/cmake';
import cpp from 'highlight.js/lib/languages/cpp';
import json from 'highlight.js/lib/languages/json';
import plaintext from 'highlight.js/lib/languages/plaintext';
import python from 'highlight.js/lib/languages/python';
import yaml from 'highlight.js/lib/languages/yaml';

const languages = { bash, cmake, cpp, json, plaintext, python, yaml };
for (const [name, language] of Object.entries(languages)) hljs.registerLanguage(name, language);
hljs.registerAliases(['console', 'shell'], { languageName: 'bash' });
hljs.registerAliases(['diff'], { languageName: 'plaintext' });

const [input, output] = process.argv.slice(2);
const fragments = JSON.parse(readFileSync(input, 'utf8'));
const problems = [];

const mathjax = await createRequire(import.meta.url)('mathjax').init({
  loader: { load: ['input/tex', 'output/svg', 'a11y/assistive-mml', '[tex]/boldsymbol'] },
  tex: {
    packages: ['base', 'ams', 'newcommand', 'boldsymbol'],
    formatError: (jax, error) => { throw error; },
  },
  svg: { fontCache: 'global' },
});
const speech = createRequire(import.meta.url)('speech-rule-engine');
await speech.setupEngine({ locale: 'en', domain: 'clearspeak', modality: 'speech' });
await speech.engineReady();
const adaptor = mathjax.startup.adaptor;

/** A formula as {svg, mathml, number}. */
function formula(tex, display) {
  const tags = [...tex.matchAll(/\\tag\{([^}]*)\}/g)];
  if (tags.length > 1) throw new Error('one \\tag for each formula, please');
  const node = mathjax.tex2svg(tex.replace(/\\tag\{[^}]*\}/, ''), { display });
  const [svg, assistive] = adaptor.childNodes(node);
  const slim = adaptor.outerHTML(svg)
    .replace(/ (data-[\w-]+|role|focusable|xmlns(:\w+)?)="[^"]*"/g, '')
    .replaceAll('xlink:href', 'href')
    .replaceAll('></use>', '/>').replaceAll('></path>', '/>').replaceAll('></rect>', '/>');
  const mathml = adaptor.innerHTML(assistive).replace(/ data-[\w-]+="[^"]*"/g, '');
  const words = speech.toSpeech(mathml).replaceAll('"', '');
  return { svg: slim, mathml: mathml.replace('<math', `<math aria-label="${words}"`), number: tags.length ? tags[0][1] : '' };
}

const formulas = {};
const code = {};
fragments.forEach((fragment, index) => {
  try {
    if (fragment.kind === 'math') {
      formulas[index] = formula(fragment.tex, fragment.display);
    } else if (fragment.kind === 'code') {
      const language = fragment.lang === 'text' ? 'plaintext' : fragment.lang;
      if (!hljs.getLanguage(language)) throw new Error(`no colours for language '${language}'`);
      code[index] = hljs.highlight(fragment.text, { language }).value;
    }
  } catch (error) {
    problems.push(`${error.message}: ${fragment.tex ?? fragment.lang}`);
  }
});

const glyphs = {};
for (const path of adaptor.tags(mathjax.startup.document.outputJax.fontCache.getCache(), 'path'))
  glyphs[adaptor.getAttribute(path, 'id')] = adaptor.getAttribute(path, 'd');

writeFileSync(output, JSON.stringify({ formulas, code, glyphs }));
if (problems.length) {
  console.error(problems.map((problem) => `site: ${problem}`).join('\n'));
  process.exit(1);
}
