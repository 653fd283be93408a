// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// node bundle.mjs OUT: page.html with its style and its script, three.js in it, as one file. What `sweepkit view`
// puts in place of the words between @ is left as it is.
import {buildSync} from 'esbuild';
import {readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));

function bundled(file, options) {
  return buildSync({
    entryPoints: [join(here, file)], bundle: true, minify: true, write: false, charset: 'utf8', logLevel: 'error',
    legalComments: 'inline', ...options,
  }).outputFiles[0].text;
}

const parts = {
  '@STYLE@': bundled('src/page.css', {}),
  // A browser ends a script at the first "</script", wherever it stands.
  '@SCRIPT@': bundled('src/page.js', {format: 'iife', target: 'es2020'}).replaceAll('</script', '<\\/script'),
};
let page = readFileSync(join(here, 'src/page.html'), 'utf8');
for (const [mark, text] of Object.entries(parts)) page = page.replace(mark, () => text);
writeFileSync(process.argv[2], page);
