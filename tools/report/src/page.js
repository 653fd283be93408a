// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
const report = JSON.parse(document.getElementById('report').textContent);
const charts = [];

function element(name, properties = {}, ...children) {
  const node = Object.assign(document.createElement(name), properties);
  node.append(...children);
  return node;
}

const isDark = () => document.documentElement.dataset.theme === 'dark';

function tableOf(experiment) {
  const head = element('tr', {}, element('th', {textContent: '#'}),
    ...experiment.columns.map(column => element('th', {textContent: column.title, title: column.name})));
  const body = element('tbody');
  experiment.rows.forEach((row, i) => {
    const cells = row.map((value, k) => typeof value === 'string' ? element('td', {textContent: value})
      : element('td', {className: 'number', title: value === null ? '' : String(value),
        textContent: value === null ? 'failed' : sweepkitPlots.numberText(value, experiment.columns[k])}));
    body.append(element('tr', {id: `${experiment.name}-${i}`}, element('td', {className: 'number', textContent: i + 1}), ...cells));
  });
  return element('details', {open: experiment.plots.length === 0},
    element('summary', {textContent: `All ${experiment.rows.length} rows, as in ${experiment.name}.csv`}),
    element('div', {className: 'scroll'}, element('table', {}, element('thead', {}, head), body)));
}

// A click on a point opens the table at its row.
function showRow(experiment, index) {
  const row = document.getElementById(`${experiment.name}-${index}`);
  for (const old of document.querySelectorAll('tr.told')) old.classList.remove('told');
  row.classList.add('told');
  row.closest('details').open = true;
  row.scrollIntoView({block: 'nearest'});
}

function addPlot(experiment, plot, section) {
  const place = element('div', {className: 'plot', role: 'img', ariaLabel: plot.title});
  section.append(element('h3', {textContent: plot.title}), place);
  const chart = echarts.init(place, null, {renderer: 'svg'});
  chart.on('click', item => item.data.told && showRow(experiment, item.data.told[3]));
  charts.push({chart, plot});
}

function addExperiment(experiment) {
  const section = element('section', {id: experiment.name}, element('h2', {textContent: experiment.title}),
    element('p', {textContent: experiment.what}), element('p', {className: 'how', textContent: experiment.how}));
  document.getElementById('experiments').append(section);
  for (const plot of experiment.plots) addPlot(experiment, plot, section);
  section.append(tableOf(experiment));
}

function draw() {
  for (const {chart, plot} of charts) {
    chart.setOption(sweepkitPlots.option(plot, isDark(), false), true);
    chart.resize();
  }
}

function setTheme(isDarkNow) {
  document.documentElement.dataset.theme = isDarkNow ? 'dark' : 'light';
  draw();
}

const {machine} = report;
document.getElementById('made').textContent =
  `sweepkit ${report.sweepkit}, ${report.date}${report.quick ? ', a quick run' : ''}. ${machine.processor}, ` +
  `${machine.threads} threads, ${machine.memory_gib} GiB; ${machine.system}; ${machine.compiler}. ` +
  'Times are medians of at least five runs. The grey band is the Pareto front: no point is both cheaper and more exact. Click a point for its row; drag to move, Ctrl and the wheel to zoom.';
document.getElementById('contents').append(element('ul', {}, ...report.experiments.map(
  one => element('li', {}, element('a', {href: `#${one.name}`, textContent: one.title})))));
report.experiments.forEach(addExperiment);
document.getElementById('theme').addEventListener('click', () => setTheme(!isDark()));
const asked = matchMedia('(prefers-color-scheme: dark)');
asked.addEventListener('change', () => setTheme(asked.matches));
addEventListener('resize', draw);
// Paper is white.
addEventListener('beforeprint', () => setTheme(false));
setTheme(asked.matches);
document.documentElement.dataset.state = 'ready';
