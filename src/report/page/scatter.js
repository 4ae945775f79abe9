// Points with their curves, over any quantity: responses of a study, a trade-off.

pmr.scatter_scale = function (axis, values, range, padded) {
  var low = d3.min(values),
    high = d3.max(values),
    span = high - low || Math.abs(high) * 0.2 || 1;
  if (axis.scale === "log" && low > 0) {
    var ratio = Math.pow(high / low || 2, 0.05);
    return d3.scale
      .log()
      .domain([low / ratio, high * ratio])
      .range(range);
  }
  if (!padded)
    return d3.scale
      .linear()
      .domain([low - 0.03 * span, high + 0.03 * span])
      .range(range);
  if (low >= 0 && low < 0.35 * high)
    return d3.scale
      .linear()
      .domain([0, high + 0.06 * span])
      .range(range)
      .nice(5);
  return d3.scale
    .linear()
    .domain([low - 0.08 * span, high + 0.08 * span])
    .range(range)
    .nice(5);
};

pmr.all_values = function (spec, key) {
  var values = [];
  function take(v) {
    if (v !== null && v !== undefined && isFinite(v)) values.push(v);
  }
  spec.series.forEach(function (s) {
    (s.points || []).forEach(function (p) {
      take(p[key]);
      if (key === "y") [p.low, p.high].forEach(take);
    });
    var curve = s.curve || {};
    (curve[key] || []).forEach(take);
    if (key === "y")
      [curve.low, curve.high].forEach(function (c) {
        (c || []).forEach(take);
      });
  });
  return values;
};

// Ticks at the levels of a variable that is no number, else where the scale likes them.
pmr.scatter_axes = function (svg, x, y, size, spec) {
  var log_x = spec.x.scale === "log",
    log_y = spec.y.scale === "log";
  var x_ticks = spec.x.levels
    ? d3.range(spec.x.levels.length)
    : log_x
      ? pmr.log_ticks(x.domain(), 6)
      : x.ticks(Math.max(3, Math.round(size.width / 80)));
  var y_ticks = log_y ? pmr.log_ticks(y.domain(), 6) : y.ticks(5);
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
    axis
      .append("text")
      .attr({ x: x(v), y: size.height + 17, "text-anchor": "middle" })
      .text(spec.x.levels ? spec.x.levels[v] : log_x ? pmr.number(v) : pmr.tick(v, x_ticks));
  });
  axis.append("path").attr("d", "M0,0V" + size.height + "H" + size.width);
  svg
    .append("text")
    .attr({ x: -size.left + 2, y: -9, "class": "strong" })
    .text(pmr.axis_title(spec.y.label, spec.y.unit));
  svg
    .append("text")
    .attr({ x: size.width, y: size.height + 33, "text-anchor": "end", "class": "strong" })
    .text(spec.x.levels ? spec.x.label : pmr.axis_title(spec.x.label, spec.x.unit));
};

pmr.error_bar = function (x, low, high) {
  var left = "M" + (x - 3) + ",";
  return left + low + "h6M" + x + "," + low + "V" + high + left + high + "h6";
};

pmr.draw_scatter_series = function (svg, s, x, y) {
  var curve = s.curve;
  if (curve) {
    var rows = curve.x.map((v, k) => ({
      x: v,
      y: curve.y[k],
      low: curve.low ? curve.low[k] : null,
      high: curve.high ? curve.high[k] : null
    }));
    if (curve.low)
      svg.append("path").attr({
        "class": "band",
        fill: s.colour,
        d: d3.svg
          .area()
          .x((p) => x(p.x))
          .y0((p) => y(p.low))
          .y1((p) => y(p.high))(rows)
      });
    svg.append("path").attr({
      "class": "line",
      stroke: s.colour,
      "stroke-dasharray": s.dash || null,
      d: d3.svg
        .line()
        .x((p) => x(p.x))
        .y((p) => y(p.y))(rows)
    });
  }
  (s.points || []).forEach(function (p) {
    if (p.x === null || p.y === null) return;
    if (isFinite(p.low) && isFinite(p.high))
      svg
        .append("path")
        .attr({ "class": "line", stroke: s.colour, d: pmr.error_bar(x(p.x), y(p.low), y(p.high)) });
    var mark = svg
      .append("a")
      .attr({ "xlink:href": p.link || null })
      .append("circle")
      .attr({
        cx: x(p.x),
        cy: y(p.y),
        r: p.strong ? 5.5 : 3.4,
        fill: s.colour,
        "fill-opacity": p.strong ? 0.95 : 0.6,
        stroke: "#fff",
        "stroke-width": 0.7
      });
    mark.append("title").text(p.label || "");
    if (p.strong && p.name)
      svg
        .append("text")
        .attr({ x: x(p.x) + 8, y: y(p.y) - 6, "class": "statement" })
        .text(p.name);
  });
};

