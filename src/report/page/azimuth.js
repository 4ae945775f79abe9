// Mass ratio over azimuth: a small panel for each layer, all on the same axes.

// Sectors of a layer as points; the ramp's section closes the circle at 360 degrees.
pmr.circle = function (row) {
  return row
    .concat(row.length ? [row[0]] : [])
    .map((w, s) => ({ phi: (360 * s) / row.length, w: w }));
};

pmr.draw_azimuth = function (holder, spec, width) {
  if (spec.lines.length > 1) pmr.keys(holder, spec.lines);
  var values = d3.merge(d3.merge(spec.lines.map((l) => l.cells))).filter((w) => w > 0);
  var columns = width > 900 ? 4 : width > 560 ? 3 : 2,
    left = 46,
    right = 8,
    gap = 16,
    top = 22,
    foot = 34,
    inside = 118;
  var panel = { width: (width - left - right - gap * (columns - 1)) / columns, height: inside };
  var rows = Math.ceil(spec.layers / columns),
    step = top + inside + foot;
  var x = d3.scale.linear().domain([0, 360]).range([0, panel.width]);
  var y = d3.scale
    .log()
    .domain([d3.min(values) / 1.25, d3.max(values) * 1.25])
    .range([inside, 0]);
  var svg = holder.append("svg").attr("viewBox", "0 0 " + width + " " + (rows * step + 18));
  svg.append("text").attr({ x: 0, y: 12, "class": "strong" }).text("w [1]");
  svg
    .append("text")
    .attr({ x: width - right, y: rows * step + 12, "text-anchor": "end", "class": "strong" })
    .text("azimuth φ [°]");
  for (var k = 0; k < spec.layers; ++k) {
    var column = k % columns,
      row = Math.floor(k / columns);
    var g = svg
      .append("g")
      .attr(
        "transform",
        "translate(" + (left + column * (panel.width + gap)) + "," + (row * step + top) + ")"
      );
    pmr.draw_azimuth_axes(g, x, y, panel, k, column === 0);
    spec.lines.forEach(function (l) {
      if (l.cells[k]) pmr.draw_azimuth_line(g, l, l.cells[k], x, y);
    });
    pmr.follow_azimuth(holder, g, spec, k, x, panel);
  }
};

pmr.draw_azimuth_axes = function (g, x, y, panel, layer, is_first) {
  var grid = g.append("g").attr("class", "grid");
  g.append("rect").attr({
    "class": "far-side",
    x: x(157.5),
    width: x(45),
    y: 0,
    height: panel.height
  });
  pmr.log_ticks(y.domain(), 6).forEach(function (v) {
    grid.append("line").attr({ x1: 0, x2: panel.width, y1: y(v), y2: y(v) });
    if (is_first)
      g.append("text")
        .attr({ x: -6, y: y(v) + 4, "text-anchor": "end" })
        .text(pmr.number(v));
  });
  [0, 90, 180, 270, 360].forEach(function (v) {
    grid.append("line").attr({ x1: x(v), x2: x(v), y1: 0, y2: panel.height });
    g.append("text")
      .attr({
        x: x(v),
        y: panel.height + 14,
        "text-anchor": v === 0 ? "start" : v === 360 ? "end" : "middle"
      })
      .text(v);
  });
  [
    [0, "ramp", "start"],
    [180, "far side", "middle"],
    [360, "ramp", "end"]
  ].forEach(function (side) {
    g.append("text")
      .attr({ "class": "side", x: x(side[0]), y: panel.height + 26, "text-anchor": side[2] })
      .text(side[1]);
  });
  if (y.domain()[0] < 1 && y.domain()[1] > 1)
    g.append("line").attr({ "class": "unity", x1: 0, x2: panel.width, y1: y(1), y2: y(1) });
  g.append("g")
    .attr("class", "axis")
    .append("path")
    .attr("d", "M0,0V" + panel.height + "H" + panel.width);
  g.append("text")
    .attr({ x: 4, y: -6, "class": "strong" })
    .text("layer " + (layer + 1));
};

pmr.draw_azimuth_line = function (g, line, row, x, y) {
  var points = pmr.circle(row),
    highest = d3.max(row);
  var path = d3.svg
    .line()
    .defined((p) => p.w > 0)
    .x((p) => x(p.phi))
    .y((p) => y(p.w));
  g.append("path").attr({
    "class": "line",
    d: path(points),
    stroke: line.colour,
    "stroke-dasharray": line.dash || null
  });
  points.forEach(function (p) {
    if (!(p.w > 0)) return;
    g.append("circle").attr({ cx: x(p.phi), cy: y(p.w), r: 2.4, fill: line.colour });
    if (p.w === highest)
      g.append("circle").attr({
        cx: x(p.phi),
        cy: y(p.w),
        r: 5.5,
        fill: "none",
        stroke: line.colour,
        "stroke-width": 1.5
      });
  });
};

pmr.follow_azimuth = function (holder, g, spec, layer, x, panel) {
  var tip = holder.append("div").attr("class", "tip").style("display", "none");
  var cursor = g
    .append("line")
    .attr({ "class": "cursor", y1: 0, y2: panel.height })
    .style("display", "none");
  var sectors = spec.lines[0].cells[layer] ? spec.lines[0].cells[layer].length : 0;
  function readout(sector) {
    var rows = spec.lines
      .filter((l) => l.cells[layer])
      .map(function (l) {
        return (
          '<span style="color:' +
          l.colour +
          '">●</span> ' +
          pmr.escape(l.label) +
          ": <b>" +
          pmr.number(l.cells[layer][sector]) +
          "</b>"
        );
      });
    return (
      "layer " +
      (layer + 1) +
      ", φ = " +
      pmr.number((360 * sector) / sectors) +
      "°<br>" +
      rows.join("<br>")
    );
  }
  g.append("rect")
    .attr({ width: panel.width, height: panel.height, fill: "transparent" })
    .on("mousemove", function () {
      var place = Math.round((x.invert(d3.mouse(this)[0]) * sectors) / 360),
        at = x((360 * place) / sectors);
      var mouse = d3.mouse(holder.node()),
        is_left = mouse[0] < holder.node().clientWidth / 2;
      cursor.attr({ x1: at, x2: at }).style("display", null);
      tip
        .html(readout(place % sectors))
        .style({
          display: null,
          top: mouse[1] + 14 + "px",
          left: is_left ? mouse[0] + 14 + "px" : null,
          right: is_left ? null : holder.node().clientWidth - mouse[0] + 14 + "px"
        });
    })
    .on("mouseleave", function () {
      tip.style("display", "none");
      cursor.style("display", "none");
    });
};

pmr.azimuth_rows = function (spec) {
  var rows = [["line", "layer", "azimuth [deg]", "w [1]"]];
  spec.lines.forEach(function (l) {
    l.cells.forEach(function (row, k) {
      row.forEach(function (w, s) {
        rows.push([l.label, k + 1, (360 * s) / row.length, w]);
      });
    });
  });
  return rows;
};
