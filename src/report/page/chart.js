// Line charts over time, or over what spec.x says. D3 version 3.
var pmr = pmr || {};

pmr.data = JSON.parse(document.getElementById("pmr-data").textContent);
pmr.time = { scale: "linear", cursor: null };

// A column is an array of numbers, or the name of one that charts share.
pmr.column = function (reference) {
  return typeof reference === "string" ? pmr.data.columns[reference] : reference;
};

pmr.superscript = function (n) {
  return String(n).replace(/[0-9-]/g, (c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[+c]));
};

// As many digits as a reader wants: four significant ones.
pmr.number = function (v) {
  if (v === null || !isFinite(v)) return "–";
  if (v === 0) return "0";
  var size = Math.abs(v);
  if (size >= 1e6 || size < 1e-3) {
    var power = Math.floor(Math.log(size) / Math.LN10 + 1e-12);
    var mantissa = v / Math.pow(10, power);
    var text = Math.abs(mantissa - 1) < 1e-9 ? "" : mantissa.toFixed(2).replace("-", "−") + "·";
    return text + "10" + pmr.superscript(power);
  }
  var decimals = Math.max(0, 3 - Math.floor(Math.log(size) / Math.LN10 + 1e-12));
  var rounded = v.toFixed(Math.min(decimals, 6));
  if (rounded.indexOf(".") >= 0) rounded = rounded.replace(/\.?0+$/, "");
  return rounded.replace("-", "−");
};

pmr.with_unit = function (v, unit) {
  return pmr.number(v) + (unit && unit !== "1" ? " " + unit : "");
};

pmr.axis_title = function (label, unit) {
  return label + " [" + (unit || "1") + "]";
};

// A tick of a linear axis: the decimals its step needs, so that no two ticks read alike.
pmr.tick = function (v, ticks) {
  var step = ticks.length > 1 ? Math.abs(ticks[1] - ticks[0]) : Math.abs(v);
  if (v === 0 || step < 1e-6 || step > 1e6) return pmr.number(v);
  return v.toFixed(Math.max(0, Math.ceil(-Math.log(step) / Math.LN10 - 1e-9))).replace("-", "−");
};

// Ticks of a log axis: the decades, with 2 and 5 between them where there are few.
pmr.log_ticks = function (domain, room) {
  var low = Math.floor(Math.log(domain[0]) / Math.LN10 - 1e-9),
    high = Math.ceil(Math.log(domain[1]) / Math.LN10 + 1e-9);
  var decades = Math.log(domain[1] / domain[0]) / Math.LN10;
  var steps = decades < 2.2 ? [1, 2, 5] : [1],
    stride = Math.max(1, Math.ceil(decades / room)),
    ticks = [];
  for (var k = low; k <= high; k += stride)
    steps.forEach(function (s) {
      var v = s * Math.pow(10, k);
      if (v >= domain[0] * 0.9999 && v <= domain[1] * 1.0001) ticks.push(v);
    });
  return ticks;
};

// Values of a line as shown: factor and offset of the axis applied, gaps left as null.
pmr.points = function (line, axis) {
  var factor = axis.factor || 1,
    offset = axis.offset || 0;
  function shown(v) {
    return v === null || v === undefined ? null : factor * v + offset;
  }
  var x = pmr.column(line.x),
    y = pmr.column(line.y);
  var low = line.low ? pmr.column(line.low) : null,
    high = line.high ? pmr.column(line.high) : null;
  return x.map(function (t, k) {
    return { x: t, y: shown(y[k]), low: low && shown(low[k]), high: high && shown(high[k]) };
  });
};

pmr.y_scale = function (all, axis, height) {
  var values = [];
  all.forEach(function (points) {
    points.forEach(function (p) {
      [p.y, p.low, p.high].forEach(function (v) {
        if (v !== null && v !== undefined && isFinite(v)) values.push(v);
      });
    });
  });
  if (axis.scale === "log") {
    var positive = values.filter((v) => v > 0);
    var top = d3.max(positive) || 1,
      bottom = Math.max(d3.min(positive) || 0.1, top * 1e-6);
    if (top / bottom < 3) {
      top *= 1.5;
      bottom /= 1.5;
    }
    return d3.scale
      .log()
      .domain([bottom / 1.15, top * 1.15])
      .range([height, 0])
      .clamp(true);
  }
  var low = d3.min(values),
    high = d3.max(values),
    span = high - low || Math.abs(high) * 0.1 || 1;
  // From zero where zero is near; a little less than nothing gets a little room only.
  if (low < 0 && low > -0.1 * high)
    return d3.scale
      .linear()
      .domain([1.2 * low, 1.04 * high])
      .range([height, 0]);
  if (low >= 0 && low < 0.35 * high) low = 0;
  else low -= 0.04 * span;
  return d3.scale
    .linear()
    .domain([low, high + 0.04 * span])
    .range([height, 0])
    .nice(5);
};

