// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// A whole `sweepkit report --quick`, opened in headless Chromium from file://, in a window and on a phone: no error on
// the console, no request but for the page itself; every plot is drawn, has at least two methods and four points, and
// each of its points is a row of the table and of the CSV file. The screenshots of the plots are left in the folder given.
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {launch} from './browser.mjs';
import {freshFolder, sweepkit} from './sweepkit.mjs';

const [program, out] = process.argv.slice(2);
freshFolder(out);
const faults = [];
function expect(holds, what) {
  if (!holds) faults.push(what);
}

const folder = join(out, 'report');
sweepkit(program, 'report', '--quick', '-o', folder, '--quiet');
const file = join(folder, 'index.html');

async function open(browser, options) {
  const page = await browser.newPage(options);
  page.on('console', (message) => expect(message.type() !== 'error', `on the console: ${message.text()}`));
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('request', (request) => expect(/^(data|blob):/.test(request.url()) || request.url() === `file://${file}`, `asks for ${request.url()}`));
  await page.goto(`file://${file}`);
  await page.waitForFunction(() => document.documentElement.dataset.state === 'ready', null, {timeout: 60000});
  return page;
}

// The lines of a CSV file by RFC 4180.
function rowsOf(text) {
  return text.trimEnd().split('\n').map((line) =>
    [...line.replace(/\r$/, '').matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map((cell) => cell[1]?.replaceAll('""', '"') ?? cell[2]));
}

function checkPlot(experiment, plot, csv) {
  const points = plot.curves.flatMap((curve) => curve.points);
  expect(plot.curves.length >= 2, `${plot.name} has ${plot.curves.length} methods`);
  expect(points.length >= 4, `${plot.name} has ${points.length} points`);
  expect(existsSync(join(folder, `${plot.name}.svg`)), `there is no ${plot.name}.svg`);
  for (const [axis, index] of [[plot.x, 0], [plot.y, 1]]) {
    const column = csv[0].indexOf(axis.column);
    expect(points.some((point) => point[index] !== null), `${plot.name}: all of ${axis.column} failed`);
    for (const point of points) {
      const told = csv[1 + point[3]][column];
      expect(point[index] === null ? !Number.isFinite(Number(told)) || told === '' : Number(told) === point[index],
             `${plot.name}: ${point[index]} of ${axis.column} is ${told} in the table`);
    }
  }
}

const report = JSON.parse(readFileSync(join(folder, 'report.json'), 'utf8'));
const browser = await launch([]);
try {
  const wide = await open(browser, {viewport: {width: 1000, height: 800}, colorScheme: 'light'});
  const shown = JSON.parse(await wide.textContent('#report'));
  expect(shown.experiments.length === report.experiments.length, 'the page has other experiments than report.json');
  let plots = 0;
  for (const experiment of shown.experiments) {
    const csv = rowsOf(readFileSync(join(folder, `${experiment.name}.csv`), 'utf8'));
    expect(csv.length === 1 + experiment.rows.length, `${experiment.name}.csv has ${csv.length - 1} rows of ${experiment.rows.length}`);
    for (const plot of experiment.plots) {
      checkPlot(experiment, plot, csv);
      const place = wide.locator('.plot').nth(plots++);
      const marks = await place.locator('svg path').count();
      expect(marks > plot.curves.flatMap((curve) => curve.points).length, `${plot.name} is drawn with ${marks} paths`);
      await place.screenshot({path: join(out, `${plot.name}.png`)});
    }
  }
  expect(await wide.locator('.plot').count() === plots, 'the page has other plots than the report');
  await wide.click('#theme');
  expect(await wide.evaluate(() => document.documentElement.dataset.theme) === 'dark', 'the page cannot be made dark');

  const phone = await open(browser, {viewport: {width: 390, height: 780}, hasTouch: true, isMobile: true, colorScheme: 'dark'});
  const {scroll, inner} = await phone.evaluate(() => ({scroll: document.documentElement.scrollWidth, inner: innerWidth}));
  expect(scroll <= inner, 'on a phone the page is wider than the window');
  await phone.screenshot({path: join(out, 'phone.png')});
} finally {
  await browser.close();
}

if (faults.length > 0) {
  faults.slice(0, 50).forEach((fault) => console.error(fault));
  process.exit(1);
}