pmr.draw_scatter = function (holder, spec, width) {
  var named = spec.series.filter((s) => s.label);
  if (named.length > 1) pmr.keys(holder, named);
  var size = { left: 58, right: 14, top: 24, bottom: 40 };
  size.width = width - size.left - size.right;
  size.height = 230;
  var svg = holder
    .append("svg")
    .attr("viewBox", "0 0 " + width + " " + (size.height + size.top + size.bottom))
    .append("g")
    .attr("transform", "translate(" + size.left + "," + size.top + ")");
  var x = pmr.scatter_scale(spec.x, pmr.all_values(spec, "x"), [0, size.width], spec.x.padded);
  if (spec.x.levels)
    x = d3.scale
      .linear()
      .domain([-0.4, spec.x.levels.length - 0.6])
      .range([0, size.width]);
  var y = pmr.scatter_scale(spec.y, pmr.all_values(spec, "y"), [size.height, 0], true);
  pmr.scatter_axes(svg, x, y, size, spec);
  spec.series.forEach(function (s) {
    pmr.draw_scatter_series(svg, s, x, y);
  });
};

pmr.scatter_rows = function (spec) {
  var rows = [
    [
      "series",
      "run",
      pmr.axis_title(spec.x.label, spec.x.unit),
      pmr.axis_title(spec.y.label, spec.y.unit),
      "low",
      "high"
    ]
  ];
  spec.series.forEach(function (s) {
    (s.points || []).forEach(function (p) {
      rows.push([s.label || "runs", p.label, p.x, p.y, p.low, p.high]);
    });
    if (s.curve)
      s.curve.x.forEach(function (v, k) {
        rows.push([
          (s.label || "") + " curve",
          "",
          v,
          s.curve.y[k],
          s.curve.low ? s.curve.low[k] : null,
          s.curve.high ? s.curve.high[k] : null
        ]);
      });
  });
  return rows;
};

// Horizontal bars with their intervals, the largest on top: what matters most.
pmr.draw_bars = function (holder, spec, width) {
  var size = { left: Math.min(330, 0.55 * width), right: 40, top: 8, bottom: 40, row: 24 };
  size.width = width - size.left - size.right;
  size.height = size.row * spec.rows.length;
  var svg = holder
    .append("svg")
    .attr("viewBox", "0 0 " + width + " " + (size.height + size.top + size.bottom))
    .append("g")
    .attr("transform", "translate(" + size.left + "," + size.top + ")");
  var x = d3.scale.linear().domain(spec.domain).range([0, size.width]),
    ticks = x.ticks(5);
  ticks.forEach(function (v) {
    svg
      .append("g")
      .attr("class", "grid")
      .append("line")
      .attr({ x1: x(v), x2: x(v), y1: 0, y2: size.height });
    svg
      .append("text")
      .attr({ x: x(v), y: size.height + 16, "text-anchor": "middle" })
      .text(pmr.tick(v, ticks));
  });
  svg
    .append("text")
    .attr({ x: size.width, y: size.height + 33, "text-anchor": "end", "class": "strong" })
    .text(spec.label);
  spec.rows.forEach(function (row, k) {
    var middle = (k + 0.5) * size.row,
      from = x(Math.min(0, row.value)),
      to = x(Math.max(0, row.value));
    svg
      .append("rect")
      .attr({
        x: from,
        width: Math.max(1, to - from),
        y: middle - 7,
        height: 14,
        fill: row.value < 0 ? "#0072b2" : "#d55e00",
        "fill-opacity": 0.75
      });
    svg
      .append("line")
      .attr({
        x1: x(row.low),
        x2: x(row.high),
        y1: middle,
        y2: middle,
        stroke: "#1d2430",
        "stroke-width": 1.4
      });
    svg
      .append("text")
      .attr({ x: -8, y: middle + 4, "text-anchor": "end", "class": "strong" })
      .text(row.name);
  });
  svg.append("line").attr({ x1: x(0), x2: x(0), y1: 0, y2: size.height, stroke: "#6b7684" });
};

pmr.bar_rows = function (spec) {
  return [["variable", spec.label, "low", "high"]].concat(
    spec.rows.map((r) => [r.name, r.value, r.low, r.high])
  );
};