pmr.is_log_time = function (spec) {
  return !spec.x && pmr.time.scale === "log";
};

pmr.x_scale = function (all, spec, width) {
  var xs = d3
    .merge(all)
    .filter((p) => p.y !== null)
    .map((p) => p.x);
  if (spec.x) return d3.scale.linear().domain(d3.extent(xs)).range([0, width]);
  if (pmr.is_log_time(spec)) {
    var positive = xs.filter((x) => x > 0);
    return d3.scale
      .log()
      .domain([Math.max(d3.min(positive), d3.max(positive) * 1e-5, 1e-2), d3.max(positive)])
      .range([0, width]);
  }
  return d3.scale
    .linear()
    .domain([Math.min(0, d3.min(xs)), d3.max(xs)])
    .range([0, width]);
};

pmr.draw_axes = function (svg, x, y, size, spec) {
  var log_y = spec.y.scale === "log",
    log_x = pmr.is_log_time(spec);
  var y_ticks = log_y ? pmr.log_ticks(y.domain(), 6) : y.ticks(5);
  var x_ticks = log_x
    ? pmr.log_ticks(x.domain(), 7)
    : x.ticks(Math.max(3, Math.round(size.width / 90)));
  var grid = svg.append("g").attr("class", "grid"),
    axis = svg.append("g").attr("class", "axis");
  y_ticks.forEach(function (v) {
    grid.append("line").attr({ x1: 0, x2: size.width, y1: y(v), y2: y(v) });
    axis
      .append("text")
      .attr({ x: -7, y: y(v) + 4, "text-anchor": "end" })
      .text(log_y ? pmr.number(v) : pmr.tick(v, y_ticks));
  });
  x_ticks.forEach(function (v) {
    grid.append("line").attr({ x1: x(v), x2: x(v), y1: 0, y2: size.height });
    axis.append("line").attr({ x1: x(v), x2: x(v), y1: size.height, y2: size.height + 4 });
    axis
      .append("text")
      .attr({ x: x(v), y: size.height + 17, "text-anchor": "middle" })
      .text(log_x ? pmr.number(v) : pmr.tick(v, x_ticks));
  });
  axis.append("path").attr("d", "M0,0V" + size.height + "H" + size.width);
  svg
    .append("text")
    .attr({ x: -size.left + 2, y: -9, "class": "strong" })
    .text(pmr.axis_title(spec.y.label, spec.y.unit));
  svg
    .append("text")
    .attr({ x: size.width, y: size.height + 33, "text-anchor": "end", "class": "strong" })
    .text(spec.x ? pmr.axis_title(spec.x.label, spec.x.unit) : "time since release [s]");
};

pmr.draw_lines = function (svg, spec, all, x, y) {
  function drawable(p) {
    return (
      p.y !== null &&
      (spec.y.scale !== "log" || p.y >= y.domain()[0]) &&
      (!pmr.is_log_time(spec) || p.x >= x.domain()[0])
    );
  }
  var line = d3.svg
    .line()
    .defined(drawable)
    .x((p) => x(p.x))
    .y((p) => y(p.y));
  var area = d3.svg
    .area()
    .defined(drawable)
    .x((p) => x(p.x))
    .y0((p) => y(p.low))
    .y1((p) => y(p.high));
  spec.lines.forEach(function (l, k) {
    if (l.low) svg.append("path").attr({ "class": "band", d: area(all[k]), fill: l.colour });
  });
  spec.lines.forEach(function (l, k) {
    svg
      .append("path")
      .attr({
        "class": "line",
        d: line(all[k]),
        stroke: l.colour,
        "stroke-dasharray": l.dash || null
      });
  });
};

pmr.draw_events = function (svg, spec, x, size) {
  var right = 7 * pmr.axis_title(spec.y.label, spec.y.unit).length - size.left; // free of the title
  (spec.events || [])
    .slice()
    .sort((a, b) => a.t - b.t)
    .forEach(function (e) {
      if (e.t < x.domain()[0] || e.t > x.domain()[1]) return;
      var at = x(e.t),
        g = svg.append("g").attr("class", "event");
      g.append("line").attr({ x1: at, x2: at, y1: 0, y2: size.height });
      var flip = at > size.width - 60,
        start = flip ? at - 58 : at + 3;
      if (start < right) return;
      right = start + 8 * e.label.length;
      g.append("text")
        .attr({ x: flip ? at - 3 : at + 3, y: -9, "text-anchor": flip ? "end" : "start" })
        .text(e.label);
    });
};

