// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// What `sweepkit report` measured, as rows that one can lay beside those of another day: a time with its range, or an
// error, under a name that says what was measured and how.
'use strict';
const {existsSync, readFileSync, statSync} = require('node:fs');
const {join} = require('node:path');

// Errors are the same on every run: what is larger than before is no noise.
const kErrors = ['error', 'error_largest', 'radians', 'metres', 'rmse'];

// The column that names what is compared: all its rows are judged together, whatever the case and the knob.
const kMethods = ['method', 'filter', 'accelerator', 'work', 'way'];

// The history's fields are not quoted.
const plain = (text) => text.replaceAll(/[,\n]/g, ';');

/** How many of the first columns it takes to tell all rows apart. */
function keyLength(rows) {
  const longest = rows[0]?.length ?? 0;
  for (let length = 1; length < longest; ++length) {
    if (new Set(rows.map((row) => JSON.stringify(row.slice(0, length)))).size === rows.length) return length;
  }
  return longest;
}

/** The rows {table, method, setting, what, value, least, most} of a report.json; errors have no range. */
function rowsOfReport(report) {
  return report.experiments.flatMap(({name: table, columns, rows}) => {
    const at = new Map(columns.map(({name}, index) => [name, index]));
    const length = keyLength(rows);
    return rows.flatMap((row) => {
      const named = columns.slice(0, length).findIndex((column) => kMethods.includes(column.name));
      const method = String(row[Math.max(named, 0)]);
      const setting = row.slice(0, length).filter((value, index) => index !== named && value !== '').join(' / ');
      const measured = [];
      const add = (what, ...values) => {
        if (values.every((value) => typeof value === 'number' && Number.isFinite(value))) {
          measured.push({table, method: plain(method), setting: plain(setting), what, value: values[0], least: values[1] ?? values[0], most: values[2] ?? values[0]});
        }
      };
      if (at.has('seconds_least')) add('seconds', ...['seconds', 'seconds_least', 'seconds_most'].map((column) => row[at.get(column)]));
      for (const column of kErrors) {
        if (at.has(column) && at.get(column) >= length) add(column, row[at.get(column)]);
      }
      return measured;
    });
  });
}

const kColumns = ['date', 'version', 'quick', 'table', 'what', 'value', 'least', 'most', 'method', 'setting'];

/** A line of a history file. No time is worth more than five digits. */
function lineOf(report, row) {
  const numbers = [row.value, row.least, row.most].map((value) => Number(value.toPrecision(5)));
  return [report.date, report.sweepkit, report.quick, row.table, row.what, ...numbers, row.method, row.setting].join(',');
}

function rowsOfHistory(text, file) {
  const [head, ...lines] = text.trimEnd().split('\n');
  if (head !== kColumns.join(',')) throw new Error(`${file}: is no history of measurements (its first line is not ${kColumns.join(',')})`);
  const rows = lines.map((line) => {
    const [date, version, quick, table, what, value, least, most, method, setting] = line.split(',');
    return {date, version, quick, table, what, value: Number(value), least: Number(least), most: Number(most), method, setting};
  });
  const last = rows.at(-1)?.date;
  return rows.filter(({date}) => date === last);
}

function readReport(folder) {
  const file = join(folder, 'report.json');
  if (!existsSync(file)) throw new Error(`${folder}: holds no report.json; sweepkit report -o ${folder} makes one`);
  return JSON.parse(readFileSync(file, 'utf8'));
}

/** Of a report's folder, or the newest ones of a history file. */
function readRows(path) {
  if (!existsSync(path)) throw new Error(`${path}: there is no such file or folder`);
  return statSync(path).isDirectory() ? rowsOfReport(readReport(path)) : rowsOfHistory(readFileSync(path, 'utf8'), path);
}

/** What it says of an Error goes to the user in one line. */
function withMessages(name, run) {
  try {
    process.exitCode = run(process.argv.slice(2));
  } catch (error) {
    console.error(`${name}: ${error.message}`);
    process.exitCode = 2;
  }
}

module.exports = {kColumns, lineOf, readReport, readRows, rowsOfReport, withMessages};
