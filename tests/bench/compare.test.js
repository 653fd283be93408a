// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// bench/compare and bench/record on reports whose noise and regressions are known.
'use strict';
const assert = require('node:assert');
const {spawnSync} = require('node:child_process');
const {mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync} = require('node:fs');
const {tmpdir} = require('node:os');
const {join} = require('node:path');
const {after, test} = require('node:test');

const bench = join(__dirname, '..', '..', 'bench');
const folder = mkdtempSync(join(tmpdir(), 'compare-'));
after(() => rmSync(folder, {recursive: true}));

const run = (program, ...words) => {
  const {status, stdout, stderr} = spawnSync(join(bench, program), words, {encoding: 'utf8'});
  return {status, out: stdout, err: stderr};
};

// Three methods at six settings; a run's range is 5 % to either side. `change` gets each time and error.
let count = 0;
function report(change = (row) => row) {
  const columns = ['case', 'method', 'steps', 'error', 'seconds', 'seconds_least', 'seconds_most', 'runs'].map((name) => ({name}));
  const rows = ['chords', 'Gauss', 'panels, even'].flatMap((method) => [4, 8, 16, 32, 64, 128].map((steps) => {
    const {seconds, error} = change({method, steps, seconds: 1e-6 * steps, error: 1 / steps});
    return ['ellipse', method, steps, error, seconds, 0.95 * seconds, 1.05 * seconds, 5];
  }));
  const path = join(folder, String(++count));
  mkdirSync(path);
  writeFileSync(join(path, 'report.json'), JSON.stringify({
    sweepkit: '0.1.0', date: `2026-01-01T00:00:${String(count).padStart(2, '0')}Z`, quick: true, machine: {processor: 'A Mill (2)', threads: 2},
    experiments: [{name: 'lengths', columns, rows}],
  }));
  return path;
}

test('noise within the ranges is no regression', () => {
  const {status, out} = run('compare', report(), report(({steps, seconds, error}) => ({seconds: seconds * (steps % 8 ? 1.06 : 0.95), error})));
  assert.equal(status, 0, out);
  assert.match(out, /^36 rows in common/);
  assert.match(out, /nothing is worse/);
});

test('a method half as slow again is told of, and no other', () => {
  const {status, out} = run('compare', report(), report(({method, seconds, error}) => ({seconds: seconds * (method === 'chords' ? 1.5 : 1), error})));
  assert.equal(status, 1);
  assert.match(out, /^slower: lengths: chords: 1\.[45]\d\d times, 6 rows$/m);
  assert.doesNotMatch(out, /: panels/);
});

test('what is faster is told of and is nothing bad', () => {
  const {status, out} = run('compare', report(), report(({method, seconds, error}) => ({seconds: seconds * (method === 'panels, even' ? 0.5 : 1), error})));
  assert.equal(status, 0, out);
  assert.match(out, /^faster: lengths: panels; even: 0\.5/m);
});

test('a machine that is slower for all is taken off', () => {
  const {status, out} = run('compare', report(), report(({seconds, error}) => ({seconds: 1.4 * seconds, error})));
  assert.equal(status, 0, out);
  assert.match(out, /all times together are 1\.400 of before/);
});

test('an error that is larger is told of with its setting', () => {
  const {status, out} = run('compare', report(), report(({steps, seconds, error}) => ({seconds, error: steps === 64 ? 1.1 * error : error})));
  assert.equal(status, 1);
  assert.match(out, /^error larger: lengths: chords \/ ellipse \/ 64: 1\.100 times, 1 row$/m);
});

test('a history is kept for each kind of machine, and its newest measurements count', () => {
  const results = join(folder, 'results');
  const slow = report(({seconds, error}) => ({seconds: 9 * seconds, error}));
  const usual = report();
  assert.equal(run('record', slow, results).status, 0);
  assert.equal(run('record', usual, results).status, 0);
  assert.deepEqual(readdirSync(results), ['a_mill_2_2_threads.csv']);
  const {status, out} = run('compare', join(results, 'a_mill_2_2_threads.csv'), usual);
  assert.equal(status, 0, out);
  assert.match(out, /^36 rows in common; all times together are 1\.000/);
  assert.match(run('record', usual, results).err, /has this report already\n$/);
});

test('what cannot be compared is one line and status 2', () => {
  const other = join(folder, 'other.csv');
  writeFileSync(other, 'a,b\n1,2\n');
  for (const words of [[], [join(folder, 'none'), report()], [other, report()], [folder, report()]]) {
    const {status, out, err} = run('compare', ...words);
    assert.equal(status, 2);
    assert.equal(out, '');
    assert.match(err, /^bench\/compare: [^\n]+\n$/);
  }
});
