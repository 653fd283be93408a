// SPDX-FileCopyrightText: 2026 the sweepkit authors
// SPDX-License-Identifier: MIT
//
// Plots by ECharts, on the page and, without a browser, as SVG files: ECMAScript 5.1 alone, for Duktape runs it too.
// A plot is what libreport/src/json.cpp writes: {title, x, y, lines, curves: [{name, points: [[x, y, label, row]]}], front}.
var sweepkitPlots = (function() {
  // Told apart by people who see few colours, on white and on black (P. Tol, "Colour schemes", 2021), and by shape.
  var COLORS = ['#4477aa', '#ee6677', '#228833', '#ccaa22', '#66aacc', '#aa3377', '#888888', '#dd8844'];
  var SHAPES = ['circle', 'rect', 'triangle', 'diamond', 'emptyCircle', 'emptyRect', 'emptyTriangle', 'emptyDiamond'];
  var LIGHT = {ink: '#1b1f24', quiet: '#5a636e', line: '#d3d8de', ground: '#ffffff'};
  var DARK = {ink: '#e8ebef', quiet: '#9aa4af', line: '#39414a', ground: '#20252b'};
  var PREFIXES = {'-15': 'f', '-12': 'p', '-9': 'n', '-6': 'µ', '-3': 'm', '0': '', '3': 'k', '6': 'M', '9': 'G'};

  // "1e-7", "20 µs" where the axis is one of seconds.
  function numberText(value, axis) {
    if (value === 0) return '0';
    if (/\(s\)$/.test(axis.title)) {
      var power = Math.floor(Math.log(Math.abs(value) * 1.0000001) / Math.LN10 / 3) * 3;
      if (PREFIXES[power] !== undefined) return +(value / Math.pow(10, power)).toPrecision(3) + ' ' + PREFIXES[power] + 's';
    }
    var size = Math.abs(value);
    return size >= 1e-3 && size < 1e5 ? String(+value.toPrecision(4)) : value.toExponential(2).replace(/\.?0+e/, 'e');
  }

  function extent(plot, index) {
    var low = Infinity, high = -Infinity;
    plot.curves.forEach(function(curve) {
      curve.points.forEach(function(point) {
        var value = point[index];
        if (value === null || !(value > 0 || !(index ? plot.y : plot.x).log)) return;
        low = Math.min(low, value);
        high = Math.max(high, value);
      });
    });
    return low <= high ? {low: low, high: high} : {low: 1, high: 10};
  }

  // On a logarithmic axis an error of 0 stands on the lower edge, and what failed on the upper one.
  function bounds(plot, index) {
    var axis = index ? plot.y : plot.x, found = extent(plot, index);
    if (!axis.log) return {min: undefined, max: undefined, top: found.high, bottom: found.low};
    var hasZero = false, hasFailure = false;
    plot.curves.forEach(function(curve) {
      curve.points.forEach(function(point) {
        hasZero = hasZero || point[index] === 0;
        hasFailure = hasFailure || point[index] === null;
      });
    });
    var low = Math.floor(Math.log(found.low) / Math.LN10 + 1e-9) - (hasZero ? 1 : 0);
    var high = Math.ceil(Math.log(found.high) / Math.LN10 - 1e-9) + (hasFailure ? 1 : 0);
    // Whole powers of ten, so many apart that at most eight are named.
    var step = Math.max(Math.ceil((high - low) / 8), 1);
    low = Math.floor(low / step) * step;
    high = Math.max(Math.ceil(high / step) * step, low + step);
    var min = Math.pow(10, low), max = Math.pow(10, high);
    return {min: min, max: max, top: max, bottom: min, interval: step};
  }

  function axisOption(axis, limits, look, isX) {
    return {
      type: axis.log ? 'log' : 'value', scale: isX, name: axis.title, nameLocation: 'middle', nameGap: isX ? 30 : 58,
      min: limits.min, max: limits.max, interval: limits.interval, nameTextStyle: {color: look.ink, fontSize: 12},
      axisLabel: {color: look.quiet, hideOverlap: true, formatter: function(value) { return numberText(value, axis); }},
      axisLine: {show: true, onZero: false, lineStyle: {color: look.quiet}},
      splitLine: {lineStyle: {color: look.line}}, minorSplitLine: {show: false}
    };
  }

  function place(value, limits) {
    return value === null ? limits.top : value === 0 ? limits.bottom : value;
  }

  function curveOption(plot, curve, i, limits) {
    // Beyond eight curves other pairs of colour and shape, dashed.
    var round = Math.floor(i / COLORS.length), color = COLORS[(i + 3 * round) % COLORS.length];
    return {
      name: curve.name, type: 'line', color: color, symbol: SHAPES[i % SHAPES.length], symbolSize: 8, showSymbol: true,
      lineStyle: {width: plot.lines ? 2 : 0, color: color, type: round ? 'dashed' : 'solid'}, emphasis: {focus: 'series'},
      data: curve.points.map(function(point) {
        var hasFailed = point[0] === null || point[1] === null;
        return {
          value: [place(point[0], limits.x), place(point[1], limits.y)],
          symbol: hasFailed ? 'path://M0 0L10 10M10 0L0 10' : point[1] === 0 ? 'arrow' : undefined,
          symbolSize: hasFailed ? 12 : undefined, symbolRotate: point[1] === 0 ? 180 : undefined,
          itemStyle: hasFailed ? {color: 'none', borderColor: color, borderWidth: 3} : undefined,
          told: point
        };
      })
    };
  }

  function frontOption(front, look) {
    return {
      name: 'Pareto front', type: 'line', step: 'end', symbol: 'none', silent: true, z: 1,
      color: look.quiet, lineStyle: {width: 7, color: look.quiet, opacity: 0.25}, data: front
    };
  }

  function tell(plot, curve, point) {
    var text = curve + (plot.label ? '\n' + plot.label + ': ' + point[2] : '');
    [plot.x, plot.y].forEach(function(axis, i) {
      text += '\n' + axis.title + ': ' + (point[i] === null ? 'failed' : numberText(point[i], axis));
    });
    return text + '\nrow ' + (point[3] + 1) + ' of the table';
  }

  // `still`: for paper, with its title and on white.
  function option(plot, isDark, still) {
    var look = isDark ? DARK : LIGHT, limits = {x: bounds(plot, 0), y: bounds(plot, 1)};
    var series = plot.curves.map(function(curve, i) { return curveOption(plot, curve, i, limits); });
    if (plot.front) series.unshift(frontOption(plot.front, look));
    // On paper all names are there, in as many lines as they take.
    var width = 0;
    series.forEach(function(one) { width += 60 + 6.5 * one.name.length; });
    var below = still ? 26 * Math.floor(width / 740) : 0;
    return {
      animation: false, backgroundColor: still ? look.ground : 'transparent',
      textStyle: {fontFamily: 'system-ui, sans-serif', color: look.ink},
      title: still ? {text: plot.title, left: 'center', top: 8, textStyle: {fontSize: 15, color: look.ink}} : undefined,
      legend: {top: still ? 34 : 0, textStyle: {color: look.ink}, type: still ? 'plain' : 'scroll', itemGap: still ? 22 : 10,
        data: series.map(function(one) { return one.step ? {name: one.name, icon: 'rect'} : one.name; })},
      grid: {left: 84, right: 24, top: (still ? 84 : 44) + below, bottom: 54},
      xAxis: axisOption(plot.x, limits.x, look, true), yAxis: axisOption(plot.y, limits.y, look, false),
      tooltip: still ? undefined : {
        trigger: 'item', renderMode: 'richText', confine: true, backgroundColor: look.ground, borderColor: look.line,
        textStyle: {color: look.ink},
        formatter: function(item) { return tell(plot, item.seriesName, item.data.told); }
      },
      dataZoom: still ? undefined : [
        {type: 'inside', xAxisIndex: 0, filterMode: 'none', zoomOnMouseWheel: 'ctrl'},
        {type: 'inside', yAxisIndex: 0, filterMode: 'none', zoomOnMouseWheel: 'ctrl'}],
      series: series
    };
  }

  function svg(plot) {
    var chart = echarts.init(null, null, {renderer: 'svg', ssr: true, width: 760, height: 500});
    chart.setOption(option(plot, false, true));
    var text = chart.renderToSVGString();
    chart.dispose();
    return text;
  }

  return {option: option, svg: svg, numberText: numberText};
})();
