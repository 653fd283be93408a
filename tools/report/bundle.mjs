// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// node bundle.mjs PAGE SCRIPT: page.html with its style and scripts, ECharts in it, as one file; and the script that
// draws a plot, ECharts and all, for the program to run by itself. What `sweepkit report` puts in place of the words
// between @ is left as it is.
import {buildSync, transformSync} from 'esbuild';
import {readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const read = file => readFileSync(join(here, file), 'utf8');
const minify = (text, loader) => transformSync(text, {loader, minify: true, charset: 'utf8'}).code;

// The charts in common use, as ECharts' own makers built it for browsers and engines of ECMAScript 5.
const plots = read('node_modules/echarts/dist/echarts.common.min.js') + '\n' + read('src/plots.js');
const parts = {
  '@STYLE@': minify(read('src/page.css'), 'css'),
  '@PLOTS@': plots,
  '@SCRIPT@': buildSync({
    entryPoints: [join(here, 'src/page.js')], bundle: true, minify: true, write: false, charset: 'utf8', format: 'iife',
    target: 'es2020', logLevel: 'error',
  }).outputFiles[0].text,
};
let page = read('src/page.html');
// A browser ends a script at the first "</script", wherever it stands.
for (const [mark, text] of Object.entries(parts)) page = page.replace(mark, () => text.replaceAll('</script', '<\\/script'));
writeFileSync(process.argv[2], page);
writeFileSync(process.argv[3], plots);
