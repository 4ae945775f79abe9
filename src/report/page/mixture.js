// The mixture: mean mass ratio per layer, and the bed unrolled.

pmr.ratio_ticks = function (domain) {
  return [0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50].filter(
    (v) => v >= domain[0] && v <= domain[1]
  );
};

pmr.draw_layers = function (holder, spec, width) {
  if (spec.lines.length > 1) pmr.keys(holder, spec.lines);
  var left = 58,
    right = 62,
    top = 12,
    inside = width - left - right,
    height = 260;
  var values = d3
    .merge(spec.lines.map((l) => l.w.concat(l.whole || [], l.residuum ? [l.residuum.w] : [])))
    .filter((w) => w > 0);
  if (spec.published) values = values.concat([0.5, 3.5]);
  var deepest = d3.max(spec.lines, (l) =>
    Math.max(d3.max(l.depth), l.residuum ? l.residuum.depth : 0)
  );
  var x = d3.scale
    .log()
    .domain([Math.min(0.14, d3.min(values) / 1.3), Math.max(5, d3.max(values) * 1.3)])
    .range([0, inside]);
  var y = d3.scale
    .linear()
    .domain([0, 1.05 * Math.max(deepest, d3.max(spec.cuts))])
    .range([0, height]);
  var svg = holder
    .append("svg")
    .attr("viewBox", "0 0 " + width + " " + (height + top + 42))
    .append("g")
    .attr("transform", "translate(" + left + "," + top + ")");
  pmr.draw_layer_axes(svg, x, y, spec, inside, height);
  if (spec.published) pmr.draw_published(svg, x, y, spec.cuts);
  spec.lines.forEach(function (l) {
    pmr.draw_profile(svg, l, x, y);
  });
};

pmr.draw_layer_axes = function (svg, x, y, spec, inside, height) {
  var grid = svg.append("g").attr("class", "grid"),
    axis = svg.append("g").attr("class", "axis");
  pmr.ratio_ticks(x.domain()).forEach(function (v) {
    grid.append("line").attr({ x1: x(v), x2: x(v), y1: 0, y2: height });
    svg
      .append("text")
      .attr({ x: x(v), y: height + 16, "text-anchor": "middle" })
      .text(pmr.number(v));
  });
  y.ticks(6).forEach(function (v) {
    axis.append("line").attr({ x1: -4, x2: 0, y1: y(v), y2: y(v) });
    svg
      .append("text")
      .attr({ x: -8, y: y(v) + 4, "text-anchor": "end" })
      .text(pmr.number(v));
  });
  spec.cuts.forEach(function (depth, k) {
    grid.append("line").attr({ x1: 0, x2: inside, y1: y(depth), y2: y(depth) });
    if (k > 0)
      svg
        .append("text")
        .attr({ x: inside + 6, y: y((spec.cuts[k - 1] + depth) / 2) + 4 })
        .text(k === 1 ? "layer 1" : k);
  });
  svg.append("line").attr({ "class": "unity", x1: x(1), x2: x(1), y1: 0, y2: height });
  axis.append("path").attr("d", "M0,0V" + height + "H" + inside);
  svg
    .append("text")
    .attr({ x: inside, y: height + 33, "text-anchor": "end", "class": "strong" })
    .text("mass ratio w [1]");
  svg
    .append("text")
    .attr({
      transform: "rotate(-90)",
      x: -height / 2,
      y: -42,
      "text-anchor": "middle",
      "class": "strong"
    })
    .text("depth under the bed's top [mm]");
};

// What is stated of the measured beds: broad strokes, for they are words and no data.
pmr.draw_published = function (svg, x, y, cuts) {
  function statement(w, from, to, text, side) {
    svg
      .append("line")
      .attr({
        x1: x(w),
        x2: x(w),
        y1: y(from) + 5,
        y2: y(to) - 5,
        stroke: "#b4bcc6",
        "stroke-width": 9,
        "stroke-linecap": "round",
        opacity: 0.6
      });
    svg
      .append("text")
      .attr({
        "class": "statement",
        x: x(w) + 10 * side,
        y: y((from + to) / 2) + 4,
        "text-anchor": side < 0 ? "end" : "start"
      })
      .text(text);
  }
  var n = cuts.length - 1;
  statement(3.5, cuts[0], cuts[1], "stated: about 3.5", -1);
  if (n > 3) statement(0.5, cuts[n - 3], cuts[n], "stated: about 0.5", 1);
};

pmr.draw_profile = function (svg, line, x, y) {
  var points = line.w
    .map((w, k) => ({ w: w, depth: line.depth[k], layer: k + 1 }))
    .filter((p) => p.w > 0);
  svg.append("path").attr({
    "class": "line",
    stroke: line.colour,
    "stroke-dasharray": line.dash || null,
    d: d3.svg
      .line()
      .x((p) => x(p.w))
      .y((p) => y(p.depth))(points)
  });
  points.forEach(function (p) {
    svg
      .append("circle")
      .attr({
        cx: x(p.w),
        cy: y(p.depth),
        r: 4,
        fill: line.dash ? "#fff" : line.colour,
        stroke: line.colour
      })
      .append("title")
      .text(
        line.label +
          ", layer " +
          p.layer +
          ": w = " +
          pmr.number(p.w) +
          " at " +
          pmr.number(p.depth) +
          " mm"
      );
  });
  (line.whole || []).forEach(function (w, k) {
    if (w > 0)
      svg
        .append("path")
        .attr({
          d: "M-4,-4L4,4M-4,4L4,-4",
          stroke: line.colour,
          "stroke-width": 1.6,
          transform: "translate(" + x(w) + "," + y(line.depth[k]) + ")"
        })
        .append("title")
        .text(line.label + ", layer " + (k + 1) + " as a whole: w = " + pmr.number(w));
  });
  if (line.residuum && line.residuum.w > 0)
    svg
      .append("rect")
      .attr({
        x: x(line.residuum.w) - 4,
        y: y(line.residuum.depth) - 4,
        width: 8,
        height: 8,
        fill: "#fff",
        stroke: line.colour,
        "stroke-width": 1.6
      })
      .append("title")
      .text(line.label + ", residuum: w = " + pmr.number(line.residuum.w));
};