pmr.keys = function (holder, lines) {
  if (lines.length < 2 && !lines[0].low) return;
  var keys = holder.append("div").attr("class", "keys");
  lines.forEach(function (l) {
    var key = keys.append("span").attr("class", "key");
    key
      .append("svg")
      .attr("viewBox", "0 0 26 10")
      .append("line")
      .attr({
        x1: 0,
        x2: 26,
        y1: 5,
        y2: 5,
        stroke: l.colour,
        "stroke-width": 2.4,
        "stroke-dasharray": l.dash || null
      });
    key.append("span").text(l.label);
  });
};

// Follows the pointer: a cursor in every course chart, a readout in the one under the pointer.
pmr.follow = function (chart) {
  var tip = chart.holder.append("div").attr("class", "tip").style("display", "none");
  chart.cursor = chart.svg
    .append("line")
    .attr({ "class": "cursor", y1: 0, y2: chart.size.height })
    .style("display", "none");
  chart.move = function (value) {
    var inside = value !== null && value >= chart.x.domain()[0] && value <= chart.x.domain()[1];
    chart.cursor.style("display", inside ? null : "none");
    if (inside) chart.cursor.attr({ x1: chart.x(value), x2: chart.x(value) });
  };
  function readout(value) {
    var rows = chart.spec.lines.map(function (l, k) {
      var p =
        chart.all[k][d3.bisector((q) => q.x).left(chart.all[k], value)] ||
        chart.all[k][chart.all[k].length - 1];
      var band =
        l.low && p.low !== null ? " (" + pmr.number(p.low) + " to " + pmr.number(p.high) + ")" : "";
      return (
        '<span style="color:' +
        l.colour +
        '">●</span> ' +
        pmr.escape(l.label) +
        ": <b>" +
        pmr.number(p.y) +
        "</b>" +
        band
      );
    });
    var unit = chart.spec.y.unit === "1" ? "" : " <span>[" + chart.spec.y.unit + "]</span>";
    var at = chart.spec.x
      ? pmr.with_unit(value, chart.spec.x.unit)
      : "t = " + pmr.number(value) + " s";
    return at + unit + "<br>" + rows.join("<br>");
  }
  chart.svg
    .append("rect")
    .attr({ width: chart.size.width, height: chart.size.height, fill: "transparent" })
    .on("mousemove", function () {
      var mouse = d3.mouse(this),
        value = chart.x.invert(mouse[0]);
      pmr.charts.forEach(function (c) {
        if (!c.spec.x === !chart.spec.x) c.move(value);
      });
      var left = mouse[0] < chart.size.width / 2;
      tip
        .html(readout(value))
        .style({
          display: null,
          top: "28px",
          left: left ? chart.size.left + mouse[0] + 14 + "px" : null,
          right: left ? null : chart.size.width - mouse[0] + chart.size.right + 14 + "px"
        });
    })
    .on("mouseleave", function () {
      tip.style("display", "none");
      pmr.charts.forEach(function (c) {
        c.move(null);
      });
    });
};

// The fill of the tubes before the release is left out, but for a little of it.
pmr.since_release = function (all) {
  var last = d3.max(d3.merge(all), (p) => p.x);
  if (!(last > 0)) return all;
  return all.map((points) => points.filter((p) => p.x >= -0.03 * last));
};

pmr.draw_line_chart = function (holder, spec, width) {
  pmr.keys(holder, spec.lines);
  var size = { left: 58, right: 12, top: 24, bottom: 40 };
  size.width = width - size.left - size.right;
  size.height = 230;
  var svg = holder
    .append("svg")
    .attr("viewBox", "0 0 " + width + " " + (size.height + size.top + size.bottom))
    .append("g")
    .attr("transform", "translate(" + size.left + "," + size.top + ")");
  var all = spec.lines.map((l) => pmr.points(l, spec.y));
  if (!spec.x) all = pmr.since_release(all);
  var x = pmr.x_scale(all, spec, size.width),
    y = pmr.y_scale(all, spec.y, size.height);
  pmr.draw_axes(svg, x, y, size, spec);
  pmr.draw_events(svg, spec, x, size);
  pmr.draw_lines(svg, spec, all, x, y);
  var chart = { holder: holder, svg: svg, spec: spec, all: all, x: x, y: y, size: size };
  pmr.follow(chart);
  pmr.charts.push(chart);
};

// One row a point; lines that share their x share a row.
pmr.line_rows = function (spec) {
  var unit = " [" + spec.y.unit + "]",
    rows = [
      [
        "line",
        spec.x ? pmr.axis_title(spec.x.label, spec.x.unit) : "time [s]",
        "value" + unit,
        "10 %" + unit,
        "90 %" + unit
      ]
    ];
  spec.lines.forEach(function (l) {
    pmr.points(l, spec.y).forEach(function (p) {
      rows.push([l.label, p.x, p.y, p.low, p.high]);
    });
  });
  return rows;
};