// The colour of a ratio, on a log scale that is as wide above 1 as below.
pmr.ratio_colour = function (cells, colours) {
  var widest = d3.max(d3.merge(cells), (w) => (w > 0 ? Math.abs(Math.log(w) / Math.LN2) : 0));
  var octaves = Math.max(1, Math.ceil(widest || 1));
  var scale = d3.scale
    .linear()
    .domain(
      d3.range(colours.length).map(function (k) {
        return octaves * ((2 * k) / (colours.length - 1) - 1);
      })
    )
    .range(colours)
    .clamp(true);
  // No beads at all is the deepest blue, no granules an empty cell.
  return {
    octaves: octaves,
    of: (w) => (w > 0 ? scale(Math.log(w) / Math.LN2) : w === 0 ? colours[0] : "#fff")
  };
};

pmr.draw_unrolled = function (holder, spec, width) {
  // Beds that are compared share one scale.
  var all = d3.values(pmr.data.charts).filter((c) => c.kind === "unrolled");
  var colour = pmr.ratio_colour(d3.merge(all.map((c) => c.cells)), spec.colours);
  var left = 58,
    right = 12,
    top = 8,
    columns = spec.azimuth.length,
    rows = spec.cells.length;
  var w = (width - left - right) / columns,
    h = 30;
  var svg = holder
    .append("svg")
    .attr("viewBox", "0 0 " + width + " " + (rows * h + top + 92))
    .append("g")
    .attr("transform", "translate(" + left + "," + top + ")");
  spec.cells.forEach(function (row, k) {
    svg
      .append("text")
      .attr({ x: -8, y: (k + 0.5) * h + 4, "text-anchor": "end" })
      .text(k === 0 ? "layer 1" : k + 1);
    row.forEach(function (ratio, s) {
      var strong =
        ratio === 0 || (ratio > 0 && Math.abs(Math.log(ratio) / Math.LN2) > 0.6 * colour.octaves);
      svg
        .append("rect")
        .attr({ x: s * w, y: k * h, width: w - 1, height: h - 1, fill: colour.of(ratio) })
        .append("title")
        .text("layer " + (k + 1) + ", φ = " + spec.azimuth[s] + "°: w = " + pmr.number(ratio));
      svg
        .append("text")
        .attr({ x: (s + 0.5) * w, y: (k + 0.5) * h + 4, "text-anchor": "middle" })
        .style("fill", strong ? "#fff" : "#333")
        .text(ratio > 0 ? d3.format(".2r")(ratio) : ratio === 0 ? "0" : "–");
    });
  });
  spec.azimuth.forEach(function (phi, s) {
    svg
      .append("text")
      .attr({ x: (s + 0.5) * w, y: rows * h + 15, "text-anchor": "middle" })
      .text(phi + "°");
  });
  svg
    .append("text")
    .attr({ x: columns * w, y: rows * h + 32, "text-anchor": "end", "class": "strong" })
    .text("azimuth φ [°]");
  pmr.draw_ratio_bar(
    svg.append("g").attr("transform", "translate(0," + (rows * h + 46) + ")"),
    colour,
    Math.min(320, columns * w)
  );
};

pmr.draw_ratio_bar = function (g, colour, width) {
  var steps = 64;
  d3.range(steps).forEach(function (k) {
    var octave = colour.octaves * ((2 * (k + 0.5)) / steps - 1);
    g.append("rect").attr({
      x: (k * width) / steps,
      y: 0,
      width: width / steps + 0.6,
      height: 11,
      fill: colour.of(Math.pow(2, octave))
    });
  });
  var stride = colour.octaves > 4 ? 2 : 1;
  for (var n = -colour.octaves; n <= colour.octaves; n += stride) {
    var at = ((n / colour.octaves + 1) / 2) * width;
    g.append("text")
      .attr({ x: at, y: 25, "text-anchor": "middle" })
      .text(n < 0 ? "1/" + Math.pow(2, -n) : Math.pow(2, n));
  }
  g.append("text")
    .attr({ x: width + 16, y: 10, "class": "strong" })
    .text("mass ratio w [1]");
};

pmr.layer_rows = function (spec) {
  var rows = [
    ["line", "layer", "depth [mm]", "mean w over sections [1]", "w of the whole layer [1]"]
  ];
  spec.lines.forEach(function (l) {
    l.w.forEach(function (w, k) {
      rows.push([l.label, k + 1, l.depth[k], w, l.whole && l.whole[k]]);
    });
    if (l.residuum) rows.push([l.label, "residuum", l.residuum.depth, null, l.residuum.w]);
  });
  return rows;
};

pmr.unrolled_rows = function (spec) {
  var rows = [["layer", "azimuth [deg]", "w [1]"]];
  spec.cells.forEach(function (row, k) {
    row.forEach(function (w, s) {
      rows.push([k + 1, spec.azimuth[s], w]);
    });
  });
  return rows;
};
